/* The functions of the GKS of the GR framework that this library has: the functions gks_..., and the C names of the
 * draft of 1988 behind them.
 *
 * Coordinates, sizes and colours are in double precision. What has no effect here is listed in bindings/README.md. */
#ifndef GKS_H
#define GKS_H

#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

void gks_init_gks(void);
void gks_open_gks(int errfil);
void gks_close_gks(void);
void gks_open_ws(int wkid, char *conid, int wtype);
void gks_close_ws(int wkid);
void gks_activate_ws(int wkid);
void gks_deactivate_ws(int wkid);
void gks_configure_ws(int wkid);
void gks_clear_ws(int wkid, int cofl);
void gks_redraw_seg_on_ws(int wkid);
void gks_update_ws(int wkid, int regfl);
void gks_set_deferral_state(int wkid, int defmo, int regmo);
void gks_escape(int funid, int dimidr, int *idr, int maxodr, int *lenodr, int *odr);
void gks_message(int wkid, char *message);
void gks_polyline(int n, double *pxa, double *pya);
void gks_polymarker(int n, double *pxa, double *pya);
void gks_text(double px, double py, char *str);
void gks_fillarea(int n, double *pxa, double *pya);
void gks_cellarray(double qx, double qy, double rx, double ry, int dimx, int dimy, int scol, int srow, int ncol, int nrow, int *colia);
void gks_gdp(int n, double *px, double *py, int primid, int ldr, int *datrec);
void gks_set_pline_index(int index);
void gks_set_pline_linetype(int ltype);
void gks_set_pline_linewidth(double lwidth);
void gks_set_pline_color_index(int coli);
void gks_set_pmark_index(int index);
void gks_set_pmark_type(int mtype);
void gks_set_pmark_size(double mszsc);
void gks_set_pmark_color_index(int coli);
void gks_set_text_index(int index);
void gks_set_text_fontprec(int font, int prec);
void gks_set_text_expfac(double chxp);
void gks_set_text_spacing(double chsp);
void gks_set_text_color_index(int coli);
void gks_set_text_height(double chh);
double gks_inq_ws_text_height(double chh, double height);
void gks_set_text_upvec(double chux, double chuy);
void gks_set_text_path(int txp);
void gks_set_text_align(int txalh, int txalv);
void gks_set_fill_index(int index);
void gks_set_fill_int_style(int ints);
void gks_set_fill_style_index(int styli);
void gks_set_fill_color_index(int coli);
void gks_set_asf(int *flag);
void gks_set_color_rep(int wkid, int index, double red, double green, double blue);
void gks_set_window(int tnr, double xmin, double xmax, double ymin, double ymax);
void gks_set_viewport(int tnr, double xmin, double xmax, double ymin, double ymax);
void gks_select_xform(int tnr);
void gks_set_clipping(int clsw);
void gks_set_ws_window(int wkid, double xmin, double xmax, double ymin, double ymax);
void gks_set_ws_viewport(int wkid, double xmin, double xmax, double ymin, double ymax);
void gks_create_seg(int segn);
void gks_close_seg(void);
void gks_delete_seg(int segn);
void gks_assoc_seg_with_ws(int wkid, int segn);
void gks_copy_seg_to_ws(int wkid, int segn);
void gks_set_seg_xform(int segn, double mat[3][2]);
void gks_initialize_locator(int wkid, int lcdnr, int tnr, double px, double py, int pet, double xmin, double xmax, double ymin, double ymax, int ldr, char *datrec);
void gks_request_locator(int wkid, int lcdnr, int *stat, int *tnr, double *px, double *py);
void gks_request_stroke(int wkid, int skdnr, int n, int *stat, int *tnr, int *np, double *pxa, double *pya);
void gks_request_choice(int wkid, int chdnr, int *stat, int *chnr);
void gks_request_string(int wkid, int stdnr, int *stat, int *lostr, char *str);
void gks_get_item(int wkid, int *type, int *lenodr);
void gks_read_item(int wkid, int lenidr, int maxodr, char *odr);
void gks_interpret_item(int type, int lenidr, int dimidr, char *idr);
void gks_inq_segn_ws(int wkid, int n, int *errind, int *ol, int *segn);
void gks_eval_xform_matrix(double fx, double fy, double transx, double transy, double phi, double scalex, double scaley, int coord, double tran[3][2]);
void gks_inq_operating_state(int *opsta);
void gks_inq_level(int *errind, int *lev);
void gks_inq_wstype(int n, int *errind, int *number, int *wtype);
void gks_inq_max_xform(int *errind, int *maxtnr);
void gks_inq_open_ws(int n, int *errind, int *ol, int *wkid);
void gks_inq_active_ws(int n, int *errind, int *ol, int *wkid);
void gks_inq_color_rep(int wkid, int index, int type, int *errind, double *red, double *green, double *blue);
void gks_inq_pline_linetype(int *errind, int *ltype);
void gks_inq_pline_linewidth(int *errind, double *lwidth);
void gks_inq_pline_color_index(int *errind, int *coli);
void gks_inq_pmark_type(int *errind, int *mtype);
void gks_inq_pmark_size(int *errind, double *mszsc);
void gks_inq_pmark_color_index(int *errind, int *coli);
void gks_inq_text_fontprec(int *errind, int *font, int *prec);
void gks_inq_text_expfac(int *errind, double *chxp);
void gks_inq_text_spacing(int *errind, double *chsp);
void gks_inq_text_color_index(int *errind, int *coli);
void gks_inq_text_height(int *errind, double *chh);
void gks_inq_text_upvec(int *errind, double *chux, double *chuy);
void gks_inq_text_path(int *errind, int *txp);
void gks_inq_text_align(int *errind, int *txalh, int *txalv);
void gks_inq_fill_int_style(int *errind, int *ints);
void gks_inq_fill_style_index(int *errind, int *styli);
void gks_inq_fill_color_index(int *errind, int *coli);
void gks_inq_transparency(int *errind, double *alpha);
void gks_inq_open_segn(int *errind, int *segn);
void gks_inq_current_xformno(int *errind, int *tnr);
void gks_inq_xform(int tnr, int *errind, double *wn, double *vp);
void gks_inq_clip(int *errind, int *clsw, double *clrt);
void gks_inq_ws_conntype(int wkid, int *errind, int *conid, int *wtype);
void gks_inq_ws_category(int wkid, int *errind, int *wscat);
void gks_inq_text_extent(int wkid, double px, double py, char *str, int *errind, double *cpx, double *cpy, double *tx, double *ty);
void gks_inq_max_ds_size(int wtype, int *errind, int *dcunit, double *rx, double *ry, int *lx, int *ly);
void gks_inq_vp_size(int wkid, int *errind, int *width, int *height, double *device_pixel_ratio);
void gks_sample_locator(int wkid, int *errind, double *x, double *y, int *buttons);
void gks_emergency_close(void);
void gks_set_text_slant(double slant);
void gks_draw_image(double x, double y, double scalex, double scaley, int width, int height, int *data);
void gks_set_shadow(double offsetx, double offsety, double blur);
void gks_set_transparency(double alpha);
void gks_set_coord_xform(double mat[3][2]);
void gks_begin_selection(int index, int kind);
void gks_end_selection(void);
void gks_move_selection(double x, double y);
void gks_resize_selection(int kind, double x, double y);
void gks_set_bbox_callback(int id, void (*bbox_callback)(int, double, double, double, double), void (*mask_callback)(unsigned int, unsigned int, unsigned int *));
void gks_cancel_bbox_callback(void);
void gks_begin_partial(int id, void (*image_callback)(int, unsigned int, unsigned int, unsigned int, unsigned int, unsigned int *));
void gks_end_partial(int id);
void gks_set_background(double xmin, double xmax, double ymin, double ymax);
void gks_clear_background(void);
void gks_inq_bbox(int *errind, double *xmin, double *xmax, double *ymin, double *ymax);
void gks_inq_text_slant(int *errind, double *slant);
double gks_precision(void);
int gks_text_maxsize(void);
void gks_set_border_color_index(int coli);
void gks_inq_border_color_index(int *errind, int *coli);
void gks_set_border_width(double bwidth);
void gks_inq_border_width(int *errind, double *bwidth);
void gks_select_clip_xform(int tnr);
void gks_inq_clip_xform(int *errind, int *tnr);
void gks_set_resample_method(unsigned int flag);
void gks_inq_resample_method(unsigned int *flag);
void gks_ft_gdp(int n, double *px, double *py, int primid, int ldr, int *datrec);
void *gks_state(void);
void gks_set_nominal_size(double factor);
void gks_inq_nominal_size(double *factor);
void gks_set_clip_region(int region);
void gks_inq_clip_region(int *errind, int *region);
void gks_set_clip_sector(double start_angle, double end_angle);
void gks_inq_clip_sector(int *errind, double *start_angle, double *end_angle);

/* The number of the last error. */
extern int gks_errno;

/* Primitives of gks_gdp. */
#define GKS_K_GDP_DRAW_PATH 1
#define GKS_K_GDP_DRAW_LINES 2
#define GKS_K_GDP_DRAW_MARKERS 3
#define GKS_K_GDP_DRAW_TRIANGLES 4
#define GKS_K_GDP_FILL_POLYGONS 5

/* The C names of 1988. A function returns the number of its error; inquiries give it in their last argument. */
typedef FILE Gfile;
typedef char Gchar;
typedef char Gconn;
typedef double Gfloat;
typedef int Gwstype;
typedef int Gint;
typedef unsigned int Guint;
typedef long Glong;

typedef enum { GBUNDLED, GINDIVIDUAL } Gasf;
typedef enum { GCLIP, GNOCLIP } Gclip;
typedef enum { GCONDITIONALLY, GALWAYS } Gclrflag;
typedef enum { GWC, GNDC } Gcsw;
typedef enum { GDC_METRES, GDC_OTHER } Gdevunits;
typedef enum { GHOLLOW, GSOLID, GPATTERN, GHATCH } Gflinter;
typedef enum { GOK, GNONE } Gistat;
typedef enum { GPERFORM, GPOSTPONE } Gregen;
typedef enum { GAH_NORMAL, GAH_LEFT, GAH_CENTRE, GAH_RIGHT } Gtxhor;
typedef enum { GAV_NORMAL, GAV_TOP, GAV_CAP, GAV_HALF, GAV_BASE, GAV_BOTTOM } Gtxver;
typedef enum { GTP_RIGHT, GTP_LEFT, GTP_UP, GTP_DOWN } Gtxpath;
typedef enum { GP_STRING, GP_CHAR, GP_STROKE } Gtxprec;
typedef enum { GOUTPUT, GINPUT, GOUTIN, GWISS, GMO, GMI } Gwscat;
typedef enum { GGKCL, GGKOP, GWSOP, GWSAC, GSGOP } Gopst;
typedef enum { GLN_SOLID = 1, GLN_DASHED, GLN_DOTTED, GLN_DASHDOT } Glntype;
typedef enum { GMK_POINT = 1, GMK_PLUS, GMK_STAR, GMK_O, GMK_X } Gmktype;

typedef struct { Gint x, y; } Gipoint;
typedef struct { Gfloat x, y; } Gpoint;
typedef struct { Gfloat xmin, xmax, ymin, ymax; } Glimit;
typedef struct { Gint font; Gtxprec prec; } Gtxfp;
typedef struct { Gtxhor hor; Gtxver ver; } Gtxalign;
typedef struct { Gpoint ul, lr; } Grect;
typedef struct { Guint x_dim, y_dim; } Gidim;
typedef struct {
    Gasf ln_type, ln_width, ln_colour, mk_type, mk_size, mk_colour, tx_fp, tx_exp, tx_space, tx_colour, fl_inter,
        fl_style, fl_colour;
} Gasfs;
typedef struct { Gfloat red, green, blue; } Gcobundl;
typedef struct { Gclip ind; Glimit rec; } Gcliprect;
typedef struct { Gdevunits units; Gpoint device; Gipoint raster; } Gdspsize;
typedef struct { Gpoint concat, corner_1, corner_2, corner_3, corner_4; } Gextent;
typedef struct { Gint transform; Gpoint position; } Gloc;
typedef struct { Gistat status; Gloc loc; } Gqloc;
typedef struct { Gistat status; Gchar *string; } Gqstring;
typedef struct { Gfloat x_scale, y_scale; } Gscale;
typedef struct { Glimit w, v; } Gtran;

int gopengks(Gfile *err_file, Glong memory);
int gclosegks(void);
int gemergencyclosegks(void);
int gopenws(Gint wsid, Gconn *connection, Gwstype *ws_type);
int gclosews(Gint wsid);
int gactivatews(Gint wsid);
int gdeactivatews(Gint wsid);
int gconfigurews(Gint wsid);
int gclearws(Gint wsid, Gclrflag flag);
int gupdatews(Gint wsid, Gregen flag);
int gmessage(Gint wsid, Gchar *text);
int gpolyline(Gint count, Gpoint *points);
int gpolymarker(Gint count, Gpoint *points);
int gtext(Gpoint *at, Gchar *text);
int gfillarea(Gint count, Gpoint *points);
int gcellarray(Grect *rect, Gidim *size, Gint *colours);
int gsetasf(Gasfs *flags);
int gsetlineind(Gint index);
int gsetlinetype(Gint type);
int gsetlinewidth(Gfloat width);
int gsetlinecolourind(Gint index);
int gsetmarkerind(Gint index);
int gsetmarkertype(Gint type);
int gsetmarkersize(Gfloat size);
int gsetmarkercolourind(Gint index);
int gsettextind(Gint index);
int gsettextfontprec(Gtxfp *value);
int gsetcharexpan(Gfloat factor);
int gsetcharspace(Gfloat spacing);
int gsettextcolourind(Gint index);
int gsetcharheight(Gfloat height);
int gsetcharup(Gpoint *up);
int gsettextpath(Gtxpath path);
int gsettextalign(Gtxalign *value);
int gsetfillind(Gint index);
int gsetfillintstyle(Gflinter style);
int gsetfillstyle(Gint index);
int gsetfillcolourind(Gint index);
int gsetcolourrep(Gint wsid, Gint index, Gcobundl *rep);
int gsetwindow(Gint number, Glimit *window);
int gsetviewport(Gint number, Glimit *viewport);
int gselntran(Gint number);
int gsetclip(Gclip indicator);
int gsetwswindow(Gint wsid, Glimit *window);
int gsetwsviewport(Gint wsid, Glimit *viewport);
int greqloc(Gint wsid, Gint device, Gqloc *response);
int greqstring(Gint wsid, Gint device, Gqstring *response);
int gcreateseg(Gint name);
int gcopysegws(Gint wsid, Gint name);
int gredrawsegws(Gint wsid);
int gcloseseg(void);
int gevaltran(Gpoint *point, Gpoint *shift, Gfloat angle, Gscale *scale, Gcsw coordinates, Gfloat result[2][3]);
int gsetsegtran(Gint name, Gfloat matrix[2][3]);
int ginqopst(Gint *state);
int ginqlevelgks(Gint *level, Gint *error);
int ginqmaxntrannum(Gint *number, Gint *error);
int ginqcharheight(Gfloat *height, Gint *error);
int ginqcharup(Gpoint *up, Gint *error);
int ginqtextpath(Gint *path, Gint *error);
int ginqtextalign(Gtxalign *value, Gint *error);
int ginqlinetype(Gint *type, Gint *error);
int ginqlinewidth(Gfloat *width, Gint *error);
int ginqlinecolourind(Gint *index, Gint *error);
int ginqmarkertype(Gint *type, Gint *error);
int ginqmarkersize(Gfloat *size, Gint *error);
int ginqmarkercolourind(Gint *index, Gint *error);
int ginqtextfontprec(Gtxfp *value, Gint *error);
int ginqcharexpan(Gfloat *factor, Gint *error);
int ginqcharspace(Gfloat *spacing, Gint *error);
int ginqtextcolourind(Gint *index, Gint *error);
int ginqfillintstyle(Gint *style, Gint *error);
int ginqfillstyle(Gint *index, Gint *error);
int ginqfillcolourind(Gint *index, Gint *error);
int ginqcurntrannum(Gint *number, Gint *error);
int ginqntran(Gint number, Gtran *transformation, Gint *error);
int ginqclip(Gcliprect *clipping, Gint *error);
int ginqwscategory(Gwstype *ws_type, Gint *category, Gint *error);
int ginqdisplaysize(Gwstype *ws_type, Gdspsize *size, Gint *error);
int ginqtextextent(Gint wsid, Gpoint *position, Gchar *text, Gextent *extent, Gint *error);
int ginqnameopenseg(Gint *name, Gint *error);

/* The other way of spelling. */
#define gsetlinecolorind gsetlinecolourind
#define gsetmarkercolorind gsetmarkercolourind
#define gsettextcolorind gsettextcolourind
#define gsetfillcolorind gsetfillcolourind
#define gsetcolorrep gsetcolourrep
#define ginqlinecolorind ginqlinecolourind
#define ginqmarkercolorind ginqmarkercolourind
#define ginqtextcolorind ginqtextcolourind
#define ginqfillcolorind ginqfillcolourind

#ifdef __cplusplus
}
#endif

#endif
