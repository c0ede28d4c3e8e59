/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef SHELL_DRAW_ROW_H
#define SHELL_DRAW_ROW_H

#include "commands/drawing/draw_words.h"

/* Draws the session's row. False: an error was reported. */
bool draw_row(const struct query *query, struct answer *a, struct problem *problem,
              const struct draw_what *what);

#endif
