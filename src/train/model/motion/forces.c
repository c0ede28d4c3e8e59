/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The forces in a moving chain, computed from the tail to the head. Part of the torque on a follower
 * accelerates the follower. The rest of the torque acts on its leader, through their contact. When the
 * contact forces are known, Newton's law gives the force of the floor on each domino.
 */
#include "motion/motion.h"
#include <stdlib.h>

/* The force on the last domino shown depends on all dominoes behind it. If n dominoes are shown, forces_find
 * lists n + 64 more dominoes behind them, but at most about FORCES_MORE. The dominoes behind the end of the
 * list all move alike, so forces_push replaces them by a geometric series. */
#define FORCES_MORE 4096

/* This tolerance gives a few digits of a force. */
#define FORCES_TOL ((real)1e-6)

/* The motion of a chain, given by the motion of its head: `omegasq` is tau^2 omega^2, and `acceleration` is
 * tau^2 times the angular acceleration. */
struct kinematics {
    struct tilt head;
    real omegasq, acceleration;
    size_t n; /* number of dominoes that contribute to the sums */
    /*
     * True at the start of a motion that begins with a collision. `omega` is then tau times the angular
     * velocity of the head after the collision. `omega_lost` describes what the followers lose: in the
     * collision, the angular velocity of follower i decreases by theta_i' * `omega_lost` / tau.
     */
    bool hit;
    real omega, omega_lost;
};

/* One domino of a moving chain. Forces are in units of m g of the head, and impulses in units of m g tau of
 * the head. x points forward and z up. */
struct loaded {
    struct link link;
    real second_derivative; /* theta_i'' */
    real size;              /* height / height of the head */
    struct arms arms;       /* arms of the contact with the follower, if there is one */
    bool leaned;            /* true if a follower leans on this domino */
    real force, impulse;    /* of the follower, normal to the back face; NaN if none leans on this domino */
    real x, z;              /* force of the floor on the foot */
    real impulse_x, impulse_z; /* impulse of the floor during the collision; NaN if there is none */
};

/* Lists the dominoes up to the end of the chain, but at most `room`. Returns their number. */
static size_t forces_list(const struct geometry *geometry, struct tilt head, struct loaded *k, size_t room)
{
    struct walk walk = walk_begin(geometry, head, geometry->rolls);
    real size = 1;
    for (size_t n = 0;; k++) {
        *k = (struct loaded){.link = walk.link, .second_derivative = walk.second_derivative, .size = size};
        k->force = k->impulse = k->impulse_x = k->impulse_z = REAL_NAN;
        if (k->link.leads)
            k->arms = walk_arms(&k->link, geometry->rolls);
        if (++n == room || n == geometry->n || !k->link.leads)
            return n;
        k->leaned = true;
        size /= k->link.geometry->r;
        walk_on(&walk);
    }
}

static real geometric(real first, real ratio)
{
    return fabs(ratio) < 1 ? first / (1 - ratio) : first;
}

/* Finds the forces and impulses of all contacts. */
static void forces_push(const struct geometry *geometry, const struct kinematics *kinematics,
                        struct loaded *k, size_t n)
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

static struct push push_on(const struct loaded *k, real normal)
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
static void forces_floor(struct loaded *k, const struct loaded *leader, const struct geometry *head,
                         const struct kinematics *kinematics)
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
    struct push from = push_on(k, k->leaned ? k->force : 0), none = {0, 0};
    struct push onto = leader ? push_on(leader, leader->force) : none;
    /* The torque of the drag acts like a force at 3/4 of the height, and the air that moves along like a
     * force at 2/3 of it. Both forces are normal to the face. */
    const real by = self->inertia / k->size, entrained = self->geometry->entrained * by * 3 / 2,
               back = self->geometry->drag * omegasq * by * 4 / 3 + entrained * theta_2;
    k->x = momentum * (high * theta_2 - across * omegasq) - mass * self->geometry->g.along - from.x + onto.x +
           back * self->tilt.y;
    k->z = momentum * (-across * theta_2 - up * omegasq) + mass * self->geometry->g.down - from.z + onto.z -
           back * self->tilt.x;
    if (!kinematics->hit)
        return;
    real change = leader ? -self->slope * kinematics->omega_lost : kinematics->omega;
    from = push_on(k, k->leaned ? k->impulse : 0);
    onto = leader ? push_on(leader, leader->impulse) : none;
    k->impulse_x = momentum * high * change - from.x + onto.x + entrained * change * self->tilt.y;
    k->impulse_z = -momentum * across * change - from.z + onto.z - entrained * change * self->tilt.x;
    /* at r s = 1, no finite impulse turns the struck domino, so the required friction is infinite */
    if (isnan(k->impulse_x))
        k->impulse_x = (real)INFINITY;
}

/* Finds the motion of a chain at a tilt of its head. */
static enum dom_status forces_motion(const struct segment *st, real theta, struct kinematics *kinematics)
{
    const struct geometry *geometry = &st->geometry;
    real omegasq = 0;
    enum dom_status status = geometry_tilt(geometry, theta, &kinematics->head);
    if (status == DOM_OK)
        status = segment_speed(st, theta, &omegasq);
    kinematics->omegasq = fmax(omegasq, 0);
    if (status == DOM_OK)
        status = chain_acceleration(geometry, kinematics->head, kinematics->omegasq,
                                    &kinematics->acceleration, &kinematics->n);
    kinematics->hit = theta == geometry->lean && st->inertia_ratio > 0;
    kinematics->omega = sqrt(st->start.omegasq);
    /* The collision multiplies all angular velocities by T / (1 + T). So the lost angular velocity is 1 / T
     * times the angular velocity that remains. */
    kinematics->omega_lost = kinematics->hit ? kinematics->omega / st->inertia_ratio : 0;
    return status;
}

/* Finds the forces of the contacts of the first *shown dominoes, or of all if there are fewer. Sets *shown to
 * their number. Returns their list, which the caller frees, or NULL if memory runs out. */
static struct loaded *forces_find(const struct geometry *geometry, const struct kinematics *kinematics,
                                  size_t *shown)
{
    size_t more = *shown < FORCES_MORE ? *shown + 64 : FORCES_MORE,
           room = geometry->n < *shown || geometry->n - *shown < more ? geometry->n : *shown + more;
    struct loaded *list = malloc(room * sizeof *list);
    if (!list)
        return NULL;
    const size_t n = forces_list(geometry, kinematics->head, list, room);
    forces_push(geometry, kinematics, list, n);
    *shown = n < *shown ? n : *shown;
    return list;
}

/* ---- The largest value over a motion ---- */

/* Finds the value at a tilt. */
typedef enum dom_status peak_function(real theta, void *context, real *value);

enum { PEAK_MOST = 24, PEAK_HALVINGS = 24 };

struct peak {
    int samples; /* the number of intervals with which a search begins, at most PEAK_MOST */
    peak_function *at;
    void *context;
    real most;     /* the largest value so far */
    real tol, off; /* a search ends when no peak can exceed `most` by more than tol * |most| + off */
};

static enum dom_status peak_at(struct peak *p, real theta, real *value)
{
    const enum dom_status status = p->at(theta, p->context, value);
    if (status == DOM_OK && *value > p->most)
        p->most = *value;
    return status;
}

/*
 * Searches [lo, hi] for larger values. A piece is bisected only if it may contain such a value. If the values
 * form a parabola, the parabola exceeds three equally spaced values by at most 1/8 of their second
 * difference. To be safe, the test allows for the whole second difference.
 */
static enum dom_status peak_between(struct peak *p, real lo, real hi, const real at[2], int halvings)
{
    real middle = lo + (hi - lo) / 2, value;
    if (!(lo < middle && middle < hi))
        return DOM_OK;
    enum dom_status status = peak_at(p, middle, &value);
    if (status != DOM_OK)
        return status;
    const real most = fmax(fmax(at[0], at[1]), value) + fabs(at[0] - 2 * value + at[1]);
    if (halvings == 0 || !(most > p->most + p->tol * fabs(p->most) + p->off))
        return DOM_OK;
    status = peak_between(p, lo, middle, (real[]){at[0], value}, halvings - 1);
    return status == DOM_OK ? peak_between(p, middle, hi, (real[]){value, at[1]}, halvings - 1) : status;
}

/* Searches [lo, hi], in which the value must not jump. */
static enum dom_status peak_over(struct peak *p, real lo, real hi)
{
    const real step = (hi - lo) / (real)p->samples;
    real value[PEAK_MOST + 1];
    enum dom_status status = DOM_OK;
    for (int k = 0; k <= p->samples && status == DOM_OK; k++)
        status = peak_at(p, k < p->samples ? lo + (real)k * step : hi, &value[k]);
    for (int k = 0; k < p->samples && status == DOM_OK; k++) {
        const real from = lo + (real)k * step, to = k + 1 < p->samples ? from + step : hi;
        status = peak_between(p, from, to, &value[k], PEAK_HALVINGS);
    }
    return status;
}

/* Searches the cycle of a train. The edges of its barrier divide the cycle into parts. Forces jump at the
 * edges, so the search of a part begins and ends just inside. */
static enum dom_status peak_of_cycle(struct peak *p, const struct motion *m)
{
    const real *edge = m->segment.barrier.edge, inside = 16 * REAL_EPSILON;
    enum dom_status status = DOM_OK;
    for (int i = 1; status == DOM_OK && i < m->segment.barrier.edges; i++) {
        const real lo = i == 1 ? 0 : edge[i - 1] * (1 + inside), hi = fmin(edge[i] * (1 - inside), m->end);
        if (lo < hi)
            status = peak_over(p, lo, hi);
    }
    return status;
}

/* ---- The forces of contacts ---- */

/* The smallest force on a domino, divided by the weight of the domino that it pushes, so that forces on
 * dominoes of different sizes can be compared. */
struct least {
    const struct segment *segment;
    real force, theta; /* the smallest force so far, and its tilt */
    size_t domino;     /* the domino on which it acts */
    real impulse;      /* the smallest impulse so far */
};

/* Sets *value to minus the smallest force at a tilt. */
static enum dom_status least_at(real theta, void *context, real *value)
{
    struct least *least = context;
    struct kinematics kinematics = {.n = 0};
    enum dom_status status = forces_motion(least->segment, theta, &kinematics);
    *value = -(real)INFINITY;
    if (status != DOM_OK)
        return status;
    size_t n = kinematics.n;
    struct loaded *list = forces_find(&least->segment->geometry, &kinematics, &n);
    if (!list)
        return DOM_NO_MEMORY;
    for (size_t i = 0; i < n && list[i].leaned; i++) {
        const real force = list[i].force * list[i].size / list[i].link.weight;
        *value = fmax(-force, *value);
        if (force < least->force) {
            least->force = force;
            least->theta = theta;
            least->domino = i;
        }
        if (isfinite(list[i].impulse))
            least->impulse = fmin(list[i].impulse, least->impulse);
    }
    free(list);
    return DOM_OK;
}

enum { CONTACT_SAMPLES = 3 };

KERNEL_SHARED enum dom_status segment_contact(const struct segment *st, real to, real *force)
{
    struct least least = {.segment = st, .force = *force};
    enum dom_status status = DOM_OK;
    for (int k = 0; k <= CONTACT_SAMPLES && status == DOM_OK; k++) {
        real part = (1 - cos(PI * (real)k / CONTACT_SAMPLES)) / 2, value;
        /* The last tilt is `to` itself, because rounding can put lo + (to - lo) beyond it. */
        status = least_at(k < CONTACT_SAMPLES ? st->lo + part * (to - st->lo) : to, &least, &value);
    }
    *force = least.force;
    return status;
}

/* The absolute error of the smallest force is at most an eighth of this. */
#define LEAST_OFF ((real)1e-6)

KERNEL enum dom_status cycle_least_force(const struct request *train, struct dom_least_force *found)
{
    struct motion m;
    struct least least = {.segment = &m.segment, .force = (real)INFINITY, .impulse = (real)INFINITY};
    struct peak peak = {PEAK_MOST / 3, least_at, &least, -(real)INFINITY, FORCES_TOL, LEAST_OFF};
    enum dom_status status = motion_prepare(train, false, &m);
    m.segment.geometry.tol = fmax(m.segment.geometry.tol, FORCES_TOL);
    if (status == DOM_OK)
        status = peak_of_cycle(&peak, &m);
    motion_end(&m);
    if (status == DOM_OK)
        *found = (struct dom_least_force){least.force, least.theta, least.domino, least.impulse};
    return status;
}

KERNEL enum dom_status cycle_forces(const struct request *train, dom_real theta, dom_force_visit *visit,
                                    void *context)
{
    struct motion m;
    struct kinematics kinematics = {.n = 0};
    const struct geometry *geometry = &m.segment.geometry;
    enum dom_status status = motion_prepare(train, false, &m);
    if (status == DOM_OK)
        status = geometry_tilt(geometry, theta, &kinematics.head);
    if (status == DOM_OK && theta > m.end * (1 + 4 * REAL_EPSILON))
        status = DOM_STOPS;
    if (status == DOM_OK)
        status = forces_motion(&m.segment, fmin(theta, m.end), &kinematics);
    size_t n = status == DOM_OK ? kinematics.n : 0;
    struct loaded *list = status == DOM_OK ? forces_find(geometry, &kinematics, &n) : NULL;
    for (size_t i = 0; list && i < n; i++) {
        const struct dom_force force = {.i = i,
                                        .force = list[i].force,
                                        .per_weight = list[i].force * list[i].size / list[i].link.weight,
                                        .impulse = list[i].impulse};
        if (!visit(&force, context))
            break;
    }
    motion_end(&m);
    free(list);
    return status == DOM_OK && !list ? DOM_NO_MEMORY : status;
}

/* ---- The friction of the floor ---- */

/* The relative tolerance of the friction. */
#define FLOOR_TOL fmax((real)1e-7, 16 * REAL_EPSILON)

/* The search from the head backwards ends at the first domino that is slower than this fraction of the head's
 * speed. Nobody would see the dominoes behind it slip. */
#define FLOOR_SHARE ((real)1e-3)

/* The search looks at no more dominoes than this. */
enum { FLOOR_SHOWN = 4096 };

/* Returns the friction coefficient |x| / z that a foot needs if (x, z) is the force of the floor on it. If
 * the floor would have to pull (z <= 0), the friction coefficient is infinite. */
static real friction_needed(real x, real z)
{
    if (x == (real)INFINITY)
        return x;
    return z > 0 ? fabs(x) / z : isnan(x) || isnan(z) ? REAL_NAN : (real)INFINITY;
}

struct floor_search {
    const struct segment *segment;
    struct required_friction *required;
};

/* Finds the friction that the floor needs during the motion, at the tilt theta. Also updates the maxima in
 * *required. */
static enum dom_status floor_at(real theta, void *context, real *value)
{
    const struct floor_search *search = context;
    const struct geometry *head = &search->segment->geometry;
    struct required_friction *required = search->required;
    struct kinematics kinematics = {.n = 0};
    struct loaded *list = NULL;
    size_t n = 0, shown = 0;
    enum dom_status status = forces_motion(search->segment, theta, &kinematics);
    /* More dominoes may move than count for the energy, because light ones do not count. */
    for (size_t next = kinematics.n > required->shown ? kinematics.n : required->shown;
         status == DOM_OK && n == shown && shown < FLOOR_SHOWN; next *= 2) {
        size_t listed = shown = next;
        free(list);
        list = forces_find(head, &kinematics, &listed);
        status = list ? DOM_OK : DOM_NO_MEMORY;
        for (n = 0; list && n < listed && (n == 0 || list[n - 1].link.slope > FLOOR_SHARE);)
            n++;
    }
    *value = -1;
    size_t most = 0;
    for (size_t i = 0; i < n && list; i++) {
        forces_floor(&list[i], i > 0 ? &list[i - 1] : NULL, head, &kinematics);
        const real motion = friction_needed(list[i].x, list[i].z),
                   hit = friction_needed(list[i].impulse_x, list[i].impulse_z);
        if (motion > *value) {
            *value = motion;
            most = i;
        }
        if (hit > required->hit) {
            required->hit = hit;
            required->hit_domino = i;
        }
    }
    free(list);
    required->shown = shown;
    if (*value > required->motion) {
        required->motion = *value;
        required->theta = theta;
        required->domino = most;
    }
    return status;
}

KERNEL enum dom_status floor_over(const struct segment *st, real lo, real hi,
                                  struct required_friction *required)
{
    struct floor_search search = {st, required};
    struct peak peak = {PEAK_MOST, floor_at, &search, required->motion, FLOOR_TOL, 0};
    return peak_over(&peak, lo, hi);
}

KERNEL enum dom_status cycle_floor(const struct request *train, struct dom_floor *floor)
{
    struct motion m;
    struct required_friction required = {0};
    struct floor_search search = {&m.segment, &required};
    struct peak peak = {PEAK_MOST, floor_at, &search, 0, FLOOR_TOL, 0};
    enum dom_status status = motion_prepare(train, false, &m);
    m.segment.geometry.tol = fmax(m.segment.geometry.tol, FORCES_TOL);
    if (status == DOM_OK)
        status = peak_of_cycle(&peak, &m);
    motion_end(&m);
    if (status != DOM_OK)
        return status;
    *floor = (struct dom_floor){required.motion, required.theta, required.domino, required.hit,
                                required.hit_domino};
    return DOM_OK;
}
