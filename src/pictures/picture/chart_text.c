/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws charts and stages with characters. A character is assumed to be twice as high as it is wide. */
#include "io/terminal.h"
#include "language/text.h"
#include "pictures/picture/chart.h"
#include "pictures/picture/stage.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* AXIS_USUAL is the assumed width of the y axis with its labels, in columns. It is used until the labels are
 * known. */
enum { CHART_TEXT = 192, LEGEND_APART = 3, ROWS_LEAST = 4, AXIS_USUAL = 7 };

/* The part of the canvas between the axes, in cells. `bottom` is the row of the x axis. */
struct frame {
    struct canvas *canvas;
    const struct chart *chart; /* NULL for a stage */
    struct chart_axis x, y;
    int left, top, right, bottom;
    int most; /* the maximum number of rows for each text */
};

/* ---- From values to dots ---- */

static double dot_x(const struct frame *f, double x)
{
    int across = f->canvas->across;
    return f->left * across + axis_place(&f->x, x) * ((f->right - f->left) * across - 1) + 0.5;
}

static double dot_y(const struct frame *f, double y)
{
    int down = f->canvas->down;
    return f->top * down + (1 - axis_place(&f->y, y)) * ((f->bottom - f->top) * down - 1) + 0.5;
}

static double clamp(double value, double low, double high)
{
    return fmin(fmax(value, low), high);
}

/* Clips a line to a strip of the canvas. A point of the line has the coordinate start + f * change, where f
 * goes from 0 at one end of the line to 1 at the other end. Narrows the interval [*from, *to] of f to the
 * points whose coordinate is in [low, high]. */
static void clip(double start, double change, double low, double high, double *from, double *to)
{
    double first = (low - start) / change, last = (high - start) / change;
    if (change == 0) {
        *to = start >= low && start <= high ? *to : -1;
        return;
    }
    *from = fmax(*from, fmin(first, last));
    *to = fmin(*to, fmax(first, last));
}

/* Draws the part of a line that is inside the frame. */
static void line_draw(const struct frame *f, double x0, double y0, double x1, double y1, enum ink ink,
                      int dash, int *phase)
{
    const struct canvas *c = f->canvas;
    double from = 0, to = 1, dx = x1 - x0, dy = y1 - y0;
    clip(x0, dx, f->left * c->across, f->right * c->across - 0.01, &from, &to);
    clip(y0, dy, f->top * c->down, f->bottom * c->down - 0.01, &from, &to);
    if (from <= to)
        canvas_line(f->canvas, x0 + from * dx, y0 + from * dy, x0 + to * dx, y0 + to * dy, ink, dash, phase);
}

static void points_draw(const struct frame *f, const struct chart_curve *curve)
{
    for (const struct chart_point *p = curve->point; p < curve->point + curve->count; p++) {
        double px = axis_place(&f->x, p->x), py = axis_place(&f->y, p->y);
        if (!(px >= -1e-9 && px <= 1 + 1e-9 && py >= -1e-9 && py <= 1 + 1e-9))
            continue;
        int x = (int)dot_x(f, p->x), y = (int)dot_y(f, p->y);
        if (f->canvas->display.braille)
            canvas_text(f->canvas, x / f->canvas->across, y / f->canvas->down, "●", curve->ink);
        else
            canvas_dot(f->canvas, x, y, curve->ink);
    }
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
        line_draw(f, x0, y0, x1, steps ? y0 : y1, curve->ink, curve->dash, &phase);
        if (steps)
            line_draw(f, x1, y0, x1, y1, curve->ink, curve->dash, &phase);
    }
}

/* ---- Maps ---- */

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

/* Returns the shade of a map at the point (x, y), or NaN if the map has no value there. x and y are fractions
 * of the axes. */
static double map_shade(const struct chart_map *m, double x, double y, double low, double high)
{
    int i = (int)clamp(x * m->across, 0, m->across - 1), k = (int)clamp(y * m->down, 0, m->down - 1);
    double value = m->value[k * m->across + i];
    return isfinite(value) ? (high > low ? (value - low) / (high - low) : 0.5) : (double)NAN;
}

static void map_draw(const struct frame *f)
{
    const struct chart_map *m = &f->chart->map;
    double low, high;
    int wide = f->right - f->left, tall = f->bottom - f->top;
    map_ends(m, &low, &high);
    for (int row = 0; row < tall; row++)
        for (int column = 0; column < wide; column++) {
            double x = (column + 0.5) / wide;
            canvas_shade(f->canvas, f->left + column, f->top + row,
                         map_shade(m, x, 1 - (row + 0.25) / tall, low, high),
                         map_shade(m, x, 1 - (row + 0.75) / tall, low, high));
        }
}

/* ---- Texts and axes ---- */

/* Writes a text between the columns `left` and `right`, in several rows if necessary. After `most` rows, the
 * text is cut off. Returns the number of rows. If the canvas is NULL, writes nothing and only counts the
 * rows. */
static int text_put(struct canvas *c, int left, int right, int row, int most, bool centred, const char *text)
{
    int rows = 0;
    for (size_t n; *text && rows < most; rows++, text += n + (text[n] == ' ')) {
        char line[CHART_TEXT];
        n = rows + 1 < most ? line_break(text, right - left) : strlen(text);
        snprintf(line, sizeof line, "%.*s", (int)n, text);
        int at = centred ? (right - left - utf8_columns(line)) / 2 : 0;
        if (c)
            canvas_text(c, left + (at > 0 ? at : 0), row + rows, line, INK_TEXT);
    }
    return rows;
}

static void axis_y_draw(const struct frame *f, const struct ticks *ticks)
{
    bool boxes = f->canvas->display.braille;
    for (int row = f->top; row < f->bottom; row++)
        canvas_text(f->canvas, f->left - 1, row, boxes ? "│" : "|", INK_TEXT);
    for (int k = 0; k < ticks->count; k++) {
        int row = (int)dot_y(f, ticks->at[k]) / f->canvas->down;
        row = row >= f->bottom ? f->bottom - 1 : row;
        canvas_text(f->canvas, f->left - 2 - (int)strlen(ticks->text[k]), row, ticks->text[k], INK_TEXT);
        canvas_text(f->canvas, f->left - 1, row, boxes ? "┤" : "+", INK_TEXT);
    }
}

/* Draws the x axis, with the labels of its ticks in the given row. */
static void axis_x_draw(const struct frame *f, int label_row)
{
    struct canvas *c = f->canvas;
    bool boxes = c->display.braille;
    const struct ticks ticks = axis_ticks(&f->x, (f->right - f->left) / 9);
    int free_from = 0;
    canvas_text(c, f->left - 1, f->bottom, boxes ? "└" : "+", INK_TEXT);
    for (int column = f->left; column < f->right; column++)
        canvas_text(c, column, f->bottom, boxes ? "─" : "-", INK_TEXT);
    for (int k = 0; k < ticks.count; k++) {
        int wide = (int)strlen(ticks.text[k]), column = (int)dot_x(f, ticks.at[k]) / c->across;
        int at = column - wide / 2;
        at = at + wide > c->width ? c->width - wide : at;
        if (at < free_from)
            continue;
        free_from = at + wide + 1;
        canvas_text(c, column, f->bottom, boxes ? "┴" : "+", INK_TEXT);
        canvas_text(c, at, label_row, ticks.text[k], INK_TEXT);
    }
}

static void events_draw(const struct frame *f)
{
    double wide = f->right - f->left, across = f->canvas->across;
    for (int k = 0; k < f->chart->events; k++) {
        const struct event_spot spot = event_spot(f->chart, k, 1 / wide);
        double x = clamp(dot_x(f, f->chart->event[k].x), f->left * across, f->right * across - 1);
        int phase = 0;
        line_draw(f, x, f->bottom * f->canvas->down - 1, x, f->top * f->canvas->down, INK_GREY, 2, &phase);
        canvas_text(f->canvas, f->left + (int)floor(spot.from * wide), f->top - 1 - spot.row,
                    f->chart->event[k].name, INK_TEXT);
    }
}

/* ---- The legend ---- */

static bool has_points(enum chart_kind kind)
{
    return kind == CHART_POINTS || kind == CHART_MARKED;
}

/* Writes the legend: the titles of the curves. `row` is its first row. If `row` is negative, writes nothing
 * and only counts the rows. Returns the number of rows. */
static int legend(const struct frame *f, int row)
{
    struct canvas *c = f->canvas;
    int column = 2, rows = 0;
    for (int k = 0; k < f->chart->curves; k++) {
        const struct chart_curve *curve = &f->chart->curve[k];
        char sample[4 * GLYPH], text[160];
        if (!*curve->title)
            continue;
        bool braille = c->display.braille;
        canvas_sample(c, curve->ink, curve->dash, sample);
        if (braille && has_points(curve->kind))
            snprintf(sample, sizeof sample, "●");
        snprintf(text, sizeof text, " %s", curve->title);
        int first = utf8_columns(sample), wide = first + utf8_columns(text);
        if (rows == 0 || column + wide > c->width) {
            column = 2;
            rows++;
        }
        if (row >= 0) {
            canvas_text(c, column, row + rows - 1, sample, curve->ink);
            canvas_text(c, column + first, row + rows - 1, text, INK_TEXT);
        }
        column += wide + LEGEND_APART;
    }
    return rows;
}

/* Like legend, but for a map: writes a bar of shades between the lowest and the highest value. */
static int map_legend(const struct frame *f, int row)
{
    enum { SHADES = 24 };
    struct canvas *c = row < 0 ? NULL : f->canvas;
    const char *label = f->chart->map.label;
    double low, high;
    char text[CHART_TEXT + 32], last[32];
    map_ends(&f->chart->map, &low, &high);
    snprintf(last, sizeof last, " %.4g", high);
    int rows = 0, at = snprintf(text, sizeof text, "%s: %.4g ", label, low), width = f->canvas->width;
    /* the label goes above the bar if there is no room beside it */
    if (at + SHADES + (int)strlen(last) + 2 > width) {
        rows = text_put(c, 2, width, row, f->most, false, label);
        at = snprintf(text, sizeof text, "%.4g ", low);
    }
    if (c) {
        canvas_text(c, 2, row + rows, text, INK_TEXT);
        for (int k = 0; k < SHADES; k++)
            canvas_shade(c, 2 + at + k, row + rows, (double)k / (SHADES - 1), (double)k / (SHADES - 1));
        canvas_text(c, 2 + at + SHADES, row + rows, last, INK_TEXT);
    }
    return rows + 1;
}

/* ---- The whole chart ---- */

static void data_draw(const struct frame *f)
{
    const struct chart *chart = f->chart;
    if (chart->map.value)
        map_draw(f);
    events_draw(f);
    for (int k = 0; k < chart->curves; k++) {
        const struct chart_curve *curve = &chart->curve[k];
        if (curve->kind != CHART_POINTS)
            curve_draw(f, curve);
        if (has_points(curve->kind))
            points_draw(f, curve);
    }
}

bool chart_text(const struct chart *chart, struct display display, int width, int height, FILE *out)
{
    struct canvas canvas;
    int (*const legend_put)(const struct frame *f, int row) = chart->map.value ? map_legend : legend;
    int note_rows = *chart->note ? 1 + utf8_columns(chart->note) / (width - 4) : 0;
    if (!canvas_make(&canvas, display, width, height - note_rows))
        return false;
    struct frame f = {
        .canvas = &canvas, .chart = chart, .x = chart->x, .y = chart->y, .left = AXIS_USUAL, .right = width};
    f.most = height / 10 > 0 ? height / 10 : 1;
    int title_rows = text_put(&canvas, 0, width, 0, f.most, true, chart->title);
    f.top = title_rows + text_put(&canvas, 0, width, title_rows, f.most, false, chart->y.label) +
            event_rows(chart, 1.0 / (width - AXIS_USUAL));
    int label_rows = text_put(NULL, f.left, width, 0, f.most, true, chart->x.label);
    f.bottom = canvas.height - 2 - label_rows;
    int legend_rows = legend_put(&f, -1), room = f.bottom - f.top - ROWS_LEAST;
    /* Rows of the legend that do not fit are not drawn. */
    f.bottom -= legend_rows < room ? legend_rows : room > 0 ? room : 0;
    const int rows = f.bottom - f.top;
    const struct ticks ticks = axis_ticks(&chart->y, rows < 6 ? 3 : rows / 3);
    f.left = ticks.widest + 3;
    data_draw(&f);
    axis_y_draw(&f, &ticks);
    axis_x_draw(&f, f.bottom + 1);
    text_put(&canvas, f.left, f.right, f.bottom + 2, f.most, true, chart->x.label);
    legend_put(&f, f.bottom + 2 + label_rows);
    canvas_write(&canvas, 0, out);
    canvas_free(&canvas);
    if (*chart->note) {
        write_wrapped(out, chart->note, 0, width);
        putc('\n', out);
    }
    return true;
}

/* ---- Stages ---- */

static int compare(const void *one, const void *other)
{
    const double a = *(const double *)one, b = *(const double *)other;
    return (a > b) - (a < b);
}

/* Fills an outline with dots or, if there is a `mark`, with this character. `x` and `y` are its corners in
 * dots. The area is scanned in both directions, and each crossing fills at least one dot, so that a thin
 * domino is not lost between two dots. */
static void area_fill(const struct frame *f, const double *x, const double *y, int n, const char *mark,
                      enum ink ink)
{
    const int across = f->canvas->across, down = f->canvas->down, low[] = {f->left * across, f->top * down},
              high[] = {f->right * across, f->bottom * down};
    for (int way = 0; way < 2; way++) {
        const double *a = way ? y : x, *b = way ? x : y;
        for (int line = low[!way]; line < high[!way]; line++) {
            double cross[OUTLINE];
            int count = 0;
            for (int i = 0, j = n - 1; i < n; j = i++)
                if ((b[i] <= line + 0.5) != (b[j] <= line + 0.5))
                    cross[count++] = a[i] + (line + 0.5 - b[i]) / (b[j] - b[i]) * (a[j] - a[i]);
            qsort(cross, (size_t)count, sizeof *cross, compare);
            for (int k = 0; k + 1 < count; k += 2) {
                const double first = ceil(cross[k] - 0.49), last = floor(cross[k + 1] - 0.51),
                             middle = floor((cross[k] + cross[k + 1]) / 2),
                             from = clamp(last < first ? middle : first, low[way], high[way]),
                             to = fmin(last < first ? middle : last, high[way] - 1);
                for (int at = (int)from; at <= to; at++)
                    if (mark)
                        canvas_text(f->canvas, way ? line : at, way ? at : line, mark, ink);
                    else
                        canvas_dot(f->canvas, way ? line : at, way ? at : line, ink);
            }
        }
    }
}

/* Returns the dot at a point of a stage. The ground is the lower edge of the lowest dots. */
static struct point stage_dot(const struct frame *f, struct point p)
{
    const double wide = (f->right - f->left) * f->canvas->across,
                 high = (f->bottom - f->top) * f->canvas->down;
    return (struct point){f->left * f->canvas->across + wide * axis_place(&f->x, p.x),
                          f->bottom * f->canvas->down - 0.02 - high * axis_place(&f->y, p.y)};
}

/* Draws the outline of a domino, and fills it if it is marked or if there is no braille. */
static void domino_draw(const struct frame *f, const struct drawn *d)
{
    static const enum ink inks[PARTS] = {[HEAD] = INK_BLUE, [FALLS] = INK_ORANGE, [WEAKEST] = INK_RED};
    const bool braille = f->canvas->display.braille;
    const char mark[2] = {(char)(d->part == ENDS      ? 'X'
                                 : d->part == WEAKEST ? '*'
                                 : d->number < 0      ? '#'
                                                      : '0' + d->number % 10)};
    struct point outline[OUTLINE];
    double x[OUTLINE], y[OUTLINE];
    int phase = 0, n = drawn_outline(d, outline);
    for (int i = 0; i < n; i++) {
        const struct point dot = stage_dot(f, outline[i]);
        x[i] = dot.x;
        y[i] = dot.y;
    }
    for (int i = 0; i < n && braille; i++)
        line_draw(f, x[i], y[i], x[(i + 1) % n], y[(i + 1) % n], inks[d->part], 0, &phase);
    if (!braille || drawn_marked(d))
        area_fill(f, x, y, n, braille ? NULL : mark, inks[d->part]);
}

/* Writes the names of the dominoes below them. Where names would overlap, marked dominoes have priority. */
static void names_draw(const struct frame *f, const struct stage *stage)
{
    struct canvas *c = f->canvas;
    const int row = f->bottom + 1;
    canvas_text(c, 0, row, "domino", INK_TEXT);
    for (int pass = 0; pass < 2; pass++)
        for (size_t k = 0; k < stage->count; k++) {
            const struct drawn *d = &stage->domino[k];
            char name[DRAWN_NAME + CELL_TEXT] = "";
            const double middle = stage_dot(f, (struct point){d->foot - d->thickness / 2, 0}).x / c->across;
            bool is_free = drawn_marked(d) == (pass == 0) && drawn_name(d, name) > 0 &&
                           (stage->tall <= 0 || (middle >= f->left && middle < f->right));
            if (is_free && stage->tall > 0 && d->number == NUMBER_TOWER)
                text_add(name, sizeof name, " %s", measured((domq_real)d->height, "m", 4).text);
            const int wide = (int)strlen(name), half = wide / 2,
                      from = is_free ? (int)clamp(middle - half, f->left, c->width - wide) : 0;
            for (int i = from > f->left ? from - 1 : from; is_free && i <= from + wide; i++)
                is_free = canvas_blank(c, i, row);
            if (is_free)
                canvas_text(c, from, row, name, INK_TEXT);
        }
}

bool stage_text(const struct stage *stage, struct display display, int width, int height, FILE *out)
{
    enum {
        LEFT = 7,       /* columns for the vertical scale */
        FILM_LINES = 3, /* lines for the caption of a film that follows the fall */
        BELOW = 3,      /* rows for the ground, the names of the dominoes, and the ruler */
        WIDTH_MOST = 200
    };
    struct canvas canvas;
    int lines = 0;
    width = width < WIDTH_MOST ? width : WIDTH_MOST;
    for (const char *text = stage->caption; *text; lines++) {
        const size_t n = line_break(text, width);
        fprintf(out, "%.*s\n", (int)n, text);
        text += n + (text[n] == ' ' || text[n] == '\n');
    }
    for (; stage->tall > 0 && lines < FILM_LINES; lines++) /* the frames of a film have the same height */
        fputc('\n', out);
    struct frame f = {
        .canvas = &canvas, .left = LEFT, .right = width, .bottom = (int)fmax(height - lines - BELOW, 1)};
    /* A free column on either side leaves room for the outlines at the ends. `unit` is the width of a column.
     */
    double unit = fmax((stage->right - stage->left) / (width - LEFT - 2), 1.02 * stage->top / (2 * f.bottom));
    f.x.low = stage->left - unit;
    if (stage->tall > 0) {
        unit = stage->tall / (2 * f.bottom);
        f.x.low = stage->at - 0.45 * (width - LEFT) * unit;
    } else {
        f.bottom = (int)fmin(f.bottom, ceil(1.02 * stage->top / (2 * unit)));
    }
    f.x.high = f.x.low + (width - LEFT) * unit;
    f.y.high = 2 * unit * f.bottom;
    const struct axis_unit shown = stage_unit(stage, f.x.high - f.x.low);
    f.x.unit = f.y.unit = shown.size;
    if (!canvas_make(&canvas, display, width, f.bottom + BELOW))
        return false;
    for (size_t k = stage->count; k-- > 0;)
        domino_draw(&f, stage_front(stage, k));
    for (size_t k = 0; k < stage->count && !display.braille; k++) {
        const struct drawn *d = &stage->domino[k];
        const struct point dot = stage_dot(&f, d->contact);
        if (d->touched && d->height > 4 * unit)
            canvas_text(&canvas, (int)dot.x, (int)dot.y, "@", INK_TEXT);
    }
    const struct ticks ticks = axis_ticks(&f.y, f.bottom < 6 ? 3 : f.bottom / 3);
    axis_y_draw(&f, &ticks);
    names_draw(&f, stage);
    char text[32];
    snprintf(text, sizeof text, "%*s[%s]", LEFT - 3 - (int)strlen(shown.name), "", shown.name);
    canvas_text(&canvas, 0, f.bottom + 2, text, INK_TEXT);
    axis_x_draw(&f, f.bottom + 2);
    canvas_write(&canvas, 0, out);
    canvas_free(&canvas);
    return true;
}
