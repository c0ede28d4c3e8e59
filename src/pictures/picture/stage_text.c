/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws a stage with characters, to scale. A character is assumed to be twice as high as it is wide. */
#include "answer/wrap.h"
#include "language/text.h"
#include "pictures/picture/stage.h"
#include <math.h>
#include <string.h>

enum {
    LEFT = 7,       /* columns for the vertical scale */
    FILM_LINES = 3, /* lines for the caption of a film that follows the fall */
    BELOW = 3,      /* rows for the ground, the numbers of the dominoes, and the ruler */
    WIDTH_MOST = 200
};

struct grid {
    struct canvas canvas;
    double left, unit; /* where the canvas begins on the stage, and the width of a column */
    int ground;        /* the row of the canvas that shows the ground */
};

struct marks text_marks(struct display display)
{
    return (struct marks){.theta = "theta",
                          .weakest = !display.braille  ? "*"
                                     : display.colours ? "red"
                                                       : "filled",
                          .ends = display.braille ? "filled" : "X",
                          .contacts = display.braille ? "" : "; #: the next; @: contact"};
}

static int column_of(const struct grid *g, double x)
{
    return (int)floor((x - g->left) / g->unit);
}

/* ---- Dominoes ---- */

static enum ink ink_of(const struct drawn *k)
{
    static const enum ink inks[PARTS] = {[HEAD] = INK_BLUE, [FALLS] = INK_ORANGE, [WEAKEST] = INK_RED};
    return inks[k->part];
}

/* Returns the part of a domino, along its height or its thickness, in which all its visible points are.
 * `from` and `to` are the ends of the height or of the thickness. The part is empty for a domino that is not
 * visible. In a film that follows the fall, dominoes can be much larger than the picture. */
struct part_seen {
    double low, high;
};
static struct part_seen part_seen(const struct grid *g, struct point from, struct point to)
{
    const double x = to.x - from.x, y = to.y - from.y, length = x * x + y * y,
                 right = g->left + g->canvas.width * g->unit, high = 2 * g->unit * g->ground;
    struct part_seen seen = {HUGE_VAL, -HUGE_VAL};
    for (int corner = 0; corner < 4; corner++) {
        const double along =
            ((corner % 2 ? right : g->left) - from.x) * x + ((corner / 2 ? high : 0) - from.y) * y;
        seen.low = fmin(seen.low, along / length);
        seen.high = fmax(seen.high, along / length);
    }
    return (struct part_seen){fmax(seen.low, 0), fmin(seen.high, 1)};
}

/* Fills a domino with a character, by sampling points that are closer together than characters. */
static void domino_fill(struct grid *g, const struct stage *stage, const struct drawn *k)
{
    const char mark[2] = {(char)(k->part == ENDS      ? 'X'
                                 : k->part == WEAKEST ? '*'
                                 : k->number < 0      ? '#'
                                                      : '0' + k->number % 10)};
    /* A domino that is taller than the picture is cut off. Only one domino can be too tall: the upright
     * domino in front of a train. */
    double seen = k->height > stage->top ? stage->top / k->height : 1;
    const struct point *p = k->corner;
    const struct part_seen tall = part_seen(g, p[0], p[1]), thick = part_seen(g, p[0], p[3]);
    if (!(tall.low < tall.high && thick.low < thick.high))
        return;
    int rows = (int)(3 * seen * (tall.high - tall.low) * k->height / g->unit) + 2,
        columns = (int)(3 * (thick.high - thick.low) * k->thickness / g->unit) + 2;
    for (int i = 0; i <= rows; i++)
        for (int j = 0; j <= columns; j++) {
            /* points on the edges would make the domino one character wider */
            double up = seen * (0.02 + 0.96 * (tall.low + (tall.high - tall.low) * i / rows)),
                   back = thick.low + (thick.high - thick.low) * (j + 0.5) / (columns + 1);
            double x = p[0].x + up * (p[1].x - p[0].x) + back * (p[3].x - p[0].x);
            double y = p[0].y + up * (p[1].y - p[0].y) + back * (p[3].y - p[0].y);
            int column = column_of(g, x), row = g->ground - 1 - (int)floor(y / (2 * g->unit));
            if (column >= LEFT && row < g->ground && drawn_covers(k, up, back))
                canvas_text(&g->canvas, column, row, mark, ink_of(k));
        }
}

/* Draws the outline of a domino and fills it if the domino is marked. */
static void domino_outline(struct grid *g, const struct drawn *k)
{
    struct canvas *c = &g->canvas;
    bool filled = drawn_marked(k);
    double dot = g->unit / c->across, bottom = (double)(g->ground * c->down) - 1, x[OUTLINE] = {0},
           y[OUTLINE] = {0};
    struct point outline[OUTLINE];
    /* Rounded edges are too small to be seen, so only silhouettes need the exact outline. */
    bool is_silhouette = k->number == NUMBER_TOWER || k->number == NUMBER_PERSON;
    int phase = 0, count = is_silhouette ? drawn_outline(k, outline) : CORNERS;
    for (int i = 0; i < count; i++) {
        const struct point *p = is_silhouette ? &outline[i] : &k->corner[i];
        x[i] = round((p->x - g->left) / dot);
        y[i] = bottom - round(p->y / dot);
    }
    for (int i = 0; i < count; i++)
        canvas_line(c, x[i], y[i], x[(i + 1) % count], y[(i + 1) % count], ink_of(k), 0, &phase);
    int steps = filled ? 2 * (int)(k->thickness / dot) + 1 : 0;
    for (int i = 1; i < steps; i++) {
        double part = (double)i / steps;
        canvas_line(c, x[0] + part * (x[3] - x[0]), y[0] + part * (y[3] - y[0]), x[1] + part * (x[2] - x[1]),
                    y[1] + part * (y[2] - y[1]), ink_of(k), 0, &phase);
    }
}

static bool is_seen(const struct grid *g, const struct drawn *k)
{
    const struct part_seen tall = part_seen(g, k->corner[0], k->corner[1]),
                           thick = part_seen(g, k->corner[0], k->corner[3]);
    return tall.low < tall.high && thick.low < thick.high;
}

static void dominoes_draw(struct grid *g, const struct stage *stage)
{
    for (size_t k = stage->count; k-- > 0;)
        if (stage->tall > 0 && !is_seen(g, stage_front(stage, k)))
            continue;
        else if (g->canvas.display.braille)
            domino_outline(g, stage_front(stage, k));
        else
            domino_fill(g, stage, &stage->domino[k]);
    for (size_t k = 0; k < stage->count && !g->canvas.display.braille; k++) {
        const struct drawn *d = &stage->domino[k];
        if (d->touched && d->height > 4 * g->unit)
            canvas_text(&g->canvas, column_of(g, d->contact.x),
                        g->ground - 1 - (int)floor(d->contact.y / (2 * g->unit)), "@", INK_TEXT);
    }
}

/* ---- The ruler and the numbers ---- */

/* Writes a label centred on a column, unless it would overlap another label. */
static void label_put(struct canvas *c, int column, int row, const char *text)
{
    int n = (int)strlen(text), from = column - n / 2;
    from = from < LEFT ? LEFT : from + n > c->width ? c->width - n : from;
    for (int i = from > LEFT ? from - 1 : LEFT; i <= from + n; i++)
        if (!canvas_blank(c, i, row))
            return;
    canvas_text(c, from, row, text, INK_TEXT);
}

/* Draws the ground with the ruler, and the vertical scale from the ground up to row `top`. */
static void ruler_draw(struct grid *g, const struct stage *stage, int top)
{
    struct canvas *c = &g->canvas;
    char text[32];
    struct axis_unit unit = stage_unit(stage, g->unit * (c->width - LEFT));
    double high = ruler_step(6 * g->unit / unit.size) * unit.size,
           wide = ruler_step(9 * g->unit / unit.size) * unit.size;
    for (int n = 0; n * high < 2 * g->unit * g->ground; n++) {
        int row = n == 0 ? g->ground : g->ground - 1 - (int)floor(n * high / (2 * g->unit));
        snprintf(text, sizeof text, "%*.4g -", LEFT - 2, n * high / unit.size);
        if (row >= top)
            canvas_text(c, 0, row, text, INK_TEXT);
    }
    for (int column = LEFT; column < c->width; column++)
        canvas_text(c, column, g->ground, "-", INK_TEXT);
    snprintf(text, sizeof text, "%*s[%s]", LEFT - 3 - (int)strlen(unit.name), "", unit.name);
    canvas_text(c, 0, g->ground + 2, text, INK_TEXT);
    for (int n = (int)ceil((g->left + LEFT * g->unit) / wide); column_of(g, n * wide) < c->width; n++) {
        canvas_text(c, column_of(g, n * wide), g->ground, "+", INK_TEXT);
        snprintf(text, sizeof text, "%.6g", n * wide / unit.size);
        label_put(c, column_of(g, n * wide), g->ground + 2, text);
    }
}

/* Where numbers would overlap, marked dominoes have priority. */
static void numbers_draw(struct grid *g, const struct stage *stage)
{
    struct canvas *c = &g->canvas;
    canvas_text(c, 0, g->ground + 1, "domino", INK_TEXT);
    for (int pass = 0; pass < 2; pass++)
        for (size_t k = 0; k < stage->count; k++) {
            const struct drawn *d = &stage->domino[k];
            char name[DRAWN_NAME + CELL_TEXT];
            const int column = column_of(g, d->foot - d->thickness / 2);
            const bool is_beyond = stage->tall > 0 && (column < LEFT || column >= c->width);
            if (drawn_marked(d) != (pass == 0) || !drawn_name(d, name) || is_beyond)
                continue;
            if (stage->tall > 0 && d->number == NUMBER_TOWER)
                text_add(name, sizeof name, " %s", measured((domq_real)d->height, "m", 4).text);
            label_put(c, column, g->ground + 1, name);
        }
}

/* Returns the number of lines. */
static int caption_write(const char *text, int width, FILE *out)
{
    int lines = 0;
    for (size_t n; *text; lines++, text += n + (text[n] == ' ' || text[n] == '\n')) {
        n = line_break(text, width);
        fprintf(out, "%.*s\n", (int)n, text);
    }
    return lines;
}

bool stage_text(const struct stage *stage, struct display display, int width, int height, FILE *out)
{
    width = width < WIDTH_MOST ? width : WIDTH_MOST;
    int lines = caption_write(stage->caption, width, out), top = 0;
    for (; stage->tall > 0 && lines < FILM_LINES; lines++) /* the frames of a film have the same height */
        fputc('\n', out);
    int rows = height - lines;
    struct grid g = {.ground = rows - BELOW};
    if (!canvas_make(&g.canvas, display, width, rows))
        return false;
    /* A free column on either side leaves room for the outlines at the ends. */
    double across = (stage->right - stage->left) / (width - LEFT - 2),
           up = 1.02 * stage->top / (2 * g.ground);
    g.unit = across > up ? across : up;
    g.left = stage->left - (LEFT + 1) * g.unit;
    if (stage->tall > 0) {
        g.unit = stage->tall / (2 * g.ground);
        g.left = stage->at - (LEFT + 0.45 * (width - LEFT)) * g.unit;
    }
    dominoes_draw(&g, stage);
    for (bool blank = stage->tall <= 0; blank && top < g.ground;
         top += blank) /* empty rows at the top are skipped */
        for (int column = 0; column < width && blank; column++)
            blank = canvas_blank(&g.canvas, column, top);
    ruler_draw(&g, stage, top);
    numbers_draw(&g, stage);
    canvas_write(&g.canvas, top, out);
    canvas_free(&g.canvas);
    return true;
}
