/* What GR has beyond the figure of iso.c: its colours, its primitives, segments, requests and errors. */
#include <gks.h>

#include <math.h>

static double box_x[] = {0.5, 0.75, 0.75, 0.5}, box_y[] = {0.5, 0.5, 0.75, 0.75};
static double peak_x[] = {0.75, 0.8125, 0.875}, peak_y[] = {0.125, 0.1875, 0.125};

/* A square with a hole, filled and with an edge: codes, and points of which most are relative. */
static const char codes[] = "MlllZMlllF";
static double hole_x[] = {0.125, 0.25, 0.0, -0.25, 0.1875, 0.125, 0.0, -0.125};
static double hole_y[] = {0.125, 0.0, 0.25, 0.0, 0.1875, 0.0, 0.125, 0.0};

int main(void)
{
    double red, green, blue, tran[3][2], result[2][3];
    int widths[] = {4000, 0x0000ff, 1000, 0x00ff00, 1000, 0xff0000};
    int triangle[] = {1, 2, 3, 0x808000}, polygon[] = {4, 1, 2, 3, 4, 0xff8000};
    int error, number, name, status, steps[16], i, count = sizeof codes - 1;
    Gpoint fixed = {0.5, 0.5}, shift = {0.25, 0.0};
    Gscale scale = {1.0, 1.0};

    gks_open_gks(0);
    gks_open_ws(1, "gr_more.png", 140);
    gks_activate_ws(1);
    gks_inq_color_rep(1, 980, 1, &error, &red, &green, &blue);
    if (error != 0 || red != 1.0 || fabs(green - 0.702) > 1e-3 || blue != 0.0)
        return 1;
    gks_set_fill_color_index(980);
    gks_set_border_color_index(4);
    gks_set_border_width(4.0);
    for (i = 0; i < count; i++)
        steps[i] = codes[i];
    gks_gdp(8, hole_x, hole_y, GKS_K_GDP_DRAW_PATH, count, steps);
    gks_gdp(4, box_x, box_y, GKS_K_GDP_FILL_POLYGONS, 6, polygon);
    gks_gdp(4, box_x, box_y, GKS_K_GDP_DRAW_LINES, 6, widths);
    gks_gdp(4, box_x, box_y, GKS_K_GDP_DRAW_TRIANGLES, 4, triangle);
    gks_set_pmark_type(3);
    gks_gdp(3, peak_x, peak_y, GKS_K_GDP_DRAW_MARKERS, 6, widths);
    gks_inq_fill_color_index(&error, &number);
    if (number != 980)
        return 2;
    gks_create_seg(3);
    gks_polyline(3, peak_x, peak_y);
    gks_close_seg();
    gks_inq_segn_ws(1, 1, &error, &number, &name);
    if (error != 0 || number != 1 || name != 3)
        return 3;
    gks_eval_xform_matrix(0.5, 0.5, 0.25, 0.0, 0.0, 1.0, 1.0, 1, tran);
    gevaltran(&fixed, &shift, 0.0, &scale, GNDC, result);
    if (tran[2][0] != 0.25 || tran[0][0] != 1.0 || result[0][2] != 0.25 || result[1][1] != 1.0)
        return 4;
    /* Nobody operates a picture. */
    gks_request_choice(1, 1, &status, &number);
    if (gks_errno != 38 || status != 0)
        return 5;
    gks_set_pline_linetype(0);
    if (gks_errno != 63)
        return 6;
    gks_deactivate_ws(1);
    gks_close_ws(1);
    gks_close_gks();
    return 0;
}
