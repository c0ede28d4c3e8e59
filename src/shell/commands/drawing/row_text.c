/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The row in characters, to scale: a row of them is as high as two are wide. */
#include "commands/drawing/row_text.h"
#include "answer/measure.h"
#include "language/quad.h"
#include "picture/canvas.h"
#include <stdlib.h>
#include <string.h>

enum { LEFT = 7, BELOW = 3, WIDTH_MOST = 200 }; /* the heights at the left; ground, numbers and tape below */

struct grid {
    int width, height;
    double left, unit; /* m: of the left end, and of a column */
    char *cell;
};

static void grid_put(struct grid *g, double x, double y, char mark)
{
    int column = (int)quad(floor)((domq_real)((x - g->left) / g->unit));
    int row = g->height - 1 - (int)quad(floor)((domq_real)(y / (2 * g->unit)));
    if (column >= 0 && column < g->width && row >= 0 && row < g->height && y >= 0)
        g->cell[row * g->width + column] = mark;
}

/* Points on a grid finer than the characters, over the face of the domino but not on its edges. */
static void grid_fill(struct grid *g, const struct drawn *k, double thickness, char mark)
{
    const struct point *p = k->corner;
    int rows = (int)(3 * k->height / g->unit) + 2, columns = (int)(3 * thickness / g->unit) + 2;
    for (int i = 0; i <= rows; i++)
        for (int j = 0; j <= columns; j++) {
            double up = 0.02 + 0.96 * i / rows, back = (j + 0.5) / (columns + 1);
            grid_put(g, p[0].x + up * (p[1].x - p[0].x) + back * (p[3].x - p[0].x),
                     p[0].y + up * (p[1].y - p[0].y) + back * (p[3].y - p[0].y), mark);
        }
}

static char mark_of(const struct falling_row *row, size_t k)
{
    static const char digits[] = "1234567890", ends[] = ROW_MARK_ENDS, weakest[] = ROW_MARK_WEAKEST;
    const char *mark = row_ends_at(row, k) ? ends : row_weakest_is(row, k) ? weakest : &digits[k % 10];
    return *mark;
}

/* Writes text around a column of a line, unless something is there already. */
static bool line_put(char *line, int width, int column, const char *text)
{
    int n = (int)strlen(text), from = column - n / 2;
    from = from < 0 ? 0 : from + n > width ? width - n : from;
    for (int i = from - 1; i <= from + n; i++)
        if (i >= 0 && i < width && line[i] != ' ')
            return false;
    if (from < 0)
        return false;
    memcpy(line + from, text, (size_t)n);
    return true;
}

static int column_of(const struct grid *g, double x)
{
    return (int)quad(floor)((domq_real)((x - g->left) / g->unit));
}

static void line_write(FILE *out, const char *head, const char *line, int width)
{
    while (width > 0 && line[width - 1] == ' ')
        width--;
    fprintf(out, "%*s%.*s\n", width > 0 || *head ? LEFT : 0, head, width, line);
}

/* The ground, the numbers of the dominoes below it, and the tape measure. */
static void ground_write(const struct grid *g, const struct falling_row *row, FILE *out)
{
    char line[WIDTH_MOST + 1], text[64];
    struct axis_unit unit = measure_axis(g->unit * g->width);
    double step = row_step(9 * g->unit / unit.size) * unit.size;
    memset(line, '-', sizeof line);
    for (int k = 0; k * step < g->left + g->unit * g->width; k++)
        if (column_of(g, k * step) < g->width)
            line[column_of(g, k * step)] = '+';
    line_write(out, "0 -", line, g->width);
    memset(line, ' ', sizeof line);
    for (int pass = 0; pass < 2; pass++)
        for (size_t k = 0; k < row->count; k++)
            if (pass == (int)!(row_ends_at(row, k) || row_weakest_is(row, k))) {
                snprintf(text, sizeof text, "%zu", k + 1);
                (void)line_put(line, g->width,
                               column_of(g, row->at[k] + (double)row->scene.domino[k].thickness / 2), text);
            }
    line_write(out, "domino ", line, g->width);
    memset(line, ' ', sizeof line);
    for (int n = 0; n * step < g->left + g->unit * g->width; n++) {
        snprintf(text, sizeof text, "%.6g", n * step / unit.size);
        (void)line_put(line, g->width, column_of(g, n * step), text);
    }
    snprintf(text, sizeof text, "[%s] ", unit.name);
    line_write(out, text, line, g->width);
}

/* ---- In braille ---- */

const char *row_text_weakest(FILE *out)
{
    struct look look = look_of(out);
    return !look.braille ? ROW_MARK_WEAKEST : look.colours ? "red" : "filled";
}

const char *row_text_end(FILE *out)
{
    return look_of(out).braille ? "filled" : ROW_MARK_ENDS;
}

/* Draws one domino: its outline, or all of it where it is marked. */
static void canvas_domino(struct canvas *c, const struct grid *g, const struct falling_row *row, size_t k,
                          const struct drawn *d, size_t head)
{
    bool weakest = row_weakest_is(row, k), filled = weakest || row_ends_at(row, k),
         moved = d->theta > falling_row_lean(row, k) || k + 1 == head;
    enum ink ink = weakest         ? INK_RED
                   : filled        ? INK_TEXT
                   : k + 1 == head ? INK_BLUE
                   : moved         ? INK_ORANGE
                                   : INK_TEXT;
    double dot = g->unit / c->across, bottom = (double)(c->height * c->down) - 1;
    double x[CORNERS], y[CORNERS];
    int phase = 0;
    for (int i = 0; i < CORNERS; i++) {
        x[i] = (double)quad(round)((domq_real)((d->corner[i].x - g->left) / dot));
        y[i] = bottom - (double)quad(round)((domq_real)(d->corner[i].y / dot));
    }
    for (int i = 0; i < CORNERS; i++)
        canvas_line(c, x[i], y[i], x[(i + 1) % CORNERS], y[(i + 1) % CORNERS], ink, 0, &phase);
    int steps = filled ? 2 * (int)((double)row->scene.domino[k].thickness / dot) + 1 : 0;
    for (int i = 1; i < steps; i++) {
        double part = (double)i / steps;
        canvas_line(c, x[0] + part * (x[3] - x[0]), y[0] + part * (y[3] - y[0]), x[1] + part * (x[2] - x[1]),
                    y[1] + part * (y[2] - y[1]), ink, 0, &phase);
    }
}

/* Draws the dominoes in as many lines as they need of the grid. */
static bool braille_write(struct grid *g, const struct falling_row *row, const double *tilt, size_t head,
                          struct look look, double step, struct axis_unit unit, FILE *out)
{
    struct canvas c;
    double top = 0;
    for (size_t k = 0; k < row->count; k++) {
        struct drawn d = falling_row_domino(row, k, tilt ? tilt[k] : falling_row_lean(row, k));
        for (int i = 0; i < CORNERS; i++)
            top = d.corner[i].y > top ? d.corner[i].y : top;
    }
    int lines = (int)(top / (2 * g->unit)) + 1;
    g->height = lines < g->height ? lines : g->height;
    if (!canvas_make(&c, look, g->width + LEFT, g->height))
        return false;
    g->left -= LEFT * g->unit; /* the canvas has the heights, too */
    for (size_t k = 0; k < row->count; k++) {
        struct drawn d = falling_row_domino(row, k, tilt ? tilt[k] : falling_row_lean(row, k));
        canvas_domino(&c, g, row, k, &d, head);
    }
    g->left += LEFT * g->unit;
    for (int n = 1; n * step < 2 * g->unit * g->height; n++) {
        char text[32];
        snprintf(text, sizeof text, "%*.4g -", LEFT - 2, n * step / unit.size);
        canvas_text(&c, 0, g->height - 1 - (int)(n * step / (2 * g->unit)), text, INK_TEXT);
    }
    canvas_write(&c, out);
    canvas_free(&c);
    return true;
}

bool row_text(const struct falling_row *row, const double *tilt, size_t head, double right, int width,
              int height, FILE *out)
{
    struct grid g = {.width = (width < WIDTH_MOST ? width : WIDTH_MOST) - LEFT, .height = height - BELOW};
    double across = right / g.width, up = 1.02 * row->tallest / (2 * g.height);
    struct axis_unit unit = measure_axis(right);
    g.unit = across > up ? across : up;
    g.left = -g.unit;
    double step = row_step(6 * g.unit / unit.size) * unit.size;
    struct look look = look_of(out);
    if (look.braille) {
        bool drawn = braille_write(&g, row, tilt, head, look, step, unit, out);
        if (drawn)
            ground_write(&g, row, out);
        return drawn;
    }
    size_t cells = (size_t)g.width * (size_t)g.height;
    g.cell = malloc(cells);
    if (!g.cell)
        return false;
    memset(g.cell, ' ', cells);
    for (size_t k = row->count; k-- > 0;) {
        struct drawn d = falling_row_domino(row, k, tilt ? tilt[k] : falling_row_lean(row, k));
        grid_fill(&g, &d, (double)row->scene.domino[k].thickness, mark_of(row, k));
    }
    int top = 0; /* rows of blanks alone are left out above */
    while (top < g.height && strspn(g.cell + (size_t)top * (size_t)g.width, " ") >= (size_t)g.width)
        top++;
    for (int i = top; i < g.height; i++) {
        char mark[32] = "";
        double low = 2 * g.unit * (g.height - 1 - i), n = (double)quad(ceil)((domq_real)(low / step));
        if (n > 0 && n * step < low + 2 * g.unit)
            snprintf(mark, sizeof mark, "%.4g -", n * step / unit.size);
        line_write(out, mark, g.cell + (size_t)i * (size_t)g.width, g.width);
    }
    ground_write(&g, row, out);
    free(g.cell);
    return true;
}
