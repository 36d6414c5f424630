/* Input with the names of XGKS, from the operator of a scripted workstation: every class in every mode. */
#include "xgks_check.h"

static Glimit area = {0.0f, 0.1f, 0.0f, 0.05f};

static void locators(void)
{
    Gqloc answer;
    Gloc initial = {1, {2.0f, 3.0f}};
    Glocrec record;
    Glocst state;
    Gdefloc usual;

    WORKS(greqloc(1, 1, &answer));
    CHECK(answer.status == GOK && answer.loc.transform == 1);
    CHECK(near(answer.loc.position.x, 5.0) && near(answer.loc.position.y, 2.0));
    WORKS(greqloc(1, 1, &answer));
    CHECK(answer.loc.transform == 0 && near(answer.loc.position.x, 0.75));
    WORKS(greqloc(1, 1, &answer));
    CHECK(answer.status == GNONE);
    REPORTS(140, greqloc(1, 99, &answer));
    REPORTS(25, greqloc(7, 1, &answer));

    memset(&record, 0, sizeof record);
    record.pet5.pfcf = GPF_FILLAREA;
    record.pet5.acf = GSPECIFIED;
    record.pet5.attr.fl.fill = 1;
    record.pet5.attr.fl.bundl.inter = GHATCH;
    record.pet5.attr.fl.bundl.style = -3;
    record.pet5.attr.fl.bundl.colour = 4;
    WORKS(ginitloc(1, 1, &initial, 5, &area, &record));
    memset(&record, 0, sizeof record);
    WORKS(ginqlocst(1, 1, GSET, &state));
    CHECK(state.mode == GREQUEST && state.esw == GECHO && state.pet == 5 && near(state.e_area.xmax, 0.1));
    CHECK(state.loc.transform == 1 && near(state.loc.position.y, 3.0));
    CHECK(state.record.pet5.pfcf == GPF_FILLAREA && state.record.pet5.acf == GSPECIFIED);
    CHECK(state.record.pet5.attr.fl.fill == 1 && state.record.pet5.attr.fl.bundl.inter == GHATCH);
    CHECK(state.record.pet5.attr.fl.bundl.style == -3 && state.record.pet5.attr.fl.bundl.colour == 4);
    record.pet4.acf = GSPECIFIED;
    record.pet4.ln.type = GINDIVIDUAL;
    record.pet4.ln.line = 2;
    record.pet4.ln.bundl.type = GLN_DOT;
    record.pet4.ln.bundl.width = 2.5f;
    record.pet4.ln.bundl.colour = 3;
    WORKS(ginitloc(1, 1, &initial, 4, &area, &record));
    WORKS(ginqlocst(1, 1, GREALIZED, &state));
    CHECK(state.record.pet4.ln.type == GINDIVIDUAL && state.record.pet4.ln.line == 2);
    CHECK(state.record.pet4.ln.bundl.type == GLN_DOT && near(state.record.pet4.ln.bundl.width, 2.5));
    CHECK(state.record.pet4.ln.bundl.colour == 3);
    REPORTS(2000, ginqlocst(1, 1, (Gqtype) 7, &state));
    REPORTS(2000, ginitloc(1, 1, NULL, 1, &area, NULL));
    initial.position.x = 77.0f;
    REPORTS(152, ginitloc(1, 1, &initial, 1, &area, NULL));
    WORKS(ginqdefloc(NULL, 1, &usual));
    CHECK(usual.pets.number == 6 && usual.pets.integers[5] == 6 && usual.e_area.xmax > 0.0f);
    CHECK(near(usual.position.x, 0.5));
    free(usual.pets.integers);
}

static void strokes(void)
{
    Gpoint room[64], points[] = {{0.25f, 0.5f}, {0.5f, 0.75f}};
    Gqstroke answer;
    Gstroke initial = {0, 2, NULL};
    Gstrokerec record;
    Gstrokest state;
    Gdefstroke usual;

    answer.stroke.points = room;
    WORKS(greqstroke(1, 1, &answer));
    CHECK(answer.status == GOK && answer.stroke.n_points == 3 && near(room[2].y, 0.75));
    initial.points = points;
    memset(&record, 0, sizeof record);
    record.pet3.bufsiz = 2;
    record.pet3.editpos = 2;
    record.pet3.interval.x = 0.25f;
    record.pet3.acf = GSPECIFIED;
    record.pet3.mk.mark = 3;
    record.pet3.mk.bundl.type = GMK_STAR;
    record.pet3.mk.bundl.size = 1.5f;
    WORKS(ginitstroke(1, 1, &initial, 3, &area, &record));
    WORKS(ginqstrokest(1, 1, GSET, &state));
    CHECK(state.pet == 3 && state.stroke.n_points == 2 && near(state.stroke.points[1].y, 0.75));
    CHECK(state.record.pet3.bufsiz == 2 && state.record.pet3.editpos == 2);
    CHECK(near(state.record.pet3.interval.x, 0.25) && state.record.pet3.mk.mark == 3);
    CHECK(state.record.pet3.mk.bundl.type == GMK_STAR && near(state.record.pet3.mk.bundl.size, 1.5));
    free(state.stroke.points);
    record.pet3.bufsiz = 1;
    REPORTS(153, ginitstroke(1, 1, &initial, 1, &area, &record));
    REPORTS(146, ginitstroke(1, 1, &initial, 1, &area, NULL));
    /* No more points than the buffer holds are set. */
    initial.n_points = 0;
    record.pet1.bufsiz = 2;
    record.pet1.editpos = 1;
    record.pet1.interval.x = record.pet1.interval.y = 0.0f;
    WORKS(ginitstroke(1, 1, &initial, 1, &area, &record));
    room[2].x = -7.0f;
    WORKS(greqstroke(1, 1, &answer));
    CHECK(answer.stroke.n_points == 2 && answer.stroke.transform == 1 && near(room[1].x, 2.5));
    CHECK(near(room[2].x, -7.0) && answer.stroke.points == room);
    WORKS(greqstroke(1, 1, &answer));
    CHECK(answer.status == GNONE && answer.stroke.points == room);
    WORKS(ginqstrokest(1, 2, GSET, &state));
    CHECK(state.record.pet1.bufsiz == 64 && state.stroke.n_points == 0);
    WORKS(ginqdefstroke(NULL, 1, &usual));
    CHECK(usual.bufsiz == 64 && usual.pets.number == 4 && usual.record.pet1.editpos == 1);
    free(usual.pets.integers);
}

static void valuators(void)
{
    Gqval answer;
    Gvalrec record;
    Gvalst state;
    Gdefval usual;

    record.pet1.low = -1.0f;
    record.pet1.high = 1.0f;
    WORKS(ginitval(1, 1, 0.5f, 2, &area, &record));
    WORKS(ginqvalst(1, 1, &state));
    CHECK(near(state.val, 0.5) && state.pet == 2 && near(state.record.pet2.low, -1.0));
    CHECK(near(state.record.pet2.high, 1.0));
    REPORTS(152, ginitval(1, 1, 2.0f, 1, &area, &record));
    WORKS(greqval(1, 1, &answer));
    CHECK(answer.status == GOK && near(answer.val, 0.25));
    WORKS(greqval(1, 1, &answer));
    CHECK(answer.status == GNONE);
    WORKS(ginqdefval(NULL, 1, &usual));
    CHECK(usual.record.pet1.low < usual.record.pet1.high && usual.pets.number == 3);
    free(usual.pets.integers);
}

static void choices(void)
{
    Gchar *names[] = {"red", "green", "blue"};
    Gprflag prompts[] = {GPRON, GPROFF};
    Gint identifiers[] = {7, 8, 9};
    Gchoice answer, initial = {GC_OK, 3};
    Gchoicerec record;
    Gchoicest state;
    Gdefchoice usual;
    int i;

    WORKS(greqchoice(1, 1, &answer));
    CHECK(answer.status == GC_OK && answer.choice == 3);
    WORKS(greqchoice(1, 1, &answer));
    CHECK(answer.status == GC_NOCHOICE);
    WORKS(greqchoice(1, 1, &answer));
    CHECK(answer.status == GC_NONE);
    record.pet3.number = 3;
    record.pet3.strings = names;
    WORKS(ginitchoice(1, 1, &initial, 3, &area, &record));
    WORKS(ginqchoicest(1, 1, &state));
    CHECK(state.choice.status == GC_OK && state.choice.choice == 3 && state.pet == 3);
    CHECK(state.record.pet3.number == 3 && strcmp(state.record.pet3.strings[2], "blue") == 0);
    for (i = 0; i < 3; i++)
        free(state.record.pet3.strings[i]);
    free(state.record.pet3.strings);
    initial.choice = 4;
    REPORTS(152, ginitchoice(1, 1, &initial, 3, &area, &record));
    initial.status = GC_NONE;
    REPORTS(152, ginitchoice(1, 1, &initial, 3, &area, &record));
    initial.status = GC_NOCHOICE;
    record.pet2.number = 2;
    record.pet2.enable = prompts;
    WORKS(ginitchoice(1, 1, &initial, 2, &area, &record));
    WORKS(ginqchoicest(1, 1, &state));
    CHECK(state.choice.status == GC_NOCHOICE && state.record.pet2.number == 2);
    CHECK(state.record.pet2.enable[0] == GPRON && state.record.pet2.enable[1] == GPROFF);
    free(state.record.pet2.enable);
    record.pet5.seg = 5;
    record.pet5.number = 3;
    record.pet5.pickids = identifiers;
    WORKS(ginitchoice(1, 1, &initial, 5, &area, &record));
    WORKS(ginqchoicest(1, 1, &state));
    CHECK(state.record.pet5.seg == 5 && state.record.pet5.pickids[2] == 9);
    free(state.record.pet5.pickids);
    WORKS(ginqdefchoice(NULL, 1, &usual));
    CHECK(usual.choices > 3 && usual.pets.number == 5);
    free(usual.pets.integers);
}

static void picks(void)
{
    Gpick answer, initial = {GP_OK, 4, 11};
    Gpickrec record;
    Gpickst state;
    Gdefpick usual;
    Gint identifier;

    WORKS(ginqcurpickid(&identifier));
    CHECK(identifier == 11);
    WORKS(greqpick(1, 1, &answer));
    CHECK(answer.status == GP_OK && answer.seg == 4 && answer.pickid == 11);
    WORKS(greqpick(1, 1, &answer));
    CHECK(answer.status == GP_NOPICK);
    WORKS(greqpick(1, 1, &answer));
    CHECK(answer.status == GP_NONE);
    record.pet1.data = NULL;
    WORKS(ginitpick(1, 1, &initial, 1, &area, &record));
    WORKS(ginqpickst(1, 1, GSET, &state));
    CHECK(state.pick.status == GP_OK && state.pick.seg == 4 && state.pick.pickid == 11);
    WORKS(ginqdefpick(NULL, 1, &usual));
    CHECK(usual.pets.number == 3 && usual.record.pet1.data == NULL);
    free(usual.pets.integers);
}

static void strings(void)
{
    Gchar text[1024];
    Gqstring answer;
    Gstringrec record;
    Gstringst state;
    Gdefstring usual;

    answer.string = text;
    WORKS(greqstring(1, 1, &answer));
    CHECK(answer.status == GOK && strcmp(text, "hello world") == 0);
    /* No more bytes than the buffer holds are set, the last of which ends the string. */
    record.pet1.bufsiz = 8;
    record.pet1.position = 2;
    record.pet1.data = NULL;
    WORKS(ginitstring(1, 1, "x", 1, &area, &record));
    WORKS(ginqstringst(1, 1, &state));
    CHECK(strcmp(state.string, "x") == 0 && state.record.pet1.bufsiz == 8 && state.record.pet1.position == 2);
    free(state.string);
    record.pet1.position = 3;
    REPORTS(152, ginitstring(1, 1, "x", 1, &area, &record));
    WORKS(greqstring(1, 1, &answer));
    CHECK(answer.status == GOK && strcmp(text, "abc") == 0);
    memset(text, 'x', sizeof text);
    WORKS(greqstring(1, 1, &answer));
    CHECK(memcmp(text, "much to\0x", 9) == 0);
    WORKS(ginqdefstring(NULL, 1, &usual));
    CHECK(usual.bufsiz == 1024 && usual.pets.number == 1 && usual.record.pet1.position == 1);
    free(usual.pets.integers);
}

static void samples(void)
{
    Gpoint room[64];
    Gloc place;
    Gstroke stroke;
    Gfloat value;
    Gchoice choice;
    Gpick pick;
    Gchar text[1024];

    stroke.points = room;
    WORKS(gsetlocmode(1, 2, GSAMPLE, GNOECHO));
    WORKS(gsampleloc(1, 2, &place));
    CHECK(place.transform == 1 && near(place.position.x, 2.0));
    WORKS(gsetstrokemode(1, 2, GSAMPLE, GECHO));
    WORKS(gsamplestroke(1, 2, &stroke));
    CHECK(stroke.n_points == 2 && near(room[1].x, 4.0));
    WORKS(gsetvalmode(1, 2, GSAMPLE, GECHO));
    WORKS(gsampleval(1, 2, &value));
    CHECK(near(value, 0.75));
    WORKS(gsetchoicemode(1, 2, GSAMPLE, GECHO));
    WORKS(gsamplechoice(1, 2, &choice));
    CHECK(choice.status == GC_OK && choice.choice == 2);
    WORKS(gsetpickmode(1, 2, GSAMPLE, GECHO));
    WORKS(gsamplepick(1, 2, &pick));
    CHECK(pick.status == GP_OK && pick.seg == 4 && pick.pickid == 11);
    WORKS(gsetstringmode(1, 2, GSAMPLE, GECHO));
    WORKS(gsamplestring(1, 2, text));
    CHECK(strcmp(text, "left") == 0);
    WORKS(gsetstringmode(1, 2, GREQUEST, GECHO));
    REPORTS(142, gsamplestring(1, 2, text));
    REPORTS(2000, gsetlocmode(1, 2, (Gimode) 5, GECHO));
    REPORTS(2000, gsetlocmode(1, 2, GREQUEST, (Gesw) 5));
}

static void events(void)
{
    Gqloc answer;
    Gevent event;
    Gqueue overflow;
    Gsimultev more;
    Gloc place;
    Gstroke stroke;
    Gfloat value;
    Gchoice choice;
    Gpick pick;
    Gchar text[1024];

    WORKS(gsetlocmode(1, 3, GEVENT, GECHO));
    WORKS(gsetstrokemode(1, 3, GEVENT, GECHO));
    WORKS(gsetvalmode(1, 3, GEVENT, GECHO));
    WORKS(gsetchoicemode(1, 3, GEVENT, GECHO));
    WORKS(gsetpickmode(1, 3, GEVENT, GECHO));
    WORKS(gsetstringmode(1, 3, GEVENT, GECHO));
    WORKS(greqloc(1, 1, &answer));
    WORKS(greqloc(1, 1, &answer));
    CHECK(near(answer.loc.position.x, 10.0));
    REPORTS(150, ggetloc(&place));
    WORKS(gawaitevent(0.0f, &event));
    CHECK(event.ws == 1 && event.class == GISTROKE && event.dev == 3);
    REPORTS(150, ggetchoice(&choice));
    WORKS(ggetstroke(&stroke));
    CHECK(stroke.transform == 1 && stroke.n_points == 3 && near(stroke.points[2].x, 6.0));
    free(stroke.points);
    WORKS(gawaitevent(0.0f, &event));
    WORKS(ggetchoice(&choice));
    CHECK(event.class == GCHOICE && choice.status == GC_OK && choice.choice == 1);
    WORKS(gawaitevent(0.0f, &event));
    WORKS(ggetpick(&pick));
    CHECK(event.class == GPICK && pick.seg == 4 && pick.pickid == 11);
    WORKS(gawaitevent(0.0f, &event));
    WORKS(ggetstring(text));
    CHECK(event.class == GISTRING && strcmp(text, "event") == 0);
    WORKS(gawaitevent(0.0f, &event));
    WORKS(ggetloc(&place));
    CHECK(event.class == GLOCATOR && place.transform == 1 && near(place.position.y, 1.0));
    WORKS(gawaitevent(0.01f, &event));
    CHECK(event.class == GNCLASS);
    WORKS(gawaitevent(60.0f, &event));
    WORKS(ggetval(&value));
    CHECK(event.class == GVALUATOR && near(value, 0.5));
    WORKS(ginqmoreevents(&more));
    CHECK(more == GMORE);
    WORKS(gflushevents(1, GCHOICE, 3));
    WORKS(ginqmoreevents(&more));
    CHECK(more == GNOMORE);
    WORKS(gawaitevent(60.0f, &event));
    CHECK(event.class == GNCLASS);
    REPORTS(151, gawaitevent(-1.0f, &event));
    REPORTS(148, ginqinputoverflow(&overflow));
    REPORTS(2000, gflushevents(1, (Giclass) 9, 1));
}

int main(void)
{
    Glimit window = {0.0f, 10.0f, 0.0f, 10.0f}, viewport = {0.0f, 0.5f, 0.0f, 0.5f};
    Gpoint corners[] = {{0.2f, 0.2f}, {0.3f, 0.2f}, {0.3f, 0.3f}, {0.2f, 0.3f}};
    Gsegattr attributes = {4, {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}}, GVISIBLE, GNORMAL, 0.5f, GDETECTABLE};
    Gnumdev devices;
    Glimit screen = {0.0f, 1279.0f, 0.0f, 1023.0f};
    Gchoice none = {GC_NOCHOICE, 0};

    REPORTS(8, gsetpickid(1));
    WORKS(gopengks(stdout, 0));
    WORKS(gopenws(1, NULL, NULL));
    WORKS(gactivatews(1));
    WORKS(ginqnumavailinput(NULL, &devices));
    CHECK(devices.locator == 10 && devices.stroke == 10 && devices.valuator == 10 && devices.choice == 10);
    CHECK(devices.pick == 10 && devices.string == 10);
    WORKS(gsetfillintstyle(GSOLID));
    WORKS(gcreateseg(4));
    WORKS(gsetpickid(11));
    WORKS(gfillarea(4, corners));
    WORKS(gcloseseg());
    WORKS(gsetsegattr(4, &attributes));
    WORKS(gsetwindow(1, &window));
    WORKS(gsetviewport(1, &viewport));
    WORKS(gsetviewportinputpri(1, 0, GHIGHER));
    locators();
    strokes();
    valuators();
    choices();
    picks();
    strings();
    samples();
    events();
    /* Programs of XGKS have large echo areas. */
    WORKS(ginitchoice(1, 4, &none, 1, &screen, NULL));
    WORKS(gdeactivatews(1));
    WORKS(gclosews(1));
    WORKS(gclosegks());
    return finish();
}
