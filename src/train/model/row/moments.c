/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the state of a row at given times. The motion of each head is divided into passages: whenever a
 * domino detaches, a new passage begins. A detached domino keeps its tilt. Within a passage, the tilt at a
 * given time is found from the tilt at the time before, by Newton's method.
 */
#include "row/moments.h"
#include "dynamics/flow.h"
#include "dynamics/losses.h"
#include "geometry/rounded.h"
#include <stdlib.h>

KERNEL enum dom_status watch_begin(struct watch *w, const struct row_request *row)
{
    w->tilt = calloc(row->count, sizeof *w->tilt);
    w->omega = calloc(row->count, sizeof *w->omega);
    for (size_t k = 0; w->tilt && k < row->count; k++)
        w->tilt[k] = row->domino[k].lean;
    return w->tilt && w->omega ? DOM_OK : DOM_NO_MEMORY;
}

KERNEL void watch_free(struct watch *w)
{
    free(w->tilt);
    free(w->omega);
}

/* ---- The state at a given tilt of the head ---- */

/* Sets the tilts and angular velocities of all moving dominoes from those of the head, `theta` and `omega`,
 * in rad and rad/s. */
static enum dom_status watch_lean(struct watch *w, const struct segment *st, size_t head, real theta,
                                  real omega)
{
    struct tilt tilt;
    enum dom_status status = geometry_tilt(&st->geometry, theta, &tilt);
    if (status != DOM_OK)
        return status;
    struct walk k = st->geometry.law->begin(&st->geometry, tilt);
    w->moving = st->geometry.n;
    for (;;) {
        w->tilt[head - k.link.i] = k.link.i == 0 ? theta : tilt_angle(k.link.tilt);
        w->omega[head - k.link.i] = k.link.slope * omega;
        if (k.link.i + 1 >= st->geometry.n)
            return DOM_OK;
        /* All n dominoes lean on each other, so `leads` should be true. Only a rounding error at the end of a
         * passage can make it false. */
        if (!k.link.leads) {
            st->geometry.law->touch(&k);
            k.link.contact.slope = 0;
        }
        st->geometry.law->next(&k);
    }
}

static void watch_visit(struct watch *w, dom_real time)
{
    const struct dom_moment moment = {
        .time = time, .head = w->head + 1, .moving = w->moving, .tilt = w->tilt, .omega = w->omega};
    w->next++;
    w->ended = !w->visit(&moment, w->context);
}

static enum dom_status passage_lean(struct watch *w, const struct passage *s, real theta)
{
    const struct segment *st = &s->st;
    const bool still = (s->rests && theta >= s->to) || (st->start.omegasq == 0 && theta <= st->lo);
    real omegasq = 0;
    enum dom_status status = still ? DOM_OK : segment_speed(&s->st, theta, &omegasq);
    return status == DOM_OK ? watch_lean(w, &s->st, s->head, theta, sqrt(fmax(omegasq, 0)) / s->since.tau)
                            : status;
}

/* ---- From time to tilt ---- */

/* Returns a scale for the tilts in a passage. If the head leans backwards at first, the range of the tilts
 * can be larger than the last tilt. */
static real passage_size(const struct passage *s)
{
    return fmax(fabs(s->to), s->to - s->st.lo);
}

/*
 * The time until the head comes to rest, at the tilt b = `to`, is an integral over the tilt theta. Its
 * integrand 1/omega grows like (b - theta)^(-1/2) near b, so it cannot be integrated directly. The
 * substitution theta = b - (b - lo) x^2 removes the singularity, and time becomes a smooth function of x.
 * Returns the new integrand at x.
 */
static real slowness_to_rest(real x, void *context)
{
    struct passage *s = context;
    real u = fmax(s->span * x, sqrt(REAL_EPSILON)), squared = REAL_NAN;
    real size = passage_size(s), by = fmin(size * u * u, s->to - s->st.lo);
    s->st.status = s->st.geometry.dynamics->near_rest(&s->st.geometry, s->to, by, &squared);
    return s->st.status == DOM_OK ? 2 * size * u * s->span * sqrt(squared) : REAL_NAN;
}

/* Sets s->lasts, the duration of the passage, to `lasts`. If `lasts` is NaN, computes the duration. */
static enum dom_status passage_begin(struct passage *s, real lasts)
{
    struct segment *st = &s->st;
    const real noise = fabs(segment_noise(st));
    s->tol = fmax(st->geometry.tol / 8, noise);
    s->at = st->lo;
    s->lasts = lasts;
    if (!(noise < (real)0.125))
        return DOM_NO_MARGIN;
    if (s->rests)
        s->span = sqrt((s->to - st->lo) / passage_size(s));
    if (!isnan(lasts))
        return DOM_OK;
    if (!s->rests)
        return segment_integral(st, slowness, st->lo, s->to, s->tol, &s->lasts);
    const enum num_status solver = num_integral(slowness_to_rest, s, 0, 1, s->tol, &s->lasts, NULL);
    return model_status(st->status, solver);
}

/* Returns the time from x, the variable of slowness_to_rest, until the head comes to rest, minus s->left. */
static real passage_left(real x, void *context)
{
    struct passage *s = context;
    real time = 0;
    const enum num_status solver = num_integral(slowness_to_rest, s, 0, x, s->tol, &time, NULL);
    return solver == NUM_OK ? time - s->left : REAL_NAN;
}

/* Moves the state (s->at, s->passed) to the time `into`, by Newton's method. Bisects if a step would leave
 * the bracket. */
static enum dom_status passage_find(struct passage *s, real into)
{
    struct segment *st = &s->st;
    const real close = fmax(s->tol, 4 * REAL_EPSILON) * passage_size(s);
    real lo = st->lo, hi = s->to;
    for (int i = 0; i < 200; i++) {
        const real off = into - s->passed, at = s->at;
        real omegasq = 0, step = 0;
        enum dom_status status = segment_speed(st, at, &omegasq);
        real next = at + off * sqrt(fmax(omegasq, 0));
        *(off >= 0 ? &lo : &hi) = at;
        if (!(next > lo && next < hi))
            next = (lo + hi) / 2;
        s->at = next;
        if (status == DOM_OK && fabs(next - at) <= close) {
            s->passed = into;
            return DOM_OK;
        }
        if (status == DOM_OK)
            status = segment_integral(st, slowness, fmin(at, next), fmax(at, next), s->tol, &step);
        if (status != DOM_OK)
            return status;
        s->passed += next > at ? step : -step;
    }
    return DOM_NOT_CONVERGED;
}

/* Finds the tilt of the head at the time `into`, counted in tau from the beginning of the passage. */
static enum dom_status passage_tilt(struct passage *s, real into, real *theta)
{
    real x = 0;
    *theta = into <= 0 ? s->st.lo : s->to;
    if (!(into > 0 && into < s->lasts))
        return DOM_OK;
    if (!s->rests) {
        enum dom_status status = passage_find(s, into);
        *theta = s->at;
        return status;
    }
    s->left = s->lasts - into;
    enum num_status solver = num_root_between(passage_left, s, 0, -s->left, 1, s->lasts - s->left,
                                              fmax(s->tol, 4 * REAL_EPSILON), &x);
    *theta = s->to - (s->to - s->st.lo) * x * x;
    return model_status(s->st.status, solver);
}

static real passage_end(const struct passage *s)
{
    return s->since.begins + (s->since.passed + s->lasts) * s->since.tau;
}

KERNEL enum dom_status watch_passage(struct watch *w, const struct segment *st, size_t head, real to,
                                     bool rests, const struct since *since, real lasts)
{
    if (!w || w->ended)
        return DOM_OK;
    if (isnan(since->begins + since->passed) && w->next < w->times)
        return DOM_NO_MARGIN;
    struct passage *s = &w->last;
    *s = (struct passage){.st = *st, .to = to, .rests = rests, .since = *since, .lasts = lasts, .head = head};
    /*
     * If a requested time lies in this passage, its tilt is sought. If the motion ends here, the caller does
     * not know the duration, and watch_rest needs the time of the end.
     */
    bool inside = w->next < w->times && !((real)w->time[w->next] >= passage_end(s));
    enum dom_status status = inside || isnan(lasts) ? passage_begin(s, lasts) : DOM_OK;
    while (status == DOM_OK && !w->ended && w->next < w->times && (real)w->time[w->next] < passage_end(s)) {
        real theta = 0;
        status =
            passage_tilt(s, ((real)w->time[w->next] - since->begins) / since->tau - since->passed, &theta);
        if (status == DOM_OK)
            status = passage_lean(w, s, theta);
        if (status == DOM_OK)
            watch_visit(w, w->time[w->next]);
    }
    return status;
}

KERNEL enum dom_status watch_detach(struct watch *w, const struct segment *st, size_t head, size_t moving)
{
    if (!w || moving >= st->geometry.n)
        return DOM_OK;
    enum dom_status status = watch_lean(w, st, head, st->hi, 0);
    w->moving = moving;
    return status;
}

KERNEL enum dom_status watch_rest(struct watch *w)
{
    enum dom_status status = DOM_OK;
    const struct passage *s = &w->last;
    if (w->ended || w->next >= w->times)
        return DOM_OK;
    if (s->st.geometry.n > 0) /* n is 0 if no domino has moved */
        status = passage_lean(w, s, s->to);
    while (status == DOM_OK && !w->ended && w->next < w->times)
        watch_visit(w, passage_end(s));
    return status;
}

/* ---- Before the first hit ---- */

/* A single domino with rounded edges or with drag, which falls from theta_u. */
struct tipping {
    const struct segment *st;
    real end;  /* p = ln tan(phi / 4) at the hit */
    real left; /* the time, in tau, by which the wanted state precedes the hit */
};

/* Returns the angle phi beyond theta_u, given p = ln tan(phi / 4). */
static real tipping_phi(real p)
{
    return 4 * atan(exp(p));
}

/* With drag, the solution of the equation of motion has too few digits where the domino has hardly moved.
 * There, a power series for omega^2 takes its place, with an error of about the square of the angle, and
 * times have a coarser tolerance. */
#define DRAG_CLOSE ((real)1e-4)
#define DRAG_TOL   ((real)1e-7)

/* Returns tau omega / sin(phi / 2), which is a smooth function of phi. */
static real tipping_rate(const struct segment *st, real phi)
{
    const struct geometry *geometry = &st->geometry;
    if (!losses_end_alone(geometry) && phi > DRAG_CLOSE) {
        const real theta = fmin(st->lo + phi, st->hi);
        real ln_G, u;
        flow_at(geometry, theta, &ln_G, &u);
        u = num_linear_moved(&geometry->flow->solution, theta, theta - st->lo); /* without cancellation */
        return sqrt(fmax(exp(ln_G) * u, 0)) / sin(phi / 2);
    }
    const struct tilt u = tilt_half(geometry_half_u(geometry)),
                      at = tilt_make(sin(st->lo + phi), cos(st->lo + phi));
    /* The released energy divided by sin^2(phi / 2). h' is 0 at theta_u, so no large terms cancel. */
    real energy = 2 * geometry_height(geometry, u) * (1 - 2 * geometry->drag * phi / 3);
    if (phi > cbrt(REAL_EPSILON))
        energy += geometry->rounded.roll * (sin(phi) - phi) / (sin(phi / 2) * sin(phi / 2));
    return sqrt(energy / geometry_inertia(geometry, at));
}

static real tipping_slowness(real p, void *context)
{
    return 2 / tipping_rate(((const struct tipping *)context)->st, tipping_phi(p));
}

/* Returns the time from p to the hit, minus t->left. */
static real tipping_over(real p, void *context)
{
    const struct tipping *t = context;
    real time = 0;
    const real tol = losses_end_alone(&t->st->geometry) ? t->st->geometry.tol / 8 : DRAG_TOL;
    enum num_status solver =
        p < t->end ? num_integral(tipping_slowness, context, p, t->end, tol, &time, NULL) : NUM_OK;
    return solver == NUM_OK ? time - t->left : REAL_NAN;
}

/* A domino tips over from theta_u. Returns the angle phi by which it has turned beyond
 * theta_u when the time `left`, in tau, remains until it hits the next domino. */
static real tipping_at(const struct segment *st, real left)
{
    struct tipping t = {st, log(tan((st->hi - st->lo) / 4)), left};
    /*
     * The root is a value of p between `first` and the value of p at the hit. The moment of inertia is at
     * least a quarter of its value for sharp edges. So p grows by at most sqrt(2 R) per tau, where R is the
     * reach. If p always grew that fast, `first` would be the root.
     */
    real first = t.end - left * sqrt(2 * st->geometry.steepest), p = t.end;
    return num_root(tipping_over, &t, first, t.end, st->geometry.tol, &p) == NUM_OK ? tipping_phi(p)
                                                                                    : REAL_NAN;
}

/*
 * A single domino tips over from theta_u. Let its tilt be theta_u + phi. With sharp edges, tau^2 omega^2 =
 * 2 u sin^2(phi / 2), where u = sqrt(1 + d^2) is the reach. So tan(phi / 4) is proportional to
 * exp(t sqrt(u / 2)), where t is the time in tau.
 */
KERNEL void watch_tip(struct watch *w, const struct segment *tip, real tau)
{
    if (!w)
        return;
    /* the domino touches the next one before it tips over, and leans on it at rest */
    if (tip->hi <= tip->lo) {
        w->tilt[0] = tip->hi;
        return;
    }
    const bool closed = !tip->geometry.law->rolls && losses_end_alone(&tip->geometry);
    const real u = tip->geometry.steepest, whole = tip->hi - tip->lo;
    struct passage *s = &w->last;
    *s = (struct passage){.st = *tip, .to = tip->hi, .since = {.tau = tau}};
    w->moving = 1;
    while (!w->ended && w->next < w->times && (real)w->time[w->next] < 0) {
        real time = (real)w->time[w->next] / tau,
             phi = closed ? 4 * atan(tan(whole / 4) * exp(time * sqrt(u / 2))) : tipping_at(tip, -time);
        w->tilt[0] = tip->lo + phi;
        w->omega[0] = (closed ? sqrt(2 * u) : tipping_rate(tip, phi)) * sin(phi / 2) / tau;
        watch_visit(w, w->time[w->next]);
    }
}
