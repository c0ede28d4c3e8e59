/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures that gnuplot draws from a script. */
#ifndef SHELL_PICTURE_H
#define SHELL_PICTURE_H

#include "session/problem.h"
#include <signal.h>
#include <stdio.h>

struct picture {
    FILE *script; /* of gnuplot; its terminal is set */
    FILE *out;    /* takes the picture */
    const volatile sig_atomic_t *interrupt;
};

/* Reports an error if there is no gnuplot. */
bool gnuplot_ready(struct problem *problem);

/* Begins a picture on a stream, by a terminal of gnuplot with its options. False: an error was reported. */
bool picture_begin(struct picture *picture, FILE *out, const char *terminal,
                   const volatile sig_atomic_t *interrupt, struct problem *problem);

/* Closes; draws, if the script is whole.  False: it is not, or an error was reported. */
bool picture_end(struct picture *picture, bool whole, struct problem *problem);

/* Returns true if there is a program of this name in one of the folders of PATH. */
bool program_there(const char *name);

/* Runs a program from one file to another; its complaints go into a third. Returns 0, errno, or -1 if it
 * failed. */
int program_run(char *const argv[], FILE *in, FILE *out, FILE *complaints,
                const volatile sig_atomic_t *interrupt);

/* Describes that program_run returned something but 0: "cannot run NAME", or "NAME did not WHAT" with its
 * first complaint. Returns false. */
bool program_failed(const char *name, int wrong, FILE *complaints, const char *what,
                    const volatile sig_atomic_t *interrupt, struct problem *problem);

#endif
