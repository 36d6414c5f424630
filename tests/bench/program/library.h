/* What the program asks of a graphics library. Coordinates are those of the unit square, y up; the canvas has
   1000 x 1000 pixels, or points in a document. */
#ifndef LIBRARY_H
#define LIBRARY_H

#define SIDE 1000

/* Points as libraries want them: double precision for all, single precision for those of ISO. */
struct points {
    int count;
    const double *x, *y;
    const float *single_x, *single_y; /* arrays of x and y */
    const float *pairs;               /* x and y of each point in turn */
};

/* Opens a workstation: memory, png, svg, pdf, pdf-small or ps. What is written goes to the file. 0 if there is none such. */
int open_library(const char *device, const char *file);
void set_window(double left, double right);
void set_line(int dashed, double width, int antialiased);
void polyline(struct points points);
void polymarker(int type, struct points points); /* 1 dot, 2 plus, 4 circle, three pixels to each side */
void fill_area(struct points points, int colour);
void cell_array(int columns, int rows, const int *colours);
/* A string, 20 pixels high, in strokes one pixel wide. */
void text(double x, double y, const char *string);
/* Whether the library has stroke fonts. One that has none gets the strokes as polylines. */
int has_stroke_fonts(void);
void finish_drawing(void);
void close_library(void);

/* The colours of the Rust benchmarks: 0 is white, 1 black. Parts of 255. */
static inline void colour_of(int index, int rgb[3])
{
    rgb[0] = index < 2 ? 255 * !index : (index * 37) & 255;
    rgb[1] = index < 2 ? 255 * !index : (index * 91 + 60) & 255;
    rgb[2] = index < 2 ? 255 * !index : (index * 151 + 128) & 255;
}

#endif
