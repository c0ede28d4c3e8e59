/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot: curves, drawn by gnuplot. */
#include "commands/costs.h"
#include "commands/tables.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "picture/picture.h"
#include <string.h>

/* ---- The price of accuracy ---- */

static const char *series_title(const struct cost_row *row, char title[64])
{
    snprintf(title, 64,
             row->method == DOM_METHOD_PAPER ? "the paper's recipe"
             : row->method == DOM_METHOD_GSL ? "solvers of GSL"
                                             : "ours, %s",
             domq_arithmetic(row->precision)->name);
    return title;
}

/* The same in every picture. */
static int series_style(const struct cost_row *row)
{
    return row->method == DOM_METHOD_PAPER ? 1 : row->method == DOM_METHOD_GSL ? 2 : 3 + (int)row->precision;
}

static bool same_series(const struct cost_row *a, const struct cost_row *b)
{
    return a->method == b->method && a->precision == b->precision;
}

/* The rows of 'cost', as that command answers them. */
static bool cost_rows(struct session *session, const struct call *call)
{
    const struct command *cost = command_find("cost");
    struct call asked = {.count = 1, .number = {call->number[1]}, .answer = call->answer};
    call->answer->columns = cost->columns;
    return cost->run(session, &asked);
}

static void cost_script(FILE *out, const struct session *session, const struct costed *answer,
                        const struct cost *cost, bool text)
{
    char title[64];
    const struct domq_train *train = &session->train;
    fprintf(out,
            "set title \"What a digit costs: error of %s at s = %.6g, r = %.6g, d = %.4g, q = %.6g\"\n"
            "set logscale xy\nset format xy '%s'\nset xlabel 'time of one answer [s]'\n"
            "set ylabel 'relative error'\nunset mytics\n"
            "set key left bottom\n", /* nothing is fast and accurate at once: that corner is free */
            answer->name, (double)train->s, (double)train->r, (double)train->d, (double)train->q,
            text ? "1e%T" : "10^{%T}");
    for (int k = 0; k < cost->rows; k++) {
        const struct cost_row *row = &cost->row[k];
        if (k == 0 || !same_series(row, row - 1))
            fprintf(out, "%s$series%d << END\n", k ? "END\n" : "", k);
        /* A logarithm has no 0: below a unit of its precision nothing is known. */
        if (row->status == DOM_OK)
            fprintf(out, "%.6g %.6g\n", row->seconds,
                    (double)quad_larger(row->error, (domq_real)domq_arithmetic(row->precision)->epsilon / 4));
    }
    fprintf(out, "END\n");
    for (int k = 0; k < cost->rows; k++)
        if (k == 0 || !same_series(&cost->row[k], &cost->row[k - 1]))
            fprintf(out, "%s$series%d using 1:2 with linespoints lt %d title \" %s\"", k ? ", " : "plot ", k,
                    series_style(&cost->row[k]), series_title(&cost->row[k], title));
    fprintf(out, "\n");
}

/* Error against time, a line for each method and precision. */
static bool plot_cost(struct session *session, const struct call *call)
{
    struct cost cost;
    struct picture picture;
    if (call->count < 2)
        return session_error(session,
                             "'plot cost' needs the NAME of an answer: fuel, launch, barrier, duration, "
                             "rmax or pair");
    if (!answer_for_people(call->answer))
        return cost_rows(session, call);
    if (!picture_begin(session, &picture))
        return false;
    const struct costed *answer = &cost_answers[(int)call->number[1]];
    bool good = cost_of(session, answer, &cost);
    if (good)
        cost_script(picture.script, session, answer, &cost, picture.text);
    return picture_end(session, &picture, good);
}

/* ---- The paper's figures ---- */

enum { SAMPLES = 193 };
#define S_LOW  ((domq_real)2 / 100)
#define S_STEP ((domq_real)5 / 1000)

/* One of the curves: r against s. */
struct limit_curve {
    const char *title;
    double q;
    bool pair;
    enum dom_fuel fuel;
};

static const struct limit_curve growth_curves[] = {
    {"hollow", 3, false, DOM_FUEL_EXACT},
    {"hollow, paper's fuel", 3, false, DOM_FUEL_PAPER},
    {"massive", 4, false, DOM_FUEL_EXACT},
    {"massive, paper's fuel", 4, false, DOM_FUEL_PAPER},
};
static const struct limit_curve marginal_curves[] = {
    {"hollow pair (paper)", 3, true, DOM_FUEL_EXACT},
    {"hollow train", 3, false, DOM_FUEL_EXACT},
    {"massive pair", 4, true, DOM_FUEL_EXACT},
    {"massive train", 4, false, DOM_FUEL_EXACT},
};
enum { LIMIT_CURVES = sizeof growth_curves / sizeof *growth_curves };

/* r of each curve at each s; NaN where not even r = 1 goes on. */
struct limit_table {
    domq_real s[SAMPLES], r[SAMPLES][LIMIT_CURVES];
};

static enum dom_status limit_point(struct domq_train train, const struct domq_compute *compute,
                                   const struct limit_curve *curve, domq_real s, domq_real *r)
{
    struct domq_limit limit;
    train.s = s;
    train.r = 1;
    train.q = (domq_real)curve->q;
    train.fuel = curve->fuel;
    *r = DOMQ_NAN;
    if (domq_dynamics(&train) && train.fuel == DOM_FUEL_PAPER) /* which knows none of them */
        return DOM_OK;
    enum dom_status status =
        curve->pair ? domq_limit_pair(&train, compute, &limit) : domq_limit_rmax(&train, compute, &limit);
    *r = status == DOM_OK && limit.ends != DOM_END_NONE ? limit.r_max : DOMQ_NAN;
    return status;
}

static bool limits_find(struct session *session, const struct limit_curve *curves, struct limit_table *table)
{
    struct progress progress = {0, 0};
    for (int k = 0; k < SAMPLES; k++) {
        enum dom_status status = DOM_OK;
        table->s[k] = S_LOW + (domq_real)k * S_STEP;
        for (int c = 0; c < LIMIT_CURVES && status == DOM_OK; c++)
            status = limit_point(session->train, &session->compute, &curves[c], table->s[k], &table->r[k][c]);
        progress_show(&progress, status == DOM_OK ? (k + 1.0) / SAMPLES : 1);
        if (status != DOM_OK)
            return session_status(session, status);
    }
    return true;
}

static bool limit_rows(const struct call *call, const struct limit_table *table)
{
    for (int k = 0; k < SAMPLES && !answer_lost(call->answer); k++)
        answer_cells(call->answer, cell_real(table->s[k]), cell_real(table->r[k][0]),
                     cell_real(table->r[k][1]), cell_real(table->r[k][2]), cell_real(table->r[k][3]),
                     cell_real(1 / table->s[k]));
    return true;
}

/* The height of the picture: all curves, and the point of the session if it is not far above them. */
static double limit_top(const struct session *session, const struct limit_table *table)
{
    domq_real top = 1, r = session->train.r;
    for (int k = 0; k < SAMPLES; k++)
        for (int c = 0; c < LIMIT_CURVES; c++)
            top = isfinite(table->r[k][c]) ? quad_larger(top, table->r[k][c]) : top;
    if (r > top && r < 2 * top)
        top = r;
    return top > 1 ? (double)(1 + (domq_real)1.15 * (top - 1)) : 2;
}

static void limit_script(FILE *out, const struct session *session, const struct limit_curve *curves,
                         const struct limit_table *table)
{
    const struct domq_train *t = &session->train;
    double top = limit_top(session, table);
    fprintf(out, "$limits << END\n");
    for (int k = 0; k < SAMPLES; k++) {
        fprintf(out, "%.6g", (double)table->s[k]);
        for (int c = 0; c < LIMIT_CURVES; c++)
            fprintf(out, " %.8g", (double)table->r[k][c]);
        fprintf(out, "\n");
    }
    fprintf(
        out,
        "END\nset xlabel 's, free gap to the next domino [h]; d = %.4g h'\nset ylabel 'largest growth r'\n"
        "set xrange [0:1]\nset yrange [1:%.6g]\n",
        (double)t->d, top);
    bool inside = (double)t->r <= top;
    fprintf(out, "$now << END\n%.8g %.8g\nEND\nplot ", (double)t->s, inside ? (double)t->r : top);
    /* Thick lines are ours; a line's points stand apart. */
    for (int c = 0; c < LIMIT_CURVES; c++)
        fprintf(out, "$limits using 1:%d with linespoints lt %d lw %s pi 24 title \" %s\", ", c + 2, c + 1,
                c % 2 ? "1.5" : "3", curves[c].title);
    fprintf(out,
            "$limits using 1:(1/$1) with lines lt 6 lw 1 dt 3 title ' reach, r = 1/s', "
            "$now with points pt 7 ps 1.6 lc rgb 'black' title ' now: s = %.4g, r = %.4g, q = %.4g%s'\n",
            (double)t->s, (double)t->r, (double)t->q, inside ? "" : " (above)");
}

static bool plot_limits(struct session *session, const struct call *call, const char *title,
                        const struct limit_curve *curves)
{
    static struct limit_table table;
    struct picture picture;
    if (!answer_for_people(call->answer))
        return limits_find(session, curves, &table) && limit_rows(call, &table);
    if (!picture_begin(session, &picture))
        return false;
    fprintf(picture.script, "set title \"%s\"\n", title);
    bool good = limits_find(session, curves, &table);
    if (good)
        limit_script(picture.script, session, curves, &table);
    return picture_end(session, &picture, good);
}

static bool plot_growth(struct session *session, const struct call *call)
{
    return plot_limits(session, call, "Largest growth: below its curve a train keeps falling", growth_curves);
}

static bool plot_marginal(struct session *session, const struct call *call)
{
    return plot_limits(session, call, "Pair: below its curve a domino that just tips over topples the next",
                       marginal_curves);
}

/* ---- The command ---- */

static const struct column plot_columns[] = {
    {"theta", "rad", "energy, omega, chain: tilt of the head", 0},
    {"dH", "mgh/2", "energy: potential energy of the train, H(theta) - H(0) (19; c1)", 0},
    {"kinetic", "mgh/2", "energy: J tau^2 omega^2, up to a stop (21; c3)", 0},
    {"J", "", "energy: inertia of the train (20; c2)", 0},
    {"omegasq", "", "omega: tau^2 omega(theta)^2 (21; c3)", 0},
    {"omega", "rad/s", "omega: angular velocity of the head", 0},
    {"i", "", "chain: number of the domino, 0 is the head", 5},
    {"theta_i", "rad", "chain: its tilt (27; A2)", 0},
    {"event", "", "energy, omega, chain: launch, top, fall, stop or hit", 6},
    {"s", "h", "growth, marginal: separation", 0},
    {"hollow", "", "growth: r_max of hollow dominoes, q = 3", 0},
    {"hollow_paper", "", "growth: the same with the paper's fuel", 0},
    {"massive", "", "growth: r_max of massive dominoes, q = 4", 0},
    {"massive_paper", "", "growth: the same with the paper's fuel", 0},
    {"hollow_pair", "", "marginal: r_max of the pair of hollow dominoes", 0},
    {"hollow_train", "", "marginal: that of their train", 0},
    {"massive_pair", "", "marginal: r_max of the pair of massive dominoes", 0},
    {"massive_train", "", "marginal: that of their train", 0},
    {"reach", "", "growth, marginal: 1/s", 0},
    {NULL, NULL, NULL, 0},
};

static const struct plot {
    const char *name;
    bool (*run)(struct session *session, const struct call *call);
    const char *keys; /* of its data */
} plots[] = {
    {"chain", plot_chain, "i theta theta_i event"},
    {"cost", plot_cost, ""},
    {"energy", plot_energy, "theta dH kinetic J event"},
    {"growth", plot_growth, "s hollow hollow_paper massive massive_paper reach"},
    {"marginal", plot_marginal, "s hollow_pair hollow_train massive_pair massive_train reach"},
    {"omega", plot_omega, "theta omegasq omega event"},
    {NULL, NULL, NULL},
};

static const char *plot_names(const void *context, int k)
{
    (void)context;
    return plots[k].name;
}

/* Returns true if the picture takes the name of an answer, as that of costs does. */
static bool name_follows(domq_real plot)
{
    return plots[(int)plot].run == plot_cost;
}

/* The columns of one picture, in the order of its keys. */
static void columns_choose(const char *keys, struct column *chosen)
{
    int n = 0;
    for (const char *key = keys; *key && n + 1 < ANSWER_COLUMNS; key += strspn(key, " ")) {
        size_t length = strcspn(key, " ");
        for (const struct column *c = plot_columns; c->key; c++)
            if (strlen(c->key) == length && strncmp(c->key, key, length) == 0)
                chosen[n++] = *c;
        key += length;
    }
    chosen[n] = (struct column){NULL, NULL, NULL, 0};
}

static bool run_plot(struct session *session, const struct call *call)
{
    const struct plot *plot = &plots[(int)call->number[0]];
    if (call->count > 1 && !name_follows(call->number[0])) {
        session->column = call->column[1];
        return session_error(session, "'plot %s' takes no name behind it", plot->name);
    }
    columns_choose(plot->keys, call->answer->own);
    call->answer->columns = call->answer->own;
    call->answer->style.errors = 0; /* a picture needs no bounds */
    return plot->run(session, call);
}

const struct command plot_commands[] = {
    {.name = "plot",
     .synonyms = "picture image graph figure chart diagram svg png pdf",
     .argument = {{.name = "WHAT", .kind = ARGUMENT_CHOICE, .of = "picture", .choices = plot_names},
                  {.name = "NAME",
                   .kind = ARGUMENT_CHOICE,
                   .of = "command with a tolerance",
                   .optional = true,
                   .choices = cost_names,
                   .follows = name_follows}},
     .summary = "a picture, in the terminal or in the file behind '>'",
     .help = "'plot growth > growth.svg' draws the largest growth against s, 'plot marginal' that of two "
             "dominoes; 'plot energy', 'plot omega' and 'plot chain' a cycle with its events; 'plot cost "
             "rmax' error against time. The ending of the file says as what: .svg, .png, .pdf, .txt. "
             "Pictures need gnuplot; in csv and json the data comes instead, of each picture its own "
             "columns, and those of 'cost'.",
     .equation = "(19; c1) (20; c2) (21; c3) (27; A2), figures 'growth' and 'marginal'",
     .see = "curve pair energy omega chain cost draw",
     .unswept = "it draws",
     .draws = true,
     .rows = true,
     .files = true,
     ANSWER(plot)},
    {.name = NULL},
};
