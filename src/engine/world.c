/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"
#include <math.h>
#include <stdlib.h>

/* Two directions count as parallel if the cosine of the angle between them exceeds this number. */
static const double parallel = 0.999;
/* Friction coefficient of a floor on which rounded feet roll without slipping. */
static const double rough = 1000;
/* A released box starts this far, in rad, beyond the tilt at which it balances on its edge. */
static const double tipped = 1e-3;

/* Chipmunk measures angles anticlockwise, but boxes fall clockwise, towards positive x. */
double world_tilt(const struct world *w, size_t k)
{
    return -w->body[k].body->a;
}

double world_spin(const struct world *w, size_t k)
{
    return -w->body[k].body->w;
}

cpVect world_tip(const struct world *w, size_t k)
{
    const struct engine_box *box = &w->row->box[k];
    return cpTransformPoint(w->body[k].body->transform, cpv(box->thickness / 2, box->height / 2));
}

static double radius_of(const struct world *w, size_t k)
{
    const struct engine_box *box = &w->row->box[k];
    return w->row->radius > 0 && box->radius > 0 ? box->radius : w->row->radius * box->height;
}

cpVect world_front(const struct world *w, size_t k, bool upper)
{
    const struct engine_box *box = &w->row->box[k];
    double r = radius_of(w, k), y = box->height / 2 - r;
    cpVect centre = cpv(box->thickness / 2 - r, upper ? y : -y);
    return cpvadd(cpTransformPoint(w->body[k].body->transform, centre), cpv(r, 0));
}

cpVect world_foot(const struct world *w, size_t k)
{
    const struct engine_box *box = &w->row->box[k];
    return cpTransformPoint(w->body[k].body->transform, cpv(box->thickness / 2, -box->height / 2));
}

double world_kinetic(const struct world *w)
{
    double sum = 0;
    for (size_t k = 0; k < w->count; k++) {
        cpVect v = w->body[k].body->v;
        double spin = world_spin(w, k);
        sum += (w->row->box[k].mass * cpvlengthsq(v) + w->body[k].moment * spin * spin) / 2;
    }
    return sum;
}

/* Returns a filter for the shapes with which a box can collide. On a floor, where feet may slide, a box can
 * collide with the floor and with all other boxes. On hinges, it can collide with boxes one place away, and
 * also three places away, but not two. */
static cpShapeFilter touches(const struct world *w, size_t k)
{
    const cpBitmask floor = 1u << 4;
    if (w->floor)
        return CP_SHAPE_FILTER_ALL;
    return cpShapeFilterNew(CP_NO_GROUP, 1u << k % 4, floor | 1u << (k + 1) % 4 | 1u << (k + 3) % 4);
}

/* Returns the shape of a box: a polygon with rounded edges, or with its upper back edge cut off. */
static cpShape *shape_of(const struct world *w, size_t k)
{
    const struct engine_box *box = &w->row->box[k];
    double r = radius_of(w, k), x = box->thickness / 2 - r, y = box->height / 2 - r;
    const cpVect edge[] = {{x, -y}, {x, y}, {-x, y - w->row->bevel * box->height}, {-x, -y}};
    return w->cp->cpPolyShapeNewRaw(w->body[k].body, 4, edge, r);
}

void world_add_box(struct world *w)
{
    const struct chipmunk *cp = w->cp;
    const size_t k = w->count;
    const struct engine_box *box = &w->row->box[k];
    struct body *b = &w->body[k];
    double h = box->height, d = box->thickness, solid = box->mass * (h * h + d * d) / 12;
    cpBody *ground = w->space->staticBody;
    *b = (struct body){.corner = k == 0 ? cpvzero : cpvadd(b[-1].corner, cpv(box->gap + d, 0)),
                       .moment = box->inertia > 0 ? box->inertia * solid : solid};
    b->body = cp->cpSpaceAddBody(w->space, cp->cpBodyNew(box->mass, b->moment));
    b->shape = cp->cpSpaceAddShape(w->space, shape_of(w, k));
    w->count++;
    cp->cpBodySetPosition(b->body, cpvadd(b->corner, cpv(-d / 2, h / 2)));
    b->shape->filter = touches(w, k);
    b->shape->userData = b;
    if (w->floor)
        return;
    b->hinge = cp->cpSpaceAddConstraint(w->space, cp->cpPivotJointNew(ground, b->body, b->corner));
    b->limit = cp->cpSpaceAddConstraint(w->space, cp->cpRotaryLimitJointNew(ground, b->body, -CP_PI / 2, 0));
}

/* Turns the first box about its foot by `tilt` and gives it the angular velocity `spin`. A box with rounded
 * edges rolls on its lower front edge, whose centre stays at the height of the radius. */
static void turn(struct world *w, double tilt, double spin)
{
    const struct chipmunk *cp = w->cp;
    const struct engine_box *box = &w->row->box[0];
    cpBody *body = w->body[0].body;
    const double r = radius_of(w, 0);
    cpVect arm = cpvrotate(cpv(r - box->thickness / 2, box->height / 2 - r), cpvforangle(-tilt));
    arm = cpvadd(arm, cpv(0, r));
    cp->cpBodySetAngle(body, -tilt);
    cp->cpBodySetPosition(body, cpvadd(w->body[0].corner, cpvadd(arm, cpv(r * (tilt - 1), 0))));
    body->w = -spin;
    body->v = cpvmult(cpvperp(arm), -spin);
}

/*
 * Starts the first box. Without a push, the box starts slightly beyond the tilt at which it balances on its
 * edge. Its distance from this tilt grows like exp(rate t), so its angular velocity is `rate` times the
 * distance.
 */
static void start(struct world *w)
{
    const struct engine_row *row = w->row;
    const struct engine_box *box = &row->box[0];
    double h = box->height, d = box->thickness, rounded = 2 * radius_of(w, 0);
    if (!isnan(row->push)) {
        turn(w, row->tilt, row->push);
        return;
    }
    double arm = hypot(h, d) / 2, about = w->body[0].moment + box->mass * arm * arm;
    double rate = sqrt(box->mass * row->g * arm / about);
    turn(w, atan((d - rounded) / (h - rounded)) - row->slope + tipped, rate * tipped);
    w->fall->leans = row->count > 1 && world_tip(w, 0).x >= box[1].gap;
}

/* ---- Contacts ---- */

/* Box k becomes the head. */
static void note_hit(struct world *w, size_t k)
{
    w->head = k;
    w->fall->hits = k + 1;
    if (w->hit)
        w->hit[k].time = w->now;
}

/* Records whether an edge of box `front` touches the top of the box behind it. */
static void note_touch(struct world *w, const cpArbiter *arbiter, size_t front)
{
    const cpVect normal = arbiter->n, face = cpvforangle(-world_tilt(w, front));
    const cpVect axis = cpvperp(cpvforangle(-world_tilt(w, front - 1)));
    if (fabs(cpvdot(normal, face)) < parallel && fabs(cpvdot(normal, axis)) > parallel) {
        w->fall->other_contact = true;
        if (front >= w->head)
            w->fall->slowest = 0;
    }
}

/* Sets friction and restitution. The box in front of the head counts as hit when it is first touched. */
static cpBool touch(cpArbiter *arbiter, cpSpace *space, void *data)
{
    struct world *w = data;
    (void)space;
    const bool floor = arbiter->a == w->floor || arbiter->b == w->floor;
    arbiter->u = floor ? fmin(w->row->feet, rough) : w->row->mu;
    arbiter->e = floor ? 0 : w->row->bounce;
    if (floor)
        return cpTrue;
    const struct body *one = arbiter->a->userData, *other = arbiter->b->userData;
    size_t i = (size_t)(one - w->body), j = (size_t)(other - w->body);
    size_t front = i > j ? i : j;
    note_touch(w, arbiter, front);
    if (front > w->head)
        note_hit(w, front);
    return cpTrue;
}

/* ---- The iterations of the solver ---- */

/*
 * Ends the iterations of Chipmunk's solver when they have converged. Chipmunk has no test for convergence: in
 * each step, it makes a fixed number of iterations. But in each iteration, it calls a function of every
 * constraint, and it reads the number of iterations again. So a constraint is added that applies no impulses
 * and only observes the velocities. When the velocities hardly change any more, the constraint ends the loop
 * by lowering the number of iterations.
 */
enum { ITERATIONS_MOST = 1000 };

static struct motion motion_of(const struct world *w, size_t k)
{
    const cpBody *body = w->body[k].body;
    return (struct motion){body->v, body->w * w->row->box[k].height / 2};
}

/* Called before the first iteration. Gravity and the impulses of the previous step are already applied. */
static void before_first(cpConstraint *watch, double factor)
{
    struct world *w = watch->userData;
    (void)factor;
    for (size_t k = 0; k < w->count; k++)
        w->body[k].begin = w->body[k].now = motion_of(w, k);
    w->change = (double)NAN;
}

static double motion_change(const struct motion *a, const struct motion *b)
{
    return fmax(fmax(fabs(a->v.x - b->v.x), fabs(a->v.y - b->v.y)), fabs(a->turns - b->turns));
}

/*
 * Called in each iteration. Estimates how much the velocities would change in all further iterations
 * together, by assuming that the changes form a geometric series. If the estimate is a small fraction of the
 * change in the whole step, ends the loop.
 */
static void each(cpConstraint *watch, double dt)
{
    struct world *w = watch->userData;
    const double last = w->change;
    double whole = w->row->g * dt;
    w->change = 0;
    for (size_t k = 0; k < w->count; k++) {
        struct body *b = &w->body[k];
        const struct motion now = motion_of(w, k);
        w->change = fmax(w->change, motion_change(&now, &b->now));
        whole = fmax(whole, motion_change(&now, &b->begin));
        b->now = now;
    }
    const double ratio = w->change / last;
    if (w->change == 0 || w->change * ratio <= w->tolerance * (1 - ratio) * whole)
        w->space->iterations = 1;
}

static void prepare(cpConstraint *watch, double dt)
{
    (void)watch, (void)dt;
}

static double no_impulse(cpConstraint *watch)
{
    (void)watch;
    return 0;
}

static void watch_add(struct world *w)
{
    static const struct cpConstraintClass class = {prepare, before_first, each, no_impulse};
    w->watch = (struct cpConstraint){.klass = &class,
                                     .a = w->space->staticBody,
                                     .b = w->body[0].body,
                                     .collideBodies = cpTrue,
                                     .userData = w};
    w->cp->cpSpaceAddConstraint(w->space, &w->watch);
}

void world_step(struct world *w, double dt)
{
    w->space->iterations = ITERATIONS_MOST;
    w->cp->cpSpaceStep(w->space, dt);
}

/* ---- The world ---- */

/* Adds the floor, a thick bar beneath the whole row. */
static void pave(struct world *w)
{
    const struct engine_row *row = w->row;
    double length = 0, tallest = 0;
    for (size_t k = 0; k < row->count; k++) {
        length += row->box[k].gap + row->box[k].thickness;
        tallest = fmax(tallest, row->box[k].height);
    }
    w->floor = w->cp->cpSegmentShapeNew(w->space->staticBody, cpv(-10 * tallest, -tallest),
                                        cpv(length + 10 * tallest, -tallest), tallest);
    w->cp->cpSpaceAddShape(w->space, w->floor);
}

enum dom_status world_make(struct world *w)
{
    enum dom_status status = chipmunk_load(&w->cp);
    if (status != DOM_OK)
        return status;
    w->has_room = chipmunk_reserve(w->row->count);
    if (!w->has_room)
        return DOM_NO_MEMORY;
    w->body = calloc(w->row->count, sizeof *w->body);
    w->space = w->cp->cpSpaceNew();
    if (!w->body || !w->space)
        return DOM_NO_MEMORY;
    cpCollisionHandler *handler = w->cp->cpSpaceAddDefaultCollisionHandler(w->space);
    handler->preSolveFunc = touch;
    handler->userData = w;
    w->space->gravity = cpv(w->row->g * sin(w->row->slope), -w->row->g * cos(w->row->slope));
    w->space->collisionSlop = 0;
    w->space->collisionBias = 1;
    if (isfinite(w->row->feet) || w->row->radius > 0)
        pave(w);
    world_add_box(w);
    watch_add(w);
    start(w);
    return DOM_OK;
}

static void free_body(struct world *w, struct body *b)
{
    const struct chipmunk *cp = w->cp;
    cpConstraint *const joint[] = {b->hinge, b->limit};
    for (int i = 0; i < 2; i++)
        if (joint[i]) {
            cp->cpSpaceRemoveConstraint(w->space, joint[i]);
            cp->cpConstraintFree(joint[i]);
        }
    cp->cpSpaceRemoveShape(w->space, b->shape);
    cp->cpSpaceRemoveBody(w->space, b->body);
    cp->cpShapeFree(b->shape);
    cp->cpBodyFree(b->body);
}

void world_free(struct world *w)
{
    if (w->watch.space)
        w->cp->cpSpaceRemoveConstraint(w->space, &w->watch);
    for (size_t k = 0; k < w->count; k++)
        free_body(w, &w->body[k]);
    if (w->floor) {
        w->cp->cpSpaceRemoveShape(w->space, w->floor);
        w->cp->cpShapeFree(w->floor);
    }
    if (w->space)
        w->cp->cpSpaceFree(w->space);
    free(w->body);
    if (w->has_room)
        chipmunk_release(w->row->count);
}
