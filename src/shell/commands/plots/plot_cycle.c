/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot energy, omega, inertia, chain: one cycle with its events. */
#include "commands/plots/plots.h"
#include "commands/walk.h"
#include "io/terminal.h"
#include "language/quad.h"

enum { STEPS = 160, SAMPLES = STEPS + 1 + DOM_EVENTS_MAX };

#define BEYOND_STOP 4

/* The cycle at one tilt. */
struct sample {
    domq_real theta, dH, J, omegasq; /* omegasq: NaN where the train does not come */
    const char *event;               /* that happens here, or NULL */
    bool rests;                      /* that event is the stop */
};

struct cycle_samples {
    struct sample at[SAMPLES];
    int count;
    struct domq_event events[DOM_EVENTS_MAX];
    int event_count;
    struct domq_angles angles;
    domq_real end; /* of the picture */
    int lines;     /* in the picture of a chain; 0: not counted yet */
};

/* ---- The data ---- */

static bool events_find(const struct query *query, struct problem *problem, struct cycle_samples *c)
{
    enum dom_status status = domq_angles_find(&query->scene->train, &query->scene->compute, &c->angles);
    if (status == DOM_OK)
        status = domq_cycle_events(&query->scene->train, &query->scene->compute, c->events, &c->event_count);
    if (status == DOM_NO_FUEL)
        return train_comes_to(query, problem, 0);
    if (status == DOM_NO_MARGIN)
        return problem_error(
            problem, "the margin is 0 to rounding: the cycle comes to no end; a slightly smaller r has one");
    c->end = c->angles.theta_c;
    /* Of a train that stops, the barrier is what there is to see. */
    if (status == DOM_STOPS)
        c->end = quad_smaller(c->end, BEYOND_STOP * c->events[c->event_count - 1].theta);
    return status == DOM_OK || status == DOM_STOPS || problem_status(problem, query->scene, status);
}

/* Tilts equally far apart, and those of the events among them. */
static void tilts_make(struct cycle_samples *c)
{
    int event = 0;
    c->count = c->lines = 0;
    for (int k = 0; k <= STEPS; k++) {
        domq_real theta = k == STEPS ? c->end : c->end * k / STEPS;
        bool taken = false;
        for (; event < c->event_count && c->events[event].theta <= theta; event++) {
            taken = c->events[event].theta == theta;
            c->at[c->count++] = (struct sample){.theta = c->events[event].theta,
                                                .event = dom_event_text(c->events[event].kind),
                                                .rests = c->events[event].kind == DOM_EVENT_STOP};
        }
        if (!taken)
            c->at[c->count++] = (struct sample){.theta = theta};
    }
}

static enum dom_status sample_find(const struct query *query, bool beyond, struct sample *k)
{
    struct domq_energy energy;
    struct domq_value omegasq = {.value = DOMQ_NAN};
    enum dom_status status =
        domq_energy_find(&query->scene->train, &query->scene->compute, k->theta, &energy);
    if (status != DOM_OK)
        return status;
    k->dH = energy.dH;
    k->J = energy.J;
    if (k->rests)
        omegasq.value = 0;
    else if (!beyond)
        status = domq_cycle_omegasq(&query->scene->train, &query->scene->compute, k->theta, &omegasq);
    k->omegasq = omegasq.value;
    return status == DOM_STOPS ? DOM_OK : status;
}

static bool samples_find(const struct query *query, struct problem *problem, struct cycle_samples *c)
{
    struct progress progress = {0, 0};
    if (!events_find(query, problem, c))
        return false;
    tilts_make(c);
    domq_real end = c->events[c->event_count - 1].theta;
    for (int k = 0; k < c->count; k++) {
        enum dom_status status = sample_find(query, c->at[k].theta > end, &c->at[k]);
        progress_show(&progress, status == DOM_OK ? (k + 1.0) / c->count : 1);
        if (status != DOM_OK)
            return problem_status(problem, query->scene, status);
    }
    return true;
}

/* ---- What these pictures have in common ---- */

/* Begins a chart over the tilt of the head, with a line and a name for each event. */
static struct chart cycle_chart(const struct query *query, const struct cycle_samples *c, const char *what)
{
    struct chart chart = chart_make();
    const struct domq_train *t = &query->scene->train;
    snprintf(chart.title, sizeof chart.title, "%s over a cycle: s = %.4g, r = %.4g, d = %.4g, q = %.4g", what,
             (double)t->s, (double)t->r, (double)t->d, (double)t->q);
    snprintf(chart.x.label, sizeof chart.x.label, "tilt of the head in %s",
             style_angle_unit(&query->state->settings.style));
    chart.x.low = 0;
    chart.x.high = plot_angle(query, c->end);
    for (int k = 0; k < c->event_count; k++)
        chart_event(&chart, plot_angle(query, c->events[k].theta), dom_event_text(c->events[k].kind));
    return chart;
}

/* Draws a picture of the samples of a cycle; for programs, writes the rows of each. */
static bool plot_samples(const struct query *query, struct answer *a, struct problem *problem,
                         bool (*rows)(const struct query *, struct answer *, struct problem *,
                                      struct cycle_samples *, const struct sample *),
                         bool (*draw)(const struct query *, struct answer *, struct problem *,
                                      struct cycle_samples *))
{
    static struct cycle_samples c;
    bool people = answer_for_people(a);
    if (people && !picture_ready(a, problem))
        return false;
    bool good = samples_find(query, problem, &c);
    for (int k = 0; k < c.count && good && !people; k++)
        good = rows(query, a, problem, &c, &c.at[k]);
    return good && (!people || draw(query, a, problem, &c));
}

/* ---- Energy ---- */

static bool energy_draw(const struct query *query, struct answer *a, struct problem *problem,
                        struct cycle_samples *c)
{
    struct chart chart = cycle_chart(query, c, "Energy");
    snprintf(chart.y.label, sizeof chart.y.label, "energy in m g h/2 of the head");
    struct chart_curve *dH =
        chart_curve(&chart, CHART_LINE, INK_BLUE, 0, "potential energy, from the launch on");
    for (int k = 0; k < c->count; k++)
        chart_point(&chart, dH, plot_angle(query, c->at[k].theta), (double)c->at[k].dH);
    struct chart_curve *kinetic = chart_curve(&chart, CHART_LINE, INK_RED, 1, "kinetic energy");
    for (int k = 0; k < c->count; k++)
        chart_point(&chart, kinetic, plot_angle(query, c->at[k].theta),
                    (double)(c->at[k].J * c->at[k].omegasq));
    struct chart_curve *zero = chart_curve(&chart, CHART_LINE, INK_GREY, 2, "%s", "");
    chart_point(&chart, zero, 0, 0);
    chart_point(&chart, zero, chart.x.high, 0);
    return chart_show(&chart, a, query->scene->compute.interrupt, problem);
}

static bool energy_row(const struct query *query, struct answer *a, struct problem *problem,
                       struct cycle_samples *c, const struct sample *at)
{
    (void)query, (void)problem, (void)c;
    return answer_cells(a, cell_real(at->theta), cell_real(at->dH), cell_real(at->J * at->omegasq),
                        cell_real(at->J), cell_word(at->event));
}

bool plot_energy(const struct query *query, struct answer *a, struct problem *problem)
{
    return plot_samples(query, a, problem, energy_row, energy_draw);
}

/* ---- Inertia ---- */

static bool inertia_draw(const struct query *query, struct answer *a, struct problem *problem,
                         struct cycle_samples *c)
{
    struct chart chart = cycle_chart(query, c, "Inertia");
    snprintf(chart.y.label, sizeof chart.y.label, "inertia J of all that move, 1 for the head alone");
    struct chart_curve *J = chart_curve(&chart, CHART_LINE, INK_BLUE, 0, "J (20; c2)");
    for (int k = 0; k < c->count; k++)
        chart_point(&chart, J, plot_angle(query, c->at[k].theta), (double)c->at[k].J);
    return chart_show(&chart, a, query->scene->compute.interrupt, problem);
}

static bool inertia_row(const struct query *query, struct answer *a, struct problem *problem,
                        struct cycle_samples *c, const struct sample *at)
{
    (void)query, (void)problem, (void)c;
    return answer_cells(a, cell_real(at->theta), cell_real(at->J), cell_word(at->event));
}

bool plot_inertia(const struct query *query, struct answer *a, struct problem *problem)
{
    return plot_samples(query, a, problem, inertia_row, inertia_draw);
}

/* ---- Angular velocity ---- */

static bool omega_draw(const struct query *query, struct answer *a, struct problem *problem,
                       struct cycle_samples *c)
{
    struct chart chart = cycle_chart(query, c, "Angular velocity");
    domq_real tau = domq_scale_tau(&query->scene->scale, &query->scene->train);
    snprintf(chart.y.label, sizeof chart.y.label, "angular velocity in %s/s",
             style_angle_unit(&query->state->settings.style));
    chart.y.low = 0;
    struct chart_curve *omega = chart_curve(&chart, CHART_LINE, INK_BLUE, 0,
                                            "the head, %.4g mm tall; the next is sqrt(r) times slower",
                                            (double)(1000 * query->scene->scale.h));
    for (int k = 0; k < c->count; k++)
        chart_point(&chart, omega, plot_angle(query, c->at[k].theta),
                    plot_angle(query, quad(sqrt)(c->at[k].omegasq) / tau));
    return chart_show(&chart, a, query->scene->compute.interrupt, problem);
}

static bool omega_row(const struct query *query, struct answer *a, struct problem *problem,
                      struct cycle_samples *c, const struct sample *at)
{
    (void)problem, (void)c;
    domq_real tau = domq_scale_tau(&query->scene->scale, &query->scene->train);
    return answer_cells(a, cell_real(at->theta), cell_real(at->omegasq),
                        cell_real(quad(sqrt)(at->omegasq) / tau), cell_word(at->event));
}

bool plot_omega(const struct query *query, struct answer *a, struct problem *problem)
{
    return plot_samples(query, a, problem, omega_row, omega_draw);
}

/* ---- Angles ---- */

enum { LINES = 5 };
#define LINES_APART ((domq_real)2 / 100) /* of theta_f: lines closer to theta_f are not distinguished */

/* The tilts of the first dominoes at one tilt of the head. */
struct angles {
    domq_real theta[LINES];
    int count;
};

static bool angles_link(const struct domq_link *link, void *context)
{
    struct angles *a = context;
    a->theta[a->count++] = link->theta;
    return a->count < LINES;
}

/* Finds the angles of the dominoes. One that is too light to matter, or has detached, has theta_f. */
static enum dom_status angles_find(const struct query *query, domq_real theta, domq_real theta_f,
                                   struct angles *a)
{
    a->count = 0;
    enum dom_status status =
        domq_chain_walk(&query->scene->train, &query->scene->compute, theta, angles_link, a);
    while (a->count < LINES)
        a->theta[a->count++] = theta_f;
    return status;
}

/* Counts the lines: as many as begin apart from theta_f. */
static enum dom_status lines_count(const struct query *query, struct cycle_samples *c)
{
    struct angles a;
    domq_real theta_f = c->angles.theta_f;
    enum dom_status status = angles_find(query, 0, theta_f, &a);
    c->lines = 1;
    while (c->lines < LINES && theta_f - a.theta[c->lines] > LINES_APART * theta_f)
        c->lines++;
    return status;
}

/* Finds the tilts of the lines at a sample. */
static bool lines_at(const struct query *query, struct answer *a, struct problem *problem,
                     struct cycle_samples *c, domq_real theta, struct angles *angles)
{
    (void)a;
    enum dom_status status = c->lines ? DOM_OK : lines_count(query, c);
    if (status == DOM_OK)
        status = angles_find(query, theta, c->angles.theta_f, angles);
    return status == DOM_OK || problem_status(problem, query->scene, status);
}

static bool chain_rows(const struct query *query, struct answer *a, struct problem *problem,
                       struct cycle_samples *c, const struct sample *at)
{
    struct angles angles = {.count = 0};
    if (!lines_at(query, a, problem, c, at->theta, &angles))
        return false;
    for (int i = 0; i < c->lines; i++)
        answer_cells(a, cell_count(i), cell_real(at->theta), cell_real(angles.theta[i]),
                     cell_word(at->event));
    return true;
}

static bool chain_draw(const struct query *query, struct answer *a, struct problem *problem,
                       struct cycle_samples *c)
{
    static const enum ink inks[LINES] = {INK_BLUE, INK_RED, INK_GREEN, INK_PURPLE, INK_ORANGE};
    struct angles angles = {.count = 0};
    struct chart chart = cycle_chart(query, c, "Tilts");
    struct chart_curve *line[LINES] = {NULL};
    snprintf(chart.y.label, sizeof chart.y.label, "tilt of domino i in %s",
             style_angle_unit(&query->state->settings.style));
    chart.y.low = 0;
    chart.y.high = 1.04 * plot_angle(query, c->angles.theta_f);
    for (int k = 0; k < c->count; k++) {
        if (!lines_at(query, a, problem, c, c->at[k].theta, &angles)) {
            chart_free(&chart);
            return false;
        }
        for (int i = 0; i < c->lines; i++) {
            if (!line[i])
                line[i] =
                    chart_curve(&chart, CHART_LINE, inks[i], i, "i = %d%s", i, i == 0 ? ", the head" : "");
            chart_point(&chart, line[i], plot_angle(query, c->at[k].theta),
                        plot_angle(query, angles.theta[i]));
        }
    }
    struct chart_curve *last = chart_curve(&chart, CHART_LINE, INK_GREY, 2, "the last");
    chart_point(&chart, last, 0, plot_angle(query, c->angles.theta_f));
    chart_point(&chart, last, chart.x.high, plot_angle(query, c->angles.theta_f));
    return chart_show(&chart, a, query->scene->compute.interrupt, problem);
}

bool plot_chain(const struct query *query, struct answer *a, struct problem *problem)
{
    return plot_samples(query, a, problem, chain_rows, chain_draw);
}
