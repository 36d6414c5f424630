/* A figure drawn with the names of ISO 8651-4. The same is in xgks.c and gr.c. */
#include <gks.h>

static Gpoint line[] = {{0.125f, 0.125f}, {0.875f, 0.25f}, {0.5f, 0.875f}};
static Gpoint area[] = {{0.25f, 0.25f}, {0.5f, 0.25f}, {0.5f, 0.5f}, {0.25f, 0.5f}};
static Gpoint marks[] = {{0.75f, 0.75f}, {0.625f, 0.625f}};

int main(void)
{
    Gpoint_list polyline = {3, line}, fill_area = {4, area}, polymarker = {2, marks};
    Glimit window = {0.0f, 2.0f, 0.0f, 1.0f}, viewport = {0.0f, 1.0f, 0.25f, 0.75f};
    Gcolr_rep colour;
    Gpoint at = {1.0f, 0.5f};
    Gtext_align align = {GHOR_CTR, GVERT_HALF};
    Gtext_font_prec font = {-4, GPREC_STROKE};

    gopen_gks(0, 0);
    gopen_ws(1, "iso.png", 100);
    gactivate_ws(1);
    colour.rgb.red = 0.5f;
    colour.rgb.green = 0.25f;
    colour.rgb.blue = 0.75f;
    gset_colr_rep(1, 9, &colour);
    gset_win(1, &window);
    gset_vp(1, &viewport);
    gsel_norm_tran(1);
    gset_fill_int_style(GSTYLE_SOLID);
    gset_fill_colr_ind(9);
    gfill_area(&fill_area);
    gset_linewidth(4.0);
    gset_linetype(2);
    gpolyline(&polyline);
    gset_marker_type(4);
    gset_marker_size(2.0);
    gpolymarker(&polymarker);
    gset_char_ht(0.125);
    gset_text_align(&align);
    gset_text_font_prec(&font);
    gtext(&at, "Figure");
    gdeactivate_ws(1);
    gclose_ws(1);
    gclose_gks();
    return 0;
}
