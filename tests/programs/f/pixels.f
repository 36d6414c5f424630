C     A cell array on a workstation with pixels, read back; the part of
C     an array that is drawn and the part that is read lie anywhere.
      PROGRAM PIXELS
      INCLUDE 'gks.inc'
      INTEGER IE, I, J, N, M, CELLS(4,3), GOT(6,5), INVAL
      REAL RX, RY, MOUT(2,3)
      DATA CELLS /9, 9, 9, 9,  9, 2, 3, 9,  9, 4, 5, 9/
      CALL GOPKS(19, 0)
C     Pixels in memory.
      CALL GOPWK(1, 0, 120)
      CALL GACWK(1)
      CALL GQDSP(120, IE, I, RX, RY, N, M)
      CALL WANTI('units', I, GMETRE)
      CALL WANTI('columns', N, 1000)
      CALL GQPXAD(1, 0.1005, 0.3005, 0.2005, 0.2505, IE, N, M)
      CALL WANTI('pixels across', N, 101)
      CALL WANTI('pixels down', M, 51)
      CALL GCA(0.0, 0.0, 1.0, 1.0, 4, 3, 2, 2, 2, 2, CELLS)
      CALL WANTE('GCA', 0, 0)
      CALL GQPX(1, 0.25, 0.25, IE, I)
      CALL WANTI('GQPX', IE, 0)
      CALL WANTI('lower left', I, 2)
      CALL GQPX(1, 0.75, 0.25, IE, I)
      CALL WANTI('lower right', I, 3)
      CALL GQPX(1, 0.25, 0.75, IE, I)
      CALL WANTI('upper left', I, 4)

      DO 10 I = 1, 6
      DO 10 J = 1, 5
        GOT(I,J) = -9
   10 CONTINUE
      CALL GQPXA(1, 0.4985, 0.5015, 6, 5, 3, 2, 3, 3, IE, INVAL, GOT)
      CALL WANTI('GQPXA', IE, 0)
      CALL WANTI('invalid values', INVAL, GABSNT)
      CALL WANTI('upper left corner', GOT(3,2), 4)
      CALL WANTI('upper right corner', GOT(5,2), 5)
      CALL WANTI('lower right corner', GOT(5,4), 3)
      CALL WANTI('left of the part', GOT(2,2), -9)
      CALL WANTI('above the part', GOT(3,1), -9)
      CALL WANTI('right of the part', GOT(6,2), -9)
      CALL GQPXA(1, 0.5, 0.5, 6, 5, 3, 2, 5, 3, IE, INVAL, GOT)
      CALL WANTI('part too wide', IE, 2001)
      CALL GQPXA(1, 0.5, 0.5, 6, 5, 3, 2, 0, 3, IE, INVAL, GOT)
      CALL WANTI('part without columns', IE, 91)
      CALL GQPXA(2, 0.5, 0.5, 6, 5, 3, 2, 5, 3, IE, INVAL, GOT)
      CALL WANTI('workstation not open', IE, 25)
      CALL GCA(0.0, 0.0, 1.0, 1.0, 4, 3, 2, 2, 4, 2, CELLS)
      CALL WANTE('GCA, part too wide', 91, ECA)

C     Matrices have their columns one after the other.
      CALL GEVTM(0.0, 0.0, 5.0, 7.0, 0.0, 2.0, 3.0, GNDC, MOUT)
      CALL WANTR('M11', MOUT(1,1), 2.0)
      CALL WANTR('M21', MOUT(2,1), 0.0)
      CALL WANTR('M22', MOUT(2,2), 3.0)
      CALL WANTR('M13', MOUT(1,3), 5.0)
      CALL WANTR('M23', MOUT(2,3), 7.0)
      CALL GACTM(MOUT, 0., 0., 1., 0., 0., 10., 1., GNDC, MOUT)
      CALL WANTR('accumulated M11', MOUT(1,1), 20.0)
      CALL WANTR('accumulated M13', MOUT(1,3), 51.0)
      CALL WANTR('accumulated M23', MOUT(2,3), 7.0)
      CALL GDAWK(1)
      CALL GCLWK(1)
      CALL GCLKS
      CALL WANTE('closing', 0, 0)
      CALL DONE
      END
