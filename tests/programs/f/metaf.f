C     A metafile is written, read item by item and interpreted; the
C     picture that comes of it is the picture that was drawn.
      PROGRAM METAF
      INCLUDE 'gks.inc'
      INTEGER ITYPE, LENGTH, NITEMS, NLINES, NOWN
      REAL X(3), Y(3)
      CHARACTER*80 RECORD(10), OWN(2)
      DATA X /0.1, 0.5, 0.9/, Y /0.2, 0.8, 0.3/
      OWN(1) = 'what only this program understands'
      OWN(2) = 'in two lines'

      CALL GOPKS(19, 0)
      CALL GOPWK(1, 7, 2)
      CALL GOPWK(2, 8, 110)
      CALL GACWK(1)
      CALL GACWK(2)
      CALL GSPLCI(2)
      CALL GPL(3, X, Y)
      CALL GWITM(1, 123, 160, 2, OWN)
      CALL GTX(0.3, 0.1, 'TEXT')
      CALL GDAWK(1)
      CALL GDAWK(2)
      CALL GCLWK(1)
      CALL GCLWK(2)

      CALL GOPWK(3, 7, 3)
      CALL GOPWK(4, 9, 110)
      CALL GACWK(4)
      NITEMS = 0
      NLINES = 0
      NOWN = 0
   10 CALL GGTITM(3, ITYPE, LENGTH)
      NITEMS = NITEMS + 1
      IF (ITYPE .EQ. 123) THEN
        NOWN = NOWN + 1
        CALL WANTI('length of own item', LENGTH, 160)
        CALL GRDITM(3, LENGTH, 10, RECORD)
        CALL WANTC('first line', RECORD(1), OWN(1))
        CALL WANTC('second line', RECORD(2), OWN(2))
      ELSE
        IF (ITYPE .EQ. 11) NLINES = NLINES + 1
        CALL GRDITM(3, 800, 10, RECORD)
        CALL GIITM(ITYPE, LENGTH, 10, RECORD)
      END IF
      IF (ITYPE .NE. 0 .AND. NITEMS .LT. 1000) GOTO 10
      CALL WANTI('polylines', NLINES, 1)
      CALL WANTI('own items', NOWN, 1)
      CALL GDAWK(4)
      CALL GCLWK(4)
      CALL GCLWK(3)
      CALL GCLKS
      CALL DONE
      END
