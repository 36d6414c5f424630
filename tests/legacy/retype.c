/* Preloaded under the original GKS of NCAR Graphics: opens a PostScript workstation (type 20) where a program asks for a
   metafile (type 1), so that the same binary draws something that can be looked at, and upright PostScript in the place of
   that on landscape paper (types 26 to 31), so that all pictures stand alike. With RETYPE, the number of a workstation type,
   that type is opened in the place of all but segment storage (type 3), and the unit square is 1000 pixels or points wide. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

typedef void escape(const int *, const int *, const char *, const int *, int *, char *, size_t, size_t);

/* The escape that places the picture on the paper. */
static const int place = -1521;

/* ESCAPE, but for that one: what is compared is the unit square, which so stays where it is looked for. */
void gesc_(const int *id, const int *lines, const char *in, const int *room, int *used, char *out, size_t in_length,
           size_t out_length)
{
    escape *original = dlsym(RTLD_NEXT, "gesc_");
    if (*id != place)
        original(id, lines, in, room, used, out, in_length, out_length);
}

void gopwk_(const int *wkid, const int *conid, const int *type)
{
    const char *all = getenv("RETYPE");
    int chosen = *type;
    void (*original)(const int *, const int *, const int *) = dlsym(RTLD_NEXT, "gopwk_");
    if (all && *type != 3) {
        static const int line = 1, none = 0;
        int used;
        char record[81] = "", out[80];
        escape *place_it = dlsym(RTLD_NEXT, "gesc_");
        snprintf(record, sizeof record, "%10d%10d%10d%10d%40s", 0, 0, 1000, 1000, "");
        place_it(&place, &line, record, &none, &used, out, 80, 80);
        chosen = atoi(all);
    } else if (*type == 1)
        chosen = 20;
    else if (*type >= 26 && *type <= 31)
        chosen = *type - 6;
    original(wkid, conid, &chosen);
}
