/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Pictures, drawn by gnuplot: a command writes a script, and the picture goes where its answer goes: as
 * text into the terminal, or into the file behind '>', whose name says as what.
 */
#ifndef SHELL_PICTURE_H
#define SHELL_PICTURE_H

#include "session/session.h"

struct picture {
    FILE *script; /* of gnuplot; its terminal is set, its lines and points tell apart in black ink */
    FILE *out;    /* takes the picture */
    bool text;    /* drawn in characters */
    const char *theta, *omega; /* as its letters can show them */
};

/* False: an error was reported; that gnuplot is missing is one, found before there is work in vain. */
bool picture_begin(struct session *session, struct picture *picture);

/* The same for an animation of width x height dots, a plot command each frame, in hundredths of a second. */
bool picture_animation(struct session *session, struct picture *picture, FILE *out, int width, int height,
                       int delay);

/* Closes; draws, if the script is whole.  False: it is not, or an error was reported. */
bool picture_end(struct session *session, struct picture *picture, bool whole);

/* Returns true if a picture is drawn in characters: for the terminal, and for a file whose ending names no
 * kind of picture. */
bool picture_is_text(const struct session *session);

/* Finds the columns and rows of a picture in characters; the line of the next prompt is not counted. */
void picture_room(const struct session *session, int *width, int *height);

/* Does the train move, and come as far as theta?  False: an error was reported. */
bool picture_comes_to(struct session *session, domq_real theta);

#endif
