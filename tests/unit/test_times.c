/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: pictures */
/*
 * Times, tops and verdicts of a cycle in difficult cases: near the launch, near the stop, with a barrier of
 * 0, and with a tolerance so rough that it hides the sign of the margin.
 */
#include "support.h"

static struct setup in_quad(struct setup train)
{
    train.precision = IN_QUAD;
    train.tol = 1e-30;
    return train;
}

/* Returns the largest growth that the reach allows in every precision. */
static double within_reach(const struct setup *train)
{
    return (1 - 1e-14) / (double)train->s;
}

/* Returns a random fraction of the distance to the stop: near the launch, near the stop, or in between. */
static double part_of(uint64_t *seed, int kind)
{
    double close = random_log(seed, 1e-12, 0.5);
    return kind == 0 ? close : kind == 1 ? 1 - close : kind == 2 ? 1 : random_unit(seed);
}

/* Checks that a train that stops has its events in every precision, even with friction and at r s = 1.
 * Without these, its times differ from quad by no more than their error bounds, which are not too wide. */
TEST(times_before_a_stop)
{
    uint64_t seed = 82;
    int stops = 0, at_reach = 0, with_friction = 0, checked = 0;
    double loosest = 0;
    for (int i = 0; i < 1500; i++) {
        struct setup train = random_train(&seed);
        struct domq_state here, there;
        struct domq_event events[DOM_EVENTS_MAX];
        domq_real stop, end;
        int n;
        train.s = random_log(&seed, 0.02, 1);
        train.q = i % 3 ? 3 : train.q;
        train.mu = i % 2 ? random_log(&seed, 1e-3, 1) : 0;
        train.r = i % 5 == 0 ? 1 / train.s : pow(1 / (double)train.s, random_unit(&seed));
        train.precision = i % 7 == 0 ? IN_QUAD : i % 3 == 0 ? IN_FLOAT : IN_DOUBLE;
        train.tol = train.precision == IN_FLOAT ? 1e-5 : 1e-12;
        if (ask_cycle_stop(&train, &stop) != DOM_OK || isnan((double)stop))
            continue;
        enum dom_status status = ask_cycle_events(&train, events, &n);
        if (status == DOM_NO_MARGIN)
            continue;
        if (status != DOM_STOPS)
            fail_train(dom_status_text(status), &train, 0, 0);
        assert_true(events[n - 1].kind == DOM_EVENT_STOP && events[n - 1].theta == stop);
        if (!isfinite((double)events[n - 1].time) || events[n - 1].time <= 0)
            fail_train("time", &train, (double)events[n - 1].time, 0);
        stops++;
        at_reach += i % 5 == 0;
        with_friction += train.mu > 0;
        if (train.precision != IN_DOUBLE || train.mu > 0 || i % 5 == 0)
            continue;
        const int kind = i / 2 % 4;
        double theta = (double)stop * part_of(&seed, kind);
        status = ask_cycle_state(&train, theta, &here);
        if (status == DOM_NO_MARGIN)
            continue;
        if (status != DOM_OK)
            fail_train(dom_status_text(status), &train, 0, 0);
        struct setup fine = in_quad(train);
        /* Because of rounding, the stop in double may be after the true stop. In that case the time of the
         * true stop is expected. */
        assert_status(ask_cycle_stop(&fine, &end), DOM_OK);
        assert_status(ask_cycle_state(&fine, theta < end ? theta : end, &there), DOM_OK);
        double off = fabs((double)(here.time - there.time));
        if (!(off <= 1e-5 * (double)there.time))
            fail_train("time", &train, (double)here.time, (double)there.time);
        struct domq_barrier b;
        assert_status(ask_barrier_find(&train, &b), DOM_STOPS);
        /* Near the launch no digits are lost, unless the margin is small. */
        if (kind == 0 && -b.margin > b.kinetic / 100)
            loosest = fmax(loosest, off / (double)there.time);
        checked++;
    }
    print_message(
        "# %d stops, %d at the reach, %d with friction; %d times, largest error near the launch %.1e\n",
        stops, at_reach, with_friction, checked, loosest);
    assert_true(stops > 100 && at_reach > 25 && with_friction > 40 && checked > 75 && loosest < 1e-9);
}

/* Checks that the time is theta / omega(0) just after the launch of a train that stops. */
TEST(first_moment)
{
    struct setup train = setup_default();
    struct domq_launch launch;
    struct domq_state s;
    train.r = 1.7;
    assert_status(ask_launch_find(&train, &launch), DOM_OK);
    for (double theta = 1e-10; theta > 1e-30; theta /= 100)
        for (int p = IN_FLOAT; p <= IN_QUAD; p++) {
            train.precision = (enum precision)p;
            train.tol = any_arithmetic(train.precision).tol_default;
            assert_status(ask_cycle_state(&train, theta, &s), DOM_OK);
            /* The angular velocity of the head decreases by about 11 theta, relative to its value at the
             * launch. */
            assert_near("time", (double)s.time, theta / sqrt((double)launch.omegasq),
                        fmax(20 * theta, p == IN_FLOAT ? 1e-5 : 1e-12));
        }
}

/* Finds by bisection the growth at which the maximum of H moves away from theta = 0. */
static double vanishing(struct setup train)
{
    double lo = 1, hi = 1 / (double)train.s;
    for (int i = 0; i < 100; i++) {
        struct domq_barrier b;
        train.r = (lo + hi) / 2;
        ask_barrier_find(&train, &b);
        *(b.theta_m > 0 ? &hi : &lo) = (double)train.r;
    }
    return lo;
}

/* Checks that theta_m is within its error bound if the barrier vanishes, so that H' is nearly 0 at the
 * launch. */
TEST(tops_that_vanish)
{
    uint64_t seed = 83;
    int checked = 0, small = 0;
    for (int i = 0; i < 300; i++) {
        struct setup train = random_train(&seed);
        train.tol = 1e-12;
        train.s = random_log(&seed, 0.05, 1);
        double root = vanishing(train);
        train.r = fmin(fmax(root * (1 + (random_unit(&seed) - 0.5) * random_log(&seed, 1e-16, 1e-6)), 1),
                       within_reach(&train));
        struct setup fine = in_quad(train);
        struct domq_barrier b, expected;
        enum dom_status status = ask_barrier_find(&train, &b);
        assert_true(status == DOM_OK || status == DOM_STOPS || status == DOM_NO_FUEL);
        status = ask_barrier_find(&fine, &expected);
        assert_true(status == DOM_OK || status == DOM_STOPS || status == DOM_NO_FUEL);
        /* There may be two tops whose heights are equal up to rounding. */
        if (fabs((double)(b.theta_m - expected.theta_m)) > 1e-3)
            continue;
        double off = fabs((double)(b.theta_m - expected.theta_m));
        if (!(off <= 1e-10 * (double)expected.theta_m + 1e-16))
            fail_train("theta_m", &train, (double)b.theta_m, (double)expected.theta_m);
        if (!(fabs((double)(b.barrier - expected.barrier)) <=
              1e-11 * (double)expected.barrier + 1e-15 * (double)b.theta_m))
            fail_train("barrier", &train, (double)b.barrier, (double)expected.barrier);
        checked++;
        small += b.theta_m < 1e-6;
    }
    print_message("# %d tops, %d below 1e-6\n", checked, small);
    assert_true(checked > 200 && small > 50);
}

/* Checks that all functions about a cycle give the expected verdict: DOM_OK, DOM_STOPS, or another status. */
static void one_verdict(const struct setup *train, enum dom_status expected)
{
    struct domq_angles angles;
    struct domq_event events[DOM_EVENTS_MAX];
    struct domq_state s;
    struct domq_barrier b;
    domq_real stop, w, time;
    int n;
    assert_status(ask_angles_find(train, &angles), DOM_OK);
    enum dom_status verdict = ask_barrier_find(train, &b);
    if (verdict != expected)
        fail_train(dom_status_text(verdict), train, (double)b.kinetic, (double)b.barrier);
    assert_status(ask_cycle_stop(train, &stop), DOM_OK);
    assert_int_equal(isnan((double)stop), expected == DOM_OK);
    assert_status(ask_cycle_omegasq(train, angles.theta_c, &w), expected);
    assert_status(ask_cycle_omegasq(train, b.theta_m, &w), expected);
    enum dom_status status = ask_cycle_duration(train, &time);
    if (status != DOM_NO_MARGIN)
        assert_status(status, expected);
    status = ask_cycle_events(train, events, &n);
    if (status == DOM_NO_MARGIN)
        return;
    if (status != expected)
        fail_train(dom_status_text(status), train, (double)b.kinetic, (double)b.barrier);
    assert_status(ask_cycle_state(train, angles.theta_c, &s), expected);
    assert_int_equal(events[n - 1].kind, expected == DOM_OK ? DOM_EVENT_HIT : DOM_EVENT_STOP);
    if (expected == DOM_STOPS) { /* the train reaches its stop, but no larger tilt */
        assert_status(ask_cycle_omegasq(train, stop, &w), DOM_OK);
        assert_true(w == 0);
        assert_status(ask_cycle_state(train, stop, &s), DOM_OK);
        assert_true(s.omegasq == 0);
        assert_status(ask_cycle_omegasq(train, stop * (1 + 1e-5), &w), DOM_STOPS);
    }
}

/* Checks that near r_max all functions give the verdict of quad, with any tolerance. */
TEST(verdicts_near_the_limit)
{
    uint64_t seed = 84;
    int goes = 0, stops = 0;
    for (int i = 0; i < 120; i++) {
        struct setup train = random_train(&seed), fine;
        struct domq_limit limit;
        struct domq_barrier b;
        train.tol = 1e-12;
        train.s = random_log(&seed, 0.02, 0.6);
        train.mu = i % 4 ? 0 : random_log(&seed, 1e-3, 0.5);
        if (ask_limit_rmax(&train, &limit) != DOM_OK || limit.ends != DOM_END_BARRIER)
            continue;
        train.r = limit.r_max * (1 + (random_unit(&seed) < 0.5 ? -1 : 1) * random_log(&seed, 1e-9, 1e-4));
        train.r = (double)fmax((double)train.r, 1);
        fine = in_quad(train);
        fine.tol = 1e-20;
        enum dom_status expected = ask_barrier_find(&fine, &b);
        if ((expected != DOM_OK && expected != DOM_STOPS) || fabs((double)(b.margin / b.kinetic)) < 1e-11)
            continue;
        const double tols[] = {0.1, 0.01, 1e-3, 1e-5, 1e-8, 1e-12};
        for (int k = 0; k < 6; k++) {
            train.tol = tols[k];
            one_verdict(&train, expected);
        }
        goes += expected == DOM_OK;
        stops += expected == DOM_STOPS;
    }
    print_message("# %d go on, %d stop\n", goes, stops);
    assert_true(goes > 25 && stops > 25);
}

struct seen {
    const struct setup *train;
    int rows, events;
    double before, whole; /* `whole` is the time of the last event */
    bool by_time;
};

static bool state_seen(const struct domq_state *s, const struct domq_event *event, void *context)
{
    struct seen *seen = context;
    struct domq_state alone;
    assert_status(ask_cycle_state(seen->train, s->theta, &alone), DOM_OK);
    double size = fmax((double)alone.time, 1e-300);
    if (fabs((double)(s->time - alone.time)) > 1e-10 * size + 1e-16)
        fail_train("time", seen->train, (double)s->time, (double)alone.time);
    assert_true(s->omegasq == alone.omegasq && s->kinetic == alone.kinetic);
    assert_true((double)s->time >= seen->before);
    seen->before = (double)s->time;
    seen->events += event != NULL;
    seen->rows += !event;
    if (!event && seen->by_time)
        assert_near("steps of equal time", s->time, seen->rows * seen->whole / 6, 1e-9);
    return true;
}

static bool force_seen(const struct dom_force *f, void *context)
{
    double *least = context;
    if (f->per_weight < *least)
        *least = f->per_weight;
    return true;
}

/* Checks that the smallest contact force agrees with the smallest one at 500 tilts of the cycle, between
 * which the force may be slightly smaller. Returns false if there is none. */
static bool force_check(const struct setup *train, double end)
{
    struct domq_least_force found;
    double least = INFINITY;
    assert_status(ask_cycle_least_force(train, &found), DOM_OK);
    for (int k = 0; k <= 500; k++)
        assert_status(ask_cycle_forces(train, fmin(end * k / 500, end), force_seen, &least), DOM_OK);
    if (isinf(least) || least > 1e6)
        return false;
    if (found.force > least + 1e-5 + 1e-5 * fabs(least) || found.force < least - 0.02 * fabs(least) - 1e-3)
        fail_train("least force", train, (double)found.force, least);
    return true;
}

/* Checks that the table of a cycle has the same times and tilts as single answers, that the times are evenly
 * spaced, and that the last one is the duration. Also checks the smallest contact forces. */
TEST(tables_and_answers)
{
    uint64_t seed = 85;
    int tables = 0, forces = 0;
    for (int i = 0; i < 150; i++) {
        struct setup train = random_train(&seed);
        struct domq_event events[DOM_EVENTS_MAX];
        int n;
        train.tol = 1e-12;
        train.s = random_log(&seed, 0.05, 1);
        train.r = fmax(fmin((double)train.r, within_reach(&train)), 1);
        train.mu = i % 3 ? 0 : random_log(&seed, 1e-3, 1);
        enum dom_status expected = ask_cycle_events(&train, events, &n);
        const bool by_time = i % 2 == 0, ends = expected == DOM_OK || expected == DOM_STOPS;
        struct seen seen = {&train, 0, 0, 0, ends ? (double)events[n - 1].time : 0, by_time};
        domq_real duration;
        enum dom_status status =
            ask_cycle_walk(&train, 7, by_time ? DOM_BY_TIME : DOM_BY_TILT, state_seen, &seen);
        assert_status(status, expected);
        if (expected == DOM_OK && ask_cycle_duration(&train, &duration) == DOM_OK)
            assert_near("duration", duration, seen.whole, 1e-9);
        if (!ends)
            continue;
        assert_int_equal(seen.events, n);
        assert_true(seen.rows >= 5 - n);
        tables++;
        if (train.r * train.s < 0.95)
            forces += force_check(&train, (double)events[n - 1].theta);
    }
    print_message("# %d tables, %d least forces\n", tables, forces);
    assert_true(tables > 50 && forces > 30);
}
