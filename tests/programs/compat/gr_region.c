/* What clips in GR: an ellipse, a sector of it, the viewport of another transformation; and images with smooth colours. */
#include <gks.h>

#include <string.h>

static void select_viewport(int number, double x, double y)
{
    gks_set_window(number, 0.0, 1.0, 0.0, 1.0);
    gks_set_viewport(number, x, x + 0.4, y, y + 0.4);
    gks_select_xform(number);
}

int main(void)
{
    double x[] = {-1.0, 2.0, 2.0, -1.0}, y[] = {-1.0, -1.0, 2.0, 2.0}, across[] = {0.5, 0.5}, higher[] = {0.75, 0.75};
    double markers[] = {0.02, 0.5}, start, end;
    int image[4], error, region, number, i;

    gks_open_gks(0);
    gks_open_ws(1, "gr_region.png", 140);
    gks_activate_ws(1);
    gks_set_fill_int_style(1);

    /* An ellipse: an area, a line across it that is dashed, markers of which one is outside, text. */
    gks_set_clip_region(1);
    select_viewport(1, 0.05, 0.55);
    gks_set_fill_color_index(5);
    gks_fillarea(4, x, y);
    gks_set_pline_linewidth(10.0);
    gks_set_pline_linetype(2);
    gks_polyline(2, x, across);
    gks_set_pline_linetype(1);
    gks_set_pmark_size(6.0);
    gks_polymarker(2, markers, markers);
    gks_set_text_fontprec(1, 2);
    gks_set_text_height(0.3);
    gks_set_text_align(2, 3);
    gks_text(0.5, 0.8, "MMMMM");

    /* Three quarters of one. */
    gks_set_clip_sector(90.0, 360.0);
    select_viewport(2, 0.55, 0.55);
    gks_set_fill_color_index(3);
    gks_fillarea(4, x, y);
    gks_polyline(2, x, higher);
    gks_inq_clip_sector(&error, &start, &end);
    gks_inq_clip_region(&error, &region);
    if (start != 90.0 || end != 360.0 || region != 1)
        return 1;

    /* The rectangle of another transformation, in spite of the indicator. */
    gks_set_clip_region(0);
    select_viewport(3, 0.05, 0.05);
    gks_select_xform(0);
    gks_set_clipping(0);
    gks_select_clip_xform(3);
    gks_inq_clip_xform(&error, &number);
    if (number != 3)
        return 2;
    gks_set_fill_color_index(4);
    gks_fillarea(4, x, y);
    gks_select_clip_xform(0);
    gks_set_clipping(1);

    /* Red and blue that pass into each other, in the whole ellipse. */
    gks_set_clip_sector(0.0, 360.0);
    gks_set_clip_region(1);
    select_viewport(4, 0.55, 0.05);
    gks_set_resample_method(0x02020202);
    for (i = 0; i < 4; i++)
        image[i] = i % 2 ? (int)0xffff0000 : (int)0xff0000ff;
    gks_draw_image(0.0, 0.0, 0.5, 0.5, 2, 2, image);

    gks_deactivate_ws(1);
    gks_close_ws(1);
    gks_close_gks();
    return 0;
}
