/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "growth/strip.h"
#include "geometry/sums.h"

/* Allows for rounding errors. Each term of a sum has an error of a few rounding units. */
#define STRIP_SLACK (256 * REAL_EPSILON)

#define LEAST_TOP_STEPS 4

/* Returns h(0) - h(theta). */
static real strip_fall(const struct geometry *geometry, struct tilt t)
{
    return geometry->h.y * t.v - geometry->h.x * t.x;
}

/* Returns g = -dh/dtheta of one domino, which is negative at tilts below theta_u. */
static real strip_sink(const struct geometry *geometry, struct tilt t)
{
    return -geometry_height_slope(geometry, t);
}

/* A follower. `lo` and `hi` are its tilts in the two trains at the ends of the strip. In every train of the
 * strip, its tilt lies between them. */
struct between {
    struct tilt lo, hi;
    real fall_least, fall_most; /* bounds on h(0) - h */
};

static struct between between_of(const struct geometry *geometry, struct tilt lo, struct tilt hi)
{
    real at_lo = strip_fall(geometry, lo), at_hi = strip_fall(geometry, hi);
    bool before = strip_sink(geometry, hi) <= 0, after = strip_sink(geometry, lo) >= 0;
    /* h has its maximum at theta_u. There, it exceeds h(0) by barrier_most. */
    real least = after ? at_lo : before ? at_hi : -barrier_most(geometry);
    return (struct between){lo, hi, least, fmax(at_lo, at_hi)};
}

/* A chain with an upright head. A detached domino and all dominoes behind it are at theta_f. */
struct upright {
    struct link link;
    bool ended; /* true if this domino and all after it are at theta_f */
    real weight, inertia, slope, contact_slope, inertia_ratio;
    real inertia_tail; /* upper bound on what the dominoes behind this one add to inertia_ratio */
};

static void upright_next(struct upright *u, const struct geometry *geometry)
{
    u->weight *= geometry->weight;
    u->inertia *= geometry->inertia;
    if (!u->ended && u->link.leads) {
        link_next(&u->link);
    } else {
        u->ended = true;
        u->link.tilt = geometry->f;
        u->link.contact_slope = 0;
        u->link.slope = 0;
    }
    u->slope = u->link.slope;
    /* T (strip_follower) is J of this chain without the term of the head. */
    u->inertia_ratio += u->inertia * u->slope * u->slope;
    u->contact_slope = u->ended || !u->link.leads ? 0 : u->link.contact_slope;
    real ratio = geometry->inertia * u->contact_slope * u->contact_slope;
    u->inertia_tail = u->inertia * u->slope * u->slope * ratio / (1 - ratio);
}

/* Bounds on sums over the followers. The comments on the members describe a strip of growths. For a strip of
 * separations, read s instead of ln r. */
struct strip_sums {
    real least, most;              /* lower and upper bound on the fuel */
    real advance;                  /* upper bound on d theta_i(0) / d ln r */
    real drops, rests;             /* the bound strip->drops, and the sum of w^i g d theta_i / d ln r */
    real far_rests;                /* the tail of `rests`, multiplied by 1 - w */
    real least_advance;            /* lower bound on d theta_i(theta) / d ln r at the largest tilt */
    real first_drops, first_rests; /* the terms of domino 1, which `drops` and `rests` do not include */
    real ages;                     /* lower bound on the sum of i w^i (h_i(0) - h_(i+1)(0)) */
    real tilt;                     /* upper bound on the head's tilt at the maximum of H */
};

/*
 * Returns an upper bound on a derivative: on d theta_1 / d ln r in a strip of growths, or on d theta_1 / ds
 * in a strip of separations. The derivative is largest at hi, when the leader has its smallest tilt. `leader`
 * is this tilt.
 */
static real strip_advance(const struct geometry *lo, const struct geometry *hi, struct tilt leader)
{
    real v = hi->detaches ? fmin(leader.v, hi->leave.v) : leader.v, X = fmax(hi->rs - hi->rL * v, 0);
    real by = lo->r < hi->r ? X : hi->r * (1 - v);
    return by / sqrt((hi->short_of + hi->rL * v) * (1 + X));
}

/* Like strip_advance, but returns a lower bound: on d theta_1 / d ln r if in_r is true, and on d theta_1 / ds
 * if in_r is false. The derivative is smallest at lo, when the leader has its largest tilt. `leader` is this
 * tilt. */
static real strip_least_advance(const struct geometry *lo, bool in_r, struct tilt leader)
{
    real v = lo->detaches ? fmin(leader.v, lo->leave.v) : leader.v, X = lo->rs - lo->rL * v;
    real by = in_r ? X : lo->r * (1 - v);
    return X > 0 ? by / sqrt((lo->short_of + lo->rL * v) * (1 + X)) : 0;
}

/*
 * Adds follower i to the sums. Together, the sums bound d margin / d ln r. Let theta be the tilt of the head
 * at the maximum of H, and let
 *
 *     u_i = d theta_i / d ln r,   m_i = theta_i(theta) - theta_i(0),   g = -dh/dtheta,   w = r^(-q),
 *     D = r^q / T + r^q - 1,   K = P / D,   c = (1 - w) T / (1 + (1 - w) T).
 *
 * At the maximum, the barrier does not change to first order if only theta changes (the envelope theorem). So
 *
 *     d margin / d ln r = -K d ln D / d ln r - (q / D) sum i w^i (h_i - h_(i+1))
 *         + sum w^i [g_i(theta) u_i(theta) - (1 - c) g_i(0) u_i(0) - q i (h_i(0) - h_i(theta))].
 *
 * If the follower is beyond theta_u, the bound uses three inequalities:
 *
 *     g_i(theta) - g_i(0) <= h_i(0) m_i,   u_i(theta) <= u_i(0),   h_i(0) - h_i(theta) >= g_i(0) m_i.
 *
 * If the follower is before theta_u, the bound adds up the absolute values of the parts.
 */
static void strip_follower(const struct geometry *lo, const struct geometry *hi, bool in_r, size_t i,
                           const struct between *at, real weight, real slope, real least_weight,
                           struct strip_sums *s)
{
    real g_lo = strip_sink(lo, at->lo), g_hi = strip_sink(lo, at->hi), moves = s->tilt * slope,
         u = s->advance;
    real ages = in_r ? lo->q * (real)i : 0;
    if (g_lo >= 0) {
        real h = lo->h.y - strip_fall(lo, at->lo);
        s->drops += weight * moves * fmax(h * u - ages * g_lo, 0);
        /* h_i - h_(i+1) is the integral of g over the tilts from theta_i to theta_(i+1), and the length of
         * this interval is asin X >= X */
        s->ages += (real)i * least_weight * g_lo * fmax(lo->rs - lo->rL * at->hi.v, 0);
    } else {
        /* g(0) u(theta) - g(0) u(0) <= |g(0)| (u(0) - u(theta)) */
        s->drops +=
            weight * (lo->steepest * moves * u - g_lo * fmax(u - s->least_advance, 0) - ages * g_lo * moves);
        s->ages += (real)i * weight * g_lo * strip_advance(lo, hi, at->lo); /* asin X <= X / Y */
    }
    s->rests += weight * fmax(g_hi, 0) * u;
}

/* Returns a lower bound on the tilt of the head at the maximum of H. The barrier must be at least
 * `kinetic`. */
static struct tilt strip_least_top(const struct geometry *lo, const struct geometry *hi, real kinetic,
                                   real grows)
{
    const real most = barrier_most(lo), last = geometry_half_u(lo), upright = strip_fall(hi, hi->c);
    real p = 0, loss = 0;
    for (int k = 0; k < LEAST_TOP_STEPS; k++) {
        /* At the maximum of H, the head has gained at least the energy kinetic + loss. So `spare` is an upper
         * bound on h(theta_u) - h(theta), the rest of the head's climb. */
        const real spare = fmax(most - (kinetic + loss) * (1 - STRIP_SLACK), 0);
        const real before = sqrt(spare / (2 * lo->steepest - spare));
        const struct tilt head = tilt_half(p = fmax(last - before, 0) / (1 + last * before));
        const bool leads = !hi->detaches || head.v < hi->leave.v;
        const struct tilt first = leads ? tilt_follower(head, geometry_contact(hi, head)) : hi->f;
        /* The loss increases with the tilt of the head. Every train in the strip loses at least the loss at
         * hi divided by `grows` (see strip_barrier_most). */
        loss = hi->weight * fmax(strip_fall(hi, first) - upright, 0) / grows;
    }
    return tilt_half(p);
}

/*
 * Returns an upper bound on the terms of domino 1 in the sums of strip_follower, or infinity if no bound is
 * found. At the reach, u_1(0) = tan theta_c is infinite, but the bound on the terms is still finite.
 *
 * If the head leans by at least `least`, u_1(theta) is at most u_1(0) multiplied by `part`:
 * - While domino 1 leans on the head, u_1(theta) / u_1(0) decreases with theta and with r.
 * - After domino 1 has detached, u_1(theta) is d theta_f / d ln r, which is less than sqrt(d / L) u_1(0).
 *
 * If u_1(theta) is replaced by part * u_1(0), the terms are a convex function of u_1(0). So they are largest
 * at lo or at hi.
 */
static real strip_first(const struct geometry *lo, const struct geometry *hi, const struct between *at,
                        real tilt, struct tilt least, real c)
{
    const real g = strip_sink(lo, at->lo), h = lo->h.y - strip_fall(lo, at->lo);
    const real u[] = {lo->c.x / lo->c.y, hi->c.x / hi->c.y};
    const real part =
                   fmax(strip_least_advance(lo, true, least) / u[0], hi->detaches ? sqrt(lo->d / lo->L) : 0),
               falls = hi->weight * g * (1 - c - part);
    real most = -(real)INFINITY;
    for (int k = 0; k < 2; k++)
        most = fmax(most, u[k] * (lo->weight * tilt * fmax(h * part - lo->q * g / u[k], 0) - falls));
    return g >= 0 && falls > 0 ? most : (real)INFINITY;
}

/* Adds bounds on the terms of the followers behind the last one visited. */
static void strip_tail(const struct geometry *lo, const struct geometry *hi, const struct between *at,
                       real weight, real slope, real contact_slope, struct strip_sums *s)
{
    real next = strip_advance(lo, hi, at->lo),
         u = contact_slope == 0 ? next : fmax(next + contact_slope * s->advance, next / (1 - contact_slope));
    real h = fmax(lo->h.y - strip_fall(lo, at->lo), 0), far = strip_sink(lo, hi->f);
    s->drops += slope == 0 ? 0 : weight * s->tilt * slope * h * u / (1 - lo->weight * contact_slope);
    s->far_rests = weight * far * u;
}

/* Returns an upper bound on rises - falls, or infinity if none is known. */
static real slope_safe(real rises, real falls)
{
    const real slope = rises + fabs(rises) * STRIP_SLACK - falls;
    return isfinite(slope) ? slope : (real)INFINITY;
}

static void strip_finish(const struct geometry *lo, const struct geometry *hi, enum dom_fuel fuel,
                         const struct upright *a, const struct upright *b, const struct between *first,
                         const struct strip_sums *sums, struct strip *s)
{
    real inertia_ratio_least = b->inertia_ratio, inertia_ratio_most = a->inertia_ratio + a->inertia_tail,
         fallen = -expm1(-hi->q * log1p(hi->r - 1));
    real D_most = hi->rq / inertia_ratio_least + hi->rq_1, D_least = lo->rq / inertia_ratio_most + lo->rq_1;
    s->kinetic_least = sums->least / D_most * (1 - STRIP_SLACK);
    s->kinetic_most = sums->most > 0 ? sums->most / D_least * (1 + STRIP_SLACK) : 0;
    s->drops = (sums->first_drops + sums->drops) * (1 + STRIP_SLACK);
    /* T r^(q+1) decreases with r. So d ln D / d ln r is at least (2 q + 1 + q T) / (1 + (1 - w) T). This
     * fraction is monotone in T, so it is smallest at the smallest or at the largest T. */
    real q = lo->q, ages = fmin((2 * q + 1 + q * inertia_ratio_least) / (1 + fallen * inertia_ratio_least),
                                (2 * q + 1 + q * inertia_ratio_most) / (1 + fallen * inertia_ratio_most));
    real c = fallen * inertia_ratio_most / (1 + fallen * inertia_ratio_most);
    real kinetic = fmax(s->kinetic_least, 0), rests, head;
    if (fuel == DOM_FUEL_PAPER) { /* P = 1 - h(theta_f) depends on r only through theta_f */
        rests = hi->detaches ? strip_sink(hi, hi->f) * strip_advance(lo, hi, hi->leave) / D_least : 0;
        head = sums->first_drops;
        c = 0;
    } else { /* far_rests is multiplied by c / (1 - w), which is at most T */
        rests = c * sums->rests + inertia_ratio_most * sums->far_rests - q * sums->ages / D_most;
        head = sums->first_drops + c * sums->first_rests;
    }
    s->margin_slope = slope_safe(sums->drops + head + rests, kinetic * ages);
    s->root_slope = s->margin_slope;
    if (s->margin_slope < 0)
        return;
    const struct tilt least = strip_least_top(lo, hi, kinetic, s->grows);
    const real by_tilt = strip_first(lo, hi, first, sums->tilt, least, c);
    s->root_slope = fmin(s->margin_slope, slope_safe(sums->drops + by_tilt + rests, kinetic * ages));
}

/*
 * Returns tan(t / 2), where t is an upper bound on the tilt of the head at the maximum of H. Without
 * followers, the maximum is at theta_u. If all followers are beyond theta_u, they lose energy as they fall,
 * so the maximum is at a smaller tilt. At the maximum dH/dtheta is 0, so
 *
 *     sqrt(1 + d^2) sin(theta_u - theta) = sum r^(-q i) theta_i' g(theta_i).
 *
 * No term of the sum is negative, so the sum is at least its first term. Each factor of the first term is
 * replaced by a lower bound, which comes from one end of the strip.
 */
static real strip_top(const struct geometry *lo, const struct geometry *hi, struct tilt first)
{
    if (!(strip_sink(lo, lo->c) > 0))
        return half_of_tilt(hi->c);
    const real last = geometry_half_u(lo), pull = hi->weight * strip_sink(lo, first) / (2 * lo->steepest);
    real top = last;
    for (int k = 0; k < 2 && top > 0; k++) {
        const struct tilt head = tilt_half(top);
        if (hi->detaches && head.v >= hi->leave.v)
            break;
        /* `below` is a lower bound on (theta_u - theta) / 2, since theta_1' decreases with the tilt of the
         * head. It is also a lower bound on tan((theta_u - theta) / 2), since the tangent of an angle is
         * larger than the angle. */
        const real below = geometry_contact(hi, head).slope * pull;
        top = fmax(last - below, 0) / (1 + last * below);
    }
    return top;
}

/* Counts the work of n steps along both chains. One step takes about as long as twelve dominoes of a plain
 * pass, so each step adds 12 to the effort. */
static void strip_count(const struct geometry *lo, size_t n)
{
    chain_count(lo, 2 * n);
    if (lo->effort)
        *lo->effort += 10 * n;
}

KERNEL enum dom_status strip_walk(const struct geometry *lo, const struct geometry *hi, enum dom_fuel fuel,
                                  real enough, real tol, struct strip *strip)
{
    struct upright a = {.link = link_head(lo, standing), .weight = 1, .inertia = 1};
    struct upright b = {.link = link_head(hi, standing), .weight = 1, .inertia = 1};
    struct strip_sums sums = {.advance = strip_advance(lo, hi, standing)};
    struct strip s = {.grows = 1};
    real most = barrier_most(lo);
    tol = fmax(tol, 64 * REAL_EPSILON);
    real paper = fuel == DOM_FUEL_PAPER ? lo->law->paper_fuel(lo) : 0;
    upright_next(&a, lo);
    upright_next(&b, hi);
    struct between at = between_of(lo, a.link.tilt, b.link.tilt);
    const real half_top = strip_top(lo, hi, at.lo);
    sums.tilt = 2 * atan(half_top);
    const struct between first = at;
    /* true if no domino of the train at lo gets beyond theta_u, so that this train has no fuel */
    bool never = strip_sink(lo, lo->f) <= 0;
    if (strip_sink(lo, hi->f) <= 0) {
        *strip = (struct strip){.kinetic_least = -(real)INFINITY,
                                .grows = (real)INFINITY,
                                .drops = (real)INFINITY,
                                .margin_slope = (real)INFINITY,
                                .root_slope = (real)INFINITY};
        return DOM_OK;
    }
    struct tilt highest = tilt_half(half_top);
    struct link top = link_head(hi, highest);
    bool early = strip_sink(lo, at.lo) < 0;
    sums.least_advance = strip_least_advance(lo, lo->r < hi->r, highest);
    if (early && top.leads)
        link_next(&top);
    else
        early = false;
    sums.least = at.fall_least;
    sums.most = at.fall_most;
    for (size_t i = 1;; i++) {
        enum dom_status status = chain_watch(lo, i - 1);
        if (status != DOM_OK)
            return status;
        strip_follower(lo, hi, lo->r < hi->r, i, &at, a.weight, a.slope, b.weight, &sums);
        if (i == 1) {
            sums.first_drops = sums.drops;
            sums.first_rests = sums.rests;
            sums.drops = sums.rests = 0;
        }
        real g_lo = strip_sink(lo, at.lo), g_hi = strip_sink(lo, at.hi);
        s.grows = g_lo > 0 ? fmax(s.grows, g_hi / g_lo) : (real)INFINITY;
        /* The dominoes behind this one can still increase sums.least by at most `rest`, and sums.most by at
         * most `rest_hi`. NaN if no bound is known. */
        bool after = g_lo >= 0, settled = after || (never && g_hi >= 0);
        real rest = after ? b.weight * (strip_fall(lo, lo->f) - at.fall_least) : REAL_NAN;
        real rest_hi = settled ? a.weight * fmax(strip_fall(lo, hi->f) - at.fall_most, 0) : REAL_NAN;
        real least = fuel == DOM_FUEL_PAPER ? paper : sums.least;
        real divisor = hi->rq / b.inertia_ratio + hi->rq_1, kinetic = least / divisor * (1 - STRIP_SLACK);
        if (after && kinetic > enough) {
            *strip = (struct strip){.kinetic_least = kinetic, .clear = true};
            strip_count(lo, i);
            return DOM_OK;
        }
        bool ends = a.ended && b.ended;
        /* Rounding errors can keep the tilts from reaching theta_inf, so `small` exceeds these errors. */
        real small = fmax(tol * (fabs(least) + most * divisor), 64 * REAL_EPSILON * a.weight);
        bool done = settled && fmax(after ? rest : 0, rest_hi) <= small &&
                    (never || a.inertia_tail <= tol * a.inertia_ratio) &&
                    b.inertia_tail <= tol * b.inertia_ratio;
        if (ends || done) {
            if (fuel == DOM_FUEL_PAPER) {
                sums.least = paper;
                sums.most = hi->law->paper_fuel(hi);
            } else if (settled) {
                sums.most += rest_hi;
            }
            if (!after) /* the walk has not gone far enough for bounds at lo */
                sums.least = -(sums.drops = (real)INFINITY);
            s.cut = ends ? 0 : a.weight * (strip_fall(lo, hi->f) - at.fall_least);
            strip_tail(lo, hi, &at, a.weight * lo->weight, a.slope * a.contact_slope, a.contact_slope, &sums);
            strip_finish(lo, hi, fuel, &a, &b, &first, &sums, &s);
            strip_count(lo, i);
            *strip = s;
            return DOM_OK;
        }
        sums.advance =
            strip_advance(lo, hi, at.lo) + (a.contact_slope > 0 ? a.contact_slope * sums.advance : 0);
        if (early) {
            sums.least_advance = strip_least_advance(lo, lo->r < hi->r, top.tilt) +
                                 (top.leads ? top.contact_slope * sums.least_advance : 0);
            early = top.leads && g_lo < 0;
            if (early)
                link_next(&top);
        } else {
            sums.least_advance = 0;
        }
        real least_weight = b.weight, most_weight = a.weight;
        upright_next(&a, lo);
        upright_next(&b, hi);
        struct between next = between_of(lo, a.link.tilt, b.link.tilt);
        real more = next.fall_least - at.fall_least, most_more = next.fall_most - at.fall_most;
        sums.least += more * (more > 0 ? least_weight : most_weight);
        sums.most += most_more * (most_more > 0 ? most_weight : least_weight);
        at = next;
    }
}

/*
 * Returns an upper bound on all barriers in the strip. A follower beyond theta_u loses energy, and thus
 * lowers the barrier. Its loss is the integral of w^i theta_i' g(theta_i) over theta. In every train of the
 * strip, this loss is at least the loss at hi divided by `grows`, for two reasons:
 * - theta_i' and w^i are at least as large as at hi.
 * - g(theta_i) at hi is at most `grows` times as large as g(theta_i) in this train. The quotient of these two
 *   values of g is largest when the head is upright, because h/g and d theta_i / dr decrease with theta. For
 *   an upright head, no quotient exceeds `grows`.
 *
 * The energy of the head itself rises by at most `most`.
 */
KERNEL real strip_barrier_most(const struct strip *s, real hi_barrier, real most, real width)
{
    real by_grows = isfinite(s->grows) ? (hi_barrier + s->cut) / s->grows + most * (1 - 1 / s->grows) : most;
    real by_slope = hi_barrier + s->drops * width;
    return fmin(most, fmin(by_grows, isfinite(by_slope) ? by_slope : most)) * (1 + STRIP_SLACK);
}

/* In every train of the strip, the loss of a follower (see strip_barrier_most) is at most `grows` times its
 * loss in the train at lo. */
KERNEL real strip_barrier_least(const struct strip *s, real lo_barrier, real most, real width)
{
    real by_grows = s->grows * lo_barrier - (s->grows - 1) * most - s->cut,
         by_slope = lo_barrier - s->drops * width;
    real least = fmax(isfinite(by_grows) ? by_grows : 0, isfinite(by_slope) ? by_slope : 0);
    return fmax(least, 0) * (1 - STRIP_SLACK);
}
