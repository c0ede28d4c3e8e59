/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Describes a finite row as a chain, so that the formulas for trains can be used. Two neighbours form a
 * joint. The joint has the geometry of a train with the r, s and d of these two dominoes. Each domino has
 * units of its own: the unit of length is its height, and the unit of energy is its m g h / 2.
 */
#include "dynamics/dynamics.h"
#include "effects/effects.h"
#include "row/row.h"
#include <stdlib.h>

/*
 * Allows for rounding errors in a gap. A head counts as reaching the next domino even if the gap exceeds the
 * reach of the head by up to this fraction. With sharp edges, the reach is the height. Example: in a row that
 * is made from a train with r = 1/s, each gap equals the height of the domino before it, but only up to the
 * rounding errors of r, of the heights and of the gap.
 */
#define REACH_ROUNDED (4 * REAL_EPSILON)

KERNEL bool row_releases(const struct dom_row *row)
{
    return row->release > 0 && !isnan(row->push);
}

/* Returns the lean of domino k, which is 0 for a first domino that is released. */
static real row_lean(const struct dom_row *row, size_t k)
{
    return k == 0 && row_releases(row) ? 0 : (real)row->domino[k].lean;
}

/* Sets the geometry of the contact between domino k and its follower k - 1. */
static void joint_shape(const struct dom_row *row, size_t k, struct geometry *geometry)
{
    const real height = (real)row->domino[k].height, previous = (real)row->domino[k - 1].height,
               gap = (real)row->domino[k].gap;
    geometry->r = height / previous;
    geometry->s = gap / height;
    geometry->L = geometry->s + geometry->d;
    geometry->rs = gap / previous;
    geometry->rL = geometry->r * geometry->L;
    geometry->short_of = fmax((previous - gap) / previous, 0);
    geometry->leave_at = geometry->short_of * (1 + gap / previous);
    geometry->leave_by = 2 * geometry->d * geometry->L * geometry->r * geometry->r;
    real v = geometry->leave_at / geometry->leave_by;
    geometry->leave = v < 2 ? (struct tilt){sqrt(v * (2 - v)), 1 - v, v} : (struct tilt){0, -1, 2};
}

static void joint_make(const struct dom_row *row, size_t k, const struct geometry *follower,
                       struct geometry *geometry)
{
    joint_shape(row, k, geometry);
    geometry->weight = (real)row->domino[k - 1].mass / (real)row->domino[k].mass / geometry->r;
    geometry->inertia = geometry->weight / geometry->r * (1 + follower->d * follower->d) /
                        (1 + geometry->d * geometry->d) *
                        (follower->inertia_factor / geometry->inertia_factor);
    geometry->follower = follower;
    if (geometry->rolls)
        rounded_joint(geometry, follower);
    /*
     * A sum along the chain may end at domino k and leave out the dominoes k - 1, k - 2, ... To know how much
     * is left out, upper bounds are needed. `weights` is a bound on the weights of the dominoes left out, as
     * a multiple of the weight of domino k. `moments` is the same bound for moments of inertia.
     */
    real weights = geometry->weight * follower->steepest / geometry->steepest *
                   (1 + follower->decay / (1 - follower->decay));
    real moments = geometry->inertia * (1 + follower->decay_J / (1 - follower->decay_J));
    if (geometry->lean < 0) {
        /* While the domino leans backwards, the slope is 1 + r L |x| / Y. The denominator Y is smallest when
         * the domino is upright, so its value there gives an upper bound on the slope. */
        real by = -geometry->rL * sin(geometry->lean) / sqrt(geometry->leave_at), most = 1 + 2 * by;
        weights = by < 1 ? weights * most : (real)INFINITY;
        moments = by < 1 ? moments * most * most : (real)INFINITY;
    }
    /* If a bound is too large to be useful, its ratio (decay or decay_J) is set to 1. The sum then leaves out
     * no domino. */
    geometry->decay = weights < 1 / REAL_EPSILON ? weights / (1 + weights) : 1;
    geometry->decay_J = moments < 1 / REAL_EPSILON ? moments / (1 + moments) : 1;
}

/*
 * Finds where domino k touches domino k + 1, if one of the two leans at the start. Sets *contact to their
 * contact, and *tilt to the tilt of domino k at that moment. Returns false if the edge of domino k misses the
 * back face of domino k + 1, or if the two dominoes already touch at the start.
 */
static bool lean_touch(const struct dom_row *row, size_t k, struct contact *contact, struct tilt *tilt)
{
    const struct dom_domino *other = &row->domino[k + 1];
    struct geometry next = {.d = (real)(other->thickness / other->height), .lean = (real)other->lean};
    joint_shape(row, k + 1, &next);
    *contact = geometry_contact(&next, geometry_rest(&next));
    *tilt = tilt_follower(geometry_rest(&next), *contact);
    contact->arm /= next.r;
    return contact->X >= 0 && contact->arm > 0 && tilt_angle(*tilt) >= row_lean(row, k);
}

/* Returns the tilt at which domino k hits the next one, or lies on the floor if it hits nothing. */
static struct tilt row_end(const struct dom_row *row, size_t k, const struct geometry *geometry)
{
    const struct tilt lies = {1, 0, 1};
    const struct dom_domino *self = &row->domino[k], *next = self + 1;
    struct contact contact;
    struct tilt tilt;
    if (k + 1 == row->count)
        return lies;
    const real gap = next->gap / self->height;
    if (next->lean == 0 && geometry->lean == 0)
        return geometry->rolls ? rounded_hit(&geometry->rounded, gap, 1 - gap)
                               : tilt_make(fmin(gap, 1), sqrt(fmax((1 - gap) * (1 + gap), 0)));
    if (next->gap > self->height * (1 + REACH_ROUNDED))
        return lies;
    return lean_touch(row, k, &contact, &tilt) ? tilt : contact.arm > 0 ? geometry_rest(geometry) : lies;
}

KERNEL enum dom_row_end joint_ends(const struct row *row, size_t k)
{
    const struct dom_row *given = &row->given;
    const struct dom_domino *self = &given->domino[k], *next = self + 1;
    const struct geometry *hits = &row->geometry[k];
    const real top = hits->rounded.rho + hits->rounded.tall * hits->c.y,
               flat = 1 - row->geometry[k + 1].rounded.rho;
    struct contact contact;
    struct tilt tilt;
    if (next->gap > hits->span * self->height * (1 + REACH_ROUNDED))
        return DOM_ROW_MISSES;
    /* the first domino would be inside the second one when it is released */
    if (k == 0 && row_releases(given) && isfinite(given->release) &&
        given->release > hits->lean * (1 + REACH_ROUNDED))
        return DOM_ROW_SKEWED;
    if (row_lean(given, k) != 0 || next->lean != 0)
        return !lean_touch(given, k, &contact, &tilt) ? DOM_ROW_SKEWED
               : contact.arm > 1                      ? DOM_ROW_PASSES
                                                      : DOM_ROW_FALLS;
    return self->height * top > flat * next->height ? DOM_ROW_PASSES : DOM_ROW_FALLS;
}

KERNEL_SHARED enum dom_status row_geometry(struct row *row, size_t k)
{
    const struct dom_row *given = &row->given;
    const struct dom_train own = dynamics_of_domino(given, k);
    struct geometry *geometry = &row->geometry[k];
    const enum dom_status status = dynamics_read(&own, &row->compute, geometry);
    geometry->flow = &row->flow;
    geometry->lean = row_lean(given, k);
    geometry->short_of = 1;
    geometry->n = k + 1;
    geometry->c = row_end(given, k, geometry);
    if (k == 0 && row_releases(given))
        geometry->lean = fmin((real)given->release, tilt_angle(geometry->c));
    if (k > 0)
        joint_make(given, k, geometry - 1, geometry);
    return status;
}

/* Returns true if a number is positive and finite, even after rounding to the precision of the kernel. */
static bool positive(dom_real value)
{
    return (real)value > REAL_MIN && (real)value < 1 / REAL_MIN;
}

/* Also checks values that are computed from the sizes, since these may underflow or overflow. */
KERNEL_SHARED enum dom_status row_domino_check(const struct dom_row *row, size_t k)
{
    const struct dom_domino *d = &row->domino[k];
    const struct dom_train own = dynamics_of_domino(row, k);
    const bool leans = row_lean(row, k) != 0, rounds = row->rho != 0;
    struct dom_box box;
    return !positive(d->height)                          ? DOM_BAD_HEIGHT
           : !positive(d->thickness) || !positive(own.d) ? DOM_BAD_THICKNESS
           : !positive(d->mass) || !positive((real)d->mass * (real)row->g * (real)d->height / 2)
               ? DOM_BAD_MASS
           : !(d->gap >= 0) || !isfinite(d->gap)                                            ? DOM_BAD_GAP
           : !(d->radius >= 0 && (!rounds || d->radius < d->height / 2))                    ? DOM_BAD_RADIUS
           : 2 * own.rho > own.d                                                            ? DOM_NO_ROUND
           : own.walls != 0 && dom_box_find(1, own.d, own.width, own.walls, &box) != DOM_OK ? DOM_NO_ROOM
           : leans && own.rho != 0                                                          ? DOM_NO_LEAN
           /* a leaning domino with sharp edges must not tip over the front or back edge of its foot */
           : leans && !(fabs(d->lean + row->alpha) < atan(own.d)) ? DOM_BAD_LEAN
                                                                  : DOM_OK;
}

KERNEL_SHARED bool row_repeats(const struct dom_row *row, size_t k)
{
    const struct dom_domino *a = &row->domino[k], *b = a - 1;
    return a->height == b->height && a->thickness == b->thickness && a->gap == b->gap && a->mass == b->mass &&
           a->radius == b->radius && a->lean == b->lean && a->width == b->width;
}

KERNEL_SHARED enum dom_status row_begin(const struct dom_row *given, const struct dom_compute *compute,
                                        struct row *row, size_t *wrong)
{
#define OF_ROW(effect, member, status) .member = given->member,
    const struct dom_train effects_given = {DOM_DYNAMICS(OF_ROW).q = 4};
    const dom_real push = given->push, tol = compute_or_default(compute).tol;
#undef OF_ROW
    size_t count = given->count;
    *row = (struct row){.given = *given, .compute = compute_or_default(compute)};
    if (!row->compute.work)
        row->compute.work = &row->work;
    enum dom_status status = dom_arithmetic()->bits == 0                  ? DOM_NO_PRECISION
                             : IS_NEWER(given) || IS_NEWER(&row->compute) ? DOM_NEWER
                             : count == 0                                 ? DOM_BAD_COUNT
                             : !positive(given->g)                        ? DOM_BAD_G
                             : !(tol >= dom_arithmetic()->tol_floor && tol <= (dom_real)0.1) ? DOM_BAD_TOL
                             : !isnan(push) && !(push >= 0 && isfinite(push))                ? DOM_BAD_PUSH
                             : !(given->release >= 0)                                        ? DOM_BAD_RELEASE
                                                      : dynamics_check(&effects_given);
    for (size_t k = 0; status == DOM_OK && k < count; k++) {
        if (k % CHECK_EVERY == 0 && dom_interrupted(row->compute.interrupt))
            return DOM_INTERRUPTED;
        status = row_domino_check(given, k);
        if (status != DOM_OK)
            *wrong = k + 1;
    }
    row->geometry = status == DOM_OK ? malloc(count * sizeof *row->geometry) : NULL;
    if (!row->geometry)
        return status == DOM_OK ? DOM_NO_MEMORY : status;
    /* A run fills in the equal dominoes at the end when it needs them, if at all. */
    while (count > 1 && row_repeats(given, count - 1))
        count--;
    for (; row->made < count && status == DOM_OK; row->made++) {
        if (row->made % CHECK_EVERY == 0 && dom_interrupted(row->compute.interrupt))
            return DOM_INTERRUPTED;
        status = row_geometry(row, row->made);
    }
    return status;
}

KERNEL_SHARED void row_free(struct row *row)
{
    num_linear_free(&row->flow.solution);
    free(row->geometry);
}
