/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/question.h"
#include "interpreter/forms.h"
#include "interpreter/lookup.h"
#include "language/quad.h"
#include "session/parameters.h"
#include <ctype.h>
#include <limits.h>
#include <string.h>

static const char no_memory[] = "out of memory";

/* Returns true for a name that expressions know. */
static bool is_value_name(const struct state *state, const char *word)
{
    return names_exact(value_names, state, word) >= 0;
}

/* ---- Expressions ---- */

/* Returns true if the word after a value is a value itself, or joins. If not, the word is meant as a unit. */
static bool known_word(struct reader *r, const char *at)
{
    char word[NAMES_SHOWN], shown[NAMES_SHOWN];
    if (!name_copy(at, name_length(at), word, sizeof word) || is_value_name(r->query->state, word) ||
        strcmp(word, "to") == 0 || strcmp(word, "with") == 0)
        return true;
    const char *close = names_closest(expression_units, NULL, word);
    reader_place(r, at);
    names_shown(word, shown);
    if (strcmp(word, "in") == 0)
        return problem_error(r->problem,
                             "the unit 'in' must follow a number; 'to' converts, as in '4.8 cm to mm'");
    if (close && strcmp(close, word) == 0)
        return problem_error(r->problem, "the unit '%s' must follow a number or a ')', as in '4.8 cm'",
                             shown);
    return close ? problem_error(r->problem, "'%s' is not a unit; did you mean '%s'?", shown, close)
                 : problem_error(r->problem, "'%s' is not a unit and has no value", shown);
}

/* Describes an error at a place in an expression, with the word that is there. */
static bool expression_wrong(struct problem *problem, enum problem_kind kind, const struct text *text,
                             const char *name, const char *at, const char *message)
{
    char shown[NAMES_SHOWN], word[NAMES_SHOWN];
    if (text)
        problem->place = text_column(text, at);
    snprintf(word, sizeof word, "%.*s", (int)strcspn(at, " \t;"), at);
    return problem_report(problem, kind, *word ? "%s at '%s': %s" : "%s%s: %s", name,
                          names_shown(word, shown), message);
}

/* Describes what stands behind a value where nothing can. */
static bool wrong_end(struct reader *r, const char *name, const char *end)
{
    char shown[NAMES_SHOWN];
    reader_place(r, end);
    names_shown(end, shown);
    if (*end == ',' && isdigit((unsigned char)end[1]))
        return problem_error(r->problem, "%s ends before '%s'; decimals have a point, as in 0.5", name,
                             shown);
    if (*end == '%')
        return problem_error(r->problem, "%s ends before '%s'; write a share as 0.95 or 95/100", name, shown);
    return problem_error(r->problem, "%s ends before '%s'; here an operator or a blank is missing", name,
                         shown);
}

static struct tree *parse_with(struct parse *parse, struct tree *value);

/* Returns true if the text ends in a number, which a unit may follow. */
static bool ends_in_number(const char *begin, const char *end)
{
    const char *c = end;
    while (c > begin && (isdigit((unsigned char)c[-1]) || c[-1] == '.'))
        c--;
    return c < end && (c == begin || (!isalnum((unsigned char)c[-1]) && c[-1] != '_'));
}

bool item_parse(struct reader *r, const struct argument *a, struct item *item)
{
    offer_value(r, a, false);
    struct parse p = {
        .text = r->at, .arena = r->arena, .no_unit = r->no_unit, .with = parse_with, .context = r};
    struct tree *tree = expression_parse(&p);
    *item = (struct item){.argument = a, .value = tree, .at = r->at};
    struct reader behind = *r;
    behind.at = tree ? skip_blanks(p.end) : p.end;
    if (!tree && p.end > r->at)
        offer_value(&behind, a, true);
    if (tree && ends_in_number(r->at, p.end))
        offer_kind(&behind, OFFER_UNIT);
    if (!tree)
        return r->problem->kind == PROBLEM_NONE &&
               expression_wrong(r->problem, PROBLEM_WRONG, r->text, a->name, p.end, p.message);
    bool ended = isspace((unsigned char)*p.end) || (command_ends(p.end) && *p.end != '#') || *p.end == '>' ||
                 (r->stops && strchr(r->stops, *p.end));
    if (!ended)
        return wrong_end(r, a->name, p.end);
    const char *next = skip_blanks(p.end);
    if (r->last && isalpha((unsigned char)*next) && next > p.end && !known_word(r, next))
        return false;
    r->at = p.end;
    if (r->unresolved)
        return true;
    struct reader inside = *r; /* of the text of a function, which is in no line */
    inside.text = NULL;
    struct resolver resolver = {.state = r->query->state,
                                .ans = r->query->ans,
                                .arena = r->arena,
                                .with = parse_with,
                                .context = &inside};
    if (!resolve(&resolver, tree))
        return r->problem->kind == PROBLEM_NONE &&
               expression_wrong(r->problem, PROBLEM_WRONG, r->text, a->name, resolver.at, resolver.message);
    domq_real number;
    return !r->evaluates || item_bind(item, r->text, r->query, NULL, &number, r->problem);
}

bool item_bind(const struct item *item, const struct text *text, const struct query *query,
               struct quantity *quantity, domq_real *number, struct problem *problem)
{
    struct quantity q = {.value = item->number};
    struct evaluation e;
    if (text && item->at)
        problem->place = text_column(text, item->at);
    if (item->value && !query_evaluate(query, &e, item->value, &q, problem))
        return problem->kind == PROBLEM_NONE &&
               expression_wrong(problem, e.of_value ? PROBLEM_NO_ANSWER : PROBLEM_WRONG, text,
                                item->argument->name, e.at, e.message);
    if (quantity)
        *quantity = q;
    *number = q.value;
    if (!item->value)
        return true;
    if (item->argument->kind == ARGUMENT_LENGTH && *item->at == '+')
        return problem_error(problem, "%s is the gap itself, not a change of it; leave out the '+'",
                             item->argument->name);
    return argument_check(query, item->argument, q, number, problem);
}

/* ---- with ---- */

const char *model_names(const void *context, int k)
{
    const struct parameter *p = session_parameters;
    (void)context;
    while (p->name && (p->setting || k-- > 0))
        p++;
    return p->name;
}

const struct parameter *parameter_parse(struct reader *r, const char *form)
{
    char message[NAMES_MESSAGE], shown[NAMES_SHOWN];
    bool usual;
    reader_place(r, r->at);
    offer_names(r, model_names, NULL);
    char *word = read_word(r, false);
    if (!word) {
        problem_error(r->problem, "%s", no_memory);
        return NULL;
    }
    const struct parameter *setting = parameter_find(word);
    int k = names_find(model_names, NULL, "parameter", word, message);
    const struct parameter *meant = k == NAMES_UNKNOWN ? parameter_by_synonym(word, &usual) : NULL;
    names_shown(word, shown);
    if (k >= 0)
        return parameter_find(model_names(NULL, k));
    if (meant && !setting)
        problem_error(r->problem, "unknown parameter '%s'; did you mean '%s'?", shown, meant->name);
    else if (setting && setting->setting)
        problem_error(r->problem,
                      "'%s' is a setting of the calculator; use a parameter of the model or an effect here",
                      shown);
    else if (*r->at == ',')
        problem_error(r->problem, "',' separates values, and not parameters; a blank is enough before the "
                                  "next parameter, as in 'r 1 1.5 3 s 0.3, 0.5'");
    else if (isalpha((unsigned char)*shown))
        problem_error(r->problem, "%s", message);
    else
        problem_error(r->problem, "'%s' is not the name of a parameter; %s", shown, form);
    return NULL;
}

/* Returns true if a unit of mass may follow a value of the parameter. */
static bool weighs(const struct parameter *p)
{
    return expression_unit(p->value->unit).mass != 0;
}

const struct item *item_parse_listed(struct reader *r, const struct parameter *p, struct item *item)
{
    const char *no_unit = r->no_unit;
    struct offer *e = reader_offer(r);
    if (e)
        e->parameter = p;
    r->no_unit = weighs(p) ? "s" : "sg";
    bool good = item_parse_value(r, p, 0, p->value->name, item);
    r->no_unit = no_unit;
    if (good && p->effect && !item->value && item->number == EFFECT_ON)
        item->number = p->value->usual;
    return good ? item : NULL;
}

/* Parses "NAME VALUE NAME VALUE ..." up to where the arguments end. Returns NULL after an error. */
static const struct assignment *assignments_parse(struct reader *r)
{
    static const char form[] = "'with' takes parameters and effects, as in 'rmax with q hollow d 0.1'";
    const struct assignment *first = NULL, **last = &first;
    for (int count = 0; !reader_ends(r); count++) {
        const struct parameter *p = parameter_parse(r, form);
        struct assignment *a = p ? arena_take(r->arena, sizeof *a) : NULL;
        if (p && count == ASSIGNED_MAX)
            problem_error(r->problem, "'with' takes %d parameters at most", ASSIGNED_MAX);
        if (!a || count == ASSIGNED_MAX)
            return NULL;
        r->at = skip_blanks(r->at);
        r->at = skip_blanks(r->at + (*r->at == '='));
        reader_place(r, r->at);
        if (reader_ends(r)) {
            problem_error(r->problem,
                          "the value of %s after 'with' is missing, as in 'rmax with q hollow d 0.1'",
                          p->name);
            return NULL;
        }
        a->parameter = p;
        if (!item_parse_listed(r, p, &a->item))
            return NULL;
        *last = a;
        last = &a->next;
    }
    if (!first) {
        reader_place(r, r->at);
        problem_error(r->problem, "%s", form);
    }
    return first;
}

/* Parses "with ..." behind a value in parentheses. */
static struct tree *parse_with(struct parse *p, struct tree *value)
{
    struct reader *outer = p->context, r = *outer;
    const char *at = p->end;
    r.at = skip_blanks(at + strlen("with"));
    r.stops = ")";
    r.unresolved = true;
    r.last = false;
    const struct assignment *with = assignments_parse(&r);
    struct tree *t = with ? arena_take(p->arena, sizeof *t) : NULL;
    if (!t)
        return NULL;
    p->end = r.at;
    *t = (struct tree){
        .kind = TREE_SYMBOL, .symbol = SYMBOL_WITH, .at = at, .refers = with, .child = value, .count = 1};
    return t;
}

bool question_with(const struct question *q, const struct query *query, struct state *state,
                   struct query *changed, struct problem *problem)
{
    struct assigned assigned[ASSIGNED_MAX];
    int count = 0;
    for (const struct assignment *a = q->with; a; a = a->next) {
        assigned[count].parameter = a->parameter;
        if (!item_bind(&a->item, q->text, query, NULL, &assigned[count++].value, problem))
            return false;
    }
    return query_with(query, assigned, count, state, changed, problem);
}

/* ---- Words ---- */

bool item_parse_value(struct reader *r, const struct parameter *p, int i, const char *name, struct item *item)
{
    const char *begin = r->at;
    if (p->words && i == 0)
        offer_names(r, parameter_offered, p);
    char message[NAMES_MESSAGE] = "", what[32], range[64];
    char *word = read_word(r, false);
    int k = -1;
    /* A word for a number may not hide a name: 'set q h' is the parameter h. */
    bool wordlike = word && *word && word[strspn(word, "abcdefghijklmnopqrstuvwxyz")] == '\0';
    if (word && p->words && i == 0) {
        snprintf(what, sizeof what, "value of %s", p->name);
        k = p->words_only || (wordlike && !is_value_name(r->query->state, word))
                ? names_find(parameter_words, p, what, word, message)
                : names_exact(parameter_words, p, word);
    }
    if (k >= 0) {
        *item = (struct item){.number = p->words[k].value, .at = begin};
        return true;
    }
    if (*message) {
        parameter_range(r->query->state, p, 0, range, sizeof range);
        return problem_error(r->problem, p->words_only ? "%s (%s is one of %s)" : "%s (%s is a number in %s)",
                             message, p->name, range);
    }
    r->at = begin;
    struct argument *a = arena_take(r->arena, sizeof *a);
    if (!a)
        return problem_error(r->problem, "%s", no_memory);
    *a = (struct argument){.name = name, .kind = ARGUMENT_OF, .of = p->name, .which = i};
    return item_parse(r, a, item);
}

/* Writes all names of a list. */
static void names_all(names_list *list, char all[128])
{
    const char *name;
    all[0] = '\0';
    for (int n = 0; (name = list(NULL, n)) != NULL; n++) {
        size_t used = strlen(all);
        snprintf(all + used, 128 - used, "%s%s", n ? ", " : "", name);
    }
}

bool item_parse_choice(struct reader *r, const struct argument *a, struct item *item)
{
    char message[NAMES_MESSAGE], shown[NAMES_SHOWN], all[128];
    bool usual;
    *item = (struct item){.at = r->at};
    offer_names(r, a->choices, NULL);
    const char *word = item->word = read_word(r, false);
    if (!word)
        return problem_error(r->problem, "%s", no_memory);
    int k = names_find(a->choices, NULL, a->of, word, message);
    item->number = k;
    if (k >= 0)
        return true;
    names_shown(word, shown);
    names_all(a->choices, all);
    if (!a->of)
        return problem_error(r->problem, "'%s' has no value; %s is an angle in [0, theta_c], or one of: %s",
                             shown, a->name, all);
    const struct parameter *meant = a->kind == ARGUMENT_EFFECT ? parameter_by_synonym(word, &usual) : NULL;
    if (meant && meant->effect && k != NAMES_CLOSE)
        return problem_error(r->problem, "unknown %s '%s'; did you mean '%s'?", a->of, shown, meant->name);
    if (k != NAMES_CLOSE)
        return problem_error(r->problem, "unknown %s '%s'; use one of: %s", a->of, shown, all);
    return problem_error(r->problem, "%s", message);
}

/* Parses one of the names, whose value is -1 - its number, or an angle. */
static bool place_parse(struct reader *r, const struct argument *a, struct item *item)
{
    char message[NAMES_MESSAGE];
    const char *begin = r->at;
    offer_names(r, a->choices, NULL);
    char *name = read_word(r, false);
    bool letters = name && *name && name[strspn(name, "abcdefghijklmnopqrstuvwxyz")] == '\0' &&
                   !is_value_name(r->query->state, name);
    int place = !name     ? -1
                : letters ? names_find(a->choices, NULL, a->of, name, message)
                          : names_exact(a->choices, NULL, name);
    if (place >= 0) {
        *item = (struct item){.number = -1 - place, .at = begin};
        return true;
    }
    r->at = begin;
    return letters ? item_parse_choice(r, a, item) : item_parse(r, a, item);
}

/* Returns true if a word is a file's name, and not the beginning of an expression. */
static bool names_file(const struct state *state, const char *word)
{
    size_t length = strlen(word);
    return strchr("\"./~", *word) || (length > 4 && strcmp(word + length - 4, ".csv") == 0) ||
           (isalpha((unsigned char)*word) && !strchr(word, '(') && !is_value_name(state, word));
}

/* Skips what can be between a parameter and its value: 'set r = 2', 'set r to 2'. */
static void skip_equals(struct reader *r)
{
    size_t n = *r->at == '=' ? 1 : strncmp(r->at, "to", 2) == 0 && isspace((unsigned char)r->at[2]) ? 2 : 0;
    r->at = skip_blanks(r->at + n);
    reader_place(r, r->at);
}

/* Parses a value for the parameter that the question names, or the file instead of its first value. */
static bool setting_parse(struct reader *r, struct question *q, int i)
{
    const struct parameter *p = q->parameter;
    const struct domq_effect_argument *of = parameter_value(p, i - 1);
    struct item *item = &q->item[i];
    char usage[USAGE_SIZE], shown[NAMES_SHOWN], word[PATH_MAX];
    if (i == 1)
        skip_equals(r);
    snprintf(word, sizeof word, "%.*s", (int)strcspn(r->at, " \t;>#"), r->at);
    const struct item *before = &q->item[1];
    bool worded = i > 1 && !before->value && parameter_word(p, before->number);
    if (!of || (i > 1 && before->word) || worded)
        return problem_error(r->problem, "'%s' is one argument too many; usage: %s%s",
                             names_shown(word, shown), p->effect ? "effect " : "",
                             p->effect ? effect_usage(p->which, usage) : command_usage(q->command, usage));
    if (of->or_file && names_file(r->query->state, word) && names_exact(parameter_words, p, word) < 0) {
        *item = (struct item){.at = r->at};
        item->word = read_file(r);
        return item->word || problem_error(r->problem, "%s", unclosed);
    }
    if (of->or_file)
        offer_kind(r, OFFER_FILE);
    r->last = !parameter_value(p, i);
    return item_parse_value(r, p, i - 1, of->name, item);
}

/* 'help sin', 'help cm', 'help units' are about expressions. */
static bool is_expression_topic(const char *word)
{
    static const char *const topics[] = {"ans",         "unit",     "units",    "expression",
                                         "expressions", "function", "functions"};
    for (size_t i = 0; i < sizeof topics / sizeof *topics; i++)
        if (strcmp(topics[i], word) == 0)
            return true;
    return is_value_name(NULL, word) || names_exact(expression_units, NULL, word) >= 0;
}

/* Reads a word that also ends before one of these letters; a '?' after it is skipped. */
static char *read_name(struct reader *r, const char *ends)
{
    const char *stops = r->stops;
    r->stops = ends;
    char *word = read_word(r, false);
    r->stops = stops;
    const char *next = skip_blanks(r->at);
    if (*next == '?')
        r->at = next + strspn(next, "?");
    return word;
}

/* Parses the name of a parameter or a topic; a variable is one where no value follows. */
static bool topic_parse(struct reader *r, const struct argument *a, struct question *q, int i)
{
    char message[NAMES_MESSAGE];
    bool topic = a->kind == ARGUMENT_TOPIC, valued = i + 1 < ARGUMENTS_MAX && a[1].kind == ARGUMENT_VALUE,
         usual;
    offer_names(r, a->choices, NULL);
    if (!valued)
        offer_kind(r, OFFER_VARIABLE);
    const char *word = q->item[i].word = read_name(r, valued ? "=" : "?");
    if (!word)
        return problem_error(r->problem, "%s", no_memory);
    const struct variable *v = variable_find(&r->query->state->variables, word);
    if (v && valued)
        return problem_error(r->problem, "'%s' is a variable; '%s = VALUE' changes it", word, word);
    if (v) {
        q->variable = v;
        return true;
    }
    int k = names_find(a->choices, NULL, a->of, word, message);
    if (k < 0 && topic && is_expression_topic(word))
        k = names_exact(a->choices, NULL, "print");
    q->item[i].number = k;
    if (k < 0 && topic && topic_meant(word, 0))
        return true;
    q->parameter = k >= 0 && !topic ? &session_parameters[k] : NULL;
    const struct parameter *meant = k < 0 ? parameter_by_synonym(word, &usual) : NULL;
    if (meant && (usual || k == NAMES_UNKNOWN))
        return problem_error(r->problem, "unknown %s '%s'; did you mean '%s'?", a->of, word, meant->name);
    return k >= 0 || problem_error(r->problem, "%s", message);
}

/* Parses the name of an effect, which also ends before a '='. */
static bool effect_parse(struct reader *r, const struct argument *a, struct question *q, int i)
{
    const char *stops = r->stops;
    r->stops = "=";
    bool good = item_parse_choice(r, a, &q->item[i]);
    r->stops = stops;
    if (good)
        q->parameter = parameter_find(a->choices(NULL, (int)q->item[i].number));
    return good;
}

/* ---- Questions ---- */

static bool argument_parse(struct reader *r, struct question *q, int i)
{
    const struct argument *a = &q->command->argument[i];
    struct item *item = &q->item[i];
    reader_place(r, r->at);
    item->at = r->at;
    r->last = i + 1 == ARGUMENTS_MAX || !a[1].kind || a[1].kind == ARGUMENT_UNIT;
    switch (a->kind) {
    case ARGUMENT_OF:
        return item_parse_value(r, parameter_find(a->of), 0, a->name, item);
    case ARGUMENT_VALUE:
        return setting_parse(r, q, i);
    case ARGUMENT_PARAMETER:
    case ARGUMENT_TOPIC:
        return topic_parse(r, a, q, i);
    case ARGUMENT_CHOICE:
        return item_parse_choice(r, a, item);
    case ARGUMENT_PLACE:
        return place_parse(r, a, item);
    case ARGUMENT_EFFECT:
        return effect_parse(r, a, q, i);
    case ARGUMENT_WORD:
    case ARGUMENT_FILE:
        offer_names(r, a->choices, NULL);
        if (a->kind == ARGUMENT_FILE)
            offer_kind(r, OFFER_FILE);
        item->word = a->kind == ARGUMENT_FILE ? read_file(r) : read_word(r, true);
        return item->word ? *item->word || problem_error(r->problem, "%s is missing", a->name)
                          : problem_error(r->problem, "%s", unclosed);
    case ARGUMENT_GRID:
    case ARGUMENT_COMMAND:
    case ARGUMENT_WORDS:
    case ARGUMENT_UNIT:
        return a->parse(r, q);
    case ARGUMENT_REST:
        item->word = arena_text(r->arena, r->at, strlen(r->at));
        r->at += strlen(r->at);
        return item->word || problem_error(r->problem, "%s", no_memory);
    default:
        return item_parse(r, a, item);
    }
}

/* Describes a problem where '--check' is here: a command with a verdict has 'assert' for that. */
static bool no_check(const struct reader *r, const struct command *c)
{
    char usage[USAGE_SIZE];
    return !c->holds || strncmp(r->at, "--check", 7) != 0 ||
           problem_error(r->problem, "commands have no options; 'assert %s' is an error unless it is true",
                         command_usage(c, usage));
}

/* Parses "with NAME VALUE ..." behind the arguments. */
static bool with_parse(struct reader *r, struct question *q)
{
    if (!word_is_next(r, "with"))
        return true;
    reader_place(r, r->at);
    if (!q->command->columns || q->command->act || q->command->changes)
        return problem_error(
            r->problem, "'with' goes behind a command that only answers, such as 'rmax', and '%s' %s",
            q->command->name, q->command->changes ? "changes something" : "gives no numbers");
    reader_takes(r, "with");
    r->last = false;
    return (q->with = assignments_parse(r)) != NULL;
}

/* Describes what follows the arguments, where nothing may. */
static bool end_check(struct reader *r, const struct command *c)
{
    char usage[USAGE_SIZE], shown[NAMES_SHOWN];
    reader_place(r, r->at);
    if (!no_check(r, c))
        return false;
    if (*r->at == '|')
        return problem_error(r->problem, "pipes are not supported; 'COMMAND > FILE' writes a file");
    if (command_ends(r->at) || *r->at == '>' || (r->stops && strchr(r->stops, *r->at)))
        return true;
    const char *word = read_word(r, false);
    return problem_error(r->problem, "'%s' is one argument too many; usage: %s",
                         names_shown(word ? word : "", shown), command_usage(c, usage));
}

/* Parses the arguments, and what holds for them alone. */
static bool arguments_parse(struct reader *r, struct question *q)
{
    char usage[USAGE_SIZE];
    const struct command *c = q->command;
    q->text = r->text;
    for (q->count = 0; q->count < ARGUMENTS_MAX && c->argument[q->count].kind; q->count++) {
        bool ends = reader_ends(r);
        if (ends && c->argument[q->count].kind != ARGUMENT_REST)
            break;
        struct offer *e = reader_offer(r);
        if (e) {
            e->command = c;
            e->argument = q->count;
            e->parameter = q->parameter;
        }
        if (!no_check(r, c) || !argument_parse(r, q, q->count))
            return false;
    }
    r->at = skip_blanks(r->at);
    reader_place(r, r->at);
    if (!no_check(r, c))
        return false;
    const struct argument *missing = q->count < ARGUMENTS_MAX ? &c->argument[q->count] : NULL;
    if (missing && missing->kind && !missing->optional && *r->at != '|')
        return problem_error(r->problem, "%s is missing; usage: %s", missing->name, command_usage(c, usage));
    return with_parse(r, q) && end_check(r, c);
}

bool question_parse(struct reader *r, struct question *q)
{
    const char *outer = r->problem->command;
    if (strcmp(q->command->name, "print") != 0) /* an expression has no command that was typed */
        r->problem->command = q->command->name;
    bool good = arguments_parse(r, q);
    if (good)
        r->problem->command = outer;
    return good;
}

bool command_parse(struct reader *r, struct question *q)
{
    r->stops = r->no_unit = NULL;
    r->unresolved = false;
    *q = (struct question){.key = -1, .command = read_form(r)};
    if (!q->command && r->problem->kind == PROBLEM_NONE) {
        offer_kind(r, OFFER_VARIABLE);
        q->command = read_command(r, command_names);
    }
    if (!q->command)
        return false;
    r->problem->command = q->command->name;
    return question_parse(r, q);
}

bool question_bind(const struct question *q, const struct query *query, struct arguments *given,
                   struct problem *problem)
{
    *given = (struct arguments){
        .count = q->count, .parameter = q->parameter, .variable = q->variable, .own = q->own};
    for (int i = 0; i < q->count; i++) {
        const struct argument *a = &q->command->argument[i];
        const struct item *item = &q->item[i];
        given->word[i] = item->word;
        given->column[i] = item->at ? text_column(q->text, item->at) : 0;
        if (!item_bind(item, q->text, query, &given->quantity[i], &given->number[i], problem) ||
            (a->bind && !a->bind(q, query, given, problem)))
            return false;
    }
    return true;
}

bool question_ask(const struct question *q, const struct query *query, struct answer *answer,
                  struct problem *problem)
{
    struct state state;
    struct query changed, asked = *query;
    struct arguments given = {.count = 0};
    const char *command = problem->command;
    if (strcmp(q->command->name, "print") != 0)
        problem->command = q->command->name;
    if (q->with) {
        if (!question_with(q, query, &state, &changed, problem))
            return false;
        asked = changed;
    }
    asked.given = &given;
    bool done =
        command_allowed(query->means, q->command, problem) && question_bind(q, &asked, &given, problem);
    if (done) {
        problem->place = 0;
        done = q->command->run(&asked, answer, problem);
    }
    arguments_free(&given);
    if (done)
        problem->command = command;
    return done;
}

void arguments_free(struct arguments *given)
{
    if (given->own_free)
        given->own_free(given->own);
}

/* ---- Questions with their command ---- */

/* Finds the command and the key that a word names; -1 is no key. Returns NULL if it names no command that
 * answers. */
static const struct command *command_named(const char *word, size_t length, int *key)
{
    char name[64];
    if (length >= sizeof name)
        return NULL;
    snprintf(name, sizeof name, "%.*s", (int)length, word);
    char *dot = strchr(name, '.');
    if (dot)
        *dot = '\0';
    const struct command *c = command_find(name);
    if (!c || !c->columns || !c->columns->key)
        return NULL;
    *key = dot ? names_exact(command_keys, c, dot + 1) : c->principal ? command_principal(c) : -1;
    return c;
}

bool question_needs_number(const struct question *q, struct problem *problem)
{
    const struct command *c = q->command;
    if (q->key >= 0 || strcmp(c->name, "print") == 0)
        return true;
    char keys[256] = "";
    for (int n = 0, k = 0; c->columns[k].key && n < (int)sizeof keys; k++)
        n +=
            snprintf(keys + n, sizeof keys - (size_t)n, "%s%s.%s", n ? ", " : "", c->name, c->columns[k].key);
    return problem_error(problem, "which number of '%s'? One of %s", c->name, keys);
}

const char *question_name(struct reader *r, const char *begin, const char *end)
{
    char typed[NAMES_SHOWN], shown[NAMES_SHOWN];
    while (end > begin && isspace((unsigned char)end[-1]))
        end--;
    int length = end - begin < NAMES_SHOWN ? (int)(end - begin) : NAMES_SHOWN - 1;
    snprintf(typed, sizeof typed, "%.*s", length, begin);
    names_shown(typed, shown);
    const char *name = arena_text(r->arena, shown, strlen(shown));
    return name ? name : "";
}

const char *question_names(const void *context, int k)
{
    const char *name;
    for (int i = 0; (name = command_names(context, i)) != NULL; i++) {
        const struct command *c = command_find(name);
        if ((c->principal || c->holds) && !c->unswept && k-- == 0)
            return name;
    }
    return NULL;
}

bool question_parse_any(struct reader *r, struct question *q, bool number)
{
    const char *begin = r->at;
    size_t length = strspn(begin, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.");
    int key = -1;
    offer_names(r, question_names, NULL);
    const char *next = skip_blanks(begin + length);
    const struct command *c = command_named(begin, length, &key);
    struct reader behind = *r;
    behind.at = next;
    bool alone = next > begin + length || reader_ends(&behind);
    *q = (struct question){.command = c && alone && !goes_on(next) ? c : command_find("print"), .key = -1};
    if (q->command == c) {
        q->key = key;
        r->at = begin + length;
        reader_named(r, begin, r->at);
        if (c->unswept)
            return problem_error(r->problem, "'%s' is not varied: %s", c->name, c->unswept);
        if ((number || !c->holds) && !question_needs_number(q, r->problem))
            return false;
    }
    bool good = question_parse(r, q);
    q->name = question_name(r, begin, r->at);
    return good;
}

bool question_value(const struct question *q, const struct query *query, struct quantity *value,
                    struct problem *problem)
{
    struct cell kept[ANSWER_CELLS] = {{.kind = CELL_NONE}};
    const struct command *c = q->command;
    struct answer answer = {
        .style = state_style(query->state), .columns = c->columns, .rows = c->rows, .kept = kept};
    if (!question_ask(q, query, &answer, problem))
        return false;
    *value = answer.value;
    if (answer.printed)
        return true;
    if (!question_needs_number(q, problem))
        return false;
    struct cell cell = kept[q->key];
    const char *key = c->columns[q->key].key;
    if (cell.kind == CELL_WORD || cell.kind == CELL_FLAG)
        return problem_error(problem, "%s.%s is a word, and not a number", c->name, key);
    if (cell.kind == CELL_NONE)
        return problem_no_answer(problem, "%s.%s does not exist here: '%s' says why", c->name, key, c->name);
    *value = expression_unit(c->columns[q->key].unit);
    value->value *= cell.number;
    return true;
}
