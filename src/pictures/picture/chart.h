/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Charts with two axes. They show curves, points or a map. A command fills a chart with data, and
 * chart_show then draws the chart to the destination of the answer. */
#pragma once

#include "pictures/picture/picture.h"

enum chart_kind {
    CHART_LINE,
    CHART_POINTS,
    CHART_MARKED, /* a line through points */
    CHART_STEPS   /* y is constant from each x to the next; a NaN repeats the previous y */
};

struct chart_point {
    double x, y; /* y is NaN at a gap in a line */
};

struct chart_curve {
    char title[96]; /* the title in the legend, or "" for a curve that is not in the legend */
    enum chart_kind kind;
    enum ink ink;
    int dash; /* the dash pattern (see DASHES in picture.h), or 0 for an unbroken line */
    struct chart_point *point;
    size_t count, room;
};

struct chart_axis {
    char label[128]; /* label, including the unit */
    bool logarithmic;
    bool whole;       /* only whole numbers get ticks */
    double low, high; /* the ends of the axis; if an end is NaN, chart_prepare chooses it from the data */
    double unit;      /* the size of the unit of its ticks, for example 0.01 for cm if the data are in m */
};

/* The values of a map, one for each cell. The cells are listed row by row, beginning with the lowest row. At
 * first, the axes end at the centres of the outermost cells. chart_prepare moves the ends to the outer edges
 * of these cells. */
struct chart_map {
    double *value; /* NaN for a cell without a value; the pointer is NULL if the chart has no map */
    int across, down;
    char label[96]; /* label of the values */
};

enum { CHART_CURVES = 10, CHART_EVENTS = 8 };

/* A chart has either curves or a map. */
struct chart {
    char title[192];
    char note[256]; /* a sentence below the title, or "" if there is none */
    struct chart_axis x, y;
    struct chart_curve curve[CHART_CURVES];
    int curves;
    struct chart_event {
        double x;
        char name[32];
    } event[CHART_EVENTS]; /* vertical lines with names at their upper ends */
    int events;
    struct chart_map map;
    bool failed; /* there was no memory for the data */
};

struct chart chart_make(void);
void chart_free(struct chart *chart);

/* Adds a curve without points. The title is formatted as by printf. */
struct chart_curve *chart_curve(struct chart *chart, enum chart_kind kind, enum ink ink, int dash,
                                const char *format, ...) __attribute__((format(printf, 5, 6)));

/* Adds a point to a curve. */
void chart_point(struct chart *chart, struct chart_curve *curve, double x, double y);

/* Adds a vertical line at x, with a name at its upper end. */
void chart_event(struct chart *chart, double x, const char *name);

/*
 * Makes a chart ready to be drawn:
 * - If an end of an axis is NaN, it is chosen so that the data fit.
 * - Points at infinity, or at 0 on a logarithmic axis, are moved to an end of the axis.
 * - Curves without points, and events outside the x axis, are removed.
 */
void chart_prepare(struct chart *chart);

/* ---- For the functions that draw charts ---- */

/* axis_place returns the position of a value on its axis: 0 is the lower end, and 1 is the upper end.
 * axis_number returns the value at a position. */
double axis_place(const struct chart_axis *axis, double value);
double axis_number(const struct chart_axis *axis, double place);

enum { TICKS = 24, TICK_TEXT = 24 };

struct ticks {
    int count, widest; /* the number of ticks, and the length of the longest label */
    double at[TICKS];
    char text[TICKS][TICK_TEXT];
};

/* Chooses up to about `most` ticks for an axis. */
struct ticks axis_ticks(const struct chart_axis *axis, int most);

/* Where the name of an event is written. */
struct event_spot {
    double from; /* where the name begins, as a fraction of the x axis */
    int row;     /* the row above the chart, counted from 0 */
};

/* Finds where to write the names of the events. Names that would overlap are put into different rows.
 * `letter` is the width of a character, as a fraction of the x axis. Returns the number of rows. */
int event_spots(const struct chart *chart, double letter, struct event_spot spot[CHART_EVENTS]);

/* Draws a chart with `width` columns and `height` rows of characters. Returns false if memory runs out. */
bool chart_text(const struct chart *chart, struct display display, int width, int height, FILE *out);

/* Draws a chart to the destination of the answer and frees the chart. A terminal shows it in characters. */
bool chart_show(struct chart *chart, const struct answer *a, struct problem *problem);

/* Writes a gnuplot script that draws a chart. */
void chart_script(const struct chart *chart, FILE *script);

/* Writes an axis of this name, "x" or "y", into a script, with up to about `most` ticks. */
void axis_script(FILE *script, const struct chart_axis *axis, const char *name, int most);
