/* A program that an operator operates: draws a picture, and writes what is entered to a file, a line for each.
 *
 *     operate RESULTS MODE:CLASS:PROMPT ...
 *
 * MODE is request, sample or event, CLASS a class of logical input devices, PROMPT a prompt and echo type. A sample
 * is taken until it is no longer the first one, or something is picked. event:all:1 lets one device of each class make events. */
#include <gks.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { WS = 1, SHAPES = 1, LETTER = 2, TOOLS = 3 };

static const char *classes[] = {"none", "locator", "stroke", "valuator", "choice", "pick", "string"};
static const char *statuses[] = {"none", "ok", "nothing"};
static FILE *results;
static Glimit display;

static void say(const char *line)
{
    fprintf(results, "%s\n", line);
    fflush(results);
}

static void area(int colour, Gint style, int count, Gpoint *points)
{
    Gpoint_list list;
    list.num_points = count;
    list.points = points;
    gset_fill_int_style(style < 0 ? GSTYLE_HATCH : GSTYLE_SOLID);
    if (style < 0)
        gset_fill_style_ind(style);
    gset_fill_colr_ind(colour);
    gfill_area(&list);
}

static void square(int colour, float x, float y, float side)
{
    Gpoint corners[] = {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
    area(colour, 0, 4, corners);
}

static void line(int colour, double width, int count, Gpoint *points)
{
    Gpoint_list list;
    list.num_points = count;
    list.points = points;
    gset_line_colr_ind(colour);
    gset_linewidth(width);
    gpolyline(&list);
}

static void text(float x, float y, float height, const char *words)
{
    Gtext_font_prec font = {-21, GPREC_STROKE};
    Gtext_align centred = {GHOR_CTR, GVERT_HALF};
    Gpoint at;
    at.x = x;
    at.y = y;
    gset_text_font_prec(&font);
    gset_text_align(&centred);
    gset_char_ht(height);
    gset_text_colr_ind(1);
    gtext(&at, words);
}

static void draw(void)
{
    Gpoint triangle[] = {{1, 1}, {4, 1}, {2.5f, 4}}, wave[] = {{5, 1}, {6, 4}, {7, 1}, {8, 4}, {9, 1}};
    Gpoint frame[] = {{0.2f, 0.2f}, {9.8f, 0.2f}, {9.8f, 9.8f}, {0.2f, 9.8f}, {0.2f, 0.2f}};
    Gpoint arrow[] = {{2, 2}, {4, 8}};
    gcreate_seg(SHAPES);
    gset_pick_id(11);
    area(3, 0, 3, triangle);
    gset_pick_id(12);
    line(2, 4.0, 5, wave);
    gset_pick_id(11);
    square(4, 7, 7, 1.5f);
    gclose_seg();
    gset_det(SHAPES, GSEG_DET);
    gcreate_seg(LETTER);
    gset_pick_id(21);
    text(2.5f, 8, 1, "Pick");
    gclose_seg();
    gset_det(LETTER, GSEG_DET);
    /* The tools of a menu: nobody sees them but as that. */
    gcreate_seg(TOOLS);
    gset_vis(TOOLS, GSEG_INVIS);
    gset_pick_id(31);
    line(4, 3.0, 2, arrow);
    gset_pick_id(32);
    square(2, 5, 3, 4);
    gset_pick_id(33);
    text(5, 9, 0.8f, "tools");
    gclose_seg();
    gset_pick_id(0);
    line(1, 1.0, 5, frame);
    gupd_ws(WS, GFLAG_PERFORM);
}

static void initialise(const char *class, int prompt)
{
    static char *names[] = {"Line", "Area", "Text", "Quit"};
    static Gpr_switch lamps[] = {GPR_ON, GPR_OFF, GPR_ON};
    static Gint tools[] = {31, 32, 33};
    Glimit corner = display;
    Gpoint place = {2.008333f, 5.991667f}; /* the middle of a pixel */
    Gpoint_list none = {0, NULL};
    Gpick nothing = {0, 0};
    Gchoice_data choice;
    Gloc_data locator;
    Gstroke_data stroke;
    memset(&choice, 0, sizeof choice);
    memset(&locator, 0, sizeof locator);
    memset(&stroke, 0, sizeof stroke);
    stroke.x_interval = stroke.y_interval = 0.5f;
    corner.x_min = display.x_max * 0.6f;
    corner.y_min = display.y_max * 0.6f;
    if (strcmp(class, "locator") == 0)
        ginit_loc(WS, 1, 1, &place, prompt, &display, &locator);
    if (strcmp(class, "stroke") == 0)
        ginit_stroke(WS, 1, 1, &none, prompt, &display, 100, &stroke);
    if (strcmp(class, "valuator") == 0)
        ginit_val(WS, 1, 20.0, prompt, &display, 0.0, 100.0, NULL);
    if (strcmp(class, "pick") == 0)
        ginit_pick(WS, 1, GIN_STATUS_NO_IN, &nothing, prompt, &display, NULL);
    if (strcmp(class, "string") == 0)
        ginit_string(WS, 1, "text", prompt, &display, 40, 5, NULL);
    if (strcmp(class, "choice") == 0) {
        if (prompt == 2) {
            choice.pets.pet_r2.num_prompts = 3;
            choice.pets.pet_r2.prompts = lamps;
        } else if (prompt == 3 || prompt == 4) {
            choice.pets.pet_r3.num_strings = 4;
            choice.pets.pet_r3.strings = names;
        } else if (prompt == 5) {
            choice.pets.pet_r5.seg_name = TOOLS;
            choice.pets.pet_r5.num_pick_ids = 3;
            choice.pets.pet_r5.pick_ids = tools;
        }
        ginit_choice(WS, 1, GIN_STATUS_NO_IN, 0, prompt, prompt == 5 ? &corner : &display, &choice);
    }
}

static void set_mode(const char *class, Gop_mode mode)
{
    if (strcmp(class, "locator") == 0)
        gset_loc_mode(WS, 1, mode, GSWITCH_ECHO);
    if (strcmp(class, "stroke") == 0)
        gset_stroke_mode(WS, 1, mode, GSWITCH_ECHO);
    if (strcmp(class, "valuator") == 0)
        gset_val_mode(WS, 1, mode, GSWITCH_ECHO);
    if (strcmp(class, "choice") == 0)
        gset_choice_mode(WS, 1, mode, GSWITCH_ECHO);
    if (strcmp(class, "pick") == 0)
        gset_pick_mode(WS, 1, mode, GSWITCH_ECHO);
    if (strcmp(class, "string") == 0)
        gset_string_mode(WS, 1, mode, GSWITCH_ECHO);
}

/* What a device of a class gives in a mode, as words. */
static void enter(char *words, size_t size, const char *class, Gop_mode mode)
{
    Gin_status status = GIN_STATUS_OK;
    Gint transformation, number = 0, i;
    Gpoint at = {0, 0}, points[100];
    Gpoint_list stroke = {0, points};
    Gdouble value = 0;
    Gpick pick = {0, 0};
    char string[200] = "";
    size_t length;

    if (strcmp(class, "locator") == 0) {
        if (mode == GOP_REQ)
            greq_loc(WS, 1, &status, &transformation, &at);
        else if (mode == GOP_SAMPLE)
            gsample_loc(WS, 1, &transformation, &at);
        else
            gget_loc(&transformation, &at);
    } else if (strcmp(class, "stroke") == 0) {
        if (mode == GOP_REQ)
            greq_stroke(WS, 1, &status, &transformation, &stroke);
        else if (mode == GOP_SAMPLE)
            gsample_stroke(WS, 1, &transformation, &stroke);
        else
            gget_stroke(&transformation, &stroke);
    } else if (strcmp(class, "valuator") == 0) {
        if (mode == GOP_REQ)
            greq_val(WS, 1, &status, &value);
        else if (mode == GOP_SAMPLE)
            gsample_val(WS, 1, &value);
        else
            gget_val(&value);
    } else if (strcmp(class, "choice") == 0) {
        if (mode == GOP_REQ)
            greq_choice(WS, 1, &status, &number);
        else if (mode == GOP_SAMPLE)
            gsample_choice(WS, 1, &status, &number);
        else
            gget_choice(&status, &number);
    } else if (strcmp(class, "pick") == 0) {
        if (mode == GOP_REQ)
            greq_pick(WS, 1, &status, &pick);
        else if (mode == GOP_SAMPLE)
            gsample_pick(WS, 1, &status, &pick);
        else
            gget_pick(&status, &pick);
    } else if (mode == GOP_REQ)
        greq_string(WS, 1, &status, string);
    else if (mode == GOP_SAMPLE)
        gsample_string(WS, 1, string);
    else
        gget_string(string);

    snprintf(words, size, "%s %s", class, statuses[status]);
    if (status != GIN_STATUS_OK)
        return;
    length = strlen(words);
    words += length;
    size -= length;
    if (strcmp(class, "locator") == 0)
        snprintf(words, size, " %.2f %.2f", at.x, at.y);
    else if (strcmp(class, "valuator") == 0)
        snprintf(words, size, " %.2f", value);
    else if (strcmp(class, "choice") == 0)
        snprintf(words, size, " %d", number);
    else if (strcmp(class, "pick") == 0)
        snprintf(words, size, " %d %d", pick.seg_name, pick.pick_id);
    else if (strcmp(class, "string") == 0)
        snprintf(words, size, " %s", string);
    else
        for (i = 0; i < stroke.num_points; i++) {
            length = (size_t) snprintf(words, size, " %.2f %.2f", points[i].x, points[i].y);
            if (length >= size)
                return;
            words += length;
            size -= length;
        }
}

static void sample(const char *class)
{
    static const struct timespec moment = {0, 20000000};
    char first[400], now[400];
    int patience;
    enter(first, sizeof first, class, GOP_SAMPLE);
    for (patience = 1000; patience > 0; patience--) {
        enter(now, sizeof now, class, GOP_SAMPLE);
        if (strcmp(first, now) != 0 || strncmp(now, "pick ok", 7) == 0)
            break;
        nanosleep(&moment, NULL);
    }
    say(now);
}

static void event(void)
{
    char words[400] = "none";
    Gin_class class;
    Gint ws, device;
    gawait_event(20.0, &ws, &class, &device);
    if (class != GIN_NONE)
        enter(words, sizeof words, classes[class], GOP_EVENT);
    say(words);
}

int main(int count, char **arguments)
{
    static const Glimit window = {0, 10, 0, 10}, viewport = {0, 1, 0, 1};
    Glimit wanted, shown, asked;
    Gupd_st update;
    Gint error;
    int i, class;

    if (count < 2 || (results = fopen(arguments[1], "w")) == NULL)
        return 2;
    gopen_gks(NULL, GDEF_MEM_SIZE);
    gopen_ws(WS, NULL, 0);
    /* The workstation viewport is the whole display surface. */
    ginq_ws_tran(WS, &error, &update, &wanted, &shown, &asked, &display);
    gactivate_ws(WS);
    gset_win(1, &window);
    gset_vp(1, &viewport);
    gsel_norm_tran(1);
    gset_vp_in_pri(1, 0, GPRI_HIGHER);
    draw();
    say("drawn");
    for (i = 2; i < count; i++) {
        char words[400], *mode = strtok(arguments[i], ":"), *name = strtok(NULL, ":"), *prompt = strtok(NULL, ":");
        int kind = prompt ? atoi(prompt) : 1, all = name && strcmp(name, "all") == 0;
        if (name == NULL)
            return 2;
        for (class = 1; class <= 6; class++)
            if (all || strcmp(name, classes[class]) == 0)
                initialise(classes[class], all && class == 4 ? 3 : kind);
        if (strcmp(mode, "request") == 0) {
            enter(words, sizeof words, name, GOP_REQ);
            say(words);
            continue;
        }
        for (class = 1; class <= 6; class++)
            if (all || strcmp(name, classes[class]) == 0)
                set_mode(classes[class], strcmp(mode, "sample") == 0 ? GOP_SAMPLE : GOP_EVENT);
        if (strcmp(mode, "sample") == 0)
            sample(name);
        else
            for (class = 1; class <= (all ? 6 : 1); class++)
                event();
        for (class = 1; class <= 6; class++)
            set_mode(classes[class], GOP_REQ);
    }
    gdeactivate_ws(WS);
    gclose_ws(WS);
    gclose_gks();
    say("closed");
    fclose(results);
    return 0;
}
