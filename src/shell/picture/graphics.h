/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shows pictures on terminals that can display graphics. */
#ifndef SHELL_GRAPHICS_H
#define SHELL_GRAPHICS_H

#include <stdbool.h>
#include <stdio.h>

enum graphics { GRAPHICS_NONE, GRAPHICS_SIXEL, GRAPHICS_KITTY };

/* Returns the protocol with which the terminal of a stream shows pictures. DOMINO_GRAPHICS may be none, sixel
 * or kitty. If the variable is not set, kitty is recognised by name, and other terminals are asked whether
 * they support sixel. A terminal without colours shows no pictures. */
enum graphics graphics_of(FILE *stream);

/* Computes the size of a picture in pixels, with room for the prompt. The height is at most 2/3 of the
 * width. */
void graphics_size(FILE *stream, int *width, int *height);

/* Writes the gnuplot terminal setting for a stage or a chart of this size in pixels. */
void graphics_terminal(FILE *stream, int width, int height, bool stage, char *terminal, size_t size);

/* Shows a drawing on the terminal. Returns false if the drawing cannot be read. */
bool graphics_write(FILE *drawing, FILE *out);

#endif
