/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The row in characters, to scale: a row of them is as high as two are wide. */
#include "commands/row_text.h"
#include "answer/measure.h"
#include "language/quad.h"
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
    return row_ends_at(row, k)      ? ROW_MARK_ENDS
           : row_weakest_is(row, k) ? ROW_MARK_WEAKEST
                                    : "1234567890"[k % 10];
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
    struct row_unit unit = row_unit(g->unit * g->width);
    double step = row_step(9 * g->unit / unit.size) * unit.size;
    memset(line, '-', sizeof line);
    for (double x = 0; x < g->left + g->unit * g->width; x += step)
        if (column_of(g, x) < g->width)
            line[column_of(g, x)] = '+';
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

bool row_text(const struct falling_row *row, const double *tilt, double right, int width, int height,
              FILE *out)
{
    struct grid g = {.width = (width < WIDTH_MOST ? width : WIDTH_MOST) - LEFT, .height = height - BELOW};
    double across = right / g.width, up = row->tallest / (2 * g.height);
    struct row_unit unit = row_unit(right);
    g.unit = across > up ? across : up;
    g.left = -g.unit;
    g.cell = malloc((size_t)(g.width * g.height));
    if (!g.cell)
        return false;
    memset(g.cell, ' ', (size_t)(g.width * g.height));
    for (size_t k = row->count; k-- > 0;) {
        struct drawn d = falling_row_domino(row, k, tilt ? tilt[k] : 0);
        grid_fill(&g, &d, (double)row->scene.domino[k].thickness, mark_of(row, k));
    }
    double step = row_step(6 * g.unit / unit.size) * unit.size;
    int top = 0; /* rows of blanks alone are left out above */
    while (top < g.height && strspn(g.cell + (size_t)top * (size_t)g.width, " ") >= (size_t)g.width)
        top++;
    for (int i = top; i < g.height; i++) {
        char head[32] = "";
        double low = 2 * g.unit * (g.height - 1 - i), n = (double)quad(ceil)((domq_real)(low / step));
        if (n > 0 && n * step < low + 2 * g.unit)
            snprintf(head, sizeof head, "%.4g -", n * step / unit.size);
        line_write(out, head, g.cell + (size_t)i * (size_t)g.width, g.width);
    }
    ground_write(&g, row, out);
    free(g.cell);
    return true;
}
