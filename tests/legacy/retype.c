/* Preloaded under the original GKS of NCAR Graphics: opens a PostScript workstation (type 20) where a program
   asks for a metafile (type 1), so that the same binary draws something that can be looked at, and upright PostScript in the place of that on
   landscape paper (types 26 to 31), so that all pictures stand alike. With RETYPE, the number of a
   workstation type, that type is opened in the place of all but segment storage (type 3). */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stddef.h>
#include <stdlib.h>

void gopwk_(const int *wkid, const int *conid, const int *type)
{
    const char *all = getenv("RETYPE");
    int chosen = *type;
    void (*original)(const int *, const int *, const int *) = dlsym(RTLD_NEXT, "gopwk_");
    if (all && *type != 3)
        chosen = atoi(all);
    else if (*type == 1)
        chosen = 20;
    else if (*type >= 26 && *type <= 31)
        chosen = *type - 6;
    original(wkid, conid, &chosen);
}

/* ESCAPE, but for -1521, which places the picture on the paper and partly beside it: what is compared is the unit square,
   which so stays where it is looked for. */
void gesc_(const int *id, const int *lines, const char *in, const int *room, int *used, char *out, size_t in_length,
           size_t out_length)
{
    void (*original)(const int *, const int *, const char *, const int *, int *, char *, size_t, size_t) =
        dlsym(RTLD_NEXT, "gesc_");
    if (*id != -1521)
        original(id, lines, in, room, used, out, in_length, out_length);
}
