/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'animate', which makes a film of the falling row or of the train. */
#include "interpreter/feature.h"
#include "language/quad.h"
#include "pictures/drawing/falling_row.h"
#include "pictures/drawing/film.h"
#include "train/falling.h"
#include "train/walk.h"
#include <stdlib.h>

/* ---- The row ---- */

enum { FRAMES_MOST = 3000 };
/* The view follows the front if the largest domino or the tower is more than this many times as tall as the
 * smallest domino. */
#define FOLLOWED 30
#define HELD     1 /* time for which the last frame is shown, in s */
/* Unless the user gives the speed, the motion in a film lasts at most this long, in s. */
#define LONGEST 9

struct row_film {
    struct film film;
    struct falling_row row;
    domq_real *time; /* time of each frame, in s */
    domq_real speed; /* seconds of the fall that are shown in one second of the film */
    bool follows;
};

/* Moves the view along the row with the front of the fall. When the domino `head` (counted from 1) is hit,
 * this domino is in the middle, and by the time of the next hit, the next domino is. */
static void follow_front(struct row_film *f, size_t head, double time)
{
    struct stage *stage = &f->row.stage;
    const struct drawn *current = &stage->domino[head - 1], *next = current + (head < stage->count);
    const double begun = falling_row_hit(&f->row, head - 1),
                 until = head < stage->count ? falling_row_hit(&f->row, head) : begun;
    film_follow(stage, current, next, until > begun ? (time - begun) / (until - begun) : 0);
}

static bool row_frame(const struct domq_moment *m, void *context)
{
    struct row_film *f = context;
    struct answer *a = f->film.is_data ? f->film.out : NULL;
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
    if (!over && f->speed != 1)
        snprintf(speed, sizeof speed, " (%.30s times real speed)", measured(f->speed, "", 3).text);
    snprintf(f->row.stage.caption, CAPTION, "%s\n%s%s", moment, more, speed);
    if (f->follows)
        follow_front(f, m->head, (double)m->time);
    return film_frame(&f->film, &f->row.stage);
}

/* In a file, a long fall is shown faster, which keeps the file small. */
static domq_real film_speed(const struct row_film *f, double seconds)
{
    const struct options *options = f->film.options;
    const domq_real typed = options->has[FILM_SPEED] ? options->value[FILM_SPEED] : 1,
                    speed = typed / (options->has[FILM_SLOW] ? SLOWER : 1);
    const bool is_file = f->film.is_data || f->film.out->path;
    if (options->has[FILM_SPEED] || options->has[FILM_SLOW] || !is_file || !(seconds > LONGEST))
        return speed;
    return round_digits((domq_real)(seconds / LONGEST), 2, true);
}

/* Fills f->time with the times of the frames. Infinity stands for the end of the motion. */
static bool row_times(struct row_film *f)
{
    struct film *film = &f->film;
    double begins = row_run_tipped(&f->row.run, 0) ? falling_row_hit(&f->row, 0) : 0;
    const domq_real speed = f->speed = film_speed(f, f->row.end - begins);
    const double step = film->delay / 100.0 * (double)speed;
    if (!isfinite(f->row.end))
        return row_status(film->query, film->problem, DOM_NO_MARGIN);
    double moving = ceil((f->row.end - begins) / step - 1e-9);
    const double frames = moving + 1 + (film->is_data || !film->out->path ? 0 : HELD * 100 / film->delay);
    if (frames > FRAMES_MOST)
        return problem_no_answer(
            film->problem,
            "the film would have %.0f frames, but at most %d are drawn; enter 'speed %s', or a smaller rate",
            frames, FRAMES_MOST, measured(speed * (domq_real)(1.05 * frames / FRAMES_MOST), "", 3).text);
    film->frames = (size_t)frames;
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
    const struct options *options = film->options;
    char verdict[SENTENCE];
    struct stage *stage = &f.row.stage;
    f.film.delay = (int)quad(round)(100 / (options->has[FILM_RATE] ? options->value[FILM_RATE] : 25));
    if (!falling_row_make(film->query, film->problem, options->has[FILM_TOWER], &f.row))
        return false;
    if (film->is_data) {
        struct column *column = answer_columns(film->out, film->out->columns);
        column[0].meaning = "time of the frame, counted as in 'fall'";
        column[1] = (struct column){"domino", "", "the last domino that was hit", 0};
    }
    falling_row_reach(&f.row, true);
    /* Every frame reserves as many lines as this caption takes up. The longest caption has the verdict as its
     * second line. */
    falling_row_verdict(&f.row, verdict);
    snprintf(stage->caption, CAPTION, "1\n%s", verdict);
    f.follows = stage->top > FOLLOWED * falling_row_smallest(&f.row);
    bool done = row_times(&f) && film_make(&f.film, stage, row_watch);
    free(f.time);
    falling_row_free(&f.row);
    return done;
}

/* ---- The command ---- */

static const struct argument number_value = {.name = "the value", .kind = ARGUMENT_NUMBER},
                             any_value = {.name = "N", .kind = ARGUMENT_ANY};

#define ALL_BUT(k) (~BIT(k))
const struct option_list film_options = {
    .options =
        (const struct option[]){
            [FILM_SPEED] = {"speed", &number_value, ALL_BUT(FILM_SPEED), .least = 0.001, .most = 1000},
            [FILM_RATE] = {"rate", &any_value, ALL_BUT(FILM_RATE), .least = 1, .most = 50,
                           .unit = " frames per second", .time = -1},
            [FILM_SLOW] = {"slow", .beside = ALL_BUT(FILM_SLOW)},
            [FILM_TRAIN] = {"train", .beside = ALL_BUT(FILM_TRAIN) & ALL_BUT(FILM_TOWER)},
            [FILM_TOWER] = {"tower", .beside = BIT(FILM_SPEED) | BIT(FILM_RATE) | BIT(FILM_SLOW)},
            [FILM_CYCLES] = {"", &any_value, .beside = ALL_BUT(FILM_CYCLES) & ALL_BUT(FILM_TOWER)},
            {.name = NULL},
        },
    .usage = "usage: animate, animate slow, animate speed 0.5 rate 20, animate train 4, animate tower; '> "
             "row.gif' writes a file",
};

const struct column animate_columns[] = {
    {"time", "s", "time of the frame, counted from the hit on the first head", 0},
    {"cycle", "", "number of the cycle, from 1", 0},
    {"theta", "rad", "tilt of the head", 0},
    {NULL, NULL, NULL, 0},
};

bool run_animate(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct options *options = options_of(query);
    struct film film = {
        .query = query, .problem = problem, .out = a, .is_data = !answer_for_people(a), .options = options};
    bool row =
        query->scene->effect[DOM_EFFECT_row].on && !options->has[FILM_TRAIN] && !options->has[FILM_CYCLES];
    if ((options->has[FILM_SPEED] || options->has[FILM_RATE]) && !row && !options->has[FILM_TOWER])
        return problem_error(
            problem, "'speed' and 'rate' are for rows; first enter 'set row N', for example 'set row 10'");
    if (!film.is_data && !picture_ready(a, problem))
        return false;
    if (row || options->has[FILM_TRAIN] || options->has[FILM_TOWER])
        /* TRAIN_NOTE would be wrong for a row, and superfluous if the user asked for the train. */
        a->note = NULL;
    a->style.errors = 0; /* a picture shows no errors */
    if (options->has[FILM_TOWER]) {
        struct tower tower;
        film.query = &tower.query;
        const bool good = tower_make(query, &tower, problem) && animate_row(&film);
        free(tower.change);
        return good;
    }
    return row ? animate_row(&film) : animate_train(&film);
}
