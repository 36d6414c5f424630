C     A program's own GERHND wins. While it runs, it may inquire, log
C     and close in an emergency, but nothing else has an effect.
      PROGRAM HANDLR
      INCLUDE 'gks.inc'
      INTEGER IE, I, NCALLS
      COMMON /CALLS/ NCALLS
      NCALLS = 0
      CALL GOPKS(19, 0)
      CALL GSPLCI(4)
      CALL GSPLCI(-1)
      CALL WANTI('calls of the handler', NCALLS, 1)
      CALL GQPLCI(IE, I)
      CALL WANTI('colour after the handler', I, 4)
      CALL GSPLCI(5)
      CALL GQPLCI(IE, I)
      CALL WANTI('colour set again', I, 5)
      CALL GSLN(0)
      CALL WANTI('calls of the handler again', NCALLS, 2)
      CALL GQOPS(I)
      CALL WANTI('state after the emergency', I, GGKCL)
      CALL DONE
      END

      SUBROUTINE GERHND(ERRNR, FCTID, ERRFIL)
      INCLUDE 'gks.inc'
      INTEGER ERRNR, FCTID, ERRFIL
      INTEGER IE, I, NCALLS
      COMMON /CALLS/ NCALLS
      NCALLS = NCALLS + 1
      IF (NCALLS .EQ. 1) THEN
        CALL WANTI('error', ERRNR, 92)
        CALL WANTI('function', FCTID, ESPLCI)
        CALL WANTI('error file', ERRFIL, 19)
        CALL GQPLCI(IE, I)
        CALL WANTI('inquiry in the handler', IE, 0)
        CALL WANTI('its value', I, 4)
        CALL GSPLCI(6)
        CALL GSPLCI(-2)
        CALL GCLKS
        CALL GQOPS(I)
        CALL WANTI('state in the handler', I, GGKOP)
        CALL GERLOG(ERRNR, FCTID, ERRFIL)
      ELSE
        CALL GECLKS
      END IF
      END
