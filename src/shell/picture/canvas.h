/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Pictures in characters: lines of braille dots or of letters, text, and shades, in colour where the terminal
 * has it.  A cell shows one thing, the one that was put there last; dots of one cell add up.
 */
#ifndef SHELL_CANVAS_H
#define SHELL_CANVAS_H

#include <stdbool.h>
#include <stdio.h>

/* Colours that stay apart for colour-blind people (Okabe and Ito); 0 is that of text. */
enum ink {
    INK_TEXT,
    INK_BLUE,
    INK_RED,
    INK_GREEN,
    INK_PURPLE,
    INK_ORANGE,
    INK_SKY,
    INK_GREY, /* what is only a help to the eye */
    INKS
};

/* Returns the colour as gnuplot writes it, "#0072b2". */
const char *ink_colour(enum ink ink);

/* What the terminal of a stream can show; a file and a pipe get plain letters. */
struct look {
    bool braille; /* also lines of boxes and half blocks */
    enum { COLOURS_NONE, COLOURS_8, COLOURS_256, COLOURS_ALL } colours;
};
struct look look_of(FILE *stream);

enum { GLYPH = 5 /* bytes of a character in UTF-8, with its end */ };

struct canvas_cell {
    unsigned char dots, ink;
    char glyph[GLYPH];  /* "" for none */
    short upper, lower; /* shades of a map, 0 .. 255; -1 for none */
};

struct canvas {
    struct look look;
    int width, height; /* cells */
    int across, down;  /* dots in a cell */
    struct canvas_cell *cell;
};

/* Makes an empty canvas; false: out of memory. */
bool canvas_make(struct canvas *canvas, struct look look, int width, int height);
void canvas_free(struct canvas *canvas);

/* Puts a dot, counted from the upper left; outside the canvas nothing happens. */
void canvas_dot(struct canvas *canvas, int x, int y, enum ink ink);

/* How a line is broken, by the number of the curve: in one colour, too, the first of them stay apart. */
enum { DASHES = 5 };

/* Draws a line of dots; *phase carries the dashes on from one piece of a curve to the next. */
void canvas_line(struct canvas *canvas, double x0, double y0, double x1, double y1, enum ink ink, int dash,
                 int *phase);

/* Returns what stands for a curve in a legend. */
const char *canvas_sample(const struct canvas *canvas, enum ink ink, int dash, char sample[4 * GLYPH]);

/* Puts text from a cell on, as far as the canvas goes. */
void canvas_text(struct canvas *canvas, int column, int row, const char *text, enum ink ink);

/* Puts two shades, 0 .. 1, one above the other, into a cell; NaN for none. */
void canvas_shade(struct canvas *canvas, int column, int row, double upper, double lower);

/* Returns true if a cell shows nothing, or is outside. */
bool canvas_blank(const struct canvas *canvas, int column, int row);

/* Writes the canvas from a row on, without blanks at the ends of lines. */
void canvas_write(const struct canvas *canvas, int from, FILE *out);

/* Writes red, green and blue of a shade, dark to light also in grey: viridis in nine steps. */
void shade_colour(double shade, int rgb[3]);

#endif
