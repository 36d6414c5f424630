C     A program's own GERLOG wins, behind the GERHND of the library.
      PROGRAM LOGGER
      INCLUDE 'gks.inc'
      INTEGER NCALLS
      COMMON /CALLS/ NCALLS
      NCALLS = 0
      CALL GOPKS(19, 0)
      CALL GSMK(0)
      CALL WANTI('calls of the logger', NCALLS, 1)
      CALL GCLKS
      CALL DONE
      END

      SUBROUTINE GERLOG(ERRNR, FCTID, ERRFIL)
      INCLUDE 'gks.inc'
      INTEGER ERRNR, FCTID, ERRFIL
      INTEGER NCALLS
      COMMON /CALLS/ NCALLS
      NCALLS = NCALLS + 1
      CALL WANTI('error', ERRNR, 69)
      CALL WANTI('function', FCTID, ESMK)
      CALL WANTI('error file', ERRFIL, 19)
      END
