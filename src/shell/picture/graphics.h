/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Terminals that show real pictures, and how they take them. */
#ifndef SHELL_GRAPHICS_H
#define SHELL_GRAPHICS_H

#include <stdbool.h>
#include <stdio.h>

enum graphics { GRAPHICS_NONE, GRAPHICS_SIXEL, GRAPHICS_KITTY };

/*
 * Returns how the terminal of a stream takes pictures: as its name says (kitty), or as it answers when it
 * is asked for its attributes (sixel); $DOMINO_GRAPHICS, if it is none, sixel or kitty, decides instead.
 * A terminal without colour, or with NO_COLOR, has none.
 */
enum graphics graphics_of(FILE *stream);

/* Finds the dots of a picture that leaves room for the prompt, no taller than two thirds of its width. */
void graphics_size(FILE *stream, int *width, int *height);

/* Writes gnuplot's terminal for a picture of this size; of a stage the letters are as large as its sheet has
 * them. */
void graphics_terminal(FILE *stream, int width, int height, bool stage, char *terminal, size_t size);

/* Puts what was drawn into the terminal. */
bool graphics_write(FILE *drawing, FILE *out);

#endif
