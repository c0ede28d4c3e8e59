/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The look of a chart as the user chooses it: texts, size, font size, axes and legend. */
#include "commands/plots/plots.h"
#include <string.h>

/* The words that choose the look. Of a pair of words for the two axes, the word for the x axis comes first.
 */
enum look_word {
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
    LOOK_LEGEND,
    LOOK_WORDS
};

static const char *look_names(const void *context, int k)
{
    static const char *const names[] = {"width",  "height", "font",   "family", "title",  "xlabel", "ylabel",
                                        "xrange", "yrange", "xscale", "yscale", "legend", NULL};
    (void)context;
    return names[k];
}

static const char *scale_names(const void *context, int k)
{
    static const char *const names[] = {"linear", "log", NULL};
    (void)context;
    return names[k];
}

/* In the order of enum chart_legend. */
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
                                               .of = "scale of an axis",
                                               .choices = scale_names},
                             legend_argument = {.name = "LEGEND",
                                                .kind = ARGUMENT_CHOICE,
                                                .of = "place of the legend",
                                                .choices = legend_names};

/* The limits of the width and height of a picture in a file, in cm, and of its font size, in points. */
#define SIZE_LEAST 6
#define MOST       30
#define FONT_LEAST 5
/* The minimum width of a picture with a legend at the right, in cm. */
#define LEGEND_LEAST 10.0

enum { FAMILY_LENGTH = 64 };

/* If a value follows the word with the index k, makes the reader ready to parse it. */
static bool value_begins(struct reader *r, int k)
{
    r->last = false;
    reader_place(r, r->at);
    return !reader_ends(r) ||
           problem_error(
               r->problem,
               "the value of '%s' is missing, as in 'title \"Growth\" width 8 cm xrange 0 0.6 yscale log'",
               look_names(NULL, k));
}

/* Parses a number or a length. A grid may follow it, so 's' and 'g' after a blank are parameters, not units.
 */
static bool number_parse(struct reader *r, int k, struct item *item)
{
    const char *no_unit = r->no_unit;
    r->no_unit = "sg";
    bool good =
        value_begins(r, k) && item_parse(r, k < LOOK_FONT ? &height_argument : &number_argument, item);
    r->no_unit = no_unit;
    return good;
}

/* Parses the value, or the two ends of a range, that follow the word with the index k. */
static bool word_parse(struct reader *r, struct look_parsed *p, int k)
{
    const char **const texts[] = {&p->look.family, &p->look.title, &p->look.x, &p->look.y};
    struct item *range = p->range[k == LOOK_YRANGE], choice;
    switch ((enum look_word)k) {
    case LOOK_WIDTH:
    case LOOK_HEIGHT:
    case LOOK_FONT:
        return number_parse(r, k, &p->size[k]);
    case LOOK_XRANGE:
    case LOOK_YRANGE:
        return number_parse(r, k, &range[0]) && number_parse(r, k, &range[1]);
    case LOOK_XSCALE:
    case LOOK_YSCALE:
        if (!value_begins(r, k) || !item_parse_choice(r, &scale_argument, &choice))
            return false;
        p->look.scale[k == LOOK_YSCALE] = choice.number == 0 ? CHART_LINEAR : CHART_LOG;
        return true;
    case LOOK_LEGEND:
        if (!value_begins(r, k) || !item_parse_choice(r, &legend_argument, &choice))
            return false;
        p->look.legend = (enum chart_legend)choice.number;
        return true;
    case LOOK_FAMILY:
    case LOOK_TITLE:
    case LOOK_XLABEL:
    case LOOK_YLABEL:
    case LOOK_WORDS:
        break;
    }
    const char **text = texts[k - LOOK_FAMILY];
    if (!value_begins(r, k))
        return false;
    *text = read_text(r);
    if (!*text)
        return false;
    /* The name of a font goes into a command of gnuplot, where a quote or a comma would end it. */
    const size_t fine = strspn(*text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 -");
    return k != LOOK_FAMILY || ((*text)[fine] == '\0' && fine > 0 && fine < FAMILY_LENGTH) ||
           problem_error(r->problem,
                         "a family has letters, digits, blanks and '-', such as \"DejaVu Serif\"");
}

bool look_parse(struct reader *r, struct look_parsed *p)
{
    for (bool more = true; more && !reader_ends(r);) {
        more = false;
        r->last = false;
        offer_names(r, look_names, NULL);
        for (int k = 0; k < LOOK_WORDS && !more; k++) {
            const char *word = look_names(NULL, k);
            more = word_is_next(r, word);
            if (more)
                r->at = skip_blanks(r->at + strlen(word));
            if (more && !word_parse(r, p, k))
                return false;
        }
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
        if (!p->size[k].argument)
            continue;
        if (!item_bind(&p->size[k], text, query, NULL, &value, problem))
            return false;
        *number[k] = (double)value * (is_font ? 1 : 100);
        if (!(*number[k] >= least * (1 - 1e-12) && *number[k] <= most * (1 + 1e-12)))
            return problem_error(problem, "%s is %.6g%s; it is %g .. %g%s", look_names(NULL, k), *number[k],
                                 is_font ? "" : " cm", least, most, is_font ? " points" : " cm");
    }
    return true;
}

/* Finds the ends of the x axis, or of the y axis if `axis` is 1. */
static bool range_bind(const struct look_parsed *p, const struct text *text, const struct query *query,
                       int axis, struct chart_look *look, struct problem *problem)
{
    domq_real end[2];
    if (!p->range[axis][0].argument)
        return true;
    for (int k = 0; k < 2; k++)
        if (!item_bind(&p->range[axis][k], text, query, NULL, &end[k], problem))
            return false;
    look->low[axis] = (double)end[0];
    look->high[axis] = (double)end[1];
    look->has_range[axis] = true;
    return look->low[axis] < look->high[axis] ||
           problem_error(problem, "%s is %.6g .. %.6g; its second number must be larger than its first",
                         look_names(NULL, LOOK_XRANGE + axis), look->low[axis], look->high[axis]);
}

bool look_bind(const struct look_parsed *p, const struct text *text, const struct query *query,
               struct chart_look *look, struct problem *problem)
{
    *look = p->look;
    for (int axis = 0; axis < 2; axis++)
        if (!range_bind(p, text, query, axis, look, problem))
            return false;
    if (!size_bind(p, text, query, look, problem))
        return false;
    return look->legend != CHART_LEGEND_RIGHT || !(look->width > 0 && look->width < LEGEND_LEAST) ||
           problem_error(problem,
                         "a picture of %.6g cm has no room for a legend at the right, which needs a width "
                         "of %g cm; use 'legend below'",
                         look->width, LEGEND_LEAST);
}
