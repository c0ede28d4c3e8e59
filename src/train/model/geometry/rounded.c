/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Dominoes with edges of radius rho. Lengths are divided by the height of the domino. The foot rolls on the
 * floor without slipping. The round upper edge of a follower slides down the flat back of its leader. The
 * lower edge at the back stays sharp.
 *
 * With l = 1 - 2 rho, the potential energy of a domino is
 *
 *     h(theta) = 2 rho + l cos theta + (d - 2 rho) sin theta.
 *
 * If the floor slopes by alpha, theta + alpha replaces theta in this formula. The foot also rolls down the
 * slope. For this reason, 2 rho theta sin alpha is subtracted.
 *
 * In the contact equation, rho_1 and l_1 are rho and l of the follower, divided by the height of the leader.
 * With delta = theta_1 - theta, the equation is
 *
 *     l_1 sin delta + rho_1 delta cos theta = L cos theta - d
 *                                             + (rho - rho_1) (1 - cos theta - sin theta + theta cos theta).
 */
#include "geometry/chain.h"

KERNEL enum dom_status rounded_make(struct geometry *geometry, real rho)
{
    real d = geometry->d, along = geometry->g.along, down = geometry->g.down, tall = 1 - 2 * rho,
         wide = d - 2 * rho, block = geometry->inertia_factor * (1 + d * d) / 3;
    struct rounded *of = &geometry->rounded;
    *of = (struct rounded){.rho = rho, .tall = tall, .wide = wide, .roll = -2 * rho * along};
    of->i.c = (block - (1 + d * d) / 4 + (tall * tall + wide * wide) / 4 + rho * rho) / block;
    of->i.x = rho * wide / block;
    of->i.y = rho * tall / block;
    geometry->rolls = true;
    geometry->upright_inertia = of->i.c + of->i.y;
    geometry->span = reach_span(rho);
    geometry->h.x = wide * down - tall * along;
    geometry->h.y = tall * down + wide * along;
    geometry->steepest = hypot(tall, wide);
    return wide >= 0 && tall > 0 ? DOM_OK : DOM_NO_ROUND;
}

/* ---- One contact ---- */

/* The maximum number of steps of an iteration. If there is a solution, one to four steps are enough. */
enum { TURN_STEPS = 40 };

static const struct turn no_turn = {REAL_NAN, {REAL_NAN, REAL_NAN, REAL_NAN}};

/*
 * Finds the turn u to a follower from the contact equation l sin u + c u = G. u lies in [-pi/2, pi/2], and l
 * and c are >= 0. Returns NaN if there is no solution.
 *
 * The method is Halley's. It starts from the power series of u in X = G / (l + c), up to X^7, which follows
 * from u - a u^3 + b u^5 - ... = X with a = l / (6 (l + c)) and b = a / 20. The iteration ends with a step
 * `by` whose cube is negligible. The sine and cosine are not computed anew after this last step: they follow
 * from their values before the step by Taylor series, up to the terms with by^2.
 */
static struct turn turn_solve(real l, real c, real G)
{
    const real of = 1 / (l + c), X = G * of, z = X * X, a = l * of * ((real)1 / 6), b = a * ((real)1 / 20);
    real turn =
        X * (1 + z * (a + z * (3 * a * a - b + z * (12 * a * a * a - 8 * a * b + b * ((real)1 / 42)))));
    for (int i = 0; i < TURN_STEPS; i++) {
        turn = fmin(fmax(turn, -PI / 2), PI / 2);
        real x = sin(turn), y = cos(turn), off = l * x + c * turn - G, slope = l * y + c;
        real bend = l * x / slope, by = -off / (slope + off * bend / 2);
        if (fabs(by * by * by) * (1 + bend * bend) <= REAL_EPSILON * fabs(turn))
            return (struct turn){turn + by, tilt_make(x + by * (y - by * x / 2), y - by * (x + by * y / 2))};
        turn += by;
    }
    return no_turn;
}

/*
 * Finds the turn u from l sin u + c u = G if u is near pi/2, where turn_solve would lose digits of cos u. The
 * argument E is l + c pi/2 - G. The angle e = pi/2 - u obeys l (1 - cos e) + c e = E. Returns NaN if there is
 * no solution.
 */
static struct turn turn_near_reach(real l, real c, real E)
{
    real e = E > 0 ? 2 * E / (c + sqrt(c * c + 2 * l * E)) : E;
    for (int i = 0; i < TURN_STEPS && e >= 0; i++) {
        real x = sin(e), y = cos(e), off = l * x * x / (1 + y) + c * e - E, slope = l * x + c;
        real by = off == 0 ? 0 : -off / (slope - off * l * y / (2 * slope));
        if (fabs(by * by * by) <= REAL_EPSILON * e * e * e)
            return (struct turn){PI / 2 - (e + by),
                                 tilt_make(y - by * (x + by * y / 2), x + by * (y - by * x / 2))};
        e += by;
    }
    return no_turn;
}

/* Returns sin theta - theta cos theta, by a power series if the terms would cancel. */
static real sine_excess(struct tilt t, real theta)
{
    if (fabs(theta) > (real)0.25)
        return t.x - theta * t.y;
    real square = theta * theta, term = theta * square / 3, sum = term;
    for (int k = 2; fabs(term) > ROUNDOFF * fabs(sum); k++) {
        term *= -square / (real)((2 * k - 2) * (2 * k + 1));
        sum += term;
    }
    return sum;
}

static struct tilt tilt_of(real theta)
{
    return tilt_make(sin(theta), cos(theta));
}

/* Like tilt_angle, but faster. The angle must not be less than -pi/3. */
static real tilt_theta(struct tilt t)
{
    return t.v < (real)0.5 ? asin(t.x) : PI / 2 - asin(t.y);
}

/* If G is at least this fraction of l + c, the turn is near pi/2, and turn_near_reach finds it. */
#define TURN_NEAR ((real)15 / 16)

/* Returns the right side of the contact equation. */
static real rounded_gap(const struct geometry *geometry, struct tilt leader, real theta)
{
    return geometry->s - geometry->L * leader.v +
           (geometry->rounded.rho - geometry->rounded.rho_1) * (leader.v - leader.x + theta * leader.y);
}

static void rounded_turn(struct link *k)
{
    const struct geometry *geometry = k->geometry;
    const struct rounded *of = &geometry->rounded;
    const struct tilt leader = k->tilt;
    const real c = of->rho_1 * leader.y, G = rounded_gap(geometry, leader, k->theta);
    if (G < TURN_NEAR * (of->tall_1 + c)) {
        k->turn = turn_solve(of->tall_1, c, G);
        return;
    }
    /* 0 if the follower is perpendicular to its leader */
    const real E = geometry->short_of / geometry->r + (geometry->L - of->rho_1 * (PI / 2)) * leader.v -
                   (of->rho - of->rho_1) * (leader.v - sine_excess(leader, k->theta));
    k->turn = turn_near_reach(of->tall_1, c, E);
}

KERNEL_SHARED void rounded_levers(struct link *k)
{
    const struct geometry *geometry = k->geometry;
    const struct rounded *of = &geometry->rounded;
    const struct tilt leader = k->tilt;
    const real x = k->turn.tilt.x, y = k->turn.tilt.y, turn = k->turn.angle, more = of->rho - of->rho_1;
    /* The derivative of the contact equation is b turn' = sin theta (rho_1 turn - M), theta being the
     * leader's tilt. */
    const real c = of->rho_1 * leader.y, M = geometry->L - more * (1 - k->theta), b = of->tall_1 * y + c,
               arm = b + leader.x * (of->rho_1 * turn - M), slope = arm / b, part = slope - 1;
    k->contact = (struct contact){.X = x, .Y = y, .arm = geometry->r * arm, .slope = slope};
    k->curve = (of->tall_1 * x * part * part + 2 * of->rho_1 * leader.x * part + c * turn - leader.y * M -
                leader.x * more) /
               b;
}

KERNEL_SHARED void rounded_touch(struct link *k)
{
    rounded_turn(k);
    rounded_levers(k);
}

/* Returns a domino that leans by theta, and its contact with its follower. */
static struct link rounded_at(const struct geometry *geometry, real theta)
{
    struct link k = {.geometry = geometry, .tilt = tilt_of(theta), .theta = theta};
    rounded_touch(&k);
    return k;
}

/* ---- The chain ---- */

/* Sets `leads` to true if a follower leans on the domino. If so, also computes the turn from the domino to
 * the follower. */
static void rounded_follower(struct link *k)
{
    /* geometry->n counts from the head in a train, but from this domino in a row. */
    const size_t before = k->geometry->follower ? 0 : k->i;
    k->leads = before + 1 < k->geometry->n && link_leads(k);
    if (k->leads)
        rounded_turn(k);
}

KERNEL_SHARED struct link rounded_head(const struct geometry *geometry, struct tilt head)
{
    struct link k = {
        .geometry = geometry, .tilt = head, .slope = 1, .weight = 1, .inertia = 1, .theta = tilt_theta(head)};
    rounded_follower(&k);
    if (k.leads)
        rounded_levers(&k);
    return k;
}

KERNEL_SHARED void rounded_step(struct link *k)
{
    const struct tilt leader = k->tilt, turn = k->turn.tilt;
    const real v = turn.v + (turn.y * leader.v + turn.x * leader.x);
    k->i++;
    k->tilt = (struct tilt){.x = sqrt(v * (2 - v)), .y = 1 - v, .v = v};
    k->theta += k->turn.angle;
    if (k->geometry->follower)
        k->geometry = k->geometry->follower;
    rounded_follower(k);
}

KERNEL_SHARED struct arms rounded_arms(const struct link *k)
{
    const struct geometry *geometry = k->geometry;
    const struct rounded *of = &geometry->rounded;
    real a = k->contact.arm - geometry->mu * geometry->r * (geometry->d - of->rho * (1 - k->tilt.x)),
         b_plain = geometry->r * (of->tall_1 * k->contact.Y + of->rho_1 * k->tilt.y),
         b = b_plain + geometry->mu * geometry->r * (of->tall_1 * k->contact.X + of->rho_1 * (1 - k->tilt.x));
    return (struct arms){.a = a, .b = b, .b_plain = b_plain, .ratio = a / b};
}

/* ---- The shape of a train ---- */

static real gap_at(real theta, void *geometry)
{
    return rounded_gap(geometry, tilt_of(theta), theta);
}

/* Returns the slope of the contact at a tilt, or -1 if there is no contact. */
static real slope_at(real theta, void *geometry)
{
    const real slope = rounded_at(geometry, theta).contact.slope;
    return isnan(slope) ? -1 : slope;
}

/* Returns the tilt of a leader at which its follower detaches: the slope of the contact, which decreases with
 * the tilt, is 0 there. At the tilt hi it is negative, or there is no contact. */
static real rounded_leave(struct geometry *geometry, real hi)
{
    real theta = hi;
    num_root_between(slope_at, geometry, REAL_EPSILON * hi, 1, hi, -1, 2 * REAL_EPSILON, &theta);
    geometry->leave = tilt_of(theta);
    return theta;
}

/* Returns how far a head reaches beyond the next domino. `sharp` is this length with sharp edges. */
static real beyond(const struct rounded *of, real sharp)
{
    return fmax(sharp - of->rho * (2 - PI / 2), 0);
}

KERNEL struct tilt rounded_hit(const struct rounded *of, real gap, real sharp)
{
    const struct turn turn = gap < TURN_NEAR * (of->tall + of->rho)
                                 ? turn_solve(of->tall, of->rho, gap)
                                 : turn_near_reach(of->tall, of->rho, beyond(of, sharp));
    struct tilt hit = turn.tilt;
    hit.y = fmax(hit.y, 0);
    return hit;
}

KERNEL enum dom_status rounded_set(struct geometry *geometry)
{
    struct rounded *of = &geometry->rounded;
    if (geometry->rs > geometry->span * (1 + 2 * REAL_EPSILON))
        return DOM_OUT_OF_REACH;
    of->rho_1 = of->rho / geometry->r;
    of->tall_1 = of->tall / geometry->r;
    const real sharp = fma(-geometry->r, geometry->s, 1);
    geometry->short_of = beyond(of, sharp);
    geometry->c = rounded_hit(of, geometry->rs, sharp);
    real theta = PI / 2; /* at theta_inf, leader and follower are parallel */
    num_root(gap_at, geometry, 0, theta, 0, &theta);
    const real slope = slope_at(theta, geometry);
    geometry->inf = geometry->f = tilt_of(theta);
    geometry->decay = geometry->weight * fmax(0, slope);
    geometry->detaches = slope < 0;
    if (geometry->detaches) {
        theta = rounded_leave(geometry, theta);
        geometry->f = tilt_of(theta + rounded_at(geometry, theta).turn.angle);
    }
    return DOM_OK;
}

KERNEL void rounded_joint(struct geometry *geometry, const struct geometry *follower)
{
    struct rounded *of = &geometry->rounded;
    of->rho_1 = follower->rounded.rho / geometry->r;
    of->tall_1 = follower->rounded.tall / geometry->r;
    geometry->short_of = beyond(&follower->rounded, 1 - geometry->rs);
    geometry->leave = (struct tilt){0, -1, 2};
    if (slope_at(PI / 2, geometry) < 0)
        rounded_leave(geometry, PI / 2);
}

/* A root of led_by is the tilt of a leader whose follower has the tilt `follower`. */
struct led {
    const struct geometry *geometry;
    real follower;
};

static real led_by(real theta, void *context)
{
    const struct led *led = context;
    return theta + rounded_at(led->geometry, theta).turn.angle - led->follower;
}

KERNEL struct tilt rounded_leader(const struct geometry *geometry, struct tilt follower)
{
    struct led led = {geometry, tilt_angle(follower)};
    real most = geometry->leave.v <= 1 ? tilt_angle(geometry->leave) : PI / 2, theta = 0;
    most = fmin(most, led.follower);
    if (led_by(0, &led) >= 0)
        return standing;
    if (!(led_by(most, &led) > 0))
        return tilt_of(most);
    return num_root(led_by, &led, 0, most, 2 * REAL_EPSILON, &theta) == NUM_OK
               ? tilt_of(theta)
               : (struct tilt){REAL_NAN, REAL_NAN, REAL_NAN};
}
