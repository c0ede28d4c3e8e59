/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command animate, which makes a film of the row as it falls, with a clock, or of several cycles of the
 * train, each r times larger than the one before. */
#include "commands/drawing/draw_words.h"
#include "commands/drawing/falling_row.h"
#include "commands/rows/falling.h"
#include "commands/tables.h"
#include "commands/walk.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "picture/movie.h"
#include <stdlib.h>

enum { SHEET_LEAST = 170, SHEET_MOST = 420 }; /* least and largest height of a frame, in pixels */

struct film {
    const struct query *query;
    struct problem *problem;
    struct answer *answer; /* receives the frames as data; NULL if they are drawn instead */
    const struct draw_what *what;
    struct movie movie;
    struct sheet sheet;
    size_t frames, frame; /* number of all frames, and of the frames drawn so far */
    int delay;            /* time between two frames, in hundredths of a second */
};

/* Makes the film. All frames have the size of the picture of `stage`, whose caption must have as many lines
 * as the captions of the frames. `watch` passes each frame to film_frame or adds it to film->answer. If
 * `watch` fails, it sets film->problem and returns false. */
static bool film_make(struct film *f, const struct stage *stage, bool (*watch)(struct film *film))
{
    if (!f->answer) {
        f->sheet = sheet_of(stage, SHEET_LEAST, SHEET_MOST);
        if (!movie_begin(&f->movie, f->query->given->word[0], (int)f->sheet.width, (int)f->sheet.height,
                         f->delay, f->query->scene->compute.interrupt, f->problem))
            return false;
    }
    bool done = watch(f);
    return f->answer ? done : movie_end(&f->movie, done, f->problem);
}

static void film_frame(struct film *f, const struct stage *stage)
{
    FILE *script = f->movie.picture.script;
    fprintf(script, "unset label\nunset arrow\n");
    sheet_palette(&f->sheet, (int)(f->frame % 2), script);
    stage_script(stage, &f->sheet, script);
    progress_show((double)++f->frame / (double)f->frames);
}

/* ---- The row ---- */

enum { FRAMES_MOST = 3000 };
/* The view follows the front if the largest domino is more than this many times as tall as the smallest. */
#define FOLLOWED 30
#define HELD     1 /* seconds for which the last frame is shown */

struct row_film {
    struct film film;
    struct falling_row row;
    domq_real *time; /* time of each frame, in s */
    bool follows;
};

/* Turns the view of a frame to the front and the dominoes that have just fallen. `head` is the number of the
 * last domino that was hit, from 1. Until the next domino is hit, the view moves towards it and grows
 * geometrically to its size. */
static void follow_front(struct row_film *f, size_t head, double time)
{
    const struct drawn *own = &f->row.stage.domino[head - 1];
    double size = own->height, begun = falling_row_hit(&f->row, head - 1), at = own->foot;
    if (head < f->row.stage.count) {
        const struct drawn *next = own + 1;
        double until = falling_row_hit(&f->row, head);
        double part = until > begun ? fmin(fmax((time - begun) / (until - begun), 0), 1) : 0;
        double growth = pow(next->height / size, part), more = next->height - size;
        at += (fabs(more) > 1e-9 * size ? (growth - 1) * size / more : part) * (next->foot - at);
        size *= growth;
    }
    sheet_follow(&f->film.sheet, at, 2.6 * size);
}

static bool row_frame(const struct domq_moment *m, void *context)
{
    struct row_film *f = context;
    struct answer *a = f->film.answer;
    domq_real pace = f->film.what->value[DRAW_SPEED];
    char moment[SENTENCE], more[SENTENCE], speed[64] = "";
    if (a) {
        answer_cells(a, cell_real(m->time), cell_count((domq_real)m->head), cell_real(m->tilt[m->head - 1]));
        return !answer_lost(a);
    }
    bool over = (double)m->time >= f->row.end;
    falling_row_pose(&f->row, m);
    falling_row_moment(&f->row, m, moment);
    if (over)
        falling_row_verdict(&f->row, more);
    else
        falling_row_summary(&f->row, more);
    if (!over && pace != 1)
        snprintf(speed, sizeof speed, " (shown at %.30s times the speed)", measured(pace, "", 3).text);
    snprintf(f->row.stage.caption, CAPTION, "%s\n%s%s", moment, more, speed);
    if (f->follows)
        follow_front(f, m->head, (double)m->time);
    film_frame(&f->film, &f->row.stage);
    return true;
}

/* Fills f->time with the times of the frames. The last frames have an infinite time, which stands for the end
 * of the motion. */
static bool row_times(struct row_film *f)
{
    struct film *film = &f->film;
    domq_real speed = film->what->value[DRAW_SPEED];
    double begins = row_run_tipped(&f->row.run, 0) ? falling_row_hit(&f->row, 0) : 0,
           step = film->delay / 100.0 * (double)speed;
    if (!isfinite(f->row.end))
        return problem_no_answer(film->problem,
                                 "one domino comes so close to a stop that later times have no value");
    double moving = ceil((f->row.end - begins) / step - 1e-9);
    int held = HELD * 100 / film->delay;
    if (moving + held > FRAMES_MOST)
        return problem_no_answer(
            film->problem,
            "that would be %.0f frames, and at most %d are drawn; 'speed %s', or a smaller rate, "
            "makes fewer",
            moving, FRAMES_MOST,
            measured(speed * (domq_real)(1.05 * (moving + held) / FRAMES_MOST), "", 3).text);
    film->frames = (size_t)(moving + 1 + (film->answer ? 0 : held));
    f->time = malloc(film->frames * sizeof *f->time);
    for (size_t k = 0; k < film->frames && f->time; k++)
        f->time[k] = (domq_real)((double)k < moving ? begins + step * (double)k : HUGE_VAL);
    return f->time || problem_status(film->problem, film->query->scene, DOM_NO_MEMORY);
}

static bool row_watch(struct film *film)
{
    struct row_film *f = (struct row_film *)film;
    enum dom_status status = falling_row_watch(&f->row, f->time, film->frames, row_frame, f);
    return status == DOM_OK || row_status(film->query, film->problem, status);
}

static bool animate_row(const struct film *film)
{
    struct row_film f = {.film = *film};
    struct stage *stage = &f.row.stage;
    f.film.delay = (int)quad(round)(100 / film->what->value[DRAW_RATE]);
    if (!falling_row_make(film->query, film->problem, script_marks, &f.row))
        return false;
    if (film->answer)
        answer_columns(film->answer, film->answer->columns)[1] =
            (struct column){"domino", "", "the last domino that was hit", 0};
    falling_row_reach(&f.row, true);
    stage->row = NULL; /* frames have no labels with the sizes of the dominoes */
    snprintf(stage->caption, CAPTION, "1\n2");
    f.follows = stage->top > FOLLOWED * falling_row_smallest(&f.row);
    bool done = row_times(&f) && film_make(&f.film, stage, row_watch);
    free(f.time);
    falling_row_free(&f.row);
    return done;
}

/* ---- The train ---- */

enum { FRAMES_FIRST = 25, FRAMES_DELAY = 4, CYCLES_MOST = 30 };
/* The largest domino of a film may be this many times as tall as the first head, which would otherwise look
 * like a dot. */
#define GROWN_MOST 40
#define FILM_TOL   ((domq_real)1 / 1000000000) /* finer than an eye can see */

/* A film of several cycles of the train. Lengths are in units of the height of the first head, and times in
 * units of its tau. */
struct train_film {
    struct film film;
    struct domq_train train;
    struct domq_compute compute;
    int cycles;
    /* The growth, the pitch and duration of the first cycle, and the time between two frames. */
    double r, pitch, duration, step;
    double tau; /* tau of the first head, in s */
    bool stops;
    struct stage whole; /* a stage as large as that of the frames, without dominoes */
    char ruler[96];
};

/* The cycle that runs at some time of the film: its number, from 0, and the time when it began. It lasts
 * `slower` times as long as the first cycle, and its head is `scale` times as large as the first one and
 * stands at `shift`. */
struct place {
    int cycle;
    double begun, slower, scale, shift;
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

/* Returns the largest number of cycles n with r^n <= grown_most, but at least 1 and at most `most`. The
 * domino that the last head hits is r^n times as large as the first head. */
static int cycles_within(double r, double grown_most, int most)
{
    int n = 1;
    for (double grown = r * r; grown <= grown_most && n < most; grown *= r)
        n++;
    return n;
}

static bool cycles_count(struct train_film *f)
{
    const struct draw_what *what = f->film.what;
    domq_real cycles = what->value[DRAW_CYCLES];
    int most = cycles_within(f->r, GROWN_MOST, CYCLES_MOST);
    bool good = cycles >= 1 && cycles <= most && cycles == quad(floor)(cycles);
    f->cycles = good ? (int)cycles : cycles_within(f->r, 4, 5);
    if (good || !what->has[DRAW_CYCLES])
        return true;
    f->film.problem->place = what->column;
    return problem_no_answer(f->film.problem,
                             "N = %s is not a count; N is an integer in 1 .. %d, the most cycles that one "
                             "picture can show at this r",
                             quad_shown(cycles).text, most);
}

static bool train_film_make(struct train_film *f)
{
    struct domq_event events[DOM_EVENTS_MAX];
    int count = 0;
    struct problem *problem = f->film.problem;
    const struct scene *scene = f->film.query->scene;
    f->train = scene->train;
    f->compute = scene->compute;
    f->compute.precision = DOM_DOUBLE;
    f->compute.tol = FILM_TOL;
    f->r = (double)f->train.r;
    f->pitch = (double)(f->train.s + f->train.d);
    f->tau = (double)domq_scale_tau(&scene->scale, &f->train);
    f->film.delay = FRAMES_DELAY;
    if (!cycles_count(f))
        return false;
    enum dom_status status = domq_cycle_events(&f->train, &f->compute, events, &count);
    if (status == DOM_NO_MARGIN)
        return problem_error(
            problem, "the margin is 0 to rounding: a cycle lasts for ever; a slightly smaller r has an end");
    if (status == DOM_NO_FUEL)
        return train_comes_to(f->film.query, problem, 0);
    if (status != DOM_OK && status != DOM_STOPS)
        return problem_status(problem, scene, status);
    f->stops = status == DOM_STOPS;
    f->cycles = f->stops ? 1 : f->cycles;
    f->duration = (double)events[count - 1].time;
    struct place last = place_at(f, (double)INFINITY);
    double behind = f->pitch * f->r / (f->r - 1); /* length of the dominoes that lean on the first head */
    double whole = last.begun + f->duration * last.slower;
    f->whole.top = pow(f->r, f->cycles);
    f->whole.right = last.shift + last.scale * f->r * f->pitch + 0.1 * f->whole.top;
    f->whole.left = behind < 1.8 ? -1.05 * behind : -1.8;
    f->film.frames = (size_t)ceil(FRAMES_FIRST * whole / f->duration) + 1;
    f->step = whole / (double)(f->film.frames - 1);
    snprintf(f->whole.caption, CAPTION, "1");
    snprintf(f->ruler, sizeof f->ruler, "x in heights of the first head, %.4g mm; 0: the head",
             (double)(1000 * scene->scale.h));
    return true;
}

/* Scales and shifts the dominoes of a cycle to the size and position of its head, and adds those that stand
 * beyond the next domino. */
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
        drawn_stand(d);
    }
}

static enum dom_status train_frame(struct train_film *f, size_t frame)
{
    struct stage stage;
    domq_real theta;
    struct answer *a = f->film.answer;
    double time = f->step * (double)frame;
    struct place p = place_at(f, time);
    enum dom_status status = domq_cycle_tilt(
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
                 FRAMES_DELAY / 100.0 / (f->step * f->tau),
                 !f->stops                     ? cycle
                 : frame + 1 == f->film.frames ? "the train stops"
                                               : "the train does not get over its barrier");
        stage.ruler = f->ruler;
        stage_place(&stage, f, p);
        film_frame(&f->film, &stage);
    }
    stage_free(&stage);
    return status;
}

static bool train_watch(struct film *film)
{
    enum dom_status status = DOM_OK;
    for (size_t frame = 0; frame < film->frames && status == DOM_OK; frame++)
        status = train_frame((struct train_film *)film, frame);
    return status == DOM_OK || problem_status(film->problem, film->query->scene, status);
}

static bool animate_train(const struct film *film)
{
    struct train_film f = {.film = *film};
    return train_film_make(&f) && film_make(&f.film, &f.whole, train_watch);
}

/* ---- The command ---- */

const struct column animate_columns[] = {
    {"time", "s", "time of the frame, since the first head was hit", 0},
    {"cycle", "", "number of the cycle, from 1", 0},
    {"theta", "rad", "tilt of the head", 0},
    {NULL, NULL, NULL, 0},
};

bool run_animate(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct draw_what *what = draw_what(query);
    struct film film = {
        .query = query, .problem = problem, .answer = answer_for_people(a) ? NULL : a, .what = what};
    bool row = query->scene->effect[DOM_EFFECT_row].on && !what->train && !what->has[DRAW_CYCLES];
    if ((what->has[DRAW_SPEED] || what->has[DRAW_RATE]) && !row)
        return problem_error(problem,
                             "'speed' and 'rate' are of a row; first enter 'effect row N', for example "
                             "'effect row 10'");
    if (a->path && !film.answer)
        return problem_error(problem, "the animation is written into FILE, and nothing is left for the file "
                                      "after '>'; leave out the '>'");
    if (!film.answer && !movie_named(query->given->word[0], problem))
        return false;
    if (row || what->train)
        a->note = NULL;  /* the note says that the answer is about the train, which is false or known */
    a->style.errors = 0; /* a picture shows no error bounds */
    return row ? animate_row(&film) : animate_train(&film);
}
