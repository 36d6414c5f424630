/* A metafile is written, read item by item and interpreted. */
#include "check.h"
#include <string.h>

enum { GKSM = 2, MI = 3, OWN = 123 };

static const char own[] = "what only this program understands";

static void write_metafile(void)
{
    Gpoint points[3] = {{0.1f, 0.2f}, {0.5f, 0.8f}, {0.9f, 0.3f}};
    Gpoint_list list = {3, points};
    Gitem_data item;

    item.type = OWN;
    item.length = sizeof own;
    item.data.impl_dep.size = sizeof own;
    item.data.impl_dep.data = (void *)own;
    WORKS(gopen_ws(2, "c.gksm", GKSM));
    REPORTS(30, Gfn_write_item, gwrite_item(2, OWN, sizeof own, &item));
    WORKS(gactivate_ws(2));
    WORKS(gpolyline(&list));
    REPORTS(160, Gfn_write_item, gwrite_item(2, 100, sizeof own, &item));
    REPORTS(161, Gfn_write_item, gwrite_item(2, OWN, -1, &item));
    REPORTS(161, Gfn_write_item, gwrite_item(2, OWN, sizeof own + 1, &item));
    REPORTS(32, Gfn_write_item, gwrite_item(1, OWN, sizeof own, &item));
    WORKS(gwrite_item(2, OWN, sizeof own, &item));
    WORKS(gdeactivate_ws(2));
    WORKS(gclose_ws(2));
}

static void read_metafile(void)
{
    char room[400];
    Gitem_data item;
    Gint type = -1, length = -1, lines = 0, found = 0, items;

    item.data.impl_dep.size = sizeof room;
    item.data.impl_dep.data = room;
    WORKS(gopen_ws(3, "c.gksm", MI));
    REPORTS(33, Gfn_activate_ws, gactivate_ws(3));
    REPORTS(166, Gfn_read_item, gread_item(3, -1, &item));
    for (items = 0; type != 0 && items < 100; items++) {
        WORKS(gget_item_type(3, &type, &length));
        item.data.impl_dep.size = sizeof room;
        WORKS(gread_item(3, sizeof room, &item));
        CHECK(item.length == length);
        item.data.impl_dep.size = length;
        if (type == OWN) {
            found++;
            CHECK(length == sizeof own && strcmp(room, own) == 0);
            REPORTS(167, Gfn_interpret_item, ginterpret_item(type, length, &item));
        } else {
            lines += type == 11;
            WORKS(ginterpret_item(type, length, &item));
        }
    }
    CHECK(lines == 1 && found == 1 && items > 20);
    REPORTS(162, Gfn_get_item_type, gget_item_type(3, &type, &length));
    REPORTS(162, Gfn_read_item, gread_item(3, 1, &item));
    REPORTS(34, Gfn_get_item_type, gget_item_type(1, &type, &length));
    WORKS(gclose_ws(3));
}

int main(void)
{
    open_all();
    write_metafile();
    read_metafile();
    close_all();
    return finish();
}
