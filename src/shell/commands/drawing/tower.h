/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 'draw tower' and 'animate FILE tower': the row that the last 'count' found, with a tower at its end. */
#ifndef SHELL_TOWER_H
#define SHELL_TOWER_H

#include "commands/drawing/falling_row.h"

/* Makes a query about the row that the last 'count' found, and stores it in *changed. Its state is *state: a
 * copy of the state of `query` with this row, which shares memory with the original. Sets *height to the
 * height of the tower in m. On failure, sets *problem and returns false. */
bool tower_query(const struct query *query, struct state *state, struct query *changed, double *height,
                 struct problem *problem);

/* Adds the tower, and an enlarged copy of dominoes that are too small to see. Returns false if memory runs
 * out. */
bool tower_add(struct falling_row *row, double height);

/* Places the tower beyond the reach of the falling dominoes and stores it in stage.domino[stage.count]. To
 * show the tower in a frame, add 1 to stage.count while the frame is drawn. Returns false if memory runs
 * out. */
bool tower_film(struct falling_row *row, double height);

#endif
