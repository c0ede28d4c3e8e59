/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Pictures, drawn by gnuplot: a command writes a script, and the picture goes where its answer goes: as
 * text into the terminal, or into the file behind '>', whose name says as what.
 */
#ifndef SHELL_PICTURE_H
#define SHELL_PICTURE_H

#include "session.h"

struct picture {
    FILE *script; /* of gnuplot; its terminal is set, its lines and points are such as black ink can tell */
    bool text;    /* drawn in characters */
};

/* False: an error was reported. */
bool picture_begin(struct session *session, struct picture *picture);

/* Draws and closes; false: an error was reported. */
bool picture_end(struct session *session, struct picture *picture);

#endif
