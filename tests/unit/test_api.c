/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The public API: <domino.h> and <domino_quad.h> give the same numbers, NULL means the defaults, and the
 * simple functions agree with the others. test_refusals.c checks errors.
 */
#include "support.h"
#include <float.h>

/* A question for both headers. */
struct both {
    struct dom_train train;
    struct dom_compute compute;
    struct domq_train trainq;
    struct domq_compute computeq;
};

/* Trains that keep falling, that stop, that have no fuel, that are at the reach, and that have friction: s,
 * r, d, q, mu. */
static const double trains[][5] = {{0.4, 1.5, 0.15, 4, 0},  {0.5, 1.9, 0.15, 3, 0}, {0.3, 2.5, 0.15, 4, 0},
                                   {0.3, 1.1, 1.5, 3, 0},   {0.5, 2, 0.1, 3, 0},    {0.9, 1, 0.02, 5, 0},
                                   {0.4, 1.3, 0.15, 4, 0.2}};
enum { TRAINS = sizeof trains / sizeof *trains };

static struct both both_of(const double p[5], enum dom_precision precision)
{
    struct both b = {dom_train_default(), dom_compute_default(), domq_train_default(),
                     domq_compute_default()};
    b.train.s = p[0];
    b.train.r = p[1];
    b.train.d = p[2];
    b.train.q = p[3];
    b.train.mu = p[4];
    b.compute.precision = b.computeq.precision = precision;
    b.compute.tol = precision == DOM_FLOAT ? 1e-5 : 1e-11;
    b.trainq.s = b.train.s;
    b.trainq.r = b.train.r;
    b.trainq.d = b.train.d;
    b.trainq.q = b.train.q;
    b.trainq.mu = b.train.mu;
    b.computeq.tol = b.compute.tol;
    return b;
}

/* The largest allowed relative difference. */
static const double rounding = DBL_EPSILON;

#define SAME(member) assert_in_both(#member, d.member, q.member, rounding);

/* Calls the function in both headers and compares all members in a list. */
#define FIND(name, type, MEMBERS)                                                                            \
    static enum dom_status both_##name(const struct both *b)                                                 \
    {                                                                                                        \
        struct dom_##type d = {0};                                                                           \
        struct domq_##type q = {0};                                                                          \
        enum dom_status status = dom_##name(&b->train, &b->compute, &d);                                     \
        assert_status(status, domq_##name(&b->trainq, &b->computeq, &q));                                    \
        if (status == DOM_OK || status == DOM_STOPS) {                                                       \
            MEMBERS(SAME)                                                                                    \
        }                                                                                                    \
        return status;                                                                                       \
    }
#define FIND_AT(name, type, MEMBERS)                                                                         \
    static enum dom_status both_##name(const struct both *b, double theta)                                   \
    {                                                                                                        \
        struct dom_##type d = {0};                                                                           \
        struct domq_##type q = {0};                                                                          \
        enum dom_status status = dom_##name(&b->train, &b->compute, theta, &d);                              \
        assert_status(status, domq_##name(&b->trainq, &b->computeq, theta, &q));                             \
        if (status == DOM_OK) {                                                                              \
            MEMBERS(SAME)                                                                                    \
        }                                                                                                    \
        return status;                                                                                       \
    }

/* The same for functions whose result is a number. */
#define FIND_NUMBER(name, PARAMETER, ARGUMENT)                                                               \
    static enum dom_status both_##name(const struct both *b PARAMETER)                                       \
    {                                                                                                        \
        double d = 0;                                                                                        \
        domq_real q = 0;                                                                                     \
        enum dom_status status = dom_##name(&b->train, &b->compute, ARGUMENT & d);                           \
        assert_status(status, domq_##name(&b->trainq, &b->computeq, ARGUMENT &q));                           \
        assert_in_both(#name, d, q, rounding);                                                               \
        return status;                                                                                       \
    }
#define AT_PARAMETER , double theta
#define AT_ARGUMENT  theta,

#define ANGLES(X)  X(theta_c) X(theta_u) X(theta_inf) X(theta_f) X(theta_leave)
#define CONTACT(X) X(theta_1) X(slope) X(arm_a) X(arm_b)
#define ENERGY(X)  X(dH) X(J) X(J0)
#define FUELS(X)   X(exact) X(paper)
#define LAUNCH(X)  X(fuel) X(J0) X(velocity_ratio) X(omegasq) X(kinetic)
#define BARRIER(X) X(theta_m) X(barrier) X(kinetic) X(margin)
#define STATE(X)                                                                                             \
    X(theta)                                                                                                 \
    X(time) X(omegasq) X(kinetic) X(climbed) X(fallen) X(before) X(lost) X(friction_work) X(acceleration)
#define LIMIT(X) X(r_max) X(ends) X(why)
#define BEST(X)  X(s) X(r_max)

/* clang-format off: these macros do not look like functions. */
FIND(angles_find, angles, ANGLES)
FIND_AT(contact_find, contact, CONTACT)
FIND_AT(energy_find, energy, ENERGY)
FIND(fuel_find, fuels, FUELS)
FIND(launch_find, launch, LAUNCH)
FIND(barrier_find, barrier, BARRIER)
FIND_NUMBER(cycle_omegasq, AT_PARAMETER, AT_ARGUMENT)
FIND_NUMBER(cycle_stop, , )
FIND_NUMBER(cycle_duration, , )
FIND_AT(cycle_state, state, STATE)
FIND(limit_rmax, limit, LIMIT)
FIND(limit_pair, limit, LIMIT)
FIND(limit_best, best, BEST)
/* clang-format on */

/* Calls a check for every train in every precision of the machine, */
static void for_all(void (*check)(const struct both *b))
{
    for (int i = 0; i < TRAINS; i++)
        for (enum dom_precision p = DOM_FLOAT; p <= DOM_QUAD; p++)
            if (dom_arithmetic(p)->bits) {
                struct both b = both_of(trains[i], p);
                check(&b);
            }
}

static void check_tilts(const struct both *b)
{
    struct dom_angles angles;
    assert_status(both_angles_find(b), DOM_OK);
    assert_status(dom_angles_find(&b->train, &b->compute, &angles), DOM_OK);
    for (int k = 0; k < 4; k++) {
        double theta = angles.theta_c * k / 4;
        assert_status(both_contact_find(b, theta), DOM_OK);
        assert_status(both_energy_find(b, theta), DOM_OK);
        both_cycle_omegasq(b, theta);
        both_cycle_state(b, theta);
    }
}

TEST(tilts)
{
    for_all(check_tilts);
}

static void check_cycle(const struct both *b)
{
    both_fuel_find(b);
    both_launch_find(b);
    both_barrier_find(b);
    both_cycle_stop(b);
    both_cycle_duration(b);
}

TEST(cycles)
{
    for_all(check_cycle);
}

static void check_growth(const struct both *b)
{
    assert_status(both_limit_rmax(b), DOM_OK);
    assert_status(both_limit_pair(b), b->train.mu > 0 ? both_limit_pair(b) : DOM_OK);
    if (b->compute.precision == DOM_DOUBLE && b->train.mu == 0)
        both_limit_best(b);
}

TEST(growth)
{
    for_all(check_growth);
}

/* ---- Events, walks and forces ---- */

enum { KEPT = 64 };

/* The steps that the visitors of <domino.h> have received. The visitors of <domino_quad.h> compare their own
 * steps with these. */
struct seen {
    struct dom_link link[KEPT];
    struct dom_state state[KEPT];
    struct dom_force force[KEPT];
    int event[KEPT], count, compared;
};

static bool link_seen(const struct dom_link *link, void *context)
{
    struct seen *seen = context;
    seen->link[seen->count++] = *link;
    return seen->count < KEPT;
}

static bool link_same(const struct domq_link *link, void *context)
{
    struct seen *seen = context;
    const struct dom_link d = seen->link[seen->compared++];
    const struct domq_link q = *link;
    SAME(i);
    SAME(theta);
    SAME(slope);
    SAME(arm_a);
    SAME(arm_b);
    SAME(weight);
    return seen->compared < KEPT;
}

static bool state_seen(const struct dom_state *state, const struct dom_event *event, void *context)
{
    struct seen *seen = context;
    seen->event[seen->count] = event ? (int)event->kind : -1;
    seen->state[seen->count++] = *state;
    return seen->count < KEPT;
}

static bool state_same(const struct domq_state *state, const struct domq_event *event, void *context)
{
    struct seen *seen = context;
    assert_int_equal(seen->event[seen->compared], event ? (int)event->kind : -1);
    const struct dom_state d = seen->state[seen->compared++];
    const struct domq_state q = *state;
    STATE(SAME)
    return seen->compared < KEPT;
}

static bool force_seen(const struct dom_force *force, void *context)
{
    struct seen *seen = context;
    seen->force[seen->count++] = *force;
    return seen->count < KEPT;
}

static bool force_same(const struct domq_force *force, void *context)
{
    struct seen *seen = context;
    const struct dom_force d = seen->force[seen->compared++];
    const struct domq_force q = *force;
    SAME(i);
    SAME(force);
    SAME(per_weight);
    SAME(impulse);
    return seen->compared < KEPT;
}

/* Checks that a walk visits the same steps in both headers. */
#define WALK_SAME(walk, visitor, ...)                                                                        \
    do {                                                                                                     \
        static struct seen seen;                                                                             \
        seen.count = seen.compared = 0;                                                                      \
        enum dom_status status = dom_##walk(&b->train, &b->compute, __VA_ARGS__, visitor##_seen, &seen);     \
        assert_status(domq_##walk(&b->trainq, &b->computeq, __VA_ARGS__, visitor##_same, &seen), status);    \
        assert_int_equal(seen.count, seen.compared);                                                         \
    } while (0)

static void check_walks(const struct both *b)
{
    WALK_SAME(chain_walk, link, 0);
    WALK_SAME(cycle_walk, state, 6, DOM_BY_TILT);
    WALK_SAME(cycle_forces, force, 0);
}

static void check_events(const struct both *b)
{
    struct dom_event events[DOM_EVENTS_MAX];
    struct domq_event eventsq[DOM_EVENTS_MAX];
    int count = 0, countq = 0;
    enum dom_status status = dom_cycle_events(&b->train, &b->compute, events, &count);
    assert_status(domq_cycle_events(&b->trainq, &b->computeq, eventsq, &countq), status);
    assert_int_equal(count, countq);
    for (int k = 0; k < count; k++) {
        struct dom_event d = events[k];
        struct domq_event q = eventsq[k];
        SAME(kind);
        SAME(theta);
        SAME(time);
        SAME(domino);
        double theta = -1;
        domq_real wide = -1;
        assert_status(dom_cycle_tilt(&b->train, &b->compute, d.time, &theta),
                      domq_cycle_tilt(&b->trainq, &b->computeq, (domq_real)d.time, &wide));
        assert_in_both("tilt", theta, wide, rounding);
    }
}

static void check_forces(const struct both *b)
{
    struct dom_least_force d = {0};
    struct domq_least_force q = {0};
    assert_status(dom_cycle_least_force(&b->train, &b->compute, &d),
                  domq_cycle_least_force(&b->trainq, &b->computeq, &q));
    SAME(force);
    SAME(theta);
    SAME(domino);
    SAME(impulse);
    {
        struct dom_floor f = {0};
        struct domq_floor fq = {0};
        assert_status(dom_cycle_floor(&b->train, &b->compute, &f),
                      domq_cycle_floor(&b->trainq, &b->computeq, &fq));
        assert_in_both("motion", f.motion, fq.motion, rounding);
        assert_in_both("hit", f.hit, fq.hit, rounding);
        assert_int_equal(f.domino, fq.domino);
    }
    assert_status(dom_train_check(&b->train, &b->compute), domq_train_check(&b->trainq, &b->computeq));
}

TEST(walks)
{
    for_all(check_walks);
    for_all(check_events);
    for_all(check_forces);
}

/* ---- NULL instead of how to compute ---- */

#define SAME_AS_DEFAULT(member) assert_in_both(#member, d.member, q.member, rounding);
#define DEFAULT(name, type, MEMBERS, ...)                                                                    \
    do {                                                                                                     \
        struct dom_##type d = {0}, q = {0};                                                                  \
        assert_status(dom_##name(&train, NULL, __VA_ARGS__ &d), DOM_OK);                                     \
        assert_status(dom_##name(&train, &compute, __VA_ARGS__ &q), DOM_OK);                                 \
        MEMBERS(SAME_AS_DEFAULT)                                                                             \
    } while (0)
#define NUMBER_DEFAULT(name, ...)                                                                            \
    do {                                                                                                     \
        double d = 0, q = 0;                                                                                 \
        assert_status(dom_##name(&train, NULL, __VA_ARGS__ &d), DOM_OK);                                     \
        assert_status(dom_##name(&train, &compute, __VA_ARGS__ &q), DOM_OK);                                 \
        assert_in_both(#name, d, q, rounding);                                                               \
    } while (0)
#define AT_TILT 0.1,

TEST(null_is_the_default)
{
    const struct dom_compute compute = dom_compute_default();
    const struct dom_train train = dom_train_default();
    assert_true(compute.tol == 1e-12 && compute.precision == DOM_DOUBLE);
    assert_true(compute.method == DOM_METHOD_OURS && !compute.work && !compute.interrupt);
    assert_true(domq_compute_default().tol == 1 / (domq_real)1e12);
    assert_status(dom_train_check(&train, NULL), DOM_OK);
    DEFAULT(angles_find, angles, ANGLES, );
    DEFAULT(contact_find, contact, CONTACT, AT_TILT);
    DEFAULT(energy_find, energy, ENERGY, AT_TILT);
    DEFAULT(fuel_find, fuels, FUELS, );
    DEFAULT(launch_find, launch, LAUNCH, );
    DEFAULT(barrier_find, barrier, BARRIER, );
    NUMBER_DEFAULT(cycle_omegasq, AT_TILT);
    NUMBER_DEFAULT(cycle_stop, );
    NUMBER_DEFAULT(cycle_duration, );
    DEFAULT(cycle_state, state, STATE, AT_TILT);
    DEFAULT(limit_rmax, limit, LIMIT, );
    DEFAULT(limit_pair, limit, LIMIT, );
    DEFAULT(limit_best, best, BEST, );
    struct both b = {train, compute, domq_train_default(), domq_compute_default()};
    static struct seen seen, of_null;
    assert_status(dom_chain_walk(&b.train, NULL, 0.1, link_seen, &of_null), DOM_OK);
    assert_status(dom_chain_walk(&b.train, &compute, 0.1, link_seen, &seen), DOM_OK);
    assert_int_equal(of_null.count, seen.count);
}
