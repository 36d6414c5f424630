/* A program has error handling and error logging of its own, by the names of the binding. */
#include "check.h"

static Gint handled, logged;

void gerr_hand(Gint error, Gint function, const char *file)
{
    handled = error;
    gerr_log(error, function, file);
}

void gerr_log(Gint error, Gint function, const char *file)
{
    (void) file;
    logged = error;
    CHECK(function == Gfn_set_linetype);
}

int main(void)
{
    void (*old)(Gint, Gint, const char *) = NULL;

    gopen_gks("errors", GDEF_MEM_SIZE);
    gset_linetype(0);
    CHECK(handled == 63 && logged == 63);
    gset_err_hand(NULL, &old);
    CHECK(old == gerr_hand);
    gclose_gks();
    return finish();
}
