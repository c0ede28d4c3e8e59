/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Charts as scripts of gnuplot. */
#include "answer/wrap.h"
#include "io/terminal.h"
#include "picture/chart.h"
#include <math.h>
#include <string.h>

/* Writes text between single quotes, where gnuplot takes every letter as it is. */
static void quoted(FILE *out, const char *text)
{
    putc('\'', out);
    for (; *text; text++)
        fputs(*text == '\'' ? "''" : (char[]){*text, '\0'}, out);
    putc('\'', out);
}

enum { COLUMNS = 64, ROOM = 320 };
#define LETTER 0.016 /* of the x axis, that a letter takes */

/* Breaks a text into lines of about equal length that fit the picture, as gnuplot reads them between double
 * quotes. Returns how many lines there are. */
static int lines_make(const char *text, char script[ROOM])
{
    int lines = 0, at = 0, all = terminal_columns(text), columns = all / (all / COLUMNS + 1) + 8;
    script[0] = '\0';
    while (*text && at + 4 < ROOM) {
        size_t n = line_break(text, columns < COLUMNS ? columns : COLUMNS);
        at += snprintf(script + at, (size_t)(ROOM - at), "%s", lines++ ? "\\n" : "");
        for (size_t i = 0; i < n && at + 4 < ROOM; i++)
            at +=
                snprintf(script + at, (size_t)(ROOM - at), strchr("\"\\", text[i]) ? "\\%c" : "%c", text[i]);
        text += n + (text[n] == ' ');
    }
    return lines;
}

static void axis_script(FILE *out, const struct chart_axis *a, const char *name)
{
    double tick[TICKS];
    char text[TICK_TEXT];
    int n = axis_ticks(a, a->whole ? 20 : 9, tick);
    if (a->logarithmic)
        fprintf(out, "set logscale %s\n", name);
    fprintf(out, "set %srange [%.10g:%.10g]\nset %stics (", name, a->low, a->high, name);
    for (int k = 0; k < n; k++) {
        tick_text(tick[k], text);
        fprintf(out, "%s'%s' %.12g", k ? ", " : "", text, tick[k]);
    }
    fprintf(out, ")\n");
}

/*
 * Writes the texts around the axes. What the y axis shows, and the colours of a map, is written level above
 * the axes: beside them a text would be cut off where it is longer than the axis. A legend with few columns
 * is as low as its longest title allows: gnuplot takes letters for wider than they are.
 */
static void texts_script(const struct chart *c, FILE *out)
{
    char title[ROOM], note[ROOM], x[ROOM], y[ROOM], value[ROOM];
    int lines = lines_make(c->title, title) + lines_make(c->note, note), above = event_rows(c, LETTER);
    int own = lines_make(c->y.label, y), shades = c->map.value ? lines_make(c->map.label, value) : 0;
    fprintf(out, "set label \"%s\" noenhanced at screen 0.02, graph 1 left offset 0,%g\n", y,
            above + own + 0.1);
    if (shades && terminal_columns(c->y.label) + terminal_columns(c->map.label) > COLUMNS - 4)
        above += own;
    above += own > shades ? own : shades;
    if (shades)
        fprintf(out, "set label \"%s\" noenhanced at screen 0.98, graph 1 right offset 0,%g\n", value,
                above + 0.1);
    lines_make(c->x.label, x);
    fprintf(out,
            "set xlabel \"%s\" noenhanced\nset title \"%s%s%s\" noenhanced offset 0,%g\nset tmargin %g\n", x,
            title, *note ? "\\n" : "", note, above + 0.2, above + lines + 1.6);
    int longest = 0;
    for (int k = 0; k < c->curves; k++) {
        int columns = terminal_columns(c->curve[k].title);
        longest = columns > longest ? columns : longest;
    }
    int across = (COLUMNS + 4) / (longest + 9);
    fprintf(out, "set key noenhanced maxcols %d width %d\n", across > 0 ? across : 1,
            longest > 16 ? -longest / 4 : 0);
}

/* Draws a vertical line with its name for each event. */
static void events_script(const struct chart *c, FILE *out)
{
    for (int k = 0; k < c->events; k++) {
        const struct event_spot spot = event_spot(c, k, LETTER);
        double x = c->event[k].x;
        fprintf(out, "set arrow from %.10g, graph 0 to %.10g, graph 1 nohead lc rgb '#777777' lw 1 dt 3\n", x,
                x);
        fprintf(out, "set label ");
        quoted(out, c->event[k].name);
        fprintf(out, " noenhanced at graph %.6g, graph 1 left offset 0,%g\n", spot.from, 0.6 + spot.row);
    }
}

/* A number of a row of data; gnuplot reads NaN as what is missing. */
static const char *number(double value, char text[32])
{
    if (isfinite(value))
        snprintf(text, 32, "%.10g", value);
    else
        snprintf(text, 32, "NaN");
    return text;
}

static void points_script(const struct chart *c, int k, FILE *out)
{
    char text[4][32];
    const struct chart_curve *curve = &c->curve[k];
    fprintf(out, "$curve%d << END\n", k);
    for (size_t i = 0; i < curve->count; i++) {
        const struct chart_point *p = &curve->point[i];
        fprintf(out, "%s %s %s %s\n", number(p->x, text[0]), number(p->y, text[1]), number(p->low, text[2]),
                number(p->high, text[3]));
    }
    fprintf(out, "END\n");
}

static void map_points(const struct chart *c, FILE *out)
{
    char text[32];
    const struct chart_map *m = &c->map;
    double dx = m->across > 1 ? (m->x1 - m->x0) / (m->across - 1) : 1;
    double dy = m->down > 1 ? (m->y1 - m->y0) / (m->down - 1) : 1;
    bool image = !c->x.logarithmic && !c->y.logarithmic; /* needs every point, NaN too */
    fprintf(out, "$map << END\n");
    for (int k = 0; k < m->down; k++)
        for (int i = 0; i < m->across; i++) {
            /* Boxes overlap a little: between edges that only meet, the ground shines through. */
            double x[2] = {m->x0 + (i - 0.5) * dx, m->x0 + (i + (i + 1 < m->across ? 0.55 : 0.5)) * dx};
            double y[2] = {m->y0 + (k - 0.5) * dy, m->y0 + (k + (k + 1 < m->down ? 0.55 : 0.5)) * dy};
            for (int side = 0; side < 2; side++) {
                x[side] = c->x.logarithmic ? pow(10, x[side]) : x[side];
                y[side] = c->y.logarithmic ? pow(10, y[side]) : y[side];
            }
            if (image) /* takes the middles */
                fprintf(out, "%.8g %.8g %s\n", m->x0 + i * dx, m->y0 + k * dy,
                        number(m->value[k * m->across + i], text));
            else if (isfinite(m->value[k * m->across + i]))
                fprintf(out, "%.8g %.8g %.8g %.8g %s\n", x[0], x[1], y[0], y[1],
                        number(m->value[k * m->across + i], text));
        }
    fprintf(out, "END\nset palette defined (");
    for (int k = 0; k <= 8; k++) {
        int rgb[3];
        shade_colour(k / 8.0, rgb);
        fprintf(out, "%s%d '#%02x%02x%02x'", k ? ", " : "", k, (unsigned)rgb[0], (unsigned)rgb[1],
                (unsigned)rgb[2]);
    }
    fprintf(out, ")\nunset grid\nunset key\n");
}

static void style_script(const struct chart_curve *curve, FILE *out)
{
    static const int points[INKS] = {7, 6, 7, 4, 8, 5, 9, 1};
    const char *colour = ink_colour(curve->ink);
    double lw = curve->ink == INK_GREY ? 1.5 : 2.5;
    switch (curve->kind) {
    case CHART_LINE:
        fprintf(out, "using 1:2 with lines lc rgb '%s' lw %g dt %d", colour, lw, curve->dash + 1);
        break;
    case CHART_MARKED:
        fprintf(out, "using 1:2 with linespoints lc rgb '%s' lw %g dt %d pt %d ps 0.8", colour, lw,
                curve->dash + 1, points[curve->ink]);
        break;
    case CHART_STEPS:
        fprintf(out, "using 1:2 with steps lc rgb '%s' lw %g dt %d", colour, lw, curve->dash + 1);
        break;
    case CHART_POINTS:
        fprintf(out, "using 1:2 with points lc rgb '%s' pt %d ps 1.3 lw 1.5", colour, points[curve->ink]);
        break;
    case CHART_RANGES:
        fprintf(out, "using 1:3:(0):($4-$3) with vectors heads size screen 0.007,90 lc rgb '%s' lw 4",
                colour);
        break;
    case CHART_BOTH:
        fprintf(out, "using 1:2:3:4 with yerrorlines pt %d lc rgb '%s' lw %g dt %d", points[curve->ink],
                colour, lw, curve->dash + 1);
        break;
    }
    if (*curve->title) {
        fprintf(out, " title ");
        quoted(out, curve->title);
    } else {
        fprintf(out, " notitle");
    }
}

void chart_script(const struct chart *c, FILE *out)
{
    fprintf(out, "set border 3\nset tics nomirror\nset datafile missing 'nan'\n"
                 "set key below Left reverse samplen 4 height 0.6\nset grid lc rgb '#bbbbbb' lw 0.5 dt 1\n");
    texts_script(c, out);
    axis_script(out, &c->x, "x");
    axis_script(out, &c->y, "y");
    events_script(c, out);
    for (int k = 0; k < c->curves; k++)
        points_script(c, k, out);
    if (c->map.value)
        map_points(c, out);
    const char *between = "plot ";
    if (c->map.value && !c->x.logarithmic && !c->y.logarithmic) {
        fprintf(out, "plot $map using 1:2:3 with image notitle");
        between = ", ";
    } else if (c->map.value) {
        fprintf(out, "plot $map using (($1+$2)/2):(($3+$4)/2):1:2:3:4:5 with boxxyerror fs solid noborder "
                     "lc palette z notitle");
        between = ", ";
    }
    for (int k = 0; k < c->curves; k++) {
        fprintf(out, "%s$curve%d ", between, k);
        style_script(&c->curve[k], out);
        between = ", ";
    }
    fprintf(out, "\n");
}
