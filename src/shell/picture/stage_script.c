/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A stage as a script of gnuplot, to scale, for a picture in a file and for a frame of a film. */
#include "answer/wrap.h"
#include "picture/stage.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* ---- The sheet, in dots ---- */

enum {
    FONT = 14,
    SMALL = 11, /* fonts */
    LINE = 19,  /* of the caption */
    STRIP = 17, /* below the ground: numbers */
    MARGIN_LEFT = 52,
    MARGIN_RIGHT = 12,
    MARGIN_BELOW = 50,
    CLEAR = 6, /* above the tallest */
    ACROSS = SHEET_WIDTH - MARGIN_LEFT - MARGIN_RIGHT
};
#define LETTER (0.62 * SMALL) /* a letter is at most as wide */
#define EDGE   0.02           /* of the width of what is seen, at both sides */

const struct marks script_marks = {
    .theta = "\u03b8",
    .weakest = "red",
    .ends = "black",
    .contacts = "; dots: contacts",
    .forces = "arrows: the push at a contact, in weights of the domino that is pushed",
};

static int caption_lines(const char *text)
{
    int lines = 0;
    for (size_t n; *text; lines++, text += n + (text[n] == ' ' || text[n] == '\n'))
        n = line_break(text, CAPTION_COLUMNS);
    return lines;
}

/* Returns the sheet with so many dots above the tallest domino, and a line more below the caption. */
static struct sheet sheet_with(const struct stage *stage, double least, double most, double room,
                               const char *more)
{
    struct sheet v = {.width = SHEET_WIDTH,
                      .below = MARGIN_BELOW,
                      .above = 10 + LINE * (caption_lines(stage->caption) + (*more != 0))};
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

void sheet_terminal(const struct sheet *v, const char *path, char *terminal, size_t size)
{
    const char *ending = strrchr(path, '.');
    if (strcasecmp(ending, ".pdf") == 0)
        snprintf(terminal, size, "pdfcairo size %.3fcm,%.3fcm font 'sans,%d' fontscale 0.67 enhanced",
                 v->width / 40, v->height / 40, FONT);
    else if (strcasecmp(ending, ".png") == 0)
        snprintf(terminal, size, "pngcairo size %.0f,%.0f font 'sans,%d' fontscale %.3g linewidth 2 enhanced",
                 2 * v->width, 2 * v->height, FONT, 2 * 0.72);
    else
        snprintf(terminal, size,
                 "svg size %.0f,%.0f dynamic font 'sans-serif,%d' background rgb 'white' enhanced", v->width,
                 v->height, FONT);
}

/* ---- The ruler and the caption ---- */

/* Writes tics each `step` units. Their texts are in units, their places in those of the stage. */
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
    fprintf(script,
            "set lmargin at screen %.8g\nset rmargin at screen %.8g\nset bmargin at screen %.8g\n"
            "set tmargin at screen %.8g\nset xrange [%.10g:%.10g]\nset yrange [%.10g:%.10g]\n"
            "unset grid\nunset key\nset border 1 lc rgb '#404040'\nset tics out nomirror\n",
            MARGIN_LEFT / v->width, 1 - MARGIN_RIGHT / v->width, v->below / v->height,
            1 - v->above / v->height, v->left, v->right, v->low, v->high);
    /* The tape of a row begins at domino 1; above, the last tic keeps clear of the caption. */
    double from = stage->left < 0 || v->left > 0 ? v->left : 0, up = ruler_step(34 * v->dot / unit.size);
    while (up * unit.size > v->high - 10 * v->dot) /* a low row has a tic, too */
        up = ruler_step(0.39 * up);
    tics_script(script, 'x', from, v->right, ruler_step(60 * v->dot / unit.size), unit.size);
    tics_script(script, 'y', up * unit.size, v->high - 10 * v->dot, up, unit.size); /* at 0 is the unit */
    fprintf(script, "set label '%s' at screen %.8g, first %.10g right font ',%d'\n", unit.name,
            (MARGIN_LEFT - 12) / v->width, 0.0, SMALL + 1);
    fprintf(script, "set arrow from %.10g,0 to %.10g,0 nohead lc rgb '#404040' lw 1.5 back\n", v->left,
            v->right);
    fprintf(script, "set label '%s [%s]' at screen %.8g,%.8g center font ',%d'\n", stage->ruler, unit.name,
            (MARGIN_LEFT + ACROSS / 2.0) / v->width, 9 / v->height, SMALL + 1);
}

/* Writes a text from a line of the caption on; returns the line after it. */
static int caption_script(const char *text, const struct sheet *v, int lines, FILE *script)
{
    for (size_t n; *text; lines++, text += n + (text[n] == ' ' || text[n] == '\n')) {
        n = line_break(text, CAPTION_COLUMNS);
        fprintf(script, "set label \"");
        for (size_t i = 0; i < n; i++)
            fprintf(script, strchr("\"\\", text[i]) ? "\\%c" : "%c", text[i]);
        fprintf(script, "\" at screen %.8g,%.8g left font ',%d' noenhanced front\n", 10 / v->width,
                1 - (16.0 + LINE * lines) / v->height, FONT);
    }
    return lines;
}

/* ---- Labels where there is room ---- */

/* The room of a text: its middle and its size, in dots, from 0 on the ruler and from the ground. */
struct box {
    double x, y, wide, high;
};

struct label {
    struct box box;
    struct point at;
    const char *how, *colour; /* how it stands there, for gnuplot */
    char text[64];
};

enum { LABELS = 256 };
struct labels {
    FILE *script; /* takes the labels that have room; NULL: none does */
    struct box taken[LABELS];
    int count;
};

/* Writes a text into the picture, unless another one is there; it keeps a little room around it. */
static bool label_put(struct labels *l, const struct label *own)
{
    for (int i = 0; i < l->count; i++)
        if (2 * fabs(own->box.x - l->taken[i].x) < own->box.wide + l->taken[i].wide &&
            2 * fabs(own->box.y - l->taken[i].y) < own->box.high + l->taken[i].high)
            return false;
    if (l->count == LABELS)
        return false;
    l->taken[l->count++] = own->box;
    if (l->script)
        fprintf(l->script, "set label '%s' at %.8g,%.8g %s font ',%d' tc rgb '%s' front\n", own->text,
                own->at.x, own->at.y, own->how, SMALL, own->colour);
    return true;
}

/* The colours of dominoes: they differ in lightness, too, so they stay apart in grey print and for
 * colour-blind people. */
static const char *const fill[PARTS] = {"#f4efe2", "#e8b85a", "#4f95c4", "#c8400c", "#000000"};

static const char *colour_of(const struct drawn *d)
{
    return d->part == WEAKEST ? fill[WEAKEST] : "#000000";
}

static double middle_of(const struct drawn *d)
{
    return d->foot - d->thickness / 2;
}

/* Puts the number of a domino below the ground. */
static bool number_put(const struct sheet *v, const struct drawn *d, struct labels *l)
{
    struct label own = {.box.high = 1, .how = "center", .colour = colour_of(d)};
    char name[DRAWN_NAME];
    own.at = (struct point){middle_of(d), v->low / 2};
    own.box.wide = drawn_name(d, name) * LETTER + 4;
    own.box.x = own.at.x / v->dot;
    snprintf(own.text, sizeof own.text, "%s", name);
    return *name && own.at.x >= v->left && own.at.x <= v->right && label_put(l, &own);
}

/* Writes the height of a domino, with the word that marks it; false: there is no room above. */
static bool height_text(const struct stage *stage, const struct sheet *v, size_t k, char text[64])
{
    const struct drawn *d = &stage->domino[k];
    double half = 0.6 * SMALL * v->dot;
    double before = k > 0 ? d->thickness / 2 + (double)stage->row[k].gap : HUGE_VAL;
    double after = k + 1 < stage->count ? d->thickness / 2 + (double)stage->row[k + 1].gap : HUGE_VAL;
    snprintf(text, 64, "%.30s%s", measured(stage->row[k].height, "m", 3).text,
             d->part == WEAKEST ? "  weakest"
             : d->part == ENDS  ? "  ends here"
                                : "");
    return drawn_marked(d) || (before > half && after > half);
}

/* Returns true for a height that is written once, at a domino before this one. */
static bool height_repeats(const struct stage *stage, size_t k)
{
    return k > 0 && !drawn_marked(&stage->domino[k]) &&
           strcmp(measured(stage->row[k - 1].height, "m", 3).text,
                  measured(stage->row[k].height, "m", 3).text) == 0;
}

/* Puts the height above a domino, upright. */
static bool height_put(const struct stage *stage, const struct sheet *v, size_t k, struct labels *l)
{
    const struct drawn *d = &stage->domino[k];
    struct label own = {
        .box = {.wide = 1.25 * SMALL}, .how = "left rotate by 90 offset 0,0.35", .colour = colour_of(d)};
    if (height_repeats(stage, k))
        return true;
    if (!height_text(stage, v, k, own.text))
        return false;
    double length = (double)strlen(own.text) * LETTER;
    own.at = (struct point){middle_of(d), d->height};
    own.box.x = own.at.x / v->dot;
    own.box.y = d->height / v->dot + 5 + length / 2;
    own.box.high = length + 4;
    return label_put(l, &own);
}

/* Puts the gap before a domino between the feet, where it is wide enough. */
static void gap_put(const struct stage *stage, const struct sheet *v, size_t k, struct labels *l)
{
    const struct drawn *d = &stage->domino[k];
    double gap = (double)stage->row[k].gap;
    struct label own = {.box = {.y = 9, .high = SMALL}, .how = "center", .colour = "#505050"};
    snprintf(own.text, sizeof own.text, "%.60s", measured(stage->row[k].gap, "m", 3).text);
    own.box.wide = (double)strlen(own.text) * LETTER;
    own.at = (struct point){d->foot - d->thickness - gap / 2, 9 * v->dot};
    own.box.x = own.at.x / v->dot;
    if (gap <= (own.box.wide + 4) * v->dot) {
        own.how = "left rotate by 90";
        own.at.y = 4 * v->dot;
        own.box.y = 4 + own.box.wide / 2;
        own.box.high = own.box.wide;
        own.box.wide = 1.25 * SMALL;
    }
    if (k > 0 && gap > 1.4 * SMALL * v->dot)
        (void)label_put(l, &own);
}

/* Returns the index of a domino on its stage. */
static size_t index_of(const struct stage *stage, const struct drawn *d)
{
    return (size_t)(d - stage->domino);
}

/*
 * Writes numbers, heights and gaps where there is room: those of the marked dominoes first, then from the
 * front, where a row that grows has its largest; heights before gaps. Where `missing` is not NULL, it says
 * for each domino whether its number or its height has no room.
 */
static void labels_put(const struct stage *stage, const struct sheet *v, FILE *script, bool *missing)
{
    struct labels own = {.script = script}, *l = &own;
    for (int pass = 0; pass < 3; pass++)
        for (size_t i = 0; i < stage->count; i++) {
            const struct drawn *d = stage_front(stage, i);
            size_t k = index_of(stage, d);
            if (pass == 2 && stage->row) {
                gap_put(stage, v, k, l);
            } else if (drawn_marked(d) == (pass == 0)) {
                bool number = number_put(v, d, l), height = !stage->row || height_put(stage, v, k, l);
                if (missing)
                    missing[k] = !number || !height;
            }
        }
}

/* Writes which dominoes have no labels, and how tall they are, in one line; "" where that is none, or many
 * runs of them, as in a long row of equal dominoes. */
static void unlabelled(const struct stage *stage, const struct sheet *v, char text[CAPTION_COLUMNS + 1])
{
    bool *missing = stage->row ? calloc(stage->count, sizeof *missing) : NULL;
    char line[2 * CAPTION_COLUMNS] = "";
    int at = 0;
    if (missing)
        labels_put(stage, v, NULL, missing);
    for (size_t k = 0; missing && k < stage->count && at < CAPTION_COLUMNS; k++) {
        size_t from = k;
        while (missing[k] && k + 1 < stage->count && missing[k + 1])
            k++;
        if (!missing[k])
            continue;
        const char *to = k == from + 1 ? "and" : "to";
        at += snprintf(line + at, sizeof line - (size_t)at, "%s%zu",
                       at ? ", " : "Too small for labels: domino ", from + 1);
        if (k > from)
            at += snprintf(line + at, sizeof line - (size_t)at, " %s %zu", to, k + 1);
        at += snprintf(line + at, sizeof line - (size_t)at, " (%.12s",
                       measured(stage->row[from].height, "m", 3).text);
        if (k > from)
            at += snprintf(line + at, sizeof line - (size_t)at, " %s %.12s", to,
                           measured(stage->row[k].height, "m", 3).text);
        at += snprintf(line + at, sizeof line - (size_t)at, ")");
    }
    bool fits = at > 0 && at < CAPTION_COLUMNS;
    snprintf(text, CAPTION_COLUMNS + 1, "%s%s", fits ? line : "", fits ? "." : "");
    free(missing);
}

/* Returns how many dots the heights that are written above the dominoes need above the tallest. */
static double heights_room(const struct stage *stage, const struct sheet *v)
{
    double room = CLEAR;
    for (size_t k = 0; k < stage->count && stage->row; k++) {
        char text[64];
        if (height_text(stage, v, k, text) && !height_repeats(stage, k))
            room = fmax(room, (stage->domino[k].height - stage->top) / v->dot + CLEAR +
                                  (double)strlen(text) * LETTER);
    }
    return room;
}

struct sheet sheet_of(const struct stage *stage, double least, double most)
{
    struct sheet v = sheet_with(stage, least, most, 0, "");
    if (!stage->row)
        return v;
    double room = heights_room(stage, &v);
    v = sheet_with(stage, least, most, room, "");
    char more[CAPTION_COLUMNS + 1];
    unlabelled(stage, &v, more);
    if (*more) { /* its line takes room itself */
        v = sheet_with(stage, least, most, room, more);
        unlabelled(stage, &v, v.more);
    }
    return v;
}

/* ---- Forces ---- */

/* Draws the push on the back of a domino, perpendicular to the back, with its number at the free end. */
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
        fprintf(
            script,
            "set object %d rectangle from screen 0,0 to screen %.6g,%.6g behind fs solid 1 noborder fc rgb "
            "'%s'\n",
            k + 1, 1.5 / v->width, 1.5 / v->height, colour[k]);
}

/* Writes the outlines of the dominoes of one part, as curves that close, and returns how many there are. */
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
    caption_script(v->more, v, caption_script(stage->caption, v, 0, script), script);
    for (int part = 0; part < PARTS; part++)
        count[part] = part_script(stage, v, (enum part)part, script);
    int contacts = contacts_script(stage, v, script);
    labels_put(stage, v, script, NULL);
    if (stage->forces)
        forces_script(stage, v, script);
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
    if (contacts)
        fprintf(script, "%s$contacts with points pt 7 ps 0.5 lc rgb 'black'", comma);
    fprintf(script, contacts || *comma == ',' ? "\n" : "plot NaN\n");
}
