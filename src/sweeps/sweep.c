/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'sweep', which prints the answers of a command at all points of a grid. */
#include "answer/format.h"
#include "interpreter/question.h"
#include "language/text.h"
#include "parallel/workers.h"
#include "sweeps/point.h"
#include "train/train.h"
#include <stdlib.h>
#include <string.h>

struct sweep_parsed {
    struct grid_parsed grid;
    struct point_question question;
    const char *typed; /* the answers as they were typed */
};

struct sweep {
    struct grid grid;
    const struct point_question *question;
    const char *typed;
};

/* The sweep that 'curve' stands for. */
struct curve {
    struct sweep sweep;
    struct point_question question;
};

/* ---- Parsing ---- */

bool sweep_parse_grid(struct reader *r, struct question *q)
{
    struct sweep_parsed *s = q->parsed = reader_memory(r, sizeof *s);
    return s && grid_parse(r, &s->grid);
}

/* A names_list (see names.h) of the commands that can be swept. */
static const char *sweepable_names(const void *context, int k)
{
    const struct command *c;
    (void)context;
    for (int i = 0; (c = command_at(i)) != NULL; i++)
        if (c->columns && !c->sweep.refusal && k-- == 0)
            return c->name;
    return NULL;
}

/* Parses a command or an expression. The name of the question does not include the word 'print'. */
static bool answer_parse(struct reader *r, struct question *q)
{
    const char *begin = r->at;
    q->key = -1;
    const struct command *c = q->command = command_read_inner(r, sweepable_names);
    if (!c)
        return false;
    if (c->sweep.refusal)
        return problem_error(r->problem, "'%s' cannot be swept: %s", c->name, c->sweep.refusal);
    if (!c->columns)
        return problem_error(r->problem, "'%s' has no answer; sweep a command that has one, such as 'rmax'",
                             c->name);
    if (c->is_print)
        begin = skip_blanks(r->at);
    bool is_good = question_parse(r, q);
    q->name = question_name(r, begin, r->at);
    return is_good;
}

/* If 'with' follows the last answer alone, as in "rmax, fuel with d 0.1", it applies to all of them. The name
 * of the last column then does not repeat it. */
static void with_share(struct reader *r, struct point_question *first, struct point_question *last)
{
    bool is_shared = last != first && last->question.with;
    int depth = 0;
    for (const struct point_question *q = first; q != last; q = q->next)
        is_shared = is_shared && !q->question.with;
    for (struct point_question *q = first; q != last && is_shared; q = q->next)
        q->question.with = last->question.with;
    const char *name = last->question.name, *end = name;
    while (is_shared && *end && (depth > 0 || strncmp(end, " with ", 6) != 0)) {
        depth += (*end == '(') - (*end == ')');
        end++;
    }
    if (is_shared)
        last->question.name = question_name(r, name, end);
}

/* Parses a list of answers. Each of them is a command that has a principal number, or COMMAND.KEY, or an
 * expression. */
static bool list_parse(struct reader *r, struct point_question *s)
{
    struct point_question *const first = s;
    while (question_parse_any(r, &s->question, true)) {
        if (*r->at != ',') {
            with_share(r, first, s);
            return true;
        }
        r->at = skip_blanks(r->at + 1);
        reader_place(r, r->at);
        s->next = reader_memory(r, sizeof *s);
        if (!s->next)
            return false;
        s = s->next;
        if (reader_ends(r))
            return problem_error(
                r->problem,
                "the answer after ',' is missing; enter, for example, 'sweep r 1 2 9 : rmax, fuel'");
    }
    return false;
}

bool sweep_parse_answers(struct reader *r, struct question *q)
{
    struct sweep_parsed *s = q->parsed;
    r->at = skip_blanks(r->at + 1);
    reader_place(r, r->at);
    const char *begin = r->at;
    if (reader_ends(r))
        return problem_error(
            r->problem, "the command after ':' is missing; enter, for example, 'sweep s 0.1 0.9 9 : rmax'");
    r->stops = ",";
    bool is_good = answer_parse(r, &s->question.question);
    s->typed = s->question.question.name;
    if (is_good && *r->at == ',') {
        r->at = begin;
        is_good = list_parse(r, &s->question);
        s->typed = question_name(r, begin, r->at);
    }
    r->stops = NULL;
    return is_good;
}

bool sweep_bind(const struct question *q, const struct query *query, struct arguments *given,
                struct problem *problem)
{
    const struct sweep_parsed *parsed = q->parsed;
    /* the values of the grid's lists are stored after the sweep */
    struct sweep *s =
        arguments_take(given, sizeof *s + parsed->grid.listed * sizeof(domq_real), query, problem);
    if (!s)
        return false;
    s->question = &parsed->question;
    s->typed = parsed->typed;
    return grid_bind(&parsed->grid, q->text, query, (domq_real *)(s + 1), &s->grid, problem);
}

bool curve_bind(const struct question *q, const struct query *query, struct arguments *given,
                struct problem *problem)
{
    const domq_real from = given->number[0], to = given->number[1], n = given->number[2];
    struct curve *c = arguments_take(given, sizeof *c, query, problem);
    if (!c)
        return false;
    c->question.question = (struct question){.command = &growths_command, .key = -1, .text = q->text};
    c->sweep = (struct sweep){
        .grid = {.axis = {{.parameter = parameter_find("s"), .count = (size_t)n, .from = from, .to = to}},
                 .axes = 1,
                 .points = (size_t)n},
        .question = &c->question,
        .typed = "curve"};
    problem->place = 0;
    return n > 1 || from == to ||
           problem_error(
               problem,
               "one value of s cannot cover %g to %g; N must be at least 2, for example 'curve 0.1 0.9 5'",
               (double)from, (double)to);
}

struct sweep_shape sweep_shape(const struct arguments *given)
{
    const struct sweep *s = given->bound;
    size_t answers = 1;
    for (const struct point_question *q = s->question->next; q; q = q->next)
        answers++;
    return (struct sweep_shape){&s->grid, s->question->question.command, s->typed, answers};
}

/* ---- The answer ---- */

/* Passes the values of the grid to the answer, which chooses units for the grid's columns. */
static void values_announce(struct answer *a, const struct grid *grid)
{
    for (int i = 0; i < grid->axes; i++) {
        const struct axis *axis = &grid->axis[i];
        /* The unit of a column must suit its largest number. If the values run from FROM to TO, the largest
         * one is the first or the last, so only these two are passed. A list can have its largest value
         * anywhere, so all its values are passed. */
        size_t step = axis->list || axis->count < 3 ? 1 : axis->count - 1;
        for (size_t k = 0; k < axis->count; k += step)
            answer_announce(a, axis->parameter->name, axis_value(axis, k));
    }
}

/* Copies the problem of the failed point to *problem or, after ^C, reports the interrupt there. Returns
 * false. */
static bool point_failed(const struct sweeper *w, struct problem *problem)
{
    if (dom_raised(w->query->scene->compute.interrupt))
        return problem_status(problem, w->query->scene, DOM_INTERRUPTED);
    *problem = w->problem;
    return false;
}

static bool rows_write(struct sweeper *w, struct answer *a, struct problem *problem)
{
    bool by_point = true;
    if ((a->style.errors || a->style.format->for_people) && !point_probe(w))
        return point_failed(w, problem);
    a->columns = w->columns.column;
    a->csv.has_reasons = true;
    /* The columns must be laid out in the same way in every part of a sweep. The first row that is written
     * cannot decide their layout, because it depends on the workers and on --shard. */
    a->layout.sample = w->answered ? w->sample : NULL;
    values_announce(a, w->grid);
    answer_plan(a, w->sample);
    w->answer = *a;
    w->answer.kept = NULL;
    const struct workers workers = {.points = w->grid->points,
                                    .point = point_write,
                                    .context = w,
                                    .size = sizeof *w,
                                    .merge = sweeper_merge};
    return points_answer(w->query, problem, a, workers, &by_point) || (by_point && point_failed(w, problem));
}

/* Prints the number of points at which a value is missing, and the reason at the first of these points. */
static void tally_say(struct sweeper *w, struct answer *a)
{
    const struct tally *t = &w->tally;
    char where[256] = "", number[CELL_TEXT];
    point_values(w, t->first);
    for (int i = 0; i < w->grid->axes; i++)
        text_add(where, sizeof where, "%s%s = %s", i ? ", " : "", w->grid->axis[i].parameter->name,
                 cell_text(w->value[i], 6, false, number));
    answer_say(a, "%zu of %zu points %s %s. The first is %s: %s.%s", t->with_reason,
               shard_range(&w->query->run_context->shard, w->grid->points).count,
               t->with_reason == 1 ? "has" : "have",
               t->without_answer == t->with_reason ? "no answer" : "a missing value", where, t->reason,
               t->with_reason == 1 ? "" : " csv and json give the reason for each of them.");
}

bool run_sweep(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct sweep *s = query->given->bound;
    struct sweeper *w = calloc(1, sizeof *w);
    if (!w)
        return query_status(query, problem, DOM_NO_MEMORY);
    w->grid = &s->grid;
    w->question = s->question;
    w->query = query;
    w->command = problem->command;
    w->run_context = *query->run_context;
    w->run_context.shard.parts = 0;
    w->answer = *a;
    for (int i = 0; i < s->grid.axes; i++) {
        const struct parameter *p = s->grid.axis[i].parameter;
        w->styled = w->styled || p->of_precision || p->moves;
    }
    bool done = sweeper_columns(w, problem) && rows_write(w, a, problem);
    if (done && w->tally.with_reason > 0) {
        tally_say(w, a);
        snprintf(a->made, sizeof a->made, "%zu of %zu points have a missing value", w->tally.with_reason,
                 shard_range(&query->run_context->shard, w->grid->points).count);
    }
    a->layout.sample = NULL;
    free(w);
    return done;
}
