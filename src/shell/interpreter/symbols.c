/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Names in expressions: what each name stands for, and its value. */
#include "interpreter/question.h"
#include "language/quad.h"
#include "language/text.h"
#include "session/parameters.h"
#include <stdio.h>
#include <string.h>

/* ---- Values ---- */

/* Finds the value of the node t, which is the number in a cell. If the cell is empty or contains a word,
 * reports an error. `reason` is the reason why the cell is empty, or "". */
static bool cell_quantity(struct evaluation *e, const struct tree *t, struct cell cell, const char *reason,
                          struct quantity *result)
{
    const struct command *c = t->refers;
    const char *key = c->columns[t->index].key;
    if (cell.kind == CELL_WORD)
        return expression_wrong(e->problem, t->at, "%s.%s is the word '%s', not a number", t->name, key,
                                cell.word);
    *result = t->value;
    result->value *= cell.number;
    return cell.kind != CELL_NONE ||
           expression_no_value(e->problem, t->at,
                               *reason ? "%s.%s has no value here: %s"
                                       : "%s.%s has no value here; enter '%s' to see why",
                               t->name, key, *reason ? reason : c->name);
}

bool command_run(struct evaluation *e, const struct tree *t, const struct quantity *argument,
                 struct answer *answer)
{
    const struct command *c = t->refers;
    static const struct question no_question;
    const struct sink sink = answer->sink;
    struct arguments given = {.count = t->count, .question = &no_question};
    struct query query = *e->query;
    if (!command_allowed(query.run_context, c, e->problem))
        return false;
    for (int i = 0; i < t->count; i++)
        if (!argument_check(&query, &c->argument[i], argument[i], &given.number[i], e->problem))
            return false;
    query.given = &given;
    query.next = NULL;
    *answer = answer_kept(&query, c, answer->kept);
    answer->sink = sink;
    return command_compute(c, &query, answer, e->problem);
}

/* Stores one number of the answer of a command. Its large variables are not on the stack while arguments are
 * evaluated, which may have commands of their own. */
static __attribute__((noinline)) bool command_quantity(struct evaluation *e, const struct tree *t,
                                                       const struct quantity *argument,
                                                       struct quantity *result)
{
    struct cell cells[ANSWER_CELLS];
    struct answer answer = {.kept = cells};
    return command_run(e, t, argument, &answer) &&
           cell_quantity(e, t, cells[t->index], answer.late_reason, result);
}

/* The value of a command such as rmax(0.3). */
static bool command_value(struct evaluation *e, const struct tree *t, struct quantity *result)
{
    struct quantity argument[EXPRESSION_ARGUMENTS];
    return arguments_evaluate(e, t, argument) && command_quantity(e, t, argument, result);
}

static bool parameter_value(struct evaluation *e, const struct tree *t, struct quantity *result)
{
    *result = t->value;
    result->value *= parameter_get(e->query->state, t->refers);
    return true;
}

static bool ans_value(struct evaluation *e, const struct tree *t, struct quantity *result)
{
    const struct last_answer *ans = e->query->ans;
    *result = ans->value;
    return !t->refers || cell_quantity(e, t, ans->cells[t->index], "", result);
}

static bool argument_value(struct evaluation *e, const struct tree *t, struct quantity *result)
{
    *result = e->argument[t->index];
    return true;
}

/* Adds the name of a 'let' function to the message of an error that has occurred in its body. `at` is the
 * place where the function is called. Returns false. */
static bool routine_wrong(struct problem *problem, const char *at, const struct variable *function)
{
    char inside[PROBLEM_TEXT];
    if (!problem->at)
        return false;
    memcpy(inside, problem->text, sizeof inside);
    if (!problem->of_function)
        snprintf(problem->text, sizeof problem->text, "in '%s': %.180s", variable_head(function), inside);
    problem->of_function = true;
    problem->at = at;
    return false;
}

/* Evaluates a 'let' function. The body of the function sees only the arguments of this function. If another
 * function has called it, the body does not see the arguments of the caller. */
static bool routine_value(struct evaluation *e, const struct tree *t, struct quantity *result)
{
    struct quantity argument[EXPRESSION_ARGUMENTS];
    const struct quantity *outer = e->argument;
    if (!arguments_evaluate(e, t, argument))
        return false;
    if (dom_raised(e->query->scene->compute.interrupt))
        return problem_status(e->problem, e->query->scene, DOM_INTERRUPTED);
    e->argument = argument;
    bool good = expression_evaluate(e, t->body, result);
    e->argument = outer;
    return good || routine_wrong(e->problem, t->at, t->refers);
}

struct evaluation query_evaluation(const struct query *query, struct problem *problem)
{
    return (struct evaluation){
        .problem = problem,
        .query = query,
        .angle = query->state->settings.style.angle == ANGLE_DEG ? QUAD_PI / 180 : 1,
    };
}

/* ---- Resolving names ---- */

/* Reports an error in a tree. The value of the macro is false. */
#define fail(r, t, ...) expression_wrong((r)->problem, (t)->at, __VA_ARGS__)

static bool stands_for(struct tree *t, evaluator *compute, const void *refers, int index)
{
    t->compute = compute;
    t->refers = refers;
    t->index = index;
    return true;
}

static bool stands_for_number(struct tree *t, struct quantity value)
{
    t->value = value;
    return stands_for(t, number_value, NULL, 0);
}

/* Parses the body of a 'let' function for one of its calls. */
static bool routine_resolve(struct reader *r, struct tree *t, const struct variable *f)
{
    const struct scope scope = {.function = f, .outer = r->scope};
    struct reader body = *r;
    if (t->count != f->count)
        return fail(r, t, "'%s' takes %d value%s", variable_head(f), f->count, f->count == 1 ? "" : "s");
    for (const struct scope *outer = r->scope; outer; outer = outer->outer)
        if (outer->function == f)
            return fail(r, t, "'%s' uses itself", variable_head(f));
    body.at = f->body;
    body.scope = &scope;
    body.no_unit = NULL;
    t->body = expression_parse(&body);
    r->nodes = body.nodes;
    return t->body ? stands_for(t, routine_value, f, 0) : routine_wrong(r->problem, t->at, f);
}

/* Finds the column that a name such as "ans.margin" or "rmax.r" stands for. A name without a key, such as
 * "rmax", stands for the principal column. */
static bool column_resolve(struct reader *r, struct tree *t, evaluator *compute, const struct command *c)
{
    char message[NAMES_MESSAGE], what[64];
    snprintf(what, sizeof what, "key of %s", c->name);
    const bool is_ans = compute == ans_value;
    if (!is_ans && t->key && c->sweep.slow_column && strcmp(t->key, c->sweep.slow_column) == 0)
        return fail(r, t,
                    "%s.%s is not available in expressions, because it takes a long time to compute; enter "
                    "'%s', and then 'ans.%s'",
                    c->name, t->key, c->name, t->key);
    names_list *const list = is_ans ? answer_keys : command_keys;
    const int index = t->key ? names_find(list, c, what, t->key, message) : command_principal(c);
    if (index == NAMES_UNKNOWN)
        return fail(r, t, "%s; its keys are %s", message, names_join(list, c, "", (char[NAMES_ALL]){""}));
    if (index < 0)
        return fail(r, t, "%s", message);
    t->value = expression_unit(c->columns[index].unit);
    return stands_for(t, compute, c, index);
}

bool command_resolve(struct reader *r, struct tree *t, const struct command *c, evaluator *compute)
{
    int fewest, most = command_values(c, &fewest);
    if (t->count == 0 && fewest == 1)
        return fail(r, t, "'%s' needs a value in parentheses: '%s(%s)%s%s'", c->name, c->name,
                    c->argument[0].name, t->key ? "." : "", t->key ? t->key : "");
    if (t->count < fewest || t->count > most)
        return fail(r, t, "'%s' does not take %d value%s", command_usage(c), t->count,
                    t->count == 1 ? "" : "s");
    return column_resolve(r, t, compute, c);
}

bool name_resolve(struct reader *r, struct tree *t)
{
    const bool is_bare = t->count == 0 && !t->key;
    const struct variable *f = r->scope ? r->scope->function : NULL;
    struct quantity value;
    const char *end, *name;
    for (int i = 0; is_bare && f && i < f->count; i++)
        if (strcmp(f->argument[i], t->name) == 0)
            return stands_for(t, argument_value, NULL, i);
    const struct variable *v = t->key ? NULL : variable_find(&r->query->state->variables, t->name);
    if (v && v->body)
        return routine_resolve(r, t, v);
    if (v && is_bare)
        return stands_for_number(t, v->value);
    const struct parameter *parameter = is_bare ? parameter_find(t->name) : NULL;
    if (parameter && parameter_is_number(parameter)) {
        t->value = expression_unit(parameter->value->unit);
        return stands_for(t, parameter_value, parameter, 0);
    }
    const struct last_answer *ans = r->query->ans;
    if (t->count == 0 && strcmp(t->name, "ans") == 0)
        return ans->printed && !t->key ? stands_for(t, ans_value, NULL, 0)
               : ans->command          ? column_resolve(r, t, ans_value, ans->command)
                                       : fail(r, t, "there is no earlier answer");
    if (aggregates && aggregates->resolve(r, t))
        return t->compute != NULL;
    const struct command *c = command_find(t->name);
    int fewest;
    if (c && command_arity(c, &fewest) < 0)
        return fail(r, t, "'%s' has no value in an expression; enter the command alone", c->name);
    if (c)
        return command_resolve(r, t, c, command_value);
    if (is_bare && feature_value(t->name, &name, &end, &value) && !*end)
        return stands_for_number(t, value);
    char message[NAMES_MESSAGE];
    if (name_absent(t->name, message) || parameter_by_value(t->name, message))
        return fail(r, t, "%s", message);
    if (strcmp(t->name, "off") == 0)
        return fail(r, t, "'off' has no value; 'set NAME off' turns an effect off");
    const char *close = names_closest(value_names, r->query->state, t->name);
    const struct parameter *suggested = parameter_by_synonym(t->name, !close);
    if (suggested && is_value_name(r->query->state, suggested->name))
        close = suggested->name;
    return fail(r, t,
                close && strcmp(close, t->name) != 0 ? "'%s' has no value; did you mean '%s'?"
                                                     : "'%s' has no value",
                t->name, close);
}
