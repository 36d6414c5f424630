C     A program that ends without closing anything.
      PROGRAM FORGOT
      CALL GOPKS(0, 0)
C     Scalable vector graphics, in the file gks.5.svg.
      CALL GOPWK(1, 5, 200)
      CALL GACWK(1)
      CALL GPL(2, (/ 0.1, 0.9 /), (/ 0.1, 0.9 /))
      END
