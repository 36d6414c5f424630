/* The binding of GKS to C of the draft of 1988, as XGKS has it, in this library.
 *
 * Functions return 0 or the number of an error. Lists that inquiries return are allocated with malloc and
 * belong to the program, as do the points of GET STROKE. Other points and strings that an operator enters go where the
 * structure points to that the program hands over, which has room for as many as the buffer of the device holds: 64
 * points and 1024 bytes, if the program has not set another size. */
#ifndef XGKS_H
#define XGKS_H

#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef int Gint;
typedef int Glong;
typedef char Gchar;
typedef float Gfloat;
/* XGKS has no prototypes: real numbers that are arguments come as doubles. */
typedef double XGKS_REAL;
typedef FILE Gfile;

#define OK 0

typedef enum Gacf { GCURRENT, GSPECIFIED } Gacf;
typedef enum Gasf { GBUNDLED, GINDIVIDUAL } Gasf;
typedef enum Gattrs { GPOLYLINE, GPOLYMARKER, GTEXT, GFILLAREA } Gattrs;
typedef enum Gcstat { GC_OK, GC_NOCHOICE, GC_NONE } Gcstat;
typedef enum Gprflag { GPROFF, GPRON } Gprflag;
typedef enum Gimode { GREQUEST, GSAMPLE, GEVENT } Gimode;
typedef enum Gesw { GECHO, GNOECHO } Gesw;
typedef enum Gpfcf { GPF_POLYLINE, GPF_FILLAREA } Gpfcf;
typedef enum Giclass { GNCLASS, GLOCATOR, GISTROKE, GVALUATOR, GCHOICE, GPICK, GISTRING } Giclass;
typedef enum Gistat { GOK, GNONE } Gistat;
typedef enum Glastev { GLAST, GNOTLAST } Glastev;
typedef enum Gpstat { GP_OK, GP_NOPICK, GP_NONE } Gpstat;
typedef enum Gsimultev { GNOMORE, GMORE } Gsimultev;
typedef enum Gclip { GCLIP, GNOCLIP } Gclip;
typedef enum Gclrflag { GCONDITIONALLY, GALWAYS } Gclrflag;
typedef enum Gcoavail { GCOLOUR, GMONOCHROME } Gcoavail;
typedef enum Gcovalid { GABSENT, GPRESENT } Gcovalid;
typedef enum Gcsw { GWC, GNDC } Gcsw;
typedef enum Gdefmode { GASAP, GBNIG, GBNIL, GASTI } Gdefmode;
typedef enum Girgmode { GSUPPRESSED, GALLOWED } Girgmode;
typedef enum Gdevunits { GDC_METRES, GDC_OTHER } Gdevunits;
typedef enum Gdspsurf { GEMPTY, GNOTEMPTY } Gdspsurf;
typedef enum Gflinter { GHOLLOW, GSOLID, GPATTERN, GHATCH } Gflinter;
typedef enum Ginqtype { GSET, GREALIZED } Ginqtype, Gqtype;
typedef enum Glevel {
    GLMA = -3, GLMB, GLMC, GL0A, GL0B, GL0C, GL1A, GL1B, GL1C, GL2A, GL2B, GL2C
} Glevel;
typedef enum Gmodtype { GIRG, GIMM } Gmodtype;
typedef enum Gnframe { GNO, GYES } Gnframe, Gstore;
typedef enum Gos { GGKCL, GGKOP, GWSOP, GWSAC, GSGOP } Gos;
typedef enum Gredraw { GRD_GKS, GRD_X } Gredraw;
typedef enum Gregen { GPERFORM, GPOSTPONE } Gregen;
typedef enum Gsegdet { GUNDETECTABLE, GDETECTABLE } Gsegdet;
typedef enum Gseghi { GNORMAL, GHIGHLIGHTED } Gseghi;
typedef enum Gsegvis { GVISIBLE, GINVISIBLE } Gsegvis;
typedef enum Gtxhor { GTH_NORMAL, GTH_LEFT, GTH_CENTRE, GTH_RIGHT } Gtxhor;
typedef enum Gtxver { GTV_NORMAL, GTV_TOP, GTV_CAP, GTV_HALF, GTV_BASE, GTV_BOTTOM } Gtxver;
typedef enum Gtxpath { GTP_RIGHT, GTP_LEFT, GTP_UP, GTP_DOWN } Gtxpath;
typedef enum Gtxprec { GSTRING, GCHAR, GSTROKE } Gtxprec;
typedef enum Gvpri { GHIGHER, GLOWER } Gvpri;
typedef enum Gwscat { GINVALID = -1, GOUTPUT = 0, GINPUT, GOUTIN, GWISS, GMO, GMI } Gwscat;
typedef enum Gwsclass { GVECTOR, GRASTER, GOTHER } Gwsclass;
typedef enum Gwsstate { GINACTIVE, GACTIVE } Gwsstate;
typedef enum Gwstus { GNOTPENDING, GPENDING } Gwstus;

/* Linetypes and marker types. */
#define GLN_LDASH (-3)
#define GLN_DDOTDASH (-2)
#define GLN_SDASH (-1)
#define GLN_SOLID 1
#define GLN_DASH 2
#define GLN_DOT 3
#define GLN_DOTDASH 4
#define GMK_POINT 1
#define GMK_PLUS 2
#define GMK_STAR 3
#define GMK_O 4
#define GMK_X 5

typedef struct Gpoint { Gfloat x, y; } Gpoint;
typedef struct Gipoint { Gint x, y; } Gipoint;
typedef struct Glimit { Gfloat xmin, xmax, ymin, ymax; } Glimit;
typedef struct Grect { Gpoint ll, ur; } Grect;
typedef struct Gintlist { Gint number; Gint *integers; } Gintlist;
typedef struct Gstrlist { Gint number; Gchar **strings; } Gstrlist;
typedef struct Gasfs {
    Gasf ln_type, ln_width, ln_colour, mk_type, mk_size, mk_colour, tx_fp, tx_exp, tx_space, tx_colour, fl_inter,
        fl_style, fl_colour;
} Gasfs;
typedef struct Gcliprec { Gclip ind; Glimit rec; } Gcliprec;
typedef struct Gcobundl { Gfloat red, green, blue; } Gcobundl;
typedef struct Gcofac { Gint colours; Gcoavail coavail; Gint predefined; } Gcofac;
typedef struct Gdefer { Gdefmode defmode; Girgmode irgmode; } Gdefer;
typedef struct Gdspsize { Gdevunits units; Gpoint device; Gipoint raster; } Gdspsize;
typedef struct Gextent { Gpoint concat, ll, lr, ul, ur; } Gextent;
typedef struct Gflbundl { Gflinter inter; Gint style, colour; } Gflbundl;
typedef struct Gflfac { Gintlist interiors, hatches; Gint predefined; } Gflfac;
typedef struct Ggdpfac { Gint number; Gattrs *attrs; } Ggdpfac;
typedef struct Ggdplist { Gint number; Gint (**functions)(void); Gint *indices; } Ggdplist;
typedef union Ggdprec { struct { Gint dummy; } gdpid1; struct { Gint dummy; } gdpid2; } Ggdprec;
typedef struct Ggksmit { Gint type, length; } Ggksmit;
typedef struct Glnbundl { Gint type; Gfloat width; Gint colour; } Glnbundl;
typedef struct Glnfac { Gintlist types; Gint widths; Gfloat nom, min, max; Gint predefined; } Glnfac;
typedef struct Gmkbundl { Gint type; Gfloat size; Gint colour; } Gmkbundl;
typedef struct Gmkfac { Gintlist types; Gint sizes; Gfloat nom, min, max; Gint predefined; } Gmkfac;
typedef struct Gmodseg {
    Gmodtype transform, appear, disappear, highlight, priority, addition, deletion;
} Gmodseg;
typedef struct Gmodws { Gmodtype line, mark, text, fill, pat, colour, wstran; } Gmodws;
typedef struct Gptbundl { Gipoint size; Gint *array; } Gptbundl;
typedef struct Gpxarray { Gcovalid covalid; Gint *array; } Gpxarray;
typedef struct Gsegattr {
    Gint seg;
    Gfloat segtran[2][3];
    Gsegvis vis;
    Gseghi hilight;
    Gfloat pri;
    Gsegdet det;
} Gsegattr;
typedef struct Gtxalign { Gtxhor hor; Gtxver ver; } Gtxalign;
typedef struct Gtxfp { Gint font; Gtxprec prec; } Gtxfp;
typedef struct Gtxbundl { Gtxfp fp; Gfloat ch_exp, space; Gint colour; } Gtxbundl;
typedef struct Gtxfac {
    Gint fps;
    Gtxfp *fp_list;
    Gint heights;
    Gfloat min_ht, max_ht;
    Gint expansions;
    Gfloat min_ex, max_ex;
    Gint predefined;
} Gtxfac;
typedef struct Gindattr {
    Gint lntype;
    Gfloat lnwidth;
    Gint lncolour, mktype;
    Gfloat mksize;
    Gint mkcolour;
    Gtxfp fp;
    Gfloat chexp, chspace;
    Gint txcolour;
    Gflinter flstyle;
    Gint flindex, flcolour;
    Gasfs asflist;
} Gindattr;
typedef struct Gpriattr {
    Gint plnindex, pmkindex, txindex;
    Gfloat height;
    Gpoint up;
    Gfloat chwidth;
    Gpoint base;
    Gtxpath path;
    Gtxalign align;
    Gint flindex;
    Gpoint widthvec, heightvec, prp;
} Gpriattr;
typedef struct Gwsct { Gchar *conn, *type; } Gwsct;
typedef struct Gwsdus { Gdefmode defmode; Gdspsurf dspsurf; Girgmode irgmode; Gnframe nframe; } Gwsdus;
typedef struct Gwsmax { Gint open, active, assoc; } Gwsmax;
typedef struct Gwstables { Gint line, mark, text, fill, pat, colour; } Gwstables;
typedef struct Gwstran { Glimit w, v; } Gwstran;
typedef struct Gwsti { Gwstus wstus; Gwstran request, current; } Gwsti;

/* What a data record says that holds nothing but data of the implementation, of which there are none. */
#define XGKS_NONE struct { Gchar *data; }

typedef struct Glnattr { Gasf type, width, colour; Gint line; Glnbundl bundl; } Glnattr;
typedef struct Gmkattr { Gasf type, size, colour; Gint mark; Gmkbundl bundl; } Gmkattr;
typedef struct Gtxattr { Gasf fp, tx_exp, space, colour; Gint text; Gtxbundl bundl; } Gtxattr;
typedef struct Gflattr { Gasf inter, style, colour; Gint fill; Gflbundl bundl; } Gflattr;

/* Locators. */
typedef struct Gloc { Gint transform; Gpoint position; } Gloc;
typedef struct Gqloc { Gistat status; Gloc loc; } Gqloc;
typedef union Glocrec {
    XGKS_NONE pet1;
    XGKS_NONE pet2;
    XGKS_NONE pet3;
    struct { Gacf acf; Glnattr ln; Gchar *data; } pet4;
    struct { Gpfcf pfcf; Gacf acf; union { Glnattr ln; Gflattr fl; } attr; Gchar *data; } pet5;
    XGKS_NONE pet6;
} Glocrec;
typedef struct Glocst { Gimode mode; Gesw esw; Gloc loc; Gint pet; Glimit e_area; Glocrec record; } Glocst;
typedef struct Gdefloc { Gpoint position; Gintlist pets; Glimit e_area; Glocrec record; } Gdefloc;

/* Stroke devices. */
#define XGKS_BUFFER Gint bufsiz, editpos; Gpoint interval; Gfloat time

typedef struct Gstroke { Gint transform, n_points; Gpoint *points; } Gstroke;
typedef struct Gqstroke { Gistat status; Gstroke stroke; } Gqstroke;
typedef union Gstrokerec {
    struct { XGKS_BUFFER; Gchar *data; } pet1;
    struct { XGKS_BUFFER; Gchar *data; } pet2;
    struct { XGKS_BUFFER; Gacf acf; Gmkattr mk; Gchar *data; } pet3;
    struct { XGKS_BUFFER; Gacf acf; Glnattr ln; Gchar *data; } pet4;
} Gstrokerec;
typedef struct Gstrokest {
    Gimode mode;
    Gesw esw;
    Gstroke stroke;
    Gint pet;
    Glimit e_area;
    Gstrokerec record;
} Gstrokest;
typedef struct Gdefstroke { Gint bufsiz; Gintlist pets; Glimit e_area; Gstrokerec record; } Gdefstroke;

/* Valuators. */
typedef struct Gqval { Gistat status; Gfloat val; } Gqval;
typedef union Gvalrec {
    struct { Gfloat low, high; Gchar *data; } pet1;
    struct { Gfloat low, high; Gchar *data; } pet2;
    struct { Gfloat low, high; Gchar *data; } pet3;
} Gvalrec;
typedef struct Gvalst { Gimode mode; Gesw esw; Gfloat val; Gint pet; Glimit e_area; Gvalrec record; } Gvalst;
typedef struct Gdefval { Gfloat value; Gintlist pets; Glimit e_area; Gvalrec record; } Gdefval;

/* Choice devices. */
typedef struct Gchoice { Gcstat status; Gint choice; } Gchoice;
typedef union Gchoicerec {
    XGKS_NONE pet1;
    struct { Gint number; Gprflag *enable; Gchar *data; } pet2;
    struct { Gint number; Gchar **strings; Gchar *data; } pet3;
    struct { Gint number; Gchar **strings; Gchar *data; } pet4;
    struct { Gint seg, number; Gint *pickids; Gchar *data; } pet5;
} Gchoicerec;
typedef struct Gchoicest {
    Gimode mode;
    Gesw esw;
    Gchoice choice;
    Gint pet;
    Glimit e_area;
    Gchoicerec record;
} Gchoicest;
typedef struct Gdefchoice { Gint choices; Gintlist pets; Glimit e_area; Gchoicerec record; } Gdefchoice;

/* Pick devices. */
typedef struct Gpick { Gpstat status; Gint seg, pickid; } Gpick;
typedef union Gpickrec {
    XGKS_NONE pet1;
    XGKS_NONE pet2;
    XGKS_NONE pet3;
} Gpickrec;
typedef struct Gpickst { Gimode mode; Gesw esw; Gpick pick; Gint pet; Glimit e_area; Gpickrec record; } Gpickst;
typedef struct Gdefpick { Gintlist pets; Glimit e_area; Gpickrec record; } Gdefpick;

/* String devices. */
typedef struct Gqstring { Gistat status; Gchar *string; } Gqstring;
typedef union Gstringrec { struct { Gint bufsiz, position; Gchar *data; } pet1; } Gstringrec;
typedef struct Gstringst {
    Gimode mode;
    Gesw esw;
    Gchar *string;
    Gint pet;
    Glimit e_area;
    Gstringrec record;
} Gstringst;
typedef struct Gdefstring { Gint bufsiz; Gintlist pets; Glimit e_area; Gstringrec record; } Gdefstring;

/* Events, and how many devices there are. C++ has no member of the name that C programs know. */
#ifdef __cplusplus
#define XGKS_CLASS in_class
#else
#define XGKS_CLASS class
#endif

typedef struct Gevent { Gint ws, dev; Giclass XGKS_CLASS; } Gevent;
typedef struct Gqueue { Giclass XGKS_CLASS; Gint devno; } Gqueue;
typedef struct Gnumdev { Gint locator, stroke, valuator, choice, pick, string; } Gnumdev;

/* Data records of escapes, which hold nothing. */
typedef union Gescin { struct { Gint dummy; } escid1; struct { Gint dummy; } escid2; } Gescin;
typedef union Gescout { struct { Gint dummy; } escid1; struct { Gint dummy; } escid2; } Gescout;

/* The functions by their numbers, which the error handling function of a program is given. */
typedef enum Gerrmap {
    errnull, errgopengks, errgclosegks, errgopenws, errgclosews, errgactivatews, errgdeactivatews, errgclearws,
    errgredrawsegws, errgupdatews, errgsetdeferst, errgmessage, errgescredrawnotify, errgescsetcolourmask,
    errgescsetdcsize, errgescstoreprimi, errgescinqxattr, errgpolyline, errgpolymarker, errgtext, errgfillarea,
    errgcellarray, errggdp, errgsetlineind, errgsetlinetype, errgsetlinewidth, errgsetlinecolourind,
    errgsetmarkerind, errgsetmarkertype, errgsetmarkersize, errgsetmarkercolourind, errgsettextind,
    errgsettextfontprec, errgsetcharexpan, errgsetcharspace, errgsettextcolourind, errgsetcharheight, errgsetcharup,
    errgsettextpath, errgsettextalign, errgsetfillind, errgsetfillintstyle, errgsetfillstyleind,
    errgsetfillcolourind, errgsetpatsize, errgsetpatrefpt, errgsetasf, errgsetpickid, errgsetlinerep,
    errgsetmarkerrep, errgsetpatrep, errgsetfillrep, errgsettextrep, errgsetcolourrep, errgsetwindow,
    errgsetviewport, errgsetviewportinputpri, errgselntran, errgsetclip, errgsetwswindow, errgsetwsviewport,
    errgcreateseg, errgcloseseg, errgrenameseg, errgdelseg, errgdelsegws, errgassocsegws, errgcopysegws,
    errginsertseg, errgsetsegtran, errgsetvis, errgsethighlight, errgsetsegpri, errgsetdet, errgsetsegattr,
    errginitloc, errginitstroke, errginitval, errginitchoice, errginitpick, errginitstring, errgsetlocmode,
    errgsetstrokemode, errgsetvalmode, errgsetchoicemode, errgsetpickmode, errgsetstringmode, errgreqloc,
    errgreqstroke, errgreqval, errgreqchoice, errgreqpick, errgreqstring, errgsampleloc, errgsamplestroke,
    errgsampleval, errgsamplechoice, errgsamplepick, errgsamplestring, errgawaitevent, errgflushevents, errggetloc,
    errggetstroke, errggetval, errggetchoice, errggetpick, errggetstring, errgwritegksm, errggettypegksm,
    errgreadgksm, errggetgksm, errginterpret, errgevaltran, errgaccumtran, errgemergencyclosegks, errgerrorhand,
    errgerrorlog, errginqactivews, errginqasf, errginqassocws, errginqavailgdp, errginqavailwstypes,
    errginqchoicest, errginqclip, errginqcolourfacil, errginqcolourindices, errginqcolourrep, errginqcurntrannum,
    errginqdefchoice, errginqdefdeferst, errginqdefloc, errginqdefpick, errginqdefstring, errginqdefstroke,
    errginqdefval, errginqdisplayspacesize, errginqdisplaysize, errginqfillfacil, errginqfillindices,
    errginqfillrep, errginqgdp, errginqindivattr, errginqinputoverflow, errginqlevelgks, errginqlinefacil,
    errginqlineindices, errginqlinerep, errginqlocst, errginqmarkerfacil, errginqmarkerindices, errginqmarkerrep,
    errginqmaxntrannum, errginqmaxwssttables, errginqmodsegattr, errginqmodwsattr, errginqmoreevents,
    errginqnameopenseg, errginqntrannum, errginqntran, errginqnumavailinput, errginqnumsegpri, errginqopenws,
    errginqopst, errginqpatfacil, errginqpatindices, errginqpatrep, errginqcurpickid, errginqpickst, errginqpixel,
    errginqpixelarray, errginqpixelarraydim, errginqpredcolourrep, errginqpredfillrep, errginqpredlinerep,
    errginqpredmarkerrep, errginqpredpatrep, errginqpredtextrep, errginqprimattr, errginqsegattr, errginqsegnames,
    errginqsegnamesws, errginqstringst, errginqstrokest, errginqtextextent, errginqtextfacil, errginqtextindices,
    errginqtextrep, errginqvalst, errginqwscategory, errginqwsclass, errginqwsconntype, errginqwsdeferupdatest,
    errginqwsmaxnum, errginqwsst, errginqwstran
} Gerrmap;

Gint gopenws(Gint wsid, Gchar *connection, Gchar *ws_type);
Gint gclosews(Gint wsid);
Gint gclearws(Gint wsid, Gclrflag control_flag);
Gint gopengks(Gfile *err_file, Glong memory);
Gint gclosegks(void);
Gint gsetasf(Gasfs *asf);
Gint gsetcolourrep(Gint wsid, Gint idx, Gcobundl *rep);
Gint ginqcolourrep(Gint wsid, Gint idx, Gqtype type, Gcobundl *rep);
Gint ginqcolourindices(Gint wsid, Gintlist *indices);
Gint ginqcolourfacil(Gchar *ws_type, Gcofac *fac);
Gint ginqpredcolourrep(Gchar *ws_type, Gint index, Gcobundl *rep);
Gint gactivatews(Gint wsid);
Gint gdeactivatews(Gint wsid);
Gint gsetwindow(Gint trans, Glimit *window);
Gint gsetviewport(Gint trans, Glimit *viewport);
Gint gsetviewportinputpri(Gint trans, Gint ref_trans, Gvpri priority);
Gint gselntran(Gint trans);
Gint gsetclip(Gclip ind);
Gint gsetwswindow(Gint wsid, Glimit *window);
Gint gsetwsviewport(Gint wsid, Glimit *viewport);
Gint gevaltran(Gpoint *ppoint, Gpoint *pshift, XGKS_REAL angle, Gpoint *pscale, Gcsw coord, Gfloat result[2][3]);
Gint gaccumtran(Gfloat segtran[2][3], Gpoint *ppoint, Gpoint *pshift, XGKS_REAL angle, Gpoint *pscale, Gcsw coord, Gfloat result[2][3]);
Gint gemergencyclosegks(void);
Gint gerrorhand(Gint errnum, Gint function, Gfile *perrfile);
Gint gerrorlog(Gint errnum, Gint function, Gfile *perrfile);
Gint gpolyline(Gint num_pts, Gpoint *pts);
Gint gsetlineind(Gint idx);
Gint gsetlinetype(Gint type);
Gint gsetlinewidth(XGKS_REAL width);
Gint gsetlinecolourind(Gint idx);
Gint gsetlinerep(Gint wsid, Gint idx, Glnbundl *rep);
Gint gcreateseg(Gint name);
Gint gcloseseg(void);
Gint grenameseg(Gint old, Gint renamed);
Gint gdelseg(Gint name);
Gint gdelsegws(Gint wsid, Gint name);
Gint gsetsegattr(Gint name, Gsegattr *segattr);
Gint gassocsegws(Gint wsid, Gint seg_id);
Gint gcopysegws(Gint wsid, Gint seg_id);
Gint ginsertseg(Gint seg_id, Gfloat segtran[2][3]);
Gint gredrawsegws(Gint wsid);
Gint ginqmodsegattr(Gchar *ws_type, Gmodseg *dyn);
Gint ginqnameopenseg(Gint *seg);
Gint ginqsegattr(Gsegattr *segattr);
Gint ginqassocws(Gint seg, Gintlist *asswk);
Gint ginqsegnames(Gintlist *segs);
Gint ginqsegnamesws(Gint wsid, Gintlist *segs);
Gint ginqnumsegpri(Gchar *ws_type, Gint *numpri);
Gint gpolymarker(Gint num_pts, Gpoint *pts);
Gint gsetmarkersize(XGKS_REAL size);
Gint gsetmarkertype(Gint type);
Gint gsetmarkercolourind(Gint colour);
Gint gsetmarkerind(Gint idx);
Gint gsetmarkerrep(Gint wsid, Gint idx, Gmkbundl *rep);
Gint gfillarea(Gint num_pts, Gpoint *pts);
Gint gsetfillcolourind(Gint colour);
Gint gsetfillind(Gint idx);
Gint gsetfillintstyle(Gflinter style);
Gint gsetfillrep(Gint wsid, Gint idx, Gflbundl *rep);
Gint gsetfillstyleind(Gint idx);
Gint gsetpatrep(Gint wsid, Gint idx, Gptbundl *rep);
Gint gcellarray(Grect *rect, Gipoint *dim, Gint row, Gint *colour);
Gint gupdatews(Gint wsid, Gregen regenflag);
Gint gsetcharexpan(XGKS_REAL expansion);
Gint gsetcharheight(XGKS_REAL height);
Gint gsetcharspace(XGKS_REAL spacing);
Gint gsetcharup(Gpoint *up_vector);
Gint gsettextalign(Gtxalign *txalign);
Gint gsettextcolourind(Gint colour);
Gint gsettextfontprec(Gtxfp *txfp);
Gint gsettextind(Gint idx);
Gint gsettextpath(Gtxpath path);
Gint gsettextrep(Gint wsid, Gint idx, Gtxbundl *bundle);
Gint gtext(Gpoint *at, Gchar *string);
Gint ginqtextextent(Gint wsid, Gpoint position, Gchar *string, Gextent *extent);
Gint gsetdeferst(Gint wsid, Gdefmode deferral_mode, Girgmode regen_mode);
Gint ginqlinefacil(Gchar *ws_type, Glnfac *fac);
Gint ginqpredlinerep(Gchar *ws_type, Gint idx, Glnbundl *rep);
Gint ginqlineindices(Gint wsid, Gintlist *idxlist);
Gint ginqlinerep(Gint wsid, Gint idx, Gqtype type, Glnbundl *rep);
Gint ginqmarkerfacil(Gchar *ws_type, Gmkfac *fac);
Gint ginqpredmarkerrep(Gchar *ws_type, Gint idx, Gmkbundl *rep);
Gint ginqmarkerindices(Gint wsid, Gintlist *idxlist);
Gint ginqmarkerrep(Gint wsid, Gint idx, Gqtype type, Gmkbundl *rep);
Gint ginqfillfacil(Gchar *ws_type, Gflfac *fac);
Gint ginqpredfillrep(Gchar *ws_type, Gint idx, Gflbundl *rep);
Gint ginqfillindices(Gint wsid, Gintlist *idxlist);
Gint ginqfillrep(Gint wsid, Gint idx, Gqtype type, Gflbundl *rep);
Gint ginqpatfacil(Gchar *ws_type, Gint *fac);
Gint ginqpredpatrep(Gchar *ws_type, Gint idx, Gptbundl *rep);
Gint ginqpatindices(Gint wsid, Gintlist *idxlist);
Gint ginqpatrep(Gint wsid, Gint idx, Gqtype type, Gptbundl *rep);
Gint gmessage(Gint wsid, Gchar *string);
void gescsetbackingstore(Gint wsid, Gint i);
void gescsetprogname(char *name);
Gint gescsetcolourmask(Gint wsid, unsigned long mask);
Gint gescsetdcsize(Gint wsid, Gpoint size);
Gint gescstoreprimi(Gint wsid, Gstore store);
Gint ginqtextfacil(Gchar *ws_type, Gtxfac *fac);
Gint ginqpredtextrep(Gchar *ws_type, Gint idx, Gtxbundl *rep);
Gint ginqtextindices(Gint wsid, Gintlist *idxlist);
Gint ginqtextrep(Gint wsid, Gint idx, Gqtype type, Gtxbundl *rep);
Gint ginqavailwstypes(Gstrlist *wstypes);
Gint ginqdisplayspacesize(Gchar *ws_type, Gdspsize *dspsz);
Gint ginqwscategory(Gchar *ws_type, Gwscat *cat);
Gint ginqwsclass(Gchar *ws_type, Gwsclass *wsclass);
Gint ginqmodwsattr(Gchar *ws_type, Gmodws *dyn);
Gint ginqdefdeferst(Gchar *ws_type, Gdefer *def);
Gint ginqmaxwssttables(Gchar *ws_type, Gwstables *tables);
Gint ginqwsconntype(Gint wsid, Gwsct *ct);
Gint ginqwsst(Gint wsid, Gwsstate *state);
Gint ginqwsdeferupdatest(Gint wsid, Gwsdus *du);
Gint ginqopst(Gos *state);
Gint ginqlevelgks(Glevel *lev);
Gint ginqwsmaxnum(Gwsmax *maxws);
Gint ginqopenws(Gintlist *wsids);
Gint ginqactivews(Gintlist *wsids);
Gint ginqprimattr(Gpriattr *primattr);
Gint ginqindivattr(Gindattr *indivattr);
Gint ginqcurntrannum(Gint *tran);
Gint ginqntrannum(Gintlist *tranlist);
Gint ginqntran(Gint num, Gwstran *tran);
Gint ginqclip(Gcliprec *clipping);
Gint ginqmaxntrannum(Gint *maxtran);
Gint ginqwstran(Gint wsid, Gwsti *wstran);
Gint ginqpixelarraydim(Gint wsid, Grect *rect, Gipoint *dim);
Gint ginqpixelarray(Gint wsid, Gpoint *point, Gipoint *dimen, Gpxarray *pxarr);
Gint ginqpixel(Gint wsid, Gpoint *ppoint, Gint *pix);
Gint ggdp(Gint npoints, Gpoint *points, Gint function, Ggdprec *data);
Gint ginqavailgdp(Gchar *type, Ggdplist *gdps);
Gint ginqgdp(Gchar *type, Gint function, Ggdpfac *fac);
Gint gsetpatsize(Gpoint *siz);
Gint gsetpatrefpt(Gpoint *ref);

/* Input. */
Gint ginitloc(Gint wsid, Gint dev, Gloc *init, Gint pet, Glimit *area, Glocrec *record);
Gint ginitstroke(Gint wsid, Gint dev, Gstroke *init, Gint pet, Glimit *area, Gstrokerec *record);
Gint ginitval(Gint wsid, Gint dev, XGKS_REAL init, Gint pet, Glimit *area, Gvalrec *record);
Gint ginitchoice(Gint wsid, Gint dev, Gchoice *init, Gint pet, Glimit *area, Gchoicerec *record);
Gint ginitpick(Gint wsid, Gint dev, Gpick *init, Gint pet, Glimit *area, Gpickrec *record);
Gint ginitstring(Gint wsid, Gint dev, Gchar *init, Gint pet, Glimit *area, Gstringrec *record);
Gint gsetlocmode(Gint wsid, Gint dev, Gimode mode, Gesw echo);
Gint gsetstrokemode(Gint wsid, Gint dev, Gimode mode, Gesw echo);
Gint gsetvalmode(Gint wsid, Gint dev, Gimode mode, Gesw echo);
Gint gsetchoicemode(Gint wsid, Gint dev, Gimode mode, Gesw echo);
Gint gsetpickmode(Gint wsid, Gint dev, Gimode mode, Gesw echo);
Gint gsetstringmode(Gint wsid, Gint dev, Gimode mode, Gesw echo);
Gint greqloc(Gint wsid, Gint dev, Gqloc *response);
Gint greqstroke(Gint wsid, Gint dev, Gqstroke *response);
Gint greqval(Gint wsid, Gint dev, Gqval *response);
Gint greqchoice(Gint wsid, Gint dev, Gchoice *response);
Gint greqpick(Gint wsid, Gint dev, Gpick *response);
Gint greqstring(Gint wsid, Gint dev, Gqstring *response);
Gint gsampleloc(Gint wsid, Gint dev, Gloc *response);
Gint gsamplestroke(Gint wsid, Gint dev, Gstroke *response);
Gint gsampleval(Gint wsid, Gint dev, Gfloat *response);
Gint gsamplechoice(Gint wsid, Gint dev, Gchoice *response);
Gint gsamplepick(Gint wsid, Gint dev, Gpick *response);
Gint gsamplestring(Gint wsid, Gint dev, Gchar *response);
Gint gawaitevent(XGKS_REAL timeout, Gevent *event);
Gint gflushevents(Gint wsid, Giclass in_class, Gint dev);
Gint ggetloc(Gloc *response);
Gint ggetstroke(Gstroke *response);
Gint ggetval(Gfloat *response);
Gint ggetchoice(Gchoice *response);
Gint ggetpick(Gpick *response);
Gint ggetstring(Gchar *response);
Gint gsetpickid(Gint pick_id);
Gint ginqcurpickid(Gint *pickid);
Gint ginqmoreevents(Gsimultev *events);
Gint ginqinputoverflow(Gqueue *overflow);
Gint ginqnumavailinput(Gchar *ws_type, Gnumdev *num);
Gint ginqlocst(Gint wsid, Gint dev, Gqtype type, Glocst *state);
Gint ginqstrokest(Gint wsid, Gint dev, Gqtype type, Gstrokest *state);
Gint ginqvalst(Gint wsid, Gint dev, Gvalst *state);
Gint ginqchoicest(Gint wsid, Gint dev, Gchoicest *state);
Gint ginqpickst(Gint wsid, Gint dev, Gqtype type, Gpickst *state);
Gint ginqstringst(Gint wsid, Gint dev, Gstringst *state);
Gint ginqdefloc(Gchar *ws_type, Gint dev, Gdefloc *data);
Gint ginqdefstroke(Gchar *ws_type, Gint dev, Gdefstroke *data);
Gint ginqdefval(Gchar *ws_type, Gint dev, Gdefval *data);
Gint ginqdefchoice(Gchar *ws_type, Gint dev, Gdefchoice *data);
Gint ginqdefpick(Gchar *ws_type, Gint dev, Gdefpick *data);
Gint ginqdefstring(Gchar *ws_type, Gint dev, Gdefstring *data);

/* GKS metafiles. What a program reads is a structure for the type of the item. */
Gint gwritegksm(Gint wsid, Gint type, Gint length, Gchar *data);
Gint ggetgksm(Gint wsid, Ggksmit *result);
Gint greadgksm(Gint wsid, Gint length, Gchar *record);
Gint ginterpret(Ggksmit *info, Gchar *data);

/* The file that is connected to a Fortran unit, and a data record as Fortran has it. */
Gchar *getlunname(Gint lun);
Gint gprecc(Gint il, Gint *ia, Gint rl, Gfloat *ra, Gint sl, Gint *lstr, Gchar **str, Gint mldr, Gint *errind,
    Gint *ldr, Gchar *datarec);

/* Display, window and graphics context of a window, of which there are none. */
Gint gescinqxattr(Gint wsid, void *display, void *window, void *gc);
Gint gescredrawnotify(Gint wsid, Gint (*notify)(Gint wsid, Gredraw who));

/* The other way of spelling. */
#define gsetcolorrep gsetcolourrep
#define ginqcolorrep ginqcolourrep
#define ginqcolorindices ginqcolourindices
#define ginqcolorfacil ginqcolourfacil
#define ginqpredcolorrep ginqpredcolourrep
#define gsetlinecolorind gsetlinecolourind
#define gsetmarkercolorind gsetmarkercolourind
#define gsetfillcolorind gsetfillcolourind
#define gsettextcolorind gsettextcolourind
#define gescsetcolormask gescsetcolourmask
#define GCOLOR GCOLOUR
#define GDC_METERS GDC_METRES
#define ln_color ln_colour
#define mk_color mk_colour
#define tx_color tx_colour
#define fl_color fl_colour
#define colors colours
#define color colour
#define lncolor lncolour
#define mkcolor mkcolour
#define txcolor txcolour
#define flcolor flcolour

/* Older names. */
#define gxconfig(ws) gescsetbackingstore(ws, 1)
#define gxname(name) gescsetprogname(name)
#define GTH_CENTER GTH_CENTRE

#ifdef __cplusplus
}
#endif

#endif
