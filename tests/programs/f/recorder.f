C     An error handling procedure that remembers the errors instead of
C     logging them.
      SUBROUTINE GERHND(ERRNR, FCTID, ERRFIL)
      INTEGER ERRNR, FCTID, ERRFIL
      INTEGER NERR, LASTER, LASTFN, LASTFL
      COMMON /RECORD/ NERR, LASTER, LASTFN, LASTFL
      SAVE /RECORD/
      NERR = NERR + 1
      LASTER = ERRNR
      LASTFN = FCTID
      LASTFL = ERRFIL
      END

C     What is wanted of the call before: one error of a function, or
C     none if the number is 0.
      SUBROUTINE WANTE(WHAT, ERRNR, FCTID)
      CHARACTER*(*) WHAT
      INTEGER ERRNR, FCTID
      INTEGER NERR, LASTER, LASTFN, LASTFL
      COMMON /RECORD/ NERR, LASTER, LASTFN, LASTFL
      SAVE /RECORD/
      IF (NERR .EQ. 0) LASTER = 0
      CALL WANTI(WHAT // ', error', LASTER, ERRNR)
      IF (ERRNR .NE. 0) THEN
        CALL WANTI(WHAT // ', number of errors', NERR, 1)
        CALL WANTI(WHAT // ', function', LASTFN, FCTID)
        CALL WANTI(WHAT // ', error file', LASTFL, 19)
      END IF
      NERR = 0
      END

      BLOCK DATA RECRDD
      INTEGER NERR, LASTER, LASTFN, LASTFL
      COMMON /RECORD/ NERR, LASTER, LASTFN, LASTFL
      SAVE /RECORD/
      DATA NERR /0/
      END
