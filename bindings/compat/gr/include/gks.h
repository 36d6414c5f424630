/* The functions of the GKS of the GR framework that this library has.
 *
 * Coordinates, sizes and colours are in double precision. What has no effect here is listed in bindings/README.md. */
#ifndef GKS_H
#define GKS_H

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

#ifdef __cplusplus
}
#endif

#endif
