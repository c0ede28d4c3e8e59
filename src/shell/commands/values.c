/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'print' and 'let'. */
#include "interpreter/question.h"
#include "language/quad.h"
#include "language/text.h"
#include <stdlib.h>
#include <string.h>

/* ---- print ---- */

static const struct column print_columns[] = {
    {"value", "", "the value in SI units (angles in the session's unit), or in the unit after 'to'", 0},
    {"unit", "", "the unit of the value; empty for a plain number", 6},
    {NULL, NULL, NULL, 0},
};

/* The unit into which 'print' converts a value. */
struct conversion {
    struct quantity unit;
    const char *name;
    const char *at;
};

static bool conversion_parse(struct reader *r, struct question *q)
{
    struct conversion *c = q->parsed = reader_memory(r, sizeof *c);
    if (!c)
        return false;
    if (!reader_takes(r, "to")) {
        q->parsed = NULL;
        return true; /* what is there is one argument too many */
    }
    reader_place(r, c->at = r->at);
    offer_names(r, expression_units, NULL);
    c->name = reader_ends(r) ? "" : read_word(r, WORD_BARE);
    if (!c->name)
        return false;
    const bool percent = strcmp(c->name, "percent") == 0 || strcmp(c->name, "%") == 0;
    c->unit = (struct quantity){.value = percent ? (domq_real)1 / 100 : 1};
    const char *close = names_closest(expression_units, NULL, c->name),
               *end = percent ? "" : unit_scan(c->name, &c->unit);
    c->name = percent ? "%" : c->name;
    if (!end || *end)
        return problem_error(r->problem,
                             !*c->name ? "the unit after 'to' is missing; enter, for example, '%s'"
                             : close   ? "'%s' is not a unit; did you mean '%s'?"
                                       : "'%s' is not a unit; enter, for example, '%s'",
                             !*c->name ? "print 112 m to ft" : names_shown(c->name),
                             close ? close : "print 112 m to ft");
    return true;
}

static bool run_print(const struct query *query, struct answer *a, struct problem *problem)
{
    struct quantity q = query->given->quantity[0];
    const struct conversion *to = query->given->bound;
    const struct answer_style *style = &query->state->settings.style;
    /* In '90 to rad', the plain number 90 is taken as an angle in the session's unit. */
    if (to && quantity_is_number(q) && quantity_alike(to->unit, (struct quantity){.angle = 1}))
        q = (struct quantity){.value = style->angle == ANGLE_DEG ? q.value * (QUAD_PI / 180) : q.value,
                              .angle = 1};
    if (to && !quantity_alike(q, to->unit)) {
        problem->place = text_column(query->given->question->text, to->at);
        return problem_error(problem, "the value is %s, but 1 %s is %s", expression_kind(q), to->name,
                             expression_kind(to->unit));
    }
    a->is_value = true;
    a->value = q;
    const bool is_angle = !to && quantity_is_dimensionless(q) && q.angle == 1;
    const char *unit = to ? to->name : is_angle ? style_angle_unit(style) : expression_unit_text(q);
    q.value = to ? q.value / to->unit.value : is_angle ? style_angle(style, q.value) : q.value;
    int digits = (int)a->style.digits;
    if (digits < 15 && q.value == quad(floor)(q.value))
        digits = 15; /* an integer is shown with up to 15 digits */
    const struct cell cell = cell_without_error(q.value);
    if (answer_for_people(a))
        answer_say(a, *unit ? "%s %s" : "%s", quad_text(q.value, digits), unit);
    else
        answer_cells(a, cell, cell_word(unit));
    return true;
}

/* ---- let ---- */

/* A parsed definition of a variable or function. The body of a function is in the parser's arena. */
struct definition {
    struct variable variable;
    struct argument argument;
    struct item value;
};

static bool definition_parse(struct reader *r, struct question *q)
{
    struct definition *d = q->parsed = reader_memory(r, sizeof *d);
    if (!d)
        return false;
    struct variable *v = &d->variable;
    const char *value = definition_head(r->at, v);
    offer_kind(r, OFFER_VARIABLE);
    if (!value)
        return problem_error(
            r->problem,
            "enter, for example, 'let x = 0.9*rmax', or 'let f(s) = rmax(s)*s' for a function with 1 to %d "
            "arguments",
            EXPRESSION_ARGUMENTS);
    if (!name_free(r->problem, v->name))
        return false;
    for (int i = 0; i < v->count; i++)
        for (int k = 0; k < i; k++)
            if (strcmp(v->argument[i], v->argument[k]) == 0)
                return problem_error(r->problem, "two values of '%s' have the same name '%s'", v->name,
                                     v->argument[i]);
    r->at = skip_blanks(value);
    reader_place(r, r->at);
    if (command_ends(r->at))
        return problem_error(r->problem,
                             "the value of '%s' is missing; enter, for example, 'let %s = 0.9*rmax'", v->name,
                             v->name);
    d->argument = (struct argument){.name = v->name, .kind = ARGUMENT_ANY};
    value = r->at;
    if (v->count > 0)
        r->names = NULL; /* the names in a function are resolved when the function is called */
    if (!item_parse(r, &d->argument, &d->value))
        return false;
    v->body = v->count > 0 ? reader_copy(r, value, (size_t)(r->at - value)) : NULL;
    return v->body || v->count == 0;
}

static bool run_let(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct definition *d = query->given->bound;
    struct variables *all = &query->next->variables;
    struct variable v = d->variable;
    domq_real number;
    (void)a;
    if (!v.body && !item_bind(&d->value, query->given->question->text, query, &v.value, &number, problem))
        return false;
    const int power[] = {v.value.length, v.value.time, v.value.angle, v.value.mass};
    for (int i = 0; i < 4; i++)
        if (abs(power[i]) > UNIT_POWER_MOST)
            return problem_error(problem, "the unit of '%s' has an exponent above %d", v.name,
                                 UNIT_POWER_MOST);
    if (!variable_find(all, v.name) && all->count == VARIABLES_MOST)
        return problem_error(problem, "there can be no more than %d variables", VARIABLES_MOST);
    return variable_put(all, &v) || query_status(query, problem, DOM_NO_MEMORY);
}

const struct command value_commands[] = {
    {.name = "print",
     .synonyms =
         "calculate calculator convert unit units feet inch evaluate sum expression expressions function "
         "functions",
     .argument = {{.name = "VALUE", .kind = ARGUMENT_ANY},
                  {.name = "to U", .kind = ARGUMENT_UNIT, .optional = true, .parse = conversion_parse}},
     .summary = "the value of an expression, optionally in another unit",
     .help =
         "The word print may be left out: '2+2', 'rmax(0.3)^20', '112 m to ft', 'rmax to percent'. An "
         "expression may contain numbers, pi, + - * / ^ and parentheses. The units are m mm cm km in ft yd "
         "for lengths, kg g t lb oz for masses, s ms min hr for times, km/h mph for speeds, and rad deg for "
         "angles; 3/8 in is "
         "(3/8) in. The functions are "
         "sin cos tan asin acos atan atan2 exp ln log log10 sqrt abs floor ceil round hypot min max. A name "
         "is a parameter, or something that 'let' has defined. 'ans' is the last "
         "value, and 'ans.KEY' is a "
         "number of the last answer. A command stands for one number of its answer, and a key chooses "
         "another: rmax, rmax(0.3).r_max_paper. g and t are units "
         "directly after a number or a ')': '10 g'. "
         "Elsewhere g is gravity: 'h/g', '2*g'. The comparisons are < <= > >= == and !=. The value of a "
         "comparison is 1 if it is true, and 0 otherwise. Write '(a > b)' in parentheses, because otherwise "
         "'>' sends the answer to a file. 'and', 'or' and 'not' join comparisons, and 'if(r > 1.5, 1, 0)' "
         "chooses one of two values. 'with' changes parameters and effects for one answer: 'rmax 0.4 with q "
         "hollow d 0.1', '2*rmax with friction 0.2'. A text in "
         "double quotes is written as 'echo' writes it.",
     .example = "print ln(112 m / h) / ln(rmax)",
     .see = "let set landmarks",
     .is_print = true,
     ANSWER(print)},
    {.name = "let",
     .synonyms = "variable define function assign name constant vars variables who",
     .argument = {{.name = "NAME = VALUE", .kind = ARGUMENT_WORDS, .parse = definition_parse}},
     .summary = "give a value a name, or define a function",
     .help =
         "'let x = 0.9*rmax' stores the value that the expression has now, and every expression can use x."
         " 'let f(s) = rmax(s)*s' stores the text, and f(0.3) evaluates it with s = 0.3. A function takes "
         "1 to 4 values and cannot use itself. 'x' shows the value, 'x = 2' changes it, and 'reset x' "
         "removes "
         "x. 'show' lists all variables and functions.",
     .example = "let f(s) = rmax(s)*s; let x = f(0.4); 2*x; f(0.6)",
     .see = "print set show",
     .access.changes = true,
     .run = run_let},
    {.name = NULL},
};
