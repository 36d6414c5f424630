/* Checks that say what is wrong, and an error handler that remembers what it is told. */
#ifndef CHECK_H
#define CHECK_H

#include <gks.h>

/* Says where a condition does not hold. */
#define CHECK(condition) check((condition) != 0, #condition, __FILE__, __LINE__)

/* Says where a call does not report just the error, of the function with an identifier of Gfn_...; 0 stands for
 * no error. The handler must be `remember`. */
#define REPORTS(error, function, call) \
    (forget(), (call), reported((error), (function), #call, __FILE__, __LINE__))

/* Says where a call reports an error. */
#define WORKS(call) REPORTS(0, 0, call)

void check(int good, const char *what, const char *file, int line);
void forget(void);
void reported(Gint error, Gint function, const char *what, const char *file, int line);

/* The error handler: keeps the first error. */
void remember(Gint error, Gint function, const char *file);

int near(double a, double b);

/* Makes the handler known, opens GKS and activates workstation 1 of type PNG, `picture.png`. */
void open_all(void);
void close_all(void);

/* Says whether all was good; the result is the exit status. */
int finish(void);

#endif
