/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: pictures */
/* One cycle in time: events, times, the balance of energy, accelerations and contact forces. */
#include "support.h"
#include <float.h>

/* Makes the next random train that completes its cycle or stops in it. Trains without fuel are skipped. */
static bool next_train(uint64_t *seed, struct setup *train, struct domq_event *events, int *count)
{
    *train = random_train(seed);
    train->tol = 1e-13;
    train->r = fmin((double)train->r, 1 + 2 * random_unit(seed));
    train->s = fmax((double)train->s, 0.02);
    if (train->r * train->s > 1)
        return false;
    enum dom_status status = ask_cycle_events(train, events, count);
    return status == DOM_OK || status == DOM_STOPS;
}

/* Makes the next random train. The kinds of trains take turns: without effects, with friction, on a slope,
 * with friction on a slope, and with rounded edges. */
static bool next_with_effects(uint64_t *seed, int i, struct setup *train, struct domq_event *events,
                              int *count)
{
    if (!next_train(seed, train, events, count) || train->s < 0.05)
        return false;
    if (i % 5 == 1 || i % 5 == 3)
        train->mu = random_log(seed, 0.01, 1);
    if (i % 5 == 2 || i % 5 == 3)
        train->alpha = 0.5 * (2 * random_unit(seed) - 1) * atan((double)train->d);
    if (i % 5 == 4)
        train->rho = 0.4 * (double)train->d * random_unit(seed);
    enum dom_status status = ask_cycle_events(train, events, count);
    return status == DOM_OK || status == DOM_STOPS;
}

/* Returns true if an event, at which accelerations jump, is within a distance of the tilt. */
static bool near_event(const struct domq_event *events, int n, double theta, double distance)
{
    for (int k = 1; k + 1 < n; k++)
        if (fabs((double)events[k].theta - theta) < distance)
            return true;
    return false;
}

TEST(events_are_in_order)
{
    uint64_t seed = 41;
    int stops = 0, falls = 0, tops = 0, hits = 0;
    for (int i = 0; i < 400; i++) {
        struct setup train;
        struct domq_event events[DOM_EVENTS_MAX];
        struct domq_barrier barrier;
        struct domq_angles angles;
        int n;
        if (!next_train(&seed, &train, events, &n))
            continue;
        assert_true(n >= 2 && n <= DOM_EVENTS_MAX);
        assert_true(events[0].kind == DOM_EVENT_LAUNCH && events[0].theta == 0 && events[0].time == 0);
        for (int k = 1; k < n; k++)
            assert_true(events[k].theta >= events[k - 1].theta && events[k].time >= events[k - 1].time);
        bool good = ask_barrier_find(&train, &barrier) == DOM_OK;
        assert_status(ask_angles_find(&train, &angles), DOM_OK);
        assert_true(events[n - 1].kind == (good ? DOM_EVENT_HIT : DOM_EVENT_STOP));
        if (good)
            assert_near("hit", events[n - 1].theta, angles.theta_c, 1e-15);
        else
            assert_true(events[n - 1].theta < barrier.theta_m);
        for (int k = 1; k < n; k++) {
            stops += events[k].kind == DOM_EVENT_STOP;
            hits += events[k].kind == DOM_EVENT_HIT;
            falls += events[k].kind == DOM_EVENT_DETACH;
            tops += events[k].kind == DOM_EVENT_TOP;
            if (events[k].kind == DOM_EVENT_DETACH) {
                /* The leader of the domino has reached theta_leave, and the domino has the tilt theta_f. */
                struct domq_contact c = {.theta_1 = events[k].theta};
                for (size_t j = 1; j < events[k].domino; j++)
                    assert_status(ask_contact_find(&train, fmin(c.theta_1, angles.theta_c), &c), DOM_OK);
                double leader = events[k].domino == 1 ? (double)events[k].theta : (double)c.theta_1;
                assert_near("leader", leader, angles.theta_leave, 1e-12);
            }
        }
    }
    print_message("# %d stops, %d hits, %d falls, %d tops\n", stops, hits, falls, tops);
    assert_true(stops > 10 && hits > 10 && falls > 10 && tops > 10);
}

/* Checks before - lost - climbed - friction_work = kinetic, at every event and between events, and that the
 * acceleration is half the derivative of omegasq, by a central difference. */
TEST(ledger_closes)
{
    uint64_t seed = 42;
    int checked[5] = {0}, slopes[5] = {0};
    for (int i = 0; i < 600; i++) {
        const double loose = i % 5 ? 10 : 1;
        struct setup train;
        struct domq_event events[DOM_EVENTS_MAX];
        struct domq_state s, below, above;
        int n;
        if (!next_with_effects(&seed, i, &train, events, &n))
            continue;
        for (int k = 0; k < 2 * n - 1; k++) {
            double theta = k % 2 ? ((double)events[k / 2].theta + (double)events[k / 2 + 1].theta) / 2
                                 : (double)events[k / 2].theta;
            assert_status(ask_cycle_state(&train, theta, &s), DOM_OK);
            double size = (double)s.before + fabs((double)s.climbed);
            double open = (double)(s.before - s.lost - s.climbed - s.friction_work - s.kinetic);
            if (!(fabs(open) <= 1e-12 * loose * size))
                fail_train("the ledger", &train, open / size, 0);
            assert_true(train.mu > 0 ? s.friction_work >= 0 : s.friction_work == 0);
            if (k % 2 == 0)
                assert_near("time", s.time, events[k / 2].time, 1e-10);
            checked[i % 5]++;
        }
        const double end = (double)events[n - 1].theta, theta = (0.1 + 0.8 * random_unit(&seed)) * end,
                     h = 1e-4 * end;
        if (near_event(events, n, theta, 20 * h))
            continue;
        assert_status(ask_cycle_state(&train, theta, &s), DOM_OK);
        assert_status(ask_cycle_state(&train, theta - h, &below), DOM_OK);
        assert_status(ask_cycle_state(&train, theta + h, &above), DOM_OK);
        double slope = (double)(above.omegasq - below.omegasq) / (4 * h);
        double scale = fabs((double)s.acceleration) + (double)s.omegasq / end;
        if (!(fabs(slope - (double)s.acceleration) <= 1e-6 * loose * scale))
            fail_train("acceleration", &train, (double)s.acceleration, slope);
        slopes[i % 5]++;
    }
    for (int k = 0; k < 5; k++)
        assert_true(checked[k] > 50 && slopes[k] > 10);
}

struct smallest {
    const struct setup *train;
    double head, force, impulse;
};

static bool force_seen(const struct dom_force *force, void *context)
{
    struct smallest *s = context;
    if (force->i == 0)
        s->head = (double)force->force;
    s->force = fmin(s->force, (double)force->per_weight);
    /* Each domino has r^(q-1) times less mass than its leader, so mass times height is multiplied by r^-q. */
    if (!isnan((double)force->force))
        assert_near("of its own weight", force->per_weight,
                    force->force * pow(s->train->r, (s->train->q - 1) * (double)force->i), 1e-12);
    s->impulse = fmin(s->impulse, (double)force->impulse);
    return true;
}

/*
 * Checks that the head obeys its own equation of motion with the force of its follower and its friction, and
 * that without friction all forces and impulses are positive, so that dominoes stay in contact.
 */
TEST(forces_hold_the_train_together)
{
    uint64_t seed = 44;
    int checked = 0, rub = 0;
    for (int i = 0; i < 300; i++) {
        struct setup train;
        struct domq_event events[DOM_EVENTS_MAX];
        int n;
        if (i % 3 ? !next_train(&seed, &train, events, &n) : !next_with_effects(&seed, 1, &train, events, &n))
            continue;
        rub += train.mu > 0;
        for (int k = 0; k < 4; k++) {
            double theta = k / 3.0 * (double)events[n - 1].theta;
            struct smallest seen = {.train = &train, .head = 0, .force = 1, .impulse = 1};
            struct domq_state s;
            struct domq_contact c;
            assert_status(ask_cycle_state(&train, theta, &s), DOM_OK);
            assert_status(ask_cycle_forces(&train, theta, force_seen, &seen), DOM_OK);
            assert_status(ask_contact_find(&train, theta, &c), DOM_OK);
            double d = (double)train.d, gravity = (sin(theta) - d * cos(theta)) / 2;
            double torque = isnan((double)c.arm_a) ? 0 : seen.head * (double)(c.arm_a - train.mu * train.d);
            double scale = fabs(gravity) + fabs((double)s.acceleration) + fabs(torque);
            if (!(fabs(gravity + torque - (double)s.acceleration) <= 1e-9 * scale))
                fail_msg("the head: gravity %g + contact %g, acceleration %g", gravity, torque,
                         (double)s.acceleration);
            assert_true(train.mu > 0 || (seen.force > 0 && seen.impulse > 0));
            checked++;
        }
    }
    assert_true(checked > 300 && rub > 20);
}
