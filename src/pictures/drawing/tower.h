/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 'draw tower' and 'animate tower': the row that the last 'count' found, with a tower at its end. */
#ifndef SHELL_TOWER_H
#define SHELL_TOWER_H

#include "pictures/drawing/falling_row.h"

/* A query about the row that the last 'count' found. One more domino, as tall as the tower, ends this row. */
struct tower {
    struct query query;
    struct state state; /* shares memory with the state of the original query */
    struct changed_domino *change;
    domq_real height; /* m */
};

/* On failure, sets *problem and returns false. Even then, the caller must free the tower. */
bool tower_make(const struct query *query, struct tower *tower, struct problem *problem);
void tower_free(struct tower *tower);

/* Adds an enlarged copy of dominoes that are too small to see. Returns false if memory runs out. */
bool tower_zoom(struct falling_row *row);

#endif
