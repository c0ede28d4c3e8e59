/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The session's row to scale, as it stands or at a moment of its fall. */
#include "commands/drawing/draw_row.h"
#include "answer/measure.h"
#include "commands/drawing/row_picture.h"
#include "commands/drawing/row_text.h"
#include "commands/rows/falling.h"
#include "io/terminal.h"
#include "language/quad.h"
#include "picture/ending.h"
#include "picture/picture.h"
#include <stdlib.h>
#include <string.h>

/* The row at the moment that is asked for. */
struct row_moment {
    struct falling_row row;
    double *tilt;
    double time;
    size_t head; /* 0: the row as it is set up */
};

static bool moment_seen(const struct domq_moment *moment, void *context)
{
    struct row_moment *m = context;
    m->time = (double)moment->time;
    m->head = moment->head;
    for (size_t k = 0; k < m->row.count; k++)
        m->tilt[k] = (double)moment->tilt[k];
    return true;
}

/* Finds the time that is asked for; false: an error was reported. */
static bool moment_time(struct problem *problem, const struct draw_what *what, const struct falling_row *row,
                        domq_real *time)
{
    problem->place = what->column;
    if (what->at == ROW_AT_END) {
        *time = (domq_real)HUGE_VAL;
        return true;
    }
    *time = what->time;
    if (what->at == ROW_AT_DOMINO) {
        if (!(what->domino >= 1 && what->domino <= (domq_real)row->count) ||
            what->domino != quad(floor)(what->domino))
            return problem_no_answer(
                problem, "there is no domino %s: this row has %zu; 'draw at domino %zu' shows the last",
                quad_shown(what->domino).text, row->count, row->count);
        size_t k = (size_t)what->domino - 1;
        *time = (domq_real)row->hit[k];
        if (k == 0 && row->tipped)
            *time = (domq_real)falling_row_begins(row);
        else if (isnan(*time) && k + 1 > row->verdict.domino)
            return problem_no_answer(
                problem, "domino %zu is never hit: the row ends at domino %zu; 'draw at end' shows that",
                k + 1, row->verdict.domino);
        return true;
    }
    if (*time < 0 && !row->tipped)
        return problem_no_answer(problem,
                                 "the clock starts at 0 s, with the push; 'draw at 0' shows that moment");
    /* As it was answered, in few digits, the end may have been rounded up. */
    if ((double)*time > row->end * 1.005)
        return problem_no_answer(problem, "the motion ends at %s; 'draw at end' shows that",
                                 measured((domq_real)row->end, "s", 4).text);
    return true;
}

/* ---- In words ---- */

enum { CAPTION = 4 * ROW_SENTENCE };

static void caption_write(const struct query *query, const struct answer *a, const struct row_moment *m,
                          bool coloured, char text[CAPTION])
{
    const struct falling_row *row = &m->row;
    char verdict[ROW_SENTENCE], weakest[ROW_SENTENCE], first[ROW_SENTENCE];
    struct measured floor = measured((domq_real)row_right(row, false), "m", 3);
    char rounded[ROW_SENTENCE] = "";
    if (query->scene->train.rho != 0)
        snprintf(rounded, sizeof rounded, ", edges rounded by %.4g of the height",
                 (double)query->scene->train.rho);
    if (m->head > 0)
        falling_row_moment(row, m->head, m->time, first);
    else
        falling_row_summary(row, first);
    falling_row_verdict(row, coloured ? "black" : row_text_end(a->out), verdict);
    falling_row_weakest(row, coloured ? "red" : row_text_weakest(a->out), weakest);
    int at = snprintf(text, CAPTION, "%s", first);
    if (m->head == 0)
        at += snprintf(text + at, CAPTION - (size_t)at, "%s, on %s of floor%s.", rounded, floor.text,
                       query->scene->effect[DOM_EFFECT_slope].on ? " that slopes (drawn level)" : "");
    snprintf(text + at, CAPTION - (size_t)at, "\n%s%s%s", verdict, *weakest ? "\n" : "", weakest);
}

/* ---- Data ---- */

static void moment_rows(struct answer *a, const struct row_moment *m)
{
    a->style.errors = 0; /* a picture needs no bounds */
    for (struct column *c = answer_columns(a, a->columns); c->key; c++)
        if (strcmp(c->unit, "h") == 0)
            c->unit = "m";
    static const char *const none[] = {"contact_x", "contact_z", "force", "of_own"};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        answer_leave_out(a, none[i]);
    for (size_t k = 0; k < m->row.count && !answer_lost(a); k++) {
        struct drawn d =
            falling_row_domino(&m->row, k, m->head > 0 ? m->tilt[k] : falling_row_lean(&m->row, k));
        d = drawn_for_people(&d);
        const struct point *p = d.corner;
        answer_cells(a, cell_count((domq_real)k + 1), cell_real((domq_real)d.height),
                     cell_real((domq_real)d.foot), cell_real((domq_real)d.theta),
                     cell_real((domq_real)p[1].x), cell_real((domq_real)p[1].y), cell_real((domq_real)p[2].x),
                     cell_real((domq_real)p[2].y), cell_real((domq_real)p[3].x),
                     cell_real((domq_real)p[3].y));
    }
}

/* ---- By gnuplot ---- */

enum { HEIGHT_LEAST = 190, HEIGHT_MOST = 560 }; /* of a picture, in dots */

static bool moment_file(const struct query *query, struct answer *a, struct problem *problem,
                        const struct row_moment *m)
{
    struct picture picture;
    char text[CAPTION], line[CAPTION_LINES][ROW_SENTENCE];
    const struct falling_row *row = &m->row;
    if (!picture_begin(a, problem, &picture))
        return false;
    caption_write(query, a, m, true, text);
    int lines = caption_wrap(text, line, CAPTION_COLUMNS);
    double high = row->tallest, right = row_right(row, m->head > 0), edge = 0.02 * right;
    struct view view = view_of(-edge, right + edge, high, lines, HEIGHT_LEAST, HEIGHT_MOST, 0);
    double room = m->head == 0 ? row_label_room(&view, row) : 0;
    view = view_of(-edge, right + edge, high, lines, HEIGHT_LEAST, HEIGHT_MOST, room);
    script_sheet(picture.script, a->path, &view);
    script_view(picture.script, &view);
    script_caption(picture.script, &view, text);
    script_row(picture.script, &view, row, m->head > 0 ? m->tilt : NULL, m->head, m->head == 0);
    return picture_end(query, problem, &picture, true);
}

/* ---- In characters ---- */

static bool moment_text(const struct query *query, struct answer *a, struct problem *problem,
                        const struct row_moment *m)
{
    char text[CAPTION];
    int width, height, lines = 0;
    ticker_stop();
    picture_room(a, &width, &height);
    caption_write(query, a, m, false, text);
    for (char *line = text, *end; line; line = end ? end + 1 : NULL) {
        end = strchr(line, '\n');
        if (end)
            *end = '\0';
        output_wrapped(a->out, line, 0, width);
        putc('\n', a->out);
        lines += 1 + (int)strlen(line) / width;
    }
    return row_text(&m->row, m->head > 0 ? m->tilt : NULL, m->head, row_right(&m->row, m->head > 0), width,
                    height - lines, a->out) ||
           problem_status(problem, query->scene, DOM_NO_MEMORY);
}

/* ---- The command ---- */

bool draw_row(const struct query *query, struct answer *a, struct problem *problem,
              const struct draw_what *what)
{
    struct row_moment m = {.head = 0};
    domq_real time = 0;
    bool people = answer_for_people(a), done = false;
    a->of_row = true;
    if (!falling_row_make(query, problem, &m.row))
        return false;
    enum dom_status status = DOM_OK;
    m.tilt = malloc(m.row.count * sizeof *m.tilt);
    if (!m.tilt)
        status = DOM_NO_MEMORY;
    else if (what->at == ROW_STANDS || (done = moment_time(problem, what, &m.row, &time))) {
        if (what->at != ROW_STANDS)
            status = falling_row_watch(&m.row, &time, 1, moment_seen, &m);
        done = true;
    }
    if (status != DOM_OK)
        done = row_status(query, problem, status);
    else if (done && !people)
        moment_rows(a, &m);
    else if (done && picture_is_text(a))
        done = moment_text(query, a, problem, &m);
    else if (done)
        done = moment_file(query, a, problem, &m);
    free(m.tilt);
    falling_row_free(&m.row);
    return done;
}
