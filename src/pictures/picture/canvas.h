/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A canvas is a picture made of characters. It has text, shades, and lines of dots. Text and shades replace
 * what was in a cell before. Dots replace text, and are added to dots that are already in the cell. A
 * coloured shade hides dots that are drawn over it. */
#ifndef SHELL_CANVAS_H
#define SHELL_CANVAS_H

#include <stdbool.h>
#include <stdio.h>

/* Colours that colour-blind people can tell apart (Okabe and Ito). INK_TEXT is the default colour of text. */
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

/* Returns the colour of an ink as 0xrrggbb. */
int ink_colour(enum ink ink);

/* Returns the colour for a shade from 0 to 1 in the viridis palette, whose brightness increases steadily. */
int shade_colour(double shade);

/* Returns a round step for a ruler: the smallest number of the form 10^n, 2 10^n or 5 10^n that is not less
 * than `least`. */
double ruler_step(double least);

/* What the terminal of a stream can show. Files and pipes get plain characters. */
struct display {
    bool braille; /* the terminal shows braille, box-drawing characters and half blocks */
    enum { COLOURS_NONE, COLOURS_8, COLOURS_256 } colours;
};
struct display display_of(FILE *stream);

enum { GLYPH = 5 /* the size of a character in UTF-8, including the NUL byte */ };

struct canvas_cell {
    char glyph[GLYPH]; /* the character, or "" */
    unsigned char dots, ink;
    int upper, lower; /* colours of the upper and lower halves of the cell, or -1 for no colour */
};

struct canvas {
    struct display display;
    int width, height; /* size of the canvas in cells */
    int across, down;  /* number of dots in a cell, across and down */
    struct canvas_cell *cell;
};

/* Returns false if memory runs out. */
bool canvas_make(struct canvas *canvas, struct display display, int width, int height);
void canvas_free(struct canvas *canvas);

/* Draws the dot at (x, y), counted from the upper left corner. A dot outside the canvas is ignored. */
void canvas_dot(struct canvas *canvas, int x, int y, enum ink ink);

/* The number of dash patterns. Pattern 0 is an unbroken line. */
enum { DASHES = 5 };

/* Draws a straight line of dots. A curve consists of many such lines. *phase is the position in the dash
 * pattern, which continues from one line to the next. */
void canvas_line(struct canvas *canvas, double x0, double y0, double x1, double y1, enum ink ink, int dash,
                 int *phase);

/* Writes a short sample of a curve with this ink and dash pattern, for a legend. */
void canvas_sample(const struct canvas *canvas, enum ink ink, int dash, char sample[4 * GLYPH]);

/* Writes text, starting in the given cell. Characters outside the canvas are not drawn. */
void canvas_text(struct canvas *canvas, int column, int row, const char *text, enum ink ink);

/* Draws two shades from 0 to 1 into a cell, one into each half. NaN stands for a half without a shade. */
void canvas_shade(struct canvas *canvas, int column, int row, double upper, double lower);

/* Returns true if a cell is empty or outside the canvas. */
bool canvas_blank(const struct canvas *canvas, int column, int row);

/* Writes the rows of the canvas, beginning with row `from`, without trailing blanks. */
void canvas_write(const struct canvas *canvas, int from, FILE *out);

#endif
