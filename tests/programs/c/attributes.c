/* Attributes are inquired as they are set, one by one and together. */
#include "check.h"

#include <string.h>

#define SETS(type, set, inquire, value, other) \
    do { \
        type got = (other); \
        Gint error = -1; \
        WORKS(set(value)); \
        inquire(&error, &got); \
        CHECK(error == 0 && got == (value)); \
    } while (0)

static void numbers(void)
{
    SETS(Gint, gset_line_ind, ginq_line_ind, 3, 0);
    SETS(Gint, gset_linetype, ginq_linetype, 4, 0);
    SETS(Gdouble, gset_linewidth, ginq_linewidth, 2.5, 0.0);
    SETS(Gint, gset_line_colr_ind, ginq_line_colr_ind, 5, 0);
    SETS(Gint, gset_marker_ind, ginq_marker_ind, 2, 0);
    SETS(Gint, gset_marker_type, ginq_marker_type, 5, 0);
    SETS(Gdouble, gset_marker_size, ginq_marker_size, 0.75, 0.0);
    SETS(Gint, gset_marker_colr_ind, ginq_marker_colr_ind, 6, 0);
    SETS(Gint, gset_text_ind, ginq_text_ind, 4, 0);
    SETS(Gdouble, gset_char_expan, ginq_char_expan, 1.5, 0.0);
    SETS(Gdouble, gset_char_space, ginq_char_space, -0.25, 0.0);
    SETS(Gint, gset_text_colr_ind, ginq_text_colr_ind, 7, 0);
    SETS(Gdouble, gset_char_ht, ginq_char_ht, 0.125, 0.0);
    SETS(Gtext_path, gset_text_path, ginq_text_path, GPATH_UP, GPATH_LEFT);
    SETS(Gint, gset_fill_ind, ginq_fill_ind, 5, 0);
    SETS(Gfill_int_style, gset_fill_int_style, ginq_fill_int_style, GSTYLE_PAT, GSTYLE_HOLLOW);
    SETS(Gint, gset_fill_style_ind, ginq_fill_style_ind, -3, 0);
    SETS(Gint, gset_fill_colr_ind, ginq_fill_colr_ind, 8, 0);
}

static void structures(void)
{
    Gint error;
    Gtext_font_prec font = {-4, GPREC_STROKE}, font_got;
    Gtext_align align = {GHOR_CTR, GVERT_CAP}, align_got;
    Gvec up = {-2.0f, 0.0f}, vector;
    Gpoint reference = {0.25f, -0.5f}, point;
    Gdouble width, height;
    Gasfs flags, flags_got;
    Gasf *flag = &flags.linetype;
    int i;

    WORKS(gset_text_font_prec(&font));
    ginq_text_font_prec(&error, &font_got);
    CHECK(error == 0 && font_got.font == -4 && font_got.prec == GPREC_STROKE);
    WORKS(gset_text_align(&align));
    ginq_text_align(&error, &align_got);
    CHECK(error == 0 && align_got.hor == GHOR_CTR && align_got.vert == GVERT_CAP);
    WORKS(gset_char_up_vec(&up));
    ginq_char_up_vec(&error, &vector);
    CHECK(error == 0 && vector.delta_x < 0.0f && vector.delta_y == 0.0f);
    ginq_char_base_vec(&error, &vector);
    CHECK(error == 0 && vector.delta_x == 0.0f && vector.delta_y > 0.0f);
    WORKS(gset_pat_size(0.5, 0.25));
    ginq_pat_width_vec(&error, &vector);
    CHECK(error == 0 && vector.delta_x == 0.5f && vector.delta_y == 0.0f);
    ginq_pat_ht_vec(&error, &vector);
    CHECK(error == 0 && vector.delta_x == 0.0f && vector.delta_y == 0.25f);
    ginq_pat_size(&error, &width, &height);
    CHECK(error == 0 && width == 0.5 && height == 0.25);
    WORKS(gset_pat_ref_point(&reference));
    ginq_pat_ref_point(&error, &point);
    CHECK(error == 0 && point.x == 0.25f && point.y == -0.5f);
    /* The flags are 13 in a row. */
    for (i = 0; i < 13; i++)
        flag[i] = i % 3 == 0 ? GASF_BUNDLED : GASF_INDIV;
    WORKS(gset_asfs(&flags));
    memset(&flags_got, -1, sizeof flags_got);
    ginq_asfs(&error, &flags_got);
    CHECK(error == 0 && memcmp(&flags, &flags_got, sizeof flags) == 0);
    CHECK(flags.marker_type == GASF_BUNDLED && flags.fill_colr_ind == GASF_BUNDLED);
}

static void together(void)
{
    Gint error;
    Gprim_attrs prim;
    Gindiv_attrs indiv;

    ginq_cur_prim_attrs(&error, &prim);
    CHECK(error == 0 && prim.line_ind == 3 && prim.marker_ind == 2 && prim.text_ind == 4 && prim.fill_ind == 5);
    CHECK(prim.char_ht == 0.125 && prim.char_width == 0.125 && prim.char_up_vec.delta_x < 0.0f);
    CHECK(prim.char_base_vec.delta_y > 0.0f && prim.text_path == GPATH_UP);
    CHECK(prim.text_align.hor == GHOR_CTR && prim.text_align.vert == GVERT_CAP);
    CHECK(prim.pat_width_vec.delta_x == 0.5f && prim.pat_ht_vec.delta_y == 0.25f);
    CHECK(prim.pat_ref_point.x == 0.25f && prim.pat_ref_point.y == -0.5f);
    ginq_cur_indiv_attrs(&error, &indiv);
    CHECK(error == 0 && indiv.linetype == 4 && indiv.linewidth == 2.5 && indiv.line_colr_ind == 5);
    CHECK(indiv.marker_type == 5 && indiv.marker_size == 0.75 && indiv.marker_colr_ind == 6);
    CHECK(indiv.text_font_prec.font == -4 && indiv.text_font_prec.prec == GPREC_STROKE);
    CHECK(indiv.char_expan == 1.5 && indiv.char_space == -0.25 && indiv.text_colr_ind == 7);
    CHECK(indiv.fill_int_style == GSTYLE_PAT && indiv.fill_style_ind == -3 && indiv.fill_colr_ind == 8);
    CHECK(indiv.asfs.linetype == GASF_BUNDLED && indiv.asfs.linewidth == GASF_INDIV);
}

static void wrong(void)
{
    Gtext_font_prec font = {1, (Gtext_prec) 3};
    Gtext_align align = {(Ghor_text_align) 4, GVERT_CAP};
    Gvec none = {0.0f, 0.0f};
    Gasfs flags;

    REPORTS(2202, Gfn_set_text_font_prec, gset_text_font_prec(&font));
    REPORTS(2202, Gfn_set_text_align, gset_text_align(&align));
    align.hor = GHOR_CTR;
    align.vert = (Gvert_text_align) 6;
    REPORTS(2202, Gfn_set_text_align, gset_text_align(&align));
    REPORTS(2202, Gfn_set_text_path, gset_text_path((Gtext_path) 4));
    REPORTS(2202, Gfn_set_fill_int_style, gset_fill_int_style((Gfill_int_style) 4));
    memset(&flags, 0, sizeof flags);
    flags.text_colr_ind = (Gasf) 2;
    REPORTS(2202, Gfn_set_asfs, gset_asfs(&flags));
    REPORTS(63, Gfn_set_linetype, gset_linetype(0));
    REPORTS(65, Gfn_set_linewidth, gset_linewidth(-1.0));
    REPORTS(92, Gfn_set_fill_colr_ind, gset_fill_colr_ind(-1));
    REPORTS(79, Gfn_set_char_up_vec, gset_char_up_vec(&none));
    /* Where a value is needed, a null pointer is an error and nothing worse. */
    REPORTS(2200, Gfn_set_char_up_vec, gset_char_up_vec(NULL));
    REPORTS(2200, Gfn_set_asfs, gset_asfs(NULL));
}

int main(void)
{
    Gint error = 0, number = 77;

    gset_err_hand(remember, NULL);
    REPORTS(8, Gfn_set_linetype, gset_linetype(1));
    REPORTS(8, Gfn_set_text_path, gset_text_path((Gtext_path) 4));
    ginq_linetype(&error, &number);
    CHECK(error == 8 && number == 77);
    WORKS(gopen_gks("errors", GDEF_MEM_SIZE));
    numbers();
    structures();
    together();
    wrong();
    /* What was refused has changed nothing. */
    together();
    ginq_linetype(&error, NULL);
    ginq_linetype(NULL, &number);
    CHECK(error == 0 && number == 4);
    WORKS(gclose_gks());
    return finish();
}
