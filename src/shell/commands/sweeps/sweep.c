/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep: the answers of a command over a grid of parameters and effects. */
#include "answer/format.h"
#include "commands/plots/plots.h"
#include "commands/sweeps/grid.h"
#include "commands/sweeps/swept.h"
#include "commands/tables.h"
#include "interpreter/forms.h"
#include "language/quad.h"
#include "parallel/points.h"
#include "session/parameters.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* The arguments of the command. */
struct sweep {
    struct grid grid;
    const struct command *command; /* runs at each point */
    const struct text *text;
    const char *arguments; /* of the command, in the text */
};

/* ---- Reading ---- */

static void sweep_free(void *own)
{
    struct sweep *s = own;
    if (s)
        grid_free(&s->grid);
    free(s);
}

bool sweep_read_grid(struct reader *r, struct call *call)
{
    struct sweep *s = calloc(1, sizeof *s);
    if (!s)
        return session_status(r->session, DOM_NO_MEMORY);
    call->own = s;
    call->own_free = sweep_free;
    r->stops = ":,";
    bool good = grid_read(r, &s->grid);
    r->stops = NULL;
    return good && (*r->at == ':' ||
                    session_error(r->session, "':' and a command are missing after the grid; for example "
                                              "'sweep s 0.1 0.9 9 : rmax'"));
}

/* Returns the command of each point; an expression means 'print'. */
static const struct command *asked_command(struct reader *r)
{
    const char *begin = r->at;
    long errors = r->session->errors;
    const struct command *c = read_form(r);
    if (c && c->run == run_print)
        return c;
    r->at = begin;
    return r->session->errors == errors ? read_command(r) : NULL;
}

bool sweep_read_command(struct reader *r, struct call *call)
{
    struct session *session = r->session;
    struct sweep *s = call->own;
    r->at = skip_blanks(r->at + 1);
    session->column = reader_column(r, r->at);
    if (command_ends(r->at) || *r->at == '>')
        return session_error(session,
                             "the command after ':' is missing; for example 'sweep s 0.1 0.9 9 : rmax'");
    const struct command *c = s->command = asked_command(r);
    if (!c)
        return false;
    if (c->unswept)
        return session_error(session, "'%s' cannot be swept: %s", c->name, c->unswept);
    if (!c->columns)
        return session_error(session, "'%s' has no answer; sweep a command that has one, such as 'rmax'",
                             c->name);
    s->text = r->text;
    s->arguments = r->at;
    r->at = text_end(r->at, ";>");
    return true;
}

/* ---- One point ---- */

/* The data of a worker. All workers share sweep and base, which do not change. */
struct sweeper {
    const struct sweep *sweep;
    const struct session *base; /* each point starts from a copy of it */
    bool styled;                /* the grid changes the precision or the tolerance of numbers */
    struct answer answer;
    struct session point;
    struct swept swept;
    struct captured_error captured_error;
    size_t index[AXES_MAX]; /* index of each value on its axis */
    domq_real value[AXES_MAX];
    size_t reasons;            /* the number of points with a reason for a missing value */
    size_t none;               /* the number of points without a row of an answer */
    size_t first;              /* the first point with a reason */
    char reason[SWEPT_REASON]; /* its reason */
};

/* Finds the values of point k; the first parameter of the grid changes slowest. */
static void point_values(struct sweeper *w, size_t k)
{
    const struct grid *grid = &w->sweep->grid;
    for (int i = grid->axes - 1; i >= 0; i--) {
        const struct axis *axis = &grid->axis[i];
        size_t index = k % axis->count;
        k /= axis->count;
        if (index == w->index[i])
            continue;
        w->index[i] = index;
        w->value[i] = axis_value(axis, index);
        w->swept.value[i] = axis_cell(axis, w->value[i]);
    }
}

static void point_session(struct sweeper *w, FILE *out)
{
    w->point = *w->base;
    w->point.out = out;
    w->point.captured_error = &w->captured_error;
    w->point.threads = 1; /* the points run in parallel already */
    w->point.shard.parts = 0;
    w->captured_error.text[0] = '\0';
    grid_put(&w->sweep->grid, w->value, &w->point);
}

/* Runs the command. Returns false if it has no answer; captured_error has the message. */
static bool point_ask(struct sweeper *w, struct answer *a)
{
    const struct sweep *s = w->sweep;
    struct call call = {.answer = a};
    struct reader r = {.session = &w->point, .text = s->text, .at = s->arguments};
    bool done = grid_check(&s->grid, &w->point);
    w->point.command = s->command->name;
    done = done && read_arguments(&r, s->command, &call);
    if (done) {
        w->point.column = 0;
        done = s->command->run(&w->point, &call);
    }
    call_free(&call);
    return done;
}

static bool point_answer(struct sweeper *w, size_t k, struct answer *to);

/* The most points that are tried to find one with an answer, which shows the kinds of cells. */
enum { TRIED = 256 };

/* Returns true if one of the first points has an answer; its first row is then in swept.first. */
static bool point_like(struct sweeper *w)
{
    size_t points = w->sweep->grid.points;
    w->swept.answered = false;
    for (size_t k = 0; k < points && k < TRIED && !w->swept.answered; k++)
        if (!point_answer(w, k, NULL))
            return false;
    return w->swept.answered;
}

/* Writes the row of a point without an answer. The head of a table takes units and kinds from other points.
 */
static void point_none(struct sweeper *w, size_t k, struct answer *to, const char *why)
{
    struct cell like[ANSWER_COLUMNS];
    char reason[SWEPT_REASON];
    snprintf(reason, sizeof reason, "%s", why);
    bool head = to && !to->begun && to->style.format->for_people;
    if (head && point_like(w)) {
        memcpy(like, w->swept.first, sizeof like);
        to->like = like;
    }
    point_values(w, k);
    swept_begin(&w->swept);
    w->swept.to = to;
    swept_none(&w->swept, reason);
    if (to)
        to->like = NULL;
}

/* Writes the rows of point k, unless `to` is NULL. Returns false if the line is wrong, as captured_error
 * says. */
static bool point_answer(struct sweeper *w, size_t k, struct answer *to)
{
    struct answer a = w->answer;
    a.columns = w->sweep->command->columns;
    a.out = to ? to->out : NULL;
    a.point = swept_row;
    a.swept = &w->swept;
    point_values(w, k);
    point_session(w, a.out);
    swept_begin(&w->swept);
    w->swept.to = to;
    if (w->styled) {
        struct output_style style = session_style(&w->point);
        style.digits = a.style.digits; /* columns have one width in all rows */
        style.format = a.style.format; /* which a picture has chosen for itself */
        a.style = style;
    }
    if (to)
        to->style = a.style;
    bool done = point_ask(w, &a);
    if (!done && !w->captured_error.no_answer)
        return false;
    if (!done || !w->swept.answered)
        point_none(w, k, to, done ? "there is no answer here" : w->captured_error.text);
    return true;
}

static bool sweep_point(void *own, size_t k, FILE *out)
{
    struct sweeper *w = own;
    struct answer to = answer_part(&w->answer, out, k == 0);
    to.columns = w->swept.column; /* the columns of this worker */
    bool good = point_answer(w, k, &to);
    w->swept.to = NULL;
    w->none += good && !w->swept.answered;
    if (good && w->swept.reasoned && w->reasons++ == 0) {
        w->first = k;
        memcpy(w->reason, w->swept.reason, sizeof w->reason);
    }
    return good;
}

static void sweep_gather(void *own, const void *worker)
{
    struct sweeper *all = own;
    const struct sweeper *w = worker;
    if (w->reasons > 0 && (all->reasons == 0 || w->first < all->first)) {
        all->first = w->first;
        memcpy(all->reason, w->reason, sizeof all->reason);
    }
    all->reasons += w->reasons;
    all->none += w->none;
}

/* ---- All of them ---- */

/* Returns true if an argument replaces the parameter that a column of the command repeats. */
static bool echo_called(const struct session *session, const struct sweep *sweep)
{
    const struct command *c = sweep->command;
    struct session scratch = *session;
    struct captured_error captured_error = {.text = ""};
    struct call call = {.count = 0};
    struct reader r = {.session = &scratch, .text = sweep->text, .at = sweep->arguments};
    scratch.captured_error = &captured_error;
    int given = read_arguments(&r, c, &call) ? call.count : call.count + 1; /* the next argument is wrong */
    call_free(&call);
    for (int i = 0; i < given && i < ARGUMENTS_MAX && c->argument[i].kind; i++)
        if (c->argument[i].of && strcmp(c->argument[i].of, c->echo) == 0)
            return true;
    return false;
}

/* Writes the values of point k: "s = 0.7, d = 0.1". */
static void point_text(struct sweeper *w, size_t k, char *text, size_t size)
{
    const struct grid *grid = &w->sweep->grid;
    size_t used = 0;
    text[0] = '\0';
    point_values(w, k);
    for (int i = 0; i < grid->axes && used < size; i++) {
        char number[CELL_TEXT];
        used +=
            (size_t)snprintf(text + used, size - used, "%s%s = %s", i ? ", " : "",
                             grid->axis[i].parameter->name, cell_text(w->swept.value[i], 6, false, number));
    }
}

/* Reports the error of a point as an error of the session. */
static bool sweep_error(struct session *session, const struct sweeper *w)
{
    if (dom_raised(session->compute.interrupt))
        return session_status(session, DOM_INTERRUPTED);
    const char *command = session->command;
    session->column = w->captured_error.column;
    session->command = w->captured_error.command;
    session_error(session, "%s", w->captured_error.text);
    session->command = command;
    return false;
}

static struct sweeper *sweeper_make(struct session *session, const struct sweep *s, const struct answer *a)
{
    struct sweeper *w = calloc(1, sizeof *w);
    if (!w)
        return NULL;
    w->sweep = s;
    w->base = session;
    w->answer = *a;
    for (int i = 0; i < s->grid.axes; i++) {
        const struct parameter *p = s->grid.axis[i].parameter;
        w->index[i] = SIZE_MAX; /* no value yet */
        w->styled = w->styled || p->fallback_of || p->moves;
    }
    bool echoed = s->command->echo && echo_called(session, s);
    if (!swept_columns(&w->swept, &s->grid, s->command, echoed)) {
        session_error(session, "a row of this sweep would have more than %d columns; sweep fewer parameters",
                      ANSWER_COLUMNS - 1);
        free(w);
        return NULL;
    }
    return w;
}

/* Returns true if a column of a table takes its unit from the first point that has an answer. */
static bool sweep_measured(const struct answer *a, const struct sweeper *w)
{
    for (int i = w->swept.values; w->swept.column[i].key; i++)
        if (a->style.format->for_people && measure_varies(w->swept.column[i].unit))
            return true;
    return false;
}

/* Gives the answer the largest value of each axis, for the unit of its column. */
static void sweep_largest(struct answer *a, const struct grid *grid)
{
    for (int i = 0; i < grid->axes; i++) {
        const struct axis *axis = &grid->axis[i];
        size_t step = axis->list || axis->count < 3 ? 1 : axis->count - 1; /* the ends are enough */
        domq_real most = 0;
        for (size_t k = 0; k < axis->count; k += step) {
            domq_real value = quad(fabs)(axis_value(axis, k));
            most = isfinite(value) ? quad_larger(most, value) : most; /* an effect may be off */
        }
        answer_largest(a, axis->parameter->name, most);
    }
}

/* Writes the rows of all points. The head, which is the same in each part, is planned before. */
static bool sweep_rows(struct session *session, struct answer *a, struct sweeper *w)
{
    bool by_point = true, bounds = a->style.errors && !a->style.format->for_people;
    if ((bounds || sweep_measured(a, w)) && !point_like(w) && *w->captured_error.text &&
        !w->captured_error.no_answer)
        return sweep_error(session, w);
    a->columns = w->swept.column;
    a->reasoned = true;
    sweep_largest(a, &w->sweep->grid);
    answer_plan(a, w->swept.first);
    w->answer = *a;
    const struct points points = {.total = w->sweep->grid.points,
                                  .point = sweep_point,
                                  .own = w,
                                  .size = sizeof *w,
                                  .gather = sweep_gather};
    return points_answer(session, a, &points, &by_point) || (by_point && sweep_error(session, w));
}

bool run_sweep(struct session *session, const struct call *call)
{
    char where[256];
    long errors = session->errors;
    struct answer *a = call->answer;
    struct sweeper *w = sweeper_make(session, call->own, a);
    if (!w)
        return session->errors == errors ? session_status(session, DOM_NO_MEMORY) : false;
    bool done = sweep_rows(session, a, w);
    if (done && w->reasons > 0) {
        point_text(w, w->first, where, sizeof where);
        answer_say(a, "%zu of %zu points %s %s. The first is %s: %s.%s", w->reasons,
                   session_part(session, w->sweep->grid.points).count, w->reasons == 1 ? "has" : "have",
                   w->none == w->reasons ? "no answer" : "a missing value", where, w->reason,
                   w->reasons == 1 ? "" : " csv and json give the reason of each.");
    }
    free(w);
    return done;
}

struct sweep_shape sweep_shape(const struct call *call)
{
    const struct sweep *s = call->own;
    struct sweep_shape shape = {.axes = s->grid.axes, .command = s->command};
    for (int i = 0; i < s->grid.axes && i < SWEEP_AXES; i++) {
        const struct axis *axis = &s->grid.axis[i];
        shape.axis[i] = (struct sweep_axis){.name = axis->parameter->name,
                                            .unit = axis->parameter->value->unit,
                                            .parameter = axis->parameter,
                                            .count = axis->count,
                                            .logarithmic = axis->logarithmic};
    }
    const char *arguments = skip_blanks(s->arguments), *end = text_end(arguments, ";>");
    while (end > arguments && (end[-1] == ' ' || end[-1] == '\t'))
        end--;
    snprintf(shape.asked, sizeof shape.asked, "%s%s%.*s", s->command->name, end > arguments ? " " : "",
             (int)(end - arguments), arguments);
    return shape;
}
