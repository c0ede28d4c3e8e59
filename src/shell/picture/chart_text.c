/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Charts in characters: title, axes, curves, legend. */
#include "answer/wrap.h"
#include "io/terminal.h"
#include "picture/chart.h"
#include <math.h>
#include <string.h>

enum { CHART_TEXT = 192, LEGEND_APART = 3, ROWS_LEAST = 4 };

/* The part of the canvas between the axes, in cells; bottom is the row of the axis. */
struct frame {
    struct canvas *canvas;
    const struct chart *chart;
    int left, top, right, bottom;
    int label_rows; /* of the x axis */
};

static bool has_line(enum chart_kind kind)
{
    return kind == CHART_LINE || kind == CHART_STEPS || kind == CHART_MARKED || kind == CHART_BOTH;
}

static bool has_points(enum chart_kind kind)
{
    return kind == CHART_POINTS || kind == CHART_MARKED || kind == CHART_BOTH;
}

/* ---- From values to dots ---- */

static double dot_x(const struct frame *f, double x)
{
    int across = f->canvas->across;
    return f->left * across + axis_place(&f->chart->x, x) * ((f->right - f->left) * across - 1) + 0.5;
}

static double dot_y(const struct frame *f, double y)
{
    int down = f->canvas->down;
    return f->top * down + (1 - axis_place(&f->chart->y, y)) * ((f->bottom - f->top) * down - 1) + 0.5;
}

static double clamp(double value, double low, double high)
{
    return fmin(fmax(value, low), high);
}

/* Cuts [*from, *to], parts of a line, to where a + part * change is in [low, high]. */
static void clip(double a, double change, double low, double high, double *from, double *to)
{
    double first = (low - a) / change, last = (high - a) / change;
    if (change == 0) {
        *to = a >= low && a <= high ? *to : -1;
        return;
    }
    *from = fmax(*from, fmin(first, last));
    *to = fmin(*to, fmax(first, last));
}

/* Draws a line, as far as it is between the axes. */
static void line_draw(const struct frame *f, double x0, double y0, double x1, double y1,
                      const struct chart_curve *curve, int *phase)
{
    const struct canvas *c = f->canvas;
    double from = 0, to = 1, dx = x1 - x0, dy = y1 - y0;
    clip(x0, dx, f->left * c->across, f->right * c->across - 0.01, &from, &to);
    clip(y0, dy, f->top * c->down, f->bottom * c->down - 0.01, &from, &to);
    if (from <= to)
        canvas_line(f->canvas, x0 + from * dx, y0 + from * dy, x0 + to * dx, y0 + to * dy, curve->ink,
                    curve->dash, phase);
}

static void point_draw(const struct frame *f, double x, double y, enum ink ink)
{
    double px = axis_place(&f->chart->x, x), py = axis_place(&f->chart->y, y);
    if (!(px >= -1e-9 && px <= 1 + 1e-9 && py >= -1e-9 && py <= 1 + 1e-9))
        return;
    int dot[] = {(int)dot_x(f, x), (int)dot_y(f, y)};
    if (f->canvas->look.braille)
        canvas_text(f->canvas, dot[0] / f->canvas->across, dot[1] / f->canvas->down, "●", ink);
    else
        canvas_dot(f->canvas, dot[0], dot[1], ink);
}

static void curve_draw(const struct frame *f, const struct chart_curve *curve)
{
    int phase = 0;
    for (size_t i = 0; i + 1 < curve->count; i++) {
        const struct chart_point *a = &curve->point[i], *b = a + 1;
        double x0 = dot_x(f, a->x), y0 = dot_y(f, a->y), x1 = dot_x(f, b->x), y1 = dot_y(f, b->y);
        bool steps = curve->kind == CHART_STEPS;
        if (isnan(x0 + y0 + x1 + y1))
            continue;
        line_draw(f, x0, y0, x1, steps ? y0 : y1, curve, &phase);
        if (steps)
            line_draw(f, x1, y0, x1, y1, curve, &phase);
    }
}

static void ranges_draw(const struct frame *f, const struct chart_curve *curve)
{
    const struct canvas *c = f->canvas;
    for (size_t i = 0; i < curve->count; i++) {
        const struct chart_point *p = &curve->point[i];
        double x = dot_x(f, p->x), low = f->top * c->down, high = f->bottom * c->down - 1;
        double y0 = clamp(dot_y(f, p->low), low, high), y1 = clamp(dot_y(f, p->high), low, high);
        int phase = 0;
        if (isnan(p->low) || isnan(p->high) || isnan(x))
            continue;
        for (int row = (int)y1; row <= (int)y0 && !c->look.braille; row++)
            canvas_text(f->canvas, (int)x, row, "|", curve->ink);
        if (!c->look.braille)
            continue;
        canvas_line(f->canvas, x, y0, x, y1, curve->ink, 0, &phase);
        for (int k = -1; k <= 1; k++) {
            canvas_dot(f->canvas, (int)x + k, (int)y0, curve->ink);
            canvas_dot(f->canvas, (int)x + k, (int)y1, curve->ink);
        }
    }
}

static double map_at(const struct chart_map *m, double x, double y)
{
    int i = (int)clamp(x * m->across, 0, m->across - 1), k = (int)clamp(y * m->down, 0, m->down - 1);
    return m->value[k * m->across + i];
}

static void map_ends(const struct chart_map *m, double *low, double *high)
{
    *low = HUGE_VAL;
    *high = -HUGE_VAL;
    for (int i = 0; i < m->across * m->down; i++)
        if (isfinite(m->value[i])) {
            *low = fmin(*low, m->value[i]);
            *high = fmax(*high, m->value[i]);
        }
}

static double shade_of(double value, double low, double high)
{
    return isfinite(value) ? (high > low ? (value - low) / (high - low) : 0.5) : (double)NAN;
}

static void map_draw(const struct frame *f)
{
    double low, high;
    map_ends(&f->chart->map, &low, &high);
    int wide = f->right - f->left, tall = f->bottom - f->top;
    for (int row = 0; row < tall; row++)
        for (int column = 0; column < wide; column++) {
            double x = (column + 0.5) / wide, upper = 1 - (row + 0.25) / tall,
                   lower = 1 - (row + 0.75) / tall;
            canvas_shade(f->canvas, f->left + column, f->top + row,
                         shade_of(map_at(&f->chart->map, x, upper), low, high),
                         shade_of(map_at(&f->chart->map, x, lower), low, high));
        }
}

/* ---- Around it ---- */

/*
 * Writes a text between two columns, in at most so many lines, of which the last is cut off where it is too
 * long. Returns how many lines there are; without a canvas it only counts them.
 */
static int lines_put(struct canvas *c, int left, int right, int row, int most, bool centred, const char *text)
{
    int lines = 0;
    for (size_t n; *text && lines < most; lines++, text += n + (text[n] == ' ')) {
        char line[CHART_TEXT];
        n = lines + 1 < most ? line_break(text, right - left) : strlen(text);
        snprintf(line, sizeof line, "%.*s", (int)n, text);
        int at = centred ? (right - left - terminal_columns(line)) / 2 : 0;
        if (c)
            canvas_text(c, left + (at > 0 ? at : 0), row + lines, line, INK_TEXT);
    }
    return lines;
}

static int ticks_y(const struct chart *chart, int rows, double tick[TICKS], char label[TICKS][TICK_TEXT])
{
    int widest = 0, n = axis_ticks(&chart->y, rows < 6 ? 3 : rows / 3, tick);
    for (int k = 0; k < n; k++) {
        int wide = tick_text(tick[k], label[k]);
        widest = wide > widest ? wide : widest;
    }
    for (int k = n; k < TICKS; k++)
        tick[k] = (double)NAN;
    return widest;
}

static void axis_y_draw(const struct frame *f, const double tick[TICKS], char label[TICKS][TICK_TEXT])
{
    bool boxes = f->canvas->look.braille;
    for (int row = f->top; row < f->bottom; row++)
        canvas_text(f->canvas, f->left - 1, row, boxes ? "│" : "|", INK_TEXT);
    for (int k = 0; k < TICKS && !isnan(tick[k]); k++) {
        int row = (int)dot_y(f, tick[k]) / f->canvas->down;
        row = row >= f->bottom ? f->bottom - 1 : row;
        canvas_text(f->canvas, f->left - 2 - (int)strlen(label[k]), row, label[k], INK_TEXT);
        canvas_text(f->canvas, f->left - 1, row, boxes ? "┤" : "+", INK_TEXT);
    }
}

static void axis_x_draw(const struct frame *f)
{
    struct canvas *c = f->canvas;
    bool boxes = c->look.braille;
    double tick[TICKS];
    int n = axis_ticks(&f->chart->x, (f->right - f->left) / 9, tick), free_from = 0;
    canvas_text(c, f->left - 1, f->bottom, boxes ? "└" : "+", INK_TEXT);
    for (int column = f->left; column < f->right; column++)
        canvas_text(c, column, f->bottom, boxes ? "─" : "-", INK_TEXT);
    for (int k = 0; k < n; k++) {
        char label[TICK_TEXT];
        int wide = tick_text(tick[k], label);
        int column = (int)dot_x(f, tick[k]) / c->across, at = column - wide / 2;
        at = at + wide > c->width ? c->width - wide : at;
        if (at < free_from)
            continue;
        free_from = at + wide + 1;
        canvas_text(c, column, f->bottom, boxes ? "┴" : "+", INK_TEXT);
        canvas_text(c, at, f->bottom + 1, label, INK_TEXT);
    }
    lines_put(c, f->left, f->right, f->bottom + 2, f->label_rows, true, f->chart->x.label);
}

/* Draws a vertical line with its name for each event. */
static void events_draw(const struct frame *f)
{
    const struct chart_curve line = {.ink = INK_GREY, .dash = 2};
    double wide = f->right - f->left, across = f->canvas->across;
    for (int k = 0; k < f->chart->events; k++) {
        const struct event_spot spot = event_spot(f->chart, k, 1 / wide);
        double x = clamp(dot_x(f, f->chart->event[k].x), f->left * across, f->right * across - 1);
        int phase = 0;
        line_draw(f, x, f->bottom * f->canvas->down - 1, x, f->top * f->canvas->down, &line, &phase);
        canvas_text(f->canvas, f->left + (int)floor(spot.from * wide), f->top - 1 - spot.row,
                    f->chart->event[k].name, INK_TEXT);
    }
}

/* ---- The legend ---- */

/* Draws the legend if `draw`, and returns the rows it takes. */
static int legend(const struct chart *chart, struct canvas *c, int row, bool draw)
{
    int column = 2, rows = 0;
    for (int k = 0; k < chart->curves; k++) {
        const struct chart_curve *curve = &chart->curve[k];
        char sample[4 * GLYPH], text[160];
        if (!*curve->title)
            continue;
        bool braille = c->look.braille, dot = has_points(curve->kind);
        canvas_sample(c, curve->ink, curve->dash, sample);
        if (braille && dot)
            snprintf(sample, sizeof sample, "●");
        else if (curve->kind == CHART_RANGES)
            snprintf(sample, sizeof sample, "%s", braille ? "│" : "|");
        snprintf(text, sizeof text, " %s", curve->title);
        int wide = terminal_columns(sample) + terminal_columns(text);
        if (rows == 0 || column + wide > c->width) {
            column = 2;
            rows++;
        }
        if (draw) {
            canvas_text(c, column, row + rows - 1, sample, curve->ink);
            canvas_text(c, column + terminal_columns(sample), row + rows - 1, text, INK_TEXT);
        }
        column += wide + LEGEND_APART;
    }
    return rows;
}

/* Draws the shades of a map with the values of their ends, below what they mean where there is no room
 * beside. Returns how many rows that takes; without a canvas it only counts them. */
static int map_legend(const struct chart *chart, struct canvas *c, int width, int row, int most)
{
    enum { SHADES = 24 };
    double low, high;
    char text[CHART_TEXT + 32], last[32];
    map_ends(&chart->map, &low, &high);
    bool none = !(low <= high);
    snprintf(last, sizeof last, none ? "no value" : " %.4g", high);
    int rows = 0, at = snprintf(text, sizeof text, none ? "%s: " : "%s: %.4g ", chart->map.label, low);
    if (at + SHADES + (int)strlen(last) + 2 > width) {
        rows = lines_put(c, 2, width, row, most, false, chart->map.label);
        at = snprintf(text, sizeof text, none ? "%s" : "%s%.4g ", "", low);
    }
    if (c) {
        canvas_text(c, 2, row + rows, text, INK_TEXT);
        for (int k = 0; k < SHADES && !none; k++)
            canvas_shade(c, 2 + at + k, row + rows, (double)k / (SHADES - 1), (double)k / (SHADES - 1));
        canvas_text(c, 2 + at + (none ? 0 : SHADES), row + rows, last, INK_TEXT);
    }
    return rows + 1;
}

/* ---- All of it ---- */

static void chart_draw(const struct frame *f)
{
    const struct chart *chart = f->chart;
    if (chart->map.value)
        map_draw(f);
    events_draw(f);
    for (int k = 0; k < chart->curves; k++) {
        const struct chart_curve *curve = &chart->curve[k];
        if (curve->kind == CHART_RANGES || curve->kind == CHART_BOTH)
            ranges_draw(f, curve);
        if (has_line(curve->kind))
            curve_draw(f, curve);
        for (size_t i = 0; i < curve->count && has_points(curve->kind); i++)
            point_draw(f, curve->point[i].x, curve->point[i].y, curve->ink);
    }
}

bool chart_text(const struct chart *chart, struct look look, int width, int height, FILE *out)
{
    struct canvas canvas;
    double tick[TICKS];
    char label[TICKS][TICK_TEXT];
    int note_rows = *chart->note ? 1 + terminal_columns(chart->note) / (width - 4) : 0;
    if (!canvas_make(&canvas, look, width, height - note_rows))
        return false;
    const int most = height / 10 > 0 ? height / 10 : 1;
    int title_rows = lines_put(NULL, 0, width, 0, most, true, chart->title);
    struct frame f = {.canvas = &canvas, .chart = chart, .left = 7, .right = width};
    f.top = title_rows + lines_put(NULL, 0, width, 0, most, false, chart->y.label) +
            event_rows(chart, 1.0 / (width - 7));
    f.label_rows = lines_put(NULL, f.left, width, 0, most, true, chart->x.label);
    f.bottom = canvas.height - 2 - f.label_rows;
    int legend_rows =
        chart->map.value ? map_legend(chart, NULL, width, 0, most) : legend(chart, &canvas, 0, false);
    int room = f.bottom - f.top - ROWS_LEAST;
    f.bottom -= legend_rows < room ? legend_rows : room > 0 ? room : 0; /* what does not fit is left out */
    f.left = ticks_y(chart, f.bottom - f.top, tick, label) + 3;
    chart_draw(&f);
    axis_y_draw(&f, tick, label);
    axis_x_draw(&f);
    lines_put(&canvas, 0, width, 0, most, true, chart->title);
    lines_put(&canvas, 0, width, title_rows, most, false, chart->y.label);
    legend(chart, &canvas, f.bottom + 2 + f.label_rows, true);
    if (chart->map.value)
        map_legend(chart, &canvas, width, f.bottom + 2 + f.label_rows, most);
    canvas_write(&canvas, 0, out);
    canvas_free(&canvas);
    if (*chart->note) {
        write_wrapped(out, chart->note, 0, width);
        putc('\n', out);
    }
    return true;
}
