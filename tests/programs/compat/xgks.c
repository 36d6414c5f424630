/* The figure of iso.c with the names of XGKS, as a picture in a file. */
#include <xgks.h>

static Gpoint line[] = {{0.125f, 0.125f}, {0.875f, 0.25f}, {0.5f, 0.875f}};
static Gpoint area[] = {{0.25f, 0.25f}, {0.5f, 0.25f}, {0.5f, 0.5f}, {0.25f, 0.5f}};
static Gpoint marks[] = {{0.75f, 0.75f}, {0.625f, 0.625f}};

int main(void)
{
    Glimit window = {0.0f, 2.0f, 0.0f, 1.0f}, viewport = {0.0f, 1.0f, 0.25f, 0.75f};
    Gcobundl colour = {0.5f, 0.25f, 0.75f};
    Gpoint at = {1.0f, 0.5f};
    Gtxalign align = {GTH_CENTRE, GTV_HALF};
    Gtxfp font = {-4, GSTROKE};
    Gintlist open;

    gopengks(stdout, 0);
    gopenws(1, "xgks.png", "MO");
    gactivatews(1);
    gsetcolourrep(1, 9, &colour);
    gsetwindow(1, &window);
    gsetviewport(1, &viewport);
    gselntran(1);
    gsetfillintstyle(GSOLID);
    gsetfillcolourind(9);
    gfillarea(4, area);
    gsetlinewidth(4.0f);
    gsetlinetype(GLN_DASH);
    gpolyline(3, line);
    gsetmarkertype(GMK_O);
    gsetmarkersize(2.0f);
    gpolymarker(2, marks);
    gsetcharheight(0.125f);
    gsettextalign(&align);
    gsettextfontprec(&font);
    gtext(&at, "Figure");
    /* An error comes back from the function, and its line goes to the stream. */
    if (gsetlinetype(0) != 63)
        return 1;
    if (ginqopenws(&open) != 0 || open.number != 1 || open.integers[0] != 1)
        return 2;
    gdeactivatews(1);
    gclosews(1);
    gclosegks();
    return 0;
}
