#include "check.h"

#include <math.h>
#include <stdio.h>

static int faults, errors;
static Gint first_error, first_function;

void check(int good, const char *what, const char *file, int line)
{
    if (!good) {
        faults++;
        printf("%s:%d: not so: %s\n", file, line, what);
    }
}

void forget(void)
{
    errors = 0;
    first_error = first_function = 0;
}

void remember(Gint error, Gint function, const char *file)
{
    (void) file;
    if (errors++ == 0) {
        first_error = error;
        first_function = function;
    }
}

void reported(Gint error, Gint function, const char *what, const char *file, int line)
{
    int good = error == 0 ? errors == 0 : errors == 1 && first_error == error && first_function == function;
    if (!good) {
        faults++;
        printf("%s:%d: %s: %d errors, the first is %d of function %d, not %d of %d\n", file, line, what, errors,
               first_error, first_function, error, function);
    }
}

int near(double a, double b)
{
    return fabs(a - b) <= 1e-5 * fmax(1.0, fmax(fabs(a), fabs(b)));
}

void open_all(void)
{
    gset_err_hand(remember, NULL);
    WORKS(gopen_gks("errors", GDEF_MEM_SIZE));
    WORKS(gopen_ws(1, "picture.png?size=100x100", 100));
    WORKS(gactivate_ws(1));
}

void close_all(void)
{
    WORKS(gdeactivate_ws(1));
    WORKS(gclose_ws(1));
    WORKS(gclose_gks());
}

int finish(void)
{
    if (faults == 0)
        puts("good");
    return faults != 0;
}
