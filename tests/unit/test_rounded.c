/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rounded edges and slopes, compared with published digits, with quad, with sharp edges in the limit of small
 * radii, and with Newton's law for the centre of each block. Newton's law is written in vectors and shares no
 * formula with the model.
 */
#include "support.h"

static struct setup train_of(double s, double rho, double mu)
{
    struct setup train = setup_default();
    train.s = s;
    train.q = 3;
    train.rho = rho;
    train.mu = mu;
    return train;
}

static double rmax_of(const struct setup *train)
{
    struct domq_limit limit = {.r_max = DOM_NAN};
    assert_status(ask_limit_rmax(train, &limit), DOM_OK);
    return (double)limit.r_max;
}

/* r_max on a slope is from arithmetic with 40 digits. */
TEST(largest_growths)
{
    static const double table[][4] = {
        /* s, rho, slope in degrees, r_max */
        {0.2, 0.005, 0, 1.599355}, {0.2, 0.01, 0, 1.649661}, {0.2, 0.02, 0, 1.772503},
        {0.3, 0.005, 0, 1.871112}, {0.3, 0.01, 0, 1.935795}, {0.3, 0.02, 0, 2.092912},
        {0.2, 0, -1, 1.48052142},  {0.2, 0, 0, 1.55478182},  {0.2, 0, 1, 1.64507145},
        {0.2, 0, 2, 1.75719157},   {0.3, 0, -1, 1.71622498}, {0.3, 0, 0, 1.81350829},
        {0.3, 0, 1, 1.93065102},   {0.3, 0, 2, 2.07536161},  {0.4, 0, -1, 1.93981351},
        {0.4, 0, 0, 2.06377177},   {0.4, 0, 1, 2.22126200},  {0.4, 0, 2, 2.40239954}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct setup train = train_of(table[i][0], table[i][1], 0);
        train.alpha = table[i][2] * M_PI / 180;
        assert_near("r_max", rmax_of(&train), table[i][3], table[i][1] > 0 ? 1e-6 : 3e-9);
    }
}

TEST(edges_become_sharp)
{
    for (int k = 0; k < 4; k++) {
        struct setup sharp = train_of(0.15 + 0.09 * k, 0, k % 2 ? 0.2 : 0), slight = sharp;
        struct domq_best a, b;
        slight.rho = 1e-12;
        assert_near("r_max", rmax_of(&slight), rmax_of(&sharp), 1e-9);
        assert_status(ask_limit_best(&sharp, &a), DOM_OK);
        assert_status(ask_limit_best(&slight, &b), DOM_OK);
        assert_near("best", (double)b.r_max, (double)a.r_max, 1e-7);
    }
}

/* Checks that theta_1 solves the contact equation up to rounding errors, for radii up to d/2, in each
 * precision. */
TEST(contacts)
{
    uint64_t seed = 11;
    double worst[2] = {0, 0};
    for (int n = 0; n < 3000; n++) {
        struct setup train = train_of(0.02 + 0.9 * random_unit(&seed), 0, 0);
        struct domq_angles angles;
        struct domq_contact contact;
        train.d = random_log(&seed, 1e-3, 0.9);
        train.rho = train.d / 2 * random_log(&seed, 1e-9, 1);
        train.r = 1 + (1 / train.s - 1) * random_unit(&seed);
        train.precision = n % 8 ? IN_DOUBLE : IN_QUAD;
        if (ask_angles_find(&train, &angles) != DOM_OK)
            continue;
        domq_real theta = angles.theta_c * random_log(&seed, 1e-6, 1);
        assert_status(ask_contact_find(&train, theta, &contact), DOM_OK);
        if (isnan((double)contact.arm_a)) /* the follower has detached */
            continue;
        const long double rho = (long double)train.rho, r = (long double)train.r, d = (long double)train.d,
                          l = 1 - 2 * rho, from = (long double)theta, to = (long double)contact.theta_1;
        const long double along = -(long double)train.s - d + rho * (1 - 1 / r) + rho * to / r - rho * from +
                                  l / r * sinl(to),
                          up = rho / r - rho + l / r * cosl(to);
        double off = (double)fabsl(along * cosl(from) - up * sinl(from) + d - rho + rho / r);
        worst[n % 8 == 0] = fmax(worst[n % 8 == 0], off);
    }
    print_message("# residual of the contact %.1e, in quad %.1e\n", worst[0], worst[1]);
    assert_true(worst[0] > 0 && worst[0] < 2e-15);
    assert_true(worst[1] < 1e-18); /* the accuracy of long double, in which the error is computed */
}

/* ---- Cases in which digits are lost: near the reach, with hardly any friction, with edges that are nearly
 * sharp ---- */

/* Checks that passes down equal dominoes end, where only the turns to theta_inf decrease from one domino to
 * the next, and rounding errors of a turn do not. */
TEST(equal_dominoes_in_thousands)
{
    for (double s = 1e-2; s > 1e-5; s /= 3) {
        struct setup train = train_of(s, 0.012677, 0);
        domq_real duration, finer;
        train.d = 0.0628582;
        train.r = 1;
        const enum dom_status status = ask_cycle_duration(&train, &duration);
        assert_true(status == DOM_OK || status == DOM_STOPS || status == DOM_NO_FUEL);
        if (status != DOM_OK)
            continue;
        train.precision = IN_QUAD;
        train.tol = 1e-16;
        assert_status(ask_cycle_duration(&train, &finer), DOM_OK);
        assert_near("duration", (double)duration, (double)finer, 1e-10);
    }
}

/* Compares difficult trains with quad, which has enough digits in any case. */
TEST(difficult_limits)
{
    static const struct {
        double s, d, q, mu, rho;
    } table[] = {
        {0.92, 7 / 48., 3, 0.1, 0.01},
        {0.88, 7 / 48., 3, 0.1, 0.005},
        {0.8724, 7 / 48., 4, 1e-7, 0},               /* the follower lies on its back at first */
        {0.7, 7 / 48., 3, 0, 1e-9},                  /* an edge much smaller than the gap at the reach */
        {0.25, 0.46409449423663324, 2, 0, 0.01},     /* the margin is 0 at r = 1 */
        {0.61, 0.040268563801308083, 1e-6, 0, 3e-6}, /* weights that hardly decrease */
        {0.4, 0.1, 4, 0.1, 0.05},                    /* no flat foot: theta_u is 0 */
        /* the second growth of the search happens to be almost a root */
        {0.016696147426729938, 0.017682612184551597, 3, 0, 3.0222794650576016e-09},
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct setup train = train_of(table[i].s, table[i].rho, table[i].mu);
        train.d = table[i].d;
        train.q = table[i].q;
        const double in_double = rmax_of(&train);
        train.precision = IN_QUAD;
        train.tol = 1e-16;
        assert_near("r_max", in_double, rmax_of(&train), 1e-11);
    }
}

/* Returns a random train, which may be as close as 1e-6 to its reach. Friction and edges have a random size
 * or are off. */
static struct setup any_train(uint64_t *seed)
{
    static const double q[] = {1e-6, 1, 2, 3, 4};
    const double rho = random_unit(seed) < 0.2 ? 0 : random_log(seed, 1e-9, 0.02);
    const double mu = random_unit(seed) < 0.2 ? 0 : random_log(seed, rho > 0 ? 1e-2 : 1e-9, 0.6);
    struct setup train = train_of(0, rho, mu);
    train.d = fmax(random_log(seed, 0.02, 0.5), 2 * rho);
    train.q = q[(int)(5 * random_unit(seed))];
    if (random_unit(seed) < 0.4)
        train.alpha = 0.9 * (random_unit(seed) - 0.5) * atan(((double)train.d - 2 * rho) / (1 - 2 * rho));
    const double span = 1 - rho * (2 - M_PI / 2);
    train.s =
        span * (random_unit(seed) < 0.5 ? 0.02 + 0.97 * random_unit(seed) : 1 - random_log(seed, 1e-3, 1));
    const double reach = span / (double)train.s, L = (double)(train.s + train.d), at = random_unit(seed);
    const double detaches = 1 / sqrt(L * L - (double)(train.d * train.d)); /* (41; A17) for sharp edges */
    double r = at < 0.4   ? exp(log(reach) * random_unit(seed))
               : at < 0.8 ? reach - (reach - 1) * random_log(seed, 1e-6, 1)
                          : fmin(detaches * (1 + random_log(seed, 1e-9, 0.1)), reach);
    train.r = fmax(r, 1);
    return train;
}

/* Checks that every random train has a result or a verdict in float and double, and compares some of the
 * results with quad. */
TEST(trains_anywhere)
{
    uint64_t seed = 29;
    int goes = 0, stops = 0;
    for (int n = 0; n < 1500; n++) {
        struct setup train = any_train(&seed);
        struct domq_barrier barrier, finer;
        train.precision = n % 4 ? IN_DOUBLE : IN_FLOAT;
        train.tol = any_arithmetic(train.precision).tol_default;
        const enum dom_status status = ask_barrier_find(&train, &barrier);
        goes += status == DOM_OK;
        stops += status == DOM_STOPS;
        if (status != DOM_OK && status != DOM_STOPS && status != DOM_LOCKS && status != DOM_NO_FUEL)
            fail_msg("train %d: %s", n, dom_status_text(status));
        assert_true(rmax_of(&train) != 0); /* r_max is NaN if even equal dominoes stop */
        if (n % 32 != 1 || (status != DOM_OK && status != DOM_STOPS))
            continue;
        train.precision = IN_QUAD;
        train.tol = 1e-16;
        assert_status(ask_barrier_find(&train, &finer), status);
        assert_near("kinetic", (double)barrier.kinetic, (double)finer.kinetic, 1e-10);
        assert_near("barrier", (double)barrier.barrier, (double)finer.barrier, 1e-10);
    }
    assert_true(goes > 500 && stops > 100);
}

/* ---- Newton's law ---- */

enum { MOST = 40 };

struct vector {
    double x, z;
};

static double cross(struct vector a, struct vector b) /* forward torque of the force b at the point a */
{
    return a.z * b.x - a.x * b.z;
}

/* A domino of a train, its front edge at x = foot when upright. */
struct block {
    double height, d, rho, foot, mass;
    double theta;
};

/* Return the centre of the rounded edge on which a block rolls, and the centre of its upper edge. */
static struct vector edge_of(const struct block *b)
{
    return (struct vector){b->foot - b->rho + b->rho * b->theta, b->rho};
}

static struct vector upper_of(const struct block *b)
{
    struct vector e = edge_of(b);
    double l = b->height - 2 * b->rho;
    return (struct vector){e.x + l * sin(b->theta), e.z + l * cos(b->theta)};
}

static struct vector centre_of(const struct block *b)
{
    struct vector e = edge_of(b);
    double up = b->height / 2 - b->rho, back = b->d / 2 - b->rho;
    return (struct vector){e.x + up * sin(b->theta) - back * cos(b->theta),
                           e.z + up * cos(b->theta) + back * sin(b->theta)};
}

/* Returns the distance of the rounded upper edge of a follower from the back of its leader, or a negative
 * number if the edge is inside the leader. */
static double clearance(const struct block *follower, const struct block *leader)
{
    struct vector p = upper_of(follower), e = edge_of(leader);
    double along = (p.x - e.x) * cos(leader->theta) - (p.z - e.z) * sin(leader->theta);
    return -along - (leader->d - leader->rho) - follower->rho;
}

/* Leans a chain of n blocks on its domino `first`, at theta. */
static void lean(struct block *b, int first, int n, double theta)
{
    b[first].theta = theta;
    for (int i = first + 1; i < n; i++) {
        double lo = 0, hi = 1.6;
        for (int k = 0; k < 100; k++) {
            b[i].theta = (lo + hi) / 2;
            *(clearance(&b[i], &b[i - 1]) > 0 ? &lo : &hi) = b[i].theta;
        }
    }
}

static void train_make(struct block *b, int n, const struct setup *train, double rho)
{
    double foot = 0, height = 1;
    for (int i = 0; i < n; i++) {
        b[i] = (struct block){height, (double)train->d * height, rho * height, foot, pow(height, 2), 0};
        foot -= ((double)train->s + (double)train->d) * height;
        height /= (double)train->r;
    }
}

/*
 * Returns the unbalanced torque on the head if all blocks have the given accelerations or, in a collision,
 * changes of velocity. Each contact supplies the force that its follower needs. Torques are about the line
 * where a block touches the floor, so that the floor exerts no torque.
 */
static double torque_left(const struct block *b, int n, const struct vector *acceleration,
                          const double *angular, double mu, double gravity)
{
    double normal = 0, left = 0;
    for (int i = n - 1; i >= 0; i--) {
        struct vector e = edge_of(&b[i]), floor = {e.x, 0}, c = centre_of(&b[i]);
        struct vector at = {c.x - floor.x, c.z};
        struct vector moved = {b[i].mass * acceleration[i].x, b[i].mass * (acceleration[i].z + gravity)};
        double own = b[i].mass * (b[i].height * b[i].height + b[i].d * b[i].d) / 12;
        left = own * angular[i] + cross(at, moved);
        if (i + 1 < n) { /* the follower pushes, and its friction acts down the face */
            double x = sin(b[i].theta), y = cos(b[i].theta);
            struct vector p = upper_of(&b[i + 1]), push = {normal * (y - mu * x), normal * (-x - mu * y)};
            struct vector on = {p.x + b[i + 1].rho * y - floor.x, p.z - b[i + 1].rho * x};
            left -= cross(on, push);
        }
        if (i > 0) { /* the leader pushes back */
            double x = sin(b[i - 1].theta), y = cos(b[i - 1].theta);
            struct vector p = upper_of(&b[i]), hold = {-(y - mu * x), x + mu * y};
            struct vector on = {p.x + b[i].rho * y - floor.x, p.z - b[i].rho * x};
            normal = left / cross(on, hold);
        }
    }
    return left;
}

/* Compares the acceleration and the collision of the endless train with a long chain of blocks. */
TEST(newtons_law)
{
    static const double scene[][5] = {/* s, r, rho, mu, theta */
                                      {0.3, 1.3, 0.01, 0, 0.15},
                                      {0.4, 1.1, 0.03, 0, 0.3},
                                      {0.3, 1.2, 0.01, 0.2, 0.2},
                                      {0.4, 1.4, 0.03, 0.1, 0.25},
                                      {0.2, 1.5, 0.06, 0.3, 0.1}};
    for (size_t k = 0; k < sizeof scene / sizeof *scene; k++) {
        struct setup train = train_of(scene[k][0], scene[k][2], scene[k][3]);
        struct domq_state at;
        struct block low[MOST], high[MOST], now[MOST];
        struct vector still[MOST], pushed[MOST];
        double none[MOST], turned[MOST];
        double mu = scene[k][3], theta = scene[k][4], step = 1e-4;
        train.r = scene[k][1];
        assert_status(ask_cycle_state(&train, theta, &at), DOM_OK);
        train_make(now, MOST, &train, scene[k][2]);
        train_make(low, MOST, &train, scene[k][2]);
        train_make(high, MOST, &train, scene[k][2]);
        lean(now, 0, MOST, theta);
        lean(low, 0, MOST, theta - step);
        lean(high, 0, MOST, theta + step);
        /* In units of h/g, tau^2 = (1 + d^2) / 3. */
        double tausq = (1 + (double)train.d * (double)train.d) / 3, w = (double)at.omegasq / tausq;
        for (int i = 0; i < MOST; i++) {
            struct vector a = centre_of(&low[i]), b = centre_of(&now[i]), c = centre_of(&high[i]);
            none[i] = (high[i].theta - 2 * now[i].theta + low[i].theta) / (step * step) * w;
            turned[i] = (high[i].theta - low[i].theta) / (2 * step);
            still[i] = (struct vector){(c.x - 2 * b.x + a.x) / (step * step) * w,
                                       (c.z - 2 * b.z + a.z) / (step * step) * w};
            pushed[i] = (struct vector){(c.x - a.x) / (2 * step), (c.z - a.z) / (2 * step)};
        }
        double by_rest = torque_left(now, MOST, still, none, mu, 1),
               by_unit = torque_left(now, MOST, pushed, turned, mu, 0);
        assert_near("acceleration", (double)at.acceleration / tausq, -by_rest / by_unit, 2e-6);

        /* The collision. Just before it, the head is upright and at rest, and its followers are the train at
         * theta_c. */
        struct domq_launch launch;
        struct domq_angles angles;
        assert_status(ask_launch_find(&train, &launch), DOM_OK);
        assert_status(ask_angles_find(&train, &angles), DOM_OK);
        lean(now, 0, MOST, 0);
        lean(high, 0, MOST, step);
        assert_near("theta_c", now[1].theta, (double)angles.theta_c, 1e-12);
        struct block hit[MOST];
        memcpy(hit, now, sizeof hit);
        lean(hit, 1, MOST, now[1].theta - step); /* the followers move while the head is at rest */
        struct vector before[MOST], after[MOST];
        double turns_before[MOST], turns_after[MOST];
        for (int i = 0; i < MOST; i++) {
            struct vector a = centre_of(&hit[i]), b = centre_of(&now[i]), c = centre_of(&high[i]);
            before[i] = (struct vector){(b.x - a.x) / step, (b.z - a.z) / step};
            after[i] = (struct vector){(c.x - b.x) / step, (c.z - b.z) / step};
            turns_before[i] = (now[i].theta - hit[i].theta) / step;
            turns_after[i] = (high[i].theta - now[i].theta) / step;
        }
        double kept = torque_left(now, MOST, before, turns_before, mu, 0) /
                      torque_left(now, MOST, after, turns_after, mu, 0);
        assert_near("collision", (double)launch.velocity_ratio, kept, 1e-3);
    }
}

/* ---- Values that do not fit ---- */

TEST(radii_that_do_not_fit)
{
    struct setup train = train_of(0.4, 0.5, 0);
    struct domq_limit limit;
    train.rho = train.d / 2 + 1e-9;
    assert_status(ask_check(&train), DOM_NO_ROUND);
    train.rho = train.d / 2;
    assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
    assert_true(limit.r_max > 1);
    train.rho = 0.01;
    train.s = 1; /* the reach of a rounded domino is less than its height */
    train.r = 1;
    assert_status(ask_check(&train), DOM_OUT_OF_REACH);
    train.s = 0.4;
    domq_real lean[2]; /* the centre must be above the flat part of the foot */
    domq_lean_limits(&(struct domq_domino){.height = 1, .thickness = train.d}, 0, train.rho, lean);
    assert_near("limit", lean[1], atan(7.0 / 48 - 0.02), 1e-15);
    train.alpha = lean[1] * (1 - 1e-9);
    assert_status(ask_check(&train), DOM_OK);
    train.alpha = lean[1] * (1 + 1e-9);
    assert_status(ask_check(&train), DOM_NO_STAND);
    struct domq_domino two[] = {{1, 0.1, 0, 1, 0, 0, 0}, {1, 0.1, 0.5, 1, 0.06, 0, 0}};
    struct row_setup row = row_setup_default(two, 2, 4);
    struct domq_verdict verdict;
    row.rho = 0.01;
    assert_status(ask_row_run(&row, true, NULL, NULL, &verdict), DOM_NO_ROUND);
    assert_int_equal(verdict.domino, 2);
    row.rho = 0;
    assert_status(ask_row_run(&row, true, NULL, NULL, &verdict), DOM_OK);
    two[1].radius = -1;
    assert_status(ask_row_run(&row, true, NULL, NULL, &verdict), DOM_BAD_RADIUS);
}

/* Checks that a domino tips over earlier by alpha, and that a slope on which no domino stands is an error. */
TEST(slopes_that_do_not_hold)
{
    struct setup train = train_of(0.4, 0, 0);
    struct domq_angles angles;
    double edge = atan(7.0 / 48);
    for (int side = -1; side <= 1; side += 2) {
        train.alpha = side * edge * (1 + 1e-12);
        assert_status(ask_check(&train), DOM_NO_STAND);
        train.alpha = side * edge * (1 - 1e-12);
        assert_status(ask_angles_find(&train, &angles), DOM_OK);
        assert_near("theta_u", (double)angles.theta_u, edge - (double)train.alpha, 1e-3);
    }
    train.alpha = 2;
    assert_status(ask_check(&train), DOM_BAD_ALPHA);
    /* the paper's fuel is only for sharp edges on a level floor */
    for (int k = 0; k < 2; k++) {
        struct domq_limit limit;
        struct domq_launch launch;
        train.alpha = k == 0 ? 0.01 : 0;
        train.rho = k == 0 ? 0 : 0.01;
        train.fuel = DOM_FUEL_PAPER;
        assert_status(ask_limit_rmax(&train, &limit), DOM_NO_METHOD);
        assert_status(ask_launch_find(&train, &launch), DOM_NO_METHOD);
        assert_status(ask_limit_pair(&train, &limit), DOM_OK);
    }
}

TEST(the_uncertainty_of_a_reach_covers_its_rounding)
{
    uint64_t seed = 48;
    int reaches = 0;
    for (int n = 0; n < 80; n++) {
        struct setup train = setup_default();
        struct domq_limit in_double, exact;
        train.s = random_log(&seed, 0.01, 0.5);
        train.d = random_log(&seed, 1e-3, 0.02);
        train.q = 0.4;
        train.rho = (double)train.d * random_log(&seed, 0.01, 0.4);
        assert_status(ask_limit_rmax(&train, &in_double), DOM_OK);
        train.precision = IN_QUAD;
        assert_status(ask_limit_rmax(&train, &exact), DOM_OK);
        if (in_double.ends != DOM_END_REACH || exact.ends != DOM_END_REACH)
            continue;
        reaches++;
        assert_true(fabs((double)(in_double.r_max - exact.r_max)) <= (double)in_double.uncertainty);
    }
    assert_true(reaches > 10);
}
