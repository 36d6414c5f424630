/* A program that closes nothing. */
#include <gks.h>
#include <stdio.h>

int main(void)
{
    Gpoint points[2] = {{0.1f, 0.1f}, {0.9f, 0.9f}};
    Gpoint_list list = {2, points};

    gopen_gks(GDEF_ERR_FILE, GDEF_MEM_SIZE);
    gopen_ws(1, "forgotten.svg", 200);
    gactivate_ws(1);
    gpolyline(&list);
    puts("good");
    return 0;
}
