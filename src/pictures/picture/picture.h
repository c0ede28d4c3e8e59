/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What charts and stages are drawn with: a canvas of characters, gnuplot, and the whole screen. */
#pragma once

#include "answer/answer.h"
#include "session/problem.h"
#include <signal.h>

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

/* The number of dash patterns. Pattern 0 is an unbroken line. */
enum { DASHES = 5 };

/* The unit of an axis or a ruler. */
struct axis_unit {
    const char *name;
    double size; /* in m */
};

/* Returns the unit for an axis or a ruler that shows lengths up to `longest` m. The unit is mm if `longest`
 * is below 0.2, cm if it is below 2, and otherwise m. So lengths in mm and cm need at most three digits
 * before the decimal point, and a ruler has no room for more. */
struct axis_unit measure_axis(double longest);

/* ---- Characters ---- */

/* What the terminal of a stream can show. Files and pipes get plain characters. */
struct display {
    bool braille; /* the terminal shows braille and box-drawing characters */
    bool colours;
};
struct display display_of(FILE *stream);

enum { GLYPH = 5 /* the size of a character in UTF-8, including the NUL byte */ };

struct canvas_cell {
    char glyph[GLYPH]; /* the character, or "" */
    unsigned char dots, ink;
};

/* A picture made of characters. It has text, and lines of dots. Text replaces what was in a cell before. Dots
 * replace text, and are added to dots that are already in the cell. */
struct canvas {
    struct display display;
    int width, height; /* size of the canvas in cells */
    int across, down;  /* number of dots in a cell, across and down */
    int left, top, right,
        bottom; /* dots appear only in the columns and rows from the first two to the last two */
    struct canvas_cell *cell;
};

/* Makes a canvas which takes dots everywhere. Returns false if memory runs out. The caller frees
 * canvas->cell. */
bool canvas_make(struct canvas *canvas, struct display display, int width, int height);

/* Draws the dot at (x, y), counted from the upper left corner. A dot elsewhere is ignored. */
void canvas_dot(struct canvas *canvas, int x, int y, enum ink ink);

/* Draws a straight line of dots. A curve consists of many such lines. *phase is the position in the dash
 * pattern, which continues from one line to the next. */
void canvas_line(struct canvas *canvas, double x0, double y0, double x1, double y1, enum ink ink, int dash,
                 int *phase);

/* Writes a short sample of a curve with this ink and dash pattern, for a legend. */
void canvas_sample(const struct canvas *canvas, enum ink ink, int dash, char sample[4 * GLYPH]);

/* Writes text, starting in the given cell. Characters outside the canvas are not drawn. */
void canvas_text(struct canvas *canvas, int column, int row, const char *text, enum ink ink);

/* Writes the rows of the canvas, without trailing blanks. */
void canvas_write(const struct canvas *canvas, FILE *out);

/* ---- gnuplot ---- */

struct picture {
    FILE *script; /* commands for gnuplot; picture_begin has already written the terminal setting */
    const struct answer *answer; /* receives the picture */
};

/* The size of a picture in dots, unless it has another height; and the width of a text in it, in
 * characters. */
enum { PICTURE_WIDTH = 640, PICTURE_HEIGHT = 480, CAPTION_COLUMNS = 76 };

/* Returns true if the answer goes to a picture file, such as .png. */
bool picture_is_filed(const struct answer *a);

/* Begins a picture of this height in the file of an answer; a .pdf file is `wide` cm wide. If the file is a
 * .gp script, the picture is only this script, which draws a .pdf file of the same name. For a film, `delay`
 * is the time between two frames in hundredths of a second, otherwise 0. On failure, sets *problem and
 * returns false. */
bool picture_begin(struct picture *picture, const struct answer *answer, double height, double wide,
                   int delay, struct problem *problem);

/* Ends a picture. Draws it if the script is complete (`whole`). Otherwise discards it and returns false. */
bool picture_end(struct picture *picture, bool whole, struct problem *problem);

/* Writes the first `length` bytes of a text as a gnuplot string. Every text in a script must go through this
 * function: gnuplot runs commands between backticks, but not in single quotes. Each '\n' begins a new line of
 * the picture. Other control characters and bytes that are not UTF-8 are escaped (see escape.h). */
void gnuplot_text_part(FILE *script, const char *text, size_t length);
void gnuplot_text(FILE *script, const char *text);

/* ---- The screen (screen.c) ---- */

/* A second screen of the terminal, without a cursor, on which keys are read one by one. ^Z does nothing
 * there. */

/* Keys beyond characters. KEY_END: the user has typed 'q', ^D or ^C, or the terminal is gone. */
enum { KEY_NONE = 0, KEY_UP = 256, KEY_DOWN, KEY_RIGHT, KEY_LEFT, KEY_END };

/* Shows the screen. Returns a stream to write on it, or NULL if `out` is not shown on a terminal, or if this
 * program is not in the terminal's foreground. */
FILE *screen_begin(FILE *out);
void screen_end(void);

/* Waits for a key, for at most this many seconds, and not longer than 0.2 s. Returns KEY_NONE if there is
 * none. */
int screen_key(double seconds);
