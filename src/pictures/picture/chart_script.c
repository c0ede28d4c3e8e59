/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes charts as gnuplot scripts. */
#include "io/terminal.h"
#include "pictures/picture/chart.h"
#include <math.h>
#include <string.h>

enum {
    ROOM = 320,
    COLUMNS = 66,             /* the number of characters that fit across the picture */
    SAMPLE = 9,               /* the width in characters of the line before a title in the legend */
    TITLE = COLUMNS - SAMPLE, /* the maximum length of a line of the legend */
    LINE_HIGH = 20            /* the height of a line in dots */
};
#define LETTER (1.024 / COLUMNS) /* the width of a character, as a fraction of the x axis */

/* Breaks a text into lines of similar length, each with at most `most` characters. Returns the number of
 * lines. */
static int lines_make(const char *text, int most, char lines[ROOM])
{
    int count = 0, at = 0, all = utf8_columns(text), columns = all / (all / most + 1) + 8;
    for (size_t n; *text && at < ROOM; text += n + (text[n] == ' ')) {
        n = line_break(text, columns < most ? columns : most);
        at += snprintf(lines + at, (size_t)(ROOM - at), "%s%.*s", count++ ? "\n" : "", (int)n, text);
    }
    lines[at < ROOM ? at : ROOM - 1] = '\0';
    return count;
}

/* Writes a command with a text, such as "set label TEXT". */
static void text_script(FILE *out, const char *before, const char *text)
{
    fputs(before, out);
    gnuplot_text(out, text);
}

void axis_script(FILE *out, const struct chart_axis *a, const char *name, int most)
{
    const struct ticks ticks = axis_ticks(a, most);
    if (a->logarithmic)
        fprintf(out, "set logscale %s\n", name);
    fprintf(out, "set %srange [%.10g:%.10g]\nset %stics (", name, a->low, a->high, name);
    for (int k = 0; k < ticks.count; k++) {
        text_script(out, k ? ", " : "", ticks.text[k]);
        fprintf(out, " %.12g", ticks.at[k]);
    }
    fprintf(out, ")\n");
}

/* Sets up the legend, with as many columns as the longest title allows. Returns the number of its lines. */
static int legend_script(const struct chart *c, FILE *out)
{
    int longest = 0, most = 1;
    char title[ROOM];
    for (int k = 0; k < c->curves; k++) {
        longest = (int)fmax(longest, utf8_columns(c->curve[k].title));
        most = (int)fmax(most, lines_make(c->curve[k].title, TITLE, title));
    }
    const int fits = (COLUMNS + 4) / (longest + SAMPLE), across = fits > 1 ? fits : 1;
    /* By default, gnuplot leaves room for titles of one line, but the longest title has `most` lines. It
     * reserves too much width for long titles; a negative `width` takes some of it away. */
    fprintf(out, "set key below Left reverse samplen 4 height %g spacing %d maxcols %d width %d\n",
            most > 1 ? 1.4 : 1.2, most, across, longest > 16 ? -longest / 6 : 0);
    return most * ((c->curves + across - 1) / across);
}

/* Writes the events, the title and the labels. The label of the y axis is written above the axis, because a
 * long label beside the axis would be cut off. Returns the number of lines above and below the axes. */
static int texts_script(const struct chart *c, FILE *out)
{
    char title[ROOM], note[ROOM], both[2 * ROOM], x[ROOM], y[ROOM], shades[ROOM];
    const int lines = lines_make(c->title, COLUMNS, title) + lines_make(c->note, COLUMNS, note),
              left = lines_make(c->y.label, COLUMNS, y), below = lines_make(c->x.label, COLUMNS, x),
              right = c->map.value ? lines_make(c->map.label, COLUMNS, shades) : 0;
    struct event_spot spot[CHART_EVENTS];
    int above = event_spots(c, LETTER, spot);
    for (int k = 0; k < c->events; k++) {
        const double at = c->event[k].x;
        fprintf(out, "set arrow from %.10g, graph 0 to %.10g, graph 1 nohead lc rgb '#777777' lw 1 dt 3\n",
                at, at);
        text_script(out, "set label ", c->event[k].name);
        fprintf(out, " at graph %.6g, graph 1 left offset 0,%g\n", spot[k].from, 0.6 + spot[k].row);
    }
    text_script(out, "set label ", y);
    fprintf(out, " at screen 0.02, graph 1 left offset 0,%g\n", above + left + 0.1);
    if (right && utf8_columns(c->y.label) + utf8_columns(c->map.label) > COLUMNS - 4)
        above += left; /* the two labels do not fit side by side */
    above += left > right ? left : right;
    if (right) {
        text_script(out, "set label ", shades);
        fprintf(out, " at screen 0.98, graph 1 right offset 0,%g\n", above + 0.1);
    }
    text_script(out, "set xlabel ", x);
    snprintf(both, sizeof both, "%s%s%s", title, *note ? "\n" : "", note);
    text_script(out, "\nset title ", both);
    fprintf(out, " offset 0,%g\nset tmargin %g\n", above + 0.2, above + lines + 1.6);
    return above + lines + below + 3;
}

/* Writes a number into the data. gnuplot treats NaN as a missing number. */
static void number_script(double value, FILE *out)
{
    if (isfinite(value))
        fprintf(out, "%.10g ", value);
    else
        fprintf(out, "NaN ");
}

/* Writes the data of a map, and the command that draws it. If both axes are linear, the map is drawn as an
 * image. If an axis is logarithmic, each cell of the map is drawn as a box. */
static void map_script(const struct chart *c, FILE *out)
{
    const struct chart_map *m = &c->map;
    const double wide = 1.0 / m->across, high = 1.0 / m->down;
    bool image = !c->x.logarithmic && !c->y.logarithmic;
    fprintf(out, "$map << END\n");
    for (int k = 0; k < m->down; k++)
        for (int i = 0; i < m->across; i++) {
            double value = m->value[k * m->across + i], x = i * wide, y = k * high;
            if (image)
                fprintf(out, "%.8g %.8g ", axis_number(&c->x, x + wide / 2),
                        axis_number(&c->y, y + high / 2));
            /* boxes overlap a little, so that the background does not show between them */
            else if (isfinite(value))
                fprintf(out, "%.8g %.8g %.8g %.8g ", axis_number(&c->x, x),
                        axis_number(&c->x, fmin(x + 1.05 * wide, 1)), axis_number(&c->y, y),
                        axis_number(&c->y, fmin(y + 1.05 * high, 1)));
            else
                continue;
            number_script(value, out);
            putc('\n', out);
        }
    /* the palette viridis, whose brightness increases steadily */
    fprintf(out,
            "END\nset palette defined (0 '#440154', 1 '#472c7a', 2 '#3b518b', 3 '#2c718e', 4 '#21908d', 5 "
            "'#27ad81', 6 '#5cc863', 7 '#aadc32', 8 '#fde725')\nunset grid\nunset key\nplot $map using %s "
            "notitle\n",
            image ? "1:2:3 with image"
                  : "(($1+$2)/2):(($3+$4)/2):1:2:3:4:5 with boxxyerror fs solid noborder lc palette z");
}

static void curve_script(const struct chart *c, int k, FILE *out)
{
    static const struct {
        int rgb, point;
    } inks[INKS] = {[INK_TEXT] = {0, 7},         [INK_BLUE] = {0x0072b2, 6},   [INK_RED] = {0xd55e00, 7},
                    [INK_GREEN] = {0x009e73, 4}, [INK_PURPLE] = {0xcc79a7, 8}, [INK_ORANGE] = {0xe69f00, 5},
                    [INK_SKY] = {0x56b4e9, 9},   [INK_GREY] = {0x777777, 1}};
    static const struct {
        const char *how;
        double size; /* the size of the points, or 0 for no points */
    } styles[] = {
        [CHART_LINE] = {"lines", 0},
        [CHART_POINTS] = {"points", 1.3},
        [CHART_MARKED] = {"linespoints", 0.8},
        [CHART_STEPS] = {"steps", 0},
    };
    const struct chart_curve *curve = &c->curve[k];
    char title[ROOM];
    const bool is_thin = curve->ink == INK_GREY || curve->kind == CHART_POINTS;
    fprintf(out, "%s$curve%d using 1:2 with %s lc rgb '#%06x' lw %g", k ? ", " : "plot ", k,
            styles[curve->kind].how, (unsigned)inks[curve->ink].rgb, is_thin ? 1.5 : 2.5);
    if (curve->kind != CHART_POINTS)
        fprintf(out, " dt %d", curve->dash + 1);
    if (styles[curve->kind].size > 0)
        fprintf(out, " pt %d ps %g", inks[curve->ink].point, styles[curve->kind].size);
    lines_make(curve->title, TITLE, title);
    text_script(out, " title ", title);
}

void chart_script(const struct chart *c, FILE *out)
{
    enum { X_TICKS = 9, Y_TICKS = 9, WHOLE_TICKS = 20 };
    fprintf(out, "set border 3\nset tics nomirror\nset datafile missing 'nan'\n"
                 "set grid lc rgb '#bbbbbb' lw 0.5 dt 1\n");
    const int lines = legend_script(c, out) + texts_script(c, out),
              room = (PICTURE_HEIGHT - lines * LINE_HIGH) * 5 / (9 * LINE_HIGH);
    axis_script(out, &c->x, "x", c->x.whole ? WHOLE_TICKS : X_TICKS);
    axis_script(out, &c->y, "y", c->y.whole ? WHOLE_TICKS : room < 2 ? 2 : room < Y_TICKS ? room : Y_TICKS);
    if (c->map.value) { /* a chart with a map has no curves */
        map_script(c, out);
        return;
    }
    for (int k = 0; k < c->curves; k++) {
        fprintf(out, "$curve%d << END\n", k);
        for (size_t i = 0; i < c->curve[k].count; i++) {
            number_script(c->curve[k].point[i].x, out);
            number_script(c->curve[k].point[i].y, out);
            putc('\n', out);
        }
        fprintf(out, "END\n");
    }
    for (int k = 0; k < c->curves; k++)
        curve_script(c, k, out);
    fprintf(out, "\n");
}
