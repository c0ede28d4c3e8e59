/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The session's row as it falls, in time, with a clock. */
#include "commands/drawing/film_row.h"
#include "commands/drawing/row_picture.h"
#include "commands/rows/falling.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "picture/movie.h"
#include <stdlib.h>
#include <string.h>

enum { FRAMES_MOST = 3000, FILM_HEIGHT_LEAST = 170, FILM_HEIGHT_MOST = 420 };
#define FOLLOWED 30 /* times that the largest domino may be taller than the smallest, and both are seen */
#define HELD     1  /* s, of the last frame */

struct row_film {
    const struct query *query;
    struct problem *problem;
    struct falling_row row;
    const struct film_what *what;
    int delay;         /* between frames, in hundredths of a second */
    domq_real *time;   /* of each frame, s */
    double *tilt, *of; /* of: the tilts of the frame that is drawn */
    size_t frames, held, frame;
    bool follows; /* the view follows the front */
    struct view view;
    FILE *script;
    struct answer *answer; /* takes data; else NULL */
    struct progress progress;
};

/* ---- The view ---- */

/* Returns the view of a frame, which shows the front and what it has just felled. */
static struct view front_view(const struct row_film *f, size_t head, double time)
{
    const struct falling_row *row = &f->row;
    const struct domq_domino *own = &row->scene.domino[head - 1];
    double begun = row->hit[head - 1], size = (double)own->height,
           at = row->at[head - 1] + (double)own->thickness;
    if (head < row->count) {
        const struct domq_domino *next = own + 1;
        double until = row->hit[head], part = until > begun ? (time - begun) / (until - begun) : 0;
        part = part > 0 ? part < 1 ? part : 1 : 0;
        /* From one to the next as steadily as sizes grow. */
        double grown = (double)quad(pow)(next->height / own->height, (domq_real)part);
        double far = (double)(next->height - own->height);
        double along =
            quad(fabs)((domq_real)far) > (domq_real)1e-9 * own->height ? (grown - 1) * size / far : part;
        at += along * (row->at[head] + (double)next->thickness - at);
        size *= grown;
    }
    struct view v = f->view;
    double dots = v.width - v.margin_left - v.margin_right, up = v.height - v.margin_above - v.margin_below;
    v.per_dot = 2.6 * size / up;
    v.left = at - 0.45 * dots * v.per_dot;
    v.right = v.left + dots * v.per_dot;
    v.low = -17 * v.per_dot;
    v.high = v.low + up * v.per_dot;
    return v;
}

static void film_view(struct row_film *f)
{
    const struct falling_row *row = &f->row;
    double right = row_right(row, true), edge = 0.01 * right;
    f->follows = row->tallest > FOLLOWED * row->smallest;
    f->view = view_of(-edge, right + edge, row->tallest, 2, FILM_HEIGHT_LEAST, FILM_HEIGHT_MOST, 0);
    if (f->follows)
        f->view.height = 360;
}

/* ---- Frames ---- */

static void frame_caption(const struct row_film *f, const struct domq_moment *m, char text[3 * ROW_SENTENCE])
{
    char moment[ROW_SENTENCE], verdict[ROW_SENTENCE], speed[64] = "";
    bool over = (double)m->time >= f->row.end;
    falling_row_moment(&f->row, m->head, (double)m->time, moment);
    falling_row_verdict(&f->row, "black", verdict);
    if (f->what->speed != 1)
        snprintf(speed, sizeof speed, " (%.30s times as fast as it is)",
                 measured(f->what->speed, "", 3).text);
    if (!over)
        falling_row_summary(&f->row, verdict);
    snprintf(text, (size_t)3 * ROW_SENTENCE, "%s\n%s%s", moment, verdict, over ? "" : speed);
}

static bool frame_seen(const struct domq_moment *m, void *context)
{
    struct row_film *f = context;
    if (f->answer) {
        answer_cells(f->answer, cell_real(m->time), cell_count((domq_real)m->head),
                     cell_real(m->tilt[m->head - 1]));
        return !answer_lost(f->answer);
    }
    char text[3 * ROW_SENTENCE];
    struct view view = f->follows ? front_view(f, m->head, (double)m->time) : f->view;
    for (size_t k = 0; k < f->row.count; k++)
        f->tilt[k] = (double)m->tilt[k];
    fprintf(f->script, "unset label\nunset arrow\n");
    frame_caption(f, m, text);
    script_palette(f->script, &view, (int)(f->frame % 2));
    script_view(f->script, &view);
    script_caption(f->script, &view, text);
    script_row(f->script, &view, &f->row, f->tilt, m->head, false);
    progress_show(&f->progress, (double)++f->frame / (double)f->frames);
    return true;
}

/* Lists the times of the frames; false: an error was reported. */
static bool film_times(struct row_film *f)
{
    const struct falling_row *row = &f->row;
    double begins = falling_row_begins(row), step = f->delay / 100.0 * (double)f->what->speed;
    if (!isfinite(row->end))
        return problem_no_answer(f->problem,
                                 "one domino comes so close to a stop that later times have no value");
    double moving = (double)quad(ceil)((domq_real)((row->end - begins) / step - 1e-9));
    size_t held = (size_t)(HELD * 100 / f->delay);
    if (moving + (double)held > FRAMES_MOST)
        return problem_no_answer(
            f->problem,
            "that would be %.0f frames, and at most %d are drawn; a larger speed, 'speed "
            "%s', or a smaller rate makes fewer",
            moving, FRAMES_MOST,
            measured(f->what->speed * (domq_real)(1.05 * (moving + (double)held) / FRAMES_MOST), "", 3).text);
    f->frames = (size_t)moving + 1 + (f->answer ? 0 : held);
    f->time = malloc(f->frames * sizeof *f->time);
    f->tilt = malloc(row->count * sizeof *f->tilt);
    if (!f->time || !f->tilt)
        return problem_status(f->problem, f->query->scene, DOM_NO_MEMORY);
    for (size_t k = 0; k < f->frames; k++)
        f->time[k] = k < (size_t)moving ? (domq_real)(begins + step * (double)k) : (domq_real)HUGE_VAL;
    return true;
}

static bool film_script(struct row_film *f)
{
    enum dom_status status = falling_row_watch(&f->row, f->time, f->frames, frame_seen, f);
    progress_show(&f->progress, 1);
    return status == DOM_OK || row_status(f->query, f->problem, status);
}

static bool film_file(struct row_film *f, struct answer *a, const char *path)
{
    struct movie movie;
    film_view(f);
    if (!movie_begin(f->query, a, f->problem, &movie, path, (int)f->view.width, (int)f->view.height,
                     f->delay))
        return false;
    f->script = movie.picture.script;
    return movie_end(f->query, f->problem, &movie, film_script(f));
}

bool animate_row(const struct query *query, struct answer *a, struct problem *problem,
                 const struct film_what *what)
{
    struct row_film f = {.query = query, .problem = problem, .what = what};
    f.delay = (int)quad(round)(100 / what->rate);
    f.answer = answer_for_people(a) ? NULL : a;
    a->of_row = true;
    if ((!f.answer && !movie_named(a, problem, query->given->word[0])) ||
        !falling_row_make(query, problem, &f.row))
        return false;
    bool done = film_times(&f);
    if (done && f.answer) {
        f.answer->style.errors = 0;
        struct column *c = answer_columns(f.answer, f.answer->columns);
        c[1] = (struct column){"domino", "", "the last that was hit", 0};
        enum dom_status status = falling_row_watch(&f.row, f.time, f.frames, frame_seen, &f);
        done = status == DOM_OK || row_status(query, problem, status);
    } else if (done) {
        done = film_file(&f, a, query->given->word[0]);
    }
    free(f.time);
    free(f.tilt);
    falling_row_free(&f.row);
    return done;
}
