/* A program sets an error handler of its own and gives it back. */
#include "check.h"

#include <string.h>

typedef void (*handler)(Gint, Gint, const char *);

static int calls, inner;
static Gint last_error, last_function;
static char last_file[80];

static void second(Gint error, Gint function, const char *file)
{
    (void) error;
    (void) function;
    (void) file;
    inner++;
}

static void first(Gint error, Gint function, const char *file)
{
    Gint indicator = -1, type = -1;
    Gop_st state;

    calls++;
    last_error = error;
    last_function = function;
    strncpy(last_file, file ? file : "(null)", sizeof last_file - 1);
    /* Inquiries work here, other functions have no effect and report nothing. */
    ginq_op_st(&state);
    ginq_linetype(&indicator, &type);
    CHECK(state == GST_GKOP && indicator == 0 && type == 2);
    gset_linetype(3);
    gset_linetype(0);
    ginq_linetype(&indicator, &type);
    CHECK(indicator == 0 && type == 2);
    gerr_log(error, function, file);
}

static void closing(Gint error, Gint function, const char *file)
{
    calls++;
    (void) file;
    CHECK(error == 92 && function == Gfn_set_line_colr_ind);
    gemergency_close_gks();
}

int main(void)
{
    handler usual = NULL, old = NULL;
    Gop_st state;

    gset_err_hand(first, &usual);
    CHECK(usual == gerr_hand);
    gopen_gks("errors", GDEF_MEM_SIZE);
    gset_linetype(2);
    CHECK(calls == 0);
    gset_linetype(0);
    CHECK(calls == 1 && last_error == 63 && last_function == Gfn_set_linetype);
    CHECK(strcmp(last_file, "errors") == 0);
    gset_char_ht(-1.5);
    CHECK(calls == 2 && last_error == 78 && last_function == Gfn_set_char_ht);
    gset_err_hand(second, &old);
    CHECK(old == first);
    gset_linetype(0);
    CHECK(calls == 2 && inner == 1);
    /* The usual handler again, which logs; the same for no handler. */
    gset_err_hand(usual, NULL);
    gset_marker_type(0);
    gset_err_hand(NULL, &old);
    CHECK(old == usual);
    gset_text_ind(0);
    CHECK(calls == 2 && inner == 1);
    gset_err_hand(closing, NULL);
    gset_line_colr_ind(-1);
    CHECK(calls == 3);
    ginq_op_st(&state);
    CHECK(state == GST_GKCL);
    return finish();
}
