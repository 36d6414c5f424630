C     What the programs of this folder check themselves with.
C
C     WANTI, WANTR and WANTC compare what was got with what is wanted
C     and say so where it differs; DONE ends a program, with status 1
C     if anything was wrong.

      SUBROUTINE WANTI(WHAT, GOT, WANT)
      CHARACTER*(*) WHAT
      INTEGER GOT, WANT
      IF (GOT .NE. WANT) THEN
        WRITE (*, 10) WHAT, GOT, WANT
        CALL FAILED
      END IF
   10 FORMAT ('FAIL ', A, ': got ', I12, ', want ', I12)
      END

      SUBROUTINE WANTR(WHAT, GOT, WANT)
      CHARACTER*(*) WHAT
      REAL GOT, WANT
      IF (.NOT. ABS(GOT - WANT) .LE. 1E-5*MAX(1.0, ABS(WANT))) THEN
        WRITE (*, 10) WHAT, GOT, WANT
        CALL FAILED
      END IF
   10 FORMAT ('FAIL ', A, ': got ', G14.6, ', want ', G14.6)
      END

      SUBROUTINE WANTC(WHAT, GOT, WANT)
      CHARACTER*(*) WHAT, GOT, WANT
      IF (GOT .NE. WANT) THEN
        WRITE (*, 10) WHAT, GOT, WANT
        CALL FAILED
      END IF
   10 FORMAT ('FAIL ', A, ': got "', A, '", want "', A, '"')
      END

C     What is wanted of an array of four: limits of a rectangle.
      SUBROUTINE WANT4(WHAT, GOT, W1, W2, W3, W4)
      CHARACTER*(*) WHAT
      REAL GOT(4), W1, W2, W3, W4
      CALL WANTR(WHAT // ' 1', GOT(1), W1)
      CALL WANTR(WHAT // ' 2', GOT(2), W2)
      CALL WANTR(WHAT // ' 3', GOT(3), W3)
      CALL WANTR(WHAT // ' 4', GOT(4), W4)
      END

      SUBROUTINE FAILED
      INTEGER NBAD
      COMMON /CHECKS/ NBAD
      SAVE /CHECKS/
      NBAD = NBAD + 1
      END

      SUBROUTINE DONE
      INTEGER NBAD
      COMMON /CHECKS/ NBAD
      SAVE /CHECKS/
      IF (NBAD .NE. 0) STOP 1
      WRITE (*, *) 'good'
      END

      BLOCK DATA CHECKD
      INTEGER NBAD
      COMMON /CHECKS/ NBAD
      SAVE /CHECKS/
      DATA NBAD /0/
      END
