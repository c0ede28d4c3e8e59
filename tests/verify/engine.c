/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "engine.h"

#include <chipmunk/chipmunk.h>
#include <fcntl.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <unistd.h>

/*
 * The engine integrates by the symplectic Euler rule, of first order, and computes contacts and joints by
 * impulses, iterating. Boxes that penetrate stay so: to push them apart would move them off their hinges. The
 * drift of hinges is pulled back slowly compared with a step, since the boxes keep the velocity of the pull.
 *
 * Before a hit steps become short, so that the hit is neither late nor deep. After the hit they stay short:
 * the engine scales the impulses of the last step with the length of the step, and would strike again.
 */
static const double hinge_rate = 50;               /* in 1 / sqrt(height / g) of the foremost box */
static const double shortest = 1.0 / 1024;         /* shortest step over the normal one */
static const double brakes = 0.9;                  /* a step goes this part of the way to the next hit */
static const double lies = 1.5707;                 /* rad */
static const double rests = 1e-5, for_good = 0.1;  /* so slow for this time, in that unit: the row stops */
static const double parallel = 0.999;              /* a cosine */
static const size_t most_steps = 20 * 1000 * 1000; /* a hundred times as many as a row takes */
enum { CALM = 2, HARDER = 50 };                    /* short steps after a hit; their iterations */
enum { FOREMOST = 4 };                             /* boxes whose depth and drift are noted */

struct scene {
    const struct engine_row *row;
    struct engine_fall *fall;
    cpSpace *space;
    cpBody *body[ENGINE_MOST];
    cpShape *shape[ENGINE_MOST];
    cpConstraint *hinge[ENGINE_MOST], *floor[ENGINE_MOST];
    cpVect corner[ENGINE_MOST]; /* of the hinges */
    size_t count, head;         /* boxes in the space; number of the foremost box that was hit */
    double now;
};

/* Returns the tilt of box k. The engine counts angles from x to y, and boxes fall towards x. */
static double tilt(const struct scene *s, size_t k)
{
    return -cpBodyGetAngle(s->body[k]);
}

static double spin(const struct scene *s, size_t k)
{
    return -cpBodyGetAngularVelocity(s->body[k]);
}

/* Only neighbours collide. */
static cpShapeFilter neighbours(size_t k)
{
    return cpShapeFilterNew(CP_NO_GROUP, 1u << k % 4, 1u << (k + 1) % 4 | 1u << (k + 3) % 4);
}

/* Adds the next box, upright on a floor that lets it turn only to the front, until it lies. */
static void stand(struct scene *s)
{
    size_t k = s->count++;
    const struct engine_box *box = &s->row->box[k];
    double h = box->height, d = box->thickness;
    cpBody *ground = cpSpaceGetStaticBody(s->space);
    cpBody *body = cpSpaceAddBody(s->space, cpBodyNew(box->mass, cpMomentForBox(box->mass, d, h)));
    cpVect edge[] = {{d / 2, -h / 2}, {d / 2, h / 2}, {-d / 2, h / 2 - s->row->bevel * h}, {-d / 2, -h / 2}};
    cpShape *shape = cpSpaceAddShape(s->space, cpPolyShapeNewRaw(body, 4, edge, 0));

    s->corner[k] = k == 0 ? cpvzero : cpvadd(s->corner[k - 1], cpv(box->gap + d, 0));
    cpBodySetPosition(body, cpvadd(s->corner[k], cpv(-d / 2, h / 2)));
    cpShapeSetFriction(shape, sqrt(s->row->mu)); /* the product of two is that of the contact */
    cpShapeSetElasticity(shape, 0);
    cpShapeSetFilter(shape, neighbours(k));
    cpShapeSetUserData(shape, (void *)(uintptr_t)k);
    s->body[k] = body;
    s->shape[k] = shape;
    s->hinge[k] = cpSpaceAddConstraint(s->space, cpPivotJointNew(ground, body, s->corner[k]));
    s->floor[k] = cpSpaceAddConstraint(s->space, cpRotaryLimitJointNew(ground, body, -CP_PI / 2, 0));
}

static void push(struct scene *s)
{
    cpVect arm = cpvsub(cpBodyGetPosition(s->body[0]), s->corner[0]);

    cpBodySetAngularVelocity(s->body[0], -s->row->push);
    cpBodySetVelocity(s->body[0], cpvmult(cpvperp(arm), -s->row->push));
}

/* Notes that two boxes touch. The first touch of the box next to the head is a hit. */
static cpBool touch(cpArbiter *arbiter, cpSpace *space, void *data)
{
    struct scene *s = data;
    cpShape *a, *b;

    (void)space;
    cpArbiterGetShapes(arbiter, &a, &b);
    size_t i = (uintptr_t)cpShapeGetUserData(a), j = (uintptr_t)cpShapeGetUserData(b), front = i > j ? i : j;
    cpVect normal = cpArbiterGetNormal(arbiter), face = cpvforangle(-tilt(s, front));
    cpVect axis = cpvperp(cpvforangle(-tilt(s, front - 1)));

    if (fabs(cpvdot(normal, face)) < parallel && fabs(cpvdot(normal, axis)) > parallel)
        s->fall->caught = true;
    for (int c = 0; c < cpArbiterGetCount(arbiter) && front + FOREMOST > s->head; c++)
        s->fall->depth = fmax(s->fall->depth, -cpArbiterGetDepth(arbiter, c) / s->row->box[front - 1].height);
    if (front > s->head) {
        s->head = front;
        s->fall->hits = front + 1;
        s->fall->time[front] = s->now;
    }
    return cpTrue;
}

static cpSpace *new_space(struct scene *s)
{
    cpSpace *space = cpSpaceNew();
    cpCollisionHandler *handler = cpSpaceAddDefaultCollisionHandler(space);

    handler->preSolveFunc = touch;
    handler->userData = s;
    cpSpaceSetGravity(space, cpv(0, -s->row->g));
    cpSpaceSetCollisionSlop(space, 0);
    cpSpaceSetCollisionBias(space, 1);
    return space;
}

static void clear(struct scene *s)
{
    for (size_t k = 0; k < s->count; k++) {
        cpSpaceRemoveConstraint(s->space, s->floor[k]);
        cpSpaceRemoveConstraint(s->space, s->hinge[k]);
        cpSpaceRemoveShape(s->space, s->shape[k]);
        cpSpaceRemoveBody(s->space, s->body[k]);
        cpConstraintFree(s->floor[k]);
        cpConstraintFree(s->hinge[k]);
        cpShapeFree(s->shape[k]);
        cpBodyFree(s->body[k]);
    }
    cpSpaceFree(s->space);
}

/* Returns the time until the tip of the head reaches the face of the next box, at the present speed. */
static double time_to_hit(const struct scene *s)
{
    size_t k = s->head;

    if (k + 1 == s->row->count)
        return (double)INFINITY;
    const struct engine_box *own = &s->row->box[k], *next = own + 1;
    cpVect tip = cpBodyLocalToWorld(s->body[k], cpv(own->thickness / 2, own->height / 2));
    double left = s->corner[k + 1].x - next->thickness - tip.x;
    double speed = cpBodyGetVelocityAtWorldPoint(s->body[k], tip).x;

    return speed > 0 ? left / speed : (double)INFINITY;
}

/* Finds how far hinges have drifted, and sets how fast they are pulled back. */
static void look_at_hinges(struct scene *s, double unit)
{
    for (size_t k = 0; k < s->count; k++) {
        const struct engine_box *box = &s->row->box[k];
        cpVect at = cpBodyLocalToWorld(s->body[k], cpv(box->thickness / 2, -box->height / 2));

        if (k + FOREMOST > s->head)
            s->fall->drift = fmax(s->fall->drift, cpvdist(at, s->corner[k]) / box->height);
        cpConstraintSetErrorBias(s->hinge[k],
                                 exp(-hinge_rate / unit)); /* the part that is left after one unit of time */
        cpConstraintSetErrorBias(s->floor[k], exp(-hinge_rate / unit));
    }
}

bool engine_run(const struct engine_row *row, const struct engine_grain *grain, struct engine_fall *fall)
{
    struct scene s = {.row = row, .fall = fall};
    double rest = 0, dt = (double)INFINITY;
    bool ends = false;
    int calm = 0;

    *fall = (struct engine_fall){.hits = 1};
    s.space = new_space(&s);
    stand(&s);
    push(&s);
    for (size_t i = 0; i < most_steps && !ends; i++) {
        size_t head = s.head;
        double unit = sqrt(row->box[head].height / row->g);
        double whole = fmin(unit, 1 / fabs(spin(&s, head))) / grain->steps;

        if (s.count < row->count && s.count < head + 2)
            stand(&s);
        look_at_hinges(&s, unit);
        if (calm == 0)
            dt = fmax(fmin(fmin(whole, 2 * dt), brakes * time_to_hit(&s)), shortest * whole);
        bool hard = calm > 0 || dt < 2 * shortest * whole;
        cpSpaceSetIterations(s.space, grain->iterations * (hard ? HARDER : 1));
        s.now += dt;
        cpSpaceStep(s.space, dt);
        calm = s.head > head ? CALM : calm > 0 ? calm - 1 : 0;
        rest = spin(&s, s.head) * unit < rests ? rest + dt : 0;
        fall->all = s.head + 1 == row->count && tilt(&s, s.head) > lies;
        ends = tilt(&s, s.head) > lies || rest > for_good * unit;
    }
    clear(&s);
    return ends;
}

const char *engine_name(void)
{
    static char name[40];

    if (*name == '\0') {
        fflush(stdout);
        int out = dup(STDOUT_FILENO), nowhere = open("/dev/null", O_WRONLY);

        if (out >= 0 && nowhere >= 0)
            dup2(nowhere, STDOUT_FILENO);
        cpSpaceFree(cpSpaceNew());
        fflush(stdout);
        if (out >= 0)
            dup2(out, STDOUT_FILENO);
        close(out);
        close(nowhere);
        snprintf(name, sizeof name, "Chipmunk %s", cpVersionString);
    }
    return name;
}
