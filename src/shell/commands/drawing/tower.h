/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 'draw tower' and 'animate FILE tower': the row of the last 'count', with the silhouette of a tower at its
 * end. */
#ifndef SHELL_TOWER_H
#define SHELL_TOWER_H

#include "commands/drawing/falling_row.h"

/* Makes the query about the row of the last 'count', and finds the height of the tower. *state becomes a
 * copy of the query's state, which borrows the memory of the original. Sets *problem and returns false if
 * there is no such answer. */
bool tower_query(const struct query *query, struct state *state, struct query *changed, double *height,
                 struct problem *problem);

/* Adds the tower behind the last domino and, above the small end of the row, a larger copy of the dominoes
 * that are too small to be seen. Returns false if memory runs out. */
bool tower_add(struct falling_row *row, double height);

/* Puts the tower behind the place where the last domino will lie, as stage.domino[stage.count]. Functions
 * that pose the row do not change the tower. A frame shows the tower only if the caller adds 1 to
 * stage.count. Returns false if memory runs out. */
bool tower_film(struct falling_row *row, double height);

#endif
