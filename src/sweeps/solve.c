/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'solve', which finds where an answer has a given value, or where a verdict changes. The parser
 * for the arguments of 'watch' is also here. */
#include "language/quad.h"
#include "session/parameters.h"
#include "sweeps/sweeps.h"
#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

/* ---- The question ---- */

const char *solve_names(const void *context, int k)
{
    (void)context;
    const struct parameter *p = session_parameters;
    while (p->name && (p->from == p->to || k-- > 0))
        p++;
    return p->name;
}

/* Returns examples of the command, for error messages. */
static const char *form_of(const struct problem *problem)
{
    static const struct {
        const char *command, *form;
    } forms[] = {
        {"watch", "'watch s : rmax', or with a range 'watch s 0.1 0.9 : rmax'"},
        {"maximize", "'maximize s : duration.speed', or with a range 'maximize s 0.1 0.9 : duration.speed'"},
        {"minimize",
         "'minimize s : duration.seconds', or with ranges 'minimize s 0.1 0.9, r 1 2 : count 20 m'"},
    };
    for (size_t k = 0; k < sizeof forms / sizeof *forms; k++)
        if (problem->command && strcmp(problem->command, forms[k].command) == 0)
            return forms[k].form;
    return "'solve d : rmax = 5/3', or with a range 'solve d 0.05 0.3 : rmax = 5/3'";
}

/* The parsed arguments of 'solve' and 'watch'. An item that was not typed is zero. */
struct solve_parsed {
    struct ranged_parsed range;
    struct item value;
    struct question question;
    bool verdict;
};

static bool bound_parse(struct reader *r, const struct parameter *p, const char *name, struct item *item)
{
    bool is_missing = reader_ends(r);
    reader_place(r, r->at);
    if (is_missing)
        return problem_error(r->problem, "%s is missing; enter, for example, %s", name, form_of(r->problem));
    return item_parse_value(r, p, 0, p->value->name, item) &&
           (item->value || isfinite(item->number) ||
            problem_error(r->problem, "%s must be a number; enter, for example, %s", name,
                          form_of(r->problem)));
}

/* Skips a word that may be left out, and that completion does not offer. */
static void word_skip(struct reader *r, const char *word)
{
    if (word_is_next(r, word))
        r->at = skip_blanks(r->at + strlen(word));
}

bool ranged_parse(struct reader *r, names_list *names, struct ranged_parsed *p)
{
    char message[NAMES_MESSAGE] = "", name[32];
    offer_names(r, names, NULL);
    size_t length = strcspn(r->at, " \t:,;>");
    snprintf(name, sizeof name, "%.*s", (int)length, r->at);
    if (length == 0)
        return problem_error(r->problem, "the name of a parameter is missing; enter, for example, %s",
                             form_of(r->problem));
    int k = parameter_search(names, "parameter", name, message);
    if (k < 0)
        return problem_error(r->problem, k == NAMES_CLOSE ? "%s" : "%s; enter, for example, %s", message,
                             form_of(r->problem));
    p->parameter = parameter_find(names(NULL, k));
    r->at = skip_blanks(r->at + length);
    r->stops = ":,";
    bool is_good = *r->at == ':' || *r->at == ',' || command_ends(r->at);
    if (!is_good) {
        word_skip(r, "from");
        is_good = bound_parse(r, p->parameter, "FROM", &p->from);
        if (is_good) {
            r->at = skip_blanks(r->at);
            word_skip(r, "to");
            is_good = bound_parse(r, p->parameter, "TO", &p->to);
        }
    }
    r->stops = NULL;
    r->at = skip_blanks(r->at);
    if (is_good)
        reader_place(r, r->at);
    return is_good;
}

bool ranges_end(const struct reader *r)
{
    return *r->at == ':' || problem_error(r->problem, "':' and an answer are missing; enter, for example, %s",
                                          form_of(r->problem));
}

bool ranged_bind(const struct ranged_parsed *parsed, const struct text *text, const struct query *query,
                 struct ranged *range, struct problem *problem)
{
    const struct parameter *p = parsed->parameter;
    *range = (struct ranged){p, (domq_real)p->from, (domq_real)p->to};
    if (parsed->from.at && (!item_bind(&parsed->from, text, query, NULL, &range->from, problem) ||
                            !item_bind(&parsed->to, text, query, NULL, &range->to, problem)))
        return false;
    if (p->from == p->to && !parsed->from.at)
        return problem_error(problem, "%s needs a range, as in '%s 5 50 : ...'", p->name, p->name);
    return range->from < range->to ||
           problem_error(problem, "the range from %s to %s is empty: FROM must be less than TO",
                         quad_text(range->from, 10), quad_text(range->to, 10));
}

/* Parses "NAME" or "NAME FROM TO", up to the ':'. */
bool solve_parse_parameter(struct reader *r, struct question *q)
{
    struct solve_parsed *s = q->parsed = reader_memory(r, sizeof *s);
    return s && ranged_parse(r, solve_names, &s->range) && ranges_end(r);
}

bool colon_pass(struct reader *r)
{
    r->at = skip_blanks(r->at + 1);
    reader_place(r, r->at);
    return !reader_ends(r) ||
           problem_error(r->problem, "the answer is missing after ':'; enter, for example, %s",
                         form_of(r->problem));
}

/* Parses ": ANSWER = VALUE", or ": COMMAND" for a command that has a verdict. */
bool solve_parse_answer(struct reader *r, struct question *q)
{
    static const struct argument value_argument = {.name = "VALUE", .kind = ARGUMENT_ANY};
    struct solve_parsed *s = q->parsed;
    if (!colon_pass(r))
        return false;
    r->stops = "=";
    bool is_good = question_parse_any(r, &s->question, false);
    r->stops = NULL;
    if (!is_good)
        return false;
    s->verdict = *r->at != '=';
    if (s->verdict)
        return s->question.command->holds ||
               problem_error(r->problem,
                             "'= VALUE' is missing after '%s'; only commands that answer yes or no, such as "
                             "'verdict', can do without it; enter, for example, %s",
                             s->question.name, form_of(r->problem));
    if (!question_needs_number(&s->question, r->problem))
        return false;
    r->at = skip_blanks(r->at + 1);
    reader_place(r, r->at);
    r->last = true;
    return item_parse(r, &value_argument, &s->value);
}

/* Parses ": ANSWER". */
bool watch_parse_answer(struct reader *r, struct question *q)
{
    struct solve_parsed *s = q->parsed;
    return colon_pass(r) && question_parse_any(r, &s->question, true);
}

bool solve_bind(const struct question *q, const struct query *query, struct arguments *given,
                struct problem *problem)
{
    const struct solve_parsed *parsed = q->parsed;
    struct solve *s = arguments_take(given, sizeof *s, query, problem);
    domq_real number;
    struct ranged range;
    if (!s || !ranged_bind(&parsed->range, q->text, query, &range, problem))
        return false;
    *s = (struct solve){.parameter = range.parameter,
                        .from = range.from,
                        .to = range.to,
                        .question = &parsed->question,
                        .verdict = parsed->verdict};
    return !parsed->value.at || item_bind(&parsed->value, q->text, query, &s->value, &number, problem);
}

/* ---- The answer ---- */

const struct column solve_columns[] = {
    {"value", "", "the value of the parameter", 0},
    {"answer", "", "the answer at this value of the parameter; for a verdict, 1 means true", 0},
    {"branch", "",
     "whether the answer rises or falls with the parameter; for a verdict, on which side it is true", 15},
    {NULL, NULL, NULL, 0},
};

static void no_root_text(const struct scan *s, char *text, size_t size)
{
    const struct solve *v = s->solve;
    const char *name = v->parameter->name, *unit = v->parameter->value->unit, *question = v->question->name;
    const char *value = quad_text(v->value.value, 10);
    const bool below = s->most.f < 0; /* the answer is below the wanted value in the whole range */
    const struct scan_point *nearest = below ? &s->most : &s->least;
    char range[192];
    unit = strcmp(unit, "h") == 0 ? "" : unit;
    snprintf(range, sizeof range, "%s = %s .. %s%s%s", name, quad_text(v->from, 10), quad_text(v->to, 10),
             *unit ? " " : "", unit);
    if (s->answers == 0)
        snprintf(text, size, "%s has no answer for any %s: %s", question, range, s->no_answer);
    else if (v->verdict && s->most.f > 0)
        snprintf(text, size, "%s: %s for every %s", question, v->question->command->holds, range);
    else if (v->verdict)
        snprintf(text, size, "%s: no %s from %s to %s%s%s makes it true that %s", question, name,
                 quad_text(v->from, 10), quad_text(v->to, 10), *unit ? " " : "", unit,
                 v->question->command->holds);
    else if (below || s->least.f > 0)
        snprintf(text, size, "%s is never %s for %s: the %s value is %s, at %s = %s", question, value, range,
                 below ? "largest" : "smallest", quad_text(nearest->f + v->value.value, 10), name,
                 quad_text(nearest->x, 10));
    else
        snprintf(text, size, "%s is never %s for %s: it jumps over this value at %s = %s", question, value,
                 range, name, quad_text(s->jump, 10));
}

/* Checks that the answer has the unit of the value, and is not constant. */
static bool scan_check(const struct scan *s, struct problem *problem)
{
    const struct solve *v = s->solve;
    const struct quantity unit = s->probe.unit;
    const domq_real highest = s->most.f + v->value.value, size = quad(fabs)(highest),
                    tol = s->probe.query->scene->compute.tol;
    if (v->verdict || s->answers == 0)
        return true;
    if (!quantity_is_number(v->value) && !quantity_alike(unit, v->value))
        return problem_error(problem, "%s is %s, but VALUE is %s", v->question->name, expression_kind(unit),
                             expression_kind(v->value));
    if (s->answers < 2 || s->most.f - s->least.f > (domq_real)1e-12 * size + 10 * tol * size)
        return true;
    return problem_no_answer(
        problem,
        "%s does not depend on %s: it is %s everywhere in %s .. %s; 'sensitivity' shows what it depends on",
        v->question->name, v->parameter->name, quad_text(highest, 10), quad_text(v->from, 10),
        quad_text(v->to, 10));
}

static void scan_answer(const struct scan *s, struct answer *a)
{
    char reason[1024];
    answer_columns(a, solve_columns)[0].unit = s->solve->parameter->value->unit;
    for (int i = 0; i < s->roots; i++)
        answer_announce(a, "value", s->root[i].x);
    for (int i = 0; i < s->roots && !answer_lost(a); i++)
        answer_cells(a, cell_computed(s->root[i].x), cell_computed(s->root[i].answer),
                     cell_word(s->root[i].branch));
    if (s->roots > 0)
        return;
    no_root_text(s, reason, sizeof reason);
    if (answer_for_people(a))
        answer_say(a, "%s.", reason);
    else
        answer_row(a, ROW(cell_real(DOMQ_NAN), cell_real(DOMQ_NAN), cell_word("none")), reason);
}

bool run_solve(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct solve *solve = query->given->bound;
    struct scan *s = calloc(1, sizeof *s);
    if (!s)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    s->solve = solve;
    s->probe = (struct probe){.query = query,
                              .command = problem->command,
                              .question = solve->question,
                              .parameter = solve->parameter,
                              .verdict = solve->verdict};
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    bool done = scan_run(s) ? scan_check(s, problem) : probe_report(&s->probe, problem);
    gsl_set_error_handler(handler);
    if (done)
        scan_answer(s, a);
    free(s);
    return done;
}
