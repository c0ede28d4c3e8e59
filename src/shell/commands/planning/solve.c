/* SPDX-License-Identifier: GPL-3.0-or-later */
/* solve: the values of a parameter at which an answer takes a value, or at which a verdict changes. */
#include "commands/planning/planning.h"
#include "commands/planning/scan.h"
#include "language/quad.h"
#include "session/parameters.h"
#include <gsl/gsl_errno.h>
#include <stdlib.h>
#include <string.h>

/* ---- What is asked ---- */

/* Where a parameter is looked for if no range is given: what builders have; its whole range is too wide. */
static const struct usual_range {
    const char *name;
    double from, to;
} usual_ranges[] = {{"s", 0.02, 1},       {"r", 1, 4},
                    {"d", 0.01, 1},       {"q", 1, 6},
                    {"h", 0.005, 10},     {"g", 0.1, 30},
                    {"mass", 1e-3, 10},   {"density", 50, 10000},
                    {"friction", 0, 2},   {"slope", -0.14, 0.14},
                    {"push", 0, 30},      {"placement", 0, 0.1},
                    {"floor", 0, 3},      {"edges", 0, 0.05},
                    {"feet", 0.05, 2},    {"bounce", 0, 1},
                    {"walls", 1e-4, 0.07}};

const char *solve_names(const void *context, int k)
{
    (void)context;
    return k < (int)(sizeof usual_ranges / sizeof *usual_ranges) ? usual_ranges[k].name : NULL;
}

static const char form[] = "'solve d : rmax = 5/3', or with a range 'solve d 0.05 0.3 : rmax = 5/3'";

/* Returns the form of the command that reads a range. */
static const char *form_of(const struct problem *problem)
{
    return problem->command && strcmp(problem->command, "watch") == 0
               ? "'watch s : rmax', or with a range 'watch s 0.1 0.9 : rmax'"
               : form;
}

/* What was parsed: a parameter, the ends of a range, the question, and the value that it is to take. */
struct solve_parsed {
    const struct parameter *parameter;
    struct item from, to, value;
    struct question question;
    bool ranged, verdict;
};

static const struct argument value_argument = {.name = "VALUE", .kind = ARGUMENT_ANY};

static bool bound_parse(struct reader *r, const struct parameter *p, const char *name, struct item *item)
{
    r->at = skip_blanks(r->at);
    reader_place(r, r->at);
    if (reader_ends(r))
        return problem_error(r->problem, "%s is missing; the form is %s", name, form_of(r->problem));
    return item_parse_value(r, p, 0, p->value->name, item) &&
           (item->value || isfinite(item->number) ||
            problem_error(r->problem, "%s is a number; the form is %s", name, form_of(r->problem)));
}

/* Parses "NAME" or "NAME FROM TO", up to the ':'. */
bool solve_parse_parameter(struct reader *r, struct question *q)
{
    char message[NAMES_MESSAGE] = "", name[32];
    struct solve_parsed *s = q->own = arena_take(r->arena, sizeof *s);
    if (!s)
        return problem_error(r->problem, "out of memory");
    offer_names(r, solve_names, NULL);
    size_t length = strcspn(r->at, " \t:;>");
    snprintf(name, sizeof name, "%.*s", (int)length, r->at);
    int k = names_find(solve_names, NULL, "parameter", name, message);
    bool usual;
    const struct parameter *meant = k == NAMES_UNKNOWN ? parameter_by_synonym(name, &usual) : NULL;
    if (meant)
        return problem_error(r->problem, "%s; did you mean '%s'?", message, meant->name);
    if (k < 0)
        return problem_error(r->problem, "%s; the form is %s", message, form_of(r->problem));
    r->at = skip_blanks(r->at + length);
    r->stops = ":";
    s->parameter = parameter_find(usual_ranges[k].name);
    s->ranged = *r->at != ':' && !command_ends(r->at);
    bool good = !s->ranged || (bound_parse(r, s->parameter, "FROM", &s->from) &&
                               bound_parse(r, s->parameter, "TO", &s->to));
    r->stops = NULL;
    r->at = skip_blanks(r->at);
    if (good)
        reader_place(r, r->at);
    return good &&
           (*r->at == ':' ||
            problem_error(r->problem, "':' and an answer are missing; the form is %s", form_of(r->problem)));
}

/* Parses ": ANSWER = VALUE", or ": COMMAND" with a verdict. */
bool solve_parse_answer(struct reader *r, struct question *q)
{
    struct solve_parsed *s = q->own;
    r->at = skip_blanks(r->at + 1);
    reader_place(r, r->at);
    if (command_ends(r->at) || *r->at == '>')
        return problem_error(r->problem, "the answer is missing after ':'; the form is %s", form);
    r->stops = "=";
    bool good = question_parse_any(r, &s->question, false);
    r->stops = NULL;
    s->verdict = good && *r->at != '=';
    if (!good)
        return false;
    if (s->verdict)
        return s->question.command->holds ||
               problem_error(r->problem,
                             "'= VALUE' is missing after '%s'; only a command with a verdict, such as "
                             "'verdict', has no value; the form is %s",
                             s->question.name, form);
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
    struct solve_parsed *s = q->own;
    r->at = skip_blanks(r->at + 1);
    reader_place(r, r->at);
    return reader_ends(r)
               ? problem_error(r->problem,
                               "the answer is missing after ':'; for example 'watch s 0.1 0.9 : rmax'")
               : question_parse_any(r, &s->question, true);
}

bool solve_bind(const struct question *q, const struct query *query, struct arguments *given,
                struct problem *problem)
{
    const struct solve_parsed *parsed = q->own;
    struct solve *s = malloc(sizeof *s);
    if (!s)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    given->own = s;
    given->own_free = free;
    *s = (struct solve){
        .parameter = parsed->parameter, .question = &parsed->question, .verdict = parsed->verdict};
    const struct usual_range *usual = usual_ranges;
    while (strcmp(usual->name, s->parameter->name) != 0)
        usual++;
    s->from = (domq_real)usual->from;
    s->to = (domq_real)usual->to;
    if (parsed->ranged && (!item_bind(&parsed->from, q->text, query, NULL, &s->from, problem) ||
                           !item_bind(&parsed->to, q->text, query, NULL, &s->to, problem)))
        return false;
    if (!(s->from < s->to))
        return problem_error(problem, "the range begins at %s and ends at %s; FROM is less than TO",
                             quad_shown(s->from).text, quad_shown(s->to).text);
    domq_real number;
    return !parsed->value.argument || item_bind(&parsed->value, q->text, query, &s->value, &number, problem);
}

/* ---- The answer ---- */

const struct column solve_columns[] = {
    {"value", "", "of the parameter", 0},
    {"answer", "", "there; for a verdict 1 is true", 0},
    {"branch", "", "whether the answer rises or falls with the parameter", 15},
    {NULL, NULL, NULL, 0},
};

static int compare(const void *one, const void *other)
{
    domq_real a = ((const struct root *)one)->x, b = ((const struct root *)other)->x;
    return a < b ? -1 : a > b;
}

/* Writes why no value was found. */
static void none_say(const struct scan *s, char *text, size_t size)
{
    const struct solve *v = s->solve;
    const char *name = v->parameter->name, *unit = v->parameter->value->unit;
    char range[192], least[CELL_TEXT], most[CELL_TEXT];
    snprintf(range, sizeof range, "%s = %s .. %s%s%s", name, quad_shown(v->from).text, quad_shown(v->to).text,
             *unit && strcmp(unit, "h") != 0 ? " " : "", strcmp(unit, "h") != 0 ? unit : "");
    if (s->answers == 0) {
        snprintf(text, size, "%s has no answer for any %s: %s", v->question->name, range, s->none);
        return;
    }
    if (v->verdict) {
        snprintf(text, size, "%s: %s for %s %s", v->question->name, v->question->command->holds,
                 s->most.f > 0 ? "every" : "no", range);
        return;
    }
    snprintf(least, sizeof least, "%s", quad_shown(s->least.f + v->value.value).text);
    snprintf(most, sizeof most, "%s", quad_shown(s->most.f + v->value.value).text);
    if (s->most.f < 0 || s->least.f > 0)
        snprintf(text, size, "%s does not take the value %s for %s: the %s is %s, at %s = %s",
                 v->question->name, quad_shown(v->value.value).text, range,
                 s->most.f < 0 ? "largest" : "smallest", s->most.f < 0 ? most : least, name,
                 quad_shown(s->most.f < 0 ? s->most.x : s->least.x).text);
    else
        snprintf(text, size, "%s does not take the value %s for %s: it jumps over it at %s = %s",
                 v->question->name, quad_shown(v->value.value).text, range, name, quad_shown(s->jump).text);
}

/* Reports an error if the answer has another unit than the value. */
static bool units_agree(struct problem *problem, const struct scan *s)
{
    char is[64], wanted[64];
    struct quantity a = s->probe.unit, b = s->solve->value;
    if (s->solve->verdict || s->answers == 0)
        return true;
    return quantity_bare(b) || quantity_alike(a, b) ||
           problem_error(problem, "%s is %s, and VALUE is %s", s->solve->question->name,
                         expression_kind(a, is, sizeof is), expression_kind(b, wanted, sizeof wanted));
}

/* Reports an error if the answer is the same everywhere. */
static bool depends(const struct query *query, struct problem *problem, const struct scan *s)
{
    domq_real spread = s->most.f - s->least.f, value = s->most.f + s->solve->value.value;
    if (s->solve->verdict || s->answers < 2 ||
        spread > (domq_real)1e-12 * quad(fabs)(value) + 10 * query->scene->compute.tol * quad(fabs)(value))
        return true;
    return problem_no_answer(
        problem,
        "%s does not depend on %s: it is %s everywhere in %s .. %s; 'sensitivity' shows on "
        "what it depends",
        s->solve->question->name, s->solve->parameter->name, quad_shown(value).text,
        quad_shown(s->solve->from).text, quad_shown(s->solve->to).text);
}

bool run_solve(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct solve *solve = query->given->own;
    char reason[1024];
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
    bool done = scan_run(s);
    gsl_set_error_handler(handler);
    if (!done)
        probe_report(&s->probe, problem);
    done = done && units_agree(problem, s) && depends(query, problem, s);
    if (done) {
        struct column *columns = answer_columns(a, solve_columns);
        columns[0].unit = solve->parameter->value->unit;
        qsort(s->root, (size_t)s->roots, sizeof *s->root, compare);
        if (s->roots > 0)
            answer_largest(a, "value", s->root[s->roots - 1].x);
    }
    for (int i = 0; done && i < s->roots && !answer_lost(a); i++)
        answer_cells(a, cell_bound(s->root[i].x, DOMQ_NAN), cell_bound(s->root[i].answer, DOMQ_NAN),
                     cell_word(s->root[i].branch));
    if (done && s->roots == 0) {
        none_say(s, reason, sizeof reason);
        if (answer_for_people(a))
            answer_say(a, "%s.", reason);
        else
            answer_row(a, ROW(cell_real(DOMQ_NAN), cell_real(DOMQ_NAN), cell_word("none")), reason);
    }
    free(s);
    return done;
}
