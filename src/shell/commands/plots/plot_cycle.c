/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot energy, omega, inertia, chain: one cycle of the train, over the tilt of its head. */
#include "commands/plots/plots.h"
#include "commands/walk.h"
#include "io/terminal.h"
#include "language/quad.h"
#include <string.h>

enum { STEPS = 160 };

/* A train that stops is shown up to this many times the tilt at which it stops: its barrier is there. */
#define BEYOND_STOP 4

struct cycle {
    const struct query *query;
    struct domq_event event[DOM_EVENTS_MAX];
    int events;
    struct domq_angles angles;
    domq_real end; /* the largest tilt of the picture */
};

/* The cycle at one tilt. */
struct sample {
    domq_real theta, dH, J, omegasq; /* omegasq is NaN beyond a stop */
    const char *event;               /* the event at this tilt, or NULL */
};

/* Writes the rows of a sample. */
typedef enum dom_status sample_rows(struct cycle *cycle, const struct sample *sample, struct answer *a);

static double angle_shown(const struct cycle *c, domq_real theta)
{
    return (double)style_angle(&c->query->state->settings.style, theta);
}

static bool cycle_find(struct cycle *c, struct problem *problem)
{
    const struct scene *scene = c->query->scene;
    enum dom_status status = domq_angles_find(&scene->train, &scene->compute, &c->angles);
    if (status == DOM_OK)
        status = domq_cycle_events(&scene->train, &scene->compute, c->event, &c->events);
    if (status == DOM_NO_FUEL)
        return train_comes_to(c->query, problem, 0);
    if (status == DOM_NO_MARGIN)
        return problem_error(
            problem, "the margin is 0 to rounding: the cycle comes to no end; a slightly smaller r has one");
    c->end = c->angles.theta_c;
    if (status == DOM_STOPS)
        c->end = quad_smaller(c->end, BEYOND_STOP * c->event[c->events - 1].theta);
    return status == DOM_OK || status == DOM_STOPS || problem_status(problem, scene, status);
}

static enum dom_status sample_find(const struct cycle *c, const struct domq_event *event, domq_real theta,
                                   struct sample *k)
{
    const struct scene *scene = c->query->scene;
    struct domq_energy energy;
    struct domq_value omegasq = {.value = DOMQ_NAN};
    enum dom_status status = domq_energy_find(&scene->train, &scene->compute, theta, &energy);
    if (event && event->kind == DOM_EVENT_STOP)
        omegasq.value = 0;
    else if (status == DOM_OK && theta <= c->event[c->events - 1].theta)
        status = domq_cycle_omegasq(&scene->train, &scene->compute, theta, &omegasq);
    *k = (struct sample){theta, energy.dH, energy.J, omegasq.value,
                         event ? dom_event_text(event->kind) : NULL};
    return status == DOM_STOPS ? DOM_OK : status;
}

/* Writes the rows of all samples: at tilts equally far apart, and at the events between them. */
static enum dom_status samples_write(struct cycle *c, struct answer *a, sample_rows *write)
{
    enum dom_status status = DOM_OK;
    int event = 0;
    for (int k = 0; k <= STEPS && status == DOM_OK && !answer_lost(a);) {
        struct sample sample;
        domq_real theta = k == STEPS ? c->end : c->end * k / STEPS;
        const struct domq_event *at =
            event < c->events && c->event[event].theta <= theta ? &c->event[event++] : NULL;
        k += !at || at->theta == theta;
        status = sample_find(c, at, at ? at->theta : theta, &sample);
        if (status == DOM_OK)
            status = write(c, &sample, a);
        progress_show((k + 1.0) / (STEPS + 2));
    }
    return status;
}

/* Answers with the rows; the chart gets the train, and a line and a name for each event. */
static bool cycle_plot(struct cycle *c, struct answer *a, struct chart *chart, struct problem *problem,
                       sample_rows *write)
{
    const struct domq_train *t = &c->query->scene->train;
    if (!cycle_find(c, problem))
        return false;
    enum dom_status status = samples_write(c, a, write);
    if (status != DOM_OK)
        return problem_status(problem, c->query->scene, status);
    if (!chart)
        return true;
    size_t at = strlen(chart->title);
    snprintf(chart->title + at, sizeof chart->title - at, ": s = %.4g, r = %.4g, d = %.4g, q = %.4g",
             (double)t->s, (double)t->r, (double)t->d, (double)t->q);
    chart->x.low = 0;
    chart->x.high = angle_shown(c, c->end);
    for (int k = 0; k < c->events; k++)
        chart_event(chart, angle_shown(c, c->event[k].theta), dom_event_text(c->event[k].kind));
    return true;
}

/* ---- Energy, inertia, angular velocity ---- */

static enum dom_status energy_row(struct cycle *c, const struct sample *k, struct answer *a)
{
    (void)c;
    answer_cells(a, cell_real(k->theta), cell_real(k->dH), cell_real(k->J * k->omegasq), cell_real(k->J),
                 cell_word(k->event));
    return DOM_OK;
}

bool plot_energy(const struct query *query, struct answer *a, struct chart *chart, struct problem *problem)
{
    struct cycle c = {.query = query};
    bool done = cycle_plot(&c, a, chart, problem, energy_row);
    if (done && chart)
        chart_level(chart, 0, "");
    return done;
}

static enum dom_status inertia_row(struct cycle *c, const struct sample *k, struct answer *a)
{
    (void)c;
    answer_cells(a, cell_real(k->theta), cell_real(k->J), cell_word(k->event));
    return DOM_OK;
}

bool plot_inertia(const struct query *query, struct answer *a, struct chart *chart, struct problem *problem)
{
    return cycle_plot(&(struct cycle){.query = query}, a, chart, problem, inertia_row);
}

static enum dom_status omega_row(struct cycle *c, const struct sample *k, struct answer *a)
{
    const struct scene *scene = c->query->scene;
    domq_real omega = quad(sqrt)(k->omegasq) / domq_scale_tau(&scene->scale, &scene->train);
    answer_cells(a, cell_real(k->theta), cell_real(k->omegasq), cell_real(omega), cell_word(k->event));
    return DOM_OK;
}

bool plot_omega(const struct query *query, struct answer *a, struct chart *chart, struct problem *problem)
{
    struct cycle c = {.query = query};
    if (chart) {
        chart->y.low = 0;
        snprintf(chart->curve[0].title, sizeof chart->curve[0].title,
                 "the head, %.4g mm tall; the next is sqrt(r) times slower",
                 (double)(1000 * query->scene->scale.h));
    }
    return cycle_plot(&c, a, chart, problem, omega_row);
}

/* ---- Tilts ---- */

enum { LINES = PLOT_CURVES };
#define LINES_APART ((domq_real)2 / 100) /* a line that begins this share of theta_f from it is left out */

/* The tilts of the first dominoes at one tilt of the head. */
struct tilts {
    domq_real theta[LINES];
    int count;
};

static bool tilts_link(const struct domq_link *link, void *context)
{
    struct tilts *t = context;
    t->theta[t->count++] = link->theta;
    return t->count < LINES;
}

/* Finds the tilts. A domino that is too light to matter, or has detached, has theta_f. */
static enum dom_status tilts_find(const struct cycle *c, domq_real theta, struct tilts *t)
{
    const struct scene *scene = c->query->scene;
    t->count = 0;
    enum dom_status status = domq_chain_walk(&scene->train, &scene->compute, theta, tilts_link, t);
    while (t->count < LINES)
        t->theta[t->count++] = c->angles.theta_f;
    return status;
}

static enum dom_status chain_rows(struct cycle *c, const struct sample *k, struct answer *a)
{
    struct tilts start, now;
    domq_real theta_f = c->angles.theta_f;
    enum dom_status status = tilts_find(c, 0, &start);
    if (status == DOM_OK)
        status = tilts_find(c, k->theta, &now);
    for (int i = 0; i < LINES && status == DOM_OK; i++) {
        if (i > 0 && theta_f - start.theta[i] <= LINES_APART * theta_f)
            break;
        answer_cells(a, cell_count(i), cell_real(k->theta), cell_real(now.theta[i]), cell_word(k->event));
    }
    return status;
}

bool plot_chain(const struct query *query, struct answer *a, struct chart *chart, struct problem *problem)
{
    struct cycle c = {.query = query};
    bool done = cycle_plot(&c, a, chart, problem, chain_rows);
    if (done && chart) {
        double theta_f = angle_shown(&c, c.angles.theta_f);
        chart->y.low = 0;
        chart->y.high = 1.04 * theta_f;
        chart_level(chart, theta_f, "the last");
    }
    return done;
}
