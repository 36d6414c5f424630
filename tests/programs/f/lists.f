C     Elements of lists: 0 asks for the length alone, an element that is
C     not there is error 2002; one variable may take several values.
      PROGRAM LISTS
      INCLUDE 'gks.inc'
      INTEGER IE, N, I, J, LAST, PATTRN(64)
      REAL A
      CALL GOPKS(19, 0)
      CALL GOPWK(7, 0, 900)
      CALL GOPWK(3, 0, 900)
      CALL GACWK(7)

      CALL GQOPWK(0, IE, N, I)
      CALL WANTI('open workstations, error', IE, 0)
      CALL WANTI('open workstations', N, 2)
      CALL GQOPWK(1, IE, N, I)
      CALL WANTI('first open workstation', I, 3)
      CALL GQOPWK(2, IE, N, I)
      CALL WANTI('second open workstation', I, 7)
      CALL GQOPWK(3, IE, N, I)
      CALL WANTI('third open workstation', IE, 2002)
      CALL WANTI('its number', N, 2)
      CALL WANTI('its name', I, 0)
      CALL GQOPWK(-1, IE, N, I)
      CALL WANTI('open workstation -1', IE, 2002)
      CALL GQACWK(1, IE, N, I)
      CALL WANTI('active workstations', N, 1)
      CALL WANTI('active workstation', I, 7)

      CALL GQEWK(0, IE, N, I)
      LAST = -1
      DO 10 J = 1, N
        CALL GQEWK(J, IE, N, I)
        CALL WANTI('workstation type, error', IE, 0)
        IF (I .LE. LAST) CALL WANTI('order of types', I, LAST + 1)
        LAST = I
   10 CONTINUE
      CALL WANTI('last workstation type', LAST, 900)
      CALL GQEWK(N + 1, IE, J, I)
      CALL WANTI('no such workstation type', IE, 2002)

C     The dummy variable J takes all that does not matter.
      CALL GQPLF(900, 2, IE, N, I, J, A, A, A, J)
      CALL WANTI('second linetype', I, GLDASH)
      CALL WANTI('predefined polyline bundles', J, 5)
      CALL GQPLF(900, N + 1, IE, N, I, J, A, A, A, J)
      CALL WANTI('no such linetype', IE, 2002)
      CALL WANTI('predefined polyline bundles still', J, 5)
      CALL GQPMF(900, 3, IE, N, I, J, A, A, A, J)
      CALL WANTI('third marker type', I, GAST)
      CALL GQTXF(900, 2, IE, N, I, LAST, J, A, A, J, A, A, J)
      CALL WANTI('font', I, 1)
      CALL WANTI('precision', LAST, GCHARP)
      CALL GQFAF(900, 4, 1, IE, N, I, J, LAST, J)
      CALL WANTI('interior styles', N, 4)
      CALL WANTI('interior style', I, GHATCH)
      CALL WANTI('hatch style', LAST, -1)
      CALL GQFAF(900, 5, 1, IE, N, I, J, LAST, J)
      CALL WANTI('no such interior style', IE, 2002)
      CALL WANTI('hatch style still', LAST, -1)
      CALL GQEGDP(900, 1, IE, N, I)
      CALL WANTI('GDP', I, -1)

      CALL GQEPLI(7, 0, IE, N, I)
      CALL WANTI('polyline indices', N, 5)
      CALL GSPLR(7, 20, GLDOT, 2.0, 1)
      CALL GQEPLI(7, 6, IE, N, I)
      CALL WANTI('new polyline index', I, 20)
      CALL GQPLR(7, 20, GSET, IE, I, A, J)
      CALL WANTI('its linetype', I, GLDOT)
      CALL WANTR('its linewidth', A, 2.0)
      CALL WANTI('its colour', J, 1)

C     A pattern in an array that is large enough, and in smaller ones.
      DO 20 I = 1, 64
        PATTRN(I) = -9
   20 CONTINUE
      CALL GSPAR(7, 40, 3, 2, 2, 1, 2, 2, (/ 9, 1, 2, 9, 3, 4 /))
      CALL GQPAR(7, 40, GSET, 4, 4, IE, I, J, PATTRN)
      CALL WANTI('GQPAR', IE, 0)
      CALL WANTI('columns', I, 2)
      CALL WANTI('rows', J, 2)
      CALL WANTI('cell (1, 1)', PATTRN(1), 1)
      CALL WANTI('cell (2, 1)', PATTRN(2), 2)
      CALL WANTI('cell (3, 1)', PATTRN(3), -9)
      CALL WANTI('cell (1, 2)', PATTRN(5), 3)
      CALL WANTI('cell (2, 2)', PATTRN(6), 4)
      PATTRN(2) = -9
      CALL GQPAR(7, 40, GSET, 1, 2, IE, I, J, PATTRN)
      CALL WANTI('too few columns', IE, 2001)
      CALL WANTI('columns needed', I, 2)
      CALL WANTI('first cell of the second row', PATTRN(2), 3)
      CALL WANTI('nothing behind', PATTRN(3), -9)
      CALL GQPAR(7, 41, GSET, 1, 1, IE, I, J, PATTRN)
      CALL WANTI('no such pattern', IE, 88)
      CALL WANTI('its columns', I, 0)
      CALL GQPPAR(900, 1, 0, 0, IE, I, J, PATTRN)
      CALL WANTI('no room at all', IE, 2001)

      CALL GDAWK(7)
      CALL GCLWK(7)
      CALL GCLWK(3)
      CALL GCLKS
      CALL DONE
      END
