/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture/chart.h"
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* ---- The data ---- */

struct chart chart_make(void)
{
    const struct chart_axis axis = {.low = (double)NAN, .high = (double)NAN};
    return (struct chart){.x = axis, .y = axis};
}

void chart_free(struct chart *c)
{
    for (int k = 0; k < c->curves; k++)
        free(c->curve[k].point);
    free(c->map.value);
    c->curves = 0;
    c->map.value = NULL;
}

struct chart_curve *chart_curve(struct chart *c, enum chart_kind kind, enum ink ink, int dash,
                                const char *format, ...)
{
    va_list arguments;
    c->curves -= c->curves == CHART_CURVES; /* no caller has more; the last one would be written over */
    struct chart_curve *curve = &c->curve[c->curves++];
    *curve = (struct chart_curve){.kind = kind, .ink = ink, .dash = dash};
    va_start(arguments, format);
    vsnprintf(curve->title, sizeof curve->title, format, arguments);
    va_end(arguments);
    return curve;
}

void chart_range(struct chart *c, struct chart_curve *curve, double x, double y, double low, double high)
{
    if (curve->count == curve->room) {
        size_t room = 2 * curve->room + 16;
        struct chart_point *more = realloc(curve->point, room * sizeof *more);
        c->failed = c->failed || !more;
        if (!more)
            return;
        curve->point = more;
        curve->room = room;
    }
    curve->point[curve->count++] = (struct chart_point){x, y, low, high};
}

void chart_point(struct chart *c, struct chart_curve *curve, double x, double y)
{
    chart_range(c, curve, x, y, (double)NAN, (double)NAN);
}

void chart_event(struct chart *c, double x, const char *name)
{
    if (c->events == CHART_EVENTS)
        return;
    struct chart_event *e = &c->event[c->events++];
    e->x = x;
    snprintf(e->name, sizeof e->name, "%s", name);
}

void chart_level(struct chart *c, double y, const char *title)
{
    struct chart_curve *level = chart_curve(c, CHART_LINE, INK_GREY, 2, "%s", title);
    chart_point(c, level, -HUGE_VAL, y);
    chart_point(c, level, HUGE_VAL, y);
}

void chart_scale(struct chart *c, double x, double y)
{
    for (int k = 0; k < c->curves; k++)
        for (size_t i = 0; i < c->curve[k].count; i++) {
            struct chart_point *p = &c->curve[k].point[i];
            *p = (struct chart_point){p->x / x, p->y / y, p->low / y, p->high / y};
        }
    for (int k = 0; k < c->events; k++)
        c->event[k].x /= x;
    c->x.low /= x;
    c->x.high /= x;
    c->y.low /= y;
    c->y.high /= y;
}

/* ---- Axes ---- */

static void axis_include(const struct chart_axis *axis, double value, double *low, double *high)
{
    if (!isfinite(value) || (axis->logarithmic && value <= 0))
        return;
    *low = fmin(*low, value);
    *high = fmax(*high, value);
}

/* Sets the ends that are NaN; pad: leaves room above and below, as a share of what there is. */
static void axis_fit(struct chart_axis *a, double low, double high, double pad)
{
    if (!(low <= high)) { /* nothing is there to be seen */
        low = a->logarithmic ? 0.1 : 0;
        high = 1;
    }
    if (a->logarithmic) {
        double more = fmax(pow(high / low, pad), 1.05);
        low /= more;
        high *= more;
    } else {
        /* Ticks could not tell a smaller range from a single value. */
        bool wide = high - low > 1e-7 * fmax(fabs(low), fabs(high));
        double more = wide ? pad * (high - low) : fmax(0.1 * fabs(high), 1e-9);
        low = low >= 0 && low < 0.35 * high && pad > 0 ? 0 : low - more;
        high += more;
    }
    a->low = isnan(a->low) ? low : a->low;
    a->high = isnan(a->high) ? high : a->high;
    if (!(a->high > a->low))
        a->high = a->low + (a->logarithmic ? a->low : 1);
}

/* Returns a coordinate within the axis where it is infinite, or 0 on a logarithmic axis. */
static double axis_within(const struct chart_axis *a, double value)
{
    return value == HUGE_VAL                                      ? a->high
           : value == -HUGE_VAL || (a->logarithmic && value == 0) ? a->low
                                                                  : value;
}

/* Sets the ends of the axes to the outer edges of the cells of a map. */
static void map_fit(const struct chart_map *m, struct chart_axis *x, struct chart_axis *y)
{
    double dx = m->across > 1 ? (m->x1 - m->x0) / (m->across - 1) / 2 : 0.5;
    double dy = m->down > 1 ? (m->y1 - m->y0) / (m->down - 1) / 2 : 0.5;
    x->low = x->logarithmic ? pow(10, m->x0 - dx) : m->x0 - dx;
    x->high = x->logarithmic ? pow(10, m->x1 + dx) : m->x1 + dx;
    y->low = y->logarithmic ? pow(10, m->y0 - dy) : m->y0 - dy;
    y->high = y->logarithmic ? pow(10, m->y1 + dy) : m->y1 + dy;
}

static void curve_fit(const struct chart *c, struct chart_curve *curve)
{
    for (size_t i = 0; i < curve->count; i++) {
        struct chart_point *p = &curve->point[i];
        if (curve->kind == CHART_STEPS && isnan(p->y) && i > 0)
            p->y = p[-1].y;
        p->x = axis_within(&c->x, p->x);
        p->y = axis_within(&c->y, p->y);
        p->low = axis_within(&c->y, p->low);
    }
}

void chart_fit(struct chart *c)
{
    double x0 = HUGE_VAL, x1 = -HUGE_VAL, y0 = HUGE_VAL, y1 = -HUGE_VAL, aside = 0;
    int kept = 0;
    for (int k = 0; k < c->curves; k++) {
        for (size_t i = 0; i < c->curve[k].count; i++) {
            const struct chart_point *p = &c->curve[k].point[i];
            axis_include(&c->x, p->x, &x0, &x1);
            axis_include(&c->y, p->y, &y0, &y1);
            axis_include(&c->y, p->low, &y0, &y1);
            axis_include(&c->y, p->high, &y0, &y1);
            aside = c->curve[k].kind == CHART_RANGES ? 0.6 : aside;
        }
        if (c->curve[k].count > 0)
            c->curve[kept++] = c->curve[k];
    }
    c->curves = kept;
    if (c->map.value)
        map_fit(&c->map, &c->x, &c->y);
    axis_fit(&c->x, x0 - aside, x1 + aside, 0);
    axis_fit(&c->y, y0, y1, 0.06);
    for (int k = 0; k < c->curves; k++)
        curve_fit(c, &c->curve[k]);
}

double axis_place(const struct chart_axis *a, double value)
{
    if (a->logarithmic)
        return value > 0 ? log(value / a->low) / log(a->high / a->low) : value == 0 ? -1 : (double)NAN;
    return (value - a->low) / (a->high - a->low);
}

/* Writes the multiples of a step of 1, 2 or 5 and zeros. */
static int ticks_even(const struct chart_axis *a, int most, double tick[TICKS])
{
    double least = (a->high - a->low) / most, ten = pow(10, floor(log10(least))), step = ten;
    for (int k = 0; step < least * (1 - 1e-9) || (a->whole && step < 1); k++) {
        step = ten * (k % 3 == 0 ? 2 : k % 3 == 1 ? 5 : 10);
        ten = k % 3 == 2 ? 10 * ten : ten;
    }
    int n = 0;
    double first = ceil(a->low / step - 1e-9);
    for (double k = first; k * step <= a->high + 1e-9 * step && n < TICKS; k++)
        tick[n++] = k == 0 ? 0 : k * step;
    return n;
}

int axis_ticks(const struct chart_axis *a, int most, double tick[TICKS])
{
    static const double parts[3][3] = {{1}, {1, 3}, {1, 2, 5}}; /* of each decade: coarse to fine */
    double decades = a->logarithmic ? log10(a->high / a->low) : 0;
    most = most < TICKS ? most : TICKS;
    if (decades < 0.8) /* a short piece of a logarithm is nearly even */
        return ticks_even(a, most, tick);
    int low = (int)floor(log10(a->low)), high = (int)ceil(log10(a->high)), n = 0;
    int fine = 2, step = 1 + (int)(decades / most);
    while (fine > 0 && (fine + 1) * decades > fmax(most, 4))
        fine--;
    for (int ten = low; ten <= high; ten += step)
        for (int k = 0; k <= fine && n < TICKS; k++) {
            double value = parts[fine][k] * pow(10, ten);
            if (value >= a->low * (1 - 1e-9) && value <= a->high * (1 + 1e-9))
                tick[n++] = value;
        }
    return n;
}

int tick_text(double tick, char text[TICK_TEXT])
{
    int wide = snprintf(text, TICK_TEXT, "%.6g", tick);
    bool exact = fabs(strtod(text, NULL) - tick) <= 1e-9 * fabs(tick);
    return exact ? wide : snprintf(text, TICK_TEXT, "%.9g", tick);
}

/* ---- Events ---- */

struct event_spot event_spot(const struct chart *c, int event, double letter)
{
    double end[CHART_EVENTS] = {0}; /* of the last name of each row, with a gap after it */
    struct event_spot spot = {0, 0};
    for (int k = 0; k <= event; k++) {
        double wide = letter * (double)strlen(c->event[k].name), place = axis_place(&c->x, c->event[k].x);
        spot.from = fmax(fmin(place - wide / 2, 1 - wide), 0);
        for (spot.row = 0; spot.row + 1 < CHART_EVENTS && spot.from < end[spot.row];)
            spot.row++;
        end[spot.row] = spot.from + wide + letter;
    }
    return spot;
}

int event_rows(const struct chart *c, double letter)
{
    int rows = 0;
    for (int k = 0; k < c->events; k++) {
        struct event_spot spot = event_spot(c, k, letter);
        rows = spot.row >= rows ? spot.row + 1 : rows;
    }
    return rows;
}
