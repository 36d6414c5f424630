/* A program of XGKS with an error handling function of its own: the numbers of the functions are those of XGKS. */
#include <xgks.h>
#include <stdio.h>

static Gint last_error, last_function, calls;

Gint gerrorhand(Gint error, Gint function, Gfile *file)
{
    (void)file;
    last_error = error;
    last_function = function;
    calls++;
    return 0;
}

/* Whether the function has returned an error, and the handler has got it with a function. */
static int is(Gint result, Gint error, Gint function)
{
    if (result == error && last_error == error && last_function == function)
        return 1;
    printf("result %d, error %d of function %d, not %d of %d\n", result, last_error, last_function, error, function);
    return 0;
}

int main(void)
{
    static Gpoint line[2] = {{0.0f, 0.0f}, {1.0f, 1.0f}};
    static Gsegattr attributes;
    int good = is(gpolyline(2, line), 5, 17);

    good += is(gopenws(1, "errors.png", "MO"), 8, errgopenws);
    good += is(gsetsegattr(1, &attributes), 7, 74);
    gopengks(stderr, 0);
    good += is(gsetcharheight(-1.0f), 78, 36);
    good += is(gclosews(5), 7, errgclosews);
    good += is(gselntran(-1), 50, 57);
    gclosegks();
    if (good != 6 || calls != 6)
        return 1;
    /* The name of the first function, that of the last, and none. */
    gerrorlog(1, errgopengks, stdout);
    gerrorlog(8, errginqwstran, stdout);
    gerrorlog(8, errginqwstran + 1, stdout);
    puts("good");
    return 0;
}
