/* SPDX-License-Identifier: GPL-3.0-or-later */
/* plot energy, omega, inertia, chain: one cycle with its events. */
#include "commands/plots/plots.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "picture/picture.h"

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

static bool events_find(struct session *session, struct cycle_samples *c)
{
    enum dom_status status = domq_angles_find(&session->train, &session->compute, &c->angles);
    if (status == DOM_OK)
        status = domq_cycle_events(&session->train, &session->compute, c->events, &c->event_count);
    if (status == DOM_NO_FUEL)
        return picture_comes_to(session, 0);
    if (status == DOM_NO_MARGIN)
        return session_error(
            session, "the margin is 0 to rounding: the cycle comes to no end; a slightly smaller r has one");
    c->end = c->angles.theta_c;
    /* Of a train that stops, the barrier is what there is to see. */
    if (status == DOM_STOPS)
        c->end = quad_smaller(c->end, BEYOND_STOP * c->events[c->event_count - 1].theta);
    return status == DOM_OK || status == DOM_STOPS || session_status(session, status);
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

static enum dom_status sample_find(const struct session *session, bool beyond, struct sample *k)
{
    struct domq_energy energy;
    struct domq_value omegasq = {.value = DOMQ_NAN};
    enum dom_status status = domq_energy_find(&session->train, &session->compute, k->theta, &energy);
    if (status != DOM_OK)
        return status;
    k->dH = energy.dH;
    k->J = energy.J;
    if (k->rests)
        omegasq.value = 0;
    else if (!beyond)
        status = domq_cycle_omegasq(&session->train, &session->compute, k->theta, &omegasq);
    k->omegasq = omegasq.value;
    return status == DOM_STOPS ? DOM_OK : status;
}

static bool samples_find(struct session *session, struct cycle_samples *c)
{
    struct progress progress = {0, 0};
    if (!events_find(session, c))
        return false;
    tilts_make(c);
    domq_real end = c->events[c->event_count - 1].theta;
    for (int k = 0; k < c->count; k++) {
        enum dom_status status = sample_find(session, c->at[k].theta > end, &c->at[k]);
        progress_show(&progress, status == DOM_OK ? (k + 1.0) / c->count : 1);
        if (status != DOM_OK)
            return session_status(session, status);
    }
    return true;
}

/* ---- What these pictures have in common ---- */

/* Begins a chart over the tilt of the head, with a line and a name for each event. */
static struct chart cycle_chart(const struct session *session, const struct cycle_samples *c,
                                const char *what)
{
    struct chart chart = chart_make();
    const struct domq_train *t = &session->train;
    snprintf(chart.title, sizeof chart.title, "%s over a cycle: s = %.4g, r = %.4g, d = %.4g, q = %.4g", what,
             (double)t->s, (double)t->r, (double)t->d, (double)t->q);
    snprintf(chart.x.label, sizeof chart.x.label, "tilt of the head in %s",
             style_angle_unit(&session->style));
    chart.x.low = 0;
    chart.x.high = plot_angle(session, c->end);
    for (int k = 0; k < c->event_count; k++)
        chart_event(&chart, plot_angle(session, c->events[k].theta), dom_event_text(c->events[k].kind));
    return chart;
}

/* Draws a picture of the samples of a cycle; for programs, writes the rows of each. */
static bool plot_samples(struct session *session, const struct call *call,
                         bool (*rows)(struct session *, struct cycle_samples *, const struct sample *,
                                      struct answer *),
                         bool (*draw)(struct session *, struct cycle_samples *))
{
    static struct cycle_samples c;
    bool people = answer_for_people(call->answer);
    if (people && !chart_ready(session))
        return false;
    bool good = samples_find(session, &c);
    for (int k = 0; k < c.count && good && !people; k++)
        good = rows(session, &c, &c.at[k], call->answer);
    return good && (!people || draw(session, &c));
}

/* ---- Energy ---- */

static bool energy_draw(struct session *session, struct cycle_samples *c)
{
    struct chart chart = cycle_chart(session, c, "Energy");
    snprintf(chart.y.label, sizeof chart.y.label, "energy in m g h/2 of the head");
    struct chart_curve *dH =
        chart_curve(&chart, CHART_LINE, INK_BLUE, 0, "potential energy, from the launch on");
    for (int k = 0; k < c->count; k++)
        chart_point(&chart, dH, plot_angle(session, c->at[k].theta), (double)c->at[k].dH);
    struct chart_curve *kinetic = chart_curve(&chart, CHART_LINE, INK_RED, 1, "kinetic energy");
    for (int k = 0; k < c->count; k++)
        chart_point(&chart, kinetic, plot_angle(session, c->at[k].theta),
                    (double)(c->at[k].J * c->at[k].omegasq));
    struct chart_curve *zero = chart_curve(&chart, CHART_LINE, INK_GREY, 2, "%s", "");
    chart_point(&chart, zero, 0, 0);
    chart_point(&chart, zero, chart.x.high, 0);
    return chart_show(session, &chart);
}

static bool energy_row(struct session *session, struct cycle_samples *c, const struct sample *at,
                       struct answer *answer)
{
    (void)session, (void)c;
    return answer_cells(answer, cell_real(at->theta), cell_real(at->dH), cell_real(at->J * at->omegasq),
                        cell_real(at->J), cell_word(at->event));
}

bool plot_energy(struct session *session, const struct call *call)
{
    return plot_samples(session, call, energy_row, energy_draw);
}

/* ---- Inertia ---- */

static bool inertia_draw(struct session *session, struct cycle_samples *c)
{
    struct chart chart = cycle_chart(session, c, "Inertia");
    snprintf(chart.y.label, sizeof chart.y.label, "inertia J of all that move, 1 for the head alone");
    struct chart_curve *J = chart_curve(&chart, CHART_LINE, INK_BLUE, 0, "J (20; c2)");
    for (int k = 0; k < c->count; k++)
        chart_point(&chart, J, plot_angle(session, c->at[k].theta), (double)c->at[k].J);
    return chart_show(session, &chart);
}

static bool inertia_row(struct session *session, struct cycle_samples *c, const struct sample *at,
                        struct answer *answer)
{
    (void)session, (void)c;
    return answer_cells(answer, cell_real(at->theta), cell_real(at->J), cell_word(at->event));
}

bool plot_inertia(struct session *session, const struct call *call)
{
    return plot_samples(session, call, inertia_row, inertia_draw);
}

/* ---- Angular velocity ---- */

static bool omega_draw(struct session *session, struct cycle_samples *c)
{
    struct chart chart = cycle_chart(session, c, "Angular velocity");
    domq_real tau = domq_scale_tau(&session->scale, &session->train);
    snprintf(chart.y.label, sizeof chart.y.label, "angular velocity in %s/s",
             style_angle_unit(&session->style));
    chart.y.low = 0;
    struct chart_curve *omega = chart_curve(&chart, CHART_LINE, INK_BLUE, 0,
                                            "the head, %.4g mm tall; the next is sqrt(r) times slower",
                                            (double)(1000 * session->scale.h));
    for (int k = 0; k < c->count; k++)
        chart_point(&chart, omega, plot_angle(session, c->at[k].theta),
                    plot_angle(session, quad(sqrt)(c->at[k].omegasq) / tau));
    return chart_show(session, &chart);
}

static bool omega_row(struct session *session, struct cycle_samples *c, const struct sample *at,
                      struct answer *answer)
{
    (void)c;
    domq_real tau = domq_scale_tau(&session->scale, &session->train);
    return answer_cells(answer, cell_real(at->theta), cell_real(at->omegasq),
                        cell_real(quad(sqrt)(at->omegasq) / tau), cell_word(at->event));
}

bool plot_omega(struct session *session, const struct call *call)
{
    return plot_samples(session, call, omega_row, omega_draw);
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
static enum dom_status angles_find(const struct session *session, domq_real theta, domq_real theta_f,
                                   struct angles *a)
{
    a->count = 0;
    enum dom_status status = domq_chain_walk(&session->train, &session->compute, theta, angles_link, a);
    while (a->count < LINES)
        a->theta[a->count++] = theta_f;
    return status;
}

/* Counts the lines: as many as begin apart from theta_f. */
static enum dom_status lines_count(const struct session *session, struct cycle_samples *c)
{
    struct angles a;
    domq_real theta_f = c->angles.theta_f;
    enum dom_status status = angles_find(session, 0, theta_f, &a);
    c->lines = 1;
    while (c->lines < LINES && theta_f - a.theta[c->lines] > LINES_APART * theta_f)
        c->lines++;
    return status;
}

/* Finds the tilts of the lines at a sample. */
static bool lines_at(struct session *session, struct cycle_samples *c, domq_real theta, struct angles *a)
{
    enum dom_status status = c->lines ? DOM_OK : lines_count(session, c);
    if (status == DOM_OK)
        status = angles_find(session, theta, c->angles.theta_f, a);
    return status == DOM_OK || session_status(session, status);
}

static bool chain_rows(struct session *session, struct cycle_samples *c, const struct sample *at,
                       struct answer *answer)
{
    struct angles a = {.count = 0};
    if (!lines_at(session, c, at->theta, &a))
        return false;
    for (int i = 0; i < c->lines; i++)
        answer_cells(answer, cell_count(i), cell_real(at->theta), cell_real(a.theta[i]),
                     cell_word(at->event));
    return true;
}

static bool chain_draw(struct session *session, struct cycle_samples *c)
{
    static const enum ink inks[LINES] = {INK_BLUE, INK_RED, INK_GREEN, INK_PURPLE, INK_ORANGE};
    struct angles a = {.count = 0};
    struct chart chart = cycle_chart(session, c, "Tilts");
    struct chart_curve *line[LINES] = {NULL};
    snprintf(chart.y.label, sizeof chart.y.label, "tilt of domino i in %s",
             style_angle_unit(&session->style));
    chart.y.low = 0;
    chart.y.high = 1.04 * plot_angle(session, c->angles.theta_f);
    for (int k = 0; k < c->count; k++) {
        if (!lines_at(session, c, c->at[k].theta, &a)) {
            chart_free(&chart);
            return false;
        }
        for (int i = 0; i < c->lines; i++) {
            if (!line[i])
                line[i] =
                    chart_curve(&chart, CHART_LINE, inks[i], i, "i = %d%s", i, i == 0 ? ", the head" : "");
            chart_point(&chart, line[i], plot_angle(session, c->at[k].theta),
                        plot_angle(session, a.theta[i]));
        }
    }
    struct chart_curve *last = chart_curve(&chart, CHART_LINE, INK_GREY, 2, "the last");
    chart_point(&chart, last, 0, plot_angle(session, c->angles.theta_f));
    chart_point(&chart, last, chart.x.high, plot_angle(session, c->angles.theta_f));
    return chart_show(session, &chart);
}

bool plot_chain(struct session *session, const struct call *call)
{
    return plot_samples(session, call, chain_rows, chain_draw);
}
