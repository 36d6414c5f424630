C     Errors go to the error file: what GOPKS says, and before it the
C     standard error output.
      PROGRAM LOGGED
      INCLUDE 'gks.inc'
      CALL GCLKS
      CALL GOPKS(-1, 0)
      CALL GOPKS(23, 0)
      CALL GSLN(0)
      CALL GSCHH(-1.5)
      WRITE (*, *) 'before'
      CALL GERLOG(69, ESMK, 6)
      CALL GCLKS
      CALL DONE
      END
