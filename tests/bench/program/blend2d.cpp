// Blend2D, called directly in one thread: one path for each primitive, round caps and joins.
extern "C" {
#include "library.h"
}
#include <blend2d/blend2d.h>
#include <cmath>
#include <cstring>

static BLImage image(SIDE, SIDE, BL_FORMAT_PRGB32);
static BLContext context;
static BLPath path;
static double left, scale, line_width = 1;
static bool dashed_line;

static BLRgba32 colour(int index)
{
    int rgb[3];
    colour_of(index, rgb);
    return BLRgba32(rgb[0], rgb[1], rgb[2]);
}

int open_library(const char *device, const char *)
{
    if (std::strcmp(device, "memory"))
        return 0;
    set_window(0, 1);
    context.begin(image);
    context.fill_all(colour(0));
    context.set_stroke_caps(BL_STROKE_CAP_ROUND);
    context.set_stroke_join(BL_STROKE_JOIN_ROUND);
    context.set_pattern_quality(BL_PATTERN_QUALITY_NEAREST);
    return 1;
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
    context.set_stroke_width(width);
}

static BLPoint place(const points &points, int i)
{
    return BLPoint((points.x[i] - left) * scale, SIDE - points.y[i] * SIDE);
}

static void follow(const points &points)
{
    path.clear();
    path.reserve(points.count);
    for (int i = 0; i < points.count; i++) {
        if (i == 0)
            path.move_to(place(points, i));
        else
            path.line_to(place(points, i));
    }
}

// Blend2D draws no dashes itself.
static void follow_dashes(const points &points)
{
    double unit = line_width > 2 ? line_width / 2 : 1;
    const double lengths[2] = {12 * unit, 8 * unit};
    int index = 0;
    double rest = lengths[0];
    path.clear();
    BLPoint at = place(points, 0);
    path.move_to(at);
    for (int i = 1; i < points.count; i++) {
        BLPoint to = place(points, i);
        double length = std::hypot(to.x - at.x, to.y - at.y), done = 0;
        while (length - done > rest) {
            done += rest;
            BLPoint end(at.x + (to.x - at.x) * done / length, at.y + (to.y - at.y) * done / length);
            if (index == 0)
                path.line_to(end);
            else
                path.move_to(end);
            index = 1 - index;
            rest = lengths[index];
        }
        rest -= length - done;
        if (index == 0)
            path.line_to(to);
        at = to;
    }
}

void polyline(points points)
{
    if (dashed_line)
        follow_dashes(points);
    else
        follow(points);
    context.stroke_path(path, colour(1));
}

void polymarker(int type, points points)
{
    for (int i = 0; i < points.count; i++) {
        double x = points.x[i] * SIDE, y = SIDE - points.y[i] * SIDE;
        if (type == 1) {
            context.fill_rect(BLRectI(int(std::floor(x)), int(std::floor(y)), 1, 1), colour(1));
        } else if (type == 2) {
            path.clear();
            path.move_to(x - 3, y);
            path.line_to(x + 3, y);
            path.move_to(x, y - 3);
            path.line_to(x, y + 3);
            context.stroke_path(path, colour(1));
        } else {
            context.stroke_circle(BLCircle(x, y, 3), colour(1));
        }
    }
}

void fill_area(points points, int index)
{
    follow(points);
    context.set_fill_rule(BL_FILL_RULE_EVEN_ODD);
    context.fill_path(path, colour(index));
}

void cell_array(int columns, int rows, const int *colours)
{
    uint32_t palette[256];
    for (int i = 0; i < 256; i++)
        palette[i] = colour(i).value;
    BLImage cells(columns, rows, BL_FORMAT_PRGB32);
    BLImageData data;
    cells.make_mutable(&data);
    for (int row = 0; row < rows; row++) {
        uint32_t *line = reinterpret_cast<uint32_t *>(static_cast<char *>(data.pixel_data) + row * data.stride);
        for (int column = 0; column < columns; column++)
            line[column] = palette[colours[row * (long)columns + column]];
    }
    context.blit_image(BLRect(0, 0, SIDE, SIDE), cells);
}

void text(double, double, const char *) {}

int has_stroke_fonts(void)
{
    return 0;
}

void finish_drawing(void)
{
    context.flush(BL_CONTEXT_FLUSH_SYNC);
}

void close_library(void)
{
    context.end();
}
