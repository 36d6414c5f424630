/* Checks of programs with the names of XGKS. */
#ifndef XGKS_CHECK_H
#define XGKS_CHECK_H

#include <xgks.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int faults;

static void check(int good, const char *what, const char *file, int line)
{
    if (!good) {
        faults++;
        printf("%s:%d: not so: %s\n", file, line, what);
    }
}

/* Says where a condition does not hold, where a function reports an error, and where it does not report just this one. */
#define CHECK(condition) check((condition) != 0, #condition, __FILE__, __LINE__)
#define WORKS(call) CHECK((call) == 0)
#define REPORTS(error, call) CHECK((call) == (error))

static int near(double a, double b)
{
    return fabs(a - b) <= 1e-5 * fmax(1.0, fmax(fabs(a), fabs(b)));
}

/* Says whether all was good; the result is the exit status. */
static int finish(void)
{
    if (faults == 0)
        puts("good");
    return faults != 0;
}

#endif
