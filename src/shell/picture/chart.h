/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves, points, ranges and maps over two axes. A command says what a chart shows, and chart_show (show.h)
 * draws it where the answer goes: in characters, as a picture on a terminal, or by gnuplot into a file.
 */
#ifndef SHELL_CHART_H
#define SHELL_CHART_H

#include "picture/canvas.h"
#include "session/query.h"

enum chart_kind {
    CHART_LINE,
    CHART_POINTS,
    CHART_MARKED, /* a line through points */
    CHART_STEPS,  /* y holds from x to the x of the next point */
    CHART_RANGES, /* from low to high at x */
    CHART_BOTH    /* points with their ranges, and a line through them */
};

struct chart_point {
    double x, y, low, high; /* y is NaN at a gap of a line; low and high are NaN where there is no range */
};

struct chart_curve {
    char title[96]; /* in the legend; "" leaves the curve out of the legend */
    enum chart_kind kind;
    enum ink ink;
    int dash; /* 0 for an unbroken line */
    struct chart_point *point;
    size_t count, room;
};

struct chart_axis {
    char label[128]; /* with its unit */
    bool logarithmic;
    bool whole;       /* only whole numbers have ticks */
    double low, high; /* NaN for what the data needs */
};

/* A value for each cell of a grid, from the lowest row on. chart_fit takes the ends of the axes for the
 * middles of the outermost cells. */
struct chart_map {
    double *value; /* NaN where there is none; NULL for a chart without a map */
    int across, down;
    char label[96]; /* what the values are */
};

struct chart_event {
    double x;
    char name[32];
};

enum { CHART_CURVES = 10, CHART_EVENTS = 8 };

/* A chart has curves or a map. */
struct chart {
    char title[192], note[256]; /* the note is a sentence, or "" */
    struct chart_axis x, y;
    struct chart_curve curve[CHART_CURVES];
    int curves;
    struct chart_event event[CHART_EVENTS]; /* vertical lines with names at their upper ends */
    int events;
    struct chart_map map;
    bool failed; /* there was no memory for the data */
};

/* Returns an empty chart. */
struct chart chart_make(void);
void chart_free(struct chart *chart);

/* Adds a curve without points, whose title is formatted. */
struct chart_curve *chart_curve(struct chart *chart, enum chart_kind kind, enum ink ink, int dash,
                                const char *format, ...) __attribute__((format(printf, 5, 6)));
void chart_point(struct chart *chart, struct chart_curve *curve, double x, double y);
void chart_range(struct chart *chart, struct chart_curve *curve, double x, double y, double low, double high);

/* Adds a grey horizontal line all across the chart. */
void chart_level(struct chart *chart, double y, const char *title);

/* Adds a vertical line with a name. */
void chart_event(struct chart *chart, double x, const char *name);

/* Divides all numbers by the sizes of the units in which they are to be shown. */
void chart_scale(struct chart *chart, double x, double y);

/*
 * Makes a chart ready to be drawn: chooses the ends of axes that are NaN, moves points at infinity, and at 0
 * on a logarithmic axis, to the end of the axis, lets steps go on where y is NaN, and drops curves without
 * points.
 */
void chart_fit(struct chart *chart);

/* ---- For the painters ---- */

/* Return the place of a value on its axis, from 0 at the lower end to 1 at the upper end, and the value at a
 * place. */
double axis_place(const struct chart_axis *axis, double value);
double axis_number(const struct chart_axis *axis, double place);

enum { TICKS = 24, TICK_TEXT = 24 };

struct ticks {
    int count, widest; /* widest: the characters of the longest text */
    double at[TICKS];
    char text[TICKS][TICK_TEXT];
};

/* Returns at most so many ticks of an axis. */
struct ticks axis_ticks(const struct chart_axis *axis, int most);

/*
 * Where the name of an event stands: its first letter as a share of the x axis, and its row above the chart,
 * from 0. Names that would meet stand above each other. `letter` is the width of a letter, as such a share.
 */
struct event_spot {
    double from;
    int row;
};
struct event_spot event_spot(const struct chart *chart, int event, double letter);

/* Returns how many rows the names of the events take. */
int event_rows(const struct chart *chart, double letter);

/* Draws in so many columns and rows of characters. Returns false if there is no memory. */
bool chart_text(const struct chart *chart, struct look look, int width, int height, FILE *out);

/* Writes the script of gnuplot. */
void chart_script(const struct chart *chart, FILE *script);

#endif
