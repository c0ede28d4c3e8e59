/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cycles as they run in time, each r times larger than the one before. */
#include "commands/drawing/film_row.h"
#include "commands/tables.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "picture/movie.h"
#include "picture/scene.h"
#include <string.h>

enum { FRAMES_FIRST = 25, FRAMES_DELAY = 4, FRAMES_WIDTH = 640, CYCLES_MOST = 30 };
#define GROWN_MOST 40 /* of the first head over the last: a smaller one would be nothing but a dot */
#define FILM_TOL   ((domq_real)1 / 1000000000)

/* The cycles one after the other, lengths in heights of the first head, times in its tau. */
struct film {
    struct domq_train train;
    struct domq_compute compute;
    int cycles, frames;
    double r, d, pitch, duration, step; /* duration of the first cycle; step from frame to frame */
    double left, right, top, tau;       /* tau of the first head in s */
    bool stops;
};

/* The cycle that a time is in, when it began, and where its head stands. */
struct moment {
    int cycle; /* from 0 */
    double begun, slower;
    struct place place;
};

static struct moment moment_at(const struct film *film, double time)
{
    struct moment m = {.slower = 1, .place = {1, 0}};
    double root = (double)quad(sqrt)((domq_real)film->r);
    while (m.cycle + 1 < film->cycles && time >= m.begun + film->duration * m.slower) {
        m.begun += film->duration * m.slower;
        m.place.shift += film->pitch * film->r * m.place.scale;
        m.place.scale *= film->r;
        m.slower *= root;
        m.cycle++;
    }
    return m;
}

/* Returns how many cycles make the last head no more than so many times as large as the first; at least 1. */
static int cycles_within(double r, double grown_most, int most)
{
    int n = 1;
    for (double grown = r * r; grown <= grown_most && n < most; grown *= r)
        n++;
    return n;
}

/* Reports an error unless the picture can show so many cycles: the first head can still be seen. */
static bool cycles_check(const struct query *query, struct problem *problem, const struct film_what *what)
{
    int most = cycles_within((double)query->scene->train.r, GROWN_MOST, CYCLES_MOST);
    if (what->cycles >= 1 && what->cycles <= most && what->cycles == quad(floor)(what->cycles))
        return true;
    problem->place = what->column;
    return problem_no_answer(problem,
                             "N = %s is not a count; N is an integer in 1 .. %d, the most cycles that one "
                             "picture can show at this r",
                             quad_shown(what->cycles).text, most);
}

static bool film_make(const struct query *query, struct problem *problem, struct film *film)
{
    struct domq_event events[DOM_EVENTS_MAX];
    int count = 0;
    *film = (struct film){.train = query->scene->train, .compute = query->scene->compute};
    const struct domq_train *t = &film->train;
    /* More than that no eye sees. */
    film->compute.precision = DOM_DOUBLE;
    film->compute.tol = FILM_TOL;
    film->r = (double)t->r;
    film->d = (double)t->d;
    film->pitch = (double)(t->s + t->d);
    film->tau = (double)domq_scale_tau(&query->scene->scale, t);
    /* As many as show the growth, and no smaller first head than can be seen. */
    const struct film_what *what = query->given->own;
    if (what && what->counted && !cycles_check(query, problem, what))
        return false;
    film->cycles = what && what->counted ? (int)what->cycles : cycles_within(film->r, 4, 5);
    enum dom_status status = domq_cycle_events(t, &film->compute, events, &count);
    if (status == DOM_NO_MARGIN)
        return problem_error(
            problem, "the margin is 0 to rounding: a cycle lasts for ever; a slightly smaller r has an end");
    if (status == DOM_NO_FUEL)
        return picture_comes_to(query, problem, 0);
    if (status != DOM_OK && status != DOM_STOPS)
        return problem_status(problem, query->scene, status);
    film->stops = status == DOM_STOPS;
    film->cycles = film->stops ? 1 : film->cycles;
    film->duration = (double)events[count - 1].time;
    film->top = 1.04 * (double)quad(pow)(t->r, (domq_real)film->cycles);
    struct moment last = moment_at(film, (double)INFINITY);
    film->right = last.place.shift + last.place.scale * film->r * film->pitch + 0.1 * film->top;
    double behind = film->pitch * film->r / (film->r - 1); /* all dominoes that leaned on the first head */
    film->left = behind < 1.8 ? -1.05 * behind : -1.8;
    double whole = last.begun + film->duration * last.slower;
    film->frames = (int)quad(ceil)((domq_real)(FRAMES_FIRST * whole / film->duration));
    film->step = whole / film->frames;
    return true;
}

/* The tilt of the head in a frame, and the moment. */
static enum dom_status frame_tilt(const struct film *film, int frame, struct moment *m, domq_real *theta)
{
    double time = film->step * frame;
    *m = moment_at(film, time);
    double own = (time - m->begun) / m->slower;
    return domq_cycle_tilt(&film->train, &film->compute,
                           (domq_real)(own < film->duration ? own : film->duration), theta);
}

/* The dominoes beyond the next one, which wait. */
static void script_waiting(FILE *script, const struct film *film, struct place at, int cycle)
{
    double height = film->r, foot = film->pitch * film->r;
    for (int k = cycle + 2; k <= film->cycles; k++) {
        height *= film->r;
        foot += film->pitch * height;
        struct drawn waits = drawn_at(-1, height, foot, 0, film->d, (double)film->train.rho * height);
        script_domino(script, &waits, at, (double)INFINITY);
    }
}

static void script_frame(FILE *script, const struct film *film, const struct moment *m, int frame,
                         const struct stage *scene)
{
    double slower = FRAMES_DELAY / 100.0 / (film->step * film->tau);
    bool ends = frame == film->frames;
    fprintf(script, "unset object\nunset label\nset title \"t = %.1f ms, slowed down %.3g times: ",
            1e3 * film->step * film->tau * frame, slower);
    if (film->stops)
        fprintf(script, ends ? "the train stops\"\n" : "the train does not get over its barrier\"\n");
    else
        fprintf(script, "cycle %d of %d\"\n", m->cycle + 1, film->cycles);
    for (int k = scene->count - 1; k >= 0; k--)
        script_domino(script, &scene->domino[k], m->place,
                      scene->domino[k].number == 0 ? -HUGE_VAL : HUGE_VAL);
    script_waiting(script, film, m->place, m->cycle);
    fprintf(script, "plot NaN\n");
}

static bool film_script(const struct query *query, struct problem *problem, const struct film *film,
                        FILE *script)
{
    static struct stage scene;
    struct progress progress = {0, 0};
    script_axes(script, film->left, film->right, film->top);
    fprintf(script, "set xlabel 'x [h]; h = %.4g mm, the height of the first head; 0: the head'\n",
            (double)(1000 * query->scene->scale.h));
    for (int frame = 0; frame <= film->frames; frame++) {
        struct moment m;
        domq_real theta;
        enum dom_status status = frame_tilt(film, frame, &m, &theta);
        double behind = (m.place.shift - film->left) / m.place.scale + 0.1;
        if (status == DOM_OK)
            status = stage_make(&film->train, &film->compute, theta, behind, &scene);
        progress_show(&progress, status == DOM_OK ? (frame + 1.0) / (film->frames + 1) : 1);
        if (status != DOM_OK)
            return problem_status(problem, query->scene, status);
        script_frame(script, film, &m, frame, &scene);
    }
    return true;
}

static bool film_file(const struct query *query, struct answer *a, struct problem *problem,
                      const struct film *film, const char *path)
{
    struct movie movie;
    int height = (int)(FRAMES_WIDTH * film->top / (film->right - film->left)) + 80;
    height = height < 240 ? 240 : height > 520 ? 520 : height;
    return movie_begin(query, a, problem, &movie, path, FRAMES_WIDTH, height, FRAMES_DELAY) &&
           movie_end(query, problem, &movie, film_script(query, problem, film, movie.picture.script));
}

const struct column animate_columns[] = {
    {"time", "s", "of the frame, since the first head was hit", 0},
    {"cycle", "", "from 1; each is r times larger", 0},
    {"theta", "rad", "tilt of its head", 0},
    {NULL, NULL, NULL, 0},
};

static bool film_rows(const struct query *query, struct problem *problem, const struct film *film,
                      struct answer *answer)
{
    answer->style.errors = 0;
    for (int frame = 0; frame <= film->frames; frame++) {
        struct moment m;
        domq_real theta;
        enum dom_status status = frame_tilt(film, frame, &m, &theta);
        if (status != DOM_OK)
            return problem_status(problem, query->scene, status);
        answer_cells(answer, cell_real((domq_real)film->step * film->tau * frame), cell_count(m.cycle + 1),
                     cell_real(theta));
    }
    return true;
}

bool run_animate(const struct query *query, struct answer *a, struct problem *problem)
{
    static const struct film_what usual = {.speed = 1, .rate = 25};
    const struct film_what *what = query->given->own ? query->given->own : &usual;
    struct film film;
    if (query->scene->effect[DOM_EFFECT_row].on && !what->train && !what->counted)
        return animate_row(query, a, problem, what);
    if (what->timed)
        return problem_error(problem,
                             "'speed' and 'rate' are of a row; first enter 'effect row N', for example "
                             "'effect row 10'");
    a->of_row = what->train;
    return film_make(query, problem, &film) &&
           (answer_for_people(a) ? film_file(query, a, problem, &film, query->given->word[0])
                                 : film_rows(query, problem, &film, a));
}
