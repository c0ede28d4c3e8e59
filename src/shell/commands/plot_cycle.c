/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/tables.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "picture/picture.h"

enum { STEPS = 160, SAMPLES = STEPS + 1 + DOM_EVENTS_MAX, ROWS_MAX = 3 };

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

static double shown_angle(const struct session *session, domq_real theta)
{
    return (double)style_angle(&session->style, theta);
}

/* Writes a line and a name for each event; names that would overlap are placed above each other. */
static void script_events(FILE *out, const struct session *session, const struct cycle_samples *c, bool text)
{
    double end = shown_angle(session, c->end);
    domq_real last[ROWS_MAX] = {-1, -1, -1}, room = c->end / 7;
    for (int k = 0; k < c->event_count; k++) {
        const struct domq_event *e = &c->events[k];
        double at = shown_angle(session, e->theta);
        int row = 0;
        while (row + 1 < ROWS_MAX && e->theta - last[row] < room && last[row] >= 0)
            row++;
        last[row] = e->theta;
        fprintf(out, "set arrow from %.8g, graph 0 to %.8g, graph %g nohead lc rgb '#555555' lw 1 dt 3\n", at,
                at, text ? 0.94 : 1.0);
        const char *side = k == 0 ? "left" : k + 1 == c->event_count && at > 0.9 * end ? "right" : "center";
        fprintf(out, "set label '%s' at %.8g, graph 1 %s offset 0,%g\n", dom_event_text(e->kind), at, side,
                (text ? 1 : 0.7) + row);
    }
}

static void script_cycle(const struct picture *picture, const struct session *session,
                         const struct cycle_samples *c, const char *what)
{
    FILE *out = picture->script;
    const struct domq_train *t = &session->train;
    fprintf(out, "set title \"%s over a cycle: s = %.4g, r = %.4g, d = %.4g, q = %.4g\" offset 0,%d\n", what,
            (double)t->s, (double)t->r, (double)t->d, (double)t->q, ROWS_MAX);
    fprintf(out, "set xlabel 'tilt of the head, %s [%s]'\nset xrange [0:%.8g]\nset tmargin %d\n",
            picture->theta, style_angle_unit(&session->style), shown_angle(session, c->end), ROWS_MAX + 3);
    script_events(out, session, c, picture->text);
}

/* Draws a picture of the samples of a cycle; for programs, writes the rows of each. */
static bool plot_samples(struct session *session, const struct call *call,
                         bool (*rows)(struct session *, struct cycle_samples *, const struct sample *,
                                      struct answer *),
                         bool (*script)(const struct picture *, struct session *, struct cycle_samples *))
{
    static struct cycle_samples c;
    struct picture picture;
    bool people = answer_for_people(call->answer);
    if (people && !picture_begin(session, &picture))
        return false;
    bool good = samples_find(session, &c);
    for (int k = 0; k < c.count && good && !people; k++)
        good = rows(session, &c, &c.at[k], call->answer);
    if (!people)
        return good;
    return picture_end(session, &picture, good && script(&picture, session, &c));
}

/* ---- Energy ---- */

static bool energy_script(const struct picture *picture, struct session *session, struct cycle_samples *c)
{
    FILE *out = picture->script;
    /* Text has no room beside an axis. */
    script_cycle(picture, session, c, picture->text ? "Energy [m g h / 2]" : "Energy");
    fprintf(out,
            "set ylabel 'energy [m g h / 2]'\nset border 11\nset y2tics\nset xzeroaxis lt 6 lw 1 dt 1\n");
    if (!picture->text) /* where it would hide the numbers; the legend says it, too */
        fprintf(out, "set y2label 'inertia J'\n");
    fprintf(out, "$cycle << END\n");
    for (int k = 0; k < c->count; k++)
        fprintf(out, "%.8g %.8g %.8g %.8g\n", shown_angle(session, c->at[k].theta), (double)c->at[k].dH,
                (double)(c->at[k].J * c->at[k].omegasq), (double)c->at[k].J);
    fprintf(out, "END\nplot $cycle using 1:2 with lines lt 1 lw 3 title ' potential energy, dH', "
                 "$cycle using 1:3 with lines lt 2 lw 3 title ' kinetic energy', "
                 "$cycle using 1:4 axes x1y2 with linespoints lt 3 pi 20 title ' J (right)'\n");
    return true;
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
    return plot_samples(session, call, energy_row, energy_script);
}

/* ---- Angular velocity ---- */

static bool omega_script(const struct picture *picture, struct session *session, struct cycle_samples *c)
{
    FILE *out = picture->script;
    domq_real tau = domq_scale_tau(&session->scale, session->train.d);
    script_cycle(picture, session, c, picture->text ? "Angular velocity [1/s]" : "Angular velocity");
    fprintf(out, "set ylabel '%s [%s/s]'\nset yrange [0:*]\n$cycle << END\n", picture->omega,
            style_angle_unit(&session->style));
    for (int k = 0; k < c->count; k++)
        fprintf(out, "%.8g %.8g\n", shown_angle(session, c->at[k].theta),
                shown_angle(session, quad(sqrt)(c->at[k].omegasq) / tau));
    fprintf(out,
            "END\nplot $cycle using 1:2 with lines lt 1 lw 3 "
            "title ' of the head, h = %.4g mm; the next is sqrt(r) times slower'\n",
            (double)(1000 * session->scale.h));
    return true;
}

static bool omega_row(struct session *session, struct cycle_samples *c, const struct sample *at,
                      struct answer *answer)
{
    (void)c;
    domq_real tau = domq_scale_tau(&session->scale, session->train.d);
    return answer_cells(answer, cell_real(at->theta), cell_real(at->omegasq),
                        cell_real(quad(sqrt)(at->omegasq) / tau), cell_word(at->event));
}

bool plot_omega(struct session *session, const struct call *call)
{
    return plot_samples(session, call, omega_row, omega_script);
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

static bool chain_script(const struct picture *picture, struct session *session, struct cycle_samples *c)
{
    FILE *out = picture->script;
    struct angles a = {.count = 0};
    script_cycle(picture, session, c, picture->text ? "Tilts theta_i" : "Tilts");
    fprintf(out, "set ylabel 'tilt %s_i of domino i [%s]'\nset yrange [0:%.8g]\n$chain << END\n",
            picture->theta, style_angle_unit(&session->style),
            1.02 * shown_angle(session, c->angles.theta_f));
    for (int k = 0; k < c->count; k++) {
        if (!lines_at(session, c, c->at[k].theta, &a))
            return false;
        fprintf(out, "%.8g", shown_angle(session, c->at[k].theta));
        for (int i = 0; i < c->lines; i++)
            fprintf(out, " %.8g", shown_angle(session, a.theta[i]));
        fprintf(out, "\n");
    }
    fprintf(out, "END\n");
    fprintf(out, "plot ");
    for (int i = 0; i < c->lines; i++)
        fprintf(out, "$chain using 1:%d with lines lt %d lw 2.5 title ' i = %d%s', ", i + 2, i + 1, i,
                i == 0 ? ", the head" : "");
    fprintf(out, "%.8g with lines lt 6 lw 1 dt 3 title ' %s_f, the last'\n",
            shown_angle(session, c->angles.theta_f), picture->theta);
    return true;
}

bool plot_chain(struct session *session, const struct call *call)
{
    return plot_samples(session, call, chain_rows, chain_script);
}
