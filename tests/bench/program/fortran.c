/* The Fortran binding, as NCAR Graphics, XGKS and this library have it. Compile with -DNCAR or -DXGKS for theirs. */
#include "library.h"
#include <stdio.h>
#include <string.h>

typedef int integer;
typedef float real;

extern void gopks_(integer *, integer *), gopwk_(integer *, integer *, integer *), gacwk_(integer *), gdawk_(integer *),
    gclwk_(integer *), gclks_(void), gclrwk_(integer *, integer *), guwk_(integer *, integer *),
    gpl_(integer *, const real *, const real *), gpm_(integer *, const real *, const real *),
    gfa_(integer *, const real *, const real *), gtx_(real *, real *, const char *, int),
    gca_(real *, real *, real *, real *, integer *, integer *, integer *, integer *, integer *, integer *, const integer *),
    gswn_(integer *, real *, real *, real *, real *), gselnt_(integer *), gsln_(integer *), gslwsc_(real *),
    gsmk_(integer *), gsmksc_(real *), gsfais_(integer *), gsfaci_(integer *), gschh_(real *), gstxfp_(integer *, integer *),
    gscr_(integer *, integer *, real *, real *, real *), gsasf_(integer *);

static integer workstation = 1, one = 1;
static const char *target;

#if defined NCAR
static const struct { const char *name; integer type; const char *file; } devices[] = {
    {"png", 41, "gmeta1.png"}, {"pdf", 11, "gmeta1.pdf"}, {"ps", 20, "gmeta1.ps"}};
#elif defined XGKS
static const struct { const char *name; integer type; const char *file; } devices[] = {{"window", 4, ""}};
#else
static const struct { const char *name; integer type; const char *file; } devices[] = {
    {"memory", 120, ""}, {"null", 900, ""}, {"svg", 200, "fort.2"}, {"pdf", 210, "fort.2"}, {"ps", 220, "fort.2"}};
#endif
static unsigned device_number;

int open_library(const char *device, const char *file)
{
    unsigned count = sizeof devices / sizeof *devices;
    for (device_number = 0; device_number < count && strcmp(device, devices[device_number].name);)
        device_number++;
    if (device_number == count)
        return 0;
    target = file;
    integer errors = 6, unit = 2, type = devices[device_number].type, buffer = 0, individual[13], stroke = 2;
    real height = 0.02f;
    gopks_(&errors, &buffer);
    gopwk_(&workstation, &unit, &type);
    gacwk_(&workstation);
    for (int i = 0; i < 13; i++)
        individual[i] = 1;
    gsasf_(individual);
#ifdef XGKS
    integer colours = 32;
#else
    integer colours = 256;
#endif
    for (integer i = 0; i < colours; i++) {
        int rgb[3];
        colour_of(i, rgb);
        real part[3] = {rgb[0] / 255.0f, rgb[1] / 255.0f, rgb[2] / 255.0f};
        gscr_(&workstation, &i, &part[0], &part[1], &part[2]);
    }
    gsfais_(&one);
    gstxfp_(&one, &stroke);
    gschh_(&height);
    return 1;
}

void set_window(double left, double right)
{
    real x0 = (real)left, x1 = (real)right, y0 = 0, y1 = 1;
    gswn_(&one, &x0, &x1, &y0, &y1);
    gselnt_(&one);
}

void set_line(int dashed, double width, int antialiased)
{
    integer type = dashed ? 2 : 1;
    real factor = (real)width;
    (void)antialiased;
    gsln_(&type);
    gslwsc_(&factor);
}

void polyline(struct points points)
{
    gpl_(&points.count, points.single_x, points.single_y);
}

void polymarker(int type, struct points points)
{
    real factor = 1;
    gsmk_(&type);
    gsmksc_(&factor);
    gpm_(&points.count, points.single_x, points.single_y);
}

void fill_area(struct points points, int colour)
{
    gsfaci_(&colour);
    gfa_(&points.count, points.single_x, points.single_y);
}

void cell_array(int columns, int rows, const int *colours)
{
    real zero = 0, unit = 1;
    gca_(&zero, &unit, &unit, &zero, &columns, &rows, &one, &one, &columns, &rows, colours);
}

void text(double x, double y, const char *string)
{
    real at_x = (real)x, at_y = (real)y;
    gtx_(&at_x, &at_y, string, (int)strlen(string));
}

int has_stroke_fonts(void)
{
    return 1;
}

void finish_drawing(void)
{
#ifndef NCAR
    guwk_(&workstation, &one);
#endif
}

void close_library(void)
{
#ifdef NCAR
    gclrwk_(&workstation, &one);
#endif
    gdawk_(&workstation);
    gclwk_(&workstation);
    gclks_();
    if (*devices[device_number].file)
        rename(devices[device_number].file, target);
}
