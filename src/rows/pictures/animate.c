/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'animate', which makes a film of the falling row, at the terminal or in a .gif file. */
#include "answer/answer.h"
#include "interpreter/question.h"
#include "io/io.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "parallel/progress.h"
#include "pictures/drawing/falling_row.h"
#include "train/train.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FRAMES_MOST = 3000 };
/* The view follows the front if the largest domino or the tower is more than this many times as tall as the
 * smallest domino. */
#define FOLLOWED 30
#define HELD     1 /* time for which the last frame is shown, in s */
/* Unless the user gives the speed, the motion in a film lasts at most this long, in s. */
#define LONGEST 9

/* The words of 'animate', as bits of question->parsed. */
enum { FILM_SPEED = 1, FILM_RATE = 2, FILM_TOWER = 4 };

struct film {
    const struct query *query;
    struct problem *problem;
    struct answer *out;
    bool is_data; /* the frames are written as data, rather than drawn */
    unsigned words;
    struct falling_row row;
    double *time;         /* time of each frame, in s */
    domq_real speed;      /* seconds of the fall that are shown in one second of the film */
    bool follows;         /* the view follows the front of the fall */
    size_t frames, frame; /* the total number of frames, and the number written so far */
    int delay;            /* time between two frames, in hundredths of a second */

    /* At the terminal: */
    FILE *screen; /* NULL for a file */
    double next;  /* when the next frame is due, in s */
    char *text;   /* the current frame */
    size_t size;
    bool is_stopped, failed;

    /* For a file: */
    struct picture picture; /* its script has a plot command for each frame */
    struct sheet sheet;     /* the size of all frames, and the part of the stage that the next frame shows */
};

/* ---- At the terminal ---- */

static void screen_show(const struct film *f)
{
    fputs("\033[H", f->screen);
    for (const char *line = f->text; *line;) {
        const size_t n = strcspn(line, "\n");
        fprintf(f->screen, "%.*s\033[K\r\n", (int)n, line);
        line += n + (line[n] == '\n');
    }
    fprintf(f->screen, "%s\033[J",
            f->is_stopped ? "(stopped: space continues, the right arrow shows the next frame, q ends)"
                          : "(space stops, q ends)");
    fflush(f->screen);
}

/* Draws the frame into f->text. Returns false if memory runs out. */
static bool frame_draw(struct film *f)
{
    int width, height;
    free(f->text);
    f->text = NULL;
    FILE *text = io_memory(&f->text, &f->size);
    if (!text)
        return false;
    terminal_size(f->out->out, &width, &height);
    width = width > PICTURE_LEAST_WIDTH ? width - 1 : PICTURE_LEAST_WIDTH;
    height = height > PICTURE_LEAST_HEIGHT ? height - 1 : PICTURE_LEAST_HEIGHT;
    const bool is_drawn = stage_text(&f->row.stage, display_of(f->out->out), width, height, text);
    return fclose(text) == 0 && is_drawn && f->text;
}

/* Shows the frame, and handles keys until it is time for the next one: the space bar stops and continues the
 * film, the right arrow shows the next frame, and 'q' ends the film. Returns false if the user has ended it.
 */
static bool frame_play(struct film *f)
{
    const double delay = f->delay / 100.0, now = terminal_clock();
    f->next = fmax(f->next, now - delay) + delay; /* after a slow frame, wait anew */
    screen_show(f);
    for (;;) {
        const int key = screen_key(f->is_stopped ? 1 : f->next - terminal_clock());
        if (key == KEY_END)
            return false;
        if (key == ' ' || key == KEY_RIGHT) {
            f->is_stopped = key == KEY_RIGHT || f->is_stopped != (key == ' ');
            f->next = terminal_clock();
            screen_show(f);
        }
        if (key == KEY_RIGHT || (!f->is_stopped && terminal_clock() >= f->next))
            return true;
    }
}

/* ---- Frames ---- */

/* Moves the view along the row with the front of the fall. When the domino `head` (counted from 1) is hit,
 * this domino is near the middle, and by the time of the next hit, the next domino is. The size of the view
 * suits these dominoes. It grows exponentially, and the place moves in proportion to it. */
static void front_follow(struct film *f, size_t head, double time)
{
    struct stage *stage = &f->row.stage;
    const struct drawn *from = &stage->domino[head - 1], *to = from + (head < stage->count);
    const double begun = falling_row_hit(&f->row, head - 1),
                 until = head < stage->count ? falling_row_hit(&f->row, head) : begun,
                 share = until > begun ? fmin(fmax((time - begun) / (until - begun), 0), 1) : 0,
                 more = to->height - from->height, growth = pow(to->height / from->height, share),
                 way = fabs(more) > 1e-9 * from->height ? (growth - 1) * from->height / more : share;
    stage->at = from->foot + way * (to->foot - from->foot);
    stage->tall = 2.6 * from->height * growth;
}

static bool frame_visit(const struct dom_moment *m, void *context)
{
    struct film *f = context;
    struct stage *stage = &f->row.stage;
    char moment[SENTENCE], more[SENTENCE], speed[64] = "";
    if (f->is_data) {
        answer_cells(f->out, cell_real((domq_real)m->time), cell_count((domq_real)m->head),
                     cell_real((domq_real)m->tilt[m->head - 1]));
        return !answer_lost(f->out);
    }
    const bool over = m->time >= f->row.end;
    falling_row_pose(&f->row, m);
    falling_row_moment(&f->row, m, moment);
    if (over)
        falling_row_verdict(&f->row, more);
    else
        falling_row_summary(&f->row, more);
    if (!over && f->speed != 1)
        snprintf(speed, sizeof speed, " (%.30s times real speed)", measured(f->speed, "", 3).text);
    snprintf(stage->caption, CAPTION, "%s\n%s%s", moment, more, speed);
    if (f->follows)
        front_follow(f, m->head, m->time);
    if (f->screen) {
        f->failed = !frame_draw(f);
        return !f->failed && frame_play(f);
    }
    fputs("unset label\nunset arrow\nunset object\n", f->picture.script);
    sheet_palette(&f->sheet, (int)(f->frame % 2), f->picture.script);
    stage_script(stage, &f->sheet, f->picture.script);
    progress_show((double)++f->frame / (double)f->frames);
    return true;
}

/* ---- The film ---- */

/* Fills f->time with the times of the frames. Infinity stands for the end of the motion. */
static bool times_find(struct film *f)
{
    /* In a file, a long fall is shown faster, which keeps the file small. */
    const bool is_long = (f->is_data || f->out->path) && f->row.end > LONGEST;
    const domq_real speed = (f->words & FILM_SPEED) ? f->query->given->number[0]
                            : is_long               ? round_digits((domq_real)(f->row.end / LONGEST), 2, true)
                                                    : 1;
    const double step = f->delay / 100.0 * (double)speed;
    f->speed = speed;
    if (!isfinite(f->row.end))
        return row_status(f->query, f->problem, DOM_NO_MARGIN);
    double moving = ceil(f->row.end / step - 1e-9);
    const double frames = moving + 1 + (f->is_data || !f->out->path ? 0 : HELD * 100 / f->delay);
    if (frames > FRAMES_MOST)
        return problem_no_answer(
            f->problem,
            "the film would have %.0f frames, but at most %d are drawn; enter 'speed %s', or a smaller rate",
            frames, FRAMES_MOST, measured(speed * (domq_real)(1.05 * frames / FRAMES_MOST), "", 3).text);
    f->frames = (size_t)frames;
    f->time = malloc(f->frames * sizeof *f->time);
    for (size_t k = 0; k < f->frames && f->time; k++)
        f->time[k] = (double)k < moving ? step * (double)k : HUGE_VAL;
    return f->time || problem_status(f->problem, f->query->scene, DOM_NO_MEMORY);
}

static bool frames_watch(struct film *f)
{
    enum dom_status status = falling_row_watch(&f->row, f->time, f->frames, frame_visit, f);
    return status == DOM_OK || row_status(f->query, f->problem, status);
}

/* Plays the film, and leaves the last frame on the terminal. */
static bool film_play(struct film *f)
{
    f->screen = screen_begin(f->out->out);
    if (!f->screen)
        return problem_error(
            f->problem,
            "an animation can be shown only on a terminal; enter 'animate > film.gif' for a file");
    f->next = terminal_clock();
    bool good = frames_watch(f);
    screen_end();
    if (good && (f->failed || dom_raised(f->query->scene->compute.interrupt)))
        good = problem_error(f->problem, "%s", dom_status_text(f->failed ? DOM_NO_MEMORY : DOM_INTERRUPTED));
    if (good && f->text)
        fputs(f->text, f->out->out);
    free(f->text);
    return good;
}

/* Writes the film into a file. All frames have the same size. */
static bool film_write(struct film *f)
{
    enum { FRAME_LEAST = 170, FRAME_MOST = 420 }; /* the minimum and maximum height of a frame, in pixels */
    struct stage *stage = &f->row.stage;
    char verdict[SENTENCE];
    /* Every frame has room for the longest caption, whose second line is the verdict. */
    falling_row_verdict(&f->row, verdict);
    snprintf(stage->caption, CAPTION, "1\n%s", verdict);
    snprintf(f->out->made, sizeof f->out->made, "%zu frames, %.3g s", f->frames,
             (double)f->frames * f->delay / 100);
    f->sheet = sheet_of(stage, FRAME_LEAST, FRAME_MOST);
    return picture_begin(&f->picture, f->out, f->sheet.height, 0, f->delay, f->problem) &&
           picture_end(&f->picture, frames_watch(f), f->problem);
}

static bool film_make(struct film *f)
{
    f->delay = (int)quad(round)(100 / (f->words & FILM_RATE ? f->query->given->number[1] : 25));
    if (!falling_row_make(f->query, f->problem, (f->words & FILM_TOWER) != 0, &f->row))
        return false;
    falling_row_reach(&f->row, true);
    f->follows = f->row.stage.top > FOLLOWED * falling_row_extreme(&f->row, f->row.dominoes, false);
    const bool done = times_find(f) && (f->is_data     ? frames_watch(f)
                                        : f->out->path ? film_write(f)
                                                       : film_play(f));
    free(f->time);
    falling_row_free(&f->row);
    return done;
}

/* ---- The command ---- */

static bool film_parse(struct reader *r, struct question *q)
{
    static const struct argument values[] = {{.name = "speed", .kind = ARGUMENT_NUMBER},
                                             {.name = "rate", .kind = ARGUMENT_NUMBER}};
    unsigned *words = q->parsed = reader_memory(r, sizeof *words);
    while (words && !reader_ends(r)) {
        reader_place(r, r->at);
        const unsigned word = !(*words & FILM_SPEED) && reader_takes(r, "speed")   ? FILM_SPEED
                              : !(*words & FILM_RATE) && reader_takes(r, "rate")   ? FILM_RATE
                              : !(*words & FILM_TOWER) && reader_takes(r, "tower") ? FILM_TOWER
                                                                                   : 0;
        *words |= word;
        if (word == 0) {
            const char *other = read_word(r, WORD_BARE);
            return problem_error(r->problem,
                                 "'%s' does not fit here; usage: animate, animate speed 0.5 rate 20, animate "
                                 "tower",
                                 names_shown(other ? other : ""));
        }
        if (word != FILM_TOWER && !item_parse(r, &values[word - 1], &q->item[word - 1]))
            return false;
    }
    return words;
}

static bool is_within(double value, const char *what, double least, double most, struct problem *problem)
{
    return (value >= least && value <= most) ||
           problem_error(problem, "%s is %.6g; it must be in the range %g .. %g", what, value, least, most);
}

/* The speed is bound like the value of any argument, the rate here. */
static bool film_bind(const struct question *q, const struct query *query, struct arguments *given,
                      struct problem *problem)
{
    const unsigned words = *(const unsigned *)q->parsed;
    domq_real *const value = given->number;
    return item_bind(&q->item[1], q->text, query, NULL, &value[1], problem) &&
           (!(words & FILM_SPEED) || is_within((double)value[0], "speed", 0.001, 1000, problem)) &&
           (!(words & FILM_RATE) || is_within((double)value[1], "rate", 1, 50, problem));
}

static bool run_animate(const struct query *query, struct answer *a, struct problem *problem)
{
    struct film film = {.query = query,
                        .problem = problem,
                        .out = a,
                        .is_data = !answer_for_people(a),
                        .words = query->given->bound ? *(const unsigned *)query->given->bound : 0};
    struct tower tower = {.row = NULL};
    a->note = NULL;      /* no note about the train, because the film shows the row */
    a->style.errors = 0; /* a picture shows no errors */
    a->in_double = a->style.precision == IN_QUAD;
    if (film.words & FILM_TOWER)
        film.query = &tower.query;
    const bool good = (!(film.words & FILM_TOWER) || tower_make(query, &tower, problem)) && film_make(&film);
    tower_free(&tower);
    return good;
}

static const struct column animate_columns[] = {
    {"time", "s", "time of the frame, counted as in 'fall'", 0},
    {"domino", "", "the last domino that was hit", 0},
    {"theta", "rad", "tilt of this domino", 0},
    {NULL, NULL, NULL, 0},
};

const struct command film_commands[] = {
    {.name = "animate",
     .synonyms = "picture image film movie video gif",
     .argument =
         {{.name = "HOW", .kind = ARGUMENT_WORDS, .optional = true, .parse = film_parse, .bind = film_bind}},
     .summary = "a film of the falling row, at the terminal or in a file",
     .help = "'animate' shows the whole fall of the row at the terminal, in characters, with a clock. The "
             "space bar stops and continues it, the right arrow shows the next frame, and 'q' ends it. "
             "'animate speed 0.5' is half as fast as the fall. 'animate > row.gif' makes a file with "
             "gnuplot, which 'ffmpeg -i row.gif row.mp4' turns into a video. A film in a file is faster than "
             "the fall if the fall takes more than 9 s. 'rate 20' makes a film of 20 frames per second. "
             "'animate tower' after 'count 112 m' shows how the row of that answer topples a tower of 112 m. "
             "If the largest domino or the tower is more than 30 times as tall as the smallest domino, the "
             "view follows the front and grows with it. csv and json have the times and tilts of the frames "
             "instead.",
     .example = NULL,
     .see = "draw fall",
     .sweep.refusal = "it draws",
     .writes = WRITES_FILMS,
     .rows = true,
     ANSWER(animate)},
    {.name = NULL},
};
