/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A finite row of dominoes of any sizes (model section 8). While domino k is the head, all before it lean on
 * it in a chain as in a train, with sizes, weights and gaps of their own; so energies, law of motion and
 * collision are those of a train. Two things differ. Nothing repeats, so each head begins with what the head
 * before leaves to it. A domino that detaches takes all that lean on it along. As everywhere in the kernels,
 * the present head is the unit: its height, m g h / 2, tau.
 */
#include "dynamics/walls.h"
#include "geometry/rounded.h"
#include "growth/margin.h"
#include "row/run.h"
#include <stdlib.h>
#include <string.h>

/* ---- The row as a chain ---- */

KERNEL struct block block_of(const struct row_request *row, size_t k)
{
    if (row->block)
        return row->block[k];
    const struct dom_domino *domino = &row->domino[k];
    real h = (real)domino->height, d = (real)(domino->thickness / domino->height), m = (real)domino->mass;
    real g = (real)row->g, walls = (real)row->effect[DOM_EFFECT_walls] / h,
         box = walls != 0 ? walls_box(d, WALLS_WIDTH, walls).inertia : 1;
    return (struct block){h, d, m, sqrt(h / (3 * g) * (1 + d * d) * box), box, m * g * h / 2};
}

/* Sets how domino k and its follower k - 1 touch. */
static void joint_shape(const struct row_request *row, size_t k, struct geometry *geometry)
{
    struct block own = block_of(row, k), previous = block_of(row, k - 1);
    real gap = (real)row->domino[k].gap;
    geometry->r = own.height / previous.height;
    geometry->s = gap / own.height;
    geometry->L = geometry->s + own.d;
    geometry->rs = gap / previous.height;
    geometry->rL = geometry->r * geometry->L;
    geometry->short_of = fmax((previous.height - gap) / previous.height, 0);
    geometry->leave_at = geometry->short_of * (1 + gap / previous.height);
    geometry->leave_by = 2 * geometry->d * geometry->L * geometry->r * geometry->r;
    real v = geometry->leave_at / geometry->leave_by;
    geometry->leave = v < 2 ? (struct tilt){sqrt(v * (2 - v)), 1 - v, v} : (struct tilt){0, -1, 2};
}

/* Makes the joint of domino k with its follower k - 1, and finds how much of the row follows. */
static void joint_make(const struct row_request *row, size_t k, const struct geometry *follower,
                       struct geometry *geometry)
{
    struct block own = block_of(row, k), previous = block_of(row, k - 1);
    joint_shape(row, k, geometry);
    geometry->weight = previous.mass / own.mass / geometry->r;
    geometry->inertia = geometry->weight / geometry->r * (1 + previous.d * previous.d) / (1 + own.d * own.d) *
                        (previous.box / own.box);
    geometry->follower = follower;
    if (geometry->rounded.on)
        rounded_joint(geometry, follower);
    /* All dominoes before, over this domino itself: a bound for what a sum that ends here leaves out. */
    real weights =
        geometry->weight * follower->reach / geometry->reach * (1 + follower->decay / (1 - follower->decay));
    real moments = geometry->inertia * (1 + follower->decay_J / (1 - follower->decay_J));
    if (geometry->lean < 0) {
        /* While it leans backwards, the slope is more than 1: by r L |x| / Y, and Y is at least that of an
         * upright one. */
        real by = -geometry->rL * sin(geometry->lean) / sqrt(geometry->leave_at), most = 1 + 2 * by;
        weights = by < 1 ? weights * most : (real)INFINITY;
        moments = by < 1 ? moments * most * most : (real)INFINITY;
    }
    /* 1 if nothing can be left out. */
    geometry->decay = weights < 1 / REAL_EPSILON ? weights / (1 + weights) : 1;
    geometry->decay_J = moments < 1 / REAL_EPSILON ? moments / (1 + moments) : 1;
}

/* Finds where domino k touches domino k + 1, which may lean. Returns false if the contact is not that of an
 * edge on the back face, or if they touch before domino k moves. */
static bool lean_touch(const struct row_request *row, size_t k, struct contact *contact, struct tilt *tilt)
{
    struct geometry next = {.d = block_of(row, k + 1).d, .lean = (real)row->domino[k + 1].lean};
    joint_shape(row, k + 1, &next);
    *contact = geometry_contact(&next, geometry_rest(&next));
    *tilt = tilt_follower_back(geometry_rest(&next), *contact);
    contact->arm /= next.r;
    return contact->X >= 0 && contact->arm > 0 && tilt_angle(*tilt) >= (real)row->domino[k].lean;
}

/* Returns row_end where one of the two dominoes leans. */
static struct tilt lean_end(const struct row_request *row, size_t k)
{
    const struct geometry own = {.lean = (real)row->domino[k].lean};
    struct contact contact;
    struct tilt tilt;
    bool touches = lean_touch(row, k, &contact, &tilt);
    if (touches)
        return tilt;
    return contact.arm > 0 ? geometry_rest(&own) : (struct tilt){1, 0, 1};
}

/* Returns the last tilt of domino k as a head: where it hits the next one, or lies on the floor. */
static struct tilt row_end(const struct row_request *row, size_t k, const struct geometry *geometry)
{
    if (k + 1 == row->count)
        return (struct tilt){1, 0, 1};
    if (geometry->rounded.on)
        return rounded_hit(geometry, (real)row->domino[k + 1].gap / (real)row->domino[k].height);
    if (row->domino[k + 1].lean != 0 || row->domino[k].lean != 0)
        return lean_end(row, k);
    real sine = fmin((real)row->domino[k + 1].gap / (real)row->domino[k].height, 1);
    return tilt_make(sine, sqrt((1 - sine) * (1 + sine)));
}

/* Returns the radius of the edges of domino k over its height; 0: they are sharp. */
static dom_real row_radius(const struct row_request *row, size_t k)
{
    const struct dom_domino *domino = &row->domino[k];
    dom_real rho = row->effect[DOM_EFFECT_edges];
    return rho != 0 && domino->radius > 0 ? domino->radius / domino->height : rho;
}

/* Turns the effects on. The walls are of one thickness, so each domino has its own share of its height; the
 * radius of the edges may be its own. */
static enum dom_status row_effects(const struct row_request *row, size_t k, struct geometry *geometry)
{
    dom_real effect[DOM_DYNAMICS_COUNT];
    memcpy(effect, row->effect, sizeof effect);
    if (dynamics_on(row->effect[DOM_EFFECT_walls]))
        effect[DOM_EFFECT_walls] /= row->domino[k].height;
    effect[DOM_EFFECT_edges] = row_radius(row, k);
    return dynamics_choose(effect, geometry);
}

KERNEL enum dom_status row_geometry(const struct row_request *asked, size_t k, struct geometry *row)
{
    struct geometry *geometry = &row[k];
    *geometry = (struct geometry){.tol = (real)asked->tol,
                                  .flow = row[0].flow,
                                  .interrupt = asked->interrupt,
                                  .work = asked->work,
                                  .d = block_of(asked, k).d,
                                  .box = 1,
                                  .lean = (real)asked->domino[k].lean,
                                  .short_of = 1,
                                  .n = k + 1};
    geometry->reach = hypot(1, geometry->d);
    geometry_gravity(geometry, 0, 1);
    enum dom_status status = row_effects(asked, k, geometry);
    geometry->c = row_end(asked, k, geometry);
    if (k > 0)
        joint_make(asked, k, &row[k - 1], geometry);
    return status;
}

KERNEL enum dom_status row_make(const struct row_request *asked, struct geometry *row)
{
    enum dom_status status = DOM_OK;
    for (size_t k = 0; k < asked->count && status == DOM_OK; k++) {
        status = row_geometry(asked, k, row);
        if (status == DOM_OK && k == 0) /* all joints share the memory of the law */
            status = dynamics_begin(row);
    }
    return status;
}

/* Returns true if a value is positive and finite, also after rounding to the precision. */
static bool positive(dom_real value)
{
    return (real)value > REAL_MIN && (real)value < 1 / REAL_MIN;
}

static enum dom_status settings_check(const struct row_request *row)
{
    return row->count == 0     ? DOM_BAD_COUNT
           : !positive(row->g) ? DOM_BAD_G
           : !(row->tol >= dom_arithmetic(row->precision)->tol_floor && (double)row->tol <= 0.1) ? DOM_BAD_TOL
           : !isnan(row->push) && !(row->push >= 0 && isfinite((real)row->push))
               ? DOM_BAD_PUSH
               : dynamics_check(row->effect);
}

/* Returns true if the walls have room in a domino. */
static bool walls_room(const struct row_request *row, const struct block *own)
{
    return walls_fit(own->d, (real)row->effect[DOM_EFFECT_walls] / own->height);
}

/* Returns true if a domino that leans does not fall over either edge of its foot. */
static bool lean_stands(const struct row_request *row, const struct dom_domino *d)
{
    return fabs((real)(d->lean + row->effect[DOM_EFFECT_slope])) < atan((real)(d->thickness / d->height));
}

/* Returns the status of what is wrong with a domino. Values computed from its sizes must be numbers of the
 * precision, too. */
KERNEL enum dom_status row_domino_check(const struct row_request *row, size_t k)
{
    const struct dom_domino *d = &row->domino[k];
    const struct block own = block_of(row, k);
    return !positive(d->height)                             ? DOM_BAD_HEIGHT
           : !positive(d->thickness) || !positive(own.d)    ? DOM_BAD_THICKNESS
           : !positive(d->mass) || !positive(own.unit)      ? DOM_BAD_MASS
           : !(d->gap >= 0) || !isfinite((real)d->gap)      ? DOM_BAD_GAP
           : !(d->radius >= 0 && d->radius < d->height / 2) ? DOM_BAD_RADIUS
           : dynamics_on(row->effect[DOM_EFFECT_edges]) && 2 * row_radius(row, k) > d->thickness / d->height
               ? DOM_NO_ROUND
           : dynamics_on(row->effect[DOM_EFFECT_walls]) && !walls_room(row, &own) ? DOM_NO_ROOM
           : d->lean != 0 && row_radius(row, k) != 0                              ? DOM_NO_LEAN
           : d->lean != 0 && !lean_stands(row, d)                                 ? DOM_BAD_LEAN
                                                                                  : DOM_OK;
}

KERNEL enum dom_status row_check(const struct row_request *row, size_t *wrong)
{
    enum dom_status status = settings_check(row);
    for (size_t k = 0; status == DOM_OK && k < row->count; k++) {
        status = row_domino_check(row, k);
        if (status != DOM_OK)
            *wrong = k + 1;
    }
    return status;
}

/* ---- The run ---- */

/* Finds where the motion ends in this segment. */
static enum dom_status descent_rest(struct descent *d, bool used_up)
{
    bool braked = true;
    d->stop = d->st.hi;
    if (used_up) {
        d->stops = true;
        return segment_rest(&d->st, &d->stop);
    }
    enum dom_status status = segment_braked(&d->st, &braked);
    d->stops = braked;
    d->locks = !braked;
    return status;
}

/* Follows the motion in a segment, up to where it ends or comes to rest. */
static enum dom_status descent_move(struct descent *d, bool times, bool floor)
{
    struct segment *st = &d->st;
    bool ends = d->stops || d->locks;
    real to = ends ? d->stop : st->hi, part = 0;
    const struct since since = {d->begins, d->tau, d->time};
    enum dom_status status = DOM_OK;
    if (st->lo < to && (d->forces || !st->end.pushes))
        status = segment_contact(st, to, &d->least_force);
    if (status == DOM_OK && floor && st->lo < to)
        status = floor_over(st, st->lo, to, &d->required_friction);
    if (ends && status == DOM_OK && st->lo < to)
        return watch_passage(d->watch, st, d->head, to, d->stops, &since, REAL_NAN);
    if (ends || status != DOM_OK)
        return status;
    d->climbed += st->end.dH;
    if (times)
        status = segment_time(st, &part);
    if (status == DOM_OK)
        status = watch_passage(d->watch, st, d->head, to, false, &since, part);
    d->time += part;
    return status != DOM_OK ? status : st->status;
}

/*
 * Computes one segment and prepares the next. Segments after a stop have no motion, but they need energy as
 * well: what is missing to the end of the row includes them.
 */
static enum dom_status descent_segment(struct descent *d, real end, bool times, bool floor)
{
    struct segment *st = &d->st, next;
    bool over = d->stops;
    st->geometry.n = d->stay;
    st->hi = end;
    enum dom_status status = segment_cut(st, &d->stay);
    if (status == DOM_OK)
        status = segment_begin(st);
    if (status == DOM_OK && !over && st->lo == st->hi)
        status = watch_detach(d->watch, st, d->head, d->stay);
    if (status != DOM_OK || !(st->locks || st->lo < st->hi))
        return status;
    /* In energy at the launch: with friction only a part of that energy reaches this place. */
    real margin = (st->start.omegasq - st->barrier.height / st->start.J) / st->gain * d->J0;
    bool used_up = margin < 0;
    if (margin < d->least_margin || st->locks) {
        d->least_margin = st->locks ? -(real)INFINITY : margin;
        d->theta_m = st->locks ? st->hi : st->barrier.theta_m;
    }
    /* Prepares the next segment before the flow is cut to where the motion comes to rest. */
    if (!st->locks)
        status = segment_next(st, &next);
    if (status == DOM_OK && !over && (used_up || st->locks))
        status = descent_rest(d, used_up);
    if (status == DOM_OK && !over)
        status = descent_move(d, times, floor);
    if (status == DOM_OK && !d->stops && !d->locks)
        status = watch_detach(d->watch, st, d->head, d->stay);
    if (status == DOM_OK && !st->locks)
        *st = next;
    return status;
}

KERNEL enum dom_status row_descend(struct run *run, size_t k, struct descent *d, struct dom_fall *fall)
{
    const struct block block = block_of(run->asked, k);
    const real end = tilt_angle(run->geometry[k].c);
    const struct tilt rest = geometry_rest(&run->geometry[k]);
    *d = (struct descent){.st = {.geometry = run->geometry[k],
                                 .lo = run->geometry[k].lean,
                                 .start = {.from = rest, .omegasq = run->omegasq},
                                 .gain = 1,
                                 .inertia_ratio = run->inertia_ratio},
                          .stay = run->moving,
                          .least_margin = (real)INFINITY,
                          .least_force = (real)INFINITY,
                          .forces = run->forces,
                          .watch = run->watch,
                          .head = k,
                          .begins = run->time,
                          .tau = block.tau};
    if (run->watch)
        run->watch->head = k;
    struct sums at;
    struct geometry geometry = d->st.geometry;
    geometry.n = run->moving;
    enum dom_status status = chain_sum(&geometry, rest, &at);
    real kinetic = at.J * run->omegasq;
    /* the whole energy change, if the head touches the next domino from the start */
    d->J0 = d->st.start.J = at.J;
    d->st.summed = run->moving;
    d->st.start.kinetic = kinetic;
    while (status == DOM_OK && d->st.lo < end && !d->st.locks)
        status = descent_segment(d, end, run->times, run->asked->floor);
    if (status != DOM_OK)
        return status;
    run->moving = d->stay;
    run->carried = d->st.start.kinetic * block.unit;
    fall->omega = sqrt(run->omegasq) / block.tau;
    fall->kinetic = kinetic * block.unit;
    fall->margin = d->least_margin < (real)INFINITY ? d->least_margin * block.unit : (real)fall->kinetic;
    fall->barrier = fall->kinetic - fall->margin;
    fall->theta_m = d->theta_m;
    bool ends = d->stops || d->locks;
    fall->theta = ends ? d->stop : end;
    fall->duration = run->times && !ends ? d->time * block.tau : REAL_NAN;
    fall->friction_work = ends ? REAL_NAN : 0;
    if (!ends && !run->geometry[k].dynamics->conservative)
        fall->friction_work = fmax((real)fall->kinetic - d->climbed * block.unit - run->carried, 0);
    return DOM_OK;
}

/* Runs the first domino, tipped over its edge and let go: its energy is what it has fallen from there
 * (9; b5). */
static enum dom_status tip_run(struct run *run, struct descent *d, struct dom_fall *fall)
{
    const struct block block = block_of(run->asked, 0);
    const struct geometry *geometry = &run->geometry[0];
    real theta_u = geometry_theta_u(geometry), barrier = geometry_rise_u(geometry) * block.unit;
    const struct tilt top = tilt_half(geometry_half_u(geometry));
    bool tips = geometry_lift(geometry, geometry->c) < 0;
    if (geometry->lean != 0)
        barrier = (geometry->reach - geometry_height(geometry, geometry_rest(geometry))) * block.unit;
    *fall = (struct dom_fall){.domino = 1,
                              .time = REAL_NAN,
                              .duration = REAL_NAN,
                              .kinetic = barrier,
                              .barrier = barrier,
                              .theta_m = theta_u,
                              .theta = tilt_angle(geometry->c),
                              .moving = 1};
    *d = (struct descent){.st = {.geometry = *geometry,
                                 .start = {.from = top, .J = geometry_inertia(geometry, top)},
                                 .gain = 1}};
    d->st.geometry.dynamics = &energy_balance; /* nothing leans on it */
    d->st.lo = theta_u;
    d->st.hi = tilt_angle(geometry->c);
    enum dom_status status =
        run->asked->floor && tips ? floor_over(&d->st, d->st.lo, d->st.hi, &d->required_friction) : DOM_OK;
    watch_tip(run->watch, &d->st, block.tau);
    d->st.start.from = geometry->c;
    d->st.start.J = geometry_inertia(geometry, geometry->c);
    d->st.start.omegasq = tips ? pair_push(geometry) : 0;
    run->carried = d->st.start.J * d->st.start.omegasq * block.unit;
    run->verdict.end = tips ? DOM_ROW_FALLS : DOM_ROW_LEANS;
    return status;
}

/*
 * Relative room for a gap as wide as the head is tall, which counts as reached: in a row of a train with r =
 * 1/s the rounding errors of r, two powers, four products, and of both sizes to the precision, are half a
 * unit or one unit each.
 */
#define REACH_ROUNDED (4 * REAL_EPSILON)

/* Returns how the row ends where head k is at the next domino, and one of the two leans. */
static enum dom_row_end lean_ends(const struct row_request *row, size_t k)
{
    struct contact contact;
    struct tilt tilt;
    return !lean_touch(row, k, &contact, &tilt) ? DOM_ROW_SKEWED
           : contact.arm > 1                    ? DOM_ROW_PASSES
                                                : DOM_ROW_FALLS;
}

KERNEL enum dom_status row_hit(struct run *run, size_t k, const struct descent *d)
{
    const struct dom_domino *own = &run->asked->domino[k], *next = own + 1;
    const struct geometry *geometry = &run->geometry[k + 1];
    enum dom_row_end *end = &run->verdict.end;
    const struct geometry *hits = &run->geometry[k];
    real top = hits->rounded.rho + hits->rounded.tall * hits->c.y, flat = 1 - geometry->rounded.rho;
    if ((real)next->gap > hits->span * (real)own->height * (1 + REACH_ROUNDED))
        *end = DOM_ROW_MISSES;
    else if (own->lean != 0 || next->lean != 0)
        *end = lean_ends(run->asked, k);
    else if ((real)own->height * top > flat * (real)next->height)
        *end = DOM_ROW_PASSES;
    if (*end != DOM_ROW_FALLS)
        return DOM_OK;
    real inertia_ratio = 0, velocity_ratio;
    enum dom_status status = geometry->dynamics->inertia_ratio(geometry, &d->st.geometry, d->st.start.from,
                                                               d->st.start.J, &inertia_ratio);
    if (status == DOM_LOCKS) {
        *end = DOM_ROW_LOCKS;
        return DOM_OK;
    }
    velocity_ratio = collision_velocity_ratio(inertia_ratio) / geometry_hit_slope(geometry);
    real slower = block_of(run->asked, k + 1).tau / block_of(run->asked, k).tau;
    run->inertia_ratio = inertia_ratio;
    run->omegasq = velocity_ratio * velocity_ratio * slower * slower * d->st.start.omegasq;
    run->moving++;
    return status;
}

/* Adds this domino to the verdict of the row. */
static void verdict_add(struct dom_verdict *v, const struct dom_fall *fall, bool tipped)
{
    dom_real spare = fall->barrier > 0 ? fall->margin / fall->barrier : (dom_real)INFINITY;
    v->domino = fall->domino;
    if (v->end == DOM_ROW_STOPS)
        v->short_by = -fall->margin;
    else if (!tipped && fall->margin >= 0 && (v->weakest == 0 || spare < v->spare)) {
        v->weakest = fall->domino;
        v->spare = spare;
    }
}

static void fall_floor(const struct row_request *row, size_t k,
                       const struct required_friction *required_friction, struct dom_fall *fall)
{
    fall->floor_motion = fall->floor_hit = REAL_NAN;
    if (!row->floor)
        return;
    if (row->work)
        row->work->entered[DOM_EFFECT_floor]++;
    fall->floor_motion = required_friction->motion;
    fall->floor_domino = k + 1 - required_friction->domino;
    fall->floor_hit = required_friction->hit;
    fall->floor_hit_domino = k + 1 - required_friction->hit_domino;
}

KERNEL void row_launch(struct run *run)
{
    real tau = block_of(run->asked, 0).tau, push = (real)run->asked->push;
    run->omegasq = isnan(push) ? 0 : push * tau * push * tau;
    run->moving = 1;
}

KERNEL enum dom_status row_head(struct run *run, size_t k, struct descent *d, struct dom_fall *fall)
{
    bool tips = k == 0 && isnan(run->asked->push);
    real before = run->carried;
    *fall = (struct dom_fall){.domino = k + 1, .time = run->time, .moving = run->moving};
    if (dom_raised(run->asked->interrupt))
        return DOM_INTERRUPTED;
    enum dom_status status = tips ? tip_run(run, d, fall) : row_descend(run, k, d, fall);
    if (status != DOM_OK)
        return status;
    if (k > 0)
        fall->lost = before - (real)fall->kinetic;
    if (!tips) {
        run->time += d->stops || d->locks ? 0 : (real)fall->duration;
        if (d->stops || d->locks || d->least_force < 0)
            run->verdict.end = d->least_force < 0 ? DOM_ROW_PARTS : d->stops ? DOM_ROW_STOPS : DOM_ROW_LOCKS;
    }
    fall_floor(run->asked, k, &d->required_friction, fall);
    verdict_add(&run->verdict, fall, tips);
    return DOM_OK;
}

static enum dom_status row_falls(struct run *run, dom_fall_visit *visit, void *context)
{
    bool more = true;
    struct dom_work *work = run->asked->work;
    if (work)
        work->entered[DOM_EFFECT_row]++;
    if (work && !isnan(run->asked->push))
        work->entered[DOM_EFFECT_push]++;
    row_launch(run);
    for (size_t k = 0; k < run->asked->count && more && run->verdict.end == DOM_ROW_FALLS; k++) {
        struct descent d;
        struct dom_fall fall;
        enum dom_status status = row_head(run, k, &d, &fall);
        if (status != DOM_OK)
            return status;
        more = (!visit || visit(&fall, context)) && !(run->watch && run->watch->ended);
        if (more && run->verdict.end == DOM_ROW_FALLS && k + 1 < run->asked->count)
            status = row_hit(run, k, &d);
        if (status != DOM_OK)
            return status;
    }
    return DOM_OK;
}

/* ---- Public ---- */

static enum dom_status row_answer(const struct row_request *given, bool times, dom_fall_visit *visit,
                                  void *context, struct watch *watch, struct dom_verdict *verdict)
{
    struct row_request row = *given, *const asked = &row;
    enum dom_status status = row_check(asked, &verdict->domino);
    if (status != DOM_OK)
        return status;
    struct run run = {.asked = asked,
                      .times = times,
                      .watch = watch,
                      .verdict = {.end = DOM_ROW_FALLS, .spare = (dom_real)INFINITY}};
    run.geometry = malloc(asked->count * sizeof *run.geometry);
    struct block *block = malloc(asked->count * sizeof *block);
    if (!run.geometry || !block) {
        free(run.geometry);
        free(block);
        return DOM_NO_MEMORY;
    }
    for (size_t k = 0; k < asked->count; k++)
        block[k] = block_of(asked, k);
    row.block = block;
    run.geometry[0] = (struct geometry){.dynamics = &energy_balance};
    status = watch ? watch_begin(watch, asked->count) : DOM_OK;
    for (size_t k = 0; watch && status == DOM_OK && k < asked->count; k++)
        watch->tilt[k] = asked->domino[k].lean;
    if (status == DOM_OK)
        status = row_make(asked, run.geometry);
    if (status == DOM_OK)
        status = row_falls(&run, visit, context);
    if (status == DOM_OK && watch)
        status = watch_rest(watch);
    dynamics_end(&run.geometry[0]);
    run.verdict.seconds = times ? run.time : REAL_NAN;
    if (status == DOM_OK)
        *verdict = run.verdict;
    free(run.geometry);
    free(block);
    return status;
}

KERNEL enum dom_status row_run(const struct row_request *asked, bool times, dom_fall_visit *visit,
                               void *context, struct dom_verdict *verdict)
{
    return row_answer(asked, times, visit, context, NULL, verdict);
}

KERNEL enum dom_status row_watch(const struct row_request *asked, const dom_real *times, size_t count,
                                 dom_moment_visit *visit, void *context, struct dom_verdict *verdict)
{
    struct watch watch = {.time = times, .times = count, .visit = visit, .context = context};
    for (size_t k = 0; k < count; k++)
        if (isnan(times[k]) || (k > 0 && times[k] < times[k - 1]) || (times[k] < 0 && !isnan(asked->push)))
            return DOM_BAD_TIME;
    enum dom_status status = row_answer(asked, true, NULL, NULL, &watch, verdict);
    watch_free(&watch);
    return status;
}
