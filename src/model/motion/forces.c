/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "motion/forces.h"
#include <stdlib.h>

/*
 * Dominoes beyond those that are shown, so that the last of them has a tail that matters to it: as many
 * again, but of a long train no more than this, since there the tail is taken as near its end (moving_push).
 */
#define FORCES_MORE 4096

/* One domino in the moving chain. */
struct moving {
    struct link link;
    real bend;           /* theta_i'' = d^2 theta_i / d theta^2 */
    real size;           /* height over that of the head */
    real force, impulse; /* of the contact with its follower */
};

/* The chain, as far as it goes or as room is left. */
static size_t moving_list(const struct lean *g, struct tilt head, struct moving *k, size_t room)
{
    size_t n = 1;
    k[0] = (struct moving){.link = link_head(g, head), .bend = 0, .size = 1};
    for (; n < room && n < g->n && k[n - 1].link.leads; n++) {
        k[n].link = k[n - 1].link;
        link_next(&k[n].link);
        k[n].bend = link_bend(&k[n - 1].link, k[n - 1].bend, &k[n].link);
        k[n].size = k[n - 1].size / k[n - 1].link.lean->r;
    }
    return n;
}

static real geometric(real first, real ratio)
{
    return fabs(ratio) < 1 ? first / (1 - ratio) : first;
}

/* From the tail upwards: torques on the followers, and the contacts that carry what is left of them. */
static void moving_push(const struct lean *g, const struct pace *pace, struct moving *k, size_t n)
{
    real rest = 0, push = 0; /* as torques on domino j */
    bool endless = g->n == CHAIN_ENDLESS && k[n - 1].link.leads;
    for (size_t j = n - 1; j > 0; j--) {
        const struct link *own = &k[j].link, *leader = &k[j - 1].link;
        real theta_2 = own->slope * pace->acceleration + k[j].bend * pace->omegasq;
        real gravity = own->weight * (own->tilt.x - own->lean->d * own->tilt.y) / 2;
        real share = !own->leads ? 0 : g->mu > 0 ? torque_ratio(own) : own->step; /* a / b */
        rest = gravity - own->inertia * theta_2 + share * rest;
        push = own->inertia * own->slope * pace->omega_lost + share * push;
        if (j + 1 == n && endless) { /* what comes behind is alike: its torques are a geometric series */
            rest = geometric(rest, g->weight * share);
            push = geometric(push, g->inertia * own->step * share);
        }
        real rb = g->mu > 0 ? contact_arm_b(leader) : leader->turn.Y,
             arm_b = rb / leader->lean->r * k[j - 1].size;
        /* At r s = 1 the collision is at the hinge itself: no force, however large, turns a domino. */
        if (j == 1 && leader->tilt.x == 0 && g->short_of <= REAL_EPSILON)
            arm_b = 0;
        k[j - 1].force = arm_b > 0 ? rest / arm_b : REAL_NAN;
        k[j - 1].impulse = pace->hit && arm_b > 0 ? push / arm_b : REAL_NAN;
    }
}

/* A push on a domino's back face, with the friction that drags it down. */
struct push {
    real x, z;
};

static struct push push_on(const struct moving *k, real normal)
{
    real mu = k->link.lean->mu;
    struct tilt t = k->link.tilt;
    return (struct push){normal * (t.y - mu * t.x), normal * (-t.x - mu * t.y)};
}

/*
 * Newton's law for the middle of the block, which is at (x - d y, y + d x) / 2 from its hinge: what contacts
 * and gravity leave to the floor.
 */
static void hinge_find(const struct moving *k, const struct moving *leader, bool leaned, real d_head,
                       const struct pace *pace, struct held *held)
{
    const struct link *own = &k->link;
    real tausq = (1 + d_head * d_head) / 3; /* in h/g of the head */
    real mass = own->weight / k->size, d = own->lean->d, across = (own->tilt.x - d * own->tilt.y) / 2,
         up = (own->tilt.y + d * own->tilt.x) / 2, momentum = mass * k->size / tausq;
    real theta_2 = own->slope * pace->acceleration + k->bend * pace->omegasq;
    real omegasq = own->slope * own->slope * pace->omegasq;
    struct push from = push_on(k, leaned ? k->force : 0), none = {0, 0};
    struct push onto = leader ? push_on(leader, leader->force) : none;
    held->x = momentum * (up * theta_2 - across * omegasq) - from.x + onto.x;
    held->z = momentum * (-across * theta_2 - up * omegasq) + mass - from.z + onto.z;
    if (!pace->hit)
        return;
    real change = leader ? -own->slope * pace->omega_lost : pace->omega;
    from = push_on(k, leaned ? k->impulse : 0);
    onto = leader ? push_on(leader, leader->impulse) : none;
    held->blow_x = momentum * up * change - from.x + onto.x;
    held->blow_z = -momentum * across * change - from.z + onto.z;
    if (isnan(held->blow_x)) /* at r s = 1 no impulse, however large, does: no floor holds that */
        held->blow_x = (real)INFINITY;
}

/* The list with room for n; what was in it is lost. */
static struct moving *room_for(struct room *room, size_t n)
{
    if (room->size >= n)
        return room->list;
    free(room->list);
    *room = (struct room){.list = malloc(n * sizeof *room->list), .size = n};
    if (!room->list)
        room->size = 0;
    return room->list;
}

KERNEL enum dom_status forces_walk(const struct lean *g, struct tilt head, const struct pace *pace,
                                   size_t shown, held_visit *visit, void *context)
{
    size_t more = shown < FORCES_MORE ? shown + 64 : FORCES_MORE;
    size_t room = g->n - shown < more || g->n < shown ? g->n : shown + more;
    struct room own = {0}, *list = pace->room ? pace->room : &own;
    struct moving *k = room_for(list, room);
    if (!k)
        return DOM_NO_MEMORY;
    size_t n = moving_list(g, head, k, room);
    moving_push(g, pace, k, n);
    for (size_t i = 0; i < n && i < shown; i++) {
        struct held held = {
            .link = &k[i].link,
            .size = k[i].size,
            .leaned = i + 1 < n,
            .force = i + 1 < n ? k[i].force : REAL_NAN,
            .impulse = i + 1 < n ? k[i].impulse : REAL_NAN,
        };
        held.x = held.z = held.blow_x = held.blow_z = REAL_NAN;
        if (pace->floor)
            hinge_find(&k[i], i > 0 ? &k[i - 1] : NULL, held.leaned, g->d, pace, &held);
        if (!visit(&held, context))
            break;
    }
    free(own.list);
    return DOM_OK;
}

KERNEL real forces_needed(real x, real z)
{
    if (x == (real)INFINITY)
        return x;
    return z > 0 ? fabs(x) / z : isnan(x) || isnan(z) ? REAL_NAN : (real)INFINITY;
}

/* ---- Of a train ---- */

/* The old train's domino j - 1 is this one's j: in the collision its theta_j' omega falls to J-1 of J. */
KERNEL enum dom_status motion_pace(struct motion *m, real theta, struct tilt head, struct pace *pace)
{
    const struct lean *g = &m->cycle.lean;
    enum dom_status status = cycle_speed(&m->cycle, theta, &pace->omegasq, NULL);
    pace->room = &m->room;
    pace->omegasq = fmax(pace->omegasq, 0);
    if (status == DOM_OK)
        status = motion_acceleration(g, head, pace->omegasq, &pace->acceleration, &pace->n);
    pace->hit = theta == 0;
    pace->omega = sqrt(m->cycle.launch.omegasq);
    pace->omega_lost = pace->omega / (g->mu > 0 ? g->flow->T : m->cycle.launch.J0 - 1);
    return status;
}

struct force_context {
    dom_force_visit *visit;
    void *context;
};

static bool force_visit(const struct held *held, void *context)
{
    struct force_context *c = context;
    struct dom_force force = {
        .i = held->link->i,
        .force = held->force,
        .of_own = held->force * held->size / held->link->weight,
        .impulse = held->impulse,
    };
    return c->visit(&force, c->context);
}

KERNEL enum dom_status cycle_forces(const struct dom_train *train, dom_real theta_, dom_force_visit *visit,
                                    void *context)
{
    struct motion m;
    FLOW(flow);
    struct tilt head = {0, 1, 0};
    struct pace pace = {0};
    real theta = (real)theta_;
    enum dom_status status = motion_begin(train, &flow, &m, false);
    if (status == DOM_OK)
        status = lean_tilt(&m.cycle.lean, theta, &head);
    if (status == DOM_OK && theta > m.end * (1 + 4 * REAL_EPSILON))
        status = DOM_STOPS;
    if (status == DOM_OK)
        status = motion_pace(&m, fmin(theta, m.end), head, &pace);
    struct force_context c = {visit, context};
    if (status == DOM_OK)
        status = forces_walk(&m.cycle.lean, head, &pace, pace.n, force_visit, &c);
    motion_end(&m);
    return status;
}

/* ---- The smallest contact force ---- */

/* The smallest force so far, the tilt and the domino; and that at the tilt that was asked for last. */
struct least_context {
    struct motion motion;
    real theta, force, least, least_theta, impulse;
    size_t domino, dominoes; /* the second: in motion */
    enum dom_status status;
};

static bool least_seen(const struct held *held, void *context)
{
    struct least_context *c = context;
    if (!held->leaned)
        return true;
    real force = held->force * held->size / held->link->weight;
    c->force = fmin(force, c->force);
    if (force < c->least) {
        c->least = force;
        c->least_theta = c->theta;
        c->domino = held->link->i;
    }
    if (isfinite(held->impulse))
        c->impulse = fmin(held->impulse, c->impulse);
    return true;
}

/* Minus the smallest force at a tilt, as a function to be maximized. */
static real least_at(real theta, void *context)
{
    struct least_context *c = context;
    struct tilt head;
    struct pace pace = {0};
    const struct lean *g = &c->motion.cycle.lean;
    c->theta = theta;
    c->force = (real)INFINITY;
    c->status = lean_tilt(g, theta, &head);
    if (c->status == DOM_OK)
        c->status = motion_pace(&c->motion, theta, head, &pace);
    c->dominoes = pace.n;
    if (c->status == DOM_OK)
        c->status = forces_walk(g, head, &pace, pace.n, least_seen, c);
    return c->status == DOM_OK ? -c->force : REAL_NAN;
}

/* A force is smallest where it is between two samples, to a thousandth of their distance. */
#define LEAST_SAMPLES 24
#define LEAST_LONG    100000 /* dominoes: a train that long, of a tiny s, moves smoothly, and a third serves */
#define LEAST_TOL     ((real)1e-3 / LEAST_SAMPLES)

/* Over [lo, hi], where forces do not jump. */
static enum dom_status least_over(struct least_context *c, real lo, real hi)
{
    real value[LEAST_SAMPLES + 1], at;
    value[0] = least_at(lo, c);
    const int samples = c->dominoes > LEAST_LONG ? LEAST_SAMPLES / 3 : LEAST_SAMPLES;
    const real step = (hi - lo) / (real)samples;
    int top = 0;
    for (int k = 1; k <= samples && c->status == DOM_OK; k++) {
        value[k] = least_at(k < samples ? lo + (real)k * step : hi, c);
        top = value[k] > value[top] ? k : top;
    }
    if (c->status != DOM_OK)
        return c->status;
    real middle = lo + (real)top * step, before = middle - step, behind = middle + step;
    if (top == 0) { /* at the end itself, unless forces fall from there on */
        before = lo;
        middle = lo + step * LEAST_TOL;
    } else if (top == samples) {
        behind = hi;
        middle = hi - step * LEAST_TOL;
    }
    real higher = fmax(value[0], value[samples]), noise = FORCES_TOL * fabs(higher);
    if (isfinite(value[top]) && least_at(middle, c) > higher + noise)
        num_maximum(least_at, c, before, middle, behind, LEAST_TOL, &at);
    return c->status;
}

KERNEL enum dom_status cycle_least_force(const struct dom_train *train, struct dom_least_force *least)
{
    FLOW(flow);
    struct least_context c = {.least = (real)INFINITY, .impulse = (real)INFINITY};
    enum dom_status status = motion_begin(train, &flow, &c.motion, false);
    if (status != DOM_OK)
        return status;
    const struct barrier *b = &c.motion.cycle.barrier;
    struct lean *g = &c.motion.cycle.lean;
    g->tol = fmax(g->tol, FORCES_TOL);
    /* A force jumps where a follower leaves: up to there and from there. */
    for (int i = 1; i < b->edges && status == DOM_OK; i++) {
        const real inside = 16 * REAL_EPSILON;
        real lo = i == 1 ? 0 : b->edge[i - 1] * (1 + inside),
             hi = fmin(b->edge[i] * (1 - inside), c.motion.end);
        if (lo < hi)
            status = least_over(&c, lo, hi);
    }
    motion_end(&c.motion);
    if (status == DOM_OK)
        *least = (struct dom_least_force){c.least, c.least_theta, c.domino, c.impulse};
    return status;
}
