C     Errors go to the error file: what GOPKS says, and before it the
C     standard error output, where messages to operators go, too.
      PROGRAM LOGGED
      INCLUDE 'gks.inc'
      CHARACTER*80 LINE
      CALL GCLKS
      CALL GOPKS(-1, 0)
      CALL GOPKS(23, 0)
      CALL GSLN(0)
      CALL GSCHH(-1.5)
      CALL GOPWK(1, 0, 900)
      CALL GMSG(1, 'change the pen   ')
      LINE = 'and the paper'
      CALL GMSGS(1, 9, LINE)
      CALL GCLWK(1)
      WRITE (*, *) 'before'
      CALL GERLOG(69, ESMK, 6)
      CALL GCLKS
      CALL DONE
      END
