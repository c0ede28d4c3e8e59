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

bool sweep_read_grid(struct reader *r, struct arguments *given)
{
    struct sweep *s = calloc(1, sizeof *s);
    if (!s)
        return problem_status(r->problem, r->query->scene, DOM_NO_MEMORY);
    given->own = s;
    given->own_free = sweep_free;
    r->stops = ":,";
    bool good = grid_read(r, &s->grid);
    r->stops = NULL;
    return good && (*r->at == ':' ||
                    problem_error(r->problem, "':' and a command are missing after the grid; for example "
                                              "'sweep s 0.1 0.9 9 : rmax'"));
}

/* Returns the command of each point; an expression means 'print'. */
static const struct command *asked_command(struct reader *r)
{
    const char *begin = r->at;
    const struct command *c = read_form(r);
    if (c && c->run == run_print)
        return c;
    r->at = begin;
    return r->problem->kind == PROBLEM_NONE ? read_command(r) : NULL;
}

bool sweep_read_command(struct reader *r, struct arguments *given)
{
    struct sweep *s = given->own;
    r->at = skip_blanks(r->at + 1);
    r->problem->place = reader_column(r, r->at);
    if (command_ends(r->at) || *r->at == '>')
        return problem_error(r->problem,
                             "the command after ':' is missing; for example 'sweep s 0.1 0.9 9 : rmax'");
    const struct command *c = s->command = asked_command(r);
    if (!c)
        return false;
    if (c->unswept)
        return problem_error(r->problem, "'%s' cannot be swept: %s", c->name, c->unswept);
    if (!c->columns)
        return problem_error(r->problem, "'%s' has no answer; sweep a command that has one, such as 'rmax'",
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
    const struct query *base; /* each point starts from a copy of its state */
    bool styled;              /* the grid changes the precision or the tolerance of numbers */
    struct answer answer;
    struct state point;
    struct means means; /* of a point */
    const char *asking; /* the name of the command that sweeps */
    struct swept swept;
    struct problem problem; /* of the last point without an answer */
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

/* Runs the command. Returns false if it has no answer; w->problem says why. */
static bool point_ask(struct sweeper *w, struct answer *a)
{
    const struct sweep *s = w->sweep;
    struct arguments given = {.count = 0};
    struct query at = *w->base;
    at.state = &w->point;
    at.scene = &w->point.scene;
    at.means = &w->means;
    at.given = &given;
    at.next = NULL;
    struct reader r = {.query = &at, .problem = &w->problem, .text = s->text, .at = s->arguments};
    w->point = *w->base->state;
    w->point.settings.threads = 1; /* the points run in parallel already */
    w->problem = (struct problem){.command = w->asking};
    grid_put(&s->grid, w->value, &w->point);
    bool done = grid_check(&s->grid, at.scene, &w->problem);
    w->problem.command = done ? s->command->name : w->asking;
    done = done && read_arguments(&r, s->command, &given);
    if (done) {
        w->problem.place = 0;
        done = s->command->run(&at, a, &w->problem);
    }
    arguments_free(&given);
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
    snprintf(reason, sizeof reason, "%.*s", SWEPT_REASON - 1, why);
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

/* Writes the rows of point k, unless `to` is NULL. Returns false if the line is wrong, as w->problem
 * says. */
static bool point_answer(struct sweeper *w, size_t k, struct answer *to)
{
    struct answer a = w->answer;
    a.columns = w->sweep->command->columns;
    a.out = to ? to->out : NULL;
    a.point = swept_row;
    a.swept = &w->swept;
    point_values(w, k);
    swept_begin(&w->swept);
    w->swept.to = to;
    if (w->styled) {
        struct state styled = *w->base->state;
        grid_put(&w->sweep->grid, w->value, &styled);
        struct output_style style = state_style(&styled);
        style.digits = a.style.digits; /* columns have one width in all rows */
        style.format = a.style.format; /* which a picture has chosen for itself */
        a.style = style;
    }
    if (to)
        to->style = a.style;
    bool done = point_ask(w, &a);
    if (!done && w->problem.kind != PROBLEM_NO_ANSWER)
        return false;
    if (!done || !w->swept.answered)
        point_none(w, k, to, done ? "there is no answer here" : w->problem.text);
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
static bool echo_called(const struct query *query, const struct sweep *sweep)
{
    const struct command *c = sweep->command;
    struct problem unheard = {.kind = PROBLEM_NONE};
    struct arguments call = {.count = 0};
    struct reader r = {.query = query, .problem = &unheard, .text = sweep->text, .at = sweep->arguments};
    int given = read_arguments(&r, c, &call) ? call.count : call.count + 1; /* the next argument is wrong */
    arguments_free(&call);
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

/* Gives the problem of a point as that of the sweep. */
static bool sweep_error(const struct query *query, struct problem *problem, const struct sweeper *w)
{
    if (dom_raised(query->scene->compute.interrupt))
        return problem_status(problem, query->scene, DOM_INTERRUPTED);
    *problem = w->problem;
    return false;
}

static struct sweeper *sweeper_make(const struct query *query, struct problem *problem, const struct sweep *s,
                                    const struct answer *a)
{
    struct sweeper *w = calloc(1, sizeof *w);
    if (!w)
        return NULL;
    w->sweep = s;
    w->base = query;
    w->asking = problem->command;
    w->means = *query->means;
    w->means.shard.parts = 0;
    w->answer = *a;
    for (int i = 0; i < s->grid.axes; i++) {
        const struct parameter *p = s->grid.axis[i].parameter;
        w->index[i] = SIZE_MAX; /* no value yet */
        w->styled = w->styled || p->fallback_of || p->moves;
    }
    bool echoed = s->command->echo && echo_called(query, s);
    if (!swept_columns(&w->swept, &s->grid, s->command, echoed)) {
        problem_error(problem, "a row of this sweep would have more than %d columns; sweep fewer parameters",
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
static bool sweep_rows(const struct query *query, struct problem *problem, struct answer *a,
                       struct sweeper *w)
{
    bool by_point = true, bounds = a->style.errors && !a->style.format->for_people;
    if ((bounds || sweep_measured(a, w)) && !point_like(w) && w->problem.kind == PROBLEM_WRONG)
        return sweep_error(query, problem, w);
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
    return points_answer(query, problem, a, &points, &by_point) ||
           (by_point && sweep_error(query, problem, w));
}

bool run_sweep(const struct query *query, struct answer *a, struct problem *problem)
{
    char where[256];
    struct sweeper *w = sweeper_make(query, problem, query->given->own, a);
    if (!w)
        return problem->kind == PROBLEM_NONE ? problem_status(problem, query->scene, DOM_NO_MEMORY) : false;
    bool done = sweep_rows(query, problem, a, w);
    if (done && w->reasons > 0) {
        point_text(w, w->first, where, sizeof where);
        answer_say(a, "%zu of %zu points %s %s. The first is %s: %s.%s", w->reasons,
                   means_part(query->means, w->sweep->grid.points).count, w->reasons == 1 ? "has" : "have",
                   w->none == w->reasons ? "no answer" : "a missing value", where, w->reason,
                   w->reasons == 1 ? "" : " csv and json give the reason of each.");
    }
    free(w);
    return done;
}

struct sweep_shape sweep_shape(const struct arguments *call)
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
    shape.expression = strcmp(s->command->name, "print") == 0;
    snprintf(shape.asked, sizeof shape.asked, "%s%s%.*s", shape.expression ? "" : s->command->name,
             end > arguments && !shape.expression ? " " : "", (int)(end - arguments), arguments);
    return shape;
}
