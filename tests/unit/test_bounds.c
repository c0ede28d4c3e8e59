/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Searches save work by bounds, which are compared here with full computations, with the trains of a strip.
 */
#include "library.h" /* the names of functions that the files of the library share */

#include "request.h"
#include "support.h"

static double uniform(uint64_t *seed, double lo, double hi)
{
    return lo + (hi - lo) * random_unit(seed);
}

/* ---- Strips ---- */

enum { SAMPLES = 6 };

/* A strip of growths, or of separations. */
struct strip_case {
    struct margin_context context;
    bool in_r;
    double lo, hi, other; /* both ends of the strip, and the separation or the growth that is constant */
    struct geometry at_lo, at_hi;
};

/* Returns the margin of a train in the strip and sets *along to its ln r or its s. */
static struct margin margin_in(struct strip_case *c, double share, double *along)
{
    const double at = c->lo * pow(c->hi / c->lo, share);
    c->context.s = c->in_r ? c->other : at;
    *along = c->in_r ? log(at) : at;
    return margin_rough(&c->context, c->in_r ? at : c->other, 1e-11);
}

static bool strip_of(struct strip_case *c, struct strip *strip)
{
    c->at_lo = c->at_hi = c->context.geometry;
    return geometry_set(&c->at_lo, c->in_r ? c->other : c->lo, c->in_r ? c->lo : c->other) == DOM_OK &&
           geometry_set(&c->at_hi, c->in_r ? c->other : c->hi, c->in_r ? c->hi : c->other) == DOM_OK &&
           strip_walk(&c->at_lo, &c->at_hi, c->context.train->fuel, INFINITY, 1e-13, strip) == DOM_OK;
}

/* Checks the bounds of the tilt at which H has its maximum. */
static void top_check(struct strip_case *c, const struct strip *strip, const struct margin *m)
{
    const double kinetic = fmax(strip->kinetic_least, 0), theta_m = c->context.barrier.theta_m;
    assert_true(m->barrier == 0 ||
                theta_m <= 2 * atan(strip_top(&c->at_lo, &c->at_hi, c->at_lo.c)) * (1 + 1e-7));
    if (c->in_r && isfinite(strip->grows) && m->barrier >= kinetic)
        assert_true(theta_m >=
                    (1 - 1e-7) * tilt_angle(strip_least_top(&c->at_lo, &c->at_hi, kinetic, strip->grows)));
}

/* The number of strips, and the number of strips with useful bounds. */
struct strips {
    int all, slopes, grows, close;
};

static void strip_check(struct strip_case *c, const struct strip *strip, struct strips *count)
{
    const double most = barrier_most(&c->context.geometry);
    double along[SAMPLES], slack = 0;
    struct margin m[SAMPLES];
    for (int k = 0; k < SAMPLES; k++) {
        m[k] = margin_in(c, k / (SAMPLES - 1.0), &along[k]);
        if (c->context.status != DOM_OK)
            return;
        top_check(c, strip, &m[k]);
        slack = fmax(slack, 1e-9 * (fabs(m[k].kinetic) + m[k].barrier));
    }
    const double width = along[SAMPLES - 1] - along[0],
                 highest = strip_barrier_most(strip, m[SAMPLES - 1].barrier, most, width),
                 lowest = strip_barrier_least(strip, m[0].barrier, most, width);
    for (int k = 0; k < SAMPLES; k++) {
        assert_true(strip->kinetic_least <= 0 || m[k].kinetic >= strip->kinetic_least - slack);
        assert_true(m[k].kinetic <= strip->kinetic_most + slack);
        assert_true(m[k].barrier <= highest + slack && m[k].barrier >= lowest - slack);
        if (k == 0 || !(m[k - 1].kinetic >= 0 && m[k].kinetic >= 0)) /* without fuel, there is no slope */
            continue;
        const double step = along[k] - along[k - 1], rise = margin_value(&m[k]) - margin_value(&m[k - 1]);
        assert_true(m[k - 1].barrier - m[k].barrier <= strip->drops * step + slack);
        assert_true(!c->in_r || rise <= strip->margin_slope * step + slack);
        if (c->in_r && fmin(m[k].barrier, m[k - 1].barrier) >= strip->kinetic_least)
            assert_true(rise <= strip->root_slope * step + slack);
    }
    count->all++;
    count->slopes += c->in_r && strip->root_slope < 0;
    count->grows += lowest > 0.5 * m[0].barrier && highest < 2 * m[0].barrier;
    count->close += strip->kinetic_least > 0.5 * strip->kinetic_most;
}

TEST(strips_enclose_their_trains)
{
    uint64_t seed = 41;
    struct strips count[2] = {{0}, {0}};
    for (int i = 0; i < 600; i++) {
        struct setup train = setup_default();
        struct strip strip;
        train.s = random_log(&seed, 0.02, 0.9);
        train.d = random_log(&seed, 0.01, 0.5);
        train.q = uniform(&seed, 1, 5);
        train.r = pow(1 / train.s, random_unit(&seed));
        train.fuel = i % 4 == 1 ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
        const struct request request = request_of(&train);
        struct strip_case c = {.context = margin_of_train(&request), .in_r = i % 2};
        const double wide = exp(random_log(&seed, 1e-4, 0.2)), reach = 1 - 1e-9;
        c.lo = c.in_r ? train.r : train.s;
        c.other = c.in_r ? train.s : train.r;
        c.hi = fmin(c.lo * wide, reach / c.other);
        if (c.context.status == DOM_OK && c.hi > c.lo && strip_of(&c, &strip))
            strip_check(&c, &strip, &count[c.in_r]);
    }
    print_message("# %d strips of growths: %d in which the margin decreases at a root, %d with close bounds "
                  "of the barrier, %d of the energy; %d strips of separations: %d with close bounds of the "
                  "barrier, %d of the energy\n",
                  count[1].all, count[1].slopes, count[1].grows, count[1].close, count[0].all, count[0].grows,
                  count[0].close);
    assert_true(count[1].all > 200 && count[1].slopes > 150 && count[1].grows > 100 && count[0].grows > 100);
}
