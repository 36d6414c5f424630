/* Functions that are still to be built say so, and leave their results empty. */
#include "check.h"

#include <string.h>

#define NOT_BUILT (-3100)

static void segments(void)
{
    static const Gtran_matrix identity = {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
    Gint error, number = 77, length = 77;
    Gint_list list = {77, &number};
    Gseg_attrs attributes;

    REPORTS(NOT_BUILT, Gfn_create_seg, gcreate_seg(1));
    REPORTS(4, Gfn_close_seg, gclose_seg());
    REPORTS(NOT_BUILT, Gfn_set_seg_tran, gset_seg_tran(1, identity));
    REPORTS(NOT_BUILT, Gfn_set_seg_pri, gset_seg_pri(1, 0.5));
    ginq_set_seg_names_ws(1, 1, 0, &error, &list, &length);
    CHECK(error == NOT_BUILT && list.num_ints == 0 && list.ints == &number && number == 77 && length == 0);
    memset(&attributes, -1, sizeof attributes);
    ginq_seg_attrs(1, &error, &attributes);
    CHECK(error == NOT_BUILT && attributes.tran[1][2] == 0.0f && attributes.det == GSEG_UNDET);
}

static void input(void)
{
    Gint error, number = 77;
    Gin_status status = GIN_STATUS_OK;
    Gpoint place = {7.0f, 7.0f}, places[1] = {{7.0f, 7.0f}};
    Gpoint_list stroke = {77, places};
    Gloc_data *data = (Gloc_data *) &number;
    Gstore store = NULL;
    Gop_mode mode;
    Gecho_switch echo;
    Glimit area;
    char text[10] = "text";
    Gnum_in devices = {7, 7, 7, 7, 7, 7};

    REPORTS(NOT_BUILT, Gfn_req_loc, greq_loc(1, 1, &status, &number, &place));
    CHECK(status == GIN_STATUS_NONE && number == 0 && place.x == 0.0f && place.y == 0.0f);
    REPORTS(NOT_BUILT, Gfn_req_stroke, greq_stroke(1, 1, &status, &number, &stroke));
    CHECK(stroke.num_points == 0 && stroke.points == places && places[0].x == 7.0f);
    REPORTS(NOT_BUILT, Gfn_req_string, greq_string(1, 1, &status, text));
    CHECK(text[0] == '\0' && text[1] == 'e');
    REPORTS(NOT_BUILT, Gfn_flush_events, gflush_events(1, GIN_LOC, 1));
    REPORTS(NOT_BUILT, Gfn_set_val_mode, gset_val_mode(1, 1, GOP_REQ, GSWITCH_ECHO));
    ginq_loc_st(1, 1, GINQ_SET, &store, &error, &mode, &echo, &number, &place, NULL, &area, &data);
    CHECK(error == NOT_BUILT && data == NULL && mode == GOP_REQ && area.x_max == 0.0f);
    ginq_num_avail_in(100, &error, &devices);
    CHECK(error == NOT_BUILT && devices.loc == 0 && devices.string == 0);
}

int main(void)
{
    Gint error, number;

    gset_err_hand(remember, NULL);
    /* In a wrong operating state that is the error. */
    REPORTS(7, Gfn_req_loc, greq_loc(1, 1, NULL, NULL, NULL));
    ginq_name_open_seg(&error, &number);
    CHECK(error == 4);
    open_all();
    segments();
    input();
    close_all();
    return finish();
}
