/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws charts and stages to the destination of an answer. A terminal shows them in characters, of which each
 * is assumed to be twice as high as it is wide. */
#include "answer/answer.h"
#include "io/terminal.h"
#include "pictures/picture/chart.h"
#include "pictures/picture/stage.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* AXIS_USUAL is the assumed width of the y axis with its labels, in columns. It is used until the labels are
 * known. */
enum { CHART_TEXT = 192, LEGEND_APART = 3, ROWS_LEAST = 4, AXIS_USUAL = 7 };

/* A canvas with two axes. Its part inside the axes takes dots; `bottom` is the row of the x axis. */
struct frame {
    struct canvas canvas;
    const struct chart *chart; /* NULL for a stage */
    struct chart_axis x, y;
    int most; /* the maximum number of rows for each text */
};

/* ---- From values to dots ---- */

static double dot_x(const struct frame *f, double x)
{
    const struct canvas *c = &f->canvas;
    return c->left * c->across + axis_place(&f->x, x) * ((c->right - c->left) * c->across - 1) + 0.5;
}

static double dot_y(const struct frame *f, double y)
{
    const struct canvas *c = &f->canvas;
    return c->top * c->down + (1 - axis_place(&f->y, y)) * ((c->bottom - c->top) * c->down - 1) + 0.5;
}

static double clamp(double value, double low, double high)
{
    return fmin(fmax(value, low), high);
}

static void points_draw(struct frame *f, const struct chart_curve *curve)
{
    struct canvas *c = &f->canvas;
    for (const struct chart_point *p = curve->point; p < curve->point + curve->count; p++) {
        double px = axis_place(&f->x, p->x), py = axis_place(&f->y, p->y);
        if (!(px >= -1e-9 && px <= 1 + 1e-9 && py >= -1e-9 && py <= 1 + 1e-9))
            continue;
        int x = (int)dot_x(f, p->x), y = (int)dot_y(f, p->y);
        if (c->display.braille)
            canvas_text(c, x / c->across, y / c->down, "●", curve->ink);
        else
            canvas_dot(c, x, y, curve->ink);
    }
}

static void curve_draw(struct frame *f, const struct chart_curve *curve)
{
    int phase = 0;
    for (size_t i = 0; i + 1 < curve->count; i++) {
        const struct chart_point *a = &curve->point[i], *b = a + 1;
        double x0 = dot_x(f, a->x), y0 = dot_y(f, a->y), x1 = dot_x(f, b->x), y1 = dot_y(f, b->y);
        bool steps = curve->kind == CHART_STEPS;
        if (isnan(x0 + y0 + x1 + y1))
            continue;
        canvas_line(&f->canvas, x0, y0, x1, steps ? y0 : y1, curve->ink, curve->dash, &phase);
        if (steps)
            canvas_line(&f->canvas, x1, y0, x1, y1, curve->ink, curve->dash, &phase);
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

static void axis_y_draw(struct frame *f, const struct ticks *ticks)
{
    struct canvas *c = &f->canvas;
    bool boxes = c->display.braille;
    for (int row = c->top; row < c->bottom; row++)
        canvas_text(c, c->left - 1, row, boxes ? "│" : "|", INK_TEXT);
    for (int k = 0; k < ticks->count; k++) {
        int row = (int)dot_y(f, ticks->at[k]) / c->down;
        row = row >= c->bottom ? c->bottom - 1 : row;
        canvas_text(c, c->left - 2 - (int)strlen(ticks->text[k]), row, ticks->text[k], INK_TEXT);
        canvas_text(c, c->left - 1, row, boxes ? "┤" : "+", INK_TEXT);
    }
}

/* Draws the x axis, with the labels of its ticks in the given row. */
static void axis_x_draw(struct frame *f, int label_row)
{
    struct canvas *c = &f->canvas;
    bool boxes = c->display.braille;
    const struct ticks ticks = axis_ticks(&f->x, (c->right - c->left) / 9);
    int free_from = 0;
    canvas_text(c, c->left - 1, c->bottom, boxes ? "└" : "+", INK_TEXT);
    for (int column = c->left; column < c->right; column++)
        canvas_text(c, column, c->bottom, boxes ? "─" : "-", INK_TEXT);
    for (int k = 0; k < ticks.count; k++) {
        int wide = (int)strlen(ticks.text[k]), column = (int)dot_x(f, ticks.at[k]) / c->across;
        int at = column - wide / 2;
        at = at + wide > c->width ? c->width - wide : at;
        if (at < free_from)
            continue;
        free_from = at + wide + 1;
        canvas_text(c, column, c->bottom, boxes ? "┴" : "+", INK_TEXT);
        canvas_text(c, at, label_row, ticks.text[k], INK_TEXT);
    }
}

static void events_draw(struct frame *f)
{
    struct canvas *c = &f->canvas;
    double wide = c->right - c->left;
    struct event_spot spot[CHART_EVENTS];
    event_spots(f->chart, 1 / wide, spot);
    for (int k = 0; k < f->chart->events; k++) {
        double x = clamp(dot_x(f, f->chart->event[k].x), c->left * c->across, c->right * c->across - 1);
        int phase = 0;
        canvas_line(c, x, c->bottom * c->down - 1, x, c->top * c->down, INK_GREY, 2, &phase);
        canvas_text(c, c->left + (int)floor(spot[k].from * wide), c->top - 1 - spot[k].row,
                    f->chart->event[k].name, INK_TEXT);
    }
}

/* ---- Maps ---- */

/* Characters for the values of a map, from the lowest to the highest. */
#define SHADES ".:-=+*#%@"

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

static void map_draw(struct frame *f)
{
    struct canvas *c = &f->canvas;
    const struct chart_map *m = &f->chart->map;
    const int wide = c->right - c->left, tall = c->bottom - c->top;
    double low, high;
    map_ends(m, &low, &high);
    for (int row = 0; row < tall; row++)
        for (int column = 0; column < wide; column++) {
            const int i = (2 * column + 1) * m->across / (2 * wide),
                      k = (2 * (tall - row) - 1) * m->down / (2 * tall);
            const double value = m->value[k * m->across + i], size = high > low ? high - low : 1;
            const char shade[2] = {isfinite(value) ? SHADES[(int)(8.999 * (value - low) / size)] : ' '};
            canvas_text(c, c->left + column, c->top + row, shade, INK_TEXT);
        }
}

/* ---- The legend ---- */

static bool has_points(enum chart_kind kind)
{
    return kind == CHART_POINTS || kind == CHART_MARKED;
}

/* Writes the legend: the titles of the curves, or the shades of the map. `row` is its first row. If `row` is
 * negative, writes nothing and only counts the rows. Returns the number of rows. */
static int legend(struct frame *f, int row)
{
    struct canvas *c = &f->canvas;
    const struct chart *chart = f->chart;
    int column = 2, rows = 0;
    if (chart->map.value) {
        char text[CHART_TEXT];
        double low, high;
        map_ends(&chart->map, &low, &high);
        snprintf(text, sizeof text, "%s: %.4g %s %.4g", chart->map.label, low, SHADES, high);
        return text_put(row < 0 ? NULL : c, 2, c->width, row, f->most, false, text);
    }
    for (const struct chart_curve *curve = chart->curve; curve < chart->curve + chart->curves; curve++) {
        char sample[4 * GLYPH], text[160];
        if (!*curve->title)
            continue;
        canvas_sample(c, curve->ink, curve->dash, sample);
        if (c->display.braille && has_points(curve->kind))
            snprintf(sample, sizeof sample, "●");
        snprintf(text, sizeof text, " %.150s", curve->title);
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

/* ---- The whole chart ---- */

bool chart_text(const struct chart *chart, struct display display, int width, int height, FILE *out)
{
    struct frame f = {
        .chart = chart, .x = chart->x, .y = chart->y, .most = height / 10 > 0 ? height / 10 : 1};
    struct canvas *c = &f.canvas;
    struct event_spot spot[CHART_EVENTS];
    const int note_rows = *chart->note ? 1 + utf8_columns(chart->note) / (width - 4) : 0;
    if (!canvas_make(c, display, width, height - note_rows))
        return false;
    const int title_rows = text_put(c, 0, width, 0, f.most, true, chart->title),
              label_rows = text_put(NULL, AXIS_USUAL, width, 0, f.most, true, chart->x.label),
              legend_rows = legend(&f, -1);
    c->top = title_rows + text_put(c, 0, width, title_rows, f.most, false, chart->y.label) +
             event_spots(chart, 1.0 / (width - AXIS_USUAL), spot);
    c->bottom -= 2 + label_rows;
    /* Rows of the legend that do not fit are not drawn. */
    const int room = c->bottom - c->top - ROWS_LEAST;
    c->bottom -= legend_rows < room ? legend_rows : room > 0 ? room : 0;
    const int rows = c->bottom - c->top;
    const struct ticks ticks = axis_ticks(&chart->y, rows < 6 ? 3 : rows / 3);
    c->left = ticks.widest + 3;
    if (chart->map.value)
        map_draw(&f);
    events_draw(&f);
    for (const struct chart_curve *curve = chart->curve; curve < chart->curve + chart->curves; curve++) {
        if (curve->kind != CHART_POINTS)
            curve_draw(&f, curve);
        if (has_points(curve->kind))
            points_draw(&f, curve);
    }
    axis_y_draw(&f, &ticks);
    axis_x_draw(&f, c->bottom + 1);
    text_put(c, c->left, c->right, c->bottom + 2, f.most, true, chart->x.label);
    legend(&f, c->bottom + 2 + label_rows);
    canvas_write(c, out);
    free(c->cell);
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
static void area_fill(struct canvas *c, const double *x, const double *y, int n, const char *mark,
                      enum ink ink)
{
    const int low[] = {c->left * c->across, c->top * c->down},
              high[] = {c->right * c->across, c->bottom * c->down};
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
                        canvas_text(c, way ? line : at, way ? at : line, mark, ink);
                    else
                        canvas_dot(c, way ? line : at, way ? at : line, ink);
            }
        }
    }
}

/* Returns the dot at a point of a stage. The ground is the lower edge of the lowest dots. */
static struct point stage_dot(const struct frame *f, struct point p)
{
    const struct canvas *c = &f->canvas;
    const double wide = (c->right - c->left) * c->across, high = (c->bottom - c->top) * c->down;
    return (struct point){c->left * c->across + wide * axis_place(&f->x, p.x),
                          c->bottom * c->down - 0.02 - high * axis_place(&f->y, p.y)};
}

/* Draws the outline of a domino, and fills it if it is marked or if there is no braille. */
static void domino_draw(struct frame *f, const struct drawn *d)
{
    static const enum ink inks[PARTS] = {[HEAD] = INK_BLUE, [FALLS] = INK_ORANGE, [WEAKEST] = INK_RED};
    const bool braille = f->canvas.display.braille;
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
        canvas_line(&f->canvas, x[i], y[i], x[(i + 1) % n], y[(i + 1) % n], inks[d->part], 0, &phase);
    if (!braille || drawn_marked(d))
        area_fill(&f->canvas, x, y, n, braille ? NULL : mark, inks[d->part]);
}

/* Writes the names of the dominoes below them. `unit` is the width of a column. */
static void names_draw(struct frame *f, const struct stage *stage, double unit)
{
    struct drawn_name name[NAMES];
    const int count = stage_names(stage, unit, 0.99 * unit, true, f->x.low, f->x.high, name);
    canvas_text(&f->canvas, 0, f->canvas.bottom + 1, "domino", INK_TEXT);
    for (int k = 0; k < count; k++)
        canvas_text(&f->canvas, f->canvas.left + (int)((name[k].from - f->x.low) / unit + 0.5),
                    f->canvas.bottom + 1, name[k].text, INK_TEXT);
}

bool stage_text(const struct stage *stage, struct display display, int width, int height, FILE *out)
{
    enum {
        LEFT = 7,       /* columns for the vertical scale */
        FILM_LINES = 3, /* lines for the caption of a film that follows the fall */
        BELOW = 3,      /* rows for the ground, the names of the dominoes, and the ruler */
        WIDTH_MOST = 200
    };
    int lines = 0;
    width = width < WIDTH_MOST ? width : WIDTH_MOST;
    for (const char *text = stage->caption; *text; lines++) {
        const size_t n = line_break(text, width);
        fprintf(out, "%.*s\n", (int)n, text);
        text += n + (text[n] == ' ' || text[n] == '\n');
    }
    for (; stage->tall > 0 && lines < FILM_LINES; lines++) /* the frames of a film have the same height */
        fputc('\n', out);
    /* A free column on either side leaves room for the outlines at the ends. `unit` is the width of a column.
     */
    struct frame f = {.x.low = stage->left};
    int bottom = (int)fmax(height - lines - BELOW, 1);
    double unit = fmax((stage->right - stage->left) / (width - LEFT - 2), 1.02 * stage->top / (2 * bottom));
    f.x.low -= unit;
    if (stage->tall > 0) {
        unit = stage->tall / (2 * bottom);
        f.x.low = stage->at - 0.45 * (width - LEFT) * unit;
    } else {
        bottom = (int)fmin(bottom, ceil(1.02 * stage->top / (2 * unit)));
    }
    f.x.high = f.x.low + (width - LEFT) * unit;
    f.y.high = 2 * unit * bottom;
    const struct axis_unit shown = stage_unit(stage, f.x.high - f.x.low);
    f.x.unit = f.y.unit = shown.size;
    if (!canvas_make(&f.canvas, display, width, bottom + BELOW))
        return false;
    f.canvas.left = LEFT;
    f.canvas.bottom = bottom;
    for (size_t k = stage->count; k-- > 0;)
        domino_draw(&f, stage_front(stage, k));
    for (size_t k = 0; k < stage->count && !display.braille; k++) {
        const struct drawn *d = &stage->domino[k];
        const struct point dot = stage_dot(&f, d->contact);
        if (d->touched && d->height > 4 * unit)
            canvas_text(&f.canvas, (int)dot.x, (int)dot.y, "@", INK_TEXT);
    }
    const struct ticks ticks = axis_ticks(&f.y, bottom < 6 ? 3 : bottom / 3);
    axis_y_draw(&f, &ticks);
    names_draw(&f, stage, unit);
    char text[32];
    snprintf(text, sizeof text, "%*s[%s]", LEFT - 3 - (int)strlen(shown.name), "", shown.name);
    canvas_text(&f.canvas, 0, bottom + 2, text, INK_TEXT);
    axis_x_draw(&f, bottom + 2);
    canvas_write(&f.canvas, out);
    free(f.canvas.cell);
    return true;
}

/* ---- To the destination of an answer ---- */

/* Draws a chart, or a stage if chart is NULL. */
static bool show(const struct answer *a, const struct chart *chart, const struct stage *stage,
                 struct problem *problem)
{
    enum { TEXT_WIDTH = 79, TEXT_HEIGHT = 23, PDF_WIDE = 16 };
    enum { STAGE_LEAST = 190, STAGE_MOST = 560 }; /* the minimum and maximum height of a sheet, in dots */
    if (picture_is_filed(a)) {
        struct picture picture;
        const struct sheet sheet =
            stage ? sheet_of(stage, STAGE_LEAST, STAGE_MOST) : (struct sheet){.height = PICTURE_HEIGHT};
        if (!picture_begin(&picture, a, sheet.height, PDF_WIDE, 0, problem))
            return false;
        if (chart)
            chart_script(chart, picture.script);
        else
            stage_script(stage, &sheet, picture.script);
        return picture_end(&picture, true, problem);
    }
    int width, height;
    const struct display display = display_of(a->out);
    progress_end();
    terminal_size(a->out, &width, &height);
    width = width >= PICTURE_LEAST_WIDTH ? width - 1 : TEXT_WIDTH;
    height =
        height >= PICTURE_LEAST_HEIGHT ? height - 1 : TEXT_HEIGHT; /* one line is left for the next prompt */
    /* The height is at most half of the usual width, because characters are twice as tall as wide. */
    height = height > TEXT_WIDTH / 2 ? TEXT_WIDTH / 2 : height;
    return (chart ? chart_text(chart, display, width, height, a->out)
                  : stage_text(stage, display, width, height, a->out)) ||
           problem_error(problem, "%s", dom_status_text(DOM_NO_MEMORY));
}

bool chart_show(struct chart *chart, const struct answer *a, struct problem *problem)
{
    chart_prepare(chart);
    const bool shown = chart->failed ? problem_error(problem, "%s", dom_status_text(DOM_NO_MEMORY))
                                     : show(a, chart, NULL, problem);
    chart_free(chart);
    return shown;
}

bool stage_show(const struct stage *stage, const struct answer *a, struct problem *problem)
{
    return show(a, NULL, stage, problem);
}
