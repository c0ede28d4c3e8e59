/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures on terminals that can show them. */
#ifndef SHELL_GRAPHICS_H
#define SHELL_GRAPHICS_H

#include <stdbool.h>
#include <stdio.h>

enum graphics { GRAPHICS_NONE, GRAPHICS_SIXEL, GRAPHICS_KITTY };

/*
 * Returns the protocol by which the terminal of a stream shows pictures. The name of the terminal tells
 * kitty, and the terminal is asked whether it knows sixel. If $DOMINO_GRAPHICS is none, sixel or kitty, it
 * decides instead. A terminal without colour, or with NO_COLOR, shows no pictures.
 */
enum graphics graphics_of(FILE *stream);

/* Finds the size in dots of a picture that leaves room for the prompt, and is at most two thirds as tall as
 * wide. */
void graphics_size(FILE *stream, int *width, int *height);

/* Writes gnuplot's terminal for a stage or a chart of this size. */
void graphics_terminal(FILE *stream, int width, int height, bool stage, char *terminal, size_t size);

/* Shows the drawing on the terminal. Returns false if it cannot be read. */
bool graphics_write(FILE *drawing, FILE *out);

#endif
