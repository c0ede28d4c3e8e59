/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: pictures */
/* Trains with friction between dominoes. */
#include "support.h"
#include <float.h>
#include <stddef.h>
#include <string.h>

static struct setup friction_train(double s, double r, double mu)
{
    struct setup train = setup_default();
    train.s = s;
    train.r = r;
    train.mu = mu;
    return train;
}

/* Returns a random train with friction and r s <= 1, which may keep falling or stop. */
static struct setup random_friction_train(uint64_t *seed, double s_least, double mu_most)
{
    double s = random_log(seed, s_least, 1);
    struct setup train = friction_train(s, 1 + (fmin(3, 1 / s) - 1) * random_unit(seed), 0);
    train.d = random_log(seed, 0.01, 0.5);
    train.q = 1 + 4 * random_unit(seed);
    train.mu = random_log(seed, 1e-6, mu_most);
    return train;
}

/* ---- Digits ---- */

/*
 * Compares with tests/reference/friction.csv, which was computed as follows. (A/2) w' + B w = C is solved in
 * 32-digit arithmetic (mpmath). A, B and C are summed domino by domino to 1e-30, with angles and
 * trigonometric functions. The equation is integrated for W and G together by Gauss collocation with 10
 * stages (order 20), piece by piece between the tilts at which a follower detaches, in 90 steps for the
 * points and in 7 for r_max. The duration comes from the same nodes. r_max is the zero, found by the secant
 * method to 1e-20, of the smallest w of the repeating cycle, which is at a zero of C or at theta_c. With 60
 * and 4 steps no number changed by more than 3e-15, and most changed by less than 1e-19. At tol = 1e-13, the
 * flow is right to tol / 8 and each sum has about 64 rounding errors, so the points are compared to 1e-12. At
 * r_max the margin changes its sign with a slope of the order of the kinetic energy, so that 1e-11 leaves a
 * factor of ten.
 */
TEST(digits)
{
    int rows = 0;
    struct csv *csv = csv_open("tests/reference/friction.csv");
    for (; csv_next(csv); rows++) {
        struct setup train = csv_train(csv);
        struct domq_limit limit;
        struct domq_launch launch;
        domq_real w, duration;
        train.d = csv_number(csv, "d");
        train.mu = csv_number(csv, "mu");
        train.tol = 1e-13;
        assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
        assert_int_equal(limit.ends, DOM_END_BARRIER);
        assert_near("r_max", limit.r_max, csv_number(csv, "r_max"), 1e-11);
        train.r = csv_number(csv, "r");
        assert_status(ask_launch_find(&train, &launch), DOM_OK);
        assert_near("omegasq_0", launch.omegasq, csv_number(csv, "omegasq_0"), 1e-12);
        assert_status(ask_cycle_omegasq(&train, csv_number(csv, "theta_1"), &w), DOM_OK);
        assert_near("omegasq_1", w, csv_number(csv, "omegasq_1"), 1e-11);
        assert_status(ask_cycle_omegasq(&train, csv_number(csv, "theta_2"), &w), DOM_OK);
        assert_near("omegasq_2", w, csv_number(csv, "omegasq_2"), 1e-11);
        assert_status(ask_cycle_duration(&train, &duration), DOM_OK);
        assert_near("duration", duration, csv_number(csv, "duration"), 1e-11);
    }
    assert_int_equal(rows, 26);
}

TEST(minus_zero_is_no_friction)
{
    struct setup train = friction_train(0.2, 1.2, 0);
    struct domq_barrier barrier[2];
    domq_real duration[2];
    for (int k = 0; k < 2; k++, train.mu = -0.0) {
        assert_status(ask_barrier_find(&train, &barrier[k]), DOM_OK);
        assert_status(ask_cycle_duration(&train, &duration[k]), DOM_OK);
    }
    assert_true(barrier[0].margin == barrier[1].margin && duration[0] == duration[1]);
}

/* ---- The work of friction ---- */

enum { CHAIN_MOST = 4096 };

/* A moving train at one tilt, as the public functions describe it. */
struct chain {
    size_t n, forces;
    double theta[CHAIN_MOST], slope[CHAIN_MOST], weight[CHAIN_MOST], force[CHAIN_MOST], impulse[CHAIN_MOST];
};

static bool link_seen(const struct domq_link *link, void *context)
{
    struct chain *c = context;
    c->theta[link->i] = link->theta;
    c->slope[link->i] = link->slope;
    c->weight[link->i] = link->weight;
    return (c->n = link->i + 1) < CHAIN_MOST;
}

static bool force_seen(const struct dom_force *force, void *context)
{
    struct chain *c = context;
    c->force[force->i] = force->force;
    c->impulse[force->i] = force->impulse;
    return (c->forces = force->i + 1) < CHAIN_MOST;
}

static void chain_at(const struct setup *train, double theta, struct chain *c)
{
    assert_status(ask_chain_walk(train, theta, link_seen, c), DOM_OK);
    assert_status(ask_cycle_forces(train, theta, force_seen, c), DOM_OK);
}

/*
 * Returns the derivative of the work of friction with respect to the tilt of the head, in m g h / 2 of the
 * head. It is the sum over the contacts of mu times the contact force times dp/dtheta, where p = h_follower
 * cos(theta' - theta) - L_leader sin theta is the distance of the follower's tip from the hinge of its
 * leader.
 */
static double friction_work_at(const struct setup *train, double theta)
{
    static struct chain c;
    double sum = 0, size = 1, r = train->r, L = (double)train->s + (double)train->d;
    chain_at(train, theta, &c);
    for (size_t i = 0; i + 1 < c.n && i + 1 < c.forces; i++, size /= r) {
        double turn = c.theta[i + 1] - c.theta[i], turned = c.slope[i + 1] - c.slope[i];
        double slides = -size / r * sin(turn) * turned - L * size * cos(c.theta[i]) * c.slope[i];
        sum += c.force[i] * fabs(slides);
    }
    return 2 * (double)train->mu * sum;
}

/* Integrates by Gauss's ten-point rule on `parts` equal parts. */
static double integral(const struct setup *train, double lo, double hi, int parts)
{
    static const double place[] = {0.14887433898163121, 0.43339539412924719, 0.67940956829902441,
                                   0.86506336668898451, 0.97390652851717172},
                        share[] = {0.29552422471475287, 0.26926671930999636, 0.21908636251598204,
                                   0.14945134915058059, 0.066671344308688138};
    double sum = 0, half = (hi - lo) / parts / 2;
    for (int k = 0; k < parts; k++)
        for (int j = 0; j < 5; j++)
            for (int side = -1; side <= 1; side += 2)
                sum += half * share[j] *
                       friction_work_at(train, lo + (2 * k + 1) * half + side * half * place[j]);
    return sum;
}

/*
 * Checks that friction_work is the work of friction. The integrand has a kink where a follower detaches, so
 * it is integrated from event to event. The error of the integral is below 1e-9. Forces at a stop are
 * ill-conditioned and are not checked.
 */
TEST(friction_takes_its_work)
{
    uint64_t seed = 51;
    int checked = 0, falls = 0;
    for (int i = 0; i < 150; i++) {
        struct setup train = random_friction_train(&seed, 0.1, 2);
        struct domq_event events[DOM_EVENTS_MAX];
        struct domq_state s;
        int n;
        train.mu = fmax(train.mu, 0.01);
        train.r = fmax(fmin(train.r, 0.95 / (double)train.s), 1);
        if (ask_cycle_events(&train, events, &n) != DOM_OK)
            continue;
        double friction_work = 0;
        for (int k = 0; k < n; k++) {
            assert_status(ask_cycle_state(&train, events[k].theta, &s), DOM_OK);
            if (k > 0)
                friction_work += integral(&train, events[k - 1].theta, events[k].theta, 4);
            if (!(fabs(friction_work - (double)s.friction_work) <=
                  1e-9 * (double)(s.before + fabs((double)s.climbed))))
                fail_train("the work of friction", &train, s.friction_work, friction_work);
            falls += events[k].kind == DOM_EVENT_DETACH;
            checked++;
        }
        /* Just before the hit, the hitting train is this train at theta_c, with its energies multiplied by
         * r^-q. */
        assert_near("before", s.before, pow(train.r, -train.q) * s.kinetic, 1e-9);
    }
    assert_true(checked > 100 && falls > 10);
}

/* ---- Tolerance ---- */

/* Checks float near 1 - r s = 0.01, where rounding leaves few correct digits of the sums. The scan for r_max
 * meets this case. */
TEST(float_near_the_reach)
{
    struct setup train = friction_train((double)0.54788214F, 1, (double)0.0312876888F);
    struct domq_limit limit;
    struct domq_launch launch;
    train.d = 0.0992909595F;
    train.q = 3.49999905F;
    train.precision = IN_FLOAT;
    train.tol = any_arithmetic(IN_FLOAT).tol_default;
    for (int k = 0; k <= 40; k++) {
        train.r = (1 - pow(10, -1 - k / 20.0)) / (double)train.s;
        assert_status(ask_launch_find(&train, &launch), DOM_OK);
    }
    assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
}

/* Checks that errors are within ten times the tolerance, since the launch and the margin amplify errors of
 * the flow. */
TEST(tolerance_is_kept)
{
    static const double tols[] = {1e-3, 1e-5, 1e-7, 1e-9};
    uint64_t seed = 54;
    int checked = 0;
    for (int i = 0; i < 150; i++) {
        struct setup train = random_friction_train(&seed, 0.02, 2);
        struct domq_launch exact, rough;
        if (ask_launch_find(&train, &exact) != DOM_OK)
            continue;
        for (int k = 0; k < 4; k++) {
            train.tol = tols[k];
            assert_status(ask_launch_find(&train, &rough), DOM_OK);
            /* An error of G is weighted with the part of a cycle's energy that carries over to the next
             * cycle. */
            double errs = fabs((double)(rough.kinetic / exact.kinetic) - 1);
            if (!(errs <= 10 * tols[k] * (double)train.r))
                fail_train("kinetic at a tolerance", &train, rough.kinetic, exact.kinetic);
            checked++;
        }
    }
    assert_true(checked > 100);
}

/* ---- Verdicts ---- */

TEST(refusals)
{
    struct setup train = friction_train(0.4, 1.3, 0.1);
    struct domq_launch launch;
    struct domq_barrier barrier;
    struct domq_limit limit;
    train.fuel = DOM_FUEL_PAPER;
    assert_status(ask_launch_find(&train, &launch), DOM_NO_METHOD);
    assert_status(ask_barrier_find(&train, &barrier), DOM_NO_METHOD);
    assert_status(ask_limit_rmax(&train, &limit), DOM_NO_METHOD);
    train.fuel = DOM_FUEL_EXACT;
    /* The train locks in the hit. The sums for the motion after the hit, which would be infinite, must not
     * hide this. */
    train = friction_train(0.10240983347041695, 2.2984965160834889, 11.465967489938446);
    train.d = 0.61451534241036898;
    train.q = 2.9636499594514638;
    assert_status(ask_launch_find(&train, &launch), DOM_LOCKS);
    /* The arm of the contact force is Y / r, and the arm of the friction is mu d. The train locks if these
     * are equal. */
    train = friction_train(0.5, 1, 1);
    train.d = 0.1;
    double edge = sqrt(1 / (0.01 + 0.25)); /* sqrt(1 - r^2 s^2) / r = mu d */
    train.r = edge * (1 - 1e-6);
    assert_status(ask_launch_find(&train, &launch), DOM_OK);
    assert_true(launch.velocity_ratio > 0 && launch.velocity_ratio < 1e-4);
    assert_status(ask_barrier_find(&train, &barrier), DOM_STOPS);
    train.r = edge * (1 + 1e-6);
    assert_status(ask_launch_find(&train, &launch), DOM_LOCKS);
    assert_status(ask_barrier_find(&train, &barrier), DOM_LOCKS);
    /* If equal dominoes lock, there is no largest growth. */
    train = friction_train(0.25, 1, 100);
    train.d = 0.0167772;
    assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
    assert_true(limit.ends == DOM_END_NONE && isnan((double)limit.r_max));
    assert_status(limit.why, DOM_LOCKS);
}

/* Checks that r_max decreases with mu and is never the reach, and that trains keep falling 1e-6 below r_max
 * and stop 1e-6 above it. */
TEST(growth_falls_with_friction)
{
    uint64_t seed = 57;
    int met = 0, none = 0;
    for (int i = 0; i < 60; i++) {
        struct setup train = random_friction_train(&seed, 0.02, 3);
        double before = INFINITY, mu = train.mu;
        for (int k = 0; k < 3; k++) {
            struct domq_limit limit;
            struct domq_barrier barrier;
            train.mu = mu * (k == 0 ? 1 : k == 1 ? 1.01 : 2);
            assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
            assert_true(limit.ends == DOM_END_NONE || limit.ends == DOM_END_BARRIER);
            double r_max = limit.ends == DOM_END_NONE ? 0 : (double)limit.r_max;
            if (!(r_max < before || (r_max == 0 && before == 0)))
                fail_train("growth with more friction", &train, r_max, before);
            before = r_max;
            none += limit.ends == DOM_END_NONE;
            if (r_max == 0 || r_max * (1 - 1e-6) < 1)
                continue;
            train.r = r_max * (1 - 1e-6);
            assert_status(ask_barrier_find(&train, &barrier), DOM_OK);
            train.r = fmin(r_max * (1 + 1e-6), 1 / (double)train.s);
            enum dom_status above = ask_barrier_find(&train, &barrier);
            assert_true(above == DOM_STOPS || above == DOM_LOCKS);
            met++;
        }
    }
    assert_true(met > 60 && none > 5);
}
