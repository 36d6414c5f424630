C     GKS is opened again after CLOSE GKS and after EMERGENCY CLOSE GKS,
C     which an error handler calls with a segment open: nothing is left
C     of what was before, and errors go to the error file of their time.
      PROGRAM REOPEN
      INCLUDE 'gks.inc'
      INTEGER J, NCALLS
      LOGICAL ENDING
      COMMON /CALLS/ NCALLS, ENDING
      NCALLS = 0
      ENDING = .FALSE.
      CALL ROUND(1)
      CALL GCLSG
      CALL GDAWK(1)
      CALL GDAWK(2)
      CALL GCLWK(1)
      CALL GCLWK(2)
      CALL GCLKS
      CALL ROUND(2)
      CALL GECLKS
      CALL ROUND(3)
      ENDING = .TRUE.
      CALL GSLWSC(-2.0)
      ENDING = .FALSE.
      CALL GQOPS(J)
      CALL WANTI('state after the emergency', J, GGKCL)
      CALL ROUND(4)
      CALL GECLKS
C     There is nothing to close any more.
      CALL GECLKS
      CALL GQOPS(J)
      CALL WANTI('state at the end', J, GGKCL)
      CALL WANTI('calls of the handler', NCALLS, 9)
      CALL DONE
      END

C     Opens GKS, which must be as new, and draws on two workstations,
C     with a segment open at the end.
      SUBROUTINE ROUND(J)
      INCLUDE 'gks.inc'
      INTEGER J, IE, I, N
      REAL X(2), Y(2)
      DATA X /0.1, 0.9/, Y /0.2, 0.7/
      CALL GOPKS(20 + J, 0)
      CALL GQOPS(I)
      CALL WANTI('state', I, GGKOP)
      CALL GQLN(IE, I)
      CALL WANTI('linetype', I, GLSOLI)
      CALL GQCNTN(IE, I)
      CALL WANTI('transformation', I, 0)
      CALL GQOPWK(0, IE, N, I)
      CALL WANTI('open workstations', N, 0)
      CALL GSLN(GLDASH)
      CALL GSELNT(3)
      CALL GSLN(0)
      CALL GOPWK(1, J, 100)
      CALL GOPWK(2, J, 2)
      CALL GQSGUS(0, IE, N, I)
      CALL WANTI('segments, error', IE, 0)
      CALL WANTI('segments', N, 0)
      CALL GACWK(1)
      CALL GACWK(2)
      CALL GPL(2, X, Y)
      CALL GCRSG(1)
      CALL GPL(2, X, X)
      CALL GSPMI(0)
      END

      SUBROUTINE GERHND(ERRNR, FCTID, ERRFIL)
      INTEGER ERRNR, FCTID, ERRFIL
      INTEGER NCALLS
      LOGICAL ENDING
      COMMON /CALLS/ NCALLS, ENDING
      NCALLS = NCALLS + 1
      CALL GERLOG(ERRNR, FCTID, ERRFIL)
      IF (ENDING) CALL GECLKS
      END
