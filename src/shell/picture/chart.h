/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves, points, ranges and maps over two axes.  A command says what they show; chart_show draws them where
 * the answer goes: in characters, as a picture on terminals that have them, or by gnuplot into a file.
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
    double x, y, low, high; /* y NaN: a gap in the line; low and high: of ranges only */
};

struct chart_curve {
    char title[96]; /* in the legend; "" to leave the curve out of it */
    enum chart_kind kind;
    enum ink ink;
    int dash; /* 0: unbroken */
    struct chart_point *point;
    size_t count, room;
};

struct chart_axis {
    char label[128]; /* with its unit */
    bool logarithmic;
    bool whole;       /* only whole numbers have ticks */
    double low, high; /* NaN: what the data needs */
};

/* A value at each point of a grid, rows from the lowest y on; axes then have their ends in the outermost
 * cells' middles. */
struct chart_map {
    double *value; /* NULL: no map; NaN: no value */
    int across, down;
    double x0, x1, y0, y1; /* the first and the last middle of a cell; in the logarithm of logarithmic axes */
    char label[96];        /* of the values */
};

struct chart_event {
    double x;
    char name[32];
};

enum { CHART_CURVES = 10, CHART_EVENTS = 8 };

struct chart {
    char title[192], note[256]; /* note: a sentence below the picture; "" for none */
    struct chart_axis x, y;
    struct chart_curve curve[CHART_CURVES];
    int curves;
    struct chart_event event[CHART_EVENTS]; /* vertical lines, named at their upper ends */
    int events;
    struct chart_map map;
    bool failed; /* a point had no memory */
};

/* Returns an empty chart. */
struct chart chart_make(void);
void chart_free(struct chart *chart);

/* Adds a curve without points; the next points belong to it. */
struct chart_curve *chart_curve(struct chart *chart, enum chart_kind kind, enum ink ink, int dash,
                                const char *format, ...) __attribute__((format(printf, 5, 6)));
void chart_point(struct chart *chart, struct chart_curve *curve, double x, double y);
void chart_range(struct chart *chart, struct chart_curve *curve, double x, double y, double low, double high);

/* Adds a grey line all across the chart. */
void chart_level(struct chart *chart, double y, const char *title);

/* Adds a vertical line with a name. */
void chart_event(struct chart *chart, double x, const char *name);

/* Shows all numbers in larger units, by these factors. */
void chart_scale(struct chart *chart, double x, double y);

/* ---- For the files that draw ---- */

/*
 * Makes a chart ready to be drawn: chooses the ends of axes that are NaN, moves points at infinity, and at 0
 * on a logarithmic axis, to the end of the axis, lets steps go on where y is NaN, and drops curves without
 * points.
 */
void chart_fit(struct chart *chart);

/* Returns the place of a value on its axis, 0 for the lower end and 1 for the upper. */
double axis_place(const struct chart_axis *axis, double value);

/* Writes the ticks of an axis, at most `most`, and returns how many. */
enum { TICKS = 24 };
int axis_ticks(const struct chart_axis *axis, int most, double tick[TICKS]);

/* Writes the text of a tick. */
enum { TICK_TEXT = 24 };
int tick_text(double tick, char text[TICK_TEXT]);

/*
 * Where the name of an event stands: its first letter as a share of the x axis, and its row above the chart,
 * from 0. `letter` is the share that a letter takes. Names that would meet stand above each other.
 */
struct event_spot {
    double from;
    int row;
};
struct event_spot event_spot(const struct chart *chart, int event, double letter);

/* Returns how many rows the names of the events take. */
int event_rows(const struct chart *chart, double letter);

/* Draws in so many characters. */
bool chart_text(const struct chart *chart, struct look look, int width, int height, FILE *out);

/* Writes what gnuplot is to do. */
void chart_script(const struct chart *chart, FILE *script);

#endif
