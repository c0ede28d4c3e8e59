/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A study runs a row many times. If a few neighbouring dominoes of a planned row are changed, the run begins
 * at the stored state of the first head that the change can affect. It ends as soon as omegasq equals that of
 * the planned row again, because from then on both rows move alike.
 *
 * The effects of a change decrease from head to head. The omegasq of a later head differs by the fraction
 * `off`, which a head multiplies by lambda. The changed dominoes still lean on the head, and change its
 * motion by an amount of the same order, which decays as these dominoes come down. So the run ends when `off`
 * is small at two heads in a row: small compared with `clear`, the change of omegasq that could change the
 * verdict on the planned row.
 *
 * If the planned row stops, the heads after the stop have no marks until a changed row falls to the end. That
 * run then makes their marks, and takes the place of the planned row for them.
 */
#include "rows/model/study.h"
#include "dynamics/dynamics.h"
#include "effects/effects.h"
#include "row/row.h"
#include <stdlib.h>

/* The headers of the kernel declare functions that only its own sources define. */
#pragma GCC diagnostic ignored "-Wunused-function"

/* The planned row at the moment when a head is hit: its state, and how clear the verdict is from there on. */
struct mark {
    real omegasq, inertia_ratio; /* values of the members of struct run */
    size_t moving;
    /* the derivative of ln omegasq of the next head with respect to ln omegasq of this head */
    real lambda;
    /* A change of omegasq by less than this fraction can change neither the sign of the margin nor that of a
     * contact force, here and at later heads. */
    real clear;
};

struct study {
    struct row row; /* between two runs, the geometry that is filled in is that of the planned row */
    /* The planned row, whose first `known` heads have marks. NULL if the rows of the study are random: then
     * no row is planned, and of the verdicts only `end` and `domino` count. */
    struct mark *mark;
    size_t known;
    struct dom_verdict verdict;
    /* ---- The current run ---- */
    size_t last; /* index of the last domino that differs from the planned row */
    real off;    /* by which fraction omegasq of the last head differs from the planned one */
    bool quick;  /* true if study_passes may be tried */
    /* True if a motion with friction is computed roughly. If the errors may change the verdict, the run sets
     * `doubt`, and the row is run again, precisely. */
    bool rough, doubt;
};

/* Errors of a rough run may change omegasq by at most this fraction. */
#define ROUGH_CLEAR ((real)1 / 32)

/* In a rough run, a contact force must exceed this fraction of the weight of the pushed domino, so that its
 * sign is certain. */
#define LEAST_CLEAR ((real)1 / 64)

/*
 * ---- Heads that certainly keep falling ----
 *
 * In a study only the verdicts on thousands of random rows are wanted, and most heads pass their barrier by
 * far, so the search for the barrier can be left out. Without this shortcut, studies of placement take three
 * to four times as long.
 */

/* The largest number of tilts at which a motion without friction is examined. */
enum { CLEAR_TILTS = 6 };

/*
 * Returns true if it is certain that a head without friction clears its barrier. All of its followers must
 * only lose height. What they have lost at one tilt, they never regain, so it surely takes the head as far as
 * it would get alone with this energy and its own. There the followers have lost more, and so on, until the
 * energy takes the head to theta_u, or to the next domino.
 */
static bool head_clears(const struct geometry *head, real kinetic)
{
    const real stands = geometry_height(head, standing), half_u = head->h.x / (head->h.y + head->steepest);
    real energy = kinetic;
    for (int i = 0; i < CLEAR_TILTS; i++) {
        struct sums sums;
        const real cosine = (stands + energy) / head->steepest; /* of the angle from there to theta_u */
        if (cosine >= 1)
            return true;
        const real apart = sqrt((1 - cosine) / (1 + cosine)), half = (half_u - apart) / (1 + half_u * apart);
        const struct tilt t = tilt_half(half);
        if (half >= half_of_tilt(head->c))
            return true;
        if (chain_change(head, standing, t, PASS_PLAIN, &sums) != DOM_OK)
            return false;
        energy = kinetic + geometry_height(head, t) - stands - sums.dH;
    }
    return false;
}

/* A motion with friction is solved roughly, from a few tilts. The errors of a rough solution are estimated
 * from the last terms of its series. omegasq at the end of the motion may have this relative error, and the
 * head must clear the barrier by several times the error. */
#define ROUGH_ERROR ((real)1 / 256)
#define ROUGH_TIMES 4

/* Number of tilts at which the required energy is sampled to find its maximum. */
enum { ROUGH_PLACES = 12 };

/* Returns the largest u up to the tilt hi (dynamics.h), from samples and parabolas through them. The samples
 * are equally spaced in the square root of the tilt, since thin dominoes have their barrier at a small tilt.
 */
static real rough_need(const struct geometry *head, real hi)
{
    real most = 0, last = 0, self = 0, next;
    for (int i = 1; i <= ROUGH_PLACES; i++) {
        flow_at(head, hi * (real)(i * i) / (ROUGH_PLACES * ROUGH_PLACES), NULL, &next);
        const real bend = 2 * self - last - next;
        most = fmax(most, next);
        if (i > 1 && self >= last && self >= next && bend > 0)
            most = fmax(most, self + (next - last) * (next - last) / (8 * bend));
        last = self;
        self = next;
    }
    return most;
}

/* With drag there is no proof that contacts push, so the forces at a few tilts decide, as in a precise run.
 */
static bool rough_pushes(const struct geometry *head, real w, real hi)
{
    const struct segment st = {.geometry = *head, .hi = hi, .start = {.from = standing, .omegasq = w}};
    real least = (real)INFINITY;
    return segment_contact(&st, hi, &least) == DOM_OK && least > LEAST_CLEAR;
}

static bool study_passes(struct run *run, size_t k, struct start *at)
{
    const struct study *s = run->options->context;
    struct geometry *head = &run->row->geometry[k];
    const bool saves = head->conservative || (run->moving == 1 && losses_end_alone(head)),
               proves = losses_end_alone(head);
    const real w = run->omegasq, kinetic = (1 + run->inertia_ratio) * w;
    struct sums sums;
    /* only a first domino that is released can lean here */
    if (!s->quick || !(w > 0) || head->lean != 0 || (saves ? head->rolls : !s->rough))
        return false;
    head->n = run->moving;
    bool rises = false;
    for (size_t j = k; !rises && j-- > k + 1 - run->moving;)
        rises = geometry_lift(&run->row->geometry[j], run->row->geometry[j].c) > 0;
    if ((saves && rises) || chain_change(head, standing, head->c, PASS_PUSHES, &sums) != DOM_OK ||
        (proves && !sums.pushes) || sums.left != 0)
        return false;
    *at = (struct start){.from = head->c, .J = sums.J, .omegasq = (kinetic - sums.dH) / sums.J};
    if (saves)
        return head_clears(head, kinetic);
    /* The last head of a row whose followers only lose height must reach theta_u to fall. Any other head must
     * reach the next domino. */
    const bool last = k + 1 == run->row->given.count;
    const real reach = tilt_angle(head->c), hi = last && !rises ? fmin(reach, geometry_theta_u(head)) : reach;
    const struct num_linear *solution = &head->flow->solution;
    real ln_G, u;
    if (!flow_rough(head, hi))
        return false;
    flow_at(head, hi, &ln_G, &u);
    at->omegasq = exp(ln_G) * (w - u);
    const real off = solution->v_error + solution->ln_G_error * (w - u);
    return off <= ROUGH_ERROR * (w - u) &&
           w - rough_need(head, hi) > ROUGH_CLEAR * w + ROUGH_TIMES * solution->v_error &&
           (proves || rough_pushes(head, w, hi));
}

/* ---- Runs that end early ---- */

/* omegasq counts as equal if it differs by less than this fraction of `clear`. */
#define STUDY_EQUAL ((real)1 / 16)

/* With friction, `clear` is at most this, because it does not tell how close the row is to locking. */
#define STUDY_LOCKING ((real)1e-3)

/* Makes the mark of head k, with the part of `clear` that concerns this head alone. */
static struct mark mark_of(const struct run *before, size_t k, const struct descent *d,
                           const struct dom_fall *fall)
{
    struct mark m = {.omegasq = before->omegasq,
                     .inertia_ratio = before->inertia_ratio,
                     .moving = before->moving,
                     .clear = 1};
    if (k == 0 && before->omegasq == 0) /* the first domino starts at rest, and has no margin */
        return m;
    m.lambda = d->st.gain * before->omegasq / d->st.start.omegasq;
    m.clear = fmin(fabs((real)fall->margin / (real)fall->kinetic), fabs(d->least_force));
    if (!before->row->geometry[0].conservative)
        m.clear = d->locks ? 0 : fmin(m.clear, STUDY_LOCKING);
    return m;
}

/* Goes back from mark[to - 1] to mark[from], so that `clear` accounts for all later heads, too. */
static void marks_join(struct mark *mark, size_t from, size_t to)
{
    for (size_t k = to; k-- > from;)
        if (k + 1 < to)
            mark[k].clear = fmin(mark[k].clear, mark[k + 1].clear / fmax(mark[k].lambda, 1));
}

/* Called after a head of a changed row. Returns true if the row moves as planned again. */
static bool settles(struct study *s, struct run *run, size_t k)
{
    if (run->verdict.end != DOM_ROW_FALLS || k + 1 >= s->known)
        return false;
    const struct mark *next = &s->mark[k + 1];
    const real last = s->off;
    s->off = fabs(run->omegasq / next->omegasq - 1);
    if (!(k > s->last && fmax(last, s->off) <= STUDY_EQUAL * next->clear))
        return false;
    if (k + 1 < s->verdict.domino)
        run->verdict.end = s->verdict.end;
    return true;
}

/* The relative tolerance of sums along the chain in a rough run. */
#define ROUGH_TOL ((real)1e-6)

static bool study_ends(struct run *run, size_t k, const struct run *before, const struct descent *d,
                       const struct dom_fall *fall)
{
    struct study *s = run->options->context;
    if (!s->mark) {
        const bool tips = k == 0 && before->omegasq == 0, pushes = fabs(d->least_force) > LEAST_CLEAR,
                   sure = fabs((real)fall->margin) > ROUGH_CLEAR * (real)fall->kinetic;
        s->doubt = s->rough && !tips && !(pushes && sure && !d->locks);
        return s->doubt;
    }
    if (run->verdict.end == DOM_ROW_STOPS)
        run->verdict.spare = fall->margin / fall->barrier;
    if (k < s->known)
        return settles(s, run, k);
    s->mark[k] = mark_of(before, k, d, fall);
    return false;
}

/* Runs the row from head k on. */
static enum dom_status study_falls(struct study *s, size_t k, struct dom_verdict *verdict)
{
    const struct run_options options = {
        .forces = s->mark && s->known < s->row.given.count, /* a mark needs the smallest force */
        .every = true,
        .passes = study_passes,
        .ends = study_ends,
        .context = s};
    struct run run = row_launch(&s->row, &options);
    s->off = (real)INFINITY;
    s->doubt = false;
    if (s->mark && k > 0) {
        run.omegasq = s->mark[k].omegasq;
        run.inertia_ratio = s->mark[k].inertia_ratio;
        run.moving = s->mark[k].moving;
    }
    const enum dom_status status = row_falls(&run, k, NULL, NULL);
    *verdict = run.verdict;
    return status;
}

enum dom_status row_study_begin(const struct dom_row *row, const struct dom_compute *compute,
                                struct study **study, struct dom_verdict *verdict)
{
    struct study *s = *study = calloc(1, sizeof *s);
    size_t wrong = 0;
    if (!s)
        return DOM_NO_MEMORY;
    enum dom_status status = row_begin(row, compute, &s->row, verdict ? &verdict->domino : &wrong);
    if (status != DOM_OK || !verdict)
        return status;
    s->mark = malloc(row->count * sizeof *s->mark);
    if (!s->mark)
        return DOM_NO_MEMORY;
    status = study_falls(s, 0, verdict);
    s->known = verdict->domino;
    s->verdict = *verdict;
    marks_join(s->mark, 0, s->known);
    return status;
}

/* Runs the planned row with changes of the dominoes `first` to `last`. */
static enum dom_status study_change(struct study *s, size_t first, size_t last, struct dom_verdict *verdict)
{
    const size_t from = first > 0 ? first - 1 : 0, count = s->row.given.count;
    enum dom_status status = DOM_OK;
    *verdict = s->verdict;
    for (size_t k = first; k <= last && status == DOM_OK; k++)
        status = row_domino_check(&s->row.given, k);
    /* the fall ends before it reaches a head that the change can affect */
    if (status != DOM_OK || (s->verdict.end != DOM_ROW_FALLS && from >= s->verdict.domino))
        return status;
    s->last = last + 1;
    s->row.made = s->row.made < from ? s->row.made : from;
    if (from == 0) { /* the launch needs the first domino */
        status = row_geometry(&s->row, 0);
        s->row.made = 1;
    }
    if (status == DOM_OK)
        status = study_falls(s, from, verdict);
    s->row.made = s->row.made < from ? s->row.made : from;
    if (status == DOM_OK && verdict->end == DOM_ROW_FALLS && verdict->domino == count && s->known < count) {
        marks_join(s->mark, s->known, count);
        s->known = count;
    }
    return status;
}

/* Runs a random row. If it has friction, first runs it roughly. If the verdict of this run is in doubt, runs
 * the row again, precisely. */
static enum dom_status study_random(struct study *s, struct dom_verdict *verdict)
{
    const struct dom_row *row = &s->row.given;
    const struct dom_train first = dynamics_of_domino(row, 0);
    const dom_real tol = s->row.compute.tol;
    s->quick = true;
    for (size_t k = 0; k < row->count; k++)
        s->quick = s->quick && row->domino[k].lean == 0;
    s->rough = s->quick && dom_dissipates(&first);
    s->row.compute.tol = s->rough && tol < (dom_real)ROUGH_TOL ? (dom_real)ROUGH_TOL : tol;
    enum dom_status status = row_read(&s->row, &verdict->domino);
    if (status == DOM_OK)
        status = study_falls(s, 0, verdict);
    s->row.compute.tol = tol;
    if (status != DOM_OK || !s->doubt)
        return status;
    s->rough = false;
    for (size_t k = 0; k < s->row.made; k++)
        s->row.geometry[k].tol = (real)tol;
    return study_falls(s, 0, verdict);
}

enum dom_status row_study(struct study *s, const struct dom_row *row, size_t first, size_t last,
                          struct dom_verdict *verdict)
{
    s->row.given = *row;
    return s->mark ? study_change(s, first, last, verdict) : study_random(s, verdict);
}

void row_study_end(struct study *s)
{
    if (s) {
        row_free(&s->row);
        free(s->mark);
    }
    free(s);
}

enum dom_status row_run_on(const struct dom_row *row, const struct dom_compute *compute,
                           dom_fall_visit *visit, void *context, struct dom_verdict *verdict)
{
    static const struct run_options options = {.carries_on = true};
    return row_run(row, compute, &options, visit, context, verdict);
}
