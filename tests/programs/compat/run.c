/* A program of XGKS that draws in a window and ends as its argument says: with a status, or by a signal. */
#include <xgks.h>

#include <signal.h>
#include <stdlib.h>
#include <string.h>

int main(int count, char **arguments)
{
    Gpoint line[] = {{0.0f, 0.0f}, {1.0f, 1.0f}};

    gopengks(stderr, 0);
    gopenws(1, NULL, NULL);
    gactivatews(1);
    gpolyline(2, line);
    gdeactivatews(1);
    gclosews(1);
    gclosegks();
    if (count > 1 && strcmp(arguments[1], "signal") == 0)
        raise(SIGTERM);
    return count > 1 ? atoi(arguments[1]) : 0;
}
