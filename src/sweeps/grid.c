/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The arguments of the commands of this feature: a grid, or ranges, of parameters, and the answers at its
 * points. */
#include "language/quad.h"
#include "session/parameters.h"
#include "sweeps/sweeps.h"
#include <string.h>

/* The parsed arguments. An item that was not typed is zero. */
struct parsed {
    enum form { FORM_GRID, FORM_RANGES, FORM_NAMES } form;
    struct axis_parsed {
        const struct parameter *parameter;
        struct value_parsed {
            struct item item;
            struct value_parsed *next;
        } first;      /* the value FROM, or a linked list of all values if the axis is a list */
        size_t count; /* the number of values in a list, or 0 if there is no list */
        struct item to, steps;
        const char *log_at; /* points to the word 'log' in the command, or is NULL */
    } axis[ASSIGNED_MAX];
    int axes;
    size_t listed; /* the number of values in all lists */
    struct question answer[ANSWER_COLUMNS];
    size_t answers;
    const char *typed; /* the answers as they were typed */
    bool verdict;
    struct item value;
};

/* Reports what is wrong with the arguments, with an example. */
static bool form_wrong(struct reader *r, const struct parsed *s, const char *what)
{
    const struct command *c = command_find(r->problem->command);
    return problem_error(r->problem, "%s; enter, for example, '%s'", what,
                         s->form == FORM_GRID ? "sweep s 0.1 0.9 9 : rmax"
                         : c && c->example    ? c->example
                                              : "watch s 0.1 0.9 : rmax");
}

/* ---- Parsing a grid ---- */

const char *varied_names(const void *context, int k)
{
    (void)context;
    const struct parameter *p = session_parameters;
    while (p->name && (p->setting || p->words_only || p->of_precision ||
                       (p->from == p->to && !p->value->whole) || k-- > 0))
        p++;
    return p->name;
}

/* Parses one value, which messages call `name`. The word before it may be left out. */
static bool value_parse(struct reader *r, const struct parsed *s, const struct parameter *p, const char *word,
                        const char *name, struct item *item)
{
    char what[96];
    r->at = skip_blanks(r->at);
    if (*word && word_is_next(r, word))
        r->at = skip_blanks(r->at + strlen(word));
    bool ends = reader_ends(r);
    reader_place(r, r->at);
    snprintf(what, sizeof what, "%s: %s is missing", p->name, name);
    if (ends)
        return form_wrong(r, s, what);
    if (s->form == FORM_GRID)
        return item_parse_listed(r, p, item);
    struct argument *a = reader_memory(r, sizeof *a); /* an end of a range is no word, such as "off" */
    if (!a)
        return false;
    *a = (struct argument){.name = p->value->name, .kind = ARGUMENT_VALUE_OF, .parameter = p->name};
    return item_parse_expression(r, a, item);
}

/* Parses the remaining values of a list, after the first one. */
static bool list_parse(struct reader *r, struct parsed *s, struct axis_parsed *axis)
{
    struct value_parsed **last = &axis->first.next;
    for (axis->count = 1; *r->at == ','; axis->count++) {
        struct value_parsed *value = *last = reader_memory(r, sizeof *value);
        r->at++;
        if (!value || !value_parse(r, s, axis->parameter, "", "a value after ','", &value->item))
            return false;
        last = &value->next;
        r->at = skip_blanks(r->at);
    }
    s->listed += axis->count;
    return true;
}

/* Parses "FROM TO" and, in a grid, also "FROM TO N", "FROM TO N log" or a list. */
static bool values_parse(struct reader *r, struct parsed *s, struct axis_parsed *axis)
{
    static const struct argument count = {.name = "N", .kind = ARGUMENT_COUNT};
    const struct parameter *p = axis->parameter;
    const bool is_grid = s->form == FORM_GRID;
    if (!value_parse(r, s, p, "from", p->words_only ? "a value" : "FROM", &axis->first.item))
        return false;
    r->at = skip_blanks(r->at);
    if (is_grid && *r->at == ',')
        return list_parse(r, s, axis);
    if (!p->words_only && !value_parse(r, s, p, "to", "TO", &axis->to))
        return false;
    const struct item *from = &axis->first.item, *to = &axis->to;
    if (is_grid && p->words_only)
        return problem_error(r->problem,
                             "the values of %s are words; list them, as in 'sweep %s %s, %s : rmax'", p->name,
                             p->name, p->words[0].name, p->words[1].name);
    if ((!from->value && !isfinite(from->number)) || (!to->value && !isfinite(to->number)))
        return form_wrong(r, s, "FROM and TO must be numbers");
    if (!is_grid)
        return true;
    bool ends = reader_ends(r);
    reader_place(r, r->at);
    if (ends)
        return problem_error(r->problem,
                             "%s: N, the number of values, is missing; enter %s FROM TO N, or %s VALUE, "
                             "VALUE, ...",
                             p->name, p->name, p->name);
    if (!item_parse(r, &count, &axis->steps))
        return false;
    const char *behind = skip_blanks(r->at);
    r->at = behind;
    axis->log_at = reader_takes(r, "log") ? behind : NULL;
    return true;
}

static bool axis_parse(struct reader *r, struct parsed *s, int most)
{
    bool ends = reader_ends(r) && *r->at != ',';
    reader_place(r, r->at);
    if (ends)
        return form_wrong(r, s, "the name of a parameter is missing");
    const struct parameter *p =
        parameter_parse(r, "for each parameter, enter NAME FROM TO N or NAME VALUE, VALUE, ...");
    if (!p)
        return false;
    if (s->form != FORM_GRID && names_exact(varied_names, NULL, p->name) < 0)
        return problem_error(r->problem, "the values of '%s' are words, or belong to the precision", p->name);
    for (int i = 0; i < s->axes; i++)
        if (s->axis[i].parameter == p)
            return problem_error(r->problem, "'%s' is named twice; name each parameter once", p->name);
    if (s->axes == most)
        return problem_error(r->problem,
                             "at most %d parameter%s can be varied; 'set' gives the others a value", most,
                             most == 1 ? "" : "s");
    struct axis_parsed *axis = &s->axis[s->axes++];
    axis->parameter = p;
    r->at = skip_blanks(r->at);
    return s->form == FORM_NAMES || (s->form == FORM_RANGES && reader_ends(r)) || values_parse(r, s, axis);
}

/* Parses up to `most` parameters, up to the ':' or, if only names are expected, up to a name without a comma
 * behind it. */
static bool axes_parse(struct reader *r, struct question *q, enum form form, int most)
{
    struct parsed *s = q->parsed = reader_memory(r, sizeof *s);
    const char *no_unit = r->no_unit;
    bool more = s != NULL, is_good = more;
    r->stops = form == FORM_NAMES ? "," : ":,";
    if (form == FORM_GRID)
        r->no_unit = "sg"; /* after N, 's' and 'g' are parameters, not seconds and grams */
    for (; more && is_good; more = is_good && more) {
        s->form = form;
        is_good = axis_parse(r, s, most);
        r->at = skip_blanks(r->at);
        more = *r->at == ',' || (form == FORM_GRID && !reader_ends(r));
        if (more && form != FORM_GRID)
            r->at = skip_blanks(r->at + 1);
    }
    r->stops = NULL;
    r->no_unit = no_unit;
    if (is_good)
        reader_place(r, r->at);
    return is_good &&
           (form == FORM_NAMES || *r->at == ':' || form_wrong(r, s, "':' and an answer are missing"));
}

bool sweep_parse_grid(struct reader *r, struct question *q)
{
    return axes_parse(r, q, FORM_GRID, ASSIGNED_MAX);
}

bool range_parse_one(struct reader *r, struct question *q)
{
    return axes_parse(r, q, FORM_RANGES, 1);
}

bool range_parse_two(struct reader *r, struct question *q)
{
    return axes_parse(r, q, FORM_RANGES, 2);
}

bool range_parse_names(struct reader *r, struct question *q, int most)
{
    return axes_parse(r, q, FORM_NAMES, most);
}

/* ---- Parsing the answers ---- */

/* Passes the ':' or ',' before an answer. */
static bool answer_begins(struct reader *r, const struct parsed *s)
{
    char what[] = "the answer is missing after ':'";
    what[sizeof what - 3] = *r->at;
    r->at = skip_blanks(r->at + 1);
    reader_place(r, r->at);
    return !reader_ends(r) || form_wrong(r, s, what);
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

bool sweep_parse_answers(struct reader *r, struct question *q)
{
    struct parsed *s = q->parsed;
    if (!answer_begins(r, s))
        return false;
    const char *begin = r->at;
    r->stops = ",";
    bool is_good = answer_parse(r, &s->answer[0]);
    s->answers = 1;
    /* In a list, each answer is one number. */
    if (is_good && *r->at == ',') {
        r->at = begin;
        is_good = question_parse_any(r, &s->answer[0], true, question_names);
    }
    while (is_good && *r->at == ',')
        is_good = answer_begins(r, s) &&
                  (s->answers < ANSWER_COLUMNS ||
                   problem_error(r->problem, "there are more than %d answers", ANSWER_COLUMNS)) &&
                  question_parse_any(r, &s->answer[s->answers++], true, question_names);
    s->typed = s->answers > 1 ? question_name(r, begin, r->at) : s->answer[0].name;
    r->stops = NULL;
    return is_good;
}

bool answer_parse_number(struct reader *r, struct question *q)
{
    struct parsed *s = q->parsed;
    return answer_begins(r, s) && question_parse_any(r, &s->answer[s->answers++], true, question_names);
}

bool answer_parse_value(struct reader *r, struct question *q)
{
    static const struct argument value_argument = {.name = "VALUE", .kind = ARGUMENT_ANY};
    struct parsed *s = q->parsed;
    const struct question *answer = s->answer;
    if (!answer_begins(r, s))
        return false;
    r->stops = "=";
    bool is_good = question_parse_any(r, &s->answer[s->answers++], false, question_names);
    r->stops = NULL;
    if (!is_good)
        return false;
    s->verdict = *r->at != '=';
    if (s->verdict)
        return answer->command->holds ||
               problem_error(r->problem,
                             "'= VALUE' is missing after '%s'; only commands that answer yes or no, such as "
                             "'verdict', can do without it; enter, for example, 'solve d : rmax = 5/3'",
                             answer->name);
    if (!question_needs_number(answer, r->problem))
        return false;
    r->at = skip_blanks(r->at + 1);
    reader_place(r, r->at);
    return item_parse(r, &value_argument, &s->value);
}

/* ---- Binding ---- */

static bool axis_bind(const struct axis_parsed *parsed, const struct text *text, const struct query *query,
                      domq_real *list, struct axis *axis, struct problem *problem)
{
    domq_real n = 0;
    const struct parameter *p = parsed->parameter;
    const struct value_parsed *value = &parsed->first;
    *axis = (struct axis){.parameter = p,
                          .count = parsed->count,
                          .from = (domq_real)p->from,
                          .to = (domq_real)p->to,
                          .logarithmic = parsed->log_at != NULL,
                          .list = parsed->count > 0 ? list : NULL};
    for (size_t k = 0; k < parsed->count; k++, value = value->next)
        if (!item_bind(&value->item, text, query, NULL, &list[k], problem))
            return false;
    if (parsed->count > 0)
        return true;
    if (!value->item.at && p->from == p->to)
        return problem_error(problem, "%s needs a range, as in '%s 5 50 : ...'", p->name, p->name);
    if (value->item.at && (!item_bind(&value->item, text, query, NULL, &axis->from, problem) ||
                           !item_bind(&parsed->to, text, query, NULL, &axis->to, problem)))
        return false;
    if (!parsed->steps.at)
        return axis->from < axis->to ||
               problem_error(problem, "the range from %s to %s is empty: FROM must be less than TO",
                             quad_text(axis->from, 10), quad_text(axis->to, 10));
    if (!item_bind(&parsed->steps, text, query, NULL, &n, problem))
        return false;
    axis->count = (size_t)n;
    if (n == 1 && axis->from != axis->to)
        return problem_error(problem, "%s: one value cannot cover %s to %s; enter an N of at least 2",
                             p->name, quad_text(axis->from, 10), quad_text(axis->to, 10));
    if (axis->logarithmic) {
        problem->place = text_column(text, parsed->log_at);
        return (axis->from > 0 && axis->to > 0) ||
               problem_error(problem, "%s: with 'log', FROM and TO must be above 0", p->name);
    }
    domq_real step = n > 1 ? (axis->to - axis->from) / (n - 1) : 0;
    return !p->value->whole || quad(fabs)(step - quad(round)(step)) < (domq_real)1e-9 ||
           problem_error(problem,
                         "%s takes whole numbers, but %zu values from %s to %s are not all whole; "
                         "enter another N",
                         p->name, axis->count, quad_text(axis->from, 10), quad_text(axis->to, 10));
}

bool sweep_bind(const struct question *q, const struct query *query, struct arguments *given,
                struct problem *problem)
{
    const size_t most = 1000000000000;
    const struct parsed *parsed = q->parsed;
    /* the values of the grid's lists are stored after the sweep */
    struct sweep *s = arguments_take(given, sizeof *s + parsed->listed * sizeof(domq_real), query, problem);
    domq_real *listed = (domq_real *)(s + 1), number;
    if (!s)
        return false;
    *s = (struct sweep){.grid.points = 1,
                        .answer = parsed->answer,
                        .answers = parsed->answers,
                        .typed = parsed->typed,
                        .verdict = parsed->verdict};
    for (int i = 0; i < parsed->axes; i++) {
        struct axis *axis = &s->grid.axis[s->grid.axes++];
        if (!axis_bind(&parsed->axis[i], q->text, query, listed, axis, problem))
            return false;
        listed += parsed->axis[i].count;
        if (axis->count > most / s->grid.points)
            return problem_error(problem, "the grid has more than %zu points; enter a smaller N", most);
        s->grid.points *= axis->count > 0 ? axis->count : 1;
    }
    return !parsed->value.at || item_bind(&parsed->value, q->text, query, &s->value, &number, problem);
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
