/* cairo, called directly: one stroke or fill for each primitive, round caps and joins. */
#include "library.h"
#include <cairo-pdf.h>
#include <cairo-ps.h>
#include <cairo-svg.h>
#include <math.h>
#include <string.h>

static cairo_surface_t *surface;
static cairo_t *canvas;
static const char *png;
static double left, scale;

int open_library(const char *device, const char *file)
{
    png = strcmp(device, "png") ? NULL : file;
    if (!strncmp(device, "memory", 6) || png)
        surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, SIDE, SIDE);
    else if (!strcmp(device, "svg"))
        surface = cairo_svg_surface_create(file, SIDE, SIDE);
    else if (!strcmp(device, "pdf"))
        surface = cairo_pdf_surface_create(file, SIDE, SIDE);
    else if (!strcmp(device, "ps"))
        surface = cairo_ps_surface_create(file, SIDE, SIDE);
    else
        return 0;
    canvas = cairo_create(surface);
    cairo_set_source_rgb(canvas, 1, 1, 1);
    cairo_paint(canvas);
    cairo_set_source_rgb(canvas, 0, 0, 0);
    cairo_set_line_cap(canvas, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(canvas, CAIRO_LINE_JOIN_ROUND);
    cairo_set_fill_rule(canvas, CAIRO_FILL_RULE_EVEN_ODD);
    set_window(0, 1);
    return 1;
}

void set_window(double from, double to)
{
    left = from;
    scale = SIDE / (to - from);
}

void set_line(int dashed, double width, int antialiased)
{
    /* As linetype 2 of this library is drawn. */
    double unit = width > 2 ? width / 2 : 1, dashes[] = {12 * unit, 8 * unit};
    cairo_set_antialias(canvas, antialiased ? CAIRO_ANTIALIAS_DEFAULT : CAIRO_ANTIALIAS_NONE);
    cairo_set_line_width(canvas, width);
    cairo_set_dash(canvas, dashes, dashed ? 2 : 0, 0);
    cairo_set_source_rgb(canvas, 0, 0, 0);
}

static void path(struct points points)
{
    for (int i = 0; i < points.count; i++) {
        double x = (points.x[i] - left) * scale, y = SIDE - points.y[i] * SIDE;
        if (i == 0)
            cairo_move_to(canvas, x, y);
        else
            cairo_line_to(canvas, x, y);
    }
}

void polyline(struct points points)
{
    path(points);
    cairo_stroke(canvas);
}

void polymarker(int type, struct points points)
{
    for (int i = 0; i < points.count; i++) {
        double x = points.x[i] * SIDE, y = SIDE - points.y[i] * SIDE;
        if (type == 1) {
            cairo_rectangle(canvas, floor(x), floor(y), 1, 1);
            cairo_fill(canvas);
            continue;
        }
        if (type == 2) {
            cairo_move_to(canvas, x - 3, y);
            cairo_line_to(canvas, x + 3, y);
            cairo_move_to(canvas, x, y - 3);
            cairo_line_to(canvas, x, y + 3);
        } else {
            cairo_new_sub_path(canvas);
            cairo_arc(canvas, x, y, 3, 0, 6.283185307179586);
        }
        cairo_stroke(canvas);
    }
}

void fill_area(struct points points, int colour)
{
    int rgb[3];
    colour_of(colour, rgb);
    cairo_set_source_rgb(canvas, rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0);
    path(points);
    cairo_close_path(canvas);
    cairo_fill(canvas);
}

void cell_array(int columns, int rows, const int *colours)
{
    unsigned palette[256];
    for (int i = 0; i < 256; i++) {
        int rgb[3];
        colour_of(i, rgb);
        palette[i] = 0xff000000u | (unsigned)rgb[0] << 16 | (unsigned)rgb[1] << 8 | (unsigned)rgb[2];
    }
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows);
    unsigned char *bytes = cairo_image_surface_get_data(image);
    for (int row = 0; row < rows; row++) {
        unsigned *line = (unsigned *)(bytes + (long)row * cairo_image_surface_get_stride(image));
        for (int column = 0; column < columns; column++)
            line[column] = palette[colours[(long)row * columns + column]];
    }
    cairo_surface_mark_dirty(image);
    cairo_save(canvas);
    cairo_scale(canvas, (double)SIDE / columns, (double)SIDE / rows);
    cairo_set_source_surface(canvas, image, 0, 0);
    cairo_pattern_set_filter(cairo_get_source(canvas), CAIRO_FILTER_NEAREST);
    cairo_paint(canvas);
    cairo_restore(canvas);
    cairo_surface_destroy(image);
}

void text(double x, double y, const char *string)
{
    (void)x, (void)y, (void)string;
}

int has_stroke_fonts(void)
{
    return 0;
}

void finish_drawing(void)
{
    cairo_surface_flush(surface);
}

void close_library(void)
{
    if (png)
        cairo_surface_write_to_png(surface, png);
    cairo_show_page(canvas);
    cairo_destroy(canvas);
    cairo_surface_destroy(surface);
}
