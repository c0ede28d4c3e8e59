/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes a stage, to scale, as a gnuplot script. */
#include "answer/wrap.h"
#include "pictures/picture/picture.h"
#include "pictures/picture/stage.h"
#include <math.h>
#include <string.h>

/* ---- The sheet, in dots ---- */

enum {
    FONT = 14,  /* the font size of the caption */
    SMALL = 11, /* font size of labels */
    LINE = 19,  /* the height of a line of the caption */
    STRIP = 17, /* the height of the area below the ground, for numbers */
    MARGIN_LEFT = 52,
    MARGIN_RIGHT = 12,
    MARGIN_BELOW = 50,
    CLEAR = 6, /* the empty space above the tallest domino */
    ACROSS = SHEET_WIDTH - MARGIN_LEFT - MARGIN_RIGHT
};
#define LETTER (0.62 * SMALL) /* the maximum width of a character */
#define EDGE   0.02           /* the margin on each side, as a fraction of the visible width */

const struct marks script_marks = {
    .theta = "\u03b8",
    .weakest = "red",
    .ends = "black",
    .contacts = "; dots: contacts",
    .forces = "arrows: the push at each contact, divided by the weight of the pushed domino",
};

static int caption_lines(const char *text)
{
    int lines = 0;
    for (size_t n; *text; lines++, text += n + (text[n] == ' ' || text[n] == '\n'))
        n = line_break(text, CAPTION_COLUMNS);
    return lines;
}

/* Returns the sheet for a stage, with `room` dots above the tallest domino. */
static struct sheet sheet_with(const struct stage *stage, double least, double most, double room)
{
    const int lines = caption_lines(stage->caption);
    struct sheet v = {.width = SHEET_WIDTH, .below = MARGIN_BELOW, .above = 10 + LINE * lines, .indent = 10};
    double edge = EDGE * (stage->right - stage->left), wide = stage->right - stage->left + 2 * edge;
    double by_width = wide / ACROSS, by_height = stage->top / (most - v.above - v.below - STRIP - room);
    v.dot = by_width > by_height ? by_width : by_height;
    double spare = ACROSS * v.dot - wide;
    v.left = stage->left - edge - spare / 2;
    v.right = stage->right + edge + spare / 2;
    v.low = -STRIP * v.dot;
    v.height = v.above + v.below + STRIP + room + stage->top / v.dot;
    v.height = ceil(v.height < least ? least : v.height);
    v.high = v.low + (v.height - v.above - v.below) * v.dot;
    return v;
}

void sheet_follow(struct sheet *v, double at, double tall)
{
    double up = v->height - v->above - v->below;
    v->dot = tall / up;
    v->left = at - 0.45 * ACROSS * v->dot;
    v->right = v->left + ACROSS * v->dot;
    v->low = -STRIP * v->dot;
    v->high = v->low + up * v->dot;
}

void sheet_terminal(const struct sheet *v, const char *name, bool is_paper, char terminal[TERMINAL_TEXT])
{
    /* The font is smaller on paper, which has margins. */
    const double cm = is_paper ? 21 : 16, scale = is_paper ? 0.86 : 1;
    if (strcmp(name, "pdfcairo") == 0)
        snprintf(terminal, TERMINAL_TEXT,
                 "pdfcairo size %.3fcm,%.3fcm font 'sans,%d' fontscale %.3g enhanced", cm,
                 cm * v->height / v->width, FONT, cm * 0.51 / 16);
    else if (strcmp(name, "pngcairo") == 0)
        snprintf(terminal, TERMINAL_TEXT,
                 "pngcairo size %.0f,%.0f font 'sans,%d' fontscale %.3g linewidth 2 enhanced", 2 * v->width,
                 2 * v->height, FONT, 2 * 0.72 * scale);
    else
        snprintf(
            terminal, TERMINAL_TEXT,
            "svg size %.0f,%.0f dynamic font 'sans-serif,%d' fontscale %.3g background rgb 'white' enhanced",
            v->width, v->height, FONT, scale);
}

/* ---- The ruler and the caption ---- */

/* Writes the tics of an axis, from the position `from` to the position `to`. The tics are labelled in a unit
 * such as cm. `step` is the distance between two tics in this unit, and `unit` is the length of the unit on
 * the stage. */
static void tics_script(FILE *script, char axis, double from, double to, double step, double unit)
{
    const char *comma = "";
    fprintf(script, "set %ctics (", axis);
    for (double k = ceil(from / (step * unit) - 1e-9); k * step * unit <= to * (1 + 1e-9); k++) {
        fprintf(script, "%s'%.10g' %.10g", comma, k * step + 0.0, k * step * unit + 0.0);
        comma = ", ";
    }
    fprintf(script, ") scale 0.6 offset 0,%s font ',%d'\n", axis == 'x' ? "0.3" : "0", SMALL + 1);
}

static void axes_script(const struct stage *stage, const struct sheet *v, FILE *script)
{
    struct axis_unit unit = stage_unit(stage, v->right - v->left);
    char ruler[160];
    fprintf(script,
            "set lmargin at screen %.8g\nset rmargin at screen %.8g\nset bmargin at screen %.8g\nset tmargin "
            "at screen %.8g\nset xrange [%.10g:%.10g]\nset yrange [%.10g:%.10g]\nunset grid\nunset key\nset "
            "border 1 lc rgb '#404040'\nset tics out nomirror\n",
            MARGIN_LEFT / v->width, 1 - MARGIN_RIGHT / v->width, v->below / v->height,
            1 - v->above / v->height, v->left, v->right, v->low, v->high);
    /* For a row, the ruler begins at domino 1. */
    double from = stage->left < 0 || v->left > 0 ? v->left : 0, up = ruler_step(34 * v->dot / unit.size);
    while (up * unit.size > v->high - 10 * v->dot) /* the axis needs at least one tic */
        up = ruler_step(0.39 * up);
    tics_script(script, 'x', from, v->right, ruler_step(60 * v->dot / unit.size), unit.size);
    /* The y axis has no tic at 0, because its unit is written there. */
    tics_script(script, 'y', up * unit.size, v->high - 10 * v->dot, up, unit.size);
    fputs("set label ", script);
    gnuplot_text(script, unit.name);
    fprintf(script, " at screen %.8g, first %.10g right font ',%d'\n", (MARGIN_LEFT - 12) / v->width, 0.0,
            SMALL + 1);
    fprintf(script, "set arrow from %.10g,0 to %.10g,0 nohead lc rgb '#404040' lw 1.5 back\n", v->left,
            v->right);
    snprintf(ruler, sizeof ruler, "%s [%s]", stage->ruler, unit.name);
    fputs("set label ", script);
    gnuplot_text(script, ruler);
    fprintf(script, " at screen %.8g,%.8g center font ',%d'\n", (MARGIN_LEFT + ACROSS / 2.0) / v->width,
            (v->below - MARGIN_BELOW + 9) / v->height, SMALL + 1);
}

static void caption_script(const char *text, const struct sheet *v, FILE *script)
{
    int line = 0;
    for (size_t n; *text; line++, text += n + (text[n] == ' ' || text[n] == '\n')) {
        n = line_break(text, CAPTION_COLUMNS);
        fputs("set label ", script);
        gnuplot_text_part(script, text, n);
        fprintf(script, " at screen %.8g,%.8g left font ',%d' noenhanced front\n", v->indent / v->width,
                1 - (v->head + 16.0 + LINE * line) / v->height, FONT);
    }
}

/* ---- Labels where there is room ---- */

/* The rectangle that a label covers, in dots. */
struct box {
    double x, y; /* the centre: the distance from 0 on the ruler, and the height above the ground */
    double wide, high;
};

enum { LABELS = 256 };
struct labels {
    FILE *script;
    const struct sheet *sheet;
    struct box taken[LABELS];
    int count;
};

/* A label at the position x on the ruler. `height` is the distance in dots from the ground to the centre of
 * the label. If `upright` is true, the label is turned by 90 degrees, and `height` is the distance to its
 * lower end. */
struct label {
    double x, height;
    bool upright;
    const char *colour, *text;
};

static struct box label_box(const struct labels *l, const struct label *label)
{
    const double at = label->x / l->sheet->dot, length = (double)strlen(label->text) * LETTER + 4;
    return label->upright ? (struct box){at, label->height + length / 2 - 2, 1.25 * SMALL, length}
                          : (struct box){at, label->height, length, SMALL};
}

/* Returns true if the label would not overlap another one. */
static bool label_fits(const struct labels *l, const struct label *label)
{
    const struct box candidate = label_box(l, label);
    for (int i = 0; i < l->count; i++)
        if (2 * fabs(candidate.x - l->taken[i].x) < candidate.wide + l->taken[i].wide &&
            2 * fabs(candidate.y - l->taken[i].y) < candidate.high + l->taken[i].high)
            return false;
    return l->count < LABELS;
}

/* Writes a label, unless it does not fit. */
static void label_put(struct labels *l, const struct label *label)
{
    if (!label_fits(l, label))
        return;
    l->taken[l->count++] = label_box(l, label);
    fputs("set label ", l->script);
    gnuplot_text(l->script, label->text);
    fprintf(l->script, " at %.8g,%.8g %s font ',%d' tc rgb '%s' front\n", label->x,
            label->height * l->sheet->dot, label->upright ? "left rotate by 90" : "center", SMALL,
            label->colour);
}

/* The colours also differ in lightness, for grey print and colour-blind people. */
static const char *const fill[PARTS] = {"#f4efe2", "#e8b85a", "#4f95c4", "#c8400c", "#000000"};

static const char *colour_of(const struct drawn *d)
{
    return d->part == WEAKEST ? fill[WEAKEST] : "#000000";
}

/* Returns true if the dimensions of a domino are known, and false for a silhouette. */
static bool is_sized(const struct stage *stage, size_t k)
{
    return stage->row && stage->domino[k].number > 0;
}

static struct measured height_of(const struct stage *stage, size_t k)
{
    return measured(stage->row[k].height, "m", 3);
}

/* Stores the text above a domino: its height and, if the domino is marked, the reason. Returns false if the
 * neighbours of an unmarked domino leave no room for the text. */
static bool height_text(const struct stage *stage, const struct sheet *v, size_t k, char text[64])
{
    const struct drawn *d = &stage->domino[k];
    double half = 0.6 * SMALL * v->dot;
    double before = k > 0 ? d->thickness / 2 + (double)stage->row[k].gap : HUGE_VAL;
    double after = k + 1 < stage->count && is_sized(stage, k + 1)
                       ? d->thickness / 2 + (double)stage->row[k + 1].gap
                       : HUGE_VAL;
    snprintf(text, 64, "%.30s%s", height_of(stage, k).text,
             d->part == WEAKEST ? "  weakest"
             : d->part == ENDS  ? "  ends here"
                                : "");
    return drawn_marked(d) || (before > half && after > half);
}

/* Returns true if domino k is not marked, and has the same height as the previous domino. */
static bool height_repeats(const struct stage *stage, size_t k)
{
    return k > 0 && !drawn_marked(&stage->domino[k]) &&
           strcmp(height_of(stage, k - 1).text, height_of(stage, k).text) == 0;
}

/* Writes the number of a domino below it, and its height above it. If the previous domino has the same
 * height, the height is not repeated. If one of the two does not fit, writes neither, except for marked
 * dominoes. */
static void names_put(const struct stage *stage, size_t k, struct labels *l)
{
    const struct drawn *d = &stage->domino[k];
    const struct sheet *v = l->sheet;
    const double middle = d->foot - d->thickness / 2;
    char name[64], text[64] = "";
    const struct label number = {middle, -STRIP / 2.0, false, colour_of(d), name},
                       height = {middle, d->height / v->dot + 5, true, colour_of(d), text};
    const bool has_height = is_sized(stage, k) && !height_repeats(stage, k);
    bool fits = drawn_name(d, name) && middle >= v->left && middle <= v->right && label_fits(l, &number);
    if (has_height)
        fits = height_text(stage, v, k, text) && label_fits(l, &height) && fits;
    if ((fits || drawn_marked(d)) && *name)
        label_put(l, &number);
    if ((fits || drawn_marked(d)) && *text)
        label_put(l, &height);
}

/* Writes the size of the gap before domino k into the gap, if there is room. */
static void gap_put(const struct stage *stage, size_t k, struct labels *l)
{
    const struct drawn *d = &stage->domino[k];
    double gap = (double)stage->row[k].gap, dot = l->sheet->dot;
    struct measured text = measured(stage->row[k].gap, "m", 3);
    bool upright = gap <= ((double)strlen(text.text) * LETTER + 4) * dot;
    const struct label label = {d->foot - d->thickness - gap / 2, upright ? 4 : 9, upright, "#505050",
                                text.text};
    if (k > 0 && gap > 1.4 * SMALL * dot)
        label_put(l, &label);
}

static void labels_script(const struct stage *stage, const struct sheet *v, FILE *script)
{
    struct labels l = {.script = script, .sheet = v};
    /* Later labels get only the room that earlier labels leave. The first pass writes the labels of marked
     * dominoes, the second pass those of all other dominoes, and the third pass the gaps. Each pass begins at
     * the front, where the largest dominoes usually are. */
    for (int pass = 0; pass < 3; pass++)
        for (size_t i = 0; i < stage->count; i++) {
            const struct drawn *d = stage_front(stage, i);
            size_t k = (size_t)(d - stage->domino);
            if (pass == 2 && is_sized(stage, k))
                gap_put(stage, k, &l);
            else if (drawn_marked(d) == (pass == 0))
                names_put(stage, k, &l);
        }
}

struct sheet sheet_of(const struct stage *stage, double least, double most)
{
    struct sheet v = sheet_with(stage, least, most, 0);
    double room = CLEAR;
    char text[64];
    for (size_t k = 0; k < stage->count; k++)
        if (is_sized(stage, k) && height_text(stage, &v, k, text) && !height_repeats(stage, k))
            room = fmax(room, (stage->domino[k].height - stage->top) / v.dot + CLEAR +
                                  (double)strlen(text) * LETTER);
    return stage->row ? sheet_with(stage, least, most, room) : v;
}

/* ---- Forces ---- */

/* Draws the push on a domino as an arrow perpendicular to its back. Writes the size of the push at the tail
 * of the arrow. */
static void arrow_script(const struct sheet *v, const struct drawn *k, double length, FILE *script)
{
    double up = (k->corner[1].y - k->corner[0].y) / k->height,
           on = (k->corner[1].x - k->corner[0].x) / k->height;
    struct point from = along(k->contact, -length * k->height, up, -on);
    fprintf(script,
            "set arrow from %.7g,%.7g to %.7g,%.7g head filled size graph 0.012,20 lw 2.5 lc rgb '#c00000' "
            "front\n",
            from.x, from.y, k->contact.x, k->contact.y);
    if (k->height > 0.25 && from.x > v->left + 5 * LETTER * v->dot)
        fprintf(script, "set label '%.3g' at %.7g,%.7g right offset char -0.3,0.5 tc rgb '#c00000' front\n",
                k->of_own, from.x, from.y);
}

static void forces_script(const struct stage *stage, const struct sheet *v, FILE *script)
{
    double largest = 0;
    for (size_t k = 0; k < stage->count; k++)
        if (isfinite(stage->domino[k].of_own))
            largest = fmax(largest, stage->domino[k].of_own);
    for (size_t k = 0; k < stage->count; k++) {
        const struct drawn *d = &stage->domino[k];
        if (d->height > 0.1 && d->of_own > 0 && !drawn_locked(d))
            arrow_script(v, d, 0.4 * d->of_own / largest, script);
    }
}

/* ---- The dominoes ---- */

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
                k + 1, 1.5 / v->width, 1.5 / v->height, colour[k]);
}

/* Writes the outlines of the visible dominoes in one state as closed curves. Returns their number. */
static int part_script(const struct stage *stage, const struct sheet *v, enum part part, FILE *script)
{
    int count = 0;
    fprintf(script, "$part%d << END\n", (int)part);
    for (size_t k = 0; k < stage->count; k++) {
        const struct drawn *d = &stage->domino[k];
        if (d->part != part || d->corner[0].x + d->height < v->left || d->corner[3].x > v->right)
            continue;
        struct point outline[OUTLINE];
        int n = drawn_outline(d, outline);
        for (int i = 0; i <= n; i++)
            fprintf(script, "%.8g %.8g\n", outline[i % n].x, outline[i % n].y);
        fprintf(script, "\n");
        count++;
    }
    fprintf(script, "END\n");
    return count;
}

static int contacts_script(const struct stage *stage, const struct sheet *v, FILE *script)
{
    int count = 0;
    for (size_t k = 0; k < stage->count; k++) {
        const struct drawn *d = &stage->domino[k];
        if (!d->touched || d->height < 14 * v->dot)
            continue;
        fprintf(script, "%s%.7g %.7g\n", count++ ? "" : "$contacts << END\n", d->contact.x, d->contact.y);
    }
    fprintf(script, count ? "END\n" : "");
    return count;
}

void stage_script(const struct stage *stage, const struct sheet *v, FILE *script)
{
    const char *comma = "plot ";
    int count[PARTS];
    axes_script(stage, v, script);
    caption_script(stage->caption, v, script);
    for (int part = 0; part < PARTS; part++)
        count[part] = part_script(stage, v, (enum part)part, script);
    int contacts = contacts_script(stage, v, script);
    labels_script(stage, v, script);
    if (stage->forces)
        forces_script(stage, v, script);
    for (int part = 0; part < PARTS; part++) {
        if (count[part] == 0)
            continue;
        fprintf(script,
                "%s$part%d with filledcurves closed fs solid 1 noborder fc rgb '%s', $part%d with lines lc "
                "rgb '#202020' lw 0.8 dt solid",
                comma, part, fill[part], part);
        comma = ", ";
    }
    if (contacts)
        fprintf(script, "%s$contacts with points pt 7 ps 0.5 lc rgb 'black'", comma);
    fprintf(script, contacts || *comma == ',' ? "\n" : "plot NaN\n");
}
