/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures that gnuplot draws from a script, and other programs that help with it. */
#ifndef SHELL_PICTURE_H
#define SHELL_PICTURE_H

#include "session/problem.h"
#include <signal.h>
#include <stdio.h>

struct picture {
    FILE *script; /* what gnuplot is to do, after its terminal was set */
    FILE *out;    /* takes the picture */
    const volatile sig_atomic_t *interrupt;
};

/* Describes a problem and returns false if gnuplot is not installed. */
bool gnuplot_ready(struct problem *problem);

/* Begins a picture on a stream, with a terminal of gnuplot and its options. */
bool picture_begin(struct picture *picture, FILE *out, const char *terminal,
                   const volatile sig_atomic_t *interrupt, struct problem *problem);

/* Ends a picture. Draws it if the script is whole; else returns false. */
bool picture_end(struct picture *picture, bool whole, struct problem *problem);

/* Returns true if a program of this name is in one of the folders of PATH. */
bool program_exists(const char *name);

/* Runs a program that reads one file and writes another one. `what` says in a problem what the program did
 * not do: "draw it". */
bool program_run(char *const argv[], FILE *in, FILE *out, const char *what,
                 const volatile sig_atomic_t *interrupt, struct problem *problem);

#endif
