/* Opening and closing, operating states, and the errors of both. */
#include "check.h"

#include <string.h>

static Gop_st state(void)
{
    Gop_st value;
    ginq_op_st(&value);
    return value;
}

static void connection(void)
{
    Gint error, type;
    char text[80];

    WORKS(gopen_ws(1, "named.png?size=50x40", 100));
    ginq_ws_conn_type(1, sizeof text, &error, text, &type);
    CHECK(error == 0 && type == 100 && strcmp(text, "named.png?size=50x40") == 0);
    /* Text that does not fit is cut off. */
    memset(text, '#', sizeof text);
    ginq_ws_conn_type(1, 6, &error, text, &type);
    CHECK(error == 2200 && strcmp(text, "named") == 0 && text[6] == '#');
    ginq_ws_conn_type(1, 0, &error, text, &type);
    CHECK(error == 2200);
    ginq_ws_conn_type(1, 0, &error, NULL, &type);
    CHECK(error == 0 && type == 100);
    ginq_ws_conn_type(2, sizeof text, &error, text, &type);
    CHECK(error == 25);
    WORKS(gclose_ws(1));
    /* Without a connection the name is the library's choice. */
    WORKS(gopen_ws(1, NULL, 100));
    ginq_ws_conn_type(1, sizeof text, &error, text, &type);
    CHECK(error == 0 && text[0] == '\0');
    WORKS(gclose_ws(1));
}

static void deferral(void)
{
    Gint error;
    Gdefer_mode defer;
    Girg_mode irg;
    Gdisp_space_empty empty;
    Gnew_frame_nec_upd frame;
    Gpoint points[2] = {{0.1f, 0.1f}, {0.9f, 0.9f}};
    Gpoint_list list = {2, points};

    WORKS(gset_defer_st(1, GDEFER_BNIG, GIRG_ALLOWED));
    ginq_ws_defer_upd_sts(1, &error, &defer, &irg, &empty, &frame);
    CHECK(error == 0 && defer == GDEFER_BNIG && irg == GIRG_ALLOWED && empty == GDISP_EMPTY && frame == GNEW_NO);
    WORKS(gpolyline(&list));
    /* A program takes what it wants. */
    ginq_ws_defer_upd_sts(1, &error, NULL, NULL, &empty, NULL);
    CHECK(error == 0 && empty == GDISP_NOT_EMPTY);
    WORKS(gupd_ws(1, GFLAG_PERFORM));
    WORKS(gclear_ws(1, GFLAG_COND));
    ginq_ws_defer_upd_sts(1, &error, NULL, NULL, &empty, NULL);
    CHECK(empty == GDISP_EMPTY);
    REPORTS(2202, Gfn_set_defer_st, gset_defer_st(1, (Gdefer_mode) 4, GIRG_SUPPR));
    REPORTS(2202, Gfn_set_defer_st, gset_defer_st(1, GDEFER_ASAP, (Girg_mode) 2));
    REPORTS(2202, Gfn_clear_ws, gclear_ws(1, (Gctrl_flag) 2));
    REPORTS(2202, Gfn_upd_ws, gupd_ws(1, (Gupd_regen_flag) -1));
    REPORTS(25, Gfn_message, gmessage(5, "lost"));
}

static void metafiles(void)
{
    Gint type, length;
    Gitem_data item;

    memset(&item, 0, sizeof item);
    REPORTS(32, Gfn_write_item, gwrite_item(1, 101, 0, &item));
    REPORTS(30, Gfn_write_item, gwrite_item(2, 101, 0, &item));
    REPORTS(34, Gfn_get_item_type, gget_item_type(1, &type, &length));
    REPORTS(34, Gfn_read_item, gread_item(1, 10, &item));
    REPORTS(164, Gfn_interpret_item, ginterpret_item(-1, 0, &item));
    REPORTS(167, Gfn_interpret_item, ginterpret_item(101, 0, &item));
}

int main(void)
{
    CHECK(state() == GST_GKCL);
    gset_err_hand(remember, NULL);
    REPORTS(8, Gfn_open_ws, gopen_ws(1, NULL, 100));
    REPORTS(7, Gfn_upd_ws, gupd_ws(1, (Gupd_regen_flag) 7));
    REPORTS(2, Gfn_close_gks, gclose_gks());
    REPORTS(200, Gfn_open_gks, gopen_gks("no such folder/errors", 0));
    CHECK(state() == GST_GKCL);
    WORKS(gopen_gks(GDEF_ERR_FILE, GDEF_MEM_SIZE));
    REPORTS(1, Gfn_open_gks, gopen_gks("no such folder/errors", 0));
    CHECK(state() == GST_GKOP);
    REPORTS(23, Gfn_open_ws, gopen_ws(1, NULL, 31999));
    REPORTS(20, Gfn_open_ws, gopen_ws(0, NULL, 100));
    connection();
    CHECK(state() == GST_GKOP);
    WORKS(gclose_gks());

    open_all();
    CHECK(state() == GST_WSAC);
    REPORTS(29, Gfn_close_ws, gclose_ws(1));
    REPORTS(29, Gfn_activate_ws, gactivate_ws(1));
    deferral();
    metafiles();
    close_all();
    CHECK(state() == GST_GKCL);

    open_all();
    WORKS(gemergency_close_gks());
    CHECK(state() == GST_GKCL);
    return finish();
}
