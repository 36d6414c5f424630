C     Input from the operator of a scripted workstation: requests,
C     samples, events, and the state of devices.
      PROGRAM INPUT
      INCLUDE 'gks.inc'
      CALL GOPKS(19, 0)
      CALL GOPWK(1, 0, 530)
      CALL GACWK(1)
      CALL GSWN(1, 0.0, 10.0, 0.0, 10.0)
      CALL GSVP(1, 0.0, 0.5, 0.0, 0.5)
      CALL GSVPIP(1, 0, GHIGHR)
      CALL REQSTS
      CALL SETUP
      CALL SMPLES
      CALL EVENTS
      CALL WANTE('all the rest', 0, 0)
C     At the end of the script there is no answer any more.
      CALL GONE
      CALL GDAWK(1)
      CALL GCLWK(1)
      CALL GCLKS
      CALL WANTE('closing', 0, 0)
      CALL DONE
      END

      SUBROUTINE REQSTS
      INCLUDE 'gks.inc'
      INTEGER STAT, TNR, N, I
      REAL X, Y, PX(4), PY(4)
      CHARACTER*12 STRING
      CHARACTER*80 LINE
      CALL GRQLC(1, 1, STAT, TNR, X, Y)
      CALL WANTI('GRQLC', STAT, GOK)
      CALL WANTI('transformation', TNR, 1)
      CALL WANTR('abscissa', X, 5.0)
      CALL WANTR('ordinate', Y, 2.0)
      CALL GRQLC(1, 2, STAT, TNR, X, Y)
      CALL WANTI('transformation elsewhere', TNR, 0)
      CALL WANTR('abscissa elsewhere', X, 0.75)
C     What lies outside of the display surface is brought inside.
      CALL GRQLC(1, 1, STAT, TNR, X, Y)
      CALL WANTR('abscissa outside', X, 1.0)
      CALL WANTR('ordinate outside', Y, 0.0)
      CALL GRQLC(1, 1, STAT, TNR, X, Y)
      CALL WANTI('break', STAT, GNONE)
      CALL GRQSK(1, 1, 4, STAT, TNR, N, PX, PY)
      CALL WANTI('GRQSK', STAT, GOK)
      CALL WANTI('number of points', N, 3)
      CALL WANTI('transformation of all', TNR, 0)
      CALL WANTR('first abscissa', PX(1), 0.125)
      CALL WANTR('last ordinate', PY(3), 0.75)
      CALL WANTE('so far', 0, 0)
      PX(3) = 7.0
      CALL GRQSK(1, 1, 2, STAT, TNR, N, PX, PY)
      CALL WANTE('no room', 2001, ERQSK)
      CALL WANTI('points there', N, 3)
      CALL WANTI('transformation of none outside', TNR, 1)
      CALL WANTR('second abscissa', PX(2), 2.5)
      CALL WANTR('behind the array', PX(3), 7.0)
      CALL GRQVL(1, 1, STAT, X)
      CALL WANTI('GRQVL', STAT, GOK)
      CALL WANTR('number', X, 0.25)
      CALL GRQVL(1, 1, STAT, X)
      CALL WANTR('number beyond the range', X, 1.0)
      CALL GRQCH(1, 1, STAT, I)
      CALL WANTI('GRQCH', STAT, GOK)
      CALL WANTI('choice', I, 3)
      CALL GRQCH(1, 1, STAT, I)
      CALL WANTI('no choice', STAT, GNCHOI)
      CALL GRQPK(1, 1, STAT, I, N)
      CALL WANTI('no pick', STAT, GNPICK)
      STRING = 'untouched'
      CALL GRQST(1, 1, STAT, N, STRING)
      CALL WANTI('GRQST', STAT, GOK)
      CALL WANTI('length', N, 11)
      CALL WANTC('string', STRING, 'hello world')
      CALL GRQSTS(1, 1, STAT, N, LINE)
      CALL WANTI('GRQSTS', N, 3)
      CALL WANTC('line', LINE, 'abc')
      END

C     Devices are initialised, and are what they have become.
      SUBROUTINE SETUP
      INCLUDE 'gks.inc'
      INTEGER IE, MODE, ESW, TNR, N, PET, BUFLEN, POS, LDR, STAT, I
      INTEGER IA(2), LSTR(3), IB(1)
      REAL X, Y, PX(4), PY(4), EAREA(4), RA(3), LO, HI
      CHARACTER*80 RECORD(10), BACK(10), STRING
      CHARACTER*6 NAMES(3)
      DATA IA /0, 0/, LSTR /3, 5, 4/, NAMES /'red', 'green', 'blue'/
      DATA RA /0.5, 0.25, 1.0/
      CALL GPREC(0, IA, 0, RA, 3, LSTR, NAMES, 10, IE, LDR, RECORD)
      CALL GINCH(1, 1, GOK, 2, 3, 0.0, 0.1, 0.0, 0.05, LDR, RECORD)
      CALL WANTE('GINCH', 0, 0)
      CALL GQCHS(1, 1, 10, IE, MODE, ESW, STAT, I, PET, EAREA, N, BACK)
      CALL WANTI('GQCHS', IE, 0)
      CALL WANTI('mode', MODE, GREQU)
      CALL WANTI('echo', ESW, GECHO)
      CALL WANTI('initial status', STAT, GOK)
      CALL WANTI('initial choice', I, 2)
      CALL WANTI('prompt', PET, 3)
      CALL WANT4('echo area', EAREA, 0.0, 0.1, 0.0, 0.05)
      CALL WANTI('lines', N, LDR)
      CALL WANTC('record', BACK(1), RECORD(1))
      CALL GQCHS(1, 1, 0, IE, MODE, ESW, STAT, I, PET, EAREA, N, BACK)
      CALL WANTI('no room for the record', IE, 2001)
      CALL GINCH(1, 1, GOK, 4, 3, 0.0, 0.1, 0.0, 0.05, LDR, RECORD)
      CALL WANTE('no fourth name', 152, EINCH)
      CALL GINCH(1, 1, 9, 4, 3, 0.0, 0.1, 0.0, 0.05, LDR, RECORD)
      CALL WANTE('no status', 2000, EINCH)
      CALL GINCH(1, 1, GOK, 1, 1, 0.0, 0.1, 0.0, 0.05, 1, 'nonsense')
      CALL WANTE('no record', 146, EINCH)

      CALL GPREC(2, IA, 3, RA, 0, LSTR, NAMES, 10, IE, LDR, RECORD)
      PX(1) = 1.0
      PY(1) = 2.0
      CALL GINSK(1, 1, 1, 1, PX, PY, 4, 0., 0.1, 0., 0.1, 8, LDR,
     +           RECORD)
      CALL WANTE('GINSK', 0, 0)
      CALL GQSKS(1, 1, GREALI, 4, 10, IE, MODE, ESW, TNR, N, PX, PY,
     +           PET, EAREA, BUFLEN, LDR, BACK)
      CALL WANTI('GQSKS', IE, 0)
      CALL WANTI('initial points', N, 1)
      CALL WANTI('transformation', TNR, 1)
      CALL WANTR('initial ordinate', PY(1), 2.0)
      CALL WANTI('buffer', BUFLEN, 8)

      CALL GINVL(1, 1, 3.5, 2, 0., 0.1, 0., 0.1, 1.0, 9.0, 0, RECORD)
      CALL GQVLS(1, 1, 10, IE, MODE, ESW, X, PET, EAREA, LO, HI, N,
     +           BACK)
      CALL WANTR('initial number', X, 3.5)
      CALL WANTR('lowest number', LO, 1.0)
      CALL WANTR('highest number', HI, 9.0)
      CALL WANTI('lines of an empty record', N, 1)

      CALL GINST(1, 1, 3, 'abcdef', 1, 0., 0.1, 0., 0.1, 20, 4, 0,
     +           RECORD)
      CALL GQSTS(1, 1, 10, IE, MODE, ESW, N, STRING, PET, EAREA,
     +           BUFLEN, POS, LDR, BACK)
      CALL WANTI('initial length', N, 3)
      CALL WANTC('initial string', STRING, 'abc')
      CALL WANTI('characters', BUFLEN, 20)
      CALL WANTI('cursor', POS, 4)
      CALL WANTE('GINST', 0, 0)

      CALL GINLC(1, 1, 1, 4.0, 6.0, 2, 0., 0.1, 0., 0.1, 0, RECORD)
      CALL GQDLC(530, 1, 2, 10, IE, X, Y, N, PET, EAREA, LDR, BACK)
      CALL WANTI('GQDLC', IE, 0)
      CALL WANTI('prompts', N, 6)
      CALL WANTI('second prompt', PET, 2)
      CALL GQDLC(530, 1, 7, 10, IE, X, Y, N, PET, EAREA, LDR, BACK)
      CALL WANTI('no such prompt', IE, 2002)
      CALL GQDSK(530, 1, 0, 10, IE, N, I, PET, EAREA, BUFLEN, LDR,
     +           BACK)
      IF (BUFLEN .GT. N) CALL WANTI('buffer', BUFLEN, N)
      IB(1) = 0
      END

      SUBROUTINE SMPLES
      INCLUDE 'gks.inc'
      INTEGER TNR
      REAL X, Y
      CALL GSMLC(1, 1, TNR, X, Y)
      CALL WANTE('sample in mode REQUEST', 142, ESMLC)
      CALL GSLCM(1, 1, GSAMPL, GNECHO)
      CALL GSMLC(1, 1, TNR, X, Y)
      CALL WANTI('transformation of the sample', TNR, 1)
      CALL WANTR('moved', X, 2.0)
      CALL GSMLC(1, 1, TNR, X, Y)
      CALL WANTR('at rest', X, 2.0)
      CALL GRQLC(1, 1, TNR, TNR, X, Y)
      CALL WANTE('request in mode SAMPLE', 141, ERQLC)
      CALL GSLCM(1, 1, GREQU, GECHO)
      END

      SUBROUTINE EVENTS
      INCLUDE 'gks.inc'
      INTEGER WKID, ICL, IDNR, STAT, I, IE, MORE
      REAL X
      CALL GSCHM(1, 1, GEVENT, GECHO)
      CALL GSVLM(1, 1, GEVENT, GECHO)
      CALL GGTCH(STAT, I)
      CALL WANTE('no event', 150, EGTCH)
C     A choice is made while a locator is waited for.
      CALL GRQLC(1, 2, STAT, I, X, X)
      CALL WANTI('request among events', STAT, GOK)
      CALL GWAIT(0.0, WKID, ICL, IDNR)
      CALL WANTI('class', ICL, GCHOIC)
      CALL WANTI('workstation', WKID, 1)
      CALL WANTI('device', IDNR, 1)
      CALL GGTVL(X)
      CALL WANTE('another class', 150, EGTVL)
      CALL GGTCH(STAT, I)
      CALL WANTI('status', STAT, GOK)
      CALL WANTI('choice', I, 1)
C     Nothing happens for half a second.
      CALL GWAIT(0.01, WKID, ICL, IDNR)
      CALL WANTI('timeout', ICL, GNCLAS)
      CALL GWAIT(60.0, WKID, ICL, IDNR)
      CALL WANTI('first of two', ICL, GVALUA)
      CALL GGTVL(X)
      CALL WANTR('number', X, 7.5)
      CALL GQSIM(IE, MORE)
      CALL WANTI('more', MORE, GMORE)
      CALL GWAIT(60.0, WKID, ICL, IDNR)
      CALL WANTI('second of two', ICL, GCHOIC)
      CALL GQSIM(IE, MORE)
      CALL WANTI('no more', MORE, GNMORE)
      CALL GQIQOV(IE, WKID, ICL, IDNR)
      CALL WANTI('no overflow', IE, 148)
      CALL GFLUSH(1, GCHOIC, 1)
      CALL GWAIT(-1.0, WKID, ICL, IDNR)
      CALL WANTE('timeout', 151, EWAIT)
      CALL GSPKID(7)
      CALL GQPKID(IE, I)
      CALL WANTI('pick identifier', I, 7)
      CALL GSPKID(-1)
      CALL WANTE('GSPKID', 97, ESPKID)
      END

      SUBROUTINE GONE
      INCLUDE 'gks.inc'
      INTEGER STAT, N, WKID, ICL
      CHARACTER*5 STRING
      CALL GRQST(1, 1, STAT, N, STRING)
      CALL WANTI('end of the script', STAT, GNONE)
      CALL GWAIT(60.0, WKID, ICL, N)
      CALL WANTI('nobody makes events', ICL, GNCLAS)
      END
