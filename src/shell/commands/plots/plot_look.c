/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The look of a chart as the user chooses it: its texts, its size and its letters. */
#include "commands/plots/plots.h"

enum { LOOK_WIDTH, LOOK_HEIGHT, LOOK_FONT, LOOK_TITLE, LOOK_X, LOOK_Y, LOOK_WORDS };

static const char *look_names(const void *context, int k)
{
    static const char *const names[] = {"width", "height", "font", "title", "xlabel", "ylabel", NULL};
    (void)context;
    return names[k];
}

/* The ranges of the size of a picture for print, in cm, and of its letters, in points. */
#define SIZE_LEAST 6
#define MOST       30
#define FONT_LEAST 5

/* Parses the value that follows the word with the index k. */
static bool word_parse(struct reader *r, struct look_parsed *p, int k)
{
    static const struct argument size[] = {{.name = "width", .kind = ARGUMENT_HEIGHT},
                                           {.name = "height", .kind = ARGUMENT_HEIGHT},
                                           {.name = "font", .kind = ARGUMENT_NUMBER}};
    const char **text = k == LOOK_TITLE ? &p->look.title : k == LOOK_X ? &p->look.x : &p->look.y;
    reader_place(r, r->at);
    if (reader_ends(r))
        return problem_error(r->problem,
                             "the value of '%s' is missing, as in 'title \"Growth\" width 8 cm font 9'",
                             look_names(NULL, k));
    if (k <= LOOK_FONT)
        return item_parse(r, &size[k], &p->size[k]);
    *text = read_text(r);
    return *text || problem_error(r->problem, "%s", unclosed);
}

bool look_parse(struct reader *r, struct look_parsed *p)
{
    for (bool more = true; more && !reader_ends(r);) {
        more = false;
        r->last = false;
        for (int k = 0; k < LOOK_WORDS && !more; k++) {
            more = reader_takes(r, look_names(NULL, k));
            if (more && !word_parse(r, p, k))
                return false;
        }
    }
    return true;
}

bool look_bind(const struct look_parsed *p, const struct text *text, const struct query *query,
               struct chart_look *look, struct problem *problem)
{
    *look = p->look;
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
