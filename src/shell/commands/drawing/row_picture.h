/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scripts of gnuplot that draw a row to scale: a picture, and the frames of an animation. */
#ifndef SHELL_ROW_PICTURE_H
#define SHELL_ROW_PICTURE_H

#include "commands/drawing/falling_row.h"

/* The part of the world that a picture shows, in m, and its size in dots: the plot to scale, and around it.
 */
struct view {
    double left, right, low, high; /* low < 0: room for the numbers below the ground */
    double width, height;          /* dots of the whole picture */
    double per_dot;                /* m */
    double margin_left, margin_right, margin_below, margin_above; /* dots */
    int size;                                                     /* of the font, in dots */
};

enum { VIEW_WIDTH = 640, CAPTION_LINES = 4, CAPTION_COLUMNS = 76 };

/*
 * Finds a view from `left` to `right` and up to `high`, with so many lines of caption and `room` dots above;
 * its height in dots has these limits.
 */
struct view view_of(double left, double right, double high, int lines, double height_least,
                    double height_most, double room);

/* Returns how many dots the heights that are written above the dominoes need above the tallest. */
double row_label_room(const struct view *view, const struct falling_row *row);

/* Returns the right end of what the row needs: where it stands, or also where it lies. */
double row_right(const struct falling_row *row, bool lying);

/* Writes the caption above the picture, wrapped to at most CAPTION_LINES lines; returns how many it takes. */
int caption_wrap(const char *text, char line[CAPTION_LINES][ROW_SENTENCE], int columns);

/* Sets gnuplot's terminal for a file of this name to the size of the view. */
void script_sheet(FILE *script, const char *path, const struct view *view);

/* Writes margins, ranges and the tape measure below. */
void script_view(FILE *script, const struct view *view);

/* Writes the caption as labels. */
void script_caption(FILE *script, const struct view *view, const char *text);

/*
 * Puts a dot of each colour into the corner: a gif has the colours of its first frame, and gnuplot leaves out
 * a frame that is the same as the one before, so these dots change places by `shift`.
 */
void script_palette(FILE *script, const struct view *view, int shift);

/* Writes the dominoes with these tilts as data and plots them, with their numbers where there is room. */
void script_row(FILE *script, const struct view *view, const struct falling_row *row, const double *tilt,
                size_t head, bool labelled);

#endif
