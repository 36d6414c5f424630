/* The functions of GR's GKS, in double precision. They are declared here, since only the library is named. */
#include "library.h"
#include <stdio.h>
#include <string.h>

void gks_open_gks(int), gks_close_gks(void), gks_open_ws(int, char *, int), gks_close_ws(int), gks_activate_ws(int),
    gks_deactivate_ws(int), gks_update_ws(int, int), gks_set_ws_viewport(int, double, double, double, double),
    gks_set_window(int, double, double, double, double), gks_select_xform(int), gks_set_asf(int *),
    gks_set_color_rep(int, int, double, double, double), gks_set_pline_linetype(int), gks_set_pline_linewidth(double),
    gks_set_pmark_type(int), gks_set_pmark_size(double), gks_set_fill_int_style(int), gks_set_fill_color_index(int),
    gks_set_text_fontprec(int, int), gks_set_text_height(double), gks_set_border_width(double),
    gks_polyline(int, const double *, const double *), gks_polymarker(int, const double *, const double *),
    gks_fillarea(int, const double *, const double *), gks_text(double, double, const char *),
    gks_cellarray(double, double, double, double, int, int, int, int, int, int, const int *);

/* The side of a page of SIDE pixels or points, in metres: GR has pixels of 600 dpi, in SVG others. */
#define PIXELS (SIDE * 0.0254 / 600 + 1e-6)
#define POINTS (SIDE * 0.0254 / 72)
static const struct {
    const char *name;
    int type;
    double side;
} devices[] = {{"png", 140, PIXELS}, {"svg", 382, SIDE * 0.254 / 4096}, {"pdf", 102, POINTS}, {"ps", 62, POINTS}};

/* Widths and sizes of 1 are so many pixels or points. */
#define NOMINAL (SIDE / 500.0)

static char written[4096];
static const char *target;

int open_library(const char *device, const char *file)
{
    unsigned count = sizeof devices / sizeof *devices, i = 0;
    while (i < count && strcmp(device, devices[i].name))
        i++;
    if (i == count)
        return 0;
    target = file;
    snprintf(written, sizeof written, "%s.%s", file, device);
    gks_open_gks(2);
    gks_open_ws(1, written, devices[i].type);
    gks_activate_ws(1);
    gks_set_ws_viewport(1, 0, devices[i].side, 0, devices[i].side);
    for (int index = 0; index < 256; index++) {
        int rgb[3];
        colour_of(index, rgb);
        gks_set_color_rep(1, index, rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0);
    }
    int individual[13];
    for (int aspect = 0; aspect < 13; aspect++)
        individual[aspect] = 1;
    gks_set_asf(individual);
    gks_set_fill_int_style(1);
    gks_set_text_fontprec(1, 2);
    gks_set_text_height(0.02);
    gks_set_border_width(1 / NOMINAL);
    return 1;
}

void set_window(double left, double right)
{
    gks_set_window(1, left, right, 0, 1);
    gks_select_xform(1);
}

void set_line(int dashed, double width, int antialiased)
{
    (void)antialiased;
    gks_set_pline_linetype(dashed ? 2 : 1);
    gks_set_pline_linewidth(width / NOMINAL);
}

void polyline(struct points points)
{
    gks_polyline(points.count, points.x, points.y);
}

void polymarker(int type, struct points points)
{
    gks_set_pmark_type(type);
    gks_set_pmark_size(1 / NOMINAL);
    gks_polymarker(points.count, points.x, points.y);
}

void fill_area(struct points points, int colour)
{
    gks_set_fill_color_index(colour);
    gks_fillarea(points.count, points.x, points.y);
}

void cell_array(int columns, int rows, const int *colours)
{
    gks_cellarray(0, 1, 1, 0, columns, rows, 1, 1, columns, rows, colours);
}

void text(double x, double y, const char *string)
{
    gks_text(x, y, string);
}

int has_stroke_fonts(void)
{
    return 1;
}

void finish_drawing(void)
{
    gks_update_ws(1, 1);
}

void close_library(void)
{
    gks_deactivate_ws(1);
    gks_close_ws(1);
    gks_close_gks();
    rename(written, target);
}
