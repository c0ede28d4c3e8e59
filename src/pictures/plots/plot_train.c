/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plots of the endless train: 'growth', the largest growth of trains and of pairs against the separation;
 * 'energy' and 'omega', one cycle against the tilt of its head. */
#include "language/quad.h"
#include "language/text.h"
#include "parallel/progress.h"
#include "pictures/plots/plots.h"
#include "train/train.h"

/* ---- One cycle ---- */

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

enum { STEPS = 160 };

/* If the train stops, the barrier lies beyond the tilt at which it stops. To show the barrier, the chart
 * extends to this multiple of that tilt, but not beyond theta_c. */
#define BEYOND_STOP 4

/* A cycle: its events, and the largest tilt of the head in the chart. */
struct cycle {
    struct domq_event event[DOM_EVENTS_MAX];
    int events;
    domq_real end;
};

static bool cycle_find(const struct query *query, struct cycle *c, struct problem *problem)
{
    const struct scene *scene = query->scene;
    struct domq_angles angles;
    enum dom_status status = any_angles_find(&scene->train, &scene->compute, &angles);
    if (status == DOM_OK)
        status = any_cycle_events(&scene->train, &scene->compute, c->event, &c->events);
    if (status == DOM_NO_FUEL)
        return train_comes_to(query, problem, 0);
    if (status == DOM_NO_MARGIN)
        return problem_error(problem, "the margin is 0 within rounding errors, so the cycle would "
                                      "never end; use a slightly smaller r");
    if (status != DOM_OK && status != DOM_STOPS)
        return problem_status(problem, scene, status);
    c->end = angles.theta_c;
    if (status == DOM_STOPS)
        c->end = quad_smaller(c->end, BEYOND_STOP * c->event[c->events - 1].theta);
    return true;
}

/* Writes a row at a tilt of the head. `event` is the event at this tilt, or NULL. */
static enum dom_status sample_write(const struct query *query, const struct cycle *c,
                                    const struct domq_event *event, domq_real theta, struct answer *a)
{
    const struct scene *scene = query->scene;
    struct domq_energy energy;
    domq_real omegasq = DOMQ_NAN;
    enum dom_status status = any_energy_find(&scene->train, &scene->compute, theta, &energy);
    if (event && event->kind == DOM_EVENT_STOP)
        omegasq = 0;
    else if (status == DOM_OK && theta <= c->event[c->events - 1].theta)
        status = any_cycle_omegasq(&scene->train, &scene->compute, theta, &omegasq);
    if (status != DOM_OK && status != DOM_STOPS)
        return status;
    answer_cells(a, cell_real(theta), cell_real(energy.dH), cell_real(energy.J * omegasq),
                 cell_real(energy.J), cell_real(omegasq),
                 cell_real(quad(sqrt)(omegasq) / domq_scale_tau(&scene->scale, &scene->train)),
                 cell_word(event ? dom_event_text(event->kind) : NULL));
    return DOM_OK;
}

/* Writes the rows of a plot, at evenly spaced tilts of the head and at the events between them. Adds the
 * parameters and the events to the chart, if there is one. */
static bool cycle_plot(const struct query *query, struct answer *a, struct chart *chart,
                       struct problem *problem)
{
    const struct domq_train *t = &query->scene->train;
    const struct answer_style *style = &query->state->settings.style;
    struct cycle c;
    int event = 0;
    if (!cycle_find(query, &c, problem))
        return false;
    for (int k = 0; k <= STEPS && !answer_lost(a);) {
        const domq_real theta = k == STEPS ? c.end : c.end * k / STEPS;
        const struct domq_event *at =
            event < c.events && c.event[event].theta <= theta ? &c.event[event++] : NULL;
        k += !at || at->theta == theta;
        const enum dom_status status = sample_write(query, &c, at, at ? at->theta : theta, a);
        if (status != DOM_OK)
            return problem_status(problem, query->scene, status);
        progress_show((k + 1.0) / (STEPS + 2));
    }
    if (!chart)
        return true;
    text_add(chart->title, sizeof chart->title, ": s = %.4g, r = %.4g, d = %.4g, q = %.4g", (double)t->s,
             (double)t->r, (double)t->d, (double)t->q);
    chart->x.low = 0;
    chart->x.high = (double)style_angle(style, c.end);
    for (int k = 0; k < c.events; k++)
        chart_event(chart, (double)style_angle(style, c.event[k].theta), dom_event_text(c.event[k].kind));
    return true;
}

static bool plot_energy(const struct query *query, struct answer *a, struct chart *chart,
                        struct problem *problem)
{
    if (chart) { /* a line at 0 */
        struct chart_curve *zero = chart_curve(chart, CHART_LINE, INK_GREY, 2, "%s", "");
        chart_point(chart, zero, -HUGE_VAL, 0);
        chart_point(chart, zero, HUGE_VAL, 0);
    }
    return cycle_plot(query, a, chart, problem);
}

static bool plot_omega(const struct query *query, struct answer *a, struct chart *chart,
                       struct problem *problem)
{
    if (chart) {
        chart->y.low = 0;
        snprintf(chart->curve[0].title, sizeof chart->curve[0].title,
                 "the head, %.4g mm tall; the next head is sqrt(r) times slower",
                 (double)(1000 * query->scene->scale.h));
    }
    return cycle_plot(query, a, chart, problem);
}

/* ---- Limits ---- */

enum { SAMPLES = 193, LIMITS = 4 };
#define S_LOW  ((domq_real)2 / 100)
#define S_STEP ((domq_real)5 / 1000)

/* Finds the largest growth at the separation s: of a train or, if `is_pair`, of two dominoes. Stores NaN if
 * no growth is possible. */
static enum dom_status limit_find(const struct query *query, domq_real q, bool is_pair, domq_real s,
                                  domq_real *r)
{
    struct domq_train train = query->scene->train;
    const struct any_compute *compute = &query->scene->compute;
    struct domq_limit limit;
    train.s = s;
    train.r = 1;
    train.q = q;
    *r = DOMQ_NAN;
    enum dom_status status =
        is_pair ? any_limit_pair(&train, compute, &limit) : any_limit_rmax(&train, compute, &limit);
    if (status == DOM_OK && limit.ends != DOM_END_NONE)
        *r = limit.r_max;
    return status == DOM_OPEN ? DOM_OK : status; /* the curve has a gap where a limit is open */
}

static domq_real reach_at(struct domq_train train, domq_real s)
{
    train.s = s;
    return domq_train_reach(&train);
}

/* Sets the axes and marks the growth of the session. The y axis includes this growth, unless it is far above
 * all curves. */
static void limits_chart(const struct domq_train *t, double top, struct chart *chart)
{
    double r = (double)t->r;
    top = r > top && r < 2 * top ? r : top;
    top = top > 1 ? 1 + 1.15 * (top - 1) : 2;
    snprintf(chart->x.label, sizeof chart->x.label, "gap over height, s (thickness over height is d = %.4g)",
             (double)t->d);
    chart->x.low = 0;
    chart->x.high = chart->y.low = 1;
    chart->y.high = top;
    struct chart_curve *reach = &chart->curve[chart->curves - 1];
    snprintf(reach->title, sizeof reach->title, "reach: r = %.4g/s", (double)reach_at(*t, 1));
    struct chart_curve *now = chart_curve(chart, CHART_POINTS, INK_TEXT, 0, "now: s = %.4g, r = %.4g%s",
                                          (double)t->s, r, r <= top ? "" : " (above)");
    chart_point(chart, now, (double)t->s, fmin(r, top));
}

static bool plot_growth(const struct query *query, struct answer *a, struct chart *chart,
                        struct problem *problem)
{
    const struct domq_train *train = &query->scene->train;
    domq_real top = 1;
    for (int k = 0; k < SAMPLES && !answer_lost(a); k++) {
        domq_real s = S_LOW + (domq_real)k * S_STEP, r;
        struct cell row[LIMITS + 2] = {cell_real(s)};
        for (int i = 0; i < LIMITS; i++) {
            enum dom_status status = limit_find(query, i % 2 ? 3 : 4, i >= LIMITS / 2, s, &r);
            if (status != DOM_OK)
                return problem_status(problem, query->scene, status);
            top = isfinite(r) ? quad_larger(top, r) : top;
            row[i + 1] = cell_real(r);
        }
        row[LIMITS + 1] = cell_real(reach_at(*train, s));
        answer_row(a, row, NULL);
        progress_show((k + 1.0) / SAMPLES);
    }
    if (chart)
        limits_chart(train, (double)top, chart);
    return true;
}

/* ---- The plots ---- */

static const struct column growth_columns[] = {
    {"s", "h", "separation", 0},
    {"solid", "", "r_max of trains of solid dominoes, q = 4", 0},
    {"hollow", "", "r_max of trains of hollow dominoes, q = 3", 0},
    {"solid_pair", "", "r_max of two solid dominoes", 0},
    {"hollow_pair", "", "r_max of two hollow dominoes", 0},
    {"reach", "", "largest growth at which a domino reaches the next one (1/s, or less with rounded edges)",
     0},
    {NULL, NULL, NULL, 0},
};
static const struct column cycle_columns[] = {
    {"theta", "rad", "tilt of the head", 0},
    {"dH", "mgh/2", "potential energy of the train, H(theta) - H(0) (19; c1)", 0},
    {"kinetic", "mgh/2", "J tau^2 omega^2 (21; c3)", 0},
    {"J", "", "inertia of the train (20; c2)", 0},
    {"omegasq", "", "tau^2 omega(theta)^2 (21; c3)", 0},
    {"omega", "rad/s", "angular velocity of the head", 0},
    {"event", "", "the event at this tilt (launch, top, fall, stop or hit), if any", 6},
    {NULL, NULL, NULL, 0},
};

const struct plot train_plots[] = {
    {"growth", plot_growth, "the largest growth of trains, and of two dominoes", growth_columns,
     .title = "A train below its curve keeps falling", .x = {"s", ""}, .y = {NULL, "growth r"},
     .curve = {{"solid", "solid train", CHART_LINE, INK_BLUE, 0},
               {"hollow", "hollow train", CHART_LINE, INK_RED, 1},
               {"solid_pair", "solid pair", CHART_LINE, INK_SKY, 3},
               {"hollow_pair", "hollow pair", CHART_LINE, INK_ORANGE, 4},
               {"reach", "", CHART_LINE, INK_GREY, 2}}},
    {"energy", plot_energy, "the energies of one cycle of the train", cycle_columns,
     .title = "Energy over a cycle", .x = {"theta", "tilt of the head"},
     .y = {NULL, "energy, in units of m g h/2 of the head"},
     .curve = {{"dH", "rise in potential energy since the launch", CHART_LINE, INK_BLUE, 0},
               {"kinetic", "kinetic energy", CHART_LINE, INK_RED, 1}}},
    {"omega", plot_omega, "the angular velocity of the head over one cycle", cycle_columns,
     .title = "Angular velocity over a cycle", .x = {"theta", "tilt of the head"},
     .y = {"omega", "angular velocity"}, .curve = {{"omega", "", CHART_LINE, INK_BLUE, 0}}},
    {.name = NULL},
};
