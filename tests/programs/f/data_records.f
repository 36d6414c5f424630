C     Data records: what is packed is unpacked, and ESCAPE takes it.
      PROGRAM DATREC
      INCLUDE 'gks.inc'
      INTEGER IE, LDR, LODR, I, IA(5), IB(5), NI, NR, NS, LENS(3)
      REAL RA(2), RB(2)
      CHARACTER*80 RECORD(9), OUT(9)
      CHARACTER*6 STR(3), GOT(3)
      CHARACTER*3 SHORT(3)
      DATA IA /1, -2, 2147483647, 0, 5/
      DATA RA /-0.1, 1.5E30/
      DATA STR /'abc', 'defghi', ' '/
      CALL GOPKS(19, 0)
      STR(3)(1:2) = CHAR(233)//CHAR(0)
      LENS(1) = 3
      LENS(2) = 6
      LENS(3) = 2
      CALL GPREC(5, IA, 2, RA, 3, LENS, STR, 9, IE, LDR, RECORD)
      CALL WANTI('GPREC', IE, 0)
      CALL GUREC(LDR, RECORD, 5, 2, 3, IE, NI, IB, NR, RB, NS, LENS,
     +           GOT)
      CALL WANTI('GUREC', IE, 0)
      CALL WANTI('integers', NI, 5)
      CALL WANTI('reals', NR, 2)
      CALL WANTI('strings', NS, 3)
      DO 10 I = 1, 5
        CALL WANTI('integer', IB(I), IA(I))
   10 CONTINUE
      IF (RB(1) .NE. RA(1)) CALL WANTR('first real', RB(1), RA(1))
      IF (RB(2) .NE. RA(2)) CALL WANTR('second real', RB(2), RA(2))
      CALL WANTI('first length', LENS(1), 3)
      CALL WANTI('third length', LENS(3), 2)
      CALL WANTC('first string', GOT(1), 'abc')
      CALL WANTC('second string', GOT(2), 'defghi')
      CALL WANTC('third string', GOT(3), STR(3))
      CALL GUREC(LDR, RECORD, 5, 2, 3, IE, NI, IB, NR, RB, NS, LENS,
     +           SHORT)
      CALL WANTI('strings too short', IE, 2001)
      CALL WANTC('what fits', SHORT(2), 'def')
      CALL WANTI('its whole length', LENS(2), 6)
      CALL GUREC(LDR, RECORD, 4, 2, 3, IE, NI, IB, NR, RB, NS, LENS,
     +           GOT)
      CALL WANTI('array too short', IE, 2001)
      CALL WANTI('whole number', NI, 5)
      CALL GUREC(0, RECORD, 4, 2, 3, IE, NI, IB, NR, RB, NS, LENS,
     +           GOT)
      CALL WANTI('no record', IE, 2003)
      CALL WANTI('its integers', NI, 0)
      CALL GPREC(5, IA, 2, RA, 0, LENS, STR, 0, IE, LDR, RECORD)
      CALL WANTI('no room', IE, 2001)
      CALL WANTI('no lines', LDR, 0)

C     Line caps are escape -3001; 1 is a round one.
      CALL GPREC(1, IA, 0, RA, 0, LENS, STR, 9, IE, LDR, RECORD)
      LODR = -9
      CALL GESC(-3001, LDR, RECORD, 9, LODR, OUT)
      CALL WANTE('GESC', 0, 0)
      CALL WANTI('output of GESC', LODR, 0)
      RECORD(1) = 'not a packed record'
      CALL GESC(-3001, 1, RECORD, 9, LODR, OUT)
      CALL WANTE('GESC, wrong record', 182, EESC)
      CALL GESC(-1391, 1, RECORD, 9, 1, OUT)
      CALL WANTE('GESC of another library', 180, EESC)
      CALL GCLKS
      CALL GESC(-3001, 1, RECORD, 9, LODR, OUT)
      CALL WANTE('GESC while closed', 8, EESC)
      CALL DONE
      END
