/* The figure of iso.c with the names of GR. */
#include <gks.h>

static double line_x[] = {0.125, 0.875, 0.5}, line_y[] = {0.125, 0.25, 0.875};
static double area_x[] = {0.25, 0.5, 0.5, 0.25}, area_y[] = {0.25, 0.25, 0.5, 0.5};
static double marks_x[] = {0.75, 0.625}, marks_y[] = {0.75, 0.625};

int main(void)
{
    int error, number;
    double alpha;

    gks_open_gks(0);
    gks_open_ws(1, "gr.png", 140);
    gks_activate_ws(1);
    gks_set_color_rep(1, 9, 0.5, 0.25, 0.75);
    gks_set_window(1, 0.0, 2.0, 0.0, 1.0);
    gks_set_viewport(1, 0.0, 1.0, 0.25, 0.75);
    gks_select_xform(1);
    gks_set_fill_int_style(1);
    gks_set_fill_color_index(9);
    gks_fillarea(4, area_x, area_y);
    gks_set_pline_linewidth(4.0);
    gks_set_pline_linetype(2);
    gks_polyline(3, line_x, line_y);
    gks_set_pmark_type(4);
    gks_set_pmark_size(2.0);
    gks_polymarker(2, marks_x, marks_y);
    gks_set_text_height(0.125);
    gks_set_text_align(2, 3);
    gks_set_text_fontprec(-4, 2);
    gks_text(1.0, 0.5, "Figure");
    gks_inq_pline_linetype(&error, &number);
    if (error != 0 || number != 2)
        return 1;
    gks_set_transparency(0.5);
    gks_inq_transparency(&error, &alpha);
    if (error != 0 || alpha != 0.5)
        return 2;
    gks_deactivate_ws(1);
    gks_close_ws(1);
    gks_close_gks();
    return 0;
}
