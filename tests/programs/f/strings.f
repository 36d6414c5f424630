C     Text: every character of the argument counts, subset variants have
C     a length of their own, Latin-1 and UTF-8 are the same letters.
      PROGRAM STRNGS
      INCLUDE 'gks.inc'
      INTEGER IE
      REAL CX, CY, DX, DY, EX(4), EY(4), FX(4), FY(4)
      CHARACTER*80 LINE
      CALL GOPKS(19, 0)
      CALL GOPWK(1, 0, 900)
      CALL GSCHH(0.1)
      CALL GSTXFP(1, GSTRKP)
      LINE = 'abcdefgh'

      CALL GQTXX(1, 0.0, 0.0, 'abc', IE, CX, CY, EX, EY)
      CALL WANTI('GQTXX', IE, 0)
      CALL GQTXXS(1, 0.0, 0.0, 3, LINE, IE, DX, DY, FX, FY)
      CALL WANTI('GQTXXS', IE, 0)
      CALL WANTR('concatenation point', DX, CX)
      CALL WANT4('abscissae', FX, EX(1), EX(2), EX(3), EX(4))
      CALL WANT4('ordinates', FY, EY(1), EY(2), EY(3), EY(4))
      IF (CX .LE. 0.1) CALL WANTR('width', CX, 0.2)
      IF (EY(3) .LE. EY(2)) CALL WANTR('height', EY(3), 0.1)

C     Blanks take room, wherever they stand.
      CALL GQTXX(1, 0.0, 0.0, 'abc  ', IE, DX, DY, FX, FY)
      IF (DX .LE. CX) CALL WANTR('blanks at the end', DX, 2*CX)
      CALL GQTXXS(1, 0.0, 0.0, -1, LINE, IE, DX, DY, FX, FY)
      CALL WANTR('negative length', DX, 0.0)
      CALL GQTXXS(1, 0.0, 0.0, 1000, LINE, IE, DX, DY, FX, FY)
      CALL GQTXX(1, 0.0, 0.0, LINE, IE, CX, CY, EX, EY)
      CALL WANTR('length beyond the line', DX, CX)

      CALL GQTXX(1, 0., 0., CHAR(233)//'t'//CHAR(233), IE,
     +           CX, CY, EX, EY)
      CALL GQTXX(1, 0., 0., CHAR(195)//CHAR(169)//'t'//CHAR(195)//
     +           CHAR(169), IE, DX, DY, FX, FY)
      CALL WANTR('Latin-1 and UTF-8', CX, DX)
      CALL GQTXX(1, 0.0, 0.0, 'ete', IE, DX, DY, FX, FY)
      CALL WANTR('accents take no room', CX, DX)

      CALL GQTXX(9, 0.0, 0.0, 'abc', IE, CX, CY, EX, EY)
      CALL WANTI('workstation not open', IE, 25)
      CALL WANTR('its extent', EX(3), 0.0)
      CALL GACWK(1)
      CALL GTX(0.1, 0.1, 'abc')
      CALL GTX(0.1, 0.1, LINE(1:0))
      CALL GTXS(0.1, 0.1, 3, LINE)
      CALL GTXS(0.1, 0.1, -3, LINE)
      CALL GDAWK(1)
      CALL GCLWK(1)
      CALL GCLKS
      CALL DONE
      END
