/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/drawing/row_picture.h"
#include "answer/measure.h"
#include "language/quad.h"
#include <string.h>
#include <strings.h>

/* ---- The view ---- */

enum {
    FONT = 14,
    SMALL = 11, /* fonts, in dots */
    LINE = 19,  /* of the caption */
    STRIP = 17, /* below the ground: numbers */
    LEFT = 52,
    RIGHT = 12,
    BELOW = 50, /* margins */
    CLEAR = 6   /* above the tallest */
};

struct view view_of(double left, double right, double high, int lines, double height_least,
                    double height_most, double room)
{
    struct view v = {.width = VIEW_WIDTH,
                     .margin_left = LEFT,
                     .margin_right = RIGHT,
                     .margin_below = BELOW,
                     .margin_above = 10 + LINE * lines,
                     .size = FONT};
    double across = v.width - LEFT - RIGHT, upright = height_most - v.margin_above - BELOW - STRIP - room;
    double by_width = (right - left) / across, by_height = high / upright;
    v.per_dot = by_width > by_height ? by_width : by_height;
    double spare = across * v.per_dot - (right - left);
    v.left = left - spare / 2;
    v.right = right + spare / 2;
    v.low = -STRIP * v.per_dot;
    v.height = v.margin_above + BELOW + STRIP + room + high / v.per_dot;
    v.height = (double)quad(ceil)((domq_real)(v.height < height_least ? height_least : v.height));
    v.high = v.low + (v.height - v.margin_above - BELOW) * v.per_dot;
    return v;
}

double row_right(const struct falling_row *row, bool lying)
{
    double right = 0;
    for (size_t k = 0; k < row->count; k++) {
        const struct domq_domino *d = &row->scene.domino[k];
        double end = row->at[k] + (double)d->thickness + (lying ? (double)d->height : 0);
        right = end > right ? end : right;
    }
    return right;
}

/* ---- The tape measure ---- */

/* Writes tics each `step` units. Their texts are in units, their places in m. */
static void script_tics(FILE *script, const char *axis, double from, double to, double step, double unit)
{
    const char *comma = "";
    fprintf(script, "set %stics (", axis);
    for (double k = (double)quad(ceil)((domq_real)(from / (step * unit) - 1e-9));
         k * step * unit <= to * (1 + 1e-9); k++) {
        fprintf(script, "%s'%.10g' %.10g", comma, k * step + 0.0, k * step * unit + 0.0);
        comma = ", ";
    }
    fprintf(script, ") scale 0.6 offset 0,%s font ',%d'\n", *axis == 'x' ? "0.3" : "0", SMALL + 1);
}

void script_view(FILE *script, const struct view *v)
{
    double across = v->right - v->left;
    struct axis_unit of = measure_axis(across);
    double unit = of.size;
    const char *name = of.name;
    fprintf(script,
            "set lmargin at screen %.8g\nset rmargin at screen %.8g\nset bmargin at screen %.8g\n"
            "set tmargin at screen %.8g\nset xrange [%.10g:%.10g]\nset yrange [%.10g:%.10g]\n"
            "unset grid\nunset key\nset border 1 lc rgb '#404040'\nset tics out nomirror\n",
            v->margin_left / v->width, 1 - v->margin_right / v->width, v->margin_below / v->height,
            1 - v->margin_above / v->height, v->left, v->right, v->low, v->high);
    /* The tape begins at domino 1; above, the last tic keeps clear of the caption. */
    script_tics(script, "x", v->left > 0 ? v->left : 0, v->right, row_step(60 * v->per_dot / unit), unit);
    double up = row_step(34 * v->per_dot / unit);
    script_tics(script, "y", up * unit, v->high - 10 * v->per_dot, up, unit); /* the unit is written at 0 */
    fprintf(script, "set label 9002 '%s' at screen %.8g, first %.10g right font ',%d'\n", name,
            (v->margin_left - 12) / v->width, 0.0, SMALL + 1);
    fprintf(script, "set arrow 1 from %.10g,0 to %.10g,0 nohead lc rgb '#404040' lw 1.5 back\n", v->left,
            v->right);
    fprintf(
        script,
        "unset xlabel\nunset ylabel\nset label 9001 'tape measure from the back of domino 1 [%s]' at screen "
        "%.8g,%.8g center font ',%d'\n",
        name, (v->margin_left + (v->width - v->margin_left - v->margin_right) / 2) / v->width, 9 / v->height,
        SMALL + 1);
}

void script_sheet(FILE *script, const char *path, const struct view *v)
{
    const char *ending = strrchr(path, '.');
    bool png = strcasecmp(ending, ".png") == 0, pdf = strcasecmp(ending, ".pdf") == 0;
    if (pdf)
        fprintf(script, "set terminal pdfcairo size %.3fcm,%.3fcm font 'sans,%d' fontscale 0.67 enhanced\n",
                v->width / 40, v->height / 40, v->size);
    else if (png)
        fprintf(script,
                "set terminal pngcairo size %.0f,%.0f font 'sans,%d' fontscale %.3g linewidth 2 enhanced\n",
                2 * v->width, 2 * v->height, v->size, 2 * 0.72);
    else
        fprintf(
            script,
            "set terminal svg size %.0f,%.0f dynamic font 'sans-serif,%d' background rgb 'white' enhanced\n",
            v->width, v->height, v->size);
}

/* ---- The caption ---- */

int caption_wrap(const char *text, char line[CAPTION_LINES][ROW_SENTENCE], int columns)
{
    int lines = 0;
    while (*text && lines < CAPTION_LINES) {
        size_t length = strcspn(text, "\n"), cut = length;
        if (length > (size_t)columns) {
            cut = (size_t)columns;
            while (cut > 0 && text[cut] != ' ')
                cut--;
            cut = cut ? cut : (size_t)columns;
        }
        snprintf(line[lines++], ROW_SENTENCE, "%.*s", (int)cut, text);
        text += cut + (text[cut] == ' ' || text[cut] == '\n');
    }
    return lines;
}

void script_caption(FILE *script, const struct view *v, const char *text)
{
    char line[CAPTION_LINES][ROW_SENTENCE];
    int lines = caption_wrap(text, line, CAPTION_COLUMNS);
    for (int k = 0; k < lines; k++) {
        fprintf(script, "set label %d \"", 9010 + k);
        for (const char *c = line[k]; *c; c++)
            fprintf(script, *c == '"' || *c == '\\' ? "\\%c" : "%c", *c);
        fprintf(script, "\" at screen %.8g,%.8g left font ',%d' noenhanced front\n", 10 / v->width,
                1 - (16.0 + LINE * k) / v->height, v->size);
    }
}

/* ---- The dominoes ---- */

/* The colours of dominoes: they differ in lightness, too, so they stay apart in grey print and for
 * colour-blind people. */
enum part { STANDS, FALLS, HEAD, WEAKEST, ENDS, PARTS };
static const char *const fill[PARTS] = {"#f4efe2", "#e8b85a", "#4f95c4", "#c8400c", "#000000"};

static enum part part_of(const struct falling_row *row, size_t k, size_t head, bool moved)
{
    if (row_ends_at(row, k))
        return ENDS;
    if (row_weakest_is(row, k))
        return WEAKEST;
    return k + 1 == head && moved ? HEAD : moved ? FALLS : STANDS;
}

/* A text in the picture: its middle and its size, in dots, from the front of domino 1 and from the ground. */
struct box {
    double x, y, wide, high;
};

enum { BOXES = 256 };

/* Takes the room of a text, with a little around it; false where another text is. */
static bool box_take(struct box *taken, int *count, struct box own)
{
    for (int i = 0; i < *count; i++) {
        double x = own.x - taken[i].x, y = own.y - taken[i].y;
        if (2 * (x < 0 ? -x : x) < own.wide + taken[i].wide &&
            2 * (y < 0 ? -y : y) < own.high + taken[i].high)
            return false;
    }
    if (*count == BOXES)
        return false;
    taken[(*count)++] = own;
    return true;
}

static bool marked(const struct falling_row *row, size_t k)
{
    enum part part = part_of(row, k, 0, false);
    return part == WEAKEST || part == ENDS;
}

/* The numbers below the ground, those of the marked dominoes first, then from the last, the largest. */
static void script_numbers(FILE *script, const struct view *v, const struct falling_row *row)
{
    struct box taken[BOXES];
    int count = 0;
    for (int pass = 0; pass < 2; pass++)
        for (size_t k = row->count; k-- > 0;) {
            char number[24];
            double x = row->at[k] + (double)row->scene.domino[k].thickness / 2;
            int n = snprintf(number, sizeof number, "%zu", k + 1);
            struct box own = {x / v->per_dot, 0, n * SMALL * 0.62 + 4, 1};
            if (marked(row, k) != (pass == 0) || x < v->left || x > v->right || !box_take(taken, &count, own))
                continue;
            fprintf(script, "set label '%s' at %.8g,%.8g center font ',%d' tc rgb '%s' front\n", number, x,
                    v->low / 2, SMALL, part_of(row, k, 0, false) == WEAKEST ? fill[WEAKEST] : "#000000");
        }
}

/*
 * Writes the height of a domino, with the word that marks it; false: there is no room above, or the domino
 * before has the same height.
 */
static bool height_label(const struct view *v, const struct falling_row *row, size_t k, char text[64])
{
    const struct domq_domino *d = &row->scene.domino[k];
    double middle = row->at[k] + (double)d->thickness / 2, half = 0.6 * SMALL * v->per_dot;
    double before = k > 0 ? middle - row->at[k] + (double)d->gap : HUGE_VAL;
    double after = k + 1 < row->count ? row->at[k + 1] - middle : HUGE_VAL;
    enum part part = part_of(row, k, 0, false);
    struct measured height = measured(d->height, "m", 3);
    snprintf(text, 64, "%.30s%s", height.text,
             part == WEAKEST ? "  weakest"
             : part == ENDS  ? "  ends here"
                             : "");
    if (marked(row, k))
        return true;
    return before > half && after > half &&
           !(k > 0 && strcmp(measured(row->scene.domino[k - 1].height, "m", 3).text, height.text) == 0);
}

double row_label_room(const struct view *v, const struct falling_row *row)
{
    double room = CLEAR;
    for (size_t k = 0; k < row->count; k++) {
        char text[64];
        double height = (double)row->scene.domino[k].height;
        if (height_label(v, row, k, text)) {
            double needs = (height - row->tallest) / v->per_dot + CLEAR + (double)strlen(text) * SMALL * 0.62;
            room = needs > room ? needs : room;
        }
    }
    return room;
}

static void script_height(FILE *script, const struct view *v, const struct falling_row *row, size_t k,
                          struct box *taken, int *count)
{
    const struct domq_domino *d = &row->scene.domino[k];
    double middle = row->at[k] + (double)d->thickness / 2, top = (double)d->height;
    char text[64];
    if (!height_label(v, row, k, text))
        return;
    double length = (double)strlen(text) * SMALL * 0.62;
    struct box own = {middle / v->per_dot, top / v->per_dot + 5 + length / 2, 1.25 * SMALL, length + 4};
    if (box_take(taken, count, own))
        fprintf(script,
                "set label '%s' at %.8g,%.8g left rotate by 90 offset 0,0.35 font ',%d' tc rgb '%s' front\n",
                text, middle, top, SMALL, part_of(row, k, 0, false) == WEAKEST ? fill[WEAKEST] : "#000000");
}

static void script_gap(FILE *script, const struct view *v, const struct falling_row *row, size_t k,
                       struct box *taken, int *count)
{
    double gap = (double)row->scene.domino[k].gap, middle = row->at[k] - gap / 2;
    struct measured measure = measured(row->scene.domino[k].gap, "m", 3);
    double wide = (double)strlen(measure.text) * SMALL * 0.62;
    bool flat = gap > (wide + 4) * v->per_dot;
    struct box own = {middle / v->per_dot, 9, wide, SMALL};
    if (!flat)
        own = (struct box){middle / v->per_dot, 4 + wide / 2, 1.25 * SMALL, wide};
    if (k > 0 && gap > 1.4 * SMALL * v->per_dot && box_take(taken, count, own))
        fprintf(script, "set label '%s' at %.8g,%.8g %s font ',%d' tc rgb '#505050' front\n", measure.text,
                middle, (flat ? 9 : 4) * v->per_dot, flat ? "center" : "left rotate by 90", SMALL);
}

/*
 * Writes heights above the dominoes, upright, and gaps between their feet, where there is room: those of the
 * marked dominoes first, then from the last, the largest; heights before gaps.
 */
static void script_sizes(FILE *script, const struct view *v, const struct falling_row *row)
{
    struct box taken[BOXES];
    int count = 0;
    for (int pass = 0; pass < 3; pass++)
        for (size_t k = row->count; k-- > 0;)
            if (pass == 2)
                script_gap(script, v, row, k, taken, &count);
            else if (marked(row, k) == (pass == 0))
                script_height(script, v, row, k, taken, &count);
}

/* Writes the corners of those that look so, as curves that close. */
static int script_corners(FILE *script, const struct view *v, const struct falling_row *row,
                          const double *tilt, size_t head, enum part part)
{
    int count = 0;
    fprintf(script, "$part%d << END\n", (int)part);
    for (size_t k = 0; k < row->count; k++) {
        const double own = falling_row_lean(row, k), lean = tilt ? tilt[k] : own;
        if (part_of(row, k, head, lean > own || k + 1 == head) != part)
            continue;
        struct drawn domino = falling_row_domino(row, k, lean);
        if (domino.corner[0].x + domino.height < v->left || domino.corner[3].x > v->right)
            continue;
        struct point outline[OUTLINE];
        int n = drawn_outline(&domino, outline);
        for (int i = 0; i <= n; i++)
            fprintf(script, "%.8g %.8g\n", outline[i % n].x, outline[i % n].y);
        fprintf(script, "\n");
        count++;
    }
    fprintf(script, "END\n");
    return count;
}

void script_palette(FILE *script, const struct view *v, int shift)
{
    for (int part = 0; part < PARTS; part++)
        fprintf(script,
                "set object %d rectangle from screen %.6g,0 to screen %.6g,%.6g behind fs solid 1 noborder "
                "fc rgb "
                "'%s'\n",
                part + 1, 1.5 * part / v->width, 1.5 * (part + 1) / v->width, 1.5 / v->height,
                fill[(part + shift) % PARTS]);
}

void script_row(FILE *script, const struct view *v, const struct falling_row *row, const double *tilt,
                size_t head, bool labelled)
{
    const char *comma = "plot ";
    int count[PARTS];
    for (int part = 0; part < PARTS; part++)
        count[part] = script_corners(script, v, row, tilt, head, (enum part)part);
    script_numbers(script, v, row);
    if (labelled)
        script_sizes(script, v, row);
    for (int part = 0; part < PARTS; part++) {
        if (count[part] == 0)
            continue;
        fprintf(
            script,
            "%s$part%d with filledcurves closed fs solid 1 noborder fc rgb '%s', $part%d with lines lc rgb "
            "'#202020' lw 0.8 dt solid",
            comma, part, fill[part], part);
        comma = ", ";
    }
    fprintf(script, count[0] + count[1] + count[2] + count[3] + count[4] ? "\n" : "plot NaN\n");
}
