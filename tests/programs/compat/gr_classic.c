/* The figure of iso.c with the C names of 1988 that GR has. */
#include <gks.h>

static Gpoint line[] = {{0.125, 0.125}, {0.875, 0.25}, {0.5, 0.875}};
static Gpoint area[] = {{0.25, 0.25}, {0.5, 0.25}, {0.5, 0.5}, {0.25, 0.5}};
static Gpoint marks[] = {{0.75, 0.75}, {0.625, 0.625}};

int main(void)
{
    Glimit window = {0.0, 2.0, 0.0, 1.0}, viewport = {0.0, 1.0, 0.25, 0.75};
    Gcobundl colour = {0.5, 0.25, 0.75};
    Gpoint at = {1.0, 0.5}, up;
    Gtxalign align = {GAH_CENTRE, GAV_HALF};
    Gtxfp font = {-4, GP_STROKE}, found;
    Gtran transformation;
    Gcliprect clip;
    Gextent extent;
    Gwstype png = 140;
    Gint error, number;

    gopengks(0, 0);
    gopenws(1, "gr_classic.png", &png);
    gactivatews(1);
    gsetcolourrep(1, 9, &colour);
    gsetwindow(1, &window);
    gsetviewport(1, &viewport);
    gselntran(1);
    gsetclip(GCLIP);
    gsetfillintstyle(GSOLID);
    gsetfillcolourind(9);
    gfillarea(4, area);
    gsetlinewidth(4.0);
    gsetlinetype(GLN_DASHED);
    gpolyline(3, line);
    gsetmarkertype(GMK_O);
    gsetmarkersize(2.0);
    gpolymarker(2, marks);
    gsetcharheight(0.125);
    gsettextalign(&align);
    gsettextfontprec(&font);
    gtext(&at, "Figure");
    /* An error is the value of the function, and inquiries give it apart. */
    if (gsetlinetype(0) != 63 || gsetlinetype(GLN_DASHED) != 0)
        return 1;
    ginqlinetype(&number, &error);
    if (error != 0 || number != GLN_DASHED)
        return 2;
    ginqtextfontprec(&found, &error);
    ginqcharup(&up, &error);
    if (found.font != -4 || found.prec != GP_STROKE || up.x != 0.0 || up.y != 1.0)
        return 3;
    ginqntran(1, &transformation, &error);
    ginqclip(&clip, &error);
    if (transformation.w.xmax != 2.0 || clip.ind != GCLIP || clip.rec.ymin != 0.25)
        return 4;
    ginqtextextent(1, &at, "Figure", &extent, &error);
    if (error != 0 || extent.corner_1.x >= extent.corner_2.x || extent.corner_1.y >= extent.corner_4.y)
        return 5;
    gdeactivatews(1);
    gclosews(1);
    gclosegks();
    return 0;
}
