/* gks.h: the C binding of GKS (ISO/IEC 8651-4).
 *
 * Written by `gks-spec generate` from the tables in spec/gks; do not edit.
 */
#ifndef GKS_H
#define GKS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* a real number passed by itself */
typedef double Gdouble;

/* a coordinate, a matrix element, a colour component */
typedef float Gfloat;

/* an integer */
typedef int Gint;

/* a transformation matrix, row by row */
typedef Gfloat Gtran_matrix[2][3];

/* memory for results of variable size, made by gcreate_store */
typedef struct Gstore_record *Gstore;

/* aspect source */
typedef enum {
    GASF_BUNDLED = 0,
    GASF_INDIV = 1
} Gasf;

/* attribute control flag */
typedef enum {
    GFLAG_CUR = 0,
    GFLAG_SPEC = 1
} Gattr_ctrl_flag;

/* clear control flag */
typedef enum {
    GFLAG_COND = 0,
    GFLAG_ALWAYS = 1
} Gctrl_flag;

/* clipping indicator */
typedef enum {
    GIND_NO_CLIP = 0,
    GIND_CLIP = 1
} Gclip_ind;

/* colour available */
typedef enum {
    GAVAIL_MONOCHR = 0,
    GAVAIL_COLR = 1
} Gcolr_avail;

/* coordinate switch */
typedef enum {
    GCOORD_WC = 0,
    GCOORD_NDC = 1
} Gcoord_switch;

/* deferral mode */
typedef enum {
    GDEFER_ASAP = 0,
    GDEFER_BNIG = 1,
    GDEFER_BNIL = 2,
    GDEFER_ASTI = 3
} Gdefer_mode;

/* detectability */
typedef enum {
    GSEG_UNDET = 0,
    GSEG_DET = 1
} Gseg_det;

/* device coordinate units */
typedef enum {
    GDC_METRES = 0,
    GDC_OTHER = 1
} Gdc_units;

/* display surface empty */
typedef enum {
    GDISP_NOT_EMPTY = 0,
    GDISP_EMPTY = 1
} Gdisp_space_empty;

/* dynamic modification */
typedef enum {
    GDYN_IRG = 0,
    GDYN_IMM = 1
} Gdyn_mod;

/* echo switch */
typedef enum {
    GSWITCH_NO_ECHO = 0,
    GSWITCH_ECHO = 1
} Gecho_switch;

/* fill area interior style */
typedef enum {
    GSTYLE_HOLLOW = 0,
    GSTYLE_SOLID = 1,
    GSTYLE_PAT = 2,
    GSTYLE_HATCH = 3
} Gfill_int_style;

/* GDP attributes */
typedef enum {
    GATTR_LINE = 0,
    GATTR_MARKER = 1,
    GATTR_TEXT = 2,
    GATTR_FILL = 3
} Gattrs;

/* highlighting */
typedef enum {
    GSEG_NORM = 0,
    GSEG_HIGHL = 1
} Gseg_highl;

/* choice prompt flag */
typedef enum {
    GPR_OFF = 0,
    GPR_ON = 1
} Gpr_switch;

/* input device status */
typedef enum {
    GIN_STATUS_NONE = 0,
    GIN_STATUS_OK = 1,
    GIN_STATUS_NO_IN = 2
} Gin_status;

/* input class */
typedef enum {
    GIN_NONE = 0,
    GIN_LOC = 1,
    GIN_STROKE = 2,
    GIN_VAL = 3,
    GIN_CHOICE = 4,
    GIN_PICK = 5,
    GIN_STRING = 6
} Gin_class;

/* implicit regeneration mode */
typedef enum {
    GIRG_SUPPR = 0,
    GIRG_ALLOWED = 1
} Girg_mode;

/* level of GKS */
typedef enum {
    GLEVEL_0A = 0,
    GLEVEL_0B = 1,
    GLEVEL_0C = 2,
    GLEVEL_1A = 3,
    GLEVEL_1B = 4,
    GLEVEL_1C = 5,
    GLEVEL_2A = 6,
    GLEVEL_2B = 7,
    GLEVEL_2C = 8
} Glevel;

/* new frame action necessary */
typedef enum {
    GNEW_NO = 0,
    GNEW_YES = 1
} Gnew_frame_nec_upd;

/* operating mode */
typedef enum {
    GOP_REQ = 0,
    GOP_SAMPLE = 1,
    GOP_EVENT = 2
} Gop_mode;

/* operating state */
typedef enum {
    GST_GKCL = 0,
    GST_GKOP = 1,
    GST_WSOP = 2,
    GST_WSAC = 3,
    GST_SGOP = 4
} Gop_st;

/* polyline/fill area control flag */
typedef enum {
    GFLAG_LINE = 0,
    GFLAG_FILL = 1
} Gline_fill_ctrl_flag;

/* presence of invalid values */
typedef enum {
    GINVAL_ABSENT = 0,
    GINVAL_PRESENT = 1
} Gpres_inval;

/* regeneration flag */
typedef enum {
    GFLAG_POSTPONE = 0,
    GFLAG_PERFORM = 1
} Gupd_regen_flag;

/* relative input priority */
typedef enum {
    GPRI_HIGHER = 0,
    GPRI_LOWER = 1
} Grel_pri;

/* simultaneous events */
typedef enum {
    GSIMULT_NO_MORE = 0,
    GSIMULT_MORE = 1
} Gmore_simult_events;

/* text alignment horizontal */
typedef enum {
    GHOR_NORM = 0,
    GHOR_LEFT = 1,
    GHOR_CTR = 2,
    GHOR_RIGHT = 3
} Ghor_text_align;

/* text alignment vertical */
typedef enum {
    GVERT_NORM = 0,
    GVERT_TOP = 1,
    GVERT_CAP = 2,
    GVERT_HALF = 3,
    GVERT_BASE = 4,
    GVERT_BOTTOM = 5
} Gvert_text_align;

/* text path */
typedef enum {
    GPATH_RIGHT = 0,
    GPATH_LEFT = 1,
    GPATH_UP = 2,
    GPATH_DOWN = 3
} Gtext_path;

/* text precision */
typedef enum {
    GPREC_STRING = 0,
    GPREC_CHAR = 1,
    GPREC_STROKE = 2
} Gtext_prec;

/* type of returned value */
typedef enum {
    GINQ_SET = 0,
    GINQ_REALIZED = 1
} Ginq_type;

/* update state */
typedef enum {
    GUPD_NOT_PEND = 0,
    GUPD_PEND = 1
} Gupd_st;

/* workstation classification */
typedef enum {
    GCLASS_VEC = 0,
    GCLASS_RASTER = 1,
    GCLASS_OTHER = 2
} Gws_class;

/* visibility */
typedef enum {
    GSEG_INVIS = 0,
    GSEG_VIS = 1
} Gseg_vis;

/* workstation category */
typedef enum {
    GCAT_OUT = 0,
    GCAT_IN = 1,
    GCAT_OUTIN = 2,
    GCAT_WISS = 3,
    GCAT_MO = 4,
    GCAT_MI = 5
} Gws_cat;

/* workstation state */
typedef enum {
    GWS_INACTIVE = 0,
    GWS_ACTIVE = 1
} Gws_st;

/* data of which GKS knows only the size */
typedef struct {
    size_t size;
    void *data;
} Gdata;

/* a point */
typedef struct {
    Gfloat x;
    Gfloat y;
} Gpoint;

/* a vector */
typedef struct {
    Gfloat delta_x;
    Gfloat delta_y;
} Gvec;

/* a list of points */
typedef struct {
    Gint num_points;
    Gpoint *points;
} Gpoint_list;

/* a list of integers */
typedef struct {
    Gint num_ints;
    Gint *ints;
} Gint_list;

/* a size in whole numbers */
typedef struct {
    Gint size_x;
    Gint size_y;
} Gint_size;

/* a size */
typedef struct {
    Gfloat size_x;
    Gfloat size_y;
} Gfloat_size;

/* the limits of a rectangle */
typedef struct {
    Gfloat x_min;
    Gfloat x_max;
    Gfloat y_min;
    Gfloat y_max;
} Glimit;

/* a rectangle by two opposite corners */
typedef struct {
    Gpoint p;
    Gpoint q;
} Grect;

/* a colour */
typedef struct {
    Gfloat red;
    Gfloat green;
    Gfloat blue;
} Grgb;

/* a colour representation */
typedef union {
    Grgb rgb;
} Gcolr_rep;

/* aspect source flags */
typedef struct {
    Gasf linetype;
    Gasf linewidth;
    Gasf line_colr_ind;
    Gasf marker_type;
    Gasf marker_size;
    Gasf marker_colr_ind;
    Gasf text_font_prec;
    Gasf char_expan;
    Gasf char_space;
    Gasf text_colr_ind;
    Gasf fill_int_style;
    Gasf fill_style_ind;
    Gasf fill_colr_ind;
} Gasfs;

/* text font and precision */
typedef struct {
    Gint font;
    Gtext_prec prec;
} Gtext_font_prec;

/* text alignment */
typedef struct {
    Ghor_text_align hor;
    Gvert_text_align vert;
} Gtext_align;

/* a polyline representation */
typedef struct {
    Gint type;
    Gdouble width;
    Gint colr_ind;
} Gline_bundle;

/* a polymarker representation */
typedef struct {
    Gint type;
    Gdouble size;
    Gint colr_ind;
} Gmarker_bundle;

/* a text representation */
typedef struct {
    Gtext_font_prec text_font_prec;
    Gdouble char_expan;
    Gdouble char_space;
    Gint colr_ind;
} Gtext_bundle;

/* a fill area representation */
typedef struct {
    Gfill_int_style int_style;
    Gint style_ind;
    Gint colr_ind;
} Gfill_bundle;

/* a pattern or the colours of a cell array, row by row */
typedef struct {
    Gint_size dims;
    Gint *colr_array;
} Gpat_rep;

/* the individual attributes */
typedef struct {
    Gint linetype;
    Gdouble linewidth;
    Gint line_colr_ind;
    Gint marker_type;
    Gdouble marker_size;
    Gint marker_colr_ind;
    Gtext_font_prec text_font_prec;
    Gdouble char_expan;
    Gdouble char_space;
    Gint text_colr_ind;
    Gfill_int_style fill_int_style;
    Gint fill_style_ind;
    Gint fill_colr_ind;
    Gasfs asfs;
} Gindiv_attrs;

/* the primitive attributes */
typedef struct {
    Gint line_ind;
    Gint marker_ind;
    Gint text_ind;
    Gdouble char_ht;
    Gvec char_up_vec;
    Gdouble char_width;
    Gvec char_base_vec;
    Gtext_path text_path;
    Gtext_align text_align;
    Gint fill_ind;
    Gvec pat_width_vec;
    Gvec pat_ht_vec;
    Gpoint pat_ref_point;
} Gprim_attrs;

/* clipping indicator and clipping rectangle */
typedef struct {
    Gclip_ind clip_ind;
    Glimit clip_rect;
} Gclip;

/* window and viewport of a transformation */
typedef struct {
    Glimit win;
    Glimit vp;
} Gtran;

/* where text would lie */
typedef struct {
    Gpoint concat_point;
    Gpoint paral[4];
} Gtext_extent;

/* the size of a display space */
typedef struct {
    Gdc_units dc_units;
    Gfloat_size size_dc;
    Gint_size size_raster;
} Gdisp_space_size;

/* how many workstations there may be */
typedef struct {
    Gint simult_open;
    Gint simult_active;
    Gint assoc_seg;
} Gws_max_nums;

/* the lengths of the tables of a workstation */
typedef struct {
    Gint line_bundles;
    Gint marker_bundles;
    Gint text_bundles;
    Gint fill_bundles;
    Gint pat_reps;
    Gint colr_reps;
} Gmax_ws_st_tables;

/* polyline facilities */
typedef struct {
    Gint_list types;
    Gint num_widths;
    Gdouble nom_width;
    Gdouble min_width;
    Gdouble max_width;
    Gint num_pred_inds;
} Gline_facs;

/* polymarker facilities */
typedef struct {
    Gint_list types;
    Gint num_sizes;
    Gdouble nom_size;
    Gdouble min_size;
    Gdouble max_size;
    Gint num_pred_inds;
} Gmarker_facs;

/* text facilities */
typedef struct {
    Gint num_font_precs;
    Gtext_font_prec *font_precs;
    Gint num_char_hts;
    Gdouble min_char_ht;
    Gdouble max_char_ht;
    Gint num_char_expans;
    Gdouble min_char_expan;
    Gdouble max_char_expan;
    Gint num_pred_inds;
} Gtext_facs;

/* fill area facilities */
typedef struct {
    Gint num_int_styles;
    Gfill_int_style int_style[4];
    Gint_list hatch_styles;
    Gint num_pred_inds;
} Gfill_facs;

/* colour facilities */
typedef struct {
    Gint num_colrs;
    Gcolr_avail colr_avail;
    Gint num_pred_inds;
} Gcolr_facs;

/* how changes of workstation attributes become visible */
typedef struct {
    Gdyn_mod line_bundle;
    Gdyn_mod marker_bundle;
    Gdyn_mod text_bundle;
    Gdyn_mod fill_bundle;
    Gdyn_mod pat_rep;
    Gdyn_mod colr_rep;
    Gdyn_mod ws_tran;
} Gdyn_mod_ws_attrs;

/* how changes of segments become visible */
typedef struct {
    Gdyn_mod tran;
    Gdyn_mod vis_invis;
    Gdyn_mod invis_vis;
    Gdyn_mod highl;
    Gdyn_mod pri;
    Gdyn_mod add;
    Gdyn_mod del;
} Gdyn_mod_seg_attrs;

/* the attributes of a segment */
typedef struct {
    Gtran_matrix tran;
    Gseg_vis vis;
    Gseg_highl highl;
    Gdouble pri;
    Gseg_det det;
} Gseg_attrs;

/* what has been picked */
typedef struct {
    Gint seg_name;
    Gint pick_id;
} Gpick;

/* numbers of input devices */
typedef struct {
    Gint loc;
    Gint stroke;
    Gint val;
    Gint choice;
    Gint pick;
    Gint string;
} Gnum_in;

/* polyline attributes of a prompt */
typedef struct {
    Gasf type_asf;
    Gasf width_asf;
    Gasf colr_ind_asf;
    Gint ind;
    Gline_bundle bundle;
} Gline_attrs;

/* polymarker attributes of a prompt */
typedef struct {
    Gasf type_asf;
    Gasf size_asf;
    Gasf colr_ind_asf;
    Gint ind;
    Gmarker_bundle bundle;
} Gmarker_attrs;

/* fill area attributes of a prompt */
typedef struct {
    Gasf style_asf;
    Gasf style_ind_asf;
    Gasf colr_ind_asf;
    Gint ind;
    Gfill_bundle bundle;
} Gfill_attrs;

/* data record of a locator, by prompt and echo type */
typedef struct {
    union {
        Gdata pet_r1;
        Gdata pet_r2;
        Gdata pet_r3;
        struct {
            Gattr_ctrl_flag attr_ctrl_flag;
            Gline_attrs line_attrs;
        } pet_r4;
        struct {
            Gline_fill_ctrl_flag line_fill_ctrl_flag;
            Gattr_ctrl_flag attr_ctrl_flag;
            union {
                Gline_attrs line_attrs;
                Gfill_attrs fill_attrs;
            } attrs;
        } pet_r5;
        Gdata pet_r6;
        Gdata pet_u1;
    } pets;
} Gloc_data;

/* data record of a stroke device */
typedef struct {
    Gint init_pos;
    Gfloat x_interval;
    Gfloat y_interval;
    Gfloat time_interval;
    union {
        Gdata pet_r1;
        Gdata pet_r2;
        struct {
            Gattr_ctrl_flag attr_ctrl_flag;
            Gmarker_attrs marker_attrs;
        } pet_r3;
        struct {
            Gattr_ctrl_flag attr_ctrl_flag;
            Gline_attrs line_attrs;
        } pet_r4;
        Gdata pet_u1;
    } pets;
} Gstroke_data;

/* data record of a valuator */
typedef struct {
    union {
        Gdata pet_r1;
        Gdata pet_r2;
        Gdata pet_r3;
        Gdata pet_u1;
    } pets;
} Gval_data;

/* data record of a choice device */
typedef struct {
    union {
        Gdata pet_r1;
        struct {
            Gint num_prompts;
            Gpr_switch *prompts;
        } pet_r2;
        struct {
            Gint num_strings;
            char **strings;
        } pet_r3;
        struct {
            Gint num_strings;
            char **strings;
        } pet_r4;
        struct {
            Gint seg_name;
            Gint num_pick_ids;
            Gint *pick_ids;
        } pet_r5;
        Gdata pet_u1;
    } pets;
} Gchoice_data;

/* data record of a pick device */
typedef struct {
    union {
        Gdata pet_r1;
        Gdata pet_r2;
        Gdata pet_r3;
        Gdata pet_u1;
    } pets;
} Gpick_data;

/* data record of a string device */
typedef union {
    Gdata pet_r1;
    Gdata pet_u1;
} Gstring_data;

/* input of an escape function */
typedef union {
    Gdata escape_r1;
    Gdata escape_u1;
    struct { Gint cap; } escape_u3001;
    struct { Gint join; } escape_u3002;
    struct { Gint ws_id; Gint colr_ind; Gfloat alpha; } escape_u3003;
    struct { Gint ws_id; Gint antialiasing; } escape_u3004;
    struct { Gint ws_id; } escape_u3005;
} Gescape_in_data;

/* output of an escape function */
typedef union {
    Gdata escape_r1;
    Gdata escape_u1;
    struct { Gint antialiasing; } escape_u3005;
} Gescape_out_data;

/* data record of a generalized drawing primitive */
typedef union {
    Gdata gdp_r1;
    Gdata gdp_u1;
} Ggdp_data;

/* a metafile item */
typedef struct {
    Gint type;
    Gint length;
    union {
        Gctrl_flag clear_ws;
        Gupd_regen_flag upd_ws;
        struct {
            Gdefer_mode defer_mode;
            Girg_mode irg_mode;
        } defer_st;
        Gdata gdp_unsupp;
        Gdata impl_dep;
    } data;
} Gitem_data;

/* linetypes */
#define GLINE_SOLID 1
#define GLINE_DASH 2
#define GLINE_DOT 3
#define GLINE_DASH_DOT 4

/* marker types */
#define GMARKER_DOT 1
#define GMARKER_PLUS 2
#define GMARKER_ASTERISK 3
#define GMARKER_CIRCLE 4
#define GMARKER_CROSS 5

/* open GKS defaults */
#define GDEF_MEM_SIZE ((size_t) -1)
#define GDEF_ERR_FILE ((char *) 0)

/* locator prompt and echo types */
#define GLOC_DEF 1
#define GLOC_CROSS_HAIR 2
#define GLOC_TRACK_CROSS 3
#define GLOC_RUB_BAND 4
#define GLOC_RECT 5
#define GLOC_DIGIT 6

/* stroke prompt and echo types */
#define GSTROKE_DEF 1
#define GSTROKE_DIGIT 2
#define GSTROKE_MARKER 3
#define GSTROKE_LINE 4

/* valuator prompt and echo types */
#define GVAL_DEF 1
#define GVAL_GRAPH 2
#define GVAL_DIGIT 3

/* choice prompt and echo types */
#define GCHOICE_DEF 1
#define GCHOICE_PR_ECHO 2
#define GCHOICE_STRING_PR 3
#define GCHOICE_STRING_IN 4
#define GCHOICE_SEG 5

/* pick prompt and echo types */
#define GPICK_DEF 1
#define GPICK_GROUP_HIGHL 2
#define GPICK_SEG_HIGHL 3

/* string prompt and echo types */
#define GSTRING_DEF 1

/* another spelling, of NCAR's header */
#define GCAT_OTHER GCLASS_OTHER

/* function identifiers, as the error handler is given them */
#define Gfn_open_gks 0
#define Gfn_close_gks 1
#define Gfn_open_ws 2
#define Gfn_close_ws 3
#define Gfn_activate_ws 4
#define Gfn_deactivate_ws 5
#define Gfn_clear_ws 6
#define Gfn_redraw_all_segs_ws 7
#define Gfn_upd_ws 8
#define Gfn_set_defer_st 9
#define Gfn_message 10
#define Gfn_escape 11
#define Gfn_polyline 12
#define Gfn_polymarker 13
#define Gfn_text 14
#define Gfn_fill_area 15
#define Gfn_cell_array 16
#define Gfn_gdp 17
#define Gfn_set_line_ind 18
#define Gfn_set_linetype 19
#define Gfn_set_linewidth 20
#define Gfn_set_line_colr_ind 21
#define Gfn_set_marker_ind 22
#define Gfn_set_marker_type 23
#define Gfn_set_marker_size 24
#define Gfn_set_marker_colr_ind 25
#define Gfn_set_text_ind 26
#define Gfn_set_text_font_prec 27
#define Gfn_set_char_expan 28
#define Gfn_set_char_space 29
#define Gfn_set_text_colr_ind 30
#define Gfn_set_char_ht 31
#define Gfn_set_char_up_vec 32
#define Gfn_set_text_path 33
#define Gfn_set_text_align 34
#define Gfn_set_fill_ind 35
#define Gfn_set_fill_int_style 36
#define Gfn_set_fill_style_ind 37
#define Gfn_set_fill_colr_ind 38
#define Gfn_set_pat_size 39
#define Gfn_set_pat_ref_point 40
#define Gfn_set_asfs 41
#define Gfn_set_pick_id 42
#define Gfn_set_line_rep 43
#define Gfn_set_marker_rep 44
#define Gfn_set_text_rep 45
#define Gfn_set_fill_rep 46
#define Gfn_set_pat_rep 47
#define Gfn_set_colr_rep 48
#define Gfn_set_win 49
#define Gfn_set_vp 50
#define Gfn_set_vp_in_pri 51
#define Gfn_sel_norm_tran 52
#define Gfn_set_clip_ind 53
#define Gfn_set_ws_win 54
#define Gfn_set_ws_vp 55
#define Gfn_create_seg 56
#define Gfn_close_seg 57
#define Gfn_rename_seg 58
#define Gfn_del_seg 59
#define Gfn_del_seg_ws 60
#define Gfn_assoc_seg_ws 61
#define Gfn_copy_seg_ws 62
#define Gfn_insert_seg 63
#define Gfn_set_seg_tran 64
#define Gfn_set_vis 65
#define Gfn_set_highl 66
#define Gfn_set_seg_pri 67
#define Gfn_set_det 68
#define Gfn_init_loc 69
#define Gfn_init_stroke 70
#define Gfn_init_val 71
#define Gfn_init_choice 72
#define Gfn_init_pick 73
#define Gfn_init_string 74
#define Gfn_set_loc_mode 75
#define Gfn_set_stroke_mode 76
#define Gfn_set_val_mode 77
#define Gfn_set_choice_mode 78
#define Gfn_set_pick_mode 79
#define Gfn_set_string_mode 80
#define Gfn_req_loc 81
#define Gfn_req_stroke 82
#define Gfn_req_val 83
#define Gfn_req_choice 84
#define Gfn_req_pick 85
#define Gfn_req_string 86
#define Gfn_sample_loc 87
#define Gfn_sample_stroke 88
#define Gfn_sample_val 89
#define Gfn_sample_choice 90
#define Gfn_sample_pick 91
#define Gfn_sample_string 92
#define Gfn_await_event 93
#define Gfn_flush_events 94
#define Gfn_get_loc 95
#define Gfn_get_stroke 96
#define Gfn_get_val 97
#define Gfn_get_choice 98
#define Gfn_get_pick 99
#define Gfn_get_string 100
#define Gfn_write_item 101
#define Gfn_get_item_type 102
#define Gfn_read_item 103
#define Gfn_interpret_item 104
#define Gfn_eval_tran_matrix 105
#define Gfn_accum_tran_matrix 106

/* ---- control ---- */

/* OPEN GKS */
void gopen_gks(const char *err_file, size_t mem_unit);

/* CLOSE GKS */
void gclose_gks(void);

/* OPEN WORKSTATION */
void gopen_ws(Gint ws_id, const char *conn_id, Gint ws_type);

/* CLOSE WORKSTATION */
void gclose_ws(Gint ws_id);

/* ACTIVATE WORKSTATION */
void gactivate_ws(Gint ws_id);

/* DEACTIVATE WORKSTATION */
void gdeactivate_ws(Gint ws_id);

/* CLEAR WORKSTATION */
void gclear_ws(Gint ws_id, Gctrl_flag ctrl_flag);

/* REDRAW ALL SEGMENTS ON WORKSTATION */
void gredraw_all_segs_ws(Gint ws_id);

/* UPDATE WORKSTATION */
void gupd_ws(Gint ws_id, Gupd_regen_flag upd_regen_flag);

/* SET DEFERRAL STATE */
void gset_defer_st(Gint ws_id, Gdefer_mode defer_mode, Girg_mode irg_mode);

/* MESSAGE */
void gmessage(Gint ws_id, const char *message);

/* ESCAPE */
void gescape(Gint func_id, const Gescape_in_data *in_data, Gstore *store_data,
             Gescape_out_data **out_data);

/* ---- output ---- */

/* POLYLINE */
void gpolyline(const Gpoint_list *point_list);

/* POLYMARKER */
void gpolymarker(const Gpoint_list *point_list);

/* TEXT */
void gtext(const Gpoint *text_pos, const char *char_string);

/* FILL AREA */
void gfill_area(const Gpoint_list *point_list);

/* CELL ARRAY */
void gcell_array(const Grect *rect, const Gpat_rep *colr_array);

/* GENERALIZED DRAWING PRIMITIVE */
void ggdp(const Gpoint_list *point_list, Gint gdp_id, const Ggdp_data *gdp_data);

/* ---- output attributes: workstation independent ---- */

/* SET POLYLINE INDEX */
void gset_line_ind(Gint line_ind);

/* SET LINETYPE */
void gset_linetype(Gint linetype);

/* SET LINEWIDTH SCALE FACTOR */
void gset_linewidth(Gdouble linewidth);

/* SET POLYLINE COLOUR INDEX */
void gset_line_colr_ind(Gint line_colr_ind);

/* SET POLYMARKER INDEX */
void gset_marker_ind(Gint marker_ind);

/* SET MARKER TYPE */
void gset_marker_type(Gint marker_type);

/* SET MARKER SIZE SCALE FACTOR */
void gset_marker_size(Gdouble marker_size);

/* SET POLYMARKER COLOUR INDEX */
void gset_marker_colr_ind(Gint marker_colr_ind);

/* SET TEXT INDEX */
void gset_text_ind(Gint text_ind);

/* SET TEXT FONT AND PRECISION */
void gset_text_font_prec(const Gtext_font_prec *text_font_prec);

/* SET CHARACTER EXPANSION FACTOR */
void gset_char_expan(Gdouble char_expan);

/* SET CHARACTER SPACING */
void gset_char_space(Gdouble char_space);

/* SET TEXT COLOUR INDEX */
void gset_text_colr_ind(Gint text_colr_ind);

/* SET CHARACTER HEIGHT */
void gset_char_ht(Gdouble char_ht);

/* SET CHARACTER UP VECTOR */
void gset_char_up_vec(const Gvec *char_up_vec);

/* SET TEXT PATH */
void gset_text_path(Gtext_path text_path);

/* SET TEXT ALIGNMENT */
void gset_text_align(const Gtext_align *text_align);

/* SET FILL AREA INDEX */
void gset_fill_ind(Gint fill_ind);

/* SET FILL AREA INTERIOR STYLE */
void gset_fill_int_style(Gfill_int_style fill_int_style);

/* SET FILL AREA STYLE INDEX */
void gset_fill_style_ind(Gint fill_style_ind);

/* SET FILL AREA COLOUR INDEX */
void gset_fill_colr_ind(Gint fill_colr_ind);

/* SET PATTERN SIZE */
void gset_pat_size(Gdouble x_size, Gdouble y_size);

/* SET PATTERN REFERENCE POINT */
void gset_pat_ref_point(const Gpoint *pat_ref_point);

/* SET ASPECT SOURCE FLAGS */
void gset_asfs(const Gasfs *list_asf);

/* SET PICK IDENTIFIER */
void gset_pick_id(Gint pick_id);

/* ---- output attributes: workstation (representations) ---- */

/* SET POLYLINE REPRESENTATION */
void gset_line_rep(Gint ws_id, Gint line_ind, const Gline_bundle *line_rep);

/* SET POLYMARKER REPRESENTATION */
void gset_marker_rep(Gint ws_id, Gint marker_ind, const Gmarker_bundle *marker_rep);

/* SET TEXT REPRESENTATION */
void gset_text_rep(Gint ws_id, Gint text_ind, const Gtext_bundle *text_rep);

/* SET FILL AREA REPRESENTATION */
void gset_fill_rep(Gint ws_id, Gint fill_ind, const Gfill_bundle *fill_rep);

/* SET PATTERN REPRESENTATION */
void gset_pat_rep(Gint ws_id, Gint pat_ind, const Gpat_rep *pat_rep);

/* SET COLOUR REPRESENTATION */
void gset_colr_rep(Gint ws_id, Gint colr_ind, const Gcolr_rep *colr_rep);

/* ---- transformation: normalization ---- */

/* SET WINDOW */
void gset_win(Gint tran_num, const Glimit *win_limits);

/* SET VIEWPORT */
void gset_vp(Gint tran_num, const Glimit *vp_limits);

/* SET VIEWPORT INPUT PRIORITY */
void gset_vp_in_pri(Gint tran_num, Gint ref_tran_num, Grel_pri rel_pri);

/* SELECT NORMALIZATION TRANSFORMATION */
void gsel_norm_tran(Gint tran_num);

/* SET CLIPPING INDICATOR */
void gset_clip_ind(Gclip_ind clip_ind);

/* ---- transformation: workstation ---- */

/* SET WORKSTATION WINDOW */
void gset_ws_win(Gint ws_id, Glimit *ws_win_limits);

/* SET WORKSTATION VIEWPORT */
void gset_ws_vp(Gint ws_id, Glimit *ws_vp_limits);

/* ---- segment: manipulation ---- */

/* CREATE SEGMENT */
void gcreate_seg(Gint seg_name);

/* CLOSE SEGMENT */
void gclose_seg(void);

/* RENAME SEGMENT */
void grename_seg(Gint old_seg_name, Gint new_seg_name);

/* DELETE SEGMENT */
void gdel_seg(Gint seg_name);

/* DELETE SEGMENT FROM WORKSTATION */
void gdel_seg_ws(Gint ws_id, Gint seg_name);

/* ASSOCIATE SEGMENT WITH WORKSTATION */
void gassoc_seg_ws(Gint ws_id, Gint seg_name);

/* COPY SEGMENT TO WORKSTATION */
void gcopy_seg_ws(Gint ws_id, Gint seg_name);

/* INSERT SEGMENT */
void ginsert_seg(Gint seg_name, const Gtran_matrix tran_matrix);

/* ---- segment: attributes ---- */

/* SET SEGMENT TRANSFORMATION */
void gset_seg_tran(Gint seg_name, const Gtran_matrix tran_matrix);

/* SET VISIBILITY */
void gset_vis(Gint seg_name, Gseg_vis seg_vis);

/* SET HIGHLIGHTING */
void gset_highl(Gint seg_name, Gseg_highl seg_highl);

/* SET SEGMENT PRIORITY */
void gset_seg_pri(Gint seg_name, Gdouble seg_pri);

/* SET DETECTABILITY */
void gset_det(Gint seg_name, Gseg_det seg_det);

/* ---- input: initialise ---- */

/* INITIALISE LOCATOR */
void ginit_loc(Gint ws_id, Gint loc_num, Gint init_norm_tran_num, const Gpoint *init_loc_pos,
               Gint pet, const Glimit *echo_area, const Gloc_data *loc_data);

/* INITIALISE STROKE */
void ginit_stroke(Gint ws_id, Gint stroke_num, Gint init_norm_tran_num,
                  const Gpoint_list *init_stroke, Gint pet, const Glimit *echo_area,
                  Gint in_buf_size, const Gstroke_data *stroke_data);

/* INITIALISE VALUATOR */
void ginit_val(Gint ws_id, Gint val_num, Gdouble init_value, Gint pet, const Glimit *echo_area,
               Gdouble low_value, Gdouble high_value, const Gval_data *val_data);

/* INITIALISE CHOICE */
void ginit_choice(Gint ws_id, Gint choice_num, Gin_status init_status, Gint init_choice, Gint pet,
                  const Glimit *echo_area, const Gchoice_data *choice_data);

/* INITIALISE PICK */
void ginit_pick(Gint ws_id, Gint pick_num, Gin_status init_status, const Gpick *init_pick, Gint pet,
                const Glimit *echo_area, const Gpick_data *pick_data);

/* INITIALISE STRING */
void ginit_string(Gint ws_id, Gint string_num, const char *init_string, Gint pet,
                  const Glimit *echo_area, Gint in_buf_size, Gint init_cur_pos,
                  const Gstring_data *string_data);

/* ---- input: set mode ---- */

/* SET LOCATOR MODE */
void gset_loc_mode(Gint ws_id, Gint loc_num, Gop_mode op_mode, Gecho_switch echo_switch);

/* SET STROKE MODE */
void gset_stroke_mode(Gint ws_id, Gint stroke_num, Gop_mode op_mode, Gecho_switch echo_switch);

/* SET VALUATOR MODE */
void gset_val_mode(Gint ws_id, Gint val_num, Gop_mode op_mode, Gecho_switch echo_switch);

/* SET CHOICE MODE */
void gset_choice_mode(Gint ws_id, Gint choice_num, Gop_mode op_mode, Gecho_switch echo_switch);

/* SET PICK MODE */
void gset_pick_mode(Gint ws_id, Gint pick_num, Gop_mode op_mode, Gecho_switch echo_switch);

/* SET STRING MODE */
void gset_string_mode(Gint ws_id, Gint string_num, Gop_mode op_mode, Gecho_switch echo_switch);

/* ---- input: request ---- */

/* REQUEST LOCATOR */
void greq_loc(Gint ws_id, Gint loc_num, Gin_status *in_status, Gint *norm_tran_num, Gpoint *loc_pos);

/* REQUEST STROKE */
void greq_stroke(Gint ws_id, Gint stroke_num, Gin_status *in_status, Gint *norm_tran_num,
                 Gpoint_list *stroke);

/* REQUEST VALUATOR */
void greq_val(Gint ws_id, Gint val_num, Gin_status *in_status, Gdouble *value);

/* REQUEST CHOICE */
void greq_choice(Gint ws_id, Gint choice_num, Gin_status *in_status, Gint *choice);

/* REQUEST PICK */
void greq_pick(Gint ws_id, Gint pick_num, Gin_status *in_status, Gpick *pick);

/* REQUEST STRING */
void greq_string(Gint ws_id, Gint string_num, Gin_status *in_status, char *string);

/* ---- input: sample ---- */

/* SAMPLE LOCATOR */
void gsample_loc(Gint ws_id, Gint loc_num, Gint *norm_tran_num, Gpoint *loc_pos);

/* SAMPLE STROKE */
void gsample_stroke(Gint ws_id, Gint stroke_num, Gint *norm_tran_num, Gpoint_list *stroke);

/* SAMPLE VALUATOR */
void gsample_val(Gint ws_id, Gint val_num, Gdouble *value);

/* SAMPLE CHOICE */
void gsample_choice(Gint ws_id, Gint choice_num, Gin_status *in_status, Gint *choice);

/* SAMPLE PICK */
void gsample_pick(Gint ws_id, Gint pick_num, Gin_status *in_status, Gpick *pick);

/* SAMPLE STRING */
void gsample_string(Gint ws_id, Gint string_num, char *string);

/* ---- input: event ---- */

/* AWAIT EVENT */
void gawait_event(Gdouble timeout, Gint *ws_id, Gin_class *in_class, Gint *in_num);

/* FLUSH DEVICE EVENTS */
void gflush_events(Gint ws_id, Gin_class in_class, Gint in_num);

/* GET LOCATOR */
void gget_loc(Gint *norm_tran_num, Gpoint *loc_pos);

/* GET STROKE */
void gget_stroke(Gint *norm_tran_num, Gpoint_list *stroke);

/* GET VALUATOR */
void gget_val(Gdouble *value);

/* GET CHOICE */
void gget_choice(Gin_status *in_status, Gint *choice);

/* GET PICK */
void gget_pick(Gin_status *in_status, Gpick *pick);

/* GET STRING */
void gget_string(char *string);

/* ---- metafile ---- */

/* WRITE ITEM TO GKSM */
void gwrite_item(Gint ws_id, Gint item_type, Gint item_data_length, const Gitem_data *item_data);

/* GET ITEM TYPE FROM GKSM */
void gget_item_type(Gint ws_id, Gint *item_type, Gint *item_data_length);

/* READ ITEM FROM GKSM */
void gread_item(Gint ws_id, Gint max_item_data_length, Gitem_data *item_data);

/* INTERPRET ITEM */
void ginterpret_item(Gint type, Gint item_data_length, const Gitem_data *item_data);

/* ---- inquiry: operating state ---- */

/* INQUIRE OPERATING STATE VALUE */
void ginq_op_st(Gop_st *op_st);

/* ---- inquiry: GKS description table ---- */

/* INQUIRE LEVEL OF GKS */
void ginq_level_gks(Gint *err_ind, Glevel *level);

/* INQUIRE LIST OF AVAILABLE WORKSTATION TYPES */
void ginq_list_avail_ws_types(Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                              Gint_list *ws_type, Gint *length_list);

/* INQUIRE WORKSTATION MAXIMUM NUMBERS */
void ginq_ws_max_nums(Gint *err_ind, Gws_max_nums *ws_max_num);

/* INQUIRE MAXIMUM NORMALIZATION TRANSFORMATION NUMBER */
void ginq_max_norm_tran_num(Gint *err_ind, Gint *max_norm_tran_num);

/* ---- inquiry: GKS state list ---- */

/* INQUIRE SET OF OPEN WORKSTATIONS */
void ginq_set_open_wss(Gint num_elems_appl_list, Gint start_pos, Gint *err_ind, Gint_list *open_ws,
                       Gint *length_list);

/* INQUIRE SET OF ACTIVE WORKSTATIONS */
void ginq_set_active_wss(Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                         Gint_list *active_ws, Gint *length_list);

/* INQUIRE CURRENT PRIMITIVE ATTRIBUTE VALUES */
void ginq_cur_prim_attrs(Gint *err_ind, Gprim_attrs *prim_attr);

/* ---- inquiry: GKS state list (part of INQUIRE CURRENT PRIMITIVE ATTRIBUTE VALUES) ---- */

/* INQUIRE POLYLINE INDEX */
void ginq_line_ind(Gint *err_ind, Gint *line_ind);

/* INQUIRE POLYMARKER INDEX */
void ginq_marker_ind(Gint *err_ind, Gint *marker_ind);

/* INQUIRE TEXT INDEX */
void ginq_text_ind(Gint *err_ind, Gint *text_ind);

/* INQUIRE CHARACTER HEIGHT */
void ginq_char_ht(Gint *err_ind, Gdouble *char_ht);

/* INQUIRE CHARACTER UP VECTOR */
void ginq_char_up_vec(Gint *err_ind, Gvec *char_up_vec);

/* INQUIRE CHARACTER WIDTH */
void ginq_char_width(Gint *err_ind, Gdouble *char_width);

/* INQUIRE CHARACTER BASE VECTOR */
void ginq_char_base_vec(Gint *err_ind, Gvec *char_base_vec);

/* INQUIRE TEXT PATH */
void ginq_text_path(Gint *err_ind, Gtext_path *text_path);

/* INQUIRE TEXT ALIGNMENT */
void ginq_text_align(Gint *err_ind, Gtext_align *text_align);

/* INQUIRE FILL AREA INDEX */
void ginq_fill_ind(Gint *err_ind, Gint *fill_ind);

/* INQUIRE PATTERN WIDTH VECTOR */
void ginq_pat_width_vec(Gint *err_ind, Gvec *pat_width_vec);

/* INQUIRE PATTERN HEIGHT VECTOR */
void ginq_pat_ht_vec(Gint *err_ind, Gvec *pat_ht_vec);

/* INQUIRE PATTERN REFERENCE POINT */
void ginq_pat_ref_point(Gint *err_ind, Gpoint *pat_ref_point);

/* ---- inquiry: GKS state list ---- */

/* INQUIRE CURRENT PICK IDENTIFIER VALUE */
void ginq_cur_pick_id(Gint *err_ind, Gint *pick_id);

/* INQUIRE CURRENT INDIVIDUAL ATTRIBUTE VALUES */
void ginq_cur_indiv_attrs(Gint *err_ind, Gindiv_attrs *indiv_attr);

/* ---- inquiry: GKS state list (part of INQUIRE CURRENT INDIVIDUAL ATTRIBUTE VALUES) ---- */

/* INQUIRE LINETYPE */
void ginq_linetype(Gint *err_ind, Gint *linetype);

/* INQUIRE LINEWIDTH SCALE FACTOR */
void ginq_linewidth(Gint *err_ind, Gdouble *linewidth);

/* INQUIRE POLYLINE COLOUR INDEX */
void ginq_line_colr_ind(Gint *err_ind, Gint *line_colr_ind);

/* INQUIRE MARKER TYPE */
void ginq_marker_type(Gint *err_ind, Gint *marker_type);

/* INQUIRE MARKER SIZE SCALE FACTOR */
void ginq_marker_size(Gint *err_ind, Gdouble *marker_size);

/* INQUIRE POLYMARKER COLOUR INDEX */
void ginq_marker_colr_ind(Gint *err_ind, Gint *marker_colr_ind);

/* INQUIRE TEXT FONT AND PRECISION */
void ginq_text_font_prec(Gint *err_ind, Gtext_font_prec *text_font_prec);

/* INQUIRE CHARACTER EXPANSION FACTOR */
void ginq_char_expan(Gint *err_ind, Gdouble *char_expan);

/* INQUIRE CHARACTER SPACING */
void ginq_char_space(Gint *err_ind, Gdouble *char_space);

/* INQUIRE TEXT COLOUR INDEX */
void ginq_text_colr_ind(Gint *err_ind, Gint *text_colr_ind);

/* INQUIRE FILL AREA INTERIOR STYLE */
void ginq_fill_int_style(Gint *err_ind, Gfill_int_style *fill_int_style);

/* INQUIRE FILL AREA STYLE INDEX */
void ginq_fill_style_ind(Gint *err_ind, Gint *fill_style_ind);

/* INQUIRE FILL AREA COLOUR INDEX */
void ginq_fill_colr_ind(Gint *err_ind, Gint *fill_colr_ind);

/* INQUIRE ASPECT SOURCE FLAGS */
void ginq_asfs(Gint *err_ind, Gasfs *list_asf);

/* ---- inquiry: GKS state list ---- */

/* INQUIRE CURRENT NORMALIZATION TRANSFORMATION NUMBER */
void ginq_cur_norm_tran_num(Gint *err_ind, Gint *norm_tran_num);

/* INQUIRE LIST OF NORMALIZATION TRANSFORMATION NUMBERS */
void ginq_list_norm_tran_nums(Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                              Gint_list *norm_tran_num, Gint *length_list);

/* INQUIRE NORMALIZATION TRANSFORMATION */
void ginq_norm_tran(Gint num, Gint *err_ind, Gtran *norm_tran);

/* INQUIRE CLIPPING */
void ginq_clip(Gint *err_ind, Gclip *clip_ind_rect);

/* INQUIRE NAME OF OPEN SEGMENT */
void ginq_name_open_seg(Gint *err_ind, Gint *name_open_seg);

/* INQUIRE SET OF SEGMENT NAMES IN USE */
void ginq_set_seg_names(Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                        Gint_list *seg_names, Gint *length_list);

/* INQUIRE MORE SIMULTANEOUS EVENTS */
void ginq_more_simult_events(Gint *err_ind, Gmore_simult_events *simult_events);

/* ---- inquiry: workstation state list ---- */

/* INQUIRE WORKSTATION CONNECTION AND TYPE */
void ginq_ws_conn_type(Gint ws_id, Gint string_length, Gint *err_ind, char *conn_id, Gint *ws_type);

/* INQUIRE WORKSTATION STATE */
void ginq_ws_st(Gint ws_id, Gint *err_ind, Gws_st *ws_st);

/* INQUIRE WORKSTATION DEFERRAL AND UPDATE STATES */
void ginq_ws_defer_upd_sts(Gint ws_id, Gint *err_ind, Gdefer_mode *defer_mode, Girg_mode *irg_mode,
                           Gdisp_space_empty *disp_empty, Gnew_frame_nec_upd *new_frame);

/* INQUIRE LIST OF POLYLINE INDICES */
void ginq_list_line_inds(Gint ws_id, Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                         Gint_list *def_line_inds, Gint *length_list);

/* INQUIRE POLYLINE REPRESENTATION */
void ginq_line_rep(Gint ws_id, Gint line_ind, Ginq_type type, Gint *err_ind, Gline_bundle *line_rep);

/* INQUIRE LIST OF POLYMARKER INDICES */
void ginq_list_marker_inds(Gint ws_id, Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                           Gint_list *def_marker_inds, Gint *length_list);

/* INQUIRE POLYMARKER REPRESENTATION */
void ginq_marker_rep(Gint ws_id, Gint marker_ind, Ginq_type type, Gint *err_ind,
                     Gmarker_bundle *marker_rep);

/* INQUIRE LIST OF TEXT INDICES */
void ginq_list_text_inds(Gint ws_id, Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                         Gint_list *def_text_inds, Gint *length_list);

/* INQUIRE TEXT REPRESENTATION */
void ginq_text_rep(Gint ws_id, Gint text_ind, Ginq_type type, Gint *err_ind, Gtext_bundle *text_rep);

/* INQUIRE TEXT EXTENT */
void ginq_text_extent(Gint ws_id, const Gpoint *pos, const char *str, Gint *err_ind,
                      Gtext_extent *extent);

/* INQUIRE LIST OF FILL AREA INDICES */
void ginq_list_fill_inds(Gint ws_id, Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                         Gint_list *def_fill_inds, Gint *length_list);

/* INQUIRE FILL AREA REPRESENTATION */
void ginq_fill_rep(Gint ws_id, Gint fill_ind, Ginq_type type, Gint *err_ind, Gfill_bundle *fill_rep);

/* INQUIRE LIST OF PATTERN INDICES */
void ginq_list_pat_inds(Gint ws_id, Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                        Gint_list *def_pat_inds, Gint *length_list);

/* INQUIRE PATTERN REPRESENTATION */
void ginq_pat_rep(Gint ws_id, Gint pat_ind, Ginq_type type, Gstore *store, Gint *err_ind,
                  Gpat_rep **pat_rep);

/* INQUIRE LIST OF COLOUR INDICES */
void ginq_list_colr_inds(Gint ws_id, Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                         Gint_list *def_colr_inds, Gint *length_list);

/* INQUIRE COLOUR REPRESENTATION */
void ginq_colr_rep(Gint ws_id, Gint colr_ind, Ginq_type type, Gint *err_ind, Gcolr_rep *colr_rep);

/* INQUIRE WORKSTATION TRANSFORMATION */
void ginq_ws_tran(Gint ws_id, Gint *err_ind, Gupd_st *ws_tran_upd_st, Glimit *req_ws_win,
                  Glimit *cur_ws_win, Glimit *req_ws_vp, Glimit *cur_ws_vp);

/* INQUIRE SET OF SEGMENT NAMES ON WORKSTATION */
void ginq_set_seg_names_ws(Gint ws_id, Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                           Gint_list *seg_names, Gint *length_list);

/* INQUIRE LOCATOR DEVICE STATE */
void ginq_loc_st(Gint ws_id, Gint loc_num, Ginq_type type, Gstore *store, Gint *err_ind,
                 Gop_mode *op_mode, Gecho_switch *echo_switch, Gint *init_norm_tran_num,
                 Gpoint *init_loc_pos, Gint *pet, Glimit *echo_area, Gloc_data **loc_data);

/* INQUIRE STROKE DEVICE STATE */
void ginq_stroke_st(Gint ws_id, Gint stroke_num, Ginq_type type, Gstore *store, Gint *err_ind,
                    Gop_mode *op_mode, Gecho_switch *echo_switch, Gint *init_norm_tran_num,
                    Gpoint_list **init_stroke, Gint *pet, Glimit *echo_area, Gint *in_buf_size,
                    Gstroke_data **stroke_data);

/* INQUIRE VALUATOR DEVICE STATE */
void ginq_val_st(Gint ws_id, Gint val_num, Gstore *store, Gint *err_ind, Gop_mode *op_mode,
                 Gecho_switch *echo_switch, Gdouble *init_value, Gint *pet, Glimit *echo_area,
                 Gdouble *low_value, Gdouble *high_value, Gval_data **val_data);

/* INQUIRE CHOICE DEVICE STATE */
void ginq_choice_st(Gint ws_id, Gint choice_num, Gstore *store, Gint *err_ind, Gop_mode *op_mode,
                    Gecho_switch *echo_switch, Gin_status *init_status, Gint *init_choice,
                    Gint *pet, Glimit *echo_area, Gchoice_data **choice_data);

/* INQUIRE PICK DEVICE STATE */
void ginq_pick_st(Gint ws_id, Gint pick_num, Ginq_type type, Gstore *store, Gint *err_ind,
                  Gop_mode *op_mode, Gecho_switch *echo_switch, Gin_status *init_status,
                  Gpick *init_pick, Gint *pet, Glimit *echo_area, Gpick_data **pick_data);

/* INQUIRE STRING DEVICE STATE */
void ginq_string_st(Gint ws_id, Gint string_num, Gstore *store, Gint *err_ind, Gop_mode *op_mode,
                    Gecho_switch *echo_switch, char **init_string, Gint *pet, Glimit *echo_area,
                    Gint *in_buf_size, Gint *init_cur_pos, Gstring_data **string_data);

/* ---- inquiry: workstation description table ---- */

/* INQUIRE WORKSTATION CATEGORY */
void ginq_ws_cat(Gint ws_type, Gint *err_ind, Gws_cat *cat);

/* INQUIRE WORKSTATION CLASSIFICATION */
void ginq_ws_class(Gint ws_type, Gint *err_ind, Gws_class *wsclass);

/* INQUIRE DISPLAY SPACE SIZE */
void ginq_disp_space_size(Gint ws_type, Gint *err_ind, Gdisp_space_size *disp_size);

/* INQUIRE DYNAMIC MODIFICATION OF WORKSTATION ATTRIBUTES */
void ginq_dyn_mod_ws_attrs(Gint ws_type, Gint *err_ind, Gdyn_mod_ws_attrs *dyn_mod);

/* INQUIRE DEFAULT DEFERRAL STATE VALUES */
void ginq_def_defer_sts(Gint ws_type, Gint *err_ind, Gdefer_mode *defer_mode, Girg_mode *irg_mode);

/* INQUIRE POLYLINE FACILITIES */
void ginq_line_facs(Gint ws_type, Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                    Gline_facs *line_facs, Gint *length_list);

/* INQUIRE PREDEFINED POLYLINE REPRESENTATION */
void ginq_pred_line_rep(Gint ws_type, Gint ind, Gint *err_ind, Gline_bundle *line_rep);

/* INQUIRE POLYMARKER FACILITIES */
void ginq_marker_facs(Gint ws_type, Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                      Gmarker_facs *marker_facs, Gint *length_list);

/* INQUIRE PREDEFINED POLYMARKER REPRESENTATION */
void ginq_pred_marker_rep(Gint ws_type, Gint ind, Gint *err_ind, Gmarker_bundle *marker_rep);

/* INQUIRE TEXT FACILITIES */
void ginq_text_facs(Gint ws_type, Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                    Gtext_facs *text_facs, Gint *length_list);

/* INQUIRE PREDEFINED TEXT REPRESENTATION */
void ginq_pred_text_rep(Gint ws_type, Gint ind, Gint *err_ind, Gtext_bundle *text_rep);

/* INQUIRE FILL AREA FACILITIES */
void ginq_fill_facs(Gint ws_type, Gint hatch_length, Gint hatch_start_pos, Gint *err_ind,
                    Gfill_facs *fill_facs, Gint *act_hatch_length);

/* INQUIRE PREDEFINED FILL AREA REPRESENTATION */
void ginq_pred_fill_rep(Gint ws_type, Gint ind, Gint *err_ind, Gfill_bundle *fill_rep);

/* INQUIRE PATTERN FACILITIES */
void ginq_pat_facs(Gint ws_type, Gint *err_ind, Gint *num_pred_inds);

/* INQUIRE PREDEFINED PATTERN REPRESENTATION */
void ginq_pred_pat_rep(Gint ws_type, Gint ind, Gstore *store, Gint *err_ind, Gpat_rep **pat_rep);

/* INQUIRE COLOUR FACILITIES */
void ginq_colr_facs(Gint ws_type, Gint *err_ind, Gcolr_facs *colr_facs);

/* INQUIRE PREDEFINED COLOUR REPRESENTATION */
void ginq_pred_colr_rep(Gint ws_type, Gint ind, Gint *err_ind, Gcolr_rep *colr_rep);

/* INQUIRE LIST OF AVAILABLE GENERALIZED DRAWING PRIMITIVES */
void ginq_list_avail_gdps(Gint ws_type, Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                          Gint_list *gdp, Gint *length_list);

/* INQUIRE GENERALIZED DRAWING PRIMITIVE */
void ginq_gdp(Gint ws_type, Gint gdp, Gint *err_ind, Gint *num_attr, Gattrs attr[4]);

/* INQUIRE MAXIMUM LENGTH OF WORKSTATION STATE TABLES */
void ginq_max_ws_st_tables(Gint ws_type, Gint *err_ind, Gmax_ws_st_tables *lengths);

/* INQUIRE NUMBER OF SEGMENT PRIORITIES SUPPORTED */
void ginq_num_seg_pris(Gint ws_type, Gint *err_ind, Gint *num_pri);

/* INQUIRE DYNAMIC MODIFICATION OF SEGMENT ATTRIBUTES */
void ginq_dyn_mod_seg_attrs(Gint ws_type, Gint *err_ind, Gdyn_mod_seg_attrs *dyn_mod);

/* INQUIRE NUMBER OF AVAILABLE LOGICAL INPUT DEVICES */
void ginq_num_avail_in(Gint ws_type, Gint *err_ind, Gnum_in *num_in);

/* INQUIRE DEFAULT LOCATOR DEVICE DATA */
void ginq_def_loc_data(Gint ws_type, Gint loc_num, Gstore *store, Gint *err_ind, Gpoint *loc_pos,
                       Gint_list **pet_list, Glimit *echo_area, Gloc_data **loc_data);

/* INQUIRE DEFAULT STROKE DEVICE DATA */
void ginq_def_stroke_data(Gint ws_type, Gint stroke_num, Gstore *store, Gint *err_ind,
                          Gint *max_buf_size, Gint_list **pet_list, Glimit *echo_area,
                          Gint *buf_size, Gstroke_data **stroke_data);

/* INQUIRE DEFAULT VALUATOR DEVICE DATA */
void ginq_def_val_data(Gint ws_type, Gint val_num, Gstore *store, Gint *err_ind, Gdouble *def_value,
                       Gint_list **pet_list, Glimit *echo_area, Gdouble *low_value,
                       Gdouble *high_value, Gval_data **val_data);

/* INQUIRE DEFAULT CHOICE DEVICE DATA */
void ginq_def_choice_data(Gint ws_type, Gint choice_num, Gstore *store, Gint *err_ind,
                          Gint *max_choices, Gint_list **pet_list, Glimit *echo_area,
                          Gchoice_data **choice_data);

/* INQUIRE DEFAULT PICK DEVICE DATA */
void ginq_def_pick_data(Gint ws_type, Gint pick_num, Gstore *store, Gint *err_ind,
                        Gint_list **pet_list, Glimit *echo_area, Gpick_data **pick_data);

/* INQUIRE DEFAULT STRING DEVICE DATA */
void ginq_def_string_data(Gint ws_type, Gint string_num, Gstore *store, Gint *err_ind,
                          Gint *max_buf_size, Gint_list **pet_list, Glimit *echo_area,
                          Gint *buf_size, Gint *init_pos, Gstring_data **string_data);

/* ---- inquiry: segment state list ---- */

/* INQUIRE SET OF ASSOCIATED WORKSTATIONS */
void ginq_set_assoc_wss(Gint seg_name, Gint num_elems_appl_list, Gint start_pos, Gint *err_ind,
                        Gint_list *assoc_ws, Gint *length_list);

/* INQUIRE SEGMENT ATTRIBUTES */
void ginq_seg_attrs(Gint seg_name, Gint *err_ind, Gseg_attrs *seg_attrs);

/* ---- inquiry: pixels ---- */

/* INQUIRE PIXEL ARRAY DIMENSIONS */
void ginq_pixel_array_dims(Gint ws_id, Grect *rect, Gint *err_ind, Gint_size *dims);

/* INQUIRE PIXEL ARRAY */
void ginq_pixel_array(Gint ws_id, Gpoint *pixel_loc, Gint_size *dims, Gint num_elems_appl_list,
                      Gint start_pos, Gint *err_ind, Gpres_inval *pres_inval,
                      Gint_list *pixel_array, Gint *length_list);

/* INQUIRE PIXEL */
void ginq_pixel(Gint ws_id, const Gpoint *pixel_loc, Gint *err_ind, Gint *colr_ind);

/* ---- inquiry: error state list ---- */

/* INQUIRE INPUT QUEUE OVERFLOW */
void ginq_in_overf(Gint *err_ind, Gint *ws_id, Gin_class *in_class, Gint *in_num);

/* ---- utility ---- */

/* EVALUATE TRANSFORMATION MATRIX */
void geval_tran_matrix(const Gpoint *point, const Gvec *shift, Gdouble angle, const Gvec *scale,
                       Gcoord_switch coord_switch, Gtran_matrix tran_matrix);

/* ACCUMULATE TRANSFORMATION MATRIX */
void gaccum_tran_matrix(const Gtran_matrix matrix, const Gpoint *point, const Gvec *shift,
                        Gdouble angle, const Gvec *scale, Gcoord_switch coord_switch,
                        Gtran_matrix tran_matrix);

/* ---- error handling ---- */

/* EMERGENCY CLOSE GKS */
void gemergency_close_gks(void);

/* ERROR HANDLING */
void gerr_hand(Gint err_num, Gint func_num, const char *err_f);

/* ERROR LOGGING */
void gerr_log(Gint err_num, Gint func_num, const char *err_f);

/* ---- binding utility (not in ISO 7942) ---- */

/* CREATE STORE */
void gcreate_store(Gint *err_ind, Gstore *store);

/* DELETE STORE */
void gdel_store(Gstore store);

/* SET ERROR HANDLER */
void gset_err_hand(void (*new_err_hand)(Gint, Gint, const char *),
                   void (**old_err_hand)(Gint, Gint, const char *));

/* ---- beyond the standard ---- */

/* INQUIRE PATTERN SIZE, of NCAR */
void ginq_pat_size(Gint *err_ind, Gdouble *x_size, Gdouble *y_size);

#ifdef __cplusplus
}
#endif

#endif
