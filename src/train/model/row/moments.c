/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the state of a row at given times. The motion of each head is divided into passages: whenever a
 * domino detaches, a new passage begins. A detached domino keeps its tilt. Within a passage, a clock finds
 * the tilt at a given time.
 */
#include "dynamics/dynamics.h"
#include "geometry/chain.h"
#include "row/row.h"

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
    struct walk k = walk_begin(&st->geometry, tilt, st->geometry.rolls);
    w->moving = st->geometry.n;
    for (;;) {
        w->tilt[head - k.link.i] = k.link.i == 0 ? theta : tilt_angle(k.link.tilt);
        w->omega[head - k.link.i] = k.link.slope * omega;
        if (k.link.i + 1 >= st->geometry.n)
            return DOM_OK;
        /* All n dominoes lean on each other, so `leads` should be true. Only a rounding error at the end of a
         * passage can make it false. */
        if (!k.link.leads) {
            walk_touch(&k);
            k.link.contact.slope = 0;
        }
        walk_on(&k);
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
    enum dom_status status = still ? DOM_OK : segment_speed(st, theta, &omegasq);
    return status == DOM_OK ? watch_lean(w, st, s->head, theta, sqrt(fmax(omegasq, 0)) / s->tau) : status;
}

static real passage_end(const struct passage *s)
{
    return s->begins + (s->passed + s->lasts) * s->tau;
}

KERNEL enum dom_status watch_passage(struct watch *w, const struct passage *passage)
{
    if (w->ended)
        return DOM_OK;
    if (isnan(passage->begins + passage->passed) && w->next < w->times)
        return DOM_NO_MARGIN;
    struct passage *s = &w->last;
    *s = *passage;
    enum dom_status status = DOM_OK;
    /*
     * If a requested time lies in this passage, its tilt is sought. If the motion ends here, the caller does
     * not know the duration, and watch_rest needs the time of the end.
     */
    if (isnan(s->lasts) || (w->next < w->times && w->time[w->next] < passage_end(s)))
        status = clock_begin(&w->clock, &s->st, s->to, s->rests, s->st.geometry.tol);
    if (isnan(s->lasts) && status == DOM_OK)
        s->lasts = clock_time(&w->clock, s->to);
    while (status == DOM_OK && !w->ended && w->next < w->times && w->time[w->next] < passage_end(s)) {
        const real time = (w->time[w->next] - s->begins) / s->tau - s->passed;
        real theta = s->st.lo;
        if (time > 0)
            status = clock_tilt(&w->clock, time, &theta);
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

/*
 * A single domino tips over from theta_u. Let its tilt be theta_u + phi. It would take an infinite time to
 * leave theta_u, so times are counted back from the hit. tau omega / sin(phi / 2) is a smooth function of
 * phi, and constant with sharp edges. So the variable is q = ln [tan(phi_c / 4) / tan(phi / 4)], with phi_c
 * at the hit.
 */
struct tipping {
    const struct segment *st;
    const struct num_linear *time; /* the time from q to the hit, in tau */
    real left;                     /* the time whose q is sought */
};

static real tipping_phi(const struct segment *st, real q)
{
    return 4 * atan(tan((st->hi - st->lo) / 4) * exp(-q));
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
    const real half = sin(phi / 2);
    energy += geometry->rounded.roll * (phi < exp(log(REAL_EPSILON) / 5) ? -2 * phi / 3 * (1 + phi * phi / 30)
                                                                         : (sin(phi) - phi) / (half * half));
    return sqrt(energy / geometry_inertia(geometry, at));
}

static bool tipping_slowness(real q, void *context, struct num_rate *rate)
{
    const struct tipping *t = context;
    *rate = (struct num_rate){.c = 2 / tipping_rate(t->st, tipping_phi(t->st, q))};
    return true;
}

static real tipping_early(real q, void *context)
{
    const struct tipping *t = context;
    return num_linear_moved(t->time, q, q) - t->left;
}

KERNEL enum dom_status watch_tip(struct watch *w, const struct segment *tip, real tau)
{
    if (!w)
        return DOM_OK;
    /* the domino touches the next one before it tips over, and leans on it at rest */
    if (tip->hi <= tip->lo) {
        w->tilt[0] = tip->hi;
        return DOM_OK;
    }
    const bool asked = w->next < w->times && w->time[w->next] < 0;
    const real tol = losses_end_alone(&tip->geometry) ? tip->geometry.tol / 8 : DRAG_TOL,
               first = asked ? -(real)w->time[w->next] / tau : 0;
    struct num_linear *time = &w->clock.time;
    struct tipping t = {.st = tip, .time = time};
    enum num_status solver = NUM_OK;
    time->integral = true;
    time->panels = 0;
    /* The moment of inertia is at least a quarter of its value for sharp edges. So q grows by at most
     * sqrt(2 steepest) per tau. */
    const real most = first * sqrt(2 * tip->geometry.steepest);
    for (real q = 0, next; q < most && solver == NUM_OK; q = next) {
        next = fmin(fmax(8 * q, 1), most);
        solver = num_linear_solve(tipping_slowness, &t, q, next, tol, time);
    }
    w->last = (struct passage){.st = *tip, .to = tip->hi, .tau = tau};
    w->moving = 1;
    while (solver == NUM_OK && !w->ended && w->next < w->times && w->time[w->next] < 0) {
        real q = 0;
        t.left = -(real)w->time[w->next] / tau;
        solver = num_root(tipping_early, &t, 0, most, tip->geometry.tol, &q);
        const real phi = tipping_phi(tip, q);
        w->tilt[0] = tip->lo + phi;
        w->omega[0] = tipping_rate(tip, phi) * sin(phi / 2) / tau;
        watch_visit(w, w->time[w->next]);
    }
    return model_status(DOM_OK, solver);
}
