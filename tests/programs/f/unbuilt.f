C     What needs segments or input can be called: it reports that its
C     level is not built, and sets what it returns to zero.
      PROGRAM UNBILT
      INCLUDE 'gks.inc'
      INTEGER IE, I, J, K, L, N, LEVEL
      PARAMETER (LEVEL = -3100)
      REAL A, B, EAREA(4), M(2,3)
      CHARACTER*80 RECORD(2)
      CHARACTER*12 STRING
      DATA M /6*1.0/
      CALL GOPKS(19, 0)
      CALL GCLKS
      CALL GCRSG(1)
      CALL WANTE('GCRSG while closed', 3, ECRSG)
      CALL GOPKS(19, 0)
      CALL GOPWK(1, 0, 900)
      CALL GACWK(1)
      CALL GCRSG(1)
      CALL WANTE('GCRSG', LEVEL, ECRSG)
      CALL GQOPS(I)
      CALL WANTI('state', I, GWSAC)
      CALL GSSGT(1, M)
      CALL WANTE('GSSGT', LEVEL, ESSGT)
      CALL GINLC(1, 1, 0, 0.5, 0.5, 1, 0., 1., 0., 1., 0, RECORD)
      CALL WANTE('GINLC', LEVEL, EINLC)
      I = 9
      A = 9.0
      CALL GRQLC(1, 1, I, J, A, B)
      CALL WANTE('GRQLC', LEVEL, ERQLC)
      CALL WANTI('status', I, GNONE)
      CALL WANTR('position', A, 0.0)
      I = 9
      STRING = 'untouched'
      CALL GRQST(1, 1, K, I, STRING)
      CALL WANTE('GRQST', LEVEL, ERQST)
      CALL WANTI('string length', I, 0)
      CALL WANTC('string', STRING, ' ')
      CALL GWAIT(0.0, I, J, K)
      CALL WANTE('GWAIT', LEVEL, EWAIT)
      RECORD(1) = 'untouched'
      RECORD(2) = 'untouched'
      EAREA(4) = 9.0
      CALL GQLCS(1, 1, GSET, 1, IE, I, J, K, A, B, L, EAREA, N, RECORD)
      CALL WANTI('GQLCS', IE, LEVEL)
      CALL WANTR('echo area', EAREA(4), 0.0)
      CALL WANTC('record', RECORD(1), ' ')
      CALL WANTC('behind the record', RECORD(2), 'untouched')
      CALL GQOPSG(IE, I)
      CALL WANTI('GQOPSG', IE, 4)
      CALL GQSGUS(0, IE, I, J)
      CALL WANTI('GQSGUS', IE, LEVEL)
      CALL GQPKID(IE, I)
      CALL WANTI('GQPKID', IE, LEVEL)
      CALL GDAWK(1)
      CALL GCLWK(1)
      CALL GCLKS
      CALL WANTE('the rest', 0, 0)
      CALL DONE
      END
