/* The C binding of ISO 8651-4. */
#include "library.h"
#include <gks.h>
#include <stdio.h>
#include <string.h>

static const struct {
    const char *name;
    int type, aliased_type;
} devices[] = {{"memory", 120, 121}, {"null", 900, 900}, {"png", 100, 110}, {"svg", 200, 200}, {"pdf", 210, 210}, {"ps", 220, 220}};

int open_library(const char *device, const char *file)
{
    char connection[4096];
    int type = 0, aliased = strstr(device, "-aliased") != NULL, small = strstr(device, "-small") != NULL;
    for (unsigned i = 0; i < sizeof devices / sizeof *devices; i++)
        if (!strncmp(device, devices[i].name, strlen(devices[i].name)))
            type = aliased ? devices[i].aliased_type : devices[i].type;
    if (!type)
        return 0;
    Gtext_font_prec strokes = {1, GPREC_STROKE};
    gopen_gks(NULL, GDEF_MEM_SIZE);
    snprintf(connection, sizeof connection, "%s%s", file, small ? "?small=1" : "");
    gopen_ws(1, connection, type);
    gactivate_ws(1);
    for (int i = 0; i < 256; i++) {
        int rgb[3];
        colour_of(i, rgb);
        Gcolr_rep colour = {{rgb[0] / 255.0f, rgb[1] / 255.0f, rgb[2] / 255.0f}};
        gset_colr_rep(1, i, &colour);
    }
    /* Round caps and joins, as the other libraries are told. */
    Gescape_in_data cap = {.escape_u3001 = {1}}, join = {.escape_u3002 = {1}};
    Gescape_out_data *nothing;
    gescape(-3001, &cap, NULL, &nothing);
    gescape(-3002, &join, NULL, &nothing);
    gset_fill_int_style(GSTYLE_SOLID);
    gset_text_font_prec(&strokes);
    gset_char_ht(0.02f);
    return 1;
}

void set_window(double left, double right)
{
    Glimit window = {(float)left, (float)right, 0, 1};
    gset_win(1, &window);
    gsel_norm_tran(1);
}

void set_line(int dashed, double width, int antialiased)
{
    (void)antialiased;
    gset_linetype(dashed ? 2 : 1);
    gset_linewidth((float)width);
}

static Gpoint_list list(struct points points)
{
    return (Gpoint_list){points.count, (Gpoint *)points.pairs};
}

void polyline(struct points points)
{
    Gpoint_list all = list(points);
    gpolyline(&all);
}

void polymarker(int type, struct points points)
{
    Gpoint_list all = list(points);
    gset_marker_type(type);
    gpolymarker(&all);
}

void fill_area(struct points points, int colour)
{
    Gpoint_list all = list(points);
    gset_fill_colr_ind(colour);
    gfill_area(&all);
}

void cell_array(int columns, int rows, const int *colours)
{
    Grect whole = {{0, 1}, {1, 0}};
    Gpat_rep cells = {{columns, rows}, (int *)colours};
    gcell_array(&whole, &cells);
}

void text(double x, double y, const char *string)
{
    Gpoint at = {(float)x, (float)y};
    gtext(&at, string);
}

int has_stroke_fonts(void)
{
    return 1;
}

void finish_drawing(void)
{
    gupd_ws(1, GFLAG_PERFORM);
}

void close_library(void)
{
    gdeactivate_ws(1);
    gclose_ws(1);
    gclose_gks();
}
