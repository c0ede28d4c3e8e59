/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plots 'energy', 'omega' and 'chain': one cycle of a train, plotted against the tilt of its
 * head. */
#include "io/terminal.h"
#include "language/quad.h"
#include "language/text.h"
#include "pictures/plots/plots.h"
#include "train/train.h"

bool train_comes_to(const struct query *query, struct problem *problem, domq_real theta)
{
    domq_real omegasq;
    struct domq_barrier b = {.stop = DOMQ_NAN};
    enum dom_status status = any_cycle_omegasq(&query->scene->train, &query->scene->compute, theta, &omegasq);
    if (status == DOM_NO_FUEL)
        return problem_error(problem, "%s", verdict_reason(status));
    if (status == DOM_STOPS)
        status = any_barrier_find(&query->scene->train, &query->scene->compute, &b);
    if (status != DOM_OK && status != DOM_STOPS)
        return query_status(query, problem, status);
    /* A tilt copied from a table has 6 digits, so it may be slightly too large. A picture does not show the
     * difference. */
    if (b.stop < theta * (1 - (domq_real)1e-5))
        return problem_error(problem,
                             "the train does not reach T = %s: it stops at %s, before the top of the barrier",
                             angle_text(query, theta, 10).text, angle_text(query, b.stop, 10).text);
    return true;
}

/* Finds the events of a cycle, for a picture. *stops tells whether the train stops. Fails if there is no
 * cycle to show. */
static bool cycle_events(const struct query *query, const struct any_compute *compute,
                         struct domq_event event[DOM_EVENTS_MAX], int *count, bool *stops,
                         struct problem *problem)
{
    enum dom_status status = any_cycle_events(&query->scene->train, compute, event, count);
    *stops = status == DOM_STOPS;
    if (status == DOM_NO_FUEL)
        return train_comes_to(query, problem, 0);
    if (status == DOM_NO_MARGIN)
        return problem_error(problem, "the margin is 0 within rounding errors, so the cycle would "
                                      "never end; use a slightly smaller r");
    return status == DOM_OK || *stops || problem_status(problem, query->scene, status);
}

enum { STEPS = 160 };

/* If the train stops, the barrier lies beyond the tilt at which it stops. To show the barrier, the chart
 * extends to this multiple of that tilt, but not beyond theta_c. */
#define BEYOND_STOP 4

/* The lines of distant dominoes would lie too close to the line for theta_f. A line is drawn for domino i
 * only if theta_f - theta_i > LINES_APART theta_f at the launch. */
#define LINES_APART ((domq_real)2 / 100)

struct cycle {
    const struct query *query;
    enum { ENERGY, OMEGA, CHAIN } plot;
    struct domq_event event[DOM_EVENTS_MAX];
    int events;
    struct domq_angles angles;
    domq_real end; /* the largest tilt of the head in the chart */
};

/* The tilts of the head and its first followers at one moment. */
struct tilts {
    domq_real theta[PLOT_CURVES];
    int count;
};

static double angle_shown(const struct cycle *c, domq_real theta)
{
    return (double)style_angle(&c->query->state->settings.style, theta);
}

static bool cycle_find(struct cycle *c, struct problem *problem)
{
    const struct scene *scene = c->query->scene;
    bool stops;
    enum dom_status status = any_angles_find(&scene->train, &scene->compute, &c->angles);
    if (status != DOM_OK)
        return problem_status(problem, scene, status);
    if (!cycle_events(c->query, &scene->compute, c->event, &c->events, &stops, problem))
        return false;
    c->end = c->angles.theta_c;
    if (stops)
        c->end = quad_smaller(c->end, BEYOND_STOP * c->event[c->events - 1].theta);
    return true;
}

static bool tilts_link(const struct domq_link *link, void *context)
{
    struct tilts *t = context;
    t->theta[t->count++] = link->theta;
    return t->count < PLOT_CURVES;
}

/* Finds the tilts of the first dominoes. A detached or negligibly light domino has the tilt theta_f. */
static enum dom_status tilts_find(const struct cycle *c, domq_real theta, struct tilts *t)
{
    const struct scene *scene = c->query->scene;
    t->count = 0;
    enum dom_status status = any_chain_walk(&scene->train, &scene->compute, theta, tilts_link, t);
    while (t->count < PLOT_CURVES)
        t->theta[t->count++] = c->angles.theta_f;
    return status;
}

/* Counts the lines to draw: see LINES_APART. */
static enum dom_status lines_count(const struct cycle *c, int *lines)
{
    struct tilts start;
    domq_real theta_f = c->angles.theta_f;
    enum dom_status status = tilts_find(c, 0, &start);
    *lines = 1;
    while (*lines < PLOT_CURVES && theta_f - start.theta[*lines] > LINES_APART * theta_f)
        ++*lines;
    return status;
}

/* Writes the rows of a plot at one tilt of the head: one, or one for each line of the chart of the chain.
 * `event` is the event at this tilt, or NULL. */
static enum dom_status sample_write(const struct cycle *c, const struct domq_event *event, domq_real theta,
                                    int lines, struct answer *a)
{
    const struct scene *scene = c->query->scene;
    const struct cell word = cell_word(event ? dom_event_text(event->kind) : NULL);
    struct tilts tilts = {.theta = {0}};
    struct domq_energy energy = {.dH = DOMQ_NAN};
    domq_real omegasq = DOMQ_NAN;
    enum dom_status status = any_energy_find(&scene->train, &scene->compute, theta, &energy);
    if (status == DOM_OK && c->plot == CHAIN)
        status = tilts_find(c, theta, &tilts);
    else if (event && event->kind == DOM_EVENT_STOP)
        omegasq = 0;
    else if (status == DOM_OK && theta <= c->event[c->events - 1].theta)
        status = any_cycle_omegasq(&scene->train, &scene->compute, theta, &omegasq);
    if (status != DOM_OK && status != DOM_STOPS)
        return status;
    if (c->plot == ENERGY)
        answer_cells(a, cell_real(theta), cell_real(energy.dH), cell_real(energy.J * omegasq),
                     cell_real(energy.J), word);
    else if (c->plot == OMEGA)
        answer_cells(a, cell_real(theta), cell_real(omegasq),
                     cell_real(quad(sqrt)(omegasq) / domq_scale_tau(&scene->scale, &scene->train)), word);
    for (int i = 0; i < lines && c->plot == CHAIN; i++)
        answer_cells(a, cell_count(i), cell_real(theta), cell_real(tilts.theta[i]), word);
    return DOM_OK;
}

/* Writes the rows of a plot, at evenly spaced tilts of the head and at the events between them. Adds the
 * parameters and the events to the chart, if there is one. */
static bool cycle_plot(struct cycle *c, struct answer *a, struct chart *chart, struct problem *problem)
{
    const struct domq_train *t = &c->query->scene->train;
    int lines = 1, event = 0;
    if (!cycle_find(c, problem))
        return false;
    enum dom_status status = c->plot == CHAIN ? lines_count(c, &lines) : DOM_OK;
    for (int k = 0; k <= STEPS && status == DOM_OK && !answer_lost(a);) {
        domq_real theta = k == STEPS ? c->end : c->end * k / STEPS;
        const struct domq_event *at =
            event < c->events && c->event[event].theta <= theta ? &c->event[event++] : NULL;
        k += !at || at->theta == theta;
        status = sample_write(c, at, at ? at->theta : theta, lines, a);
        progress_show((k + 1.0) / (STEPS + 2));
    }
    if (status != DOM_OK)
        return problem_status(problem, c->query->scene, status);
    if (!chart)
        return true;
    text_add(chart->title, sizeof chart->title, ": s = %.4g, r = %.4g, d = %.4g, q = %.4g", (double)t->s,
             (double)t->r, (double)t->d, (double)t->q);
    chart->x.low = 0;
    chart->x.high = angle_shown(c, c->end);
    for (int k = 0; k < c->events; k++)
        chart_event(chart, angle_shown(c, c->event[k].theta), dom_event_text(c->event[k].kind));
    return true;
}

static bool plot_energy(const struct query *query, struct answer *a, struct chart *chart,
                        struct problem *problem)
{
    struct cycle c = {.query = query, .plot = ENERGY};
    if (chart)
        chart_level(chart, 0, "");
    return cycle_plot(&c, a, chart, problem);
}

static bool plot_omega(const struct query *query, struct answer *a, struct chart *chart,
                       struct problem *problem)
{
    struct cycle c = {.query = query, .plot = OMEGA};
    if (chart) {
        chart->y.low = 0;
        snprintf(chart->curve[0].title, sizeof chart->curve[0].title,
                 "the head, %.4g mm tall; the next head is sqrt(r) times slower",
                 (double)(1000 * query->scene->scale.h));
    }
    return cycle_plot(&c, a, chart, problem);
}

static bool plot_chain(const struct query *query, struct answer *a, struct chart *chart,
                       struct problem *problem)
{
    struct cycle c = {.query = query, .plot = CHAIN};
    bool done = cycle_plot(&c, a, chart, problem);
    if (done && chart) {
        double theta_f = angle_shown(&c, c.angles.theta_f);
        chart->y.low = 0;
        chart->y.high = 1.04 * theta_f;
        chart_level(chart, theta_f, "the last");
    }
    return done;
}

#define THETA COLUMN("theta", "rad", "tilt of the head", 0)
#define EVENT COLUMN("event", "", "the event at this tilt (launch, top, fall, stop or hit), if any", 6)
static const struct column energy_columns[] = {
    THETA,
    {"dH", "mgh/2", "potential energy of the train, H(theta) - H(0) (19; c1)", 0},
    {"kinetic", "mgh/2", "J tau^2 omega^2 (21; c3)", 0},
    {"J", "", "inertia of the train (20; c2)", 0},
    EVENT,
    {NULL, NULL, NULL, 0},
};
static const struct column omega_columns[] = {
    THETA,
    {"omegasq", "", "tau^2 omega(theta)^2 (21; c3)", 0},
    {"omega", "rad/s", "angular velocity of the head", 0},
    EVENT,
    {NULL, NULL, NULL, 0},
};
static const struct column chain_columns[] = {
    {"i", "", "number of the domino, where 0 is the head", 5},
    THETA,
    {"theta_i", "rad", "tilt of the domino (27; A2)", 0},
    EVENT,
    {NULL, NULL, NULL, 0},
};

const struct plot cycle_plots[] = {
    {"energy", plot_energy, "the energies of one cycle of the train", energy_columns,
     .title = "Energy over a cycle", .x = {"theta", "tilt of the head"},
     .y = {NULL, "energy, in units of m g h/2 of the head"},
     .curve = {{"dH", "rise in potential energy since the launch", CHART_LINE, INK_BLUE, 0},
               {"kinetic", "kinetic energy", CHART_LINE, INK_RED, 1}}},
    {"omega", plot_omega, "the angular velocity of the head over one cycle", omega_columns,
     .title = "Angular velocity over a cycle", .x = {"theta", "tilt of the head"},
     .y = {"omega", "angular velocity"}, .curve = {{"omega", "", CHART_LINE, INK_BLUE, 0}}},
    {"chain", plot_chain, "the tilts of the first dominoes over one cycle", chain_columns,
     .title = "Tilts over a cycle", .x = {"theta", "tilt of the head"}, .y = {"theta_i", "tilt of domino i"},
     .curve = {{"theta_i", "i = 0, the head", CHART_LINE, INK_BLUE, 0, 1},
               {"theta_i", "i = 1", CHART_LINE, INK_RED, 1, 2},
               {"theta_i", "i = 2", CHART_LINE, INK_GREEN, 2, 3},
               {"theta_i", "i = 3", CHART_LINE, INK_PURPLE, 3, 4},
               {"theta_i", "i = 4", CHART_LINE, INK_ORANGE, 4, 5}}},
    {.name = NULL},
};
