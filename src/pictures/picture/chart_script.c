/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes charts as gnuplot scripts. */
#include "answer/wrap.h"
#include "io/escape.h"
#include "io/terminal.h"
#include "pictures/picture/chart.h"
#include <math.h>
#include <string.h>

enum { ROOM = 320 };

/* How a picture and the text in it are arranged. */
struct arrangement {
    double width, height, font; /* in cm, and in points */
    int columns;                /* the number of characters that fit across the picture */
    int across;                 /* the number of columns of the legend */
    int title;                  /* the number of characters that fit on a line of the legend */
    int longest;                /* the number of characters of the longest title in the legend */
    int ticks_up;               /* the number of ticks for which the y axis has room */
};

/* Without a height that the user has chosen, the picture is tall enough for the axes and the text around
 * them. Without a font size, a narrow picture gets a smaller font. */
static struct arrangement arrangement_of(const struct chart *c)
{
    const double line_cm = 0.048;   /* the height of a line in cm, divided by the font size in points */
    const double least_high = 0.45; /* the minimum height of the axes, relative to the picture's width */
    const double narrow = 10;       /* below this width in cm, the font is smaller */
    const double least_font = 7;    /* in points */
    const int sample = 9;           /* the width in characters of the line before a title in the legend */
    const struct chart_look *look = &c->look;
    const char *const texts[] = {c->title, c->note, c->x.label, c->y.label, c->map.value ? c->map.label : ""};
    const bool is_below = !c->map.value && look->legend == CHART_LEGEND_BELOW;
    struct arrangement l = {.width = look->width > 0 ? look->width : CHART_WIDTH, .across = 1};
    l.font = look->font > 0 ? look->font : fmax(CHART_FONT * fmin(l.width / narrow, 1), least_font);
    l.columns = (int)fmax(64 * l.width / CHART_WIDTH * CHART_FONT / l.font, 16);
    l.title = look->legend == CHART_LEGEND_RIGHT ? l.columns / 3 : l.columns - sample;
    for (int k = 0; k < c->curves; k++)
        l.longest = (int)fmax(l.longest, utf8_columns(c->curve[k].title));
    const int fits = (l.columns + 4) / (l.longest + sample); /* titles in a line */
    if (is_below && fits > 1)
        l.across = fits;
    int lines = is_below ? 3 + (l.longest > l.title ? 2 : 1) * ((c->curves + l.across - 1) / l.across) : 3;
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++)
        lines += *texts[k] ? utf8_columns(texts[k]) / l.columns + 1 : 0;
    const double line = line_cm * l.font;
    l.height = look->height > 0
                   ? look->height
                   : fmax(l.width * CHART_HEIGHT / CHART_WIDTH, lines * line + least_high * l.width);
    l.ticks_up = (int)fmin(fmax((l.height - lines * line) / (1.8 * line), 2), 9);
    return l;
}

#define TEX_FONT 10.0 /* the font size of a document in points, unless the document chooses another */

void chart_terminal(const struct chart *c, const char *name, char terminal[TERMINAL_TEXT])
{
    enum { SIZE = TERMINAL_TEXT };
    const struct chart_look *chosen = &c->look;
    struct arrangement l = arrangement_of(c);
    /* the font 'sans' exists even on a minimal Debian system */
    const char *family = chosen->family ? chosen->family : "sans";
    const bool svg = strcmp(name, "svg") == 0;
    const double dots = svg ? 45 : 60; /* dots per cm */
    if (!(c->tex || chosen->width > 0 || chosen->height > 0 || chosen->font > 0 || chosen->family))
        l.height = CHART_HEIGHT;
    if (c->tex)
        snprintf(terminal, SIZE, "%s size %.6gcm,%.6gcm textscale %.4g", name, l.width, l.height,
                 l.font / TEX_FONT);
    else if (strcmp(name, "pdfcairo") == 0)
        snprintf(terminal, SIZE, "%s size %.6gcm,%.6gcm font '%s,%.3g' enhanced", name, l.width, l.height,
                 family, l.font);
    else /* the font is large, since a phone shrinks the picture */
        snprintf(terminal, SIZE, "%s size %.0f,%.0f%s font '%s,%.3g'%s enhanced", name, dots * l.width,
                 dots * l.height, svg ? " dynamic" : "", family, l.font * 17 / CHART_FONT,
                 svg ? " background rgb 'white'" : "");
}

/* Returns the width of a character, as a fraction of the x axis. */
static double letter_of(const struct arrangement *l)
{
    return 1.024 / l->columns;
}

/* Breaks a text into lines of similar length, each with at most `most` characters. For TeX, escapes the
 * characters that are commands. Returns the number of lines. */
static int lines_make(const struct chart *chart, const char *text, int most, char lines[ROOM])
{
    enum { LETTER = 20 /* the maximum length of an escaped character */ };
    char shown[ROOM], piece[ESCAPE_PIECE];
    int count = 0, at = 0, all = utf8_columns(escape_text(text, shown, sizeof shown)),
        columns = all / (all / most + 1) + 8;
    text = shown;
    lines[0] = '\0';
    while (*text && at + LETTER < ROOM) {
        size_t n = line_break(text, columns < most ? columns : most);
        at += snprintf(lines + at, (size_t)(ROOM - at), "%s", count++ ? "\n" : "");
        for (size_t i = 0; i < n && at + LETTER < ROOM; i++)
            at += snprintf(lines + at, (size_t)(ROOM - at), "%s",
                           chart->tex ? escape_tex(text[i], piece) : (char[]){text[i], '\0'});
        text += n + (text[n] == ' ');
    }
    return count;
}

/* Writes a command with a text, such as "set label TEXT noenhanced ...". */
static void text_script(FILE *out, const char *before, const char *text)
{
    fputs(before, out);
    gnuplot_text(out, text);
    fputs(" noenhanced", out);
}

static void axis_script(FILE *out, const struct chart_axis *a, const char *name, int most)
{
    const struct ticks ticks = axis_ticks(a, most);
    if (a->logarithmic)
        fprintf(out, "set logscale %s\n", name);
    fprintf(out, "set %srange [%.10g:%.10g]\nset %stics (", name, a->low, a->high, name);
    for (int k = 0; k < ticks.count; k++) {
        fputs(k ? ", " : "", out);
        gnuplot_text(out, ticks.text[k]);
        fprintf(out, " %.12g", ticks.at[k]);
    }
    fprintf(out, ")\n");
}

/* Sets up the legend, with as many columns as the longest title allows. */
static void legend_script(const struct chart *c, const struct arrangement *l, FILE *out)
{
    int most = 1;
    char title[ROOM];
    for (int k = 0; k < c->curves; k++)
        most = (int)fmax(most, lines_make(c, c->curve[k].title, l->title, title));
    /* By default, gnuplot leaves room for titles of one line, but the longest title has `most` lines. */
    if (c->look.legend == CHART_LEGEND_OFF)
        fprintf(out, "unset key\n");
    else if (c->look.legend == CHART_LEGEND_RIGHT)
        fprintf(out, "set key outside right top Left reverse samplen 2 spacing %g noenhanced\n", 1.1 * most);
    else /* gnuplot reserves too much width for long titles; a negative `width` takes some of it away */
        fprintf(out,
                "set key below Left reverse samplen 4 height %g spacing %g noenhanced maxcols %d width %d\n",
                most > 1 ? 1.4 : 1.2, (double)most, l->across, l->longest > 16 ? -l->longest / 6 : 0);
}

/* Writes the title and the labels. The label of the y axis is written above the axis, because a long label
 * beside the axis would be cut off. */
static void texts_script(const struct chart *c, const struct arrangement *l, FILE *out)
{
    char title[ROOM], note[ROOM], both[2 * ROOM], x[ROOM], y[ROOM], shades[ROOM];
    const int most = l->columns;
    int lines = lines_make(c, c->title, most, title) + lines_make(c, c->note, most, note),
        above = event_rows(c, letter_of(l));
    int left = lines_make(c, c->y.label, most, y),
        right = c->map.value ? lines_make(c, c->map.label, most, shades) : 0;
    text_script(out, "set label ", y);
    fprintf(out, " at screen 0.02, graph 1 left offset 0,%g\n", above + left + 0.1);
    if (right && utf8_columns(c->y.label) + utf8_columns(c->map.label) > most - 4)
        above += left; /* the two labels do not fit side by side */
    above += left > right ? left : right;
    if (right) {
        text_script(out, "set label ", shades);
        fprintf(out, " at screen 0.98, graph 1 right offset 0,%g\n", above + 0.1);
    }
    lines_make(c, c->x.label, most, x);
    text_script(out, "set xlabel ", x);
    snprintf(both, sizeof both, "%s%s%s", title, *note ? "\n" : "", note);
    text_script(out, "\nset title ", both);
    fprintf(out, " offset 0,%g\nset tmargin %g\n", above + 0.2, above + lines + 1.6);
}

static void events_script(const struct chart *c, const struct arrangement *l, FILE *out)
{
    for (int k = 0; k < c->events; k++) {
        const struct event_spot spot = event_spot(c, k, letter_of(l));
        double x = c->event[k].x;
        char name[ROOM];
        lines_make(c, c->event[k].name, l->columns, name);
        fprintf(out, "set arrow from %.10g, graph 0 to %.10g, graph 1 nohead lc rgb '#777777' lw 1 dt 3\n", x,
                x);
        text_script(out, "set label ", name);
        fprintf(out, " at graph %.6g, graph 1 left offset 0,%g\n", spot.from, 0.6 + spot.row);
    }
}

/* Writes a number into the data. gnuplot treats NaN as a missing number. */
static void number_script(double value, FILE *out)
{
    if (isfinite(value))
        fprintf(out, "%.10g ", value);
    else
        fprintf(out, "NaN ");
}

static void points_script(const struct chart_curve *curve, int k, FILE *out)
{
    fprintf(out, "$curve%d << END\n", k);
    for (size_t i = 0; i < curve->count; i++) {
        const struct chart_point *p = &curve->point[i];
        const double number[] = {p->x, p->y, p->low, p->high};
        for (int n = 0; n < 4; n++)
            number_script(number[n], out);
        putc('\n', out);
    }
    fprintf(out, "END\n");
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
    fprintf(out, "END\nset palette defined (");
    for (int k = 0; k <= 8; k++)
        fprintf(out, "%s%d '#%06x'", k ? ", " : "", k, (unsigned)shade_colour(k / 8.0));
    fprintf(out, ")\nunset grid\nunset key\nplot $map using %s notitle\n",
            image ? "1:2:3 with image"
                  : "(($1+$2)/2):(($3+$4)/2):1:2:3:4:5 with boxxyerror fs solid noborder lc palette z");
}

static void curve_script(const struct chart *c, const struct arrangement *l, int k, FILE *out)
{
    static const int points[INKS] = {7, 6, 7, 4, 8, 5, 9, 1};
    static const struct {
        const char *how;
        double width; /* the width of the line, or 0 for the usual width */
        double size;  /* the size of the points, or 0 for no points */
        bool dashed;
    } styles[] = {
        [CHART_LINE] = {"1:2 with lines", .dashed = true},
        [CHART_POINTS] = {"1:2 with points", 1.5, 1.3, false},
        [CHART_MARKED] = {"1:2 with linespoints", 0, 0.8, true},
        [CHART_STEPS] = {"1:2 with steps", .dashed = true},
        [CHART_RANGES] = {"1:3:(0):($4-$3) with vectors heads size screen 0.007,90", .width = 4},
        [CHART_BOTH] = {"1:2:3:4 with yerrorlines", 0, 1, true},
    };
    const struct chart_curve *curve = &c->curve[k];
    char title[ROOM];
    /* In a small picture, large points and thick lines would cover each other. */
    const double point = c->tex ? 2 : 1, small = fmin(l->width / (0.8 * CHART_WIDTH), 1),
                 thin = fmax(small, 0.6);
    double usual = curve->ink == INK_GREY ? 1.5 : 2.5, width = styles[curve->kind].width;
    fprintf(out, "%s$curve%d using %s lc rgb '#%06x' lw %g", k ? ", " : "plot ", k, styles[curve->kind].how,
            (unsigned)ink_colour(curve->ink), thin * (width > 0 ? width : usual));
    if (styles[curve->kind].dashed)
        fprintf(out, " dt %d", curve->dash + 1);
    if (styles[curve->kind].size > 0)
        fprintf(out, " pt %d ps %g", points[curve->ink], point * small * styles[curve->kind].size);
    lines_make(c, curve->title, l->title, title);
    fputs(" title ", out);
    gnuplot_text(out, title);
}

void chart_script(const struct chart *c, FILE *out)
{
    fprintf(out, "set border 3\nset tics nomirror\nset datafile missing 'nan'\n"
                 "set grid lc rgb '#bbbbbb' lw 0.5 dt 1\n");
    if (c->look.has_range[0] || c->look.has_range[1])
        fprintf(out, "set clip two\n"); /* makes gnuplot draw lines whose ends are both outside the axes */
    const struct arrangement l = arrangement_of(c);
    legend_script(c, &l, out);
    texts_script(c, &l, out);
    const int ticks = 9 * l.columns / 64;
    axis_script(out, &c->x, "x", c->x.whole ? 20 * l.columns / 64 : (int)fmin(fmax(ticks, 4), 9));
    axis_script(out, &c->y, "y", c->y.whole ? 20 : l.ticks_up);
    events_script(c, &l, out);
    if (c->map.value) { /* a chart with a map has no curves */
        map_script(c, out);
        return;
    }
    for (int k = 0; k < c->curves; k++)
        points_script(&c->curve[k], k, out);
    for (int k = 0; k < c->curves; k++)
        curve_script(c, &l, k, out);
    fprintf(out, "\n");
}
