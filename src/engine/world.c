/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "engine/engine.h"
#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#if defined __GLIBC__ || defined __linux__
#include <stdio_ext.h>
#define STREAM_DROP __fpurge
#else
#define STREAM_DROP fpurge
#endif

/* ---- Loading Chipmunk ---- */

/* Calls X(name) for each function of the library that is used. Few of them are getters and setters, since
 * most members of Chipmunk's structures are used directly. */
#define CHIPMUNK_FUNCTIONS(X)                                                                                \
    X(cpSpaceNew)                                                                                            \
    X(cpSpaceFree)                                                                                           \
    X(cpSpaceStep)                                                                                           \
    X(cpSpaceAddDefaultCollisionHandler)                                                                     \
    X(cpSpaceAddBody)                                                                                        \
    X(cpSpaceAddShape)                                                                                       \
    X(cpSpaceAddConstraint)                                                                                  \
    X(cpBodyNew)                                                                                             \
    X(cpBodyFree)                                                                                            \
    X(cpBodySetPosition)                                                                                     \
    X(cpBodySetAngle)                                                                                        \
    X(cpPolyShapeNewRaw)                                                                                     \
    X(cpSegmentShapeNew)                                                                                     \
    X(cpShapeFree)                                                                                           \
    X(cpPivotJointNew)                                                                                       \
    X(cpRotaryLimitJointNew)                                                                                 \
    X(cpConstraintFree)

/* The library. It is loaded only when needed, since it may not be installed. */
static struct {
#define CHIPMUNK_MEMBER(name) __typeof__(name) *name;
    CHIPMUNK_FUNCTIONS(CHIPMUNK_MEMBER)
#undef CHIPMUNK_MEMBER
    const char *version; /* "7.0.3" */
} cp;

/* Bytes to reserve. Chipmunk 7.0.3 needs at most 0.4 MB for a space and 4 kB for each box. */
enum { SPACE = 1 << 20, BOX = 1 << 14 };

static pthread_mutex_t room_lock = PTHREAD_MUTEX_INITIALIZER;
static size_t reserved; /* bytes reserved for all existing Chipmunk spaces */

/*
 * Chipmunk crashes if an allocation fails. So a space is created only if there is enough memory for this
 * space and for all existing spaces. Reserves memory for a space with this many boxes, or returns false.
 * room_release ends the reservation after the space has been freed. Thread-safe.
 */
static bool room_reserve(size_t boxes)
{
    const size_t more = SPACE + BOX * boxes;
    pthread_mutex_lock(&room_lock);
    /* volatile, because gcc could otherwise remove a malloc whose result is only freed */
    void *volatile room = malloc(reserved + more);
    const bool found = room;
    free(room);
    if (found)
        reserved += more;
    pthread_mutex_unlock(&room_lock);
    return found;
}

static void room_release(size_t boxes)
{
    pthread_mutex_lock(&room_lock);
    reserved -= SPACE + BOX * boxes;
    pthread_mutex_unlock(&room_lock);
}

static bool loaded;

/* ISO C cannot convert void * to a function pointer, so the bytes are copied. */
static bool find(void *library, const char *name, void *member)
{
    void *address = dlsym(library, name);
    memcpy(member, &address, sizeof address);
    return address;
}

/*
 * Creates the first space of the process. If the Chipmunk library was built with assertions, as in Debian,
 * this call prints the library's name and version to `stdout`, and there is no way to tell it not to. The
 * text stays in the buffer of `stdout`, and is dropped. Because `stdout` is locked, another thread that
 * prints waits, and loses nothing. In glibc, a line-buffered stream that was written to before, for
 * example by Readline, would still write the beginning of the text. `fseek` resets the stream, even though it
 * fails at a terminal. Afterwards `stdout` has the same buffering as at the start of a program.
 */
static void make_first(void)
{
    flockfile(stdout);
    fflush(stdout);
    setvbuf(stdout, NULL, _IOFBF, BUFSIZ);
    fseek(stdout, 0, SEEK_CUR);
    cp.cpSpaceFree(cp.cpSpaceNew());
    STREAM_DROP(stdout);
    setvbuf(stdout, NULL, isatty(STDOUT_FILENO) ? _IOLBF : _IOFBF, BUFSIZ);
    funlockfile(stdout);
}

static void load(void)
{
    /* The names of the library on Linux and FreeBSD, on macOS, and in Homebrew on macOS. */
    static const char *const names[] = {"libchipmunk.so.7", "libchipmunk.dylib",
                                        "/opt/homebrew/lib/libchipmunk.dylib"};
    void *library = NULL;
    for (size_t i = 0; i < sizeof names / sizeof *names && !library; i++)
        library = dlopen(names[i], RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return;
    loaded = true;
#define FIND(name) loaded = find(library, #name, &cp.name) && loaded;
    CHIPMUNK_FUNCTIONS(FIND)
#undef FIND
    const char *const *version = dlsym(library, "cpVersionString");
    cp.version = version ? *version : "7";
    if (loaded)
        make_first();
}

enum dom_status engine_load(void)
{
    static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    static bool tried;
    pthread_mutex_lock(&lock);
    /* Chipmunk crashes if an allocation fails. So the library is loaded only if there is enough memory for it
     * and for the space that make_first creates. */
    const bool room = tried || room_reserve(0);
    if (room && !tried) {
        load();
        room_release(0);
        tried = true;
    }
    pthread_mutex_unlock(&lock);
    return !room ? DOM_NO_MEMORY : loaded ? DOM_OK : DOM_NO_METHOD;
}

const char *engine_version(void)
{
    return engine_load() == DOM_OK ? cp.version : NULL;
}

/* ---- Boxes ---- */

/* Two directions count as parallel if the cosine of the angle between them exceeds this number. */
static const double parallel = 0.999;
/* Friction coefficient of a floor on which rounded feet roll without slipping. */
static const double rough = 1000;
/* A released box starts this far, in rad, beyond the tilt at which it balances on its edge. */
static const double tipped = 1e-3;

/* Returns the moment of inertia of a box about its centre, divided by that of a solid block of the same size
 * and mass. */
static double inertia_of(const struct dom_row *row, const struct dom_domino *d)
{
    struct dom_box box;
    if (row->walls == 0 || d->height <= row->boxes_above ||
        dom_box_find(d->height, d->thickness, d->width > 0 ? d->width : d->height / 2, row->walls, &box) !=
            DOM_OK)
        return 1;
    /* box.inertia is the moment of inertia about a lower edge, divided by that of a solid block. In the unit
     * of this function, the moment about the edge is the moment about the centre plus 3 (parallel axis
     * theorem), so it is 1 + 3 = 4 for a solid block. */
    return 4 * box.inertia - 3;
}

void world_add_box(struct world *w)
{
    const size_t k = w->count++;
    const struct dom_domino *box = &w->row->domino[k];
    struct body *b = &w->body[k];
    const double h = box->height, d = box->thickness,
                 r = w->row->rho > 0 && box->radius > 0 ? box->radius : w->row->rho * h, x = d / 2 - r,
                 y = h / 2 - r;
    const cpVect edge[] = {{x, -y}, {x, y}, {-x, y - w->bevel * h}, {-x, -y}};
    cpBody *ground = w->space->staticBody;
    *b = (struct body){.corner = k == 0 ? cpvzero : cpvadd(b[-1].corner, cpv(box->gap + d, 0)),
                       .moment = inertia_of(w->row, box) * box->mass * (h * h + d * d) / 12,
                       .radius = r};
    b->body = cp.cpSpaceAddBody(w->space, cp.cpBodyNew(box->mass, b->moment));
    b->shape = cp.cpSpaceAddShape(w->space, cp.cpPolyShapeNewRaw(b->body, 4, edge, r));
    cp.cpBodySetPosition(b->body, cpvadd(b->corner, cpv(-d / 2, h / 2)));
    b->shape->userData = b;
    /* On a floor, where feet may slide, a box can collide with the floor and with all other boxes. */
    b->shape->filter = CP_SHAPE_FILTER_ALL;
    if (w->floor)
        return;
    /* On hinges, it can collide with boxes one place away, and also three places away, but not two. */
    b->shape->filter = cpShapeFilterNew(CP_NO_GROUP, 1u << k % 4, 1u << (k + 1) % 4 | 1u << (k + 3) % 4);
    b->hinge = cp.cpSpaceAddConstraint(w->space, cp.cpPivotJointNew(ground, b->body, b->corner));
    b->limit = cp.cpSpaceAddConstraint(w->space, cp.cpRotaryLimitJointNew(ground, b->body, -CP_PI / 2, 0));
}

/* Turns the first box about its foot by `tilt` and gives it the angular velocity `spin`. A box with rounded
 * edges rolls on its lower front edge, whose centre stays at the height of the radius. */
static void turn(struct world *w, double tilt, double spin)
{
    const struct dom_domino *box = &w->row->domino[0];
    cpBody *body = w->body[0].body;
    const double r = w->body[0].radius;
    cpVect arm = cpvrotate(cpv(r - box->thickness / 2, box->height / 2 - r), cpvforangle(-tilt));
    arm = cpvadd(arm, cpv(0, r));
    cp.cpBodySetAngle(body, -tilt);
    cp.cpBodySetPosition(body, cpvadd(w->body[0].corner, cpvadd(arm, cpv(r * (tilt - 1), 0))));
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
    const struct dom_row *row = w->row;
    const struct dom_domino *box = &row->domino[0];
    double h = box->height, d = box->thickness, rounded = 2 * w->body[0].radius;
    if (!isnan(row->push)) {
        turn(w, row->release, row->push);
        return;
    }
    double arm = hypot(h, d) / 2, about = w->body[0].moment + box->mass * arm * arm;
    double rate = sqrt(box->mass * row->g * arm / about);
    turn(w, atan((d - rounded) / (h - rounded)) - row->alpha + tipped, rate * tipped);
    w->fall->leans = row->count > 1 && world_corner(w, 0, true).x >= box[1].gap;
}

/* ---- Contacts ---- */

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
    arbiter->e = floor ? 0 : w->bounce;
    if (floor)
        return cpTrue;
    const struct body *one = arbiter->a->userData, *other = arbiter->b->userData;
    size_t i = (size_t)(one - w->body), j = (size_t)(other - w->body);
    size_t front = i > j ? i : j;
    note_touch(w, arbiter, front);
    if (front > w->head) {
        w->head = front;
        w->fall->hits = front + 1;
        if (w->hit)
            w->hit[front].time = w->now;
    }
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
    return (struct motion){body->v, body->w * w->row->domino[k].height / 2};
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
    if (w->change == 0 || w->change * ratio <= w->fall->grain.tolerance * (1 - ratio) * whole)
        w->space->iterations = 1;
}

static void prepare(cpConstraint *watch, double dt)
{
    (void)watch, (void)dt;
}

static const struct cpConstraintClass watch_class = {prepare, before_first, each, NULL};

void world_step(struct world *w, double dt)
{
    w->space->iterations = ITERATIONS_MOST;
    cp.cpSpaceStep(w->space, dt);
}

/* ---- The world ---- */

enum dom_status world_make(struct world *w)
{
    const enum dom_status status = engine_load();
    if (status != DOM_OK)
        return status;
    w->has_room = room_reserve(w->row->count);
    if (!w->has_room)
        return DOM_NO_MEMORY;
    w->body = calloc(w->row->count, sizeof *w->body);
    w->space = cp.cpSpaceNew();
    if (!w->body || !w->space)
        return DOM_NO_MEMORY;
    cpCollisionHandler *handler = cp.cpSpaceAddDefaultCollisionHandler(w->space);
    handler->preSolveFunc = touch;
    handler->userData = w;
    w->space->gravity = cpv(w->row->g * sin(w->row->alpha), -w->row->g * cos(w->row->alpha));
    w->space->collisionSlop = 0;
    w->space->collisionBias = 1;
    if (isfinite(w->row->feet) || w->row->rho > 0) { /* the floor is a thick bar beneath the whole row */
        double length = 0, tallest = 0;
        for (const struct dom_domino *d = w->row->domino; d < w->row->domino + w->row->count; d++) {
            length += d->gap + d->thickness;
            tallest = fmax(tallest, d->height);
        }
        w->floor = cp.cpSegmentShapeNew(w->space->staticBody, cpv(-10 * tallest, -tallest),
                                        cpv(length + 10 * tallest, -tallest), tallest);
        cp.cpSpaceAddShape(w->space, w->floor);
    }
    world_add_box(w);
    w->watch = (struct cpConstraint){.klass = &watch_class,
                                     .a = w->space->staticBody,
                                     .b = w->body[0].body,
                                     .collideBodies = cpTrue,
                                     .userData = w};
    cp.cpSpaceAddConstraint(w->space, &w->watch);
    start(w);
    return DOM_OK;
}

void world_free(struct world *w)
{
    if (w->space)
        cp.cpSpaceFree(w->space);
    for (size_t k = 0; k < w->count; k++) {
        const struct body *b = &w->body[k];
        if (b->hinge)
            cp.cpConstraintFree(b->hinge);
        if (b->limit)
            cp.cpConstraintFree(b->limit);
        cp.cpShapeFree(b->shape);
        cp.cpBodyFree(b->body);
    }
    if (w->floor)
        cp.cpShapeFree(w->floor);
    free(w->body);
    if (w->has_room)
        room_release(w->row->count);
}
