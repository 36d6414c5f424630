/* List inquiries give parts of their lists. */
#include "check.h"

static void open_workstations(void)
{
    Gint error, length, i, numbers[6];
    Gint_list list;

    list.ints = numbers;
    ginq_set_open_wss(6, 0, &error, &list, &length);
    CHECK(error == 0 && list.num_ints == 0 && length == 0);
    for (i = 1; i <= 5; i++)
        WORKS(gopen_ws(i * 11, NULL, 100));
    WORKS(gactivate_ws(22));
    WORKS(gactivate_ws(44));
    ginq_set_open_wss(6, 0, &error, &list, &length);
    CHECK(error == 0 && list.num_ints == 5 && length == 5 && numbers[0] == 11 && numbers[4] == 55);
    for (i = 0; i < 6; i++)
        numbers[i] = -7;
    ginq_set_open_wss(2, 1, &error, &list, &length);
    CHECK(error == 0 && list.num_ints == 2 && length == 5);
    CHECK(numbers[0] == 22 && numbers[1] == 33 && numbers[2] == -7);
    ginq_set_open_wss(6, 4, &error, &list, &length);
    CHECK(error == 0 && list.num_ints == 1 && length == 5 && numbers[0] == 55 && numbers[1] == 33);
    /* The length alone. */
    ginq_set_open_wss(0, 0, &error, &list, &length);
    CHECK(error == 0 && list.num_ints == 0 && length == 5);
    list.ints = NULL;
    ginq_set_open_wss(6, 0, &error, &list, &length);
    CHECK(error == 0 && list.num_ints == 0 && length == 5);
    ginq_set_open_wss(6, 0, &error, NULL, &length);
    CHECK(error == 0 && length == 5);
    list.ints = numbers;
    /* There is no element at the start position, or there cannot be that much room. */
    list.num_ints = length = 77;
    ginq_set_open_wss(6, 5, &error, &list, &length);
    CHECK(error == 2201 && list.num_ints == 0 && length == 0);
    ginq_set_open_wss(6, -1, &error, &list, &length);
    CHECK(error == 2201);
    ginq_set_open_wss(-1, 0, &error, &list, &length);
    CHECK(error == 2203);
    ginq_set_active_wss(6, 0, &error, &list, &length);
    CHECK(error == 0 && length == 2 && numbers[0] == 22 && numbers[1] == 44);
    WORKS(gemergency_close_gks());
    list.num_ints = length = 77;
    ginq_set_open_wss(-1, 0, &error, &list, &length);
    CHECK(error == 8 && list.num_ints == 0 && length == 0);
}

static void others(void)
{
    Gint error, length, i, last, numbers[300];
    Gint_list list;
    Gws_cat category;

    list.ints = numbers;
    ginq_list_avail_ws_types(300, 0, &error, &list, &length);
    CHECK(error == 0 && length == list.num_ints && length > 10);
    for (i = 0; i < length; i++) {
        ginq_ws_cat(numbers[i], &error, &category);
        CHECK(error == 0);
    }
    WORKS(gset_vp_in_pri(7, 0, GPRI_HIGHER));
    ginq_max_norm_tran_num(&error, &last);
    ginq_list_norm_tran_nums(300, 0, &error, &list, &length);
    CHECK(error == 0 && length == last + 1 && numbers[0] == 7 && numbers[1] == 0 && numbers[7] == 6);
    CHECK(numbers[8] == 8 && numbers[last] == last);
    REPORTS(2202, Gfn_set_vp_in_pri, gset_vp_in_pri(7, 0, (Grel_pri) 2));
    ginq_set_seg_names(300, 0, &error, &list, &length);
    CHECK(error == 7 && length == 0);
    WORKS(gopen_ws(1, NULL, 100));
    ginq_set_seg_names(300, 0, &error, &list, &length);
    CHECK(error == 0 && length == 0);
    WORKS(gclose_ws(1));
}

int main(void)
{
    gset_err_hand(remember, NULL);
    WORKS(gopen_gks("errors", GDEF_MEM_SIZE));
    open_workstations();
    WORKS(gopen_gks("errors", GDEF_MEM_SIZE));
    others();
    WORKS(gclose_gks());
    return finish();
}
