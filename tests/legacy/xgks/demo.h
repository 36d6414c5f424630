/* What the demonstration programs of XGKS include beside xgks.h: colour indices, and what they do at the end,
 * where somebody would press a button in their window. Pictures in files need nobody. */
#ifndef DEMO_H
#define DEMO_H

enum { WHITE = 1, RED, GREEN, BLUE, YELLOW, CYAN, VIOLET, SILVER, BEIGE, DARKGREEN };

#define WaitForBreak(ws_id) gupdatews(ws_id, GPERFORM)

#endif
