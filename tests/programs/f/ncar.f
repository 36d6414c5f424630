C     What the utilities of NCAR Graphics expect in their dialect.
      PROGRAM NCARGR
      INCLUDE 'gks.inc'
      INTEGER IE, I, N, J
      REAL P(2), Q(2)
      CHARACTER*80 NAME, NONE
      CALL GOPKS(19, N)
      CALL GQFAIS(IE, I)
      CALL WANTI('areas start solid', I, GSOLID)

      CALL GSFAIS(4)
      CALL WANTE('GSFAIS for characters', 0, 0)
      CALL GSFAIS(5)
      CALL WANTE('GSFAIS', 2000, ESFAIS)

C     The length of the output record is a constant.
      NAME = 'named'
      CALL GESC(-1391, 1, NAME(1:5), 1, 1, NONE)
      CALL GESC(-1512, 1, NAME, 1, 1, NONE)
      NONE = 'untouched'
      CALL GESC(-1390, 1, NAME, 1, 1, NONE)
      CALL WANTC('record of GESC', NONE, 'untouched')
      CALL GESC(-1388, 1, '    2', 1, I, NONE)
      CALL WANTC('saved attributes', NONE, ' ')
      CALL WANTE('GESC', 0, 0)
      CALL GOPWK(1, 2, 1)
      CALL GACWK(1)
      CALL WANTE('GOPWK', 0, 0)
      CALL GQWKCA(1, IE, I)
      CALL WANTI('category of type 1', I, GMO)
      CALL GQWKC(1, IE, I, J)
      CALL WANTI('type of the workstation', J, 1)
      CALL GQSGUS(0, IE, N, I)
      CALL WANTI('segment names in use, error', IE, 0)
      CALL WANTI('segment names in use', N, 0)
      CALL GQSGUS(1, IE, N, I)
      CALL WANTI('no first segment name', IE, 2002)

      CALL GSWN(1, 10.0, 20.0, 0.0, 4.0)
      CALL GSVP(1, 0.0, 0.5, 0.5, 1.0)
      CALL GSELNT(1)
      P(1) = 10.0
      P(2) = 15.0
      CALL GZW2NX(2, P, Q)
      CALL WANTR('first abscissa', Q(1), 0.0)
      CALL WANTR('second abscissa', Q(2), 0.25)
      P(1) = 1.0
      P(2) = 4.0
      CALL GZW2NY(2, P, P)
      CALL WANTR('first ordinate', P(1), 0.625)
      CALL WANTR('second ordinate', P(2), 1.0)

      CALL GFA(3, (/ 10., 20., 15. /), (/ 0., 0., 4. /))
      CALL GDAWK(1)
      CALL GCLWK(1)
C     The name was for one workstation.
      CALL GOPWK(1, 2, 1)
      CALL GACWK(1)
      CALL GFA(3, (/ 10., 20., 15. /), (/ 0., 0., 4. /))
      CALL GDAWK(1)
      CALL GCLWK(1)
      CALL GCLKS
      CALL WANTE('closing', 0, 0)
      CALL DONE
      END
