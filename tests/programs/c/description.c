/* What types of workstations are able to do. */
#include "check.h"

static void facilities(void)
{
    Gint error, length, whole, numbers[100];
    Gtext_font_prec pairs[200];
    Gline_facs lines;
    Gmarker_facs markers;
    Gtext_facs texts;
    Gfill_facs fills;
    Gcolr_facs colours;

    lines.types.ints = markers.types.ints = fills.hatch_styles.ints = numbers;
    texts.font_precs = pairs;
    ginq_line_facs(100, 100, 0, &error, &lines, &whole);
    CHECK(error == 0 && lines.types.ints == numbers && lines.types.num_ints == whole && whole >= 4);
    CHECK(numbers[0] == GLINE_SOLID && lines.num_pred_inds >= 5 && lines.num_widths == 0);
    CHECK(lines.min_width > 0.0 && lines.min_width <= lines.nom_width && lines.nom_width <= lines.max_width);
    ginq_line_facs(100, 1, 1, &error, &lines, &length);
    CHECK(error == 0 && length == whole && lines.types.num_ints == 1 && numbers[0] == GLINE_DASH);
    ginq_line_facs(100, 1, whole, &error, &lines, &length);
    CHECK(error == 2201 && lines.types.num_ints == 0 && lines.types.ints == numbers);
    ginq_marker_facs(100, 100, 0, &error, &markers, &length);
    CHECK(error == 0 && length >= 5 && numbers[2] == GMARKER_ASTERISK);
    CHECK(markers.min_size > 0.0 && markers.min_size <= markers.nom_size && markers.nom_size <= markers.max_size);
    ginq_text_facs(100, 200, 0, &error, &texts, &length);
    CHECK(error == 0 && texts.num_font_precs == length && texts.font_precs == pairs && length >= 6);
    CHECK(pairs[0].font == 1 && pairs[0].prec == GPREC_STRING && pairs[2].prec == GPREC_STROKE);
    CHECK(texts.max_char_ht > texts.min_char_ht && texts.num_pred_inds >= 2);
    texts.font_precs = NULL;
    ginq_text_facs(100, 0, 0, &error, &texts, &length);
    CHECK(error == 0 && texts.num_font_precs == 0 && length >= 6);
    ginq_fill_facs(100, 100, 0, &error, &fills, &length);
    CHECK(error == 0 && fills.num_int_styles == 4 && fills.int_style[3] == GSTYLE_HATCH && length >= 3);
    CHECK(fills.hatch_styles.num_ints == length && numbers[0] < 0);
    ginq_pat_facs(100, &error, &length);
    CHECK(error == 0 && length >= 1);
    ginq_colr_facs(100, &error, &colours);
    CHECK(error == 0 && colours.colr_avail == GAVAIL_COLR && colours.num_pred_inds >= 2);
}

static void surface(void)
{
    Gint error;
    Gdisp_space_size size;
    Gws_class class_of;
    Gws_cat category;
    Gdyn_mod_ws_attrs dynamic;
    Gdefer_mode defer;
    Girg_mode irg;
    Gmax_ws_st_tables tables;
    Gws_max_nums most;
    Glevel level;

    ginq_disp_space_size(100, &error, &size);
    CHECK(error == 0 && size.dc_units == GDC_METRES && near(size.size_dc.size_x, 0.2));
    CHECK(size.size_raster.size_x == 1000 && size.size_raster.size_y == 1000);
    ginq_ws_class(100, &error, &class_of);
    CHECK(error == 0 && class_of == GCLASS_RASTER);
    ginq_ws_cat(100, &error, &category);
    CHECK(error == 0 && category == GCAT_OUT);
    ginq_dyn_mod_ws_attrs(100, &error, &dynamic);
    CHECK(error == 0 && dynamic.ws_tran == GDYN_IRG && dynamic.line_bundle <= GDYN_IMM);
    ginq_def_defer_sts(100, &error, &defer, &irg);
    CHECK(error == 0 && defer <= GDEFER_ASTI && irg <= GIRG_ALLOWED);
    ginq_max_ws_st_tables(100, &error, &tables);
    CHECK(error == 0 && tables.line_bundles == 1024 && tables.pat_reps == 1024 && tables.colr_reps == 65536);
    ginq_ws_max_nums(&error, &most);
    CHECK(error == 0 && most.simult_open == 32 && most.simult_active == 32 && most.assoc_seg == 32);
    ginq_level_gks(&error, &level);
    CHECK(error == 0 && level == GLEVEL_2C);
    ginq_ws_cat(-5, &error, &category);
    CHECK(error == 22);
    ginq_ws_class(31999, &error, &class_of);
    CHECK(error == 23);
}

static void primitives(void)
{
    Gint error, length, count, numbers[50];
    Gint_list list;
    Gattrs attributes[4];

    list.ints = numbers;
    ginq_list_avail_gdps(100, 50, 0, &error, &list, &length);
    CHECK(error == 0 && length == list.num_ints && length >= 4 && numbers[0] == -1);
    ginq_gdp(100, -1, &error, &count, attributes);
    CHECK(error == 0 && count == 1 && attributes[0] == GATTR_LINE);
    ginq_gdp(100, -4, &error, &count, attributes);
    CHECK(error == 0 && count == 1 && attributes[0] == GATTR_FILL);
    ginq_gdp(100, -999, &error, &count, attributes);
    CHECK(error == 41);
}

int main(void)
{
    gset_err_hand(remember, NULL);
    WORKS(gopen_gks("errors", GDEF_MEM_SIZE));
    facilities();
    surface();
    primitives();
    WORKS(gclose_gks());
    return finish();
}
