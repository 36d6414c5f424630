/* Preloaded under the original GKS of NCAR Graphics: opens a PostScript workstation (type 20) where a program
   asks for a metafile (type 1), so that the same binary draws something that can be looked at. */
#define _GNU_SOURCE
#include <dlfcn.h>

void gopwk_(const int *wkid, const int *conid, const int *type)
{
    static const int postscript = 20;
    void (*original)(const int *, const int *, const int *) = dlsym(RTLD_NEXT, "gopwk_");
    original(wkid, conid, *type == 1 ? &postscript : type);
}
