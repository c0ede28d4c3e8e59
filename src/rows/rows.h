/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Types and functions that the files in this directory share, and the commands that are defined in them. */
#ifndef SHELL_ROWS_H
#define SHELL_ROWS_H

#include "interpreter/question.h"
#include "train/falling.h"

extern const struct column fall_columns[], verdict_columns[], mend_columns[], tolerance_columns[],
    slip_columns[];
bool run_fall(const struct query *query, struct answer *a, struct problem *problem);
bool run_verdict(const struct query *query, struct answer *a, struct problem *problem);
bool run_mend(const struct query *query, struct answer *a, struct problem *problem);
bool run_tolerance(const struct query *query, struct answer *a, struct problem *problem);
bool run_slip(const struct query *query, struct answer *a, struct problem *problem);

/* The parts of 'change', 'place', 'remove' and 'insert' (change.c). */
bool change_parse_dominoes(struct reader *reader, struct question *question);
bool change_parse_value(struct reader *reader, struct question *question);
bool change_bind(const struct question *question, const struct query *query, struct arguments *given,
                 struct problem *problem);
bool remove_bind(const struct question *question, const struct query *query, struct arguments *given,
                 struct problem *problem);
bool run_change(const struct query *query, struct answer *a, struct problem *problem);
bool run_remove(const struct query *query, struct answer *a, struct problem *problem);
bool run_insert(const struct query *query, struct answer *a, struct problem *problem);

/* Lists the dominoes of the row as 'row' does: all, or only one, counted from 1, if `only` is not 0. */
bool row_list(const struct query *query, size_t only, struct answer *a, struct problem *problem);

/* ---- The windows of a row: how inaccurate each domino may be before the row stops ---- */

enum { WINDOW_KINDS = DOM_WINDOW_THICKNESS + 1 };

struct windows {
    const struct scene_row *scene;
    size_t count; /* the number of dominoes */
    /* An array of windows for each kind of window. For example, kind[DOM_WINDOW_HEIGHT][2] is the window of
     * the height of the third domino. All dominoes have the same friction, so there is only one window for
     * it: kind[DOM_WINDOW_FRICTION][0]. */
    struct dom_window *kind[WINDOW_KINDS];
    /* For each kind, the number of a domino, counted from 1, or 0. If the row falls, it has the tightest
     * limits of all dominoes. If the row does not fall, it needs the smallest change to save the row. */
    size_t critical[WINDOW_KINDS];
    bool falls;
};

/* Finds all windows of the row, in parallel. Even after a failure, the caller frees w->kind[0],
 * which holds all windows. */
enum dom_status windows_find(const struct query *query, const struct scene_row *scene, struct windows *w);

#endif
