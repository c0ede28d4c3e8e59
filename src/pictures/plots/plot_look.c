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

static const struct {
    const char *name;
    const struct argument *argument; /* how to parse a value; NULL if the value is a string */
    int values;                      /* number of values after the keyword */
} words[LOOK_WORDS] = {
    [LOOK_WIDTH] = {"width", &height_argument, 1},
    [LOOK_HEIGHT] = {"height", &height_argument, 1},
    [LOOK_FONT] = {"font", &number_argument, 1},
    [LOOK_FAMILY] = {"family", NULL, 1},
    [LOOK_TITLE] = {"title", NULL, 1},
    [LOOK_XLABEL] = {"xlabel", NULL, 1},
    [LOOK_YLABEL] = {"ylabel", NULL, 1},
    [LOOK_XRANGE] = {"xrange", &number_argument, 2},
    [LOOK_YRANGE] = {"yrange", &number_argument, 2},
    [LOOK_XSCALE] = {"xscale", &scale_argument, 1},
    [LOOK_YSCALE] = {"yscale", &scale_argument, 1},
    [LOOK_LEGEND] = {"legend", &legend_argument, 1},
};

static const char *look_names(const void *context, int k)
{
    (void)context;
    return k < LOOK_WORDS ? words[k].name : NULL;
}

/* The limits for a picture in a file: width and height in cm, font size in points. */
#define SIZE_LEAST 6
#define MOST       30
#define FONT_LEAST 5
/* The minimum width of a picture with a legend on the right, in cm. */
#define LEGEND_LEAST 10.0

enum { FAMILY_LENGTH = 64 };

/* Parses one value of the keyword with index k. */
static bool value_parse(struct reader *r, int k, struct item *item, const char **text)
{
    const struct argument *a = words[k].argument;
    const char *no_unit = r->no_unit;
    r->last = false;
    reader_place(r, r->at);
    if (reader_ends(r))
        return problem_error(r->problem,
                             "the value of '%s' is missing; write, for example, 'title \"Growth\" width 8 cm "
                             "xrange 0 0.6 yscale log'",
                             words[k].name);
    if (!a)
        return (*text = read_text(r)) != NULL;
    if (a->choices)
        return item_parse_choice(r, a, item);
    r->no_unit = "sg"; /* a grid may follow, so 's' and 'g' after a blank are parameters, not units */
    bool good = item_parse(r, a, item);
    r->no_unit = no_unit;
    return good;
}

bool look_parse(struct reader *r, struct look_parsed *p)
{
    while (!reader_ends(r)) {
        int k = 0;
        r->last = false;
        offer_names(r, look_names, NULL);
        while (k < LOOK_WORDS && !word_is_next(r, words[k].name))
            k++;
        if (k == LOOK_WORDS)
            return true;
        r->at = skip_blanks(r->at + strlen(words[k].name));
        for (int i = 0; i < words[k].values; i++)
            if (!value_parse(r, k, &p->item[k][i], &p->text[k]))
                return false;
        /* In a gnuplot command, a quote or a comma would end the name of the font. */
        const char *family = k == LOOK_FAMILY ? p->text[k] : "a";
        const size_t fine =
            strspn(family, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 -");
        if (fine == 0 || fine >= FAMILY_LENGTH || family[fine] != '\0')
            return problem_error(r->problem, "the name of a font family may contain only letters, digits, "
                                             "blanks and '-', as in \"DejaVu Serif\"");
    }
    return true;
}

static bool size_bind(const struct look_parsed *p, const struct text *text, const struct query *query,
                      struct chart_look *look, struct problem *problem)
{
    double *const number[] = {&look->width, &look->height, &look->font};
    for (int k = 0; k <= LOOK_FONT; k++) {
        domq_real value;
        const bool is_font = k == LOOK_FONT;
        const double least = is_font ? FONT_LEAST : SIZE_LEAST, most = MOST;
        if (!p->item[k][0].argument)
            continue;
        struct quantity quantity;
        if (!item_bind(&p->item[k][0], text, query, &quantity, &value, problem))
            return false;
        /* A length without a unit is in cm. */
        *number[k] = (double)value * (is_font || quantity_is_number(quantity) ? 1 : 100);
        if (!(*number[k] >= least * (1 - 1e-12) && *number[k] <= most * (1 + 1e-12)))
            return problem_error(problem, "%s is %.6g%s; it must be in the range %g .. %g%s", words[k].name,
                                 *number[k], is_font ? "" : " cm", least, most, is_font ? " points" : " cm");
    }
    return true;
}

/* Evaluates the limits of the x axis or, if `axis` is 1, of the y axis. */
static bool range_bind(const struct look_parsed *p, const struct text *text, const struct query *query,
                       int axis, struct chart_look *look, struct problem *problem)
{
    const struct item *item = p->item[LOOK_XRANGE + axis];
    domq_real end[2];
    look->has_range[axis] = item[0].argument;
    if (!look->has_range[axis])
        return true;
    for (int k = 0; k < 2; k++)
        if (!item_bind(&item[k], text, query, NULL, &end[k], problem))
            return false;
    look->low[axis] = (double)end[0];
    look->high[axis] = (double)end[1];
    return look->low[axis] < look->high[axis] ||
           problem_error(problem, "%s is %.6g .. %.6g; its second number must be larger than its first",
                         words[LOOK_XRANGE + axis].name, look->low[axis], look->high[axis]);
}

bool look_bind(const struct look_parsed *p, const struct text *text, const struct query *query,
               struct chart_look *look, struct problem *problem)
{
    *look = (struct chart_look){.family = p->text[LOOK_FAMILY],
                                .title = p->text[LOOK_TITLE],
                                .x = p->text[LOOK_XLABEL],
                                .y = p->text[LOOK_YLABEL],
                                .legend = (enum chart_legend)p->item[LOOK_LEGEND][0].number};
    for (int axis = 0; axis < 2; axis++) {
        const struct item *scale = &p->item[LOOK_XSCALE + axis][0];
        if (scale->word)
            look->scale[axis] = scale->number == 0 ? CHART_LINEAR : CHART_LOG;
        if (!range_bind(p, text, query, axis, look, problem))
            return false;
    }
    if (!size_bind(p, text, query, look, problem))
        return false;
    return look->legend != CHART_LEGEND_RIGHT || !(look->width > 0 && look->width < LEGEND_LEAST) ||
           problem_error(problem,
                         "a picture of %.6g cm has no room for a legend on the right, which needs %g cm; use "
                         "'legend below'",
                         look->width, LEGEND_LEAST);
}
