/* Input from the operator of a scripted workstation, and the state of devices in stores. */
#include "check.h"

#include <string.h>

static Gstore store;
static const Glimit area = {0.0f, 0.1f, 0.0f, 0.05f};

static void requests(void)
{
    Gint transformation, number;
    Gin_status status;
    Gpoint place, places[512];
    Gpoint_list stroke = {0, places};
    Gdouble value;
    Gpick pick;
    char text[81];

    WORKS(greq_loc(1, 1, &status, &transformation, &place));
    CHECK(status == GIN_STATUS_OK && transformation == 1 && near(place.x, 5.0) && near(place.y, 2.0));
    WORKS(greq_loc(1, 2, &status, NULL, NULL));
    WORKS(greq_loc(1, 1, &status, &transformation, &place));
    CHECK(transformation == 0 && near(place.x, 1.0) && near(place.y, 0.0));
    WORKS(greq_loc(1, 1, &status, &transformation, &place));
    CHECK(status == GIN_STATUS_NONE);
    WORKS(greq_stroke(1, 1, &status, &transformation, &stroke));
    CHECK(status == GIN_STATUS_OK && stroke.num_points == 3 && near(places[2].y, 0.75));
    WORKS(greq_stroke(1, 1, &status, &transformation, &stroke));
    CHECK(transformation == 1 && stroke.points == places && near(places[1].x, 2.5));
    WORKS(greq_val(1, 1, &status, &value));
    CHECK(status == GIN_STATUS_OK && near(value, 0.25));
    WORKS(greq_val(1, 1, &status, &value));
    CHECK(near(value, 1.0));
    WORKS(greq_choice(1, 1, &status, &number));
    CHECK(status == GIN_STATUS_OK && number == 3);
    WORKS(greq_choice(1, 1, &status, &number));
    CHECK(status == GIN_STATUS_NO_IN);
    WORKS(greq_pick(1, 1, &status, &pick));
    CHECK(status == GIN_STATUS_NO_IN);
    WORKS(greq_string(1, 1, &status, text));
    CHECK(status == GIN_STATUS_OK && strcmp(text, "hello world") == 0);
    /* No more bytes than the buffer holds are set. */
    WORKS(ginit_string(1, 1, "", 1, &area, 2, 1, NULL));
    memset(text, 'x', sizeof text);
    WORKS(greq_string(1, 1, &status, text));
    CHECK(memcmp(text, "ab\0x", 4) == 0);
    REPORTS(140, Gfn_req_loc, greq_loc(1, 99, &status, &transformation, &place));
    CHECK(status == GIN_STATUS_NONE);
}

static void data_records(void)
{
    char *names[] = {"red", "green", "blue"};
    Gpr_switch prompts[] = {GPR_ON, GPR_OFF};
    Gint identifiers[] = {7, 8, 9};
    Gchoice_data choice, *kept;
    Gloc_data locator, *same;
    Gstroke_data stroke, *again;
    Gpoint points[] = {{0.25f, 0.5f}, {0.5f, 0.75f}}, place = {0.5f, 0.5f};
    Gpoint_list list = {2, points}, *initial;
    Gint error, number, transformation, pet, size;
    Gop_mode mode;
    Gecho_switch echo;
    Gin_status status;
    Glimit limits;

    choice.pets.pet_r3.num_strings = 3;
    choice.pets.pet_r3.strings = names;
    WORKS(ginit_choice(1, 1, GIN_STATUS_OK, 3, GCHOICE_STRING_PR, &area, &choice));
    ginq_choice_st(1, 1, &store, &error, &mode, &echo, &status, &number, &pet, &limits, &kept);
    CHECK(error == 0 && mode == GOP_REQ && echo == GSWITCH_ECHO && status == GIN_STATUS_OK && number == 3);
    CHECK(pet == GCHOICE_STRING_PR && near(limits.x_max, 0.1) && near(limits.y_max, 0.05));
    CHECK(kept->pets.pet_r3.num_strings == 3 && strcmp(kept->pets.pet_r3.strings[2], "blue") == 0);
    REPORTS(152, Gfn_init_choice, ginit_choice(1, 1, GIN_STATUS_OK, 4, GCHOICE_STRING_PR, &area, &choice));
    choice.pets.pet_r2.num_prompts = 2;
    choice.pets.pet_r2.prompts = prompts;
    WORKS(ginit_choice(1, 1, GIN_STATUS_NO_IN, 0, GCHOICE_PR_ECHO, &area, &choice));
    ginq_choice_st(1, 1, &store, &error, &mode, &echo, &status, &number, &pet, &limits, &kept);
    CHECK(status == GIN_STATUS_NO_IN && kept->pets.pet_r2.num_prompts == 2);
    CHECK(kept->pets.pet_r2.prompts[0] == GPR_ON && kept->pets.pet_r2.prompts[1] == GPR_OFF);
    choice.pets.pet_r5.seg_name = 5;
    choice.pets.pet_r5.num_pick_ids = 3;
    choice.pets.pet_r5.pick_ids = identifiers;
    WORKS(ginit_choice(1, 1, GIN_STATUS_OK, 3, GCHOICE_SEG, &area, &choice));
    ginq_choice_st(1, 1, &store, &error, &mode, &echo, &status, &number, &pet, &limits, &kept);
    CHECK(kept->pets.pet_r5.seg_name == 5 && kept->pets.pet_r5.pick_ids[2] == 9);

    memset(&locator, 0, sizeof locator);
    locator.pets.pet_r5.line_fill_ctrl_flag = GFLAG_FILL;
    locator.pets.pet_r5.attr_ctrl_flag = GFLAG_SPEC;
    locator.pets.pet_r5.attrs.fill_attrs.bundle.style_ind = -3;
    locator.pets.pet_r5.attrs.fill_attrs.bundle.colr_ind = 4;
    WORKS(ginit_loc(1, 1, 0, &place, GLOC_RECT, &area, &locator));
    ginq_loc_st(1, 1, GINQ_SET, &store, &error, &mode, &echo, &transformation, &place, &pet, &limits, &same);
    CHECK(error == 0 && same->pets.pet_r5.line_fill_ctrl_flag == GFLAG_FILL);
    CHECK(same->pets.pet_r5.attrs.fill_attrs.bundle.style_ind == -3);
    CHECK(same->pets.pet_r5.attrs.fill_attrs.bundle.colr_ind == 4);
    locator.pets.pet_r4.attr_ctrl_flag = GFLAG_SPEC;
    locator.pets.pet_r4.line_attrs.bundle.width = 2.5;
    WORKS(ginit_loc(1, 1, 0, &place, GLOC_RUB_BAND, &area, &locator));
    ginq_loc_st(1, 1, GINQ_SET, &store, &error, &mode, &echo, &transformation, &place, &pet, &limits, &same);
    CHECK(near(same->pets.pet_r4.line_attrs.bundle.width, 2.5));
    REPORTS(2200, Gfn_init_loc, ginit_loc(1, 1, 0, NULL, 1, &area, NULL));

    memset(&stroke, 0, sizeof stroke);
    stroke.init_pos = 2;
    stroke.x_interval = 0.25f;
    WORKS(ginit_stroke(1, 1, 0, &list, GSTROKE_DEF, &area, 8, &stroke));
    ginq_stroke_st(1, 1, GINQ_REALIZED, &store, &error, &mode, &echo, &transformation, &initial, &pet, &limits,
                   &size, &again);
    CHECK(error == 0 && size == 8 && initial->num_points == 2 && near(initial->points[1].y, 0.75));
    CHECK(again->init_pos == 2 && near(again->x_interval, 0.25));
    REPORTS(153, Gfn_init_stroke, ginit_stroke(1, 1, 0, &list, GSTROKE_DEF, &area, 1, &stroke));
}

static void descriptions(void)
{
    Gint error, most, size, cursor;
    Gint_list *prompts;
    Gnum_in devices;
    Gpoint place;
    Glimit limits;
    Gdouble value, low, high;
    Gloc_data *locator;
    Gval_data *valuator;
    Gstring_data *string;

    ginq_num_avail_in(530, &error, &devices);
    CHECK(error == 0 && devices.loc == 10 && devices.string == 10);
    ginq_num_avail_in(100, &error, &devices);
    CHECK(error == 38);
    ginq_def_loc_data(530, 1, &store, &error, &place, &prompts, &limits, &locator);
    CHECK(error == 0 && prompts->num_ints == 6 && prompts->ints[5] == 6 && near(limits.x_max, 0.2));
    ginq_def_val_data(530, 1, &store, &error, &value, &prompts, &limits, &low, &high, &valuator);
    CHECK(error == 0 && low < high && low <= value && value <= high && prompts->num_ints == 3);
    ginq_def_string_data(530, 1, &store, &error, &most, &prompts, &limits, &size, &cursor, &string);
    CHECK(error == 0 && most >= size && size >= 72 && cursor == 1);
    ginq_def_loc_data(530, 99, &store, &error, &place, &prompts, &limits, &locator);
    CHECK(error == 140 && prompts == NULL && locator == NULL);
}

static void events(void)
{
    Gint error, id, device, transformation, number;
    Gin_class class;
    Gin_status status;
    Gmore_simult_events more;
    Gpoint place;
    Gdouble value;

    WORKS(gset_loc_mode(1, 1, GOP_SAMPLE, GSWITCH_NO_ECHO));
    WORKS(gsample_loc(1, 1, &transformation, &place));
    CHECK(transformation == 1 && near(place.x, 2.0));
    WORKS(gset_loc_mode(1, 1, GOP_REQ, GSWITCH_ECHO));
    REPORTS(142, Gfn_sample_loc, gsample_loc(1, 1, &transformation, &place));
    WORKS(ginit_choice(1, 1, GIN_STATUS_NO_IN, 0, GCHOICE_DEF, &area, NULL));
    WORKS(gset_choice_mode(1, 1, GOP_EVENT, GSWITCH_ECHO));
    WORKS(gset_val_mode(1, 1, GOP_EVENT, GSWITCH_ECHO));
    REPORTS(150, Gfn_get_choice, gget_choice(&status, &number));
    WORKS(greq_loc(1, 2, &status, &transformation, &place));
    WORKS(gawait_event(0.0, &id, &class, &device));
    CHECK(id == 1 && class == GIN_CHOICE && device == 1);
    WORKS(gget_choice(&status, &number));
    CHECK(status == GIN_STATUS_OK && number == 1);
    WORKS(gawait_event(0.01, &id, &class, &device));
    CHECK(class == GIN_NONE);
    WORKS(gawait_event(60.0, &id, &class, &device));
    CHECK(class == GIN_VAL);
    WORKS(gget_val(&value));
    CHECK(near(value, 1.0));
    ginq_more_simult_events(&error, &more);
    CHECK(error == 0 && more == GSIMULT_MORE);
    WORKS(gflush_events(1, GIN_CHOICE, 1));
    ginq_more_simult_events(&error, &more);
    CHECK(more == GSIMULT_NO_MORE);
    WORKS(gawait_event(60.0, &id, &class, &device));
    CHECK(class == GIN_NONE);
    ginq_in_overf(&error, &id, &class, &device);
    CHECK(error == 148);
    REPORTS(2202, Gfn_flush_events, gflush_events(1, (Gin_class) 9, 1));
}

int main(void)
{
    static const Glimit window = {0.0f, 10.0f, 0.0f, 10.0f}, viewport = {0.0f, 0.5f, 0.0f, 0.5f};
    Gint error, number;

    gset_err_hand(remember, NULL);
    WORKS(gopen_gks(NULL, GDEF_MEM_SIZE));
    WORKS(gopen_ws(1, NULL, 530));
    gcreate_store(&error, &store);
    WORKS(gset_win(1, &window));
    WORKS(gset_vp(1, &viewport));
    WORKS(gset_vp_in_pri(1, 0, GPRI_HIGHER));
    requests();
    data_records();
    descriptions();
    events();
    WORKS(gset_pick_id(7));
    ginq_cur_pick_id(&error, &number);
    CHECK(error == 0 && number == 7);
    gdel_store(store);
    WORKS(gclose_ws(1));
    WORKS(gclose_gks());
    return finish();
}
