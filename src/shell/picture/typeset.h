/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Typesets documents with pdflatex. */
#ifndef SHELL_TYPESET_H
#define SHELL_TYPESET_H

#include "session/problem.h"
#include <signal.h>
#include <stdio.h>

/* Returns true if pdflatex is installed. Otherwise reports a problem. */
bool typeset_ready(struct problem *problem);

/* Typesets the TeX document in the stream `tex` and writes it to `out` as a PDF. On failure, sets *problem
 * and returns false. */
bool typeset(FILE *tex, FILE *out, const volatile sig_atomic_t *interrupt, struct problem *problem);

#endif
