/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A film of several cycles of the train, each r times as large as the one before. */
#include "language/quad.h"
#include "pictures/drawing/film.h"
#include "train/walk.h"
#include <math.h>

enum { FRAMES_FIRST = 25, FRAMES_DELAY = 4, CYCLES_MOST = 30 };
/* The largest domino is at most this many times as tall as the first head, which must stay visible. */
#define GROWN_MOST 40
/* The tolerance of the tilts in a film. A viewer cannot see such small errors. */
#define FILM_TOL ((domq_real)1 / 1000000000)

/* Lengths are in units of the height of the first head, and times in units of its tau. */
struct train_film {
    struct film film;
    struct domq_train train;
    struct any_compute compute;
    int cycles;
    /* The growth, the pitch and duration of the first cycle, and the time between two frames. */
    double r, pitch, duration, step;
    double tau; /* tau of the first head, in s */
    bool stops;
    struct stage whole; /* an empty stage that is as large as the stage of each frame */
    char ruler[96];
};

/* The time, place and size of a cycle in the film, relative to the first cycle. */
struct place {
    int cycle; /* counted from 0 */
    double begun;
    double slower; /* the duration divided by the duration of the first cycle */
    double scale;  /* the height of the head divided by the height of the first head */
    double shift;  /* x of the head */
};

static struct place place_at(const struct train_film *f, double time)
{
    struct place p = {.slower = 1, .scale = 1};
    while (p.cycle + 1 < f->cycles && time >= p.begun + f->duration * p.slower) {
        p.begun += f->duration * p.slower;
        p.shift += f->pitch * f->r * p.scale;
        p.scale *= f->r;
        p.slower *= sqrt(f->r);
        p.cycle++;
    }
    return p;
}

/* Returns how many cycles a film can show. Cycle n (counted from 1) ends when the head hits a domino that is
 * r^n times as tall as the first head. So that this domino is not too large for the picture, r^n is at most
 * `grown_most`. With r = 1.5 and `grown_most` = 4, for example, a film can show three cycles. The result is
 * at least 1 and at most `most`. */
static int cycles_within(double r, double grown_most, int most)
{
    int n = 1;
    for (double grown = r * r; grown <= grown_most && n < most; grown *= r)
        n++;
    return n;
}

static bool cycles_count(struct train_film *f)
{
    const struct options *options = f->film.options;
    domq_real cycles = options->value[FILM_CYCLES];
    int most = cycles_within(f->r, GROWN_MOST, CYCLES_MOST);
    bool good = cycles >= 1 && cycles <= most && cycles == quad(floor)(cycles);
    f->cycles = good ? (int)cycles : cycles_within(f->r, 4, 5);
    if (good || !options->has[FILM_CYCLES])
        return true;
    f->film.problem->place = options->column[FILM_CYCLES];
    return problem_no_answer(f->film.problem,
                             "N = %s is out of range; at this r, N is an integer in 1 .. %d, because one "
                             "picture has no room for more cycles",
                             quad_text(cycles, 10), most);
}

static bool train_film_make(struct train_film *f)
{
    struct domq_event events[DOM_EVENTS_MAX];
    int count = 0;
    const struct scene *scene = f->film.query->scene;
    f->train = scene->train;
    f->compute = scene->compute;
    f->compute.precision = IN_DOUBLE;
    f->compute.tol = FILM_TOL;
    f->r = (double)f->train.r;
    f->pitch = (double)(f->train.s + f->train.d);
    f->tau = (double)domq_scale_tau(&scene->scale, &f->train);
    f->film.delay = FRAMES_DELAY * (f->film.options->has[FILM_SLOW] ? SLOWER : 1);
    if (!cycles_count(f))
        return false;
    if (!cycle_events(f->film.query, &f->compute, events, &count, &f->stops, f->film.problem))
        return false;
    f->cycles = f->stops ? 1 : f->cycles;
    f->duration = (double)events[count - 1].time;
    struct place last = place_at(f, (double)INFINITY);
    /* The length of floor that the dominoes behind the first head take up. */
    double behind = f->pitch * f->r / (f->r - 1);
    double whole = last.begun + f->duration * last.slower;
    f->whole.top = pow(f->r, f->cycles);
    f->whole.right = last.shift + last.scale * f->r * f->pitch + 0.1 * f->whole.top;
    f->whole.left = behind < 1.8 ? -1.05 * behind : -1.8;
    f->film.frames = (size_t)ceil(FRAMES_FIRST * whole / f->duration) + 1;
    f->step = whole / (double)(f->film.frames - 1);
    snprintf(f->whole.caption, CAPTION, "1");
    snprintf(f->ruler, sizeof f->ruler, "position relative to the first head; h is its height, %.4g mm",
             (double)(1000 * scene->scale.h));
    return true;
}

/* Adds the standing heads of later cycles to the stage of one cycle. Then moves and scales all dominoes to
 * their place in the film. */
static void stage_place(struct stage *stage, const struct train_film *f, struct place p)
{
    const struct drawn next = stage->domino[0];
    double height = next.height, foot = next.foot;
    for (int k = p.cycle + 2; k <= f->cycles; k++) {
        struct drawn *waits = &stage->domino[stage->count++];
        height *= f->r;
        foot += f->pitch * height;
        *waits = next;
        waits->touched = false;
        waits->height = height;
        waits->thickness = (double)f->train.d * height;
        waits->radius = (double)f->train.rho * height;
        waits->foot = foot;
    }
    for (size_t k = 0; k < stage->count; k++) {
        struct drawn *d = &stage->domino[k];
        d->number = d->number == 0 ? 0 : NUMBER_NONE;
        d->height *= p.scale;
        d->thickness *= p.scale;
        d->radius *= p.scale;
        d->foot = p.shift + p.scale * d->foot;
        d->contact = (struct point){p.shift + p.scale * d->contact.x, p.scale * d->contact.y};
        drawn_corners(d);
    }
}

static enum dom_status train_frame(struct train_film *f, size_t frame, bool *goes_on)
{
    struct stage stage;
    domq_real theta;
    struct answer *a = f->film.is_data ? f->film.out : NULL;
    double time = f->step * (double)frame;
    struct place p = place_at(f, time);
    enum dom_status status = any_cycle_tilt(
        &f->train, &f->compute, (domq_real)fmin((time - p.begun) / p.slower, f->duration), &theta);
    if (status == DOM_OK && a)
        answer_cells(a, cell_real((domq_real)f->step * f->tau * (domq_real)frame), cell_count(p.cycle + 1),
                     cell_real(theta));
    if (status != DOM_OK || a)
        return status;
    status = stage_train(&stage, &f->train, &f->compute, theta, (p.shift - f->whole.left) / p.scale + 0.1);
    if (status == DOM_OK) {
        char cycle[48];
        snprintf(cycle, sizeof cycle, "cycle %d of %d", p.cycle + 1, f->cycles);
        snprintf(stage.caption, CAPTION, "t = %.1f ms, slowed down %.3g times: %s", 1e3 * f->tau * time,
                 f->film.delay / 100.0 / (f->step * f->tau),
                 !f->stops                     ? cycle
                 : frame + 1 == f->film.frames ? "the train stops"
                                               : "the train does not get over its barrier");
        stage.ruler = f->ruler;
        stage_place(&stage, f, p);
        /* A file shows all cycles at the same scale, but a terminal has too few characters. */
        if (f->film.screen)
            film_follow(&stage, &stage.domino[1], &stage.domino[0],
                        (time - p.begun) / p.slower / f->duration);
        *goes_on = film_frame(&f->film, &stage);
    }
    stage_free(&stage);
    return status;
}

static bool train_watch(struct film *film)
{
    enum dom_status status = DOM_OK;
    bool goes_on = true;
    for (size_t frame = 0; frame < film->frames && status == DOM_OK && goes_on; frame++)
        status = train_frame((struct train_film *)film, frame, &goes_on);
    return status == DOM_OK || problem_status(film->problem, film->query->scene, status);
}

bool animate_train(const struct film *film)
{
    struct train_film f = {.film = *film};
    return train_film_make(&f) && film_make(&f.film, &f.whole, train_watch);
}
