/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes a stage, to scale, as a gnuplot script. */
#include "io/terminal.h"
#include "pictures/picture/chart.h"
#include "pictures/picture/stage.h"
#include <math.h>
#include <string.h>

/* ---- The sheet, in dots ---- */

enum {
    SMALL = 11, /* font size of labels */
    LINE = 19,  /* the height of a line of the caption */
    STRIP = 17, /* the height of the area below the ground, for names */
    MARGIN_LEFT = 52,
    MARGIN_RIGHT = 12,
    MARGIN_BELOW = 50,
    CLEAR = 6, /* the empty space above the tallest domino */
    ACROSS = PICTURE_WIDTH - MARGIN_LEFT - MARGIN_RIGHT
};
#define LETTER (0.62 * SMALL) /* the maximum width of a character */
#define EDGE   0.02           /* the margin on each side, as a fraction of the visible width */

/* Writes the lines of a caption, if there is a script. Returns their number. */
static int caption_script(const char *text, const struct sheet *v, FILE *script)
{
    int line = 0;
    for (size_t n; *text; line++, text += n + (text[n] == ' ' || text[n] == '\n')) {
        n = line_break(text, CAPTION_COLUMNS);
        if (!script)
            continue;
        fputs("set label ", script);
        gnuplot_text_part(script, text, n);
        fprintf(script, " at screen %.6g,%.8g left front\n", v->indent / PICTURE_WIDTH,
                1 - (v->head + 16.0 + LINE * line) / v->height);
    }
    return line;
}

struct sheet sheet_of(const struct stage *stage, double least, double most)
{
    const double seen = stage->right - stage->left, wide = (1 + 2 * EDGE) * seen;
    struct sheet v = {
        .below = MARGIN_BELOW, .indent = 10, .above = 10 + LINE * caption_script(stage->caption, NULL, NULL)};
    v.dot = fmax(wide / ACROSS, stage->top / (most - v.above - v.below - STRIP - CLEAR));
    const double spare = ACROSS * v.dot - wide;
    v.left = stage->left - EDGE * seen - spare / 2;
    v.right = stage->right + EDGE * seen + spare / 2;
    v.height = ceil(fmax(v.above + v.below + STRIP + CLEAR + stage->top / v.dot, least));
    v.high = (v.height - v.above - v.below - STRIP) * v.dot;
    return v;
}

/* ---- The ruler and the labels ---- */

static void axes_script(const struct stage *stage, const struct sheet *v, FILE *script)
{
    const struct axis_unit unit = stage_unit(stage, v->right - v->left);
    /* For a row, the ruler begins at domino 1. */
    const struct chart_axis x = {.low = stage->left < 0 || v->left > 0 ? v->left : 0,
                                 .high = v->right,
                                 .unit = unit.size},
                            y = {.high = v->high, .unit = unit.size};
    char ruler[160];
    axis_script(script, &x, "x", ACROSS / 60);
    axis_script(script, &y, "y", (int)fmax(v->high / v->dot / 34, 2));
    fprintf(script,
            "set lmargin at screen %.8g\nset rmargin at screen %.8g\nset bmargin at screen %.8g\nset tmargin "
            "at screen %.8g\nset xrange [%.10g:%.10g]\nset yrange [%.10g:%.10g]\nunset grid\nunset key\nset "
            "border 1 lc rgb '#404040'\nset tics out nomirror scale 0.6 font ',%d'\nset xtics offset 0,0.3\n",
            (double)MARGIN_LEFT / PICTURE_WIDTH, 1 - (double)MARGIN_RIGHT / PICTURE_WIDTH,
            v->below / v->height, 1 - v->above / v->height, v->left, v->right, -STRIP * v->dot, v->high,
            SMALL + 1);
    fprintf(script, "set arrow from %.10g,0 to %.10g,0 nohead lc rgb '#404040' lw 1.5 back\nset label ",
            v->left, v->right);
    snprintf(ruler, sizeof ruler, "%s [%s]", stage->ruler, unit.name);
    gnuplot_text(script, ruler);
    fprintf(script, " at screen %.8g,%.8g center font ',%d'\n", (MARGIN_LEFT + ACROSS / 2.0) / PICTURE_WIDTH,
            (v->below - MARGIN_BELOW + 9) / v->height, SMALL + 1);
}

/* Writes the names of the dominoes below the ground. */
static void names_script(const struct stage *stage, const struct sheet *v, FILE *script)
{
    struct drawn_name name[NAMES];
    const int count = stage_names(stage, LETTER * v->dot, 4 * v->dot, false, v->left, v->right, name);
    for (int k = 0; k < count; k++) {
        fputs("set label ", script);
        gnuplot_text(script, name[k].text);
        fprintf(script, " at %.8g,%.8g center font ',%d' tc rgb '%s' front\n",
                (name[k].from + name[k].to) / 2, -STRIP / 2.0 * v->dot, SMALL,
                name[k].is_weakest ? "#c8400c" : "#000000");
    }
}

/* Draws each push as an arrow perpendicular to the back of its domino, with the size of the push at its
 * tail. */
static void forces_script(const struct stage *stage, const struct sheet *v, FILE *script)
{
    double largest = 0;
    for (size_t k = 0; k < stage->count; k++)
        if (isfinite(stage->domino[k].of_own))
            largest = fmax(largest, stage->domino[k].of_own);
    for (size_t k = 0; k < stage->count; k++) {
        const struct drawn *d = &stage->domino[k];
        if (!(d->height > 0.1 && d->of_own > 0) || drawn_locked(d))
            continue;
        const double length = 0.4 * d->of_own / largest, up = (d->corner[1].y - d->corner[0].y) / d->height,
                     on = (d->corner[1].x - d->corner[0].x) / d->height;
        const struct point from = along(d->contact, -length * d->height, up, -on);
        fprintf(script,
                "set arrow from %.7g,%.7g to %.7g,%.7g head filled size graph 0.012,20 lw 2.5 lc rgb "
                "'#c00000' front\n",
                from.x, from.y, d->contact.x, d->contact.y);
        if (d->height > 0.25 && from.x > v->left + 5 * LETTER * v->dot)
            fprintf(script,
                    "set label '%.3g' at %.7g,%.7g right offset char -0.3,0.5 tc rgb '#c00000' front\n",
                    d->of_own, from.x, from.y);
    }
}

/* ---- The dominoes ---- */

/* The colours also differ in lightness, for grey print and colour-blind people. */
static const char *const fill[PARTS] = {"#f4efe2", "#e8b85a", "#4f95c4", "#c8400c", "#000000"};

void sheet_palette(const struct sheet *v, int shift, FILE *script)
{
    const char *colour[PARTS + 2];
    memcpy(colour, fill, sizeof fill);
    colour[PARTS] = "#fefefe";
    colour[PARTS + 1] = shift ? "#fefefe" : "#ffffff";
    for (int k = 0; k < PARTS + 2; k++)
        fprintf(script,
                "set object %d rectangle from screen 0,0 to screen %.6g,%.6g behind fs solid 1 noborder fc "
                "rgb '%s'\n",
                k + 1, 1.5 / PICTURE_WIDTH, 1.5 / v->height, colour[k]);
}

void stage_script(const struct stage *stage, const struct sheet *sheet, FILE *script)
{
    struct sheet view = *sheet;
    const struct sheet *const v = &view;
    if (stage->tall > 0) {
        const double up = v->height - v->above - v->below;
        view.dot = stage->tall / up;
        view.left = stage->at - 0.45 * ACROSS * v->dot;
        view.right = v->left + ACROSS * v->dot;
        view.high = (up - STRIP) * v->dot;
    }
    axes_script(stage, v, script);
    caption_script(stage->caption, v, script);
    for (size_t k = 0; k < stage->count; k++) {
        const struct drawn *d = &stage->domino[k];
        struct point outline[OUTLINE];
        if (d->corner[0].x + d->height < v->left || d->corner[3].x > v->right)
            continue;
        const int n = drawn_outline(d, outline);
        fputs("set object polygon", script);
        for (int i = 0; i <= n; i++)
            fprintf(script, "%s %.8g,%.8g", i ? " to" : " from", outline[i % n].x, outline[i % n].y);
        fprintf(script, " front fs solid border rgb '#202020' fc rgb '%s' lw 0.8\n", fill[d->part]);
        if (d->touched && d->height >= 14 * v->dot)
            fprintf(script, "set label '' at %.7g,%.7g point pt 7 ps 0.5 lc rgb 'black' front\n",
                    d->contact.x, d->contact.y);
    }
    names_script(stage, v, script);
    if (stage->forces)
        forces_script(stage, v, script);
    fputs("plot NaN notitle\n", script);
}
