/* Bundles, patterns and colours of a workstation and of a type of workstation; stores. */
#include "check.h"

#include <string.h>

static void bundles(void)
{
    Gint error, length, numbers[100];
    Gint_list list;
    Gline_bundle line = {2, 3.5, 4}, line_got;
    Gmarker_bundle marker = {4, 0.5, 5}, marker_got;
    Gtext_bundle text = {{-4, GPREC_CHAR}, 1.25, 0.5, 6}, text_got;
    Gfill_bundle fill = {GSTYLE_HATCH, -2, 7}, fill_got;
    Gcolr_rep colour = {{0.25f, 0.5f, 1.0f}}, colour_got;

    list.ints = numbers;
    WORKS(gset_line_rep(1, 40, &line));
    ginq_line_rep(1, 40, GINQ_SET, &error, &line_got);
    CHECK(error == 0 && line_got.type == 2 && line_got.width == 3.5 && line_got.colr_ind == 4);
    ginq_list_line_inds(1, 100, 0, &error, &list, &length);
    CHECK(error == 0 && numbers[length - 1] == 40);
    WORKS(gset_marker_rep(1, 41, &marker));
    ginq_marker_rep(1, 41, GINQ_SET, &error, &marker_got);
    CHECK(error == 0 && marker_got.type == 4 && marker_got.size == 0.5 && marker_got.colr_ind == 5);
    ginq_list_marker_inds(1, 100, 0, &error, &list, &length);
    CHECK(error == 0 && numbers[length - 1] == 41);
    WORKS(gset_text_rep(1, 42, &text));
    ginq_text_rep(1, 42, GINQ_SET, &error, &text_got);
    CHECK(error == 0 && text_got.text_font_prec.font == -4 && text_got.text_font_prec.prec == GPREC_CHAR);
    CHECK(text_got.char_expan == 1.25 && text_got.char_space == 0.5 && text_got.colr_ind == 6);
    ginq_list_text_inds(1, 100, 0, &error, &list, &length);
    CHECK(error == 0 && numbers[length - 1] == 42);
    WORKS(gset_fill_rep(1, 43, &fill));
    ginq_fill_rep(1, 43, GINQ_SET, &error, &fill_got);
    CHECK(error == 0 && fill_got.int_style == GSTYLE_HATCH && fill_got.style_ind == -2 && fill_got.colr_ind == 7);
    ginq_list_fill_inds(1, 100, 0, &error, &list, &length);
    CHECK(error == 0 && numbers[length - 1] == 43);
    WORKS(gset_colr_rep(1, 44, &colour));
    ginq_colr_rep(1, 44, GINQ_SET, &error, &colour_got);
    CHECK(error == 0 && colour_got.rgb.red == 0.25f && colour_got.rgb.green == 0.5f && colour_got.rgb.blue == 1.0f);
    ginq_list_colr_inds(1, 100, 0, &error, &list, &length);
    CHECK(error == 0 && numbers[0] == 0 && length > 2);

    ginq_line_rep(1, 40, (Ginq_type) 2, &error, &line_got);
    CHECK(error == 2202);
    ginq_line_rep(1, 0, GINQ_SET, &error, &line_got);
    CHECK(error == 60);
    ginq_line_rep(9, 1, GINQ_SET, &error, &line_got);
    CHECK(error == 25);
    text.text_font_prec.prec = (Gtext_prec) 9;
    REPORTS(2202, Gfn_set_text_rep, gset_text_rep(1, 42, &text));
    fill.int_style = (Gfill_int_style) 4;
    REPORTS(2202, Gfn_set_fill_rep, gset_fill_rep(1, 43, &fill));
    colour.rgb.green = 1.5f;
    REPORTS(96, Gfn_set_colr_rep, gset_colr_rep(1, 44, &colour));
}

static void patterns(void)
{
    static Gint cells[6] = {1, 2, 3, 4, 5, 6}, other[1] = {9};
    Gint error = -1, length, numbers[100];
    Gint_list list;
    Gpat_rep pattern = {{3, 2}, cells}, one = {{1, 1}, other}, *got = NULL, *second = NULL;
    Gstore store = NULL, store2 = NULL, none = NULL;

    list.ints = numbers;
    gcreate_store(&error, &store);
    CHECK(error == 0 && store != NULL);
    gcreate_store(&error, &store2);
    CHECK(error == 0 && store2 != store);
    WORKS(gset_pat_rep(1, 50, &pattern));
    WORKS(gset_pat_rep(1, 51, &one));
    ginq_list_pat_inds(1, 100, 0, &error, &list, &length);
    CHECK(error == 0 && numbers[length - 1] == 51);
    ginq_pat_rep(1, 50, GINQ_SET, &store, &error, &got);
    CHECK(error == 0 && got != NULL && got->dims.size_x == 3 && got->dims.size_y == 2);
    CHECK(got->colr_array != cells && memcmp(got->colr_array, cells, sizeof cells) == 0);
    ginq_pat_rep(1, 51, GINQ_REALIZED, &store2, &error, &second);
    CHECK(error == 0 && second->dims.size_x == 1 && second->colr_array[0] == 9);
    /* The first result stays until its own store is used again. */
    CHECK(got->dims.size_x == 3 && got->colr_array[5] == 6);
    ginq_pred_pat_rep(100, 1, &store, &error, &got);
    CHECK(error == 0 && got != NULL && got->dims.size_x > 0 && got->colr_array != NULL);
    ginq_pat_rep(1, 52, GINQ_SET, &store, &error, &got);
    CHECK(error == 88 && got == NULL);
    ginq_pat_rep(1, 50, GINQ_SET, &none, &error, &got);
    CHECK(error == 2200 && got == NULL);
    ginq_pat_rep(1, 50, GINQ_SET, NULL, &error, &got);
    CHECK(error == 2200);
    gdel_store(store);
    ginq_pat_rep(1, 50, GINQ_SET, &store, &error, &got);
    CHECK(error == 2200 && got == NULL);
    CHECK(second->colr_array[0] == 9);
    gdel_store(store);
    gdel_store(store2);
    gdel_store(NULL);

    one.dims.size_y = 0;
    REPORTS(91, Gfn_set_pat_rep, gset_pat_rep(1, 50, &one));
    one.dims.size_x = one.dims.size_y = 2147483647;
    REPORTS(91, Gfn_set_pat_rep, gset_pat_rep(1, 50, &one));
    pattern.colr_array = NULL;
    REPORTS(91, Gfn_set_pat_rep, gset_pat_rep(1, 50, &pattern));
}

static void predefined(void)
{
    Gint error;
    Gline_bundle line;
    Gmarker_bundle marker;
    Gtext_bundle text;
    Gfill_bundle fill;
    Gcolr_rep colour;

    ginq_pred_line_rep(100, 1, &error, &line);
    CHECK(error == 0 && line.type == GLINE_SOLID && line.width == 1.0 && line.colr_ind == 1);
    ginq_pred_marker_rep(100, 1, &error, &marker);
    CHECK(error == 0 && marker.type != 0 && marker.size == 1.0);
    ginq_pred_text_rep(100, 1, &error, &text);
    CHECK(error == 0 && text.text_font_prec.font == 1 && text.char_expan == 1.0);
    ginq_pred_fill_rep(100, 1, &error, &fill);
    CHECK(error == 0 && fill.int_style == GSTYLE_HOLLOW);
    ginq_pred_colr_rep(100, 0, &error, &colour);
    CHECK(error == 0 && colour.rgb.red == 1.0f && colour.rgb.green == 1.0f && colour.rgb.blue == 1.0f);
    ginq_pred_line_rep(100, 0, &error, &line);
    CHECK(error == 60);
    ginq_pred_line_rep(31999, 1, &error, &line);
    CHECK(error == 23);
}

int main(void)
{
    open_all();
    bundles();
    patterns();
    predefined();
    close_all();
    return finish();
}
