/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command animate: cycles as they run in time, into a file. */
#ifndef SHELL_FILM_H
#define SHELL_FILM_H

#include "interpreter/command.h"

extern const struct column film_columns[];
/* Returns how many cycles one picture can show: the first head can still be seen, and the film has an end. */
int film_most(const struct session *session);

bool film_run(struct session *session, const struct call *call);

#endif
