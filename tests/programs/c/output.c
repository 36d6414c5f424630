/* Output primitives, by the pixels that they leave. */
#include "check.h"

#include <gks_extra.h>
#include <string.h>

static unsigned char pixels[100 * 100 * 4];

/* The colour, red * 65536 + green * 256 + blue, of the pixel that contains a point of the unit square. */
static long shown(double x, double y)
{
    Gint error;
    const unsigned char *at = pixels + 4 * (100 * (long) (100.0 * (1.0 - y)) + (long) (100.0 * x));

    gks_frame_buffer(1, pixels, sizeof pixels, &error, NULL);
    CHECK(error == 0 && at[3] == 255);
    return at[0] * 65536L + at[1] * 256L + at[2];
}

enum { WHITE = 0xffffff, BLACK = 0x000000, RED = 0xff0000, GREEN = 0x00ff00, BLUE = 0x0000ff };

/* The number of black pixels in a rectangle. */
static int black(double x_min, double x_max, double y_min, double y_max)
{
    int count = 0;
    double x, y;

    for (x = x_min + 0.005; x < x_max; x += 0.01)
        for (y = y_min + 0.005; y < y_max; y += 0.01)
            count += shown(x, y) == BLACK;
    return count;
}

static void colours(void)
{
    static const Gcolr_rep rgb[3] = {{{1.0f, 0.0f, 0.0f}}, {{0.0f, 1.0f, 0.0f}}, {{0.0f, 0.0f, 1.0f}}};
    Gint i;

    for (i = 0; i < 3; i++)
        WORKS(gset_colr_rep(1, i + 2, &rgb[i]));
}

static void primitives(void)
{
    Gpoint square[4] = {{0.1f, 0.1f}, {0.4f, 0.1f}, {0.4f, 0.4f}, {0.1f, 0.4f}};
    Gpoint across[2] = {{0.0f, 0.705f}, {1.0f, 0.705f}}, centre[1] = {{0.705f, 0.205f}};
    Gpoint circle[2] = {{0.75f, 0.5f}, {0.7f, 0.5f}};
    Gpoint_list list = {4, square};

    WORKS(gset_fill_int_style(GSTYLE_SOLID));
    WORKS(gset_fill_colr_ind(2));
    WORKS(gfill_area(&list));
    CHECK(shown(0.25, 0.25) == RED && shown(0.45, 0.25) == WHITE && shown(0.25, 0.45) == WHITE);
    list.num_points = 2;
    list.points = across;
    WORKS(gset_line_colr_ind(3));
    WORKS(gset_linewidth(30.0));
    WORKS(gpolyline(&list));
    CHECK(shown(0.5, 0.705) == GREEN && shown(0.5, 0.75) == WHITE);
    list.num_points = 1;
    list.points = centre;
    WORKS(gset_marker_type(GMARKER_PLUS));
    WORKS(gset_marker_size(30.0));
    WORKS(gset_marker_colr_ind(4));
    WORKS(gpolymarker(&list));
    CHECK(shown(0.705, 0.205) != WHITE && shown(0.705, 0.35) == WHITE);
    list.num_points = 2;
    list.points = circle;
    WORKS(ggdp(&list, -4, NULL));
    CHECK(shown(0.7, 0.5) == RED && shown(0.7, 0.54) == RED && shown(0.745, 0.545) == WHITE);

    REPORTS(100, Gfn_fill_area, gfill_area(&list));
    list.num_points = -1;
    REPORTS(100, Gfn_polymarker, gpolymarker(&list));
    list.num_points = 5;
    list.points = NULL;
    REPORTS(100, Gfn_polyline, gpolyline(&list));
    REPORTS(100, Gfn_polyline, gpolyline(NULL));
    REPORTS(104, Gfn_gdp, ggdp(&(Gpoint_list){2, circle}, -999, NULL));
}

/* Row by row from the corner p: here the upper left. */
static void cells(void)
{
    Gint indices[6] = {2, 3, 4, 4, 2, 3};
    Grect rect = {{0.1f, 0.9f}, {0.7f, 0.7f}};
    Gpat_rep array = {{3, 2}, indices};

    WORKS(gcell_array(&rect, &array));
    CHECK(shown(0.2, 0.85) == RED && shown(0.4, 0.85) == GREEN && shown(0.6, 0.85) == BLUE);
    CHECK(shown(0.2, 0.75) == BLUE && shown(0.4, 0.75) == RED && shown(0.6, 0.75) == GREEN);
    array.dims.size_y = -2;
    REPORTS(91, Gfn_cell_array, gcell_array(&rect, &array));
    REPORTS(2200, Gfn_cell_array, gcell_array(NULL, &array));
}

static void texts(void)
{
    Gint error;
    Gpoint at = {0.2f, 0.2f};
    Gtext_font_prec font = {-4, GPREC_STROKE};
    Gtext_extent utf8, latin1, two;

    WORKS(gset_text_font_prec(&font));
    WORKS(gset_char_ht(0.1));
    WORKS(gtext(&at, "Text"));
    WORKS(gtext(&at, NULL));
    CHECK(black(0.2, 0.6, 0.2, 0.31) > 50 && black(0.2, 0.6, 0.32, 0.42) == 0);
    REPORTS(2200, Gfn_text, gtext(NULL, "Text"));
    /* One character in either encoding, where bytes would be two. */
    ginq_text_extent(1, &at, "\303\251", &error, &utf8);
    CHECK(error == 0);
    ginq_text_extent(1, &at, "\351", &error, &latin1);
    CHECK(error == 0 && near(utf8.concat_point.x, latin1.concat_point.x));
    ginq_text_extent(1, &at, "\303\251\303\251", &error, &two);
    CHECK(near(two.concat_point.x - at.x, 2.0 * (utf8.concat_point.x - at.x)));
    CHECK(near(utf8.paral[0].x, at.x) && utf8.paral[2].x > at.x && utf8.paral[2].y > at.y + 0.099f);
    ginq_text_extent(2, &at, "A", &error, &two);
    CHECK(error == 25);
}

static void pixel_inquiries(void)
{
    Gint error, index = -9, length, numbers[4];
    Gint_list list;
    Gint_size dims = {-1, -1};
    Gpres_inval invalid;
    Gpoint corner = {0.105f, 0.395f};
    Grect rect = {{0.105f, 0.105f}, {0.125f, 0.115f}};

    list.ints = numbers;
    ginq_pixel(1, &corner, &error, &index);
    CHECK(error == 0 && index == 2);
    ginq_pixel_array_dims(1, &rect, &error, &dims);
    CHECK(error == 0 && dims.size_x == 3 && dims.size_y == 2);
    ginq_pixel_array(1, &corner, &dims, 4, 0, &error, &invalid, &list, &length);
    CHECK(error == 0 && length == 6 && list.num_ints == 4 && numbers[0] == 2 && numbers[3] == 2);
    CHECK(invalid == GINVAL_ABSENT);
    dims.size_x = 0;
    ginq_pixel_array(1, &corner, &dims, 4, 0, &error, &invalid, &list, &length);
    CHECK(error == 91 && list.num_ints == 0);
    ginq_pixel(2, &corner, &error, &index);
    CHECK(error == 25);

    gks_frame_buffer(1, NULL, 0, &error, &dims);
    CHECK(error == 0 && dims.size_x == 100 && dims.size_y == 100);
    memset(pixels, 7, sizeof pixels);
    gks_frame_buffer(1, pixels, sizeof pixels - 1, &error, &dims);
    CHECK(error == 2200 && pixels[0] == 7);
    gks_frame_buffer(2, pixels, sizeof pixels, &error, &dims);
    CHECK(error == 25);
}

static void escapes(void)
{
    Gint error;
    Gescape_in_data in;
    Gescape_out_data *out = NULL;
    Gstore store;

    gcreate_store(&error, &store);
    in.escape_u3004.ws_id = in.escape_u3005.ws_id = 1;
    in.escape_u3004.antialiasing = 0;
    WORKS(gescape(-3004, &in, &store, &out));
    CHECK(out == NULL);
    WORKS(gescape(-3005, &in, &store, &out));
    CHECK(out != NULL && out->escape_u3005.antialiasing == 0);
    in.escape_u3004.antialiasing = 1;
    WORKS(gescape(-3004, &in, NULL, NULL));
    WORKS(gescape(-3005, &in, &store, &out));
    CHECK(out != NULL && out->escape_u3005.antialiasing == 1);
    REPORTS(2200, Gfn_escape, gescape(-3005, &in, NULL, &out));
    gdel_store(store);
    in.escape_u3003.ws_id = 1;
    in.escape_u3003.colr_ind = 2;
    in.escape_u3003.alpha = 0.5f;
    WORKS(gescape(-3003, &in, NULL, NULL));
    in.escape_u3003.alpha = 1.5f;
    REPORTS(182, Gfn_escape, gescape(-3003, &in, NULL, NULL));
    REPORTS(2200, Gfn_escape, gescape(-3003, NULL, NULL, NULL));
    REPORTS(180, Gfn_escape, gescape(1234, NULL, NULL, &out));
    REPORTS(181, Gfn_escape, gescape(0, NULL, NULL, &out));
}

int main(void)
{
    Gescape_in_data off = {{0, NULL}};

    open_all();
    off.escape_u3004.ws_id = 1;
    off.escape_u3004.antialiasing = 0;
    WORKS(gescape(-3004, &off, NULL, NULL));
    colours();
    /* Before anything is drawn the surface shows the background. */
    CHECK(shown(0.5, 0.5) == WHITE);
    primitives();
    pixel_inquiries();
    cells();
    texts();
    escapes();
    close_all();
    return finish();
}
