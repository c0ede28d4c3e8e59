/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'solve', which finds where an answer has a given value, or where a verdict changes. The parser
 * for parameters with ranges and the probe, which other searches also use, are here, too. */
#include "interpreter/question.h"
#include "language/quad.h"
#include "session/parameters.h"
#include "sweeps/sweeps.h"
#include "train/seek.h"
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

/* The parsed arguments of a search. An item that was not typed is zero. */
struct varied_parsed {
    struct {
        const struct parameter *parameter;
        struct item from, to;
    } range[VARIED_MOST];
    int count;
    struct question question;
    bool verdict;
    struct item value;
};

/* Reports what is wrong with the arguments of a search, with an example. */
static bool form_wrong(struct problem *problem, const char *what)
{
    const struct command *c = command_find(problem->command);
    return problem_error(problem, "%s; enter, for example, '%s'", what,
                         c && c->example ? c->example : "watch s 0.1 0.9 : rmax");
}

static bool bound_parse(struct reader *r, const struct parameter *p, bool is_to, struct item *item)
{
    /* the words may be left out, and completion does not offer them */
    const char *word = is_to ? "to" : "from";
    r->at = skip_blanks(r->at);
    if (word_is_next(r, word))
        r->at = skip_blanks(r->at + strlen(word));
    bool is_missing = reader_ends(r);
    reader_place(r, r->at);
    if (is_missing)
        return form_wrong(r->problem, is_to ? "TO is missing" : "FROM is missing");
    return item_parse_value(r, p, 0, p->value->name, item) &&
           (item->value || isfinite(item->number) ||
            form_wrong(r->problem, is_to ? "TO must be a number" : "FROM must be a number"));
}

/* Parses a parameter with its range up to a ':' or ','. */
static bool range_parse(struct reader *r, names_list *names, struct varied_parsed *v)
{
    char message[NAMES_MESSAGE] = "", name[32];
    offer_names(r, names, NULL);
    size_t length = strcspn(r->at, " \t:,;>");
    snprintf(name, sizeof name, "%.*s", (int)length, r->at);
    if (length == 0)
        return form_wrong(r->problem, "the name of a parameter is missing");
    int k = parameter_search(names, "parameter", name, message);
    if (k == NAMES_CLOSE)
        return problem_error(r->problem, "%s", message);
    if (k < 0)
        return form_wrong(r->problem, message);
    const struct parameter *p = v->range[v->count].parameter = parameter_find(names(NULL, k));
    r->at = skip_blanks(r->at + length);
    r->stops = ":,";
    bool is_good = *r->at == ':' || *r->at == ',' || command_ends(r->at) ||
                   (bound_parse(r, p, false, &v->range[v->count].from) &&
                    bound_parse(r, p, true, &v->range[v->count].to));
    v->count++;
    r->stops = NULL;
    r->at = skip_blanks(r->at);
    if (is_good)
        reader_place(r, r->at);
    return is_good;
}

/* Parses "NAME" or "NAME FROM TO" for up to `most` parameters, up to the ':'. */
static bool ranges_parse(struct reader *r, struct question *q, names_list *names, int most)
{
    struct varied_parsed *v = q->parsed = reader_memory(r, sizeof *v);
    while (v && range_parse(r, names, v)) {
        if (v->count == 2 && v->range[0].parameter == v->range[1].parameter)
            return problem_error(r->problem, "'%s' is named twice; name each parameter once",
                                 v->range[0].parameter->name);
        if (*r->at != ',')
            return *r->at == ':' || form_wrong(r->problem, "':' and an answer are missing");
        if (v->count == most)
            return problem_error(r->problem, "at most %s can be varied; 'set' gives the others a value",
                                 most == 1 ? "one parameter" : "two parameters");
        r->at = skip_blanks(r->at + 1);
        reader_place(r, r->at);
    }
    return false;
}

const char *optimum_names(const void *context, int k)
{
    (void)context;
    const struct parameter *p = session_parameters;
    while (p->name && (p->setting || p->words_only || p->of_precision ||
                       (p->from == p->to && !p->value->whole) || k-- > 0))
        p++;
    return p->name;
}

bool solve_parse_name(struct reader *r, struct question *q)
{
    return ranges_parse(r, q, solve_names, 1);
}

bool optimum_parse_names(struct reader *r, struct question *q)
{
    return ranges_parse(r, q, optimum_names, VARIED_MOST);
}

static bool colon_pass(struct reader *r)
{
    r->at = skip_blanks(r->at + 1);
    reader_place(r, r->at);
    return !reader_ends(r) || form_wrong(r->problem, "the answer is missing after ':'");
}

bool varied_parse_answer(struct reader *r, struct question *q)
{
    struct varied_parsed *v = q->parsed;
    return colon_pass(r) && question_parse_any(r, &v->question, true);
}

/* Parses ": ANSWER = VALUE", or ": COMMAND" for a command that has a verdict. */
bool solve_parse_answer(struct reader *r, struct question *q)
{
    static const struct argument value_argument = {.name = "VALUE", .kind = ARGUMENT_ANY};
    struct varied_parsed *v = q->parsed;
    if (!colon_pass(r))
        return false;
    r->stops = "=";
    bool is_good = question_parse_any(r, &v->question, false);
    r->stops = NULL;
    if (!is_good)
        return false;
    v->verdict = *r->at != '=';
    if (v->verdict)
        return v->question.command->holds ||
               problem_error(r->problem,
                             "'= VALUE' is missing after '%s'; only commands that answer yes or no, such as "
                             "'verdict', can do without it; enter, for example, 'solve d : rmax = 5/3'",
                             v->question.name);
    if (!question_needs_number(&v->question, r->problem))
        return false;
    r->at = skip_blanks(r->at + 1);
    reader_place(r, r->at);
    r->last = true;
    return item_parse(r, &value_argument, &v->value);
}

bool varied_bind(const struct question *q, const struct query *query, struct arguments *given,
                 struct problem *problem)
{
    const struct varied_parsed *parsed = q->parsed;
    struct varied *v = arguments_take(given, sizeof *v, query, problem);
    domq_real number;
    if (!v)
        return false;
    *v = (struct varied){.count = parsed->count, .question = &parsed->question, .verdict = parsed->verdict};
    for (int i = 0; i < v->count; i++) {
        const struct item *from = &parsed->range[i].from, *to = &parsed->range[i].to;
        const struct parameter *p = parsed->range[i].parameter;
        struct ranged *range = &v->range[i];
        *range = (struct ranged){p, (domq_real)p->from, (domq_real)p->to};
        if (from->at && (!item_bind(from, q->text, query, NULL, &range->from, problem) ||
                         !item_bind(to, q->text, query, NULL, &range->to, problem)))
            return false;
        if (p->from == p->to && !from->at)
            return problem_error(problem, "%s needs a range, as in '%s 5 50 : ...'", p->name, p->name);
        if (!(range->from < range->to))
            return problem_error(problem, "the range from %s to %s is empty: FROM must be less than TO",
                                 quad_text(range->from, 10), quad_text(range->to, 10));
    }
    return !parsed->value.at || item_bind(&parsed->value, q->text, query, &v->value, &number, problem);
}

/* ---- Probes ---- */

/* Runs the command and sets *value to 1 if its verdict is true, and to -1 if it is false. Fails if the
 * command has no verdict. */
static bool verdict_ask(const struct probe *p, const struct query *at, struct quantity *value,
                        struct problem *problem)
{
    const struct command *c = p->question->command;
    struct answer answer = {.style = state_style(at->state), .columns = c->columns, .rows = c->rows};
    if (!question_ask(p->question, at, &answer, problem))
        return false;
    *value = (struct quantity){.value = answer.verdict == ANSWER_YES ? 1 : -1};
    return answer.verdict != ANSWER_OPEN || problem_no_answer(problem, "the command has no verdict here");
}

domq_real probe_ask(struct probe *p, const struct assigned *assigned, int count)
{
    struct state point;
    struct query at;
    struct run_context run_context = *p->query->run_context;
    struct quantity answer = {.value = 0};
    problem_begin(&p->problem, p->command);
    bool put = query_with(p->query, assigned, count, &point, &at, &p->problem);
    at.run_context = &run_context;
    run_context.seeks_yes = p->seeks_yes;
    point.settings.threads = 1;
    bool done = put && (p->verdict ? verdict_ask(p, &at, &answer, &p->problem)
                                   : question_measure(p->question, &at, &answer, p->unit_text, &p->problem));
    p->wrong = put && !done && p->problem.kind != PROBLEM_NO_ANSWER;
    if (!done)
        return DOMQ_NAN;
    p->unit = answer;
    return isfinite(answer.value) ? answer.value : DOMQ_NAN;
}

domq_real probe_at(struct probe *p, domq_real value)
{
    const struct assigned assigned = {.parameter = p->parameter, .value = value};
    return probe_ask(p, &assigned, p->parameter != NULL);
}

bool probe_report(const struct probe *p, struct problem *problem)
{
    if (dom_raised(p->query->scene->compute.interrupt))
        return problem_status(problem, p->query->scene, DOM_INTERRUPTED);
    *problem = p->problem;
    return false;
}

/* ---- Roots ---- */

enum { ROOTS_MOST = 64, SCAN_POINTS = 241 };

/* A search for the values x of a parameter at which an answer is equal to a given value. The value of a spot
 * is the difference, answer - value, or NaN if there is no answer. */
struct scan {
    struct probe probe;
    const struct varied *varied;
    struct root {
        double x;
        const char *branch;
    } root[ROOTS_MOST]; /* the roots found so far; at the end they are sorted by x */
    int roots;
    double jump;                                 /* an x at which the answer jumps past the given value */
    struct spot most, least, point[SCAN_POINTS]; /* the highest and the lowest spot, and those of the grid */
    size_t answers;                              /* the number of spots with an answer */
    char no_answer[PROBLEM_TEXT / 2];            /* the reason for the first missing answer */
    double sign;                                 /* for scan_side: 1 or -1 */
};

static double scan_at(double x, void *context)
{
    struct scan *s = context;
    const struct spot spot = {x, (double)(probe_at(&s->probe, quad_decimal(x)) - s->varied->value.value)};
    if (isnan(spot.value)) {
        if (!*s->no_answer)
            snprintf(s->no_answer, sizeof s->no_answer, "%.*s", (int)sizeof s->no_answer - 1,
                     s->probe.problem.text);
        return spot.value;
    }
    if (s->answers == 0 || spot.value > s->most.value)
        s->most = spot;
    if (s->answers == 0 || spot.value < s->least.value)
        s->least = spot;
    s->answers++;
    return spot.value;
}

/* These values have an edge where the answers end, where they are equal to the given value no longer, and
 * where they change their side of it. */
static double scan_any(double x, void *context)
{
    return isnan(scan_at(x, context)) ? -1 : 1;
}

static double scan_equal(double x, void *context)
{
    return scan_at(x, context) == 0 ? 0 : -1;
}

static double scan_side(double x, void *context)
{
    struct scan *s = context;
    return s->sign * scan_at(x, s);
}

static void root_add(struct scan *s, double x, const char *branch)
{
    for (int i = 0; i < s->roots; i++)
        if (fabs(s->root[i].x - x) <= 1e-9 * fabs(x))
            return;
    if (s->roots < ROOTS_MOST)
        s->root[s->roots++] = (struct root){x, branch};
}

/* Finds the root between two spots with values of opposite signs. If the answer jumps past the given value,
 * so that there is no root, stores the x of the jump. */
static void root_between(struct scan *s, struct spot a, struct spot b)
{
    const bool rises = b.value > a.value;
    const double rise = fabs(b.value - a.value), value = fabs((double)s->varied->value.value),
                 scale = value > 0 ? value : s->most.value - s->least.value;
    struct spot good = rises ? b : a, bad = rises ? a : b;
    seek_edge(scan_at, s, &good, &bad, 0);
    const struct spot root = good.value <= -bad.value ? good : bad;
    if (fabs(root.value) > 1e-6 * rise && fabs(root.value) > 1e-9 * scale)
        s->jump = root.x;
    else
        root_add(s, root.x, rises ? "rising" : "falling");
}

/* Looks for a root between two neighbouring points of the grid. */
static void look_between(struct scan *s, struct spot a, struct spot b)
{
    struct spot *const end[] = {&a, &b};
    for (int i = 0; i < 2; i++) {
        struct spot hole = *end[i];
        if (isnan(hole.value) && !isnan(end[1 - i]->value)) { /* the answers end in between */
            *end[i] = *end[1 - i];
            seek_edge(scan_any, s, end[i], &hole, 0);
            end[i]->value = scan_at(end[i]->x, s);
        }
    }
    for (int i = 0; i < 2; i++) {
        /* If the answer equals the value in a whole interval, only the ends of the interval are roots. */
        struct spot equal = *end[i], other = *end[1 - i];
        if (equal.value == 0 && other.value != 0) {
            const bool rises = i == 0 ? other.value > 0 : other.value < 0;
            seek_edge(scan_equal, s, &equal, &other, 0);
            root_add(s, equal.x, rises ? "rising" : "falling");
            return;
        }
    }
    if (a.value * b.value < 0)
        root_between(s, a, b);
}

/* Near a maximum or a minimum, the answer may cross the value twice between two points of the grid, and then
 * both points are on the same side of the value. If m is the highest or the lowest of three points, climbs
 * from there. If this leads to the other side, there is a root on either side of that spot. */
static void look_around(struct scan *s, struct spot a, struct spot m, struct spot b)
{
    s->sign = m.value < 0 ? 1 : -1;
    const double height = s->sign * m.value, left = s->sign * a.value, right = s->sign * b.value;
    if (m.value == 0 || height < left || height < right || (height == left && height == right))
        return;
    struct spot top = {m.x, height};
    top = seek_top(scan_side, s, a.x, top, b.x, 1e-8 * (b.x - a.x), 0);
    top.value *= s->sign;
    if (a.value * top.value < 0) {
        root_between(s, a, top);
        root_between(s, top, b);
    }
}

/* Finds where the verdict changes between two points. Without an answer the verdict counts as false. */
static void verdict_between(struct scan *s, struct spot a, struct spot b)
{
    const bool holds = a.value > 0;
    struct spot good = holds ? a : b, bad = holds ? b : a;
    if (holds == (b.value > 0))
        return;
    seek_edge(scan_at, s, &good, &bad, 0);
    root_add(s, good.x, holds ? "true up to here" : "true from here on");
}

static int compare_roots(const void *one, const void *other)
{
    const double a = ((const struct root *)one)->x, b = ((const struct root *)other)->x;
    return a < b ? -1 : a > b;
}

/* Searches the whole range. Returns false after an error or an interrupt; then call probe_report. */
static bool scan_run(struct scan *s)
{
    struct spot *p = s->point;
    const struct ranged *range = s->varied->range;
    const volatile sig_atomic_t *interrupt = s->probe.query->scene->compute.interrupt;
    for (int k = 0; k < SCAN_POINTS; k++) {
        const double share = (double)k / (SCAN_POINTS - 1);
        p[k].x = (1 - share) * (double)range->from + share * (double)range->to;
        p[k].value = scan_at(p[k].x, s);
        if (s->probe.wrong || dom_raised(interrupt))
            return false;
    }
    for (int k = 1; k < SCAN_POINTS; k++)
        (s->varied->verdict ? verdict_between : look_between)(s, p[k - 1], p[k]);
    for (int k = 1; k + 1 < SCAN_POINTS && !s->varied->verdict; k++)
        if (!isnan(p[k - 1].value) && !isnan(p[k].value) && !isnan(p[k + 1].value))
            look_around(s, p[k - 1], p[k], p[k + 1]);
    qsort(s->root, (size_t)s->roots, sizeof *s->root, compare_roots);
    return !dom_raised(interrupt);
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
    const struct varied *v = s->varied;
    const char *name = v->range->parameter->name, *unit = v->range->parameter->value->unit,
               *question = v->question->name;
    const char *value = quad_text(v->value.value, 10);
    const bool below = s->most.value < 0; /* the answer is below the wanted value in the whole range */
    const struct spot *nearest = below ? &s->most : &s->least;
    char range[192];
    unit = strcmp(unit, "h") == 0 ? "" : unit;
    snprintf(range, sizeof range, "%s = %s .. %s%s%s", name, quad_text(v->range->from, 10),
             quad_text(v->range->to, 10), *unit ? " " : "", unit);
    if (s->answers == 0)
        snprintf(text, size, "%s has no answer for any %s: %s", question, range, s->no_answer);
    else if (v->verdict && s->most.value > 0)
        snprintf(text, size, "%s: %s for every %s", question, v->question->command->holds, range);
    else if (v->verdict)
        snprintf(text, size, "%s: no %s from %s to %s%s%s makes it true that %s", question, name,
                 quad_text(v->range->from, 10), quad_text(v->range->to, 10), *unit ? " " : "", unit,
                 v->question->command->holds);
    else if (below || s->least.value > 0)
        snprintf(text, size, "%s is never %s for %s: the %s value is %s, at %s = %s", question, value, range,
                 below ? "largest" : "smallest", quad_text(quad_decimal(nearest->value) + v->value.value, 10),
                 name, quad_text(quad_decimal(nearest->x), 10));
    else
        snprintf(text, size, "%s is never %s for %s: it jumps over this value at %s = %s", question, value,
                 range, name, quad_text(quad_decimal(s->jump), 10));
}

/* Checks that the answer has the unit of the value, and is not constant. */
static bool scan_check(const struct scan *s, struct problem *problem)
{
    const struct varied *v = s->varied;
    const struct quantity unit = s->probe.unit;
    const domq_real highest = (domq_real)s->most.value + v->value.value, size = quad(fabs)(highest),
                    tol = s->probe.query->scene->compute.tol;
    if (v->verdict || s->answers == 0)
        return true;
    if (!quantity_is_number(v->value) && !quantity_alike(unit, v->value))
        return problem_error(problem, "%s is %s, but VALUE is %s", v->question->name, expression_kind(unit),
                             expression_kind(v->value));
    if (s->answers < 2 ||
        (domq_real)(s->most.value - s->least.value) > (domq_real)1e-12 * size + 10 * tol * size)
        return true;
    return problem_no_answer(
        problem,
        "%s does not depend on %s: it is %s everywhere in %s .. %s; 'sensitivity' shows what it depends on",
        v->question->name, v->range->parameter->name, quad_text(highest, 10), quad_text(v->range->from, 10),
        quad_text(v->range->to, 10));
}

static void scan_answer(struct scan *s, struct answer *a)
{
    char reason[1024];
    answer_columns(a, solve_columns)[0].unit = s->varied->range->parameter->value->unit;
    for (int i = 0; i < s->roots; i++)
        answer_announce(a, "value", quad_decimal(s->root[i].x));
    for (int i = 0; i < s->roots && !answer_lost(a); i++) {
        const domq_real x = quad_decimal(s->root[i].x);
        answer_cells(a, cell_computed(x), cell_computed(probe_at(&s->probe, x)),
                     cell_word(s->root[i].branch));
    }
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
    const struct varied *varied = query->given->bound;
    struct scan *s = calloc(1, sizeof *s);
    if (!s)
        return problem_status(problem, query->scene, DOM_NO_MEMORY);
    s->varied = varied;
    s->probe = (struct probe){.query = query,
                              .command = problem->command,
                              .question = varied->question,
                              .parameter = varied->range->parameter,
                              .verdict = varied->verdict};
    bool done = scan_run(s) ? scan_check(s, problem) : probe_report(&s->probe, problem);
    if (done)
        scan_answer(s, a);
    free(s);
    return done;
}
