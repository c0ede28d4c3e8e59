/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tables of the command 'plan': places, sizes, and boards to cut. */
#ifndef SHELL_PLAN_TABLES_H
#define SHELL_PLAN_TABLES_H

#include "chance/chance.h"
#include "pictures/drawing/falling_row.h"
#include "pictures/picture/paper.h"

/* A row that falls, and what a builder must know about it. */
struct plan {
    struct falling_row row;
    struct windows windows;
    double *back; /* positions of the dominoes' back edges on the tape measure, in m */
    bool is_thin; /* the dominoes are hollow, and the thickness of their walls is not known */
    struct dom_study study;
    struct dom_random_error error[DOM_ERROR_COUNT];
    struct paper paper;
};

/* Returns the window for the place, the height or the thickness of domino k, counted from 0. As long as only
 * this value changes and stays in its window, all dominoes fall. */
const struct dom_window *plan_window(const struct plan *plan, enum dom_window_of kind, size_t k);

bool plan_has_leans(const struct plan *plan);

/* These functions write a table into plan->paper. plan_board_table returns false if memory runs out. */
void plan_tape_table(const struct plan *plan);
void plan_size_table(const struct plan *plan, const struct scene *scene);
bool plan_board_table(const struct plan *plan);

#endif
