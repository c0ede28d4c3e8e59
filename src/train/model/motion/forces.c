/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "motion/forces.h"
#include <stdlib.h>

/* The force on the last domino shown depends on all dominoes behind it. If n dominoes are shown, forces_walk
 * lists n + 64 more dominoes behind them, but at most about FORCES_MORE. The dominoes behind the end of the
 * list all move alike, so moving_push replaces them by a geometric series. */
#define FORCES_MORE 4096

/* One domino of a moving chain. */
struct moving {
    struct link link;
    real second_derivative; /* theta_i'' */
    real size;              /* height / height of the head */
    struct arms arms;       /* arms of the contact with the follower, if there is one */
    real force, impulse;    /* force and impulse of this contact, set by moving_push */
};

/* Lists the dominoes up to the end of the chain, but at most `room`. Returns their number. */
static size_t moving_list(const struct geometry *geometry, struct tilt head, struct moving *k, size_t room)
{
    struct walk walk = geometry->law->begin(geometry, head);
    real size = 1;
    for (size_t n = 0;; k++) {
        *k = (struct moving){.link = walk.link, .second_derivative = walk.second_derivative, .size = size};
        if (k->link.leads)
            k->arms = k->link.geometry->law->arms(&k->link);
        if (++n == room || n == geometry->n || !k->link.leads)
            return n;
        size /= k->link.geometry->r;
        geometry->law->next(&walk);
    }
}

static real geometric(real first, real ratio)
{
    return fabs(ratio) < 1 ? first / (1 - ratio) : first;
}

static void moving_push(const struct geometry *geometry, const struct kinematics *kinematics,
                        struct moving *k, size_t n)
{
    /* `rest` is the torque on domino j that the contact with its leader must balance. `push` is the angular
     * momentum that this contact must supply in the collision. */
    real rest = 0, push = 0;
    bool endless = geometry->n == CHAIN_ENDLESS && k[n - 1].link.leads;
    for (size_t j = n - 1; j > 0; j--) {
        const struct link *self = &k[j].link, *leader = &k[j - 1].link;
        real theta_2 = self->slope * kinematics->acceleration + k[j].second_derivative * kinematics->omegasq;
        real gravity = -self->weight * geometry_lift(self->geometry, self->tilt) / 2;
        real torque_share = self->leads ? k[j].arms.ratio : 0;
        real inertia = self->inertia * geometry_inertia(self->geometry, self->tilt),
             grows = self->inertia * geometry_inertia_slope(self->geometry, self->tilt),
             omegasq = self->slope * self->slope * kinematics->omegasq;
        rest = gravity - inertia * theta_2 - (grows / 2 + self->inertia * self->geometry->drag) * omegasq +
               torque_share * rest;
        push = inertia * self->slope * kinematics->omega_lost + torque_share * push;
        /* the dominoes past the end of the list all move alike, so their torques form a geometric series */
        if (j + 1 == n && endless) {
            rest = geometric(rest, geometry->weight * torque_share);
            push = geometric(push, geometry->inertia * self->contact.slope * torque_share);
        }
        real arm_b = k[j - 1].arms.b / leader->geometry->r * k[j - 1].size;
        /* At r s = 1, the tip hits the leader's hinge, and the force has no lever arm. */
        if (j == 1 && leader->tilt.x == 0 && geometry->short_of <= REAL_EPSILON)
            arm_b = 0;
        k[j - 1].force = arm_b > 0 ? rest / arm_b : REAL_NAN;
        k[j - 1].impulse = kinematics->hit && arm_b > 0 ? push / arm_b : REAL_NAN;
    }
}

/* A push on the back face of a domino, including the friction that pulls the face down. */
struct push {
    real x, z;
};

static struct push push_on(const struct moving *k, real normal)
{
    real mu = k->link.geometry->mu;
    struct tilt t = k->link.tilt;
    return (struct push){normal * (t.y - mu * t.x), normal * (-t.x - mu * t.y)};
}

/*
 * Finds the force of the floor from Newton's law for the centre of the domino. Relative to the hinge, the
 * centre is at (x - d y, y + d x) / 2. A domino with rounded edges has no hinge. In its place, the function
 * uses the centre of the rounded lower edge, which moves parallel to the floor at the height rho.
 */
static void hinge_find(const struct moving *k, const struct moving *leader, bool leaned,
                       const struct geometry *head, const struct kinematics *kinematics,
                       struct hinge_load *hinge_load)
{
    const struct link *self = &k->link;
    real tausq = head->inertia_factor * (1 + head->d * head->d) / 3; /* tau^2 of the head, in units of h/g */
    const struct rounded *shape = &self->geometry->rounded;
    real mass = self->weight / k->size,
         across = (shape->tall * self->tilt.x - shape->wide * self->tilt.y) / 2,
         up = (shape->tall * self->tilt.y + shape->wide * self->tilt.x) / 2, high = up + shape->rho,
         momentum = mass * k->size / tausq;
    real theta_2 = self->slope * kinematics->acceleration + k->second_derivative * kinematics->omegasq;
    real omegasq = self->slope * self->slope * kinematics->omegasq;
    struct push from = push_on(k, leaned ? k->force : 0), none = {0, 0};
    struct push onto = leader ? push_on(leader, leader->force) : none;
    /* The torque of the drag acts like a force at 3/4 of the height, and the air that moves along like a
     * force at 2/3 of it. Both forces are normal to the face. */
    const real by = self->inertia / k->size, entrained = self->geometry->entrained * by * 3 / 2,
               back = self->geometry->drag * omegasq * by * 4 / 3 + entrained * theta_2;
    hinge_load->x = momentum * (high * theta_2 - across * omegasq) - mass * self->geometry->g.along - from.x +
                    onto.x + back * self->tilt.y;
    hinge_load->z = momentum * (-across * theta_2 - up * omegasq) + mass * self->geometry->g.down - from.z +
                    onto.z - back * self->tilt.x;
    if (!kinematics->hit)
        return;
    real change = leader ? -self->slope * kinematics->omega_lost : kinematics->omega;
    from = push_on(k, leaned ? k->impulse : 0);
    onto = leader ? push_on(leader, leader->impulse) : none;
    hinge_load->impulse_x = momentum * high * change - from.x + onto.x + entrained * change * self->tilt.y;
    hinge_load->impulse_z = -momentum * across * change - from.z + onto.z - entrained * change * self->tilt.x;
    /* at r s = 1, no finite impulse turns the struck domino, so the required friction is infinite */
    if (isnan(hinge_load->impulse_x))
        hinge_load->impulse_x = (real)INFINITY;
}

/* Returns a list of n dominoes, or NULL if memory runs out. The old contents are lost. */
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

KERNEL enum dom_status forces_walk(const struct geometry *geometry, struct tilt head,
                                   const struct kinematics *kinematics, size_t shown, hinge_load_visit *visit,
                                   void *context)
{
    size_t more = shown < FORCES_MORE ? shown + 64 : FORCES_MORE;
    size_t room = geometry->n - shown < more || geometry->n < shown ? geometry->n : shown + more;
    struct room self = {0}, *list = kinematics->room ? kinematics->room : &self;
    struct moving *k = room_for(list, room);
    if (!k)
        return DOM_NO_MEMORY;
    size_t n = moving_list(geometry, head, k, room);
    moving_push(geometry, kinematics, k, n);
    for (size_t i = 0; i < n && i < shown; i++) {
        struct hinge_load hinge_load = {
            .link = &k[i].link,
            .size = k[i].size,
            .leaned = i + 1 < n,
            .force = i + 1 < n ? k[i].force : REAL_NAN,
            .impulse = i + 1 < n ? k[i].impulse : REAL_NAN,
        };
        hinge_load.x = hinge_load.z = hinge_load.impulse_x = hinge_load.impulse_z = REAL_NAN;
        if (kinematics->floor)
            hinge_find(&k[i], i > 0 ? &k[i - 1] : NULL, hinge_load.leaned, geometry, kinematics, &hinge_load);
        if (!visit(&hinge_load, context))
            break;
    }
    free(self.list);
    return DOM_OK;
}

KERNEL real friction_needed(real x, real z)
{
    if (x == (real)INFINITY)
        return x;
    return z > 0 ? fabs(x) / z : isnan(x) || isnan(z) ? REAL_NAN : (real)INFINITY;
}

/* ---- The forces during a motion ---- */

KERNEL enum dom_status segment_kinematics(const struct segment *st, real theta, struct tilt *head,
                                          struct kinematics *kinematics)
{
    const struct geometry *geometry = &st->geometry;
    real omegasq = 0;
    kinematics->room = st->room;
    enum dom_status status = geometry_tilt(geometry, theta, head);
    if (status == DOM_OK)
        status = segment_speed(st, theta, &omegasq);
    kinematics->omegasq = fmax(omegasq, 0);
    if (status == DOM_OK)
        status = geometry->dynamics->acceleration(geometry, *head, kinematics->omegasq,
                                                  &kinematics->acceleration, &kinematics->n);
    kinematics->hit = theta == geometry->lean && st->inertia_ratio > 0;
    kinematics->omega = sqrt(st->start.omegasq);
    /* The collision multiplies all angular velocities by T / (1 + T). So the lost angular velocity is 1 / T
     * times the angular velocity that remains. */
    kinematics->omega_lost = kinematics->hit ? kinematics->omega / st->inertia_ratio : 0;
    return status;
}

struct force_context {
    dom_force_visit *visit;
    void *context;
};

static bool force_visit(const struct hinge_load *hinge_load, void *context)
{
    struct force_context *c = context;
    struct dom_force force = {
        .i = hinge_load->link->i,
        .force = hinge_load->force,
        .per_weight = hinge_load->force * hinge_load->size / hinge_load->link->weight,
        .impulse = hinge_load->impulse,
    };
    return c->visit(&force, c->context);
}

KERNEL enum dom_status cycle_forces(const struct request *train, dom_real theta_, dom_force_visit *visit,
                                    void *context)
{
    struct motion m;
    const struct geometry *geometry = &m.cycle.segment.geometry;
    struct tilt head;
    struct kinematics kinematics = {0};
    real theta = (real)theta_;
    enum dom_status status = motion_begin(train, false, &m);
    if (status == DOM_OK)
        status = geometry_tilt(geometry, theta, &head);
    if (status == DOM_OK && theta > m.end * (1 + 4 * REAL_EPSILON))
        status = DOM_STOPS;
    if (status == DOM_OK)
        status = segment_kinematics(&m.cycle.segment, fmin(theta, m.end), &head, &kinematics);
    struct force_context c = {visit, context};
    if (status == DOM_OK)
        status = forces_walk(geometry, head, &kinematics, kinematics.n, force_visit, &c);
    motion_end(&m);
    return status;
}

/* ---- The smallest contact force ---- */

/* To compare forces on dominoes of different sizes, each force here is divided by the weight of the domino
 * that it pushes. */
struct least_context {
    const struct segment *segment;
    real theta, force;       /* the current tilt, and the smallest force there */
    real least, least_theta; /* the smallest force so far, and its tilt */
    real impulse;            /* the smallest impulse so far */
    size_t domino;           /* the domino on which `least` acts */
    size_t dominoes;         /* number of moving dominoes */
    enum dom_status status;
};

static bool least_seen(const struct hinge_load *hinge_load, void *context)
{
    struct least_context *c = context;
    if (!hinge_load->leaned)
        return true;
    real force = hinge_load->force * hinge_load->size / hinge_load->link->weight;
    c->force = fmin(force, c->force);
    if (force < c->least) {
        c->least = force;
        c->least_theta = c->theta;
        c->domino = hinge_load->link->i;
    }
    if (isfinite(hinge_load->impulse))
        c->impulse = fmin(hinge_load->impulse, c->impulse);
    return true;
}

/* Returns minus the smallest force at a tilt, so that a search for a maximum finds the smallest force. */
static real least_at(real theta, void *context)
{
    struct least_context *c = context;
    struct tilt head;
    struct kinematics kinematics = {0};
    c->theta = theta;
    c->force = (real)INFINITY;
    c->status = segment_kinematics(c->segment, theta, &head, &kinematics);
    c->dominoes = kinematics.n;
    if (c->status == DOM_OK)
        c->status = forces_walk(&c->segment->geometry, head, &kinematics, kinematics.n, least_seen, c);
    return c->status == DOM_OK ? -c->force : REAL_NAN;
}

#define LEAST_SAMPLES 24
/* A train with more dominoes than this moves so smoothly that a third of the samples is enough. */
#define LEAST_LONG 100000
/* The relative tolerance of the tilt at which the force is smallest. If the samples begin at the tilt 0, no
 * tilt is larger than LEAST_SAMPLES times the spacing of the samples, so the error is at most 1/1000 of this
 * spacing. */
#define LEAST_TOL ((real)1e-3 / LEAST_SAMPLES)

/* Finds the smallest force over [lo, hi]. Forces must not jump inside this interval. */
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
    real middle = lo + (real)top * step, before = middle - step, after = middle + step;
    if (top == 0) { /* the minimum is at lo itself, unless the force decreases just after lo */
        before = lo;
        middle = lo + step * LEAST_TOL;
    } else if (top == samples) {
        after = hi;
        middle = hi - step * LEAST_TOL;
    }
    real higher = fmax(value[0], value[samples]), noise = FORCES_TOL * fabs(higher);
    if (isfinite(value[top]) && least_at(middle, c) > higher + noise)
        num_maximum(least_at, c, before, middle, after, LEAST_TOL, &at);
    return c->status;
}

enum { CONTACT_SAMPLES = 3 };

KERNEL enum dom_status segment_contact(struct segment *st, real to, real *least)
{
    struct least_context c = {.segment = st, .least = *least, .status = DOM_OK};
    for (int k = 0; k <= CONTACT_SAMPLES && c.status == DOM_OK; k++) {
        real part = (1 - cos(PI * (real)k / CONTACT_SAMPLES)) / 2;
        /* The last tilt is `to` itself, because rounding can put lo + (to - lo) beyond it. */
        least_at(k < CONTACT_SAMPLES ? st->lo + part * (to - st->lo) : to, &c);
    }
    *least = c.least;
    return c.status;
}

KERNEL bool motion_part(const struct motion *m, int i, real *lo, real *hi)
{
    const real *edge = m->cycle.segment.barrier.edge, inside = 16 * REAL_EPSILON;
    *lo = i == 1 ? 0 : edge[i - 1] * (1 + inside);
    *hi = fmin(edge[i] * (1 - inside), m->end);
    return *lo < *hi;
}

KERNEL enum dom_status cycle_least_force(const struct request *train, struct dom_least_force *least)
{
    struct motion m;
    struct segment *st = &m.cycle.segment;
    struct least_context c = {.segment = st, .least = (real)INFINITY, .impulse = (real)INFINITY};
    enum dom_status status = motion_begin(train, false, &m);
    st->geometry.tol = fmax(st->geometry.tol, FORCES_TOL);
    for (int i = 1; status == DOM_OK && i < st->barrier.edges; i++) {
        real lo, hi;
        if (motion_part(&m, i, &lo, &hi))
            status = least_over(&c, lo, hi);
    }
    motion_end(&m);
    if (status == DOM_OK)
        *least = (struct dom_least_force){c.least, c.least_theta, c.domino, c.impulse};
    return status;
}
