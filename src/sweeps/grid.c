/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The arguments of 'sweep': a grid, and the answers at its points. */
#include "language/quad.h"
#include "sweeps/sweeps.h"
#include "train/train.h"
#include <string.h>

static const char form[] = "for each parameter, enter NAME FROM TO N or NAME VALUE, VALUE, ...";

struct sweep_parsed {
    struct axis_parsed {
        const struct parameter *parameter;
        struct value_parsed {
            struct item item;
            struct value_parsed *next;
        } * first;    /* the value FROM, or a linked list of all values if the axis is a list */
        size_t count; /* the number of values in a list, or 0 if the axis has the form FROM TO N */
        struct item to, steps;
        const char *log_at; /* points to the word 'log' in the command, or is NULL */
    } axis[ASSIGNED_MAX];
    int axes;
    size_t listed; /* the number of values in all lists */
    struct question answer[ANSWER_COLUMNS];
    size_t answers;
    const char *typed; /* the answers as they were typed */
};

/* ---- Parsing a grid ---- */

/* Parses one value. If the value is missing, the message calls it `name`. */
static bool value_parse(struct reader *r, const struct parameter *p, const char *name, struct item *item)
{
    bool ends = reader_ends(r);
    reader_place(r, r->at);
    return ends ? problem_error(r->problem, "%s: %s is missing; %s", p->name, name, form)
                : item_parse_listed(r, p, item);
}

/* Parses the remaining values of a list, after the first one. */
static bool list_parse(struct reader *r, struct axis_parsed *axis)
{
    struct value_parsed **last = &axis->first->next;
    for (axis->count = 1; *r->at == ','; axis->count++) {
        struct value_parsed *value = *last = reader_memory(r, sizeof *value);
        if (!value)
            return false;
        r->at++;
        if (!value_parse(r, axis->parameter, "a value after ','", &value->item))
            return false;
        last = &value->next;
        r->at = skip_blanks(r->at);
    }
    return true;
}

/* Parses "FROM TO N", "FROM TO N log" or a list. */
static bool axis_parse(struct reader *r, struct axis_parsed *axis)
{
    static const struct argument count = {.name = "N", .kind = ARGUMENT_COUNT};
    const struct parameter *p = axis->parameter;
    axis->first = reader_memory(r, sizeof *axis->first);
    if (!axis->first || !value_parse(r, p, p->words_only ? "a value" : "FROM", &axis->first->item))
        return false;
    r->at = skip_blanks(r->at);
    if (*r->at == ',')
        return list_parse(r, axis);
    if (!p->words_only && !value_parse(r, p, "TO", &axis->to))
        return false;
    const struct item *from = &axis->first->item, *to = &axis->to;
    if (p->words_only || (!from->value && from->number == EFFECT_OFF) ||
        (!to->value && to->number == EFFECT_OFF))
        return problem_error(r->problem,
                             "the values of %s are words; list them, as in 'sweep %s %s, %s : rmax'", p->name,
                             p->name, p->words[0].name, p->words[1].name);
    bool ends = reader_ends(r);
    reader_place(r, r->at);
    if (ends)
        return problem_error(r->problem, "%s: N, the number of values, is missing; %s", p->name, form);
    if (!item_parse(r, &count, &axis->steps))
        return false;
    const char *behind = skip_blanks(r->at);
    r->at = behind;
    axis->log_at = reader_takes(r, "log") ? behind : NULL;
    return true;
}

static bool axes_parse(struct reader *r, struct sweep_parsed *grid)
{
    while (!reader_ends(r) || *r->at == ',') {
        const struct parameter *p = parameter_parse(r, form);
        if (!p)
            return false;
        for (int i = 0; i < grid->axes; i++)
            if (grid->axis[i].parameter == p)
                return problem_error(r->problem, "'%s' is in the grid twice; name each parameter once",
                                     p->name);
        if (grid->axes == ASSIGNED_MAX)
            return problem_error(r->problem,
                                 "the grid has more than %d parameters; set the others before the sweep",
                                 ASSIGNED_MAX);
        struct axis_parsed *axis = &grid->axis[grid->axes++];
        axis->parameter = p;
        if (!axis_parse(r, axis))
            return false;
        grid->listed += axis->count;
    }
    reader_place(r, r->at);
    if (grid->axes == 0)
        return problem_error(r->problem, "the grid is missing; %s", form);
    return *r->at == ':' ||
           problem_error(r->problem, "':' and a command are missing after the grid; enter, for "
                                     "example, 'sweep s 0.1 0.9 9 : rmax'");
}

bool sweep_parse_grid(struct reader *r, struct question *q)
{
    struct sweep_parsed *s = q->parsed = reader_memory(r, sizeof *s);
    const char *no_unit = r->no_unit;
    r->no_unit = "sg"; /* after N, 's' and 'g' are parameters, not seconds and grams */
    r->stops = ":,";
    bool is_good = s && axes_parse(r, s);
    r->stops = NULL;
    r->no_unit = no_unit;
    return is_good;
}

/* ---- Parsing the answers ---- */

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
    bool is_good = answer_parse(r, &s->answer[0]);
    s->answers = 1;
    /* In a list, each answer is one number. */
    if (is_good && *r->at == ',') {
        r->at = begin;
        is_good = question_parse_any(r, &s->answer[0], true);
    }
    while (is_good && *r->at == ',') {
        r->at = skip_blanks(r->at + 1);
        reader_place(r, r->at);
        if (s->answers == ANSWER_COLUMNS)
            is_good = problem_error(r->problem, "there are more than %d answers", ANSWER_COLUMNS);
        else if (reader_ends(r))
            is_good = problem_error(
                r->problem,
                "the answer after ',' is missing; enter, for example, 'sweep r 1 2 9 : rmax, fuel'");
        else
            is_good = question_parse_any(r, &s->answer[s->answers++], true);
    }
    s->typed = s->answers > 1 ? question_name(r, begin, r->at) : s->answer[0].name;
    r->stops = NULL;
    return is_good;
}

/* ---- Binding ---- */

static bool axis_bind(const struct axis_parsed *parsed, const struct text *text, const struct query *query,
                      domq_real *list, struct axis *axis, struct problem *problem)
{
    domq_real n;
    const char *name = parsed->parameter->name;
    const struct value_parsed *value = parsed->first;
    *axis = (struct axis){.parameter = parsed->parameter,
                          .count = parsed->count,
                          .logarithmic = parsed->log_at != NULL,
                          .list = parsed->count > 0 ? list : NULL};
    for (size_t k = 0; k < parsed->count; k++, value = value->next)
        if (!item_bind(&value->item, text, query, NULL, &list[k], problem))
            return false;
    if (parsed->count > 0)
        return true;
    if (!item_bind(&parsed->first->item, text, query, NULL, &axis->from, problem) ||
        !item_bind(&parsed->to, text, query, NULL, &axis->to, problem) ||
        !item_bind(&parsed->steps, text, query, NULL, &n, problem))
        return false;
    axis->count = (size_t)n;
    if (n == 1 && axis->from != axis->to)
        return problem_error(problem, "%s: one value cannot cover %s to %s; enter an N of at least 2", name,
                             quad_text(axis->from, 10), quad_text(axis->to, 10));
    if (axis->logarithmic) {
        problem->place = text_column(text, parsed->log_at);
        return (axis->from > 0 && axis->to > 0) ||
               problem_error(problem, "%s: with 'log', FROM and TO must be above 0", name);
    }
    domq_real step = n > 1 ? (axis->to - axis->from) / (n - 1) : 0;
    return !axis->parameter->value->whole || quad(fabs)(step - quad(round)(step)) < (domq_real)1e-9 ||
           problem_error(problem,
                         "%s takes whole numbers, but %zu values from %s to %s are not all whole; "
                         "enter another N",
                         name, axis->count, quad_text(axis->from, 10), quad_text(axis->to, 10));
}

bool sweep_bind(const struct question *q, const struct query *query, struct arguments *given,
                struct problem *problem)
{
    const size_t most = 1000000000000;
    const struct sweep_parsed *parsed = q->parsed;
    /* the values of the grid's lists are stored after the sweep */
    struct sweep *s = arguments_take(given, sizeof *s + parsed->listed * sizeof(domq_real), query, problem);
    if (!s)
        return false;
    domq_real *listed = (domq_real *)(s + 1);
    *s = (struct sweep){
        .grid.points = 1, .answer = parsed->answer, .answers = parsed->answers, .typed = parsed->typed};
    for (int i = 0; i < parsed->axes; i++) {
        struct axis *axis = &s->grid.axis[s->grid.axes++];
        if (!axis_bind(&parsed->axis[i], q->text, query, listed, axis, problem))
            return false;
        listed += parsed->axis[i].count;
        if (axis->count > most / s->grid.points)
            return problem_error(problem, "the grid has more than %zu points; enter a smaller N", most);
        s->grid.points *= axis->count;
    }
    return true;
}

/* ---- The arguments of 'curve' ---- */

const struct column growths_columns[] = {
    {"s", "h", "separation: the gap divided by the height", 0},
    {"exact", "", "r_max if the fuel is computed from the energy balance", 0},
    {"paper", "", "r_max if the fuel is computed with the paper's closed form", 0},
    {"pair", "", "r_max of the two-domino model", 0},
    {"reach", "", "largest growth at which each domino reaches the next one: 1/s, or less with rounded edges",
     0},
    {NULL, NULL, NULL, 0},
};

/* Returns the cell of a limit. If the limit is open, the cell is empty. */
static struct cell limit_cell(const struct domq_limit *limit)
{
    return cell_limit(cell_uncertain(isnan(limit->open) ? limit->r_max : DOMQ_NAN, limit->uncertainty));
}

static bool run_growths(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct domq_train *train = &query->scene->train;
    struct domq_limit exact, paper, pair;
    enum dom_status status = limits_find(*train, query_compute(query), &exact, &paper);
    bool is_open = status == DOM_OPEN;
    if (status == DOM_OK || is_open)
        status = any_limit_pair(train, query_compute(query), &pair);
    is_open = is_open || status == DOM_OPEN;
    if (status != DOM_OK && status != DOM_OPEN)
        return query_status(query, problem, status);
    return answer_row(a,
                      ROW(cell_real(train->s), limit_cell(&exact), limit_cell(&paper), limit_cell(&pair),
                          cell_limit(cell_real(domq_train_reach(train)))),
                      is_open ? "a limit is open: at some growth, which 'rmax' or 'pair' names, the margin "
                                "is 0 within rounding errors"
                      : exact.ends == DOM_END_NONE || pair.ends == DOM_END_NONE
                          ? "no growth possible; 'rmax' and 'pair' explain why"
                          : NULL);
}

/* Not in a table: only 'curve' runs this command. */
static const struct command growths_command = {
    .name = "curve", .precision = PRECISION_AS_SET, .train = true, .sweep.echo = "s", ANSWER(growths)};

bool curve_bind(const struct question *q, const struct query *query, struct arguments *given,
                struct problem *problem)
{
    const domq_real from = given->number[0], to = given->number[1], n = given->number[2];
    struct {
        struct sweep sweep;
        struct question question;
    } *c = arguments_take(given, sizeof *c, query, problem);
    if (!c)
        return false;
    c->question = (struct question){.command = &growths_command, .key = -1, .text = q->text};
    c->sweep = (struct sweep){
        .grid = {.axis = {{.parameter = parameter_find("s"), .count = (size_t)n, .from = from, .to = to}},
                 .axes = 1,
                 .points = (size_t)n},
        .answer = &c->question,
        .answers = 1,
        .typed = "curve"};
    problem->place = 0;
    return n > 1 || from == to ||
           problem_error(
               problem,
               "one value of s cannot cover %g to %g; N must be at least 2, for example 'curve 0.1 0.9 5'",
               (double)from, (double)to);
}

/* ---- Values ---- */

domq_real axis_value(const struct axis *axis, size_t k)
{
    if (axis->list)
        return axis->list[k];
    domq_real f = axis->count > 1 ? (domq_real)k / (domq_real)(axis->count - 1) : 0;
    bool is_end = k == 0 || k == axis->count - 1; /* the first and the last value must be exactly as typed */
    domq_real value = axis->logarithmic && !is_end
                          ? quad(exp)((1 - f) * quad(log)(axis->from) + f * quad(log)(axis->to))
                          : (1 - f) * axis->from + f * axis->to;
    return axis->parameter->value->whole ? quad(round)(value) : value;
}

struct cell axis_cell(const struct axis *axis, domq_real value)
{
    const char *word = parameter_is_number(axis->parameter) ? NULL : parameter_word(axis->parameter, value);
    if (word)
        return cell_word(word);
    return axis->parameter->value->whole ? cell_count(value) : cell_real(value);
}
