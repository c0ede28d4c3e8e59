/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shows pictures on terminals that can display graphics. */
#ifndef SHELL_GRAPHICS_H
#define SHELL_GRAPHICS_H

#include <stdbool.h>
#include <stdio.h>

enum graphics { GRAPHICS_NONE, GRAPHICS_SIXEL, GRAPHICS_KITTY };

/* Finds out how the terminal of a stream can show pictures. The environment variable DOMINO_GRAPHICS may name
 * the protocol: none, sixel or kitty. If it is not set, terminals with the protocol of kitty are recognised
 * by environment variables, and a terminal that may support sixel is asked whether it does. Returns
 * GRAPHICS_NONE if the stream may not contain colours. */
enum graphics graphics_of(FILE *stream);

/* Computes the size of a picture in pixels, with room for the prompt. The height is at most 2/3 of the
 * width. */
void graphics_size(FILE *stream, int *width, int *height);

/* Writes the gnuplot terminal setting for a stage or a chart of this size in pixels. */
void graphics_terminal(FILE *stream, int width, int height, bool stage, char *terminal, size_t size);

/* Shows a drawing on the terminal. Returns false if the drawing cannot be read. */
bool graphics_write(FILE *drawing, FILE *out);

#endif
