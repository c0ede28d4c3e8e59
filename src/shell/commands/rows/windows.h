/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The windows of a row: how far each domino may be off while all dominoes still fall. */
#ifndef SHELL_WINDOWS_H
#define SHELL_WINDOWS_H

#include "commands/rows/rows.h"

enum { WINDOW_KINDS = DOM_WINDOW_THICKNESS + 1 };

struct windows {
    const struct scene_row *scene;
    size_t count; /* the number of dominoes */
    /* For each kind of window, in the order of enum dom_window_of, the windows of all dominoes. There is only
     * one window of friction, which is the first element. */
    struct domq_window *kind[WINDOW_KINDS];
    /* For each kind, the number of the domino with the least room, or 0. If the row does not fall, it is the
     * domino that needs the smallest change. */
    size_t first[WINDOW_KINDS];
    bool falls;
};

/* Finds all windows of the row. The caller frees w->kind[0], which holds all of them. */
enum dom_status windows_find(const struct scene_row *scene, struct windows *w);

#endif
