/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: rows */
/* The friction that the floor needs under a domino that falls alone, whose motion is known in closed form. It
 * is compared with values on a fine grid, on level floors and on slopes. */
#include "run.h"
#include "support.h"

enum { GRID = 4000 };

static const double g = 9.81;

/* A block that falls alone, turning about its foot, on a floor with this slope. It starts upright, with the
 * angular velocity `push`. */
struct block {
    double h, d, slope, push;
};

/* Returns twice the height of the centre of a block above its foot, at a tilt. */
static double centre(const struct block *b, double theta)
{
    return b->h * cos(theta + b->slope) + b->d * sin(theta + b->slope);
}

/* Returns the friction |R_x| / R_z that the floor needs at a tilt, or infinity if the block is lifted. */
static double needed(const struct block *b, double theta)
{
    /* moment of inertia divided by the mass */
    double x = sin(theta), y = cos(theta), inertia = (b->h * b->h + b->d * b->d) / 3;
    double across = (b->h * x - b->d * y) / 2, up = (b->h * y + b->d * x) / 2;
    double omegasq = b->push * b->push + g * (centre(b, 0) - centre(b, theta)) / inertia;
    double alpha = g * (across * cos(b->slope) + up * sin(b->slope)) / inertia;
    double force_x = up * alpha - across * omegasq - g * sin(b->slope),
           force_z = g * cos(b->slope) - across * alpha - up * omegasq;
    return force_z > 0 ? fabs(force_x) / force_z : (double)INFINITY;
}

/* Returns the largest value up to a tilt. Between grid points, maxima are found by a parabola through three
 * values. */
static double most_needed(const struct block *b, double end, int *tops)
{
    double most = 0, before[2] = {0, 0};
    *tops = 0;
    for (int i = 0; i <= GRID; i++) {
        double at = needed(b, end * i / GRID), bend = before[0] - 2 * before[1] + at,
               slope = (at - before[0]) / 2;
        if (i > 1 && before[1] > before[0] && before[1] >= at) {
            most = fmax(most, before[1] - slope * slope / (2 * bend));
            ++*tops;
        }
        most = fmax(most, at);
        before[0] = before[1];
        before[1] = at;
    }
    return most;
}

/*
 * Checks the first of two dominoes. Rows in which it comes to rest before it hits the second are left out. A
 * smooth maximum must be right to a millionth.
 */
TEST(two_tops)
{
    uint64_t seed = 101;
    int checked = 0, several = 0;
    for (int i = 0; i < 6000; i++) {
        double h = 0.05, d = h * random_log(&seed, 0.02, 0.9), gap = h * (0.02 + 0.97 * random_unit(&seed));
        struct block b = {h, d, i % 5 ? 0 : 0.9 * atan(d / (2 * h)) * (2 * random_unit(&seed) - 1), 0};
        double edge = sqrt(3 * g * (hypot(h, d) - centre(&b, 0)) / (h * h + d * d));
        b.push = edge * (i % 3 ? random_log(&seed, 1.0001, 1.1) : random_log(&seed, 1.1, 5));
        struct domq_domino domino[] = {{h, d, 0, 1, 0, 0, 0}, {2 * h, d, gap, 1, 0, 0, 0}};
        struct row_setup row = row_setup_default(domino, 2, b.push);
        struct domq_verdict verdict;
        struct dom_floor floor[2];
        int tops;
        row.alpha = b.slope;
        assert_status(ask_row_run(&row, false, NULL, NULL, &verdict), DOM_OK);
        if (verdict.domino == 1)
            continue;
        assert_status(ask_row_floor(&row, floor), DOM_OK);
        double most = most_needed(&b, asin(gap / h), &tops), got = floor[0].motion;
        if (isinf(most) || most > 1e3) { /* if the domino is nearly lifted, few digits are right */
            assert_true(got > 500);
            continue;
        }
        if (!(fabs(got - most) <= 2e-6 * most * (1 + most)))
            fail_msg("d/h %g, gap/h %g, push %g, slope %g: %.10g, on a grid %.10g (%d tops)", d / h, gap / h,
                     b.push, b.slope, got, most, tops);
        checked++;
        several += tops > 1;
    }
    print_message("# %d heads, %d with several tops\n", checked, several);
    assert_true(checked > 2500);
}

/* ---- Rows ---- */

/* Without a push, the first domino starts balanced on its edge. It needs friction only from this tilt on. */
TEST(tipped)
{
    static struct run run;
    struct dom_floor floor[2];
    alike(&run, 2);
    run.row.push = DOMQ_NAN;
    run.domino[1].gap = 0.02;
    assert_status(ask_row_floor(&run.row, floor), DOM_OK);
    assert_true(floor[0].motion > 0 && floor[0].domino == 1 && floor[0].hit == 0 && floor[1].hit > 0);
    run.row.count = 1;
    assert_status(ask_row_floor(&run.row, floor), DOM_OK);
    /* A thin rod needs unbounded friction at cos theta = 1/3, where the floor carries none of its weight. */
    assert_true(floor[0].motion > 1);
    run.row.push = 1e-3; /* the first domino stops, and the second is not hit */
    run.row.count = 2;
    assert_status(ask_row_floor(&run.row, floor), DOM_OK);
    assert_true(floor[0].motion > 0 && isnan(floor[1].motion) && isnan(floor[1].hit) && floor[1].domino == 0);
}

/* A long row of a train needs the same friction as the endless train, during the motion and in the hit. */
TEST(floor_of_the_train)
{
    static struct run run;
    for (int i = 0; i < 3; i++) {
        struct setup train = setup_default();
        struct dom_floor floor[40], of_train;
        train.s = 0.4;
        train.r = 1.3;
        train.mu = 0.1 * i;
        make_row(&run, 40, 0.4, 1.3, train.mu);
        assert_status(ask_row_floor(&run.row, floor), DOM_OK);
        assert_status(ask_cycle_floor(&train, &of_train), DOM_OK);
        assert_near("motion", floor[36].motion, of_train.motion, 1e-6);
        assert_near("hit", floor[36].hit, of_train.hit, 1e-6);
        assert_int_equal(floor[36].domino, 37 - of_train.domino);
        assert_int_equal(floor[36].hit_domino, 37 - of_train.hit_domino);
    }
}

/* Checks that a domino that is hit at its own hinge cannot stay on the floor. */
TEST(floor_at_the_reach)
{
    struct setup t = setup_default();
    struct dom_floor floor;
    t.s = 0.5;
    t.r = 2;
    t.d = 0.1;
    t.q = 3;
    assert_status(ask_cycle_floor(&t, &floor), DOM_OK);
    assert_true(isinf(floor.hit) && floor.hit_domino == 0);
}

/* ---- The followers of a train ---- */

enum { LINKS = 256, TILTS = 100 };

/* The dominoes of a train at one tilt of the head. */
struct links {
    size_t count;
    double theta[LINKS], slope[LINKS];
};

/* The tip of each follower touches the back face of its leader: sin(theta_1 - theta) = r ((s + d) cos theta -
 * d). The list ends with a domino whose follower has detached, or MORE dominoes behind those that move. */
static struct links links_at(const struct setup *train, const struct domq_angles *angles, double theta)
{
    enum { MORE = 40 };
    const double r = (double)train->r, d = (double)train->d, far = (double)train->s + d;
    struct links links = {.theta = {theta}, .slope = {1}};
    size_t n = 0;
    for (size_t slow = 0; slow < MORE && n + 1 < LINKS; n++) {
        const double leader = links.theta[n], angle = asin(r * (far * cos(leader) - d));
        if (angles->detaches && leader >= (double)angles->theta_leave)
            break;
        links.theta[n + 1] = leader + angle;
        links.slope[n + 1] = links.slope[n] * (1 - r * far * sin(leader) / cos(angle));
        slow += links.slope[n + 1] <= 1e-3;
    }
    links.count = n + 1;
    return links;
}

/* Returns the torque of a force about a hinge, which increases the tilt. */
static double torque(const double at[2], const double force[2])
{
    return at[1] * force[0] - at[0] * force[1];
}

/*
 * Returns the largest |R_x| / R_z under the dominoes of a train with sharp edges, from Newton's laws for each
 * of them, beginning with the last: at a tilt or, if `step` is 0, in the collision, where R is an impulse.
 * Masses, lengths and g are 1 for the head. Dominoes slower than a thousandth of the head's speed are left
 * out; *decides is the one that needs most.
 */
static double train_needs(const struct setup *train, const struct domq_angles *angles, double theta,
                          double step, size_t *decides)
{
    const bool hit = step == 0;
    const double r = (double)train->r, d = (double)train->d, s = (double)train->s, mu = (double)train->mu,
                 tausq = (1 + d * d) / 3, gravity = hit ? 0 : 1;
    /* the dominoes one step later, or those of the train that hits the head */
    const struct links here = links_at(train, angles, theta),
                       other = links_at(train, angles, hit ? (double)angles->theta_c : theta + step);
    struct domq_state state;
    domq_real w_c;
    assert_status(ask_cycle_state(train, theta, &state), DOM_OK);
    assert_status(ask_cycle_omegasq(train, angles->theta_c, &w_c), DOM_OK);
    const double w = (double)state.omegasq;
    /* the force of the follower, and where it acts */
    double most = 0, behind[2] = {0, 0}, at[2] = {0, 0};
    size_t slow = 0;
    while (slow + 1 < here.count && here.slope[slow] > 1e-3)
        slow++;
    for (size_t j = here.count; j-- > 0;) {
        const double h = pow(r, -(double)j), m = pow(r, (1 - (double)train->q) * (double)j),
                     x = sin(here.theta[j]), y = cos(here.theta[j]), tip[2] = {h * x, h * y},
                     centre_x = h * (x - d * y) / 2, centre_z = h * (y + d * x) / 2,
                     bend = j < other.count ? (other.slope[j] - here.slope[j]) / step : 0,
                     turn = hit ? here.slope[j] * sqrt(w) -
                                      (j > 0 ? other.slope[j - 1] * sqrt((double)(train->r * w_c)) : 0)
                                : (here.slope[j] * (double)state.acceleration + bend * w) / tausq,
                     omegasq = hit ? 0 : here.slope[j] * here.slope[j] * w / tausq;
        double onto[2] = {0, 0};
        if (j > 0) { /* the force on the tip, normal to the back face of the leader, and along it */
            const double lx = sin(here.theta[j - 1]), ly = cos(here.theta[j - 1]),
                         away[2] = {mu * lx - ly, lx + mu * ly},
                         missing = m * h * h * tausq * turn - gravity * m * centre_x - torque(at, behind),
                         force = missing / torque(tip, away);
            onto[0] = force * away[0];
            onto[1] = force * away[1];
        }
        const double force_x = m * (centre_z * turn - centre_x * omegasq) - behind[0] - onto[0],
                     force_z = m * (gravity - centre_x * turn - centre_z * omegasq) - behind[1] - onto[1],
                     needs = force_z > 0 ? fabs(force_x) / force_z : (double)INFINITY;
        if (j <= slow && needs > most) {
            most = needs;
            *decides = j;
        }
        at[0] = tip[0] - (s + d) * h * r;
        at[1] = tip[1];
        behind[0] = -onto[0];
        behind[1] = -onto[1];
    }
    return most;
}

/* Checks trains with and without friction. In every third train, the deciding domino may be so light that it
 * does not count for the energy. */
TEST(trains_need_what_newton_says)
{
    uint64_t seed = 102;
    int checked = 0, light = 0, rubs = 0, detach = 0, by_head = 0;
    for (int i = 0; i < 150; i++) {
        struct setup train = setup_default();
        struct domq_angles angles;
        struct domq_limit limit;
        struct dom_floor floor;
        size_t decides = 0;
        const bool thin = i % 3 == 0;
        train.s = thin ? random_log(&seed, 0.02, 0.1) : random_log(&seed, 0.1, 0.9);
        train.d = thin ? random_log(&seed, 0.004, 0.04) : random_log(&seed, 0.03, 0.5);
        train.q = 3 + i % 2;
        train.mu = i % 3 == 1 ? random_log(&seed, 0.01, 1) : 0;
        assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
        if (limit.ends == DOM_END_NONE)
            continue;
        train.r = 1 + ((double)limit.r_max - 1) * (0.3 + 0.65 * random_unit(&seed));
        if (ask_angles_find(&train, &angles) != DOM_OK || ask_cycle_floor(&train, &floor) != DOM_OK)
            continue;
        const double step = 1e-7 * (double)angles.theta_c;
        for (int k = 1; k < TILTS && isfinite(floor.motion); k++) {
            const double theta = (double)angles.theta_c * pow((double)k / TILTS, thin ? 4 : 1),
                         needs = train_needs(&train, &angles, theta, step, &decides);
            if (!(needs <= floor.motion * (1 + 1e-3)))
                fail_train("friction of the floor at another tilt", &train, floor.motion, needs);
        }
        /* At the tilt that needs most, a domino may just detach. */
        double off = 1;
        for (int side = -1; side <= 1 && isfinite(floor.motion); side += 2) {
            const double theta = fmax(floor.theta, step),
                         needs = train_needs(&train, &angles, theta, side * step, &decides);
            off = fmin(off, fabs(needs / floor.motion - 1));
        }
        if (isfinite(floor.motion) && !(off <= 1e-3))
            fail_train("friction of the floor", &train, floor.motion, off);
        size_t struck = 0;
        const double hit = train_needs(&train, &angles, 0, 0, &struck), d = (double)train.d,
                     a = sqrt(1 - pow((double)(train.r * train.s), 2)) / (double)train.r;
        if (isfinite(floor.hit) || isfinite(hit))
            assert_near("in the collision", floor.hit, hit, 1e-8);
        if (train.mu == 0 && floor.hit_domino == 0) {
            assert_near("the struck domino", floor.hit, fabs(0.5 - (1 + d * d) / (3 * a)) / (d / 2), 1e-11);
            by_head++;
        }
        checked++;
        rubs += train.mu > 0;
        detach += angles.detaches;
        light += pow((double)train.r, -(double)train.q * (double)decides) < 1e-6;
    }
    print_message(
        "# %d trains, %d with friction, %d detach, %d with a light domino that decides, %d by the head\n",
        checked, rubs, detach, light, by_head);
    assert_true(checked > 60 && rubs > 15 && detach > 10 && light > 3 && by_head > 1);
}
