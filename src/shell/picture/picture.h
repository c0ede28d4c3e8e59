/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Pictures, drawn by gnuplot: a command writes a script. The picture goes where the answer of the command
 * goes: as text into the terminal, or into the file after '>', whose ending decides the format.
 */
#ifndef SHELL_PICTURE_H
#define SHELL_PICTURE_H

#include "session/query.h"

struct picture {
    /* of gnuplot; its terminal is set, and its lines and points can be distinguished in black ink */
    FILE *script;
    FILE *out;                 /* takes the picture */
    bool text;                 /* drawn in characters */
    const char *theta, *omega; /* as its letters can show them */
};

/* Returns true if there is a gnuplot. */
bool picture_possible(void);

/* Reports an error if the file after '>' cannot take a picture: without gnuplot, or after '>>'. */
bool picture_ready(struct answer *a, struct problem *problem);

/* Begins a picture. Returns false after an error, which also reports that gnuplot is missing, before any work
 * is done. */
bool picture_begin(struct answer *a, struct problem *problem, struct picture *picture);

/* The same for an animation of width x height dots, a plot command each frame, in hundredths of a second. */
bool picture_animation(struct problem *problem, struct picture *picture, FILE *out, int width, int height,
                       int delay);

/* The same for a picture on a stream, by a terminal of gnuplot with its options. */
bool picture_on(struct problem *problem, struct picture *picture, FILE *out, const char *terminal);

/* Closes; draws, if the script is whole.  False: it is not, or an error was reported. */
bool picture_end(const struct query *query, struct problem *problem, struct picture *picture, bool whole);

/* Returns true if a picture is drawn in characters: for the terminal, and for a file whose ending names no
 * kind of picture. */
bool picture_is_text(const struct answer *a);

/* Reports an error if the terminal is too small for the picture of a command; files have room. */
bool picture_fits(const struct answer *a, const char *command, struct problem *problem);

/* Finds the columns and rows of a picture in characters; the line of the next prompt is not counted. */
void picture_room(const struct answer *a, int *width, int *height);

/* Returns true if there is a program of this name in one of the folders of PATH. */
bool program_there(const char *name);

/* Runs a program from one file to another; its complaints go into a third. Returns 0, errno, or -1 if it
 * failed. */
int program_run(const struct query *query, char *const argv[], FILE *in, FILE *out, FILE *complaints);

/* Returns true if the train moves and reaches theta; false after an error. */
bool picture_comes_to(const struct query *query, struct problem *problem, domq_real theta);

#endif
