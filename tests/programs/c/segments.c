/* Segments, their attributes, and segment storage. */
#include "check.h"

#include <string.h>

#define WISS 1
#define NAMES 8

static const Gtran_matrix identity = {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
static const Gtran_matrix moved = {{2.0f, 0.5f, 0.1f}, {-0.25f, 3.0f, 0.2f}};

static void line(void)
{
    Gpoint points[2] = {{0.1f, 0.1f}, {0.9f, 0.9f}};
    Gpoint_list list = {2, points};

    WORKS(gpolyline(&list));
}

static void manipulation(void)
{
    Gint error, name, length, numbers[NAMES];
    Gint_list list = {0, numbers};
    Gop_st state;

    ginq_name_open_seg(&error, &name);
    CHECK(error == 4);
    WORKS(gcreate_seg(7));
    line();
    ginq_name_open_seg(&error, &name);
    CHECK(error == 0 && name == 7);
    REPORTS(3, Gfn_create_seg, gcreate_seg(8));
    REPORTS(125, Gfn_del_seg, gdel_seg(7));
    WORKS(grename_seg(7, 8));
    ginq_name_open_seg(&error, &name);
    CHECK(error == 0 && name == 8);
    ginq_op_st(&state);
    CHECK(state == GST_SGOP);
    WORKS(gclose_seg());
    REPORTS(4, Gfn_close_seg, gclose_seg());
    REPORTS(121, Gfn_create_seg, gcreate_seg(8));
    REPORTS(120, Gfn_create_seg, gcreate_seg(0));
    WORKS(gcreate_seg(3));
    WORKS(gclose_seg());
    ginq_set_seg_names(NAMES, 0, &error, &list, &length);
    CHECK(error == 0 && length == 2 && list.num_ints == 2 && numbers[0] == 3 && numbers[1] == 8);
    ginq_set_seg_names_ws(1, 1, 1, &error, &list, &length);
    CHECK(error == 0 && length == 2 && list.num_ints == 1 && numbers[0] == 3);
    ginq_set_seg_names_ws(1, 1, 2, &error, &list, &length);
    CHECK(error == 2201);
    WORKS(gdel_seg_ws(1, 3));
    REPORTS(123, Gfn_del_seg_ws, gdel_seg_ws(1, 3));
    REPORTS(122, Gfn_del_seg, gdel_seg(3));
    WORKS(gredraw_all_segs_ws(1));
}

static void attributes(void)
{
    Gint error, length;
    Gseg_attrs is;
    Gdyn_mod_seg_attrs how;

    ginq_seg_attrs(8, &error, &is);
    CHECK(error == 0 && memcmp(is.tran, identity, sizeof identity) == 0 && is.vis == GSEG_VIS);
    CHECK(is.highl == GSEG_NORM && is.pri == 0.0 && is.det == GSEG_UNDET);
    WORKS(gset_seg_tran(8, moved));
    WORKS(gset_vis(8, GSEG_INVIS));
    WORKS(gset_highl(8, GSEG_HIGHL));
    WORKS(gset_seg_pri(8, 0.75));
    WORKS(gset_det(8, GSEG_DET));
    ginq_seg_attrs(8, &error, &is);
    CHECK(error == 0 && memcmp(is.tran, moved, sizeof moved) == 0 && is.vis == GSEG_INVIS);
    CHECK(is.highl == GSEG_HIGHL && is.pri == 0.75 && is.det == GSEG_DET);
    REPORTS(126, Gfn_set_seg_pri, gset_seg_pri(8, 1.5));
    REPORTS(2202, Gfn_set_vis, gset_vis(8, 2));
    REPORTS(2200, Gfn_set_seg_tran, gset_seg_tran(8, NULL));
    REPORTS(122, Gfn_set_seg_tran, gset_seg_tran(9, moved));
    ginq_seg_attrs(9, &error, &is);
    CHECK(error == 122);
    ginq_num_seg_pris(100, &error, &length);
    CHECK(error == 0 && length == 0);
    ginq_dyn_mod_seg_attrs(100, &error, &how);
    CHECK(error == 0 && how.tran == GDYN_IRG && how.invis_vis == GDYN_IMM && how.del == GDYN_IRG);
    WORKS(gset_vis(8, GSEG_VIS));
}

static void storage(void)
{
    Gint error, length, numbers[NAMES];
    Gint_list list = {0, numbers};

    REPORTS(27, Gfn_copy_seg_ws, gcopy_seg_ws(1, 8));
    WORKS(gopen_ws(2, "", WISS));
    REPORTS(28, Gfn_open_ws, gopen_ws(3, "", WISS));
    REPORTS(124, Gfn_assoc_seg_ws, gassoc_seg_ws(1, 8));
    WORKS(gdeactivate_ws(1));
    WORKS(gactivate_ws(2));
    WORKS(gcreate_seg(5));
    line();
    WORKS(gclose_seg());
    WORKS(gcopy_seg_ws(1, 5));
    WORKS(gassoc_seg_ws(1, 5));
    ginq_set_assoc_wss(5, NAMES, 0, &error, &list, &length);
    CHECK(error == 0 && length == 2 && numbers[0] == 1 && numbers[1] == 2);
    WORKS(gactivate_ws(1));
    WORKS(gcreate_seg(6));
    WORKS(ginsert_seg(5, moved));
    REPORTS(125, Gfn_insert_seg, ginsert_seg(6, moved));
    WORKS(gclose_seg());
    WORKS(gdeactivate_ws(2));
    WORKS(gclose_ws(2));
    ginq_set_assoc_wss(5, NAMES, 0, &error, &list, &length);
    CHECK(error == 0 && length == 1 && numbers[0] == 1);
}

int main(void)
{
    open_all();
    manipulation();
    attributes();
    storage();
    WORKS(gclear_ws(1, GFLAG_ALWAYS));
    REPORTS(122, Gfn_del_seg, gdel_seg(8));
    close_all();
    return finish();
}
