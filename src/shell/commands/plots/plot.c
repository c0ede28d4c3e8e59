/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'plot', and the table of all plots. */
#include "commands/cost.h"
#include "commands/plots/plots.h"
#include "commands/sweeps/sweep.h"
#include "commands/tables.h"
#include <string.h>

static const struct column plot_columns[] = {
    {"theta", "rad", "energy, omega, inertia, chain: tilt of the head", 0},
    {"dH", "mgh/2", "energy: potential energy of the train, H(theta) - H(0) (19; c1)", 0},
    {"kinetic", "mgh/2",
     "energy: J tau^2 omega^2 (21; c3); fall: kinetic energy of all moving dominoes just after the hit", 0},
    {"J", "", "energy, inertia: inertia of the train (20; c2)", 0},
    {"omegasq", "", "omega: tau^2 omega(theta)^2 (21; c3)", 0},
    {"omega", "rad/s", "omega: angular velocity of the head", 0},
    {"i", "", "chain: number of the domino, where 0 is the head", 5},
    {"theta_i", "rad", "chain: tilt of the domino (27; A2)", 0},
    {"event", "",
     "energy, omega, inertia, chain: the event at this tilt (launch, top, fall, stop or hit), if any", 6},
    {"s", "h", "growth, marginal: separation", 0},
    {"solid", "", "growth: r_max of solid dominoes, q = 4", 0},
    {"hollow", "", "growth: r_max of hollow dominoes, q = 3", 0},
    {"solid_paper", "", "growth paper: r_max of solid dominoes with the paper's fuel", 0},
    {"hollow_paper", "", "growth paper: r_max of hollow dominoes with the paper's fuel", 0},
    {"solid_pair", "", "marginal: r_max of two solid dominoes", 0},
    {"solid_train", "", "marginal: r_max of a train of solid dominoes", 0},
    {"hollow_pair", "", "marginal: r_max of two hollow dominoes", 0},
    {"hollow_train", "", "marginal: r_max of a train of hollow dominoes", 0},
    {"reach", "",
     "growth, marginal: largest growth at which a domino reaches the next one (1/s, or less with rounded "
     "edges)",
     0},
    {"domino", "", "fall, speed, gaps: number of the domino, from 1", 6},
    {"barrier", "mgh/2", "fall: energy that is needed to tip this domino over", 0},
    {"margin", "mgh/2", "fall: kinetic - barrier", 0},
    {"spare", "",
     "fall: margin / barrier; empty for a domino that needs no energy, and for domino 1 without a push", 0},
    {"place", "m", "speed: distance of this domino from domino 1, front foot to front foot", 0},
    {"speed", "m/s", "speed: speed of the front from this domino to the next one", 0},
    {"gap", "m", "gaps: gap before the domino, as planned", 0},
    {"low", "m", "gaps: lower end of the range of gaps at which all dominoes fall", 0},
    {"high", "m", "gaps: upper end of the range of gaps at which all dominoes fall", 0},
    {"others", "", "gaps: yes if all dominoes also fall at some gap outside low .. high", 6},
    {"sigma", "m",
     "placement: standard deviation of the errors in the gaps; for uniform errors, the largest error", 0},
    {"probability", "", "placement: probability that the whole row falls", 0},
    {"low", "", "placement: lower end of the 95 % interval of the probability", 0},
    {"high", "", "placement: upper end of the 95 % interval of the probability", 0},
    {"rows", "", "placement: number of rows that were set up at each sigma", 0},
    {NULL, NULL, NULL, 0},
};

static const char *paper_names(const void *context, int k)
{
    (void)context;
    return k == 0 ? "paper" : NULL;
}

/* The arguments that may follow the name of a plot. */
static const struct argument answer_argument = {.name = "NAME",
                                                .kind = ARGUMENT_CHOICE,
                                                .noun = "command with a tolerance",
                                                .choices = cost_names},
                             paper_argument = {.name = "paper",
                                               .kind = ARGUMENT_CHOICE,
                                               .noun = "word after 'plot growth'",
                                               .choices = paper_names},
                             rows_argument = {.name = "ROWS", .kind = ARGUMENT_COUNT},
                             grid_argument = {.name = "GRID", .kind = ARGUMENT_GRID},
                             fit_argument = {.name = "NAME FILE", .kind = ARGUMENT_COMMAND};

/* The plots, in the order in which completion lists them. The warning about missing initializers is off,
 * because the entries leave out members. */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
static const struct plot plots[] = {
    {"fall", plot_fall, "domino kinetic barrier margin spare", .title = "Energy to spare, domino by domino",
     .x = {"domino", "domino"}, .y = {NULL, "spare energy / energy needed,", .percent = true},
     .curve = {{"spare", "", CHART_POINTS, INK_BLUE}}},
    {"speed", plot_speed, "domino place speed", .title = "Speed of the front along the row",
     .x = {"place", "distance from the first domino"}, .y = {"speed", "speed"},
     .curve = {{"speed", "", CHART_STEPS, INK_BLUE}}},
    {"gaps", plot_gaps, "domino gap low high others",
     .title = "How far each gap may be off if all others are as planned",
     .x = {"domino", "gap before domino"}, .y = {"gap", "gap"},
     .curve = {{NULL, "all fall", CHART_RANGES, INK_BLUE}, {"gap", "planned", CHART_POINTS, INK_TEXT}}},
    {"placement", plot_placement, "sigma probability low high rows", .title = "",
     .x = {"sigma", "standard deviation (or limit) of the gap errors"},
     .y = {NULL, "rows that fall,", .percent = true}, .curve = {{"probability", "", CHART_BOTH, INK_BLUE}},
     .argument = &rows_argument},
    {"growth", plot_growth, "s solid hollow solid_paper hollow_paper reach",
     .title = "A train below its curve keeps falling", .x = {"s", ""}, .y = {NULL, "growth r"},
     .curve = {{"solid", "solid dominoes", CHART_LINE, INK_BLUE, 0},
               {"hollow", "hollow dominoes", CHART_LINE, INK_RED, 1},
               {"solid_paper", "solid, the paper's fuel", CHART_LINE, INK_SKY, 3},
               {"hollow_paper", "hollow, the paper's fuel", CHART_LINE, INK_ORANGE, 4},
               {"reach", "", CHART_LINE, INK_GREY, 2}},
     .argument = &paper_argument},
    {"marginal", plot_marginal, "s solid_pair solid_train hollow_pair hollow_train reach",
     .title = "Growth below a pair's curve: a domino that barely tips over topples the next", .x = {"s", ""},
     .y = {NULL, "growth r"},
     .curve = {{"solid_pair", "solid pair", CHART_LINE, INK_SKY, 3},
               {"solid_train", "solid train", CHART_LINE, INK_BLUE, 0},
               {"hollow_pair", "hollow pair", CHART_LINE, INK_ORANGE, 4},
               {"hollow_train", "hollow train", CHART_LINE, INK_RED, 1},
               {"reach", "", CHART_LINE, INK_GREY, 2}}},
    {"sweep", plot_sweep_rows, "", .title = "", .draw = plot_sweep_draw, .argument = &grid_argument},
    {"energy", plot_energy, "theta dH kinetic J event", .title = "Energy over a cycle",
     .x = {"theta", "tilt of the head"}, .y = {NULL, "energy, in units of m g h/2 of the head"},
     .curve = {{"dH", "rise in potential energy since the launch", CHART_LINE, INK_BLUE, 0},
               {"kinetic", "kinetic energy", CHART_LINE, INK_RED, 1}}},
    {"omega", plot_omega, "theta omegasq omega event", .title = "Angular velocity over a cycle",
     .x = {"theta", "tilt of the head"}, .y = {"omega", "angular velocity"},
     .curve = {{"omega", "", CHART_LINE, INK_BLUE, 0}}},
    {"inertia", plot_inertia, "theta J event", .title = "Inertia over a cycle",
     .x = {"theta", "tilt of the head"},
     .y = {NULL, "inertia J of the moving dominoes, 1 for the head alone"},
     .curve = {{"J", "J (20; c2)", CHART_LINE, INK_BLUE, 0}}},
    {"chain", plot_chain, "i theta theta_i event", .title = "Tilts over a cycle",
     .x = {"theta", "tilt of the head"}, .y = {"theta_i", "tilt of domino i"},
     .curve = {{"theta_i", "i = 0, the head", CHART_LINE, INK_BLUE, 0, 1},
               {"theta_i", "i = 1", CHART_LINE, INK_RED, 1, 2},
               {"theta_i", "i = 2", CHART_LINE, INK_GREEN, 2, 3},
               {"theta_i", "i = 3", CHART_LINE, INK_PURPLE, 3, 4},
               {"theta_i", "i = 4", CHART_LINE, INK_ORANGE, 4, 5}}},
    {"cost", plot_cost, "", .title = "", .argument = &answer_argument},
    {"fit", plot_fit, "", .title = "", .argument = &fit_argument},
    {.name = NULL},
};
#pragma GCC diagnostic pop

static const char *plot_names(const void *context, int k)
{
    (void)context;
    return plots[k].name;
}

/* The parsed text after the name of a plot. */
struct plot_parsed {
    struct look_parsed look;
    bool has_argument;
    void *argument; /* the result of sweep_parse_grid or plot_fit_parse, or NULL */
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
    switch (plot->argument->kind) {
    case ARGUMENT_GRID:
        return sweep_parse_grid(r, q) && sweep_parse_answers(r, q);
    case ARGUMENT_COMMAND:
        return plot_fit_parse(r, q);
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
    const struct plot *plot = &plots[(int)q->item[0].number];
    struct plot_parsed *p = reader_memory(r, sizeof *p);
    if (!p || !look_parse(r, &p->look))
        return false;
    reader_place(r, r->at);
    p->has_argument = !reader_ends(r);
    if (p->has_argument && !argument_parse(r, plot, q))
        return false;
    p->argument = q->parsed;
    q->parsed = p;
    return look_parse(r, &p->look) &&
           (reader_ends(r) || problem_error(r->problem, "'%.20s' is one argument too many", r->at));
}

static bool more_bind(const struct question *q, const struct query *query, struct arguments *given,
                      struct problem *problem)
{
    const struct plot_parsed *p = q->parsed;
    const struct argument *kind = plots[(int)q->item[0].number].argument;
    const bool is_grid = p->argument && kind->kind == ARGUMENT_GRID;
    struct question inner = *q;
    inner.parsed = p->argument;
    if (is_grid && !sweep_bind(&inner, query, given, problem))
        return false;
    void *argument = is_grid ? given->bound : p->argument;
    struct plot_given *g = arguments_take(given, sizeof *g, query, problem);
    if (!g)
        return false;
    g->has_argument = p->has_argument;
    g->argument = argument;
    return look_bind(&p->look, q->text, query, &g->look, problem);
}

/* Chooses the columns of a plot. If several columns have the same key, chooses the one whose description
 * mentions the plot. */
static void columns_choose(const struct plot *plot, struct column *chosen)
{
    int n = 0;
    for (const char *key = plot->keys; *key && n + 1 < ANSWER_COLUMNS; key += strspn(key, " ")) {
        size_t length = strcspn(key, " ");
        for (const struct column *c = plot_columns; c->key; c++)
            if (strlen(c->key) == length && strncmp(c->key, key, length) == 0 &&
                strstr(c->meaning, plot->name))
                chosen[n++] = *c;
        key += length;
    }
    chosen[n] = (struct column){NULL, NULL, NULL, 0};
}

static bool run_plot(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct plot *plot = &plots[(int)query->given->number[0]];
    const struct plot_given *more = query->given->count > 1 ? query->given->bound : NULL;
    const struct chart_look usual = {.title = NULL};
    /* The plot sees only its own argument. */
    struct arguments given = *query->given;
    struct query plot_query = *query;
    given.count = more && more->has_argument ? 2 : 1;
    given.bound = more ? more->argument : NULL;
    plot_query.given = &given;
    columns_choose(plot, a->copy);
    a->columns = a->copy;
    a->style.errors = 0; /* a picture shows no errors */
    return plot_write(plot, more ? &more->look : &usual, &plot_query, a, problem);
}

bool plot_sweep(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct chart_look usual = {.title = NULL};
    return plot_write(&plots[names_exact(plot_names, NULL, "sweep")], &usual, query, a, problem);
}

const struct command plot_commands[] = {
    {.name = "plot",
     .synonyms = "picture image graph figure chart diagram svg png pdf gnuplot",
     .argument =
         {{.name = "WHAT", .kind = ARGUMENT_CHOICE, .noun = "picture", .choices = plot_names},
          {.name = "MORE", .kind = ARGUMENT_GRID, .optional = true, .parse = more_parse, .bind = more_bind}},
     .summary = "a chart of the row, of limits, of a cycle, or of any sweep",
     .help =
         "For a row, 'plot fall' shows how much energy each domino has to spare. 'plot speed' shows how fast "
         "the fall runs along the row, and 'plot gaps' how far each gap may be off. 'plot placement 400' "
         "shows how likely the whole row is to fall. It uses 400 random rows for each size of the errors. "
         "For trains, 'plot growth' shows the largest growth. 'plot growth paper' compares it with the "
         "growth that the paper's fuel gives, and 'plot marginal' compares it with the largest growth of two "
         "dominoes. 'plot energy', 'plot omega', 'plot inertia' and 'plot chain' show one cycle, and 'plot "
         "cost rmax' shows what accuracy costs. 'plot sweep s 0.1 0.9 33 : rmax' shows any sweep over one or "
         "two parameters. 'plot sweep s 0.1 0.9 33 : rmax, pair' shows the curves of several answers. 'plot "
         "fit friction FILE' shows measurements against the values that the model gives with the fitted "
         "friction. The picture appears in the terminal. 'plot fall > fall.svg' makes a file with gnuplot: "
         ".svg, .png, .pdf, or .tex for \\input in a document with \\usepackage{gnuplot-lua-tikz}. The "
         "extensions .csv and .json give the data, and .gp gives gnuplot's script with the data, for you to "
         "change. 'plot growth title \"Growth\" xrange 0.2 0.6 > a.pdf' chooses the look. 'title', 'xlabel' "
         "and 'ylabel' take a text. 'xrange' and 'yrange' take the two ends of an axis, in the unit that its "
         "label names. 'xscale' and 'yscale' take 'log' or 'linear', and 'legend' takes 'below', 'right' or "
         "'off'. For a file, 'width' and 'height' take 6 to 30 cm (the unit may be left out), 'font' takes "
         "points, and 'family' takes "
         "the name of a font. These words can come in any order. They must come before the grid of a sweep "
         "or the parameters of a fit.",
     .equation = "(19; c1) (20; c2) (21; c3) (27; A2), figures 'growth' and 'marginal'",
     .example = "plot growth",
     .see = "fall mend placement sweep curve fit draw",
     .sweep_refusal = "it draws",
     .writes = WRITES_CHARTS,
     .rows = true,
     ANSWER(plot)},
    {.name = NULL},
};
