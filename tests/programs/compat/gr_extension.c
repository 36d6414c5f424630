/* Images with opacity, nominal sizes and slanted text of GR. */
#include <gks.h>

#include <math.h>

int main(void)
{
    int first[] = {(int)0xff0000ff, (int)0x80ff0000}, second = (int)0xff00ff00, error;
    double x[] = {0.1, 0.9}, y[] = {0.5, 0.5}, part, next_x, next_y, corners_x[4], corners_y[4];

    gks_open_gks(0);
    gks_set_nominal_size(10.0);
    gks_open_ws(1, "gr_extension.png", 140);
    gks_activate_ws(1);
    gks_draw_image(0.1, 0.1, 0.1, 0.1, 2, 1, first);
    gks_draw_image(0.1, 0.3, 0.1, 0.1, 1, 1, &second);
    gks_set_transparency(0.5);
    gks_draw_image(0.5, 0.1, 0.1, 0.1, 1, 1, first);
    gks_set_transparency(1.0);
    /* No colour index of the program has changed. */
    gks_inq_color_rep(1, 4096, 0, &error, &part, &part, &part);
    if (error == 0)
        return 1;
    gks_polyline(2, x, y);
    gks_set_nominal_size(0.0);
    y[0] = y[1] = 0.6;
    gks_polyline(2, x, y);

    gks_set_text_fontprec(1, 2);
    gks_set_text_height(0.2);
    gks_inq_text_extent(1, 0.5, 0.7, "I", &error, &next_x, &next_y, corners_x, corners_y);
    if (error != 0 || fabs(corners_x[3] - corners_x[0]) > 1e-9)
        return 2;
    gks_set_text_slant(45.0);
    gks_inq_text_extent(1, 0.5, 0.7, "I", &error, &next_x, &next_y, corners_x, corners_y);
    if (error != 0 || fabs(corners_x[3] - corners_x[0] - (corners_y[3] - corners_y[0])) > 1e-9 || corners_y[3] < 0.83)
        return 3;
    gks_text(0.5, 0.7, "I");
    gks_inq_text_upvec(&error, &next_x, &next_y);
    gks_inq_text_height(&error, &part);
    if (next_x != 0.0 || next_y != 1.0 || part != 0.2)
        return 4;
    gks_deactivate_ws(1);
    gks_close_ws(1);
    gks_close_gks();
    return 0;
}
