/* SPDX-License-Identifier: GPL-3.0-or-later */
/* sweep: the answers of a command over a grid of parameters and effects. */
#include "commands/sweeps/sweep.h"
#include "answer/format.h"
#include "commands/sweeps/swept.h"
#include "commands/tables.h"
#include "interpreter/command_read.h"
#include "language/quad.h"
#include "parallel/points.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* One of several answers of a point, each a number. */
struct asked {
    struct question question;
    char key[NAMES_SHOWN]; /* name of its column */
    struct asked *next;
};

/* The arguments of the command, as they were parsed. */
struct sweep_parsed {
    struct grid_parsed grid;
    struct question question; /* that is asked at each point, where there is only one */
    struct asked *several;    /* or these; NULL: there is one */
    const char *asked;        /* as typed */
};

/* The same with values. */
struct sweep {
    struct grid grid;
    const struct sweep_parsed *parsed;
};

/* ---- Parsing ---- */

bool sweep_parse_grid(struct reader *r, struct question *q)
{
    struct sweep_parsed *s = q->parsed = arena_take(r->arena, sizeof *s);
    if (!s)
        return problem_error(r->problem, "out of memory");
    r->stops = ":,";
    bool good = grid_parse(r, &s->grid);
    r->stops = NULL;
    return good && (*r->at == ':' ||
                    problem_error(r->problem, "':' and a command are missing after the grid; for example "
                                              "'sweep s 0.1 0.9 9 : rmax'"));
}

/* Lists for names.h the commands that can be swept. */
static const char *swept_names(const void *context, int k)
{
    const char *name;
    for (int i = 0; (name = command_names(context, i)) != NULL; i++)
        if (command_find(name)->columns && !command_find(name)->unswept && k-- == 0)
            return name;
    return NULL;
}

/* Parses the answers of a list: commands with a principal number, COMMAND.KEY, or expressions. */
static bool several_parse(struct reader *r, struct sweep_parsed *s)
{
    struct asked **last = &s->several;
    for (;;) {
        struct asked *a = *last = arena_take(r->arena, sizeof *a);
        r->at = skip_blanks(r->at);
        reader_place(r, r->at);
        if (!a)
            return problem_error(r->problem, "out of memory");
        if (reader_ends(r))
            return problem_error(r->problem,
                                 "an answer after ',' is missing, as in 'sweep r 1 2 9 : rmax, fuel'");
        if (!question_parse_any(r, &a->question, true))
            return false;
        snprintf(a->key, sizeof a->key, "%s", a->question.name);
        last = &a->next;
        if (*r->at != ',')
            return true;
        r->at++;
    }
}

/* Parses what stands after the ':': a command or an expression, or several with commas between. */
bool sweep_parse_answers(struct reader *r, struct question *q)
{
    struct sweep_parsed *s = q->parsed;
    r->at = skip_blanks(r->at + 1);
    reader_place(r, r->at);
    if (command_ends(r->at) || *r->at == '>')
        return problem_error(r->problem,
                             "the command after ':' is missing; for example 'sweep s 0.1 0.9 9 : rmax'");
    const char *begin = r->at;
    s->question.key = -1;
    r->stops = ",";
    const struct command *c = s->question.command = command_read_inner(r, swept_names);
    if (!c)
        return false;
    if (c->unswept)
        return problem_error(r->problem, "'%s' cannot be swept: %s", c->name, c->unswept);
    if (!c->columns)
        return problem_error(r->problem, "'%s' has no answer; sweep a command that has one, such as 'rmax'",
                             c->name);
    const char *arguments = skip_blanks(r->at);
    bool good = question_parse(r, &s->question);
    if (good && *r->at == ',') {
        r->at = begin;
        good = several_parse(r, s);
    }
    r->stops = NULL;
    bool bare = s->several || strcmp(c->name, "print") == 0; /* the question is not named by its command */
    const char *from = s->several ? begin : arguments, *end = r->at;
    while (end > from && (end[-1] == ' ' || end[-1] == '\t'))
        end--;
    size_t size = strlen(c->name) + (size_t)(end - from) + 2;
    char *asked = good ? arena_take(r->arena, size) : NULL;
    if (asked)
        snprintf(asked, size, "%s%s%.*s", bare ? "" : c->name, bare || end == from ? "" : " ",
                 (int)(end - from), from);
    s->asked = asked;
    return good && (asked || problem_error(r->problem, "out of memory"));
}

static void sweep_free(void *own)
{
    struct sweep *s = own;
    grid_free(&s->grid);
    free(s);
}

bool sweep_bind(const struct question *q, const struct query *query, struct arguments *given,
                struct problem *problem)
{
    const struct sweep_parsed *parsed = q->parsed;
    struct sweep *s = calloc(1, sizeof *s);
    if (!s)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    given->bound = s;
    given->bound_free = sweep_free;
    s->parsed = parsed;
    return grid_bind(&parsed->grid, q->text, query, &s->grid, problem);
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
    struct problem problem;     /* of the last point without an answer */
    size_t index[ASSIGNED_MAX]; /* index of each value on its axis */
    domq_real value[ASSIGNED_MAX];
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

/* Gives the state of the point its values. */
static bool point_assign(struct sweeper *w)
{
    const struct grid *grid = &w->sweep->grid;
    struct assigned assigned[ASSIGNED_MAX];
    for (int i = 0; i < grid->axes; i++)
        assigned[i] = (struct assigned){grid->axis[i].parameter, w->value[i]};
    w->point = *w->base->state;
    w->point.settings.threads = 1; /* the points run in parallel already */
    problem_begin(&w->problem, w->asking);
    return state_assign(&w->point, assigned, grid->axes, &w->problem);
}

/* Answers several questions in one row; one without an answer has a cell without a value, and a reason. */
static bool several_ask(struct sweeper *w, const struct query *at, struct answer *a)
{
    struct cell cells[ANSWER_COLUMNS];
    char reason[SWEPT_REASON] = "";
    int n = 0;
    for (const struct asked *q = w->sweep->parsed->several; q; q = q->next, n++) {
        struct quantity value;
        cells[n] = (struct cell){.kind = CELL_NONE};
        problem_begin(&w->problem, w->asking);
        if (question_value(&q->question, at, &value, &w->problem))
            cells[n] = cell_bound(value.value, DOMQ_NAN);
        else if (w->problem.kind != PROBLEM_NO_ANSWER)
            return false;
        else if (!*reason)
            snprintf(reason, sizeof reason, "%.*s", SWEPT_REASON - 1, w->problem.text);
    }
    return answer_row(a, cells, *reason ? reason : NULL);
}

/* Answers at the point. Returns false if there is no answer; w->problem says why. */
static bool point_ask(struct sweeper *w, struct answer *a, bool assigned)
{
    struct query at = *w->base;
    at.state = &w->point;
    at.scene = &w->point.scene;
    at.means = &w->means;
    at.next = NULL;
    return assigned &&
           (w->sweep->parsed->several ? several_ask(w, &at, a)
                                      : question_ask(&w->sweep->parsed->question, &at, a, &w->problem));
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
    bool head = to && !to->has_rows && to->style.format->for_people;
    if (head && point_like(w)) {
        memcpy(like, w->swept.first, sizeof like);
        to->sample = like;
    }
    point_values(w, k);
    swept_begin(&w->swept);
    w->swept.to = to;
    swept_none(&w->swept, reason);
    if (to)
        to->sample = NULL;
}

/* Writes the rows of point k, unless `to` is NULL. Returns false if the line is wrong, as w->problem
 * says. */
static bool point_answer(struct sweeper *w, size_t k, struct answer *to)
{
    struct answer a = w->answer;
    a.columns = w->sweep->parsed->several ? w->swept.asked : w->sweep->parsed->question.command->columns;
    a.out = to ? to->out : NULL;
    a.point = swept_row;
    a.swept = &w->swept;
    point_values(w, k);
    swept_begin(&w->swept);
    w->swept.to = to;
    bool assigned = point_assign(w);
    if (w->styled) {
        struct answer_style style = state_style(&w->point);
        style.digits = a.style.digits; /* columns have one width in all rows */
        style.format = a.style.format; /* which a picture has chosen for itself */
        a.style = style;
    }
    if (to)
        to->style = a.style;
    bool done = point_ask(w, &a, assigned);
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
static bool is_echoed(const struct question *q)
{
    for (int i = 0; q->command->echo && i < q->count; i++)
        if (q->command->argument[i].of && strcmp(q->command->argument[i].of, q->command->echo) == 0)
            return true;
    return false;
}

/* Makes the columns of several answers: their names, and the units that they have in the state of the query.
 */
static void several_columns(struct sweeper *w, const struct query *query)
{
    struct swept *s = &w->swept;
    int n = 0;
    for (const struct asked *q = w->sweep->parsed->several; q && n + 1 < ANSWER_COLUMNS; q = q->next, n++) {
        const struct question *asked = &q->question;
        struct problem unheard = {.kind = PROBLEM_NONE};
        struct quantity value = {.value = 0};
        struct column *column = &s->asked[n];
        if (asked->key >= 0)
            *column = asked->command->columns[asked->key];
        else {
            question_value(asked, query, &value, &unheard);
            *column = (struct column){.unit = expression_unit_text(value, s->unit[n], sizeof s->unit[n])};
        }
        *column = (struct column){q->key, column->unit, "", 0};
    }
    s->asked[n] = (struct column){NULL, NULL, NULL, 0};
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
        w->styled = w->styled || p->of_precision || p->moves;
    }
    const struct command *c = s->parsed->question.command;
    if (s->parsed->several)
        several_columns(w, query);
    if (!swept_columns(&w->swept, &s->grid, c, s->parsed->several ? w->swept.asked : c->columns,
                       is_echoed(&s->parsed->question))) {
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
    a->has_reasons = true;
    sweep_largest(a, &w->sweep->grid);
    answer_plan(a, w->swept.first);
    w->answer = *a;
    const struct workers workers = {.points = w->sweep->grid.points,
                                    .point = sweep_point,
                                    .context = w,
                                    .size = sizeof *w,
                                    .merge = sweep_gather};
    return points_answer(query, problem, a, workers, &by_point) ||
           (by_point && sweep_error(query, problem, w));
}

bool run_sweep(const struct query *query, struct answer *a, struct problem *problem)
{
    char where[256];
    struct sweeper *w = sweeper_make(query, problem, query->given->bound, a);
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

struct sweep_shape sweep_shape(const struct arguments *given)
{
    const struct sweep *s = given->bound;
    return (struct sweep_shape){&s->grid, s->parsed->question.command, s->parsed->asked};
}
