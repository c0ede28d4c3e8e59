/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Terminals that show real pictures, and how they take them. */
#ifndef SHELL_GRAPHICS_H
#define SHELL_GRAPHICS_H

#include "picture/chart.h"

enum graphics { GRAPHICS_NONE, GRAPHICS_SIXEL, GRAPHICS_KITTY };

/*
 * Returns how the terminal of a stream takes pictures: as its name says (kitty), or as it answers when it
 * is asked for its attributes (sixel); $DOMINO_GRAPHICS, if it is none, sixel or kitty, decides instead.
 * A terminal without colour, or with NO_COLOR, has none.
 */
enum graphics graphics_of(FILE *stream);

/* Draws the chart into the terminal of the session; false: an error was reported. */
bool graphics_show(const struct query *query, struct answer *a, struct problem *problem,
                   const struct chart *chart);

#endif
