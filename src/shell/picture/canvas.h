/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Pictures in characters: lines of braille dots or of letters, text, and shades, in colour where the terminal
 * has colours. A cell shows what was put there last; only the dots of a cell add up.
 */
#ifndef SHELL_CANVAS_H
#define SHELL_CANVAS_H

#include <stdbool.h>
#include <stdio.h>

/* Colours that colour-blind people can tell apart (Okabe and Ito). INK_TEXT is the colour of text. */
enum ink {
    INK_TEXT,
    INK_BLUE,
    INK_RED,
    INK_GREEN,
    INK_PURPLE,
    INK_ORANGE,
    INK_SKY,
    INK_GREY, /* for lines that only guide the eye */
    INKS
};

/* Returns the colour of an ink, 0xrrggbb. */
int ink_colour(enum ink ink);

/* Returns the colour of a shade in 0 .. 1 of the palette viridis, whose brightness rises steadily. */
int shade_colour(double shade);

/* Returns the step of a ruler or an axis: the least of 1, 2 and 5 times a power of ten that is not below
 * `least`. */
double ruler_step(double least);

/* Returns true if the name of the terminal, $TERM, begins with one of these names, which end with NULL. */
bool term_begins(const char *const *names);

/* What the terminal of a stream can show; a file and a pipe get plain letters. */
struct look {
    bool braille; /* also lines of boxes and half blocks */
    enum { COLOURS_NONE, COLOURS_8, COLOURS_256, COLOURS_ALL } colours;
};
struct look look_of(FILE *stream);

enum { GLYPH = 5 /* bytes of a character in UTF-8, with its end */ };

struct canvas_cell {
    char glyph[GLYPH]; /* "" for none */
    unsigned char dots, ink;
    int upper, lower; /* colours of the halves; -1 for none */
};

struct canvas {
    struct look look;
    int width, height; /* in cells */
    int across, down;  /* the number of dots in a cell */
    struct canvas_cell *cell;
};

/* Makes an empty canvas. Returns false if there is no memory. */
bool canvas_make(struct canvas *canvas, struct look look, int width, int height);
void canvas_free(struct canvas *canvas);

/* Puts a dot, counted from the upper left. A dot outside the canvas is ignored. */
void canvas_dot(struct canvas *canvas, int x, int y, enum ink ink);

/* The number of patterns of dashes, which keep curves apart that have one colour. Pattern 0 is unbroken. */
enum { DASHES = 5 };

/* Draws a line of dots. *phase is the place in the pattern, which goes on from one piece of a curve to the
 * next. */
void canvas_line(struct canvas *canvas, double x0, double y0, double x1, double y1, enum ink ink, int dash,
                 int *phase);

/* Writes a short piece of a curve for a legend. */
void canvas_sample(const struct canvas *canvas, enum ink ink, int dash, char sample[4 * GLYPH]);

/* Writes text from a cell on. What is outside the canvas is left out. */
void canvas_text(struct canvas *canvas, int column, int row, const char *text, enum ink ink);

/* Puts two shades in 0 .. 1, one above the other, into a cell. A shade that is NaN is left out. */
void canvas_shade(struct canvas *canvas, int column, int row, double upper, double lower);

/* Returns true if a cell shows nothing, or is outside the canvas. */
bool canvas_blank(const struct canvas *canvas, int column, int row);

/* Writes the rows of the canvas from a row on, without blanks at their ends. */
void canvas_write(const struct canvas *canvas, int from, FILE *out);

#endif
