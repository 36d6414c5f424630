/* Output that meets a fault: the argument says which. */
#include <gks.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

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
static void pipe_closed(int type, int count)
{
    gopen_ws(1, "-", type);
    gopen_ws(2, "whole.svg", 200);
    gactivate_ws(1);
    gactivate_ws(2);
    lines(count);
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

/* Three complete pictures and a piece of the fourth in one metafile. */
static void killed_metafile(int type)
{
    int page;
    gopen_ws(1, "pictures", type);
    gactivate_ws(1);
    for (page = 1; page <= 3; page++) {
        lines(10);
        gclear_ws(1, GFLAG_COND);
    }
    lines(20000);
    raise(SIGKILL);
}

/* No file may become larger than a few octets from now on. */
static void limit_files(void)
{
    struct rlimit limit = {512, 512};
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limit);
}

/* A picture for which there is no room, in a file or on a device that is full, and one that is complete before. */
static void full(const char *name, int type, int limited)
{
    gopen_ws(1, "before.svg", 200);
    gactivate_ws(1);
    lines(3);
    gdeactivate_ws(1);
    gclose_ws(1);
    if (limited)
        limit_files();
    gopen_ws(2, name, type);
    gactivate_ws(2);
    lines(100);
    gdeactivate_ws(2);
    gclose_ws(2);
}

int main(int argc, char **argv)
{
    int type = argc > 2 ? atoi(argv[2]) : 0;
    gopen_gks("errors", GDEF_MEM_SIZE);
    if (strcmp(argv[1], "pipe") == 0) {
        pipe_closed(type, argc > 3 ? atoi(argv[3]) : 20000);
    } else if (strcmp(argv[1], "metafile") == 0) {
        killed_metafile(type);
    } else if (strcmp(argv[1], "full") == 0) {
        full("/dev/full?size=300x300", type, 0);
    } else if (strcmp(argv[1], "limit") == 0) {
        full("picture?size=300x300", type, 1);
    } else {
        killed();
    }
    gclose_gks();
    return 0;
}
