/* What the usual error handling writes, to the standard error output and to a file. */
#include "check.h"

#include <stdio.h>

int main(void)
{
    gclose_gks();
    gopen_gks("no such folder/errors", 0);
    gopen_gks(GDEF_ERR_FILE, GDEF_MEM_SIZE);
    gset_linetype(0);
    gclose_gks();
    gopen_gks("errors", GDEF_MEM_SIZE);
    gset_char_ht(-1.5);
    gerr_log(92, Gfn_set_fill_colr_ind, "other");
    gerr_log(93, -1, NULL);
    gclose_gks();
    gopen_gks("/dev/stdout", GDEF_MEM_SIZE);
    printf("first: a line of the program\n");
    gset_marker_type(0);
    gclose_gks();
    return finish();
}
