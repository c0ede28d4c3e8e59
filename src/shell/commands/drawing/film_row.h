/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef SHELL_FILM_ROW_H
#define SHELL_FILM_ROW_H

#include "commands/drawing/draw_words.h"

/* Makes the animation of the session's row, or its data. False: an error was reported. */
bool animate_row(const struct query *query, struct answer *a, struct problem *problem,
                 const struct film_what *what);

#endif
