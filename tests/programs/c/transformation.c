/* Normalization and workstation transformations, clipping, matrices. */
#include "check.h"

static void normalization(void)
{
    Gint error, number;
    Glimit window = {-10.0f, 30.0f, 5.0f, 6.5f}, viewport = {0.25f, 0.5f, 0.125f, 1.0f}, flat = {1.0f, 1.0f, 0.0f, 1.0f};
    Gtran tran;
    Gclip clip;

    WORKS(gset_win(3, &window));
    WORKS(gset_vp(3, &viewport));
    WORKS(gsel_norm_tran(3));
    ginq_cur_norm_tran_num(&error, &number);
    CHECK(error == 0 && number == 3);
    ginq_norm_tran(3, &error, &tran);
    CHECK(error == 0 && tran.win.x_min == -10.0f && tran.win.y_max == 6.5f && tran.vp.x_max == 0.5f);
    WORKS(gset_clip_ind(GIND_NO_CLIP));
    ginq_clip(&error, &clip);
    CHECK(error == 0 && clip.clip_ind == GIND_NO_CLIP);
    WORKS(gset_clip_ind(GIND_CLIP));
    ginq_clip(&error, &clip);
    CHECK(error == 0 && clip.clip_ind == GIND_CLIP && clip.clip_rect.x_min == 0.25f && clip.clip_rect.y_min == 0.125f);
    REPORTS(51, Gfn_set_win, gset_win(3, &flat));
    REPORTS(50, Gfn_set_vp, gset_vp(0, &viewport));
    REPORTS(52, Gfn_set_vp, gset_vp(3, &window));
    REPORTS(50, Gfn_sel_norm_tran, gsel_norm_tran(-1));
    REPORTS(2202, Gfn_set_clip_ind, gset_clip_ind((Gclip_ind) 2));
    REPORTS(2200, Gfn_set_win, gset_win(3, NULL));
    ginq_norm_tran(-1, &error, &tran);
    CHECK(error == 50);
}

static void workstation(void)
{
    Gint error;
    Gupd_st pending;
    Glimit window = {0.0f, 0.5f, 0.25f, 0.75f}, viewport = {0.0f, 0.01f, 0.0f, 0.01f}, wide = {0.0f, 2.0f, 0.0f, 1.0f};
    Glimit wanted, shown, place, current;

    WORKS(gset_ws_win(1, &window));
    WORKS(gset_ws_vp(1, &viewport));
    ginq_ws_tran(1, &error, &pending, &wanted, &shown, &place, &current);
    CHECK(error == 0 && pending == GUPD_NOT_PEND && wanted.y_min == 0.25f && shown.x_max == 0.5f);
    CHECK(near(place.x_max, 0.01) && near(current.y_max, 0.01));
    REPORTS(53, Gfn_set_ws_win, gset_ws_win(1, &wide));
    REPORTS(54, Gfn_set_ws_vp, gset_ws_vp(1, &wide));
    REPORTS(25, Gfn_set_ws_vp, gset_ws_vp(5, &viewport));
}

static void matrices(void)
{
    Gpoint fixed = {1.0f, 0.0f};
    Gvec shift = {0.0f, 5.0f}, scale = {2.0f, 3.0f}, none = {0.0f, 0.0f}, one = {1.0f, 1.0f};
    Gtran_matrix matrix, both;
    /* ISO C has no conversion of an array to one of constant elements. */
    const Gfloat (*const first)[3] = (const Gfloat (*)[3]) matrix;

    /* Scaled about (1, 0), turned by a right angle, shifted: (x, y) goes to (1 - 3 y, 2 (x - 1) + 5). */
    WORKS(geval_tran_matrix(&fixed, &shift, 1.5707963267948966, &scale, GCOORD_NDC, matrix));
    CHECK(near(matrix[0][0], 0.0) && near(matrix[0][1], -3.0) && near(matrix[0][2], 1.0));
    CHECK(near(matrix[1][0], 2.0) && near(matrix[1][1], 0.0) && near(matrix[1][2], 3.0));
    /* The matrix comes first, the shift after it. */
    WORKS(gaccum_tran_matrix(first, &fixed, &shift, 0.0, &one, GCOORD_NDC, both));
    CHECK(near(both[0][2], 1.0) && near(both[1][0], 2.0) && near(both[1][2], 8.0));
    /* World coordinates are mapped by the current transformation: 40 units to 0.25. */
    WORKS(geval_tran_matrix(&(Gpoint){0.0f, 0.0f}, &(Gvec){40.0f, 0.0f}, 0.0, &one, GCOORD_WC, matrix));
    CHECK(near(matrix[0][2], 0.25) && near(matrix[1][2], 0.0));
    REPORTS(2202, Gfn_eval_tran_matrix, geval_tran_matrix(&fixed, &none, 0.0, &one, (Gcoord_switch) 2, matrix));
    REPORTS(2200, Gfn_accum_tran_matrix, gaccum_tran_matrix(NULL, &fixed, &none, 0.0, &one, GCOORD_NDC, both));
    CHECK(near(both[1][2], 8.0));
}

int main(void)
{
    open_all();
    normalization();
    workstation();
    matrices();
    close_all();
    return finish();
}
