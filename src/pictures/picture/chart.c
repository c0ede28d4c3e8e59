/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/picture/chart.h"
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* ---- The data ---- */

struct chart chart_make(void)
{
    const struct chart_axis axis = {.low = (double)NAN, .high = (double)NAN, .unit = 1};
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
    /* No caller adds more curves than there is room for. */
    c->curves -= c->curves == CHART_CURVES;
    struct chart_curve *curve = &c->curve[c->curves++];
    *curve = (struct chart_curve){.kind = kind, .ink = ink, .dash = dash};
    va_start(arguments, format);
    vsnprintf(curve->title, sizeof curve->title, format, arguments);
    va_end(arguments);
    return curve;
}

void chart_point(struct chart *c, struct chart_curve *curve, double x, double y)
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
    curve->point[curve->count++] = (struct chart_point){x, y};
}

void chart_event(struct chart *c, double x, const char *name)
{
    if (c->events == CHART_EVENTS)
        return;
    struct chart_event *e = &c->event[c->events++];
    e->x = x;
    snprintf(e->name, sizeof e->name, "%s", name);
}

/* ---- Axes ---- */

static void axis_include(const struct chart_axis *axis, double value, double *low, double *high)
{
    if (!isfinite(value) || (axis->logarithmic && value <= 0))
        return;
    *low = fmin(*low, value);
    *high = fmax(*high, value);
}

/* Chooses the ends of an axis that are still NaN. The data reach from `low` to `high`. At each end, the axis
 * extends beyond the data by about `pad` times the range of the data. If `pad` is positive and the data begin
 * a little above 0, a linear axis begins at 0. */
static void axis_fit(struct chart_axis *a, double low, double high, double pad)
{
    if (!(low <= high)) { /* there is no data */
        low = a->logarithmic ? 0.1 : 0;
        high = 1;
    }
    if (a->logarithmic) {
        double more = fmax(pow(high / low, pad), 1.05);
        low /= more;
        high *= more;
    } else {
        /* Labels cannot show a very narrow range, so such a range is treated as a single value. */
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

/* Infinite values have no place on an axis, and neither has 0 on a logarithmic axis. Returns the end of the
 * axis where such a value is drawn. Returns other values unchanged. */
static double axis_within(const struct chart_axis *a, double value)
{
    return value == HUGE_VAL                                      ? a->high
           : value == -HUGE_VAL || (a->logarithmic && value == 0) ? a->low
                                                                  : value;
}

/* Lengthens the axis of a map from the centres of the outermost cells to their outer edges, so that whole
 * cells are visible. */
static void cells_fit(struct chart_axis *a, int cells)
{
    double half = 0.5 / (cells - 1), low = axis_number(a, -half), high = axis_number(a, 1 + half);
    a->low = low;
    a->high = high;
}

void chart_prepare(struct chart *c)
{
    double x0 = HUGE_VAL, x1 = -HUGE_VAL, y0 = HUGE_VAL, y1 = -HUGE_VAL;
    int kept = 0;
    if (c->map.value) {
        cells_fit(&c->x, c->map.across);
        cells_fit(&c->y, c->map.down);
    }
    for (int k = 0; k < c->curves; k++) {
        for (size_t i = 0; i < c->curve[k].count; i++) {
            const struct chart_point *p = &c->curve[k].point[i];
            axis_include(&c->x, p->x, &x0, &x1);
            axis_include(&c->y, p->y, &y0, &y1);
        }
        if (c->curve[k].count > 0)
            c->curve[kept++] = c->curve[k];
    }
    c->curves = kept;
    axis_fit(&c->x, x0, x1, 0);
    axis_fit(&c->y, y0, y1, 0.06);
    for (int k = 0; k < c->curves; k++)
        for (struct chart_point *p = c->curve[k].point; p < c->curve[k].point + c->curve[k].count; p++) {
            if (c->curve[k].kind == CHART_STEPS && isnan(p->y) && p > c->curve[k].point)
                p->y = p[-1].y;
            p->x = axis_within(&c->x, p->x);
            p->y = axis_within(&c->y, p->y);
        }
    kept = 0;
    for (int k = 0; k < c->events; k++) {
        const double place = axis_place(&c->x, c->event[k].x);
        if (place > -1e-9 && place < 1 + 1e-9)
            c->event[kept++] = c->event[k];
    }
    c->events = kept;
}

double axis_place(const struct chart_axis *a, double value)
{
    if (a->logarithmic)
        return value > 0 ? log(value / a->low) / log(a->high / a->low) : value == 0 ? -1 : (double)NAN;
    return (value - a->low) / (a->high - a->low);
}

double axis_number(const struct chart_axis *a, double place)
{
    return a->logarithmic ? a->low * pow(a->high / a->low, place) : a->low + place * (a->high - a->low);
}

/* ---- Ticks ---- */

/* Returns the smallest number of the form 10^n, 2 10^n or 5 10^n that is not less than `least`. */
static double ruler_step(double least)
{
    const double ten = pow(10, floor(log10(least)));
    return least <= ten ? ten : least <= 2 * ten ? 2 * ten : least <= 5 * ten ? 5 * ten : 10 * ten;
}

static void tick_add(struct ticks *t, double tick, double unit)
{
    if (t->count == TICKS)
        return;
    char *text = t->text[t->count];
    int wide = snprintf(text, TICK_TEXT, "%.6g", tick);
    if (fabs(strtod(text, NULL) - tick) > 1e-9 * fabs(tick))
        wide = snprintf(text, TICK_TEXT, "%.9g", tick); /* six digits are too few if the range is narrow */
    t->widest = wide > t->widest ? wide : t->widest;
    t->at[t->count++] = tick * unit;
}

struct ticks axis_ticks(const struct chart_axis *a, int most)
{
    /* The ticks within a decade, for an axis that has room for few, some or many ticks. */
    static const double parts[3][3] = {{1}, {1, 3}, {1, 2, 5}};
    struct ticks t = {.count = 0};
    const double low = a->low / a->unit, high = a->high / a->unit,
                 decades = a->logarithmic ? log10(high / low) : 0;
    most = most < TICKS ? most : TICKS;
    if (decades < 0.8) { /* a short section of a logarithmic axis is nearly linear */
        double step = ruler_step((high - low) / most * (1 - 1e-9));
        step = a->whole ? fmax(step, 1) : step;
        for (double k = ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++)
            tick_add(&t, k == 0 ? 0 : k * step, a->unit);
        return t;
    }
    int fine = 2, step = 1 + (int)(decades / most);
    while (fine > 0 && (fine + 1) * decades > fmax(most, 4))
        fine--;
    for (int ten = (int)floor(log10(low)); ten <= (int)ceil(log10(high)); ten += step)
        for (int k = 0; k <= fine; k++) {
            double value = parts[fine][k] * pow(10, ten);
            if (value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9))
                tick_add(&t, value, a->unit);
        }
    return t;
}

/* ---- Events ---- */

int event_spots(const struct chart *c, double letter, struct event_spot spot[CHART_EVENTS])
{
    double end[CHART_EVENTS] = {0}; /* for each row, the position where the next name may begin */
    int rows = 0;
    for (int k = 0; k < c->events; k++) {
        const double wide = letter * (double)strlen(c->event[k].name),
                     from = fmax(fmin(axis_place(&c->x, c->event[k].x) - wide / 2, 1 - wide), 0);
        int row = 0;
        while (row + 1 < CHART_EVENTS && from < end[row])
            row++;
        end[row] = from + wide + letter;
        spot[k] = (struct event_spot){from, row};
        rows = row >= rows ? row + 1 : rows;
    }
    return rows;
}
