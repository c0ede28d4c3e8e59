/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'plot', and the table of all plots. */
#include "interpreter/feature.h"
#include "pictures/plots/plots.h"
#include <string.h>

/* Returns plot number k of all features, counted from 0, or NULL if there are no more. */
static const struct plot *plot_at(int k)
{
    const struct feature *f;
    for (int i = 0; (f = feature_at(i)) != NULL; i++)
        for (const struct plot *const *table = f->plots; table && *table; table++)
            for (const struct plot *plot = *table; plot->name; plot++)
                if (k-- == 0)
                    return plot;
    return NULL;
}

static const char *plot_names(const void *context, int k)
{
    (void)context;
    const struct plot *plot = plot_at(k);
    return plot ? plot->name : NULL;
}

static const struct column *plot_columns(int k, const char **name, const char **summary)
{
    const struct plot *plot = plot_at(k);
    if (!plot)
        return NULL;
    *name = plot->name;
    *summary = plot->summary;
    return plot->columns;
}

/* The parsed text after the name of a plot. */
struct plot_parsed {
    struct options_parsed look;
    bool has_argument;
    void *argument; /* the result of plot->argument->parse, or NULL */
};

/* A struct plot_parsed after binding. The question of a fit is not bound yet; plot_fit binds it. */
struct plot_given {
    struct chart_look look;
    bool has_argument;
    void *argument;
};

static bool argument_parse(struct reader *r, const struct plot *plot, struct question *q)
{
    if (!plot->argument)
        return problem_error(r->problem, "'plot %s' takes no arguments", plot->name);
    if (plot->argument->parse)
        return plot->argument->parse(r, q);
    switch (plot->argument->kind) {
    case ARGUMENT_CHOICE:
        return item_parse_choice(r, plot->argument, &q->item[1]);
    default:
        r->last = false; /* keywords for the look of the chart may follow */
        return item_parse(r, plot->argument, &q->item[1]);
    }
}

/* Parses the text after the name of a plot. Keywords may stand before or after the plot's argument. There is
 * one exception: if the argument is a grid or a fit, it extends to the end of the command, so keywords must
 * stand before it. */
static bool more_parse(struct reader *r, struct question *q)
{
    const struct plot *plot = plot_at((int)q->item[0].number);
    struct plot_parsed *p = reader_memory(r, sizeof *p);
    if (!p || !options_parse(r, &look_options, &p->look))
        return false;
    reader_place(r, r->at);
    p->has_argument = !reader_ends(r);
    if (p->has_argument && !argument_parse(r, plot, q))
        return false;
    p->argument = q->parsed;
    q->parsed = p;
    return options_parse(r, &look_options, &p->look) &&
           (reader_ends(r) || problem_error(r->problem, "'%.20s' is one argument too many", r->at));
}

static bool more_bind(const struct question *q, const struct query *query, struct arguments *given,
                      struct problem *problem)
{
    const struct plot_parsed *p = q->parsed;
    const struct argument *kind = plot_at((int)q->item[0].number)->argument;
    const bool is_bound = p->argument && kind->bind;
    struct question inner = *q;
    inner.parsed = p->argument;
    if (is_bound && !kind->bind(&inner, query, given, problem))
        return false;
    void *argument = is_bound ? given->bound : p->argument;
    struct plot_given *g = arguments_take(given, sizeof *g, query, problem);
    if (!g)
        return false;
    g->has_argument = p->has_argument;
    g->argument = argument;
    struct options look = {.has = {false}};
    return options_bind(&p->look, q->text, query, &look, problem) && look_make(&look, &g->look, problem);
}

static bool run_plot(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct plot *plot = plot_at((int)query->given->number[0]);
    const struct plot_given *more = query->given->count > 1 ? query->given->bound : NULL;
    const struct chart_look usual = {.title = NULL};
    /* The plot sees only its own argument. */
    struct arguments given = *query->given;
    struct query plot_query = *query;
    given.count = more && more->has_argument ? 2 : 1;
    given.bound = more ? more->argument : NULL;
    plot_query.given = &given;
    a->columns = plot->columns;
    a->style.errors = 0; /* a picture shows no errors */
    return plot_write(plot, more ? &more->look : &usual, &plot_query, a, problem);
}

/* Each plot has its own columns. */
static const struct column no_columns[] = {{NULL, NULL, NULL, 0}};

const struct command plot_commands[] = {
    {.name = "plot",
     .synonyms = "picture image graph figure chart diagram svg png pdf gnuplot",
     .argument =
         {{.name = "WHAT", .kind = ARGUMENT_CHOICE, .noun = "picture", .choices = plot_names},
          {.name = "MORE", .kind = ARGUMENT_GRID, .optional = true, .parse = more_parse, .bind = more_bind}},
     .summary = "a chart of the row, of limits, of a cycle, or of any sweep",
     .help =
         "The picture appears in the terminal. 'plot fall > fall.svg' makes a file with gnuplot: "
         ".svg, .png, .pdf, or .tex for \\input in a document with \\usepackage{gnuplot-lua-tikz}. The "
         "extensions .csv and .json give the data, and .gp gives gnuplot's script with the data, for you to "
         "change.\n\n"
         "'plot growth title \"Growth\" xrange 0.2 0.6 > a.pdf' chooses the look. 'title', 'xlabel' "
         "and 'ylabel' take a text. 'xrange' and 'yrange' take the two ends of an axis, in the unit that its "
         "label names. 'xscale' and 'yscale' take 'log' or 'linear', and 'legend' takes 'below', 'right' or "
         "'off'.\n\n"
         "For a file, 'width' and 'height' take 6 to 30 cm (the unit may be left out), 'font' takes "
         "points, and 'family' takes "
         "the name of a font.\n\n"
         "These words can come in any order. They must come before an argument "
         "that goes to the end of the line, such as a grid.",
     .equation = "(19; c1) (20; c2) (21; c3) (27; A2), figures 'growth' and 'marginal'",
     .example = "plot growth",
     .see = "fall mend placement sweep curve fit draw",
     .sweep.refusal = "it draws",
     .writes = WRITES_CHARTS,
     .rows = true,
     .columns = no_columns,
     .parts = plot_columns,
     .run = run_plot},
    {.name = NULL},
};
