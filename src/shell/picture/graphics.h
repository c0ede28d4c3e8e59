/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shows pictures on terminals that can display graphics. */
#ifndef SHELL_GRAPHICS_H
#define SHELL_GRAPHICS_H

#include <stdbool.h>
#include <stdio.h>

enum graphics { GRAPHICS_NONE, GRAPHICS_SIXEL, GRAPHICS_KITTY };

/*
 * Returns the protocol with which the terminal of a stream shows pictures. A terminal with the kitty protocol
 * is recognised by its name. Other terminals are asked whether they can show sixel. If the environment
 * variable DOMINO_GRAPHICS is none, sixel or kitty, its value is used instead. A terminal without colours
 * shows no pictures, nor does any terminal if NO_COLOR is set.
 */
enum graphics graphics_of(FILE *stream);

/* Computes the size in pixels of a picture that leaves room for the prompt and is at most two thirds as tall
 * as it is wide. */
void graphics_size(FILE *stream, int *width, int *height);

/* Writes the gnuplot terminal setting for a stage or a chart of this size in pixels. */
void graphics_terminal(FILE *stream, int width, int height, bool stage, char *terminal, size_t size);

/* Shows a drawing on the terminal. Returns false if the drawing cannot be read. */
bool graphics_write(FILE *drawing, FILE *out);

#endif
