/* Output that meets a fault: the argument says which. */
#include <gks.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

static void lines(int count)
{
    int i;
    for (i = 0; i < count; i++) {
        Gpoint points[2] = {{0.0, 0.0}, {1.0, 0.0}};
        Gpoint_list list = {2, points};
        points[1].y = (double) i / count;
        gpolyline(&list);
    }
}

/* Two pictures, one of them into a pipe that nobody reads. */
static void pipe_closed(void)
{
    gopen_ws(1, "-", 200);
    gopen_ws(2, "whole.svg", 200);
    gactivate_ws(1);
    gactivate_ws(2);
    lines(20000);
    gdeactivate_ws(1);
    gdeactivate_ws(2);
    gclose_ws(1);
    gclose_ws(2);
}

/* Three complete pages and a piece of the fourth. */
static void killed(void)
{
    int page;
    gopen_ws(1, "page.%d.png?size=50x50", 100);
    gopen_ws(2, "pages.svg", 200);
    gactivate_ws(1);
    gactivate_ws(2);
    for (page = 1; page <= 3; page++) {
        lines(10);
        gclear_ws(1, GFLAG_COND);
        gclear_ws(2, GFLAG_COND);
    }
    lines(20000);
    raise(SIGKILL);
}

int main(int argc, char **argv)
{
    (void) argc;
    gopen_gks("errors", GDEF_MEM_SIZE);
    if (strcmp(argv[1], "pipe") == 0)
        pipe_closed();
    else
        killed();
    gclose_gks();
    return 0;
}
