/* gks_extra.h: what the library offers to C programs beyond the standard. */
#ifndef GKS_EXTRA_H
#define GKS_EXTRA_H

#include <gks.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Copies the picture that a workstation with pixels shows.
 *
 * rgba      room for the pixels: 4 bytes each, red, green, blue and opacity, row by row from the top; null to
 *           ask for the dimensions only
 * size      the number of bytes there is room for
 * err_ind   0, or the errors of INQUIRE PIXEL ARRAY: 7, 20, 25, 39, 40 (the workstation has no pixels that
 *           could be read), or 2200 (there must be room for 4 * size_x * size_y bytes)
 * dims      the numbers of columns and rows, set unless the workstation has none
 */
void gks_frame_buffer(Gint ws_id, unsigned char *rgba, size_t size, Gint *err_ind, Gint_size *dims);

#ifdef __cplusplus
}
#endif

#endif
