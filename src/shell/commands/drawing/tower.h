/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 'draw tower' and 'animate FILE tower': the row of the last 'count', with the silhouette of a tower at its
 * end. */
#ifndef SHELL_TOWER_H
#define SHELL_TOWER_H

#include "commands/drawing/falling_row.h"

/* Sets *changed to a query about the row of the last 'count', and *height to the height of the tower. *state
 * receives the state for this query, which shares the memory of the original state. Sets *problem and returns
 * false if the last answer is not from 'count', or if there is no row to draw. */
bool tower_query(const struct query *query, struct state *state, struct query *changed, double *height,
                 struct problem *problem);

/* Adds the tower behind the last domino and, above the small end of the row, an enlarged copy of the dominoes
 * that are too small to be seen. Returns false if memory runs out. */
bool tower_add(struct falling_row *row, double height);

/* Stores the tower in stage.domino[stage.count], far enough to the right for the last domino to fall in front
 * of it. Functions that pose the row do not change the tower. A frame shows the tower only if the caller adds
 * 1 to stage.count. Returns false if memory runs out. */
bool tower_film(struct falling_row *row, double height);

#endif
