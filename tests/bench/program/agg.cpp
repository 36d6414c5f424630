// Anti-Grain Geometry, called directly: one path for each primitive, round caps and joins.
extern "C" {
#include "library.h"
}
#include <agg_conv_dash.h>
#include <agg_conv_stroke.h>
#include <agg_ellipse.h>
#include <agg_path_storage.h>
#include <agg_pixfmt_rgba.h>
#include <agg_rasterizer_scanline_aa.h>
#include <agg_renderer_scanline.h>
#include <agg_rendering_buffer.h>
#include <agg_scanline_u.h>
#include <cmath>
#include <cstring>
#include <vector>

typedef agg::renderer_base<agg::pixfmt_rgba32> Renderer;

static std::vector<unsigned char> bytes(4 * SIDE *SIDE, 255);
static agg::rendering_buffer buffer(bytes.data(), SIDE, SIDE, 4 * SIDE);
static agg::pixfmt_rgba32 format(buffer);
static Renderer renderer(format);
static agg::rasterizer_scanline_aa<> rasterizer;
static agg::scanline_u8 scanline;
static double left, scale, line_width = 1;
static bool dashed_line;

static agg::rgba8 colour(int index)
{
    int rgb[3];
    colour_of(index, rgb);
    return agg::rgba8(rgb[0], rgb[1], rgb[2]);
}

static void render(int index)
{
    agg::render_scanlines_aa_solid(rasterizer, scanline, renderer, colour(index));
    rasterizer.reset();
}

template <class Path> static void stroke(Path &path)
{
    agg::conv_stroke<Path> outline(path);
    outline.width(line_width);
    outline.line_cap(agg::round_cap);
    outline.line_join(agg::round_join);
    rasterizer.add_path(outline);
    render(1);
}

int open_library(const char *device, const char *)
{
    set_window(0, 1);
    rasterizer.clip_box(0, 0, SIDE, SIDE);
    return !std::strcmp(device, "memory");
}

void set_window(double from, double to)
{
    left = from;
    scale = SIDE / (to - from);
}

void set_line(int dashed, double width, int)
{
    dashed_line = dashed;
    line_width = width;
}

static agg::path_storage path_of(const points &points)
{
    agg::path_storage path;
    for (int i = 0; i < points.count; i++) {
        double x = (points.x[i] - left) * scale, y = SIDE - points.y[i] * SIDE;
        if (i == 0)
            path.move_to(x, y);
        else
            path.line_to(x, y);
    }
    return path;
}

void polyline(points points)
{
    agg::path_storage path = path_of(points);
    if (dashed_line) {
        agg::conv_dash<agg::path_storage> dashes(path);
        double unit = line_width > 2 ? line_width / 2 : 1;
        dashes.add_dash(12 * unit, 8 * unit);
        stroke(dashes);
    } else {
        stroke(path);
    }
}

void polymarker(int type, points points)
{
    for (int i = 0; i < points.count; i++) {
        double x = points.x[i] * SIDE, y = SIDE - points.y[i] * SIDE;
        if (type == 1) {
            renderer.copy_pixel(int(std::floor(x)), int(std::floor(y)), colour(1));
        } else if (type == 2) {
            agg::path_storage path;
            path.move_to(x - 3, y);
            path.line_to(x + 3, y);
            path.move_to(x, y - 3);
            path.line_to(x, y + 3);
            stroke(path);
        } else {
            agg::ellipse circle(x, y, 3, 3);
            stroke(circle);
        }
    }
}

void fill_area(points points, int index)
{
    agg::path_storage path = path_of(points);
    rasterizer.filling_rule(agg::fill_even_odd);
    rasterizer.add_path(path);
    render(index);
    rasterizer.filling_rule(agg::fill_non_zero);
}

void cell_array(int columns, int rows, const int *colours)
{
    agg::rgba8 palette[256];
    for (int i = 0; i < 256; i++)
        palette[i] = colour(i);
    std::vector<agg::rgba8> line(SIDE);
    for (int y = 0; y < SIDE; y++) {
        const int *row = colours + (long)(y * (long)rows / SIDE) * columns;
        for (int x = 0; x < SIDE; x++)
            line[x] = palette[row[x * (long)columns / SIDE]];
        renderer.blend_color_hspan(0, y, SIDE, line.data(), 0);
    }
}

void text(double, double, const char *) {}

int has_stroke_fonts(void)
{
    return 0;
}

void finish_drawing(void) {}

void close_library(void) {}
