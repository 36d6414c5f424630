/* A metafile with the names of XGKS: written, read item by item, looked into, and interpreted. */
#include "xgks_check.h"

enum { OWN = 123 };

static const char own[] = "what only this program understands";

/* What items are read into, as far as this program looks into them. */
typedef struct { Gint flag; } One;
typedef struct { Gint number; Gpoint *points; } Graph;
typedef struct { Gpoint at; Gint length; Gchar *string; } Text;
typedef struct { Gpoint ll, ur, lr; Gipoint size; Gint *colours; } Cells;
typedef struct { Gint index; Gfloat red, green, blue; } Colour;
typedef struct { Gint index, style, colour; Gfloat size; } Representation;
typedef struct { Gint name, value; } Two;

static void draw(void)
{
    Gpoint points[3] = {{0.125f, 0.25f}, {0.5f, 0.75f}, {0.875f, 0.25f}}, at = {0.25f, 0.125f};
    Grect rect = {{0.25f, 0.5f}, {0.75f, 1.0f}};
    Gipoint size = {2, 2};
    Gint colours[] = {1, 2, 3, 4};
    Gcobundl black = {0.0f, 0.0f, 0.0f}, orange = {1.0f, 0.5f, 0.25f};
    Glnbundl line = {GLN_DASH, 3.0f, 9};
    Glimit window = {0.0f, 1.0f, 0.0f, 1.0f}, viewport = {0.0f, 0.2f, 0.0f, 0.2f};

    WORKS(gsetwswindow(2, &window));
    WORKS(gsetwsviewport(2, &viewport));
    WORKS(gsetcolourrep(2, 1, &black));
    WORKS(gsetcolourrep(2, 9, &orange));
    WORKS(gsetlinerep(2, 2, &line));
    WORKS(gsetfillintstyle(GSOLID));
    WORKS(gsetfillcolourind(9));
    WORKS(gfillarea(3, points));
    WORKS(gcellarray(&rect, &size, 2, colours));
    WORKS(gsetlinetype(GLN_DOT));
    WORKS(gpolyline(3, points));
    WORKS(gsetcharheight(0.0625f));
    WORKS(gtext(&at, "Text in a metafile"));
    WORKS(gupdatews(2, GPERFORM));
}

static void write_metafile(void)
{
    Gwscat category;

    WORKS(ginqwscategory("MO", &category));
    CHECK(category == GMO);
    WORKS(gopenws(2, "xgks.gksm", "MO"));
    REPORTS(5, gwritegksm(2, OWN, sizeof own, (Gchar *) own));
    WORKS(gactivatews(2));
    draw();
    REPORTS(160, gwritegksm(2, 100, sizeof own, (Gchar *) own));
    REPORTS(161, gwritegksm(2, OWN, -1, (Gchar *) own));
    WORKS(gwritegksm(2, OWN, sizeof own, (Gchar *) own));
    WORKS(gdeactivatews(2));
    WORKS(gclosews(2));
}

/* Looks into items of the metafile. */
static void look(const Ggksmit *item, const char *record)
{
    const Graph *graph = (const Graph *) record;
    const Text *text = (const Text *) record;
    const Cells *cells = (const Cells *) record;
    const Colour *colour = (const Colour *) record;
    const Representation *line = (const Representation *) record;

    switch (item->type) {
    case 3:
        CHECK(item->length == sizeof(One) && ((const One *) record)->flag == GPERFORM);
        break;
    case 11:
    case 14:
        CHECK(item->length == sizeof(Graph) + 3 * sizeof(Gpoint) && graph->number == 3);
        CHECK(near(graph->points[1].x, 0.5) && near(graph->points[2].x, 0.875));
        break;
    case 13:
        CHECK(item->length == sizeof(Text) + sizeof "Text in a metafile" && near(text->at.x, 0.25));
        CHECK(text->length == 18 && strcmp(text->string, "Text in a metafile") == 0);
        break;
    case 15:
        CHECK(cells->size.x == 2 && cells->size.y == 2 && cells->colours[3] == 4);
        break;
    case 51:
        if (line->index == 2)
            CHECK(line->style == GLN_DASH && line->colour == 9 && near(line->size, 3.0));
        break;
    case 56:
        if (colour->index == 9)
            CHECK(near(colour->green, 0.5) && near(colour->blue, 0.25));
        break;
    case OWN:
        CHECK(item->length == sizeof own && strcmp(record, own) == 0);
        break;
    }
}

static void read_metafile(void)
{
    static const int drawn[] = {3, 11, 13, 14, 15, 51, 56, OWN};
    int seen[128] = {0};
    Ggksmit item = {-1, 0};
    Two segment;
    char *record;
    unsigned i;

    WORKS(gopenws(1, "xgks.png", "MO"));
    WORKS(gactivatews(1));
    WORKS(gopenws(3, "xgks.gksm", "MI"));
    REPORTS(33, gactivatews(3));
    REPORTS(166, greadgksm(3, -1, NULL));
    for (i = 0; item.type != 0 && i < 200; i++) {
        WORKS(ggetgksm(3, &item));
        record = malloc(item.length + 1);
        WORKS(greadgksm(3, item.length, record));
        look(&item, record);
        if (item.type > 100)
            REPORTS(167, ginterpret(&item, record));
        else
            WORKS(ginterpret(&item, record));
        free(record);
        if (item.type >= 0 && item.type < 128)
            seen[item.type]++;
    }
    for (i = 0; i < sizeof drawn / sizeof *drawn; i++) {
        CHECK(seen[drawn[i]] > 0);
        if (seen[drawn[i]] == 0)
            printf("no item %d\n", drawn[i]);
    }
    REPORTS(162, ggetgksm(3, &item));
    REPORTS(162, greadgksm(3, 1, NULL));
    REPORTS(34, ggetgksm(1, &item));
    /* Items that the program makes itself. */
    item.type = 92;
    item.length = sizeof segment;
    segment.name = 5;
    segment.value = GINVISIBLE;
    WORKS(gcreateseg(5));
    WORKS(gcloseseg());
    WORKS(ginterpret(&item, (Gchar *) &segment));
    {
        Gsegattr attributes;
        attributes.seg = 5;
        WORKS(ginqsegattr(&attributes));
        CHECK(attributes.vis == GINVISIBLE);
    }
    item.type = 99;
    REPORTS(164, ginterpret(&item, (Gchar *) &segment));
    item.type = 11;
    REPORTS(161, ginterpret(&item, NULL));
    WORKS(gclosews(3));
    WORKS(gdeactivatews(1));
    WORKS(gclosews(1));
}

int main(void)
{
    WORKS(gopengks(stdout, 0));
    write_metafile();
    read_metafile();
    /* The same at once, as a picture. */
    WORKS(gopenws(2, "direct.png", "MO"));
    WORKS(gactivatews(2));
    draw();
    WORKS(gdeactivatews(2));
    WORKS(gclosews(2));
    WORKS(gclosegks());
    return finish();
}
