/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The look of a chart as the user chooses it: texts, size, font size, axes and legend. */
#include "pictures/plots/plots.h"
#include <string.h>

static const char *scale_names(const void *context, int k)
{
    static const char *const names[] = {"linear", "log", NULL};
    (void)context;
    return names[k];
}

/* Lists the values of 'legend', in the order of enum chart_legend. */
static const char *legend_names(const void *context, int k)
{
    static const char *const names[] = {"below", "right", "off", NULL};
    (void)context;
    return names[k];
}

static const struct argument height_argument = {.name = "LENGTH", .kind = ARGUMENT_HEIGHT},
                             number_argument = {.name = "NUMBER", .kind = ARGUMENT_NUMBER},
                             scale_argument = {.name = "SCALE",
                                               .kind = ARGUMENT_CHOICE,
                                               .noun = "scale of an axis",
                                               .choices = scale_names},
                             legend_argument = {.name = "LEGEND",
                                                .kind = ARGUMENT_CHOICE,
                                                .noun = "place of the legend",
                                                .choices = legend_names};

enum {
    LOOK_WIDTH,
    LOOK_HEIGHT,
    LOOK_FONT,
    LOOK_FAMILY,
    LOOK_TITLE,
    LOOK_XLABEL,
    LOOK_YLABEL,
    LOOK_XRANGE,
    LOOK_YRANGE,
    LOOK_XSCALE,
    LOOK_YSCALE,
    LOOK_LEGEND
};

#define ANY (~0u)
const struct option_list look_options = {
    .options =
        (const struct option[]){
            [LOOK_WIDTH] = {"width", &height_argument, 1, ANY, .least = 6, .most = 30, .unit = " cm"},
            [LOOK_HEIGHT] = {"height", &height_argument, 1, ANY, .least = 6, .most = 30, .unit = " cm"},
            [LOOK_FONT] = {"font", &number_argument, 1, ANY, .least = 5, .most = 30, .unit = " points"},
            [LOOK_FAMILY] = {"family", NULL, 1, ANY},
            [LOOK_TITLE] = {"title", NULL, 1, ANY},
            [LOOK_XLABEL] = {"xlabel", NULL, 1, ANY},
            [LOOK_YLABEL] = {"ylabel", NULL, 1, ANY},
            [LOOK_XRANGE] = {"xrange", &number_argument, 2, ANY},
            [LOOK_YRANGE] = {"yrange", &number_argument, 2, ANY},
            [LOOK_XSCALE] = {"xscale", &scale_argument, 1, ANY},
            [LOOK_YSCALE] = {"yscale", &scale_argument, 1, ANY},
            [LOOK_LEGEND] = {"legend", &legend_argument, 1, ANY},
            {NULL},
        },
    .no_unit = "sg", /* a grid may follow, so 's' and 'g' after a blank are parameters, not units */
    .usage = "write, for example, 'title \"Growth\" width 8 cm xrange 0 0.6 yscale log'",
};

/* The minimum width of a picture with a legend on the right, in cm. */
#define LEGEND_LEAST 10.0

bool look_make(const struct options *w, struct chart_look *look, struct problem *problem)
{
    *look = (struct chart_look){.title = w->text[LOOK_TITLE],
                                .x = w->text[LOOK_XLABEL],
                                .y = w->text[LOOK_YLABEL],
                                .legend = (enum chart_legend)w->value[LOOK_LEGEND][0],
                                .width = (double)w->value[LOOK_WIDTH][0],
                                .height = (double)w->value[LOOK_HEIGHT][0],
                                .font = (double)w->value[LOOK_FONT][0],
                                .family = w->text[LOOK_FAMILY]};
    for (int k = 0; k < 2; k++) {
        const int range = k == 0 ? LOOK_XRANGE : LOOK_YRANGE, scale = k == 0 ? LOOK_XSCALE : LOOK_YSCALE;
        look->low[k] = (double)w->value[range][0];
        look->high[k] = (double)w->value[range][1];
        look->has_range[k] = w->has[range];
        if (w->has[scale])
            look->scale[k] = w->value[scale][0] == 0 ? CHART_LINEAR : CHART_LOG;
        if (look->has_range[k] && !(look->low[k] < look->high[k]))
            return problem_error(problem,
                                 "%crange is %.6g .. %.6g; its second number must be larger than its first",
                                 "xy"[k], look -> low[k], look -> high[k]);
    }
    /* In a gnuplot command, a quote or a comma would end the name of the font. */
    if (look->family &&
        look->family[strspn(look->family,
                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 -")])
        return problem_error(problem, "the name of a font family may contain only letters, digits, blanks "
                                      "and '-', as in \"DejaVu Serif\"");
    return look->legend != CHART_LEGEND_RIGHT || !(look->width > 0 && look->width < LEGEND_LEAST) ||
           problem_error(problem,
                         "a picture of %.6g cm has no room for a legend on the right, which needs %g cm; use "
                         "'legend below'",
                         look->width, LEGEND_LEAST);
}
