/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/question.h"
#include "session/parameters.h"
#include <ctype.h>
#include <limits.h>
#include <string.h>
#include <strings.h>

/* ---- Parameters ---- */

/* Returns true if the word looks like the path of a file rather than the beginning of an expression. */
static bool is_path(const struct reader *r, const char *word)
{
    const size_t length = strlen(word);
    return strchr("\"./~", *word) || (length > 4 && strcasecmp(word + length - 4, ".csv") == 0) ||
           (isalpha((unsigned char)*word) && !strchr(word, '(') && !is_value_name(r->query->state, word));
}

/* Reports a word that is too much. After a value, it may be meant as a unit. */
static bool too_many(struct reader *r, const struct question *q, const char *word, const char *prefix,
                     const char *usage)
{
    const bool after_value = q->count > 0 && q->item[q->count - 1].value && isalpha((unsigned char)*word);
    const char *unit = after_value ? names_closest(expression_units, NULL, word) : NULL;
    if (unit && strcmp(unit, word) != 0)
        return problem_error(r->problem, "'%s' is not a unit; did you mean '%s'?", names_shown(word), unit);
    return problem_error(r->problem, "'%s' is one argument too many; usage: %s%s", names_shown(word), prefix,
                         usage);
}

/* The user may leave out optional values of an effect. Returns true if value i is optional and has been left
 * out, because the word belongs to a later value. */
static bool word_is_later(const struct parameter *p, int i, const char *word)
{
    const struct domq_effect_argument *value = parameter_argument(p, i - 1);
    for (bool is_later = false; value && value->optional; value = parameter_argument(p, i++), is_later = true)
        for (const char *const *w = value->words; is_later && w && *w; w++)
            if (strcmp(*w, word) == 0)
                return true;
    return false;
}

/* Parses argument i, a value of question->parameter. For some parameters, the value may be a file. */
static bool setting_parse(struct reader *r, struct question *q, int i)
{
    const struct parameter *p = q->parameter;
    const struct domq_effect_argument *value = parameter_argument(p, i - 1);
    struct item *item = &q->item[i], *first = &q->item[1];
    char word[PATH_MAX];
    /* Between the name and the value, there may be '=' or 'to', as in 'set r = 2' and 'set r to 2'. */
    if (i == 1) {
        bool has_to = strncmp(r->at, "to", 2) == 0 && isspace((unsigned char)r->at[2]);
        r->at = skip_blanks(r->at + (*r->at == '=' ? 1 : has_to ? 2 : 0));
        reader_place(r, r->at);
    }
    snprintf(word, sizeof word, "%.*s", (int)strcspn(r->at, " \t;>#"), r->at);
    bool is_word = !first->value && parameter_word(p, first->number);
    if (!value || (i > 1 && (first->word || is_word)))
        return p->effect ? too_many(r, q, word, "set ", parameter_usage(p))
                         : too_many(r, q, word, "", command_usage(q->command));
    if (value->or_file)
        offer_kind(r, OFFER_FILE);
    if (value->or_file && names_exact(parameter_words, p, word) < 0 && is_path(r, word)) {
        *item = (struct item){.at = r->at};
        item->word = read_file(r);
        return item->word != NULL;
    }
    if (word_is_later(p, i, word)) {
        *item = (struct item){.number = value->usual, .at = r->at};
        return true;
    }
    return item_parse_value(r, p, i - 1, item);
}

/* Parses the name of a parameter. Variables are accepted if no value follows. */
static bool name_parse(struct reader *r, const struct argument *a, struct question *q, int i)
{
    char message[NAMES_MESSAGE];
    const char *outer = r->stops;
    const bool has_value = i + 1 < ARGUMENTS_MAX && a[1].kind == ARGUMENT_VALUE;
    offer_names(r, a->choices, NULL);
    if (!has_value)
        offer_kind(r, OFFER_VARIABLE);
    r->stops = has_value ? "=" : outer;
    const char *word = q->item[i].word = read_word(r, WORD_BARE);
    r->stops = outer;
    if (!word)
        return false;
    q->variable = variable_find(&r->query->state->variables, word);
    if (q->variable)
        return !has_value ||
               problem_error(r->problem, "'%s' is a variable; '%s = VALUE' changes it", word, word);
    const int k = parameter_search(a->choices, a->noun, word, message);
    q->item[i].number = k;
    q->parameter = k >= 0 ? parameter_find(a->choices(NULL, k)) : NULL; /* 'show all' names none */
    return k >= 0 || problem_error(r->problem, "%s", message);
}

/* ---- All arguments ---- */

static bool argument_parse(struct reader *r, struct question *q, int i)
{
    const struct argument *a = &q->command->argument[i];
    struct item *item = &q->item[i];
    reader_place(r, r->at);
    item->at = r->at;
    switch (a->kind) {
    case ARGUMENT_VALUE:
        return setting_parse(r, q, i);
    case ARGUMENT_PARAMETER:
        return name_parse(r, a, q, i);
    case ARGUMENT_FILE:
        offer_kind(r, OFFER_FILE);
        item->word = read_file(r);
        break;
    case ARGUMENT_REST:
        item->word = reader_copy(r, r->at, strlen(r->at));
        r->at += strlen(r->at);
        return item->word != NULL;
    default:
        return a->parse ? a->parse(r, q) : item_parse(r, a, item);
    }
    return item->word && (*item->word || problem_error(r->problem, "%s is missing", a->name));
}

/* Returns true if there are no more arguments. Otherwise, sets r->problem. */
static bool end_check(struct reader *r, const struct question *q)
{
    reader_place(r, r->at);
    if (reader_ends(r) && !word_is_next(r, "with"))
        return true;
    const char *word = read_word(r, WORD_BARE);
    return too_many(r, q, word ? word : "", "", command_usage(q->command));
}

/* Parses "NAME VALUE NAME VALUE ..." after 'with'. */
static bool with_parse(struct reader *r, struct question *q)
{
    static const char form[] = "'with' takes parameters and effects, as in 'rmax with q hollow d 0.1'";
    q->with = reader_memory(r, ASSIGNED_MAX * sizeof *q->with);
    while (q->with && !reader_ends(r)) {
        const char *outer = r->stops;
        r->stops = "="; /* as in 'with s=0.3' */
        const struct parameter *p = parameter_parse(r, form);
        r->stops = outer;
        if (!p)
            return false;
        if (q->assigned == ASSIGNED_MAX)
            return problem_error(r->problem, "'with' takes at most %d parameters", ASSIGNED_MAX);
        r->at = skip_blanks(r->at);
        r->at = skip_blanks(r->at + (*r->at == '='));
        reader_place(r, r->at);
        if (reader_ends(r))
            return problem_error(r->problem, "the value of %s after 'with' is missing; %s", p->name, form);
        q->with[q->assigned].parameter = p;
        if (!item_parse_listed(r, p, &q->with[q->assigned++].item))
            return false;
    }
    reader_place(r, r->at);
    return q->assigned > 0 || (q->with && problem_error(r->problem, "%s", form));
}

/* Replaces the error of what follows 'with' if an 'and' before a parameter caused it. */
static bool and_check(struct reader *r, const char *with)
{
    const char *at = strstr(with, " and ");
    char name[32];
    if (at && name_copy(at + 5, name_length(at + 5), name, sizeof name) && parameter_find(name) && r->text &&
        text_column(r->text, at) < r->problem->column) {
        r->problem->kind = PROBLEM_NONE;
        reader_place(r, at + 1);
        problem_error(r->problem, "unexpected 'and'; after 'with', separate values by blanks, without 'and'");
    }
    return false;
}

static bool arguments_parse(struct reader *r, struct question *q)
{
    const struct command *c = q->command;
    q->text = r->text;
    for (q->count = 0; q->count < ARGUMENTS_MAX && c->argument[q->count].kind; q->count++) {
        if (reader_ends(r) && c->argument[q->count].kind != ARGUMENT_REST)
            break;
        struct offer *o = reader_offer(r);
        if (o) {
            o->command = c;
            o->parameter = q->parameter;
        }
        const struct command *variant =
            q->count == 1 && c->typed.variant ? command_find(c->typed.variant) : NULL;
        if (variant && reader_takes(r, variant->name)) {
            q->command = c = variant;
            r->problem->command = c->name;
            break;
        }
        if (!argument_parse(r, q, q->count))
            return false;
    }
    r->at = skip_blanks(r->at);
    reader_place(r, r->at);
    const struct argument *missing = q->count < ARGUMENTS_MAX ? &c->argument[q->count] : NULL;
    if (missing && missing->kind && !missing->optional)
        return problem_error(r->problem, "%s is missing; usage: %s", missing->name, command_usage(c));
    if (!word_is_next(r, "with"))
        return end_check(r, q);
    if (!c->columns || c->act || c->access.changes)
        return problem_error(
            r->problem, "'with' can only follow a command that computes an answer, such as 'rmax'; '%s' %s",
            c->name, c->access.changes ? "changes something" : "gives no numbers");
    reader_takes(r, "with");
    const char *with = r->at;
    return (with_parse(r, q) || and_check(r, with)) && end_check(r, q);
}

/* ---- Questions ---- */

bool question_parse(struct reader *r, struct question *q)
{
    const char *outer = r->problem->command;
    if (!q->command->is_print)
        r->problem->command = q->command->name;
    bool good = arguments_parse(r, q);
    if (good)
        r->problem->command = outer;
    return good;
}

bool command_parse(struct reader *r, struct question *q)
{
    r->stops = r->no_unit = NULL;
    *q = (struct question){.key = -1, .command = command_read(r)};
    if (!q->command)
        return false;
    /* a text in double quotes alone is written as 'echo' writes it */
    const char *quote = skip_blanks(r->at), *end = *quote == '"' ? text_quote(quote) : NULL;
    if (q->command->is_print && end && (command_ends(skip_blanks(end)) || *skip_blanks(end) == '>'))
        q->command = command_find("echo");
    r->problem->command = q->command->name;
    r->details = q->command->brief != NULL;
    if (!question_parse(r, q))
        return false;
    q->details = r->details && word_is_next(r, "details");
    r->details = false;
    if (!q->details)
        return true;
    r->at = skip_blanks(r->at + strlen("details"));
    return end_check(r, q);
}
/* ---- Questions ---- */

bool question_bind(const struct question *q, const struct query *query, struct call *call,
                   struct problem *problem)
{
    struct assigned assigned[ASSIGNED_MAX];
    call->given = (struct arguments){.count = q->count, .bound = q->parsed, .question = q};
    call->query = *query;
    if (!command_allowed(query->run_context, q->command, problem))
        return false;
    for (int i = 0; i < q->assigned; i++) {
        struct quantity typed;
        assigned[i] = (struct assigned){.parameter = q->with[i].parameter};
        if (!item_bind(&q->with[i].item, q->text, query, &typed, &assigned[i].value, problem))
            return false;
        assigned[i].length = share_length(q->with[i].parameter, &typed);
    }
    if (q->assigned > 0 && !query_with(query, assigned, q->assigned, &call->state, &call->query, problem))
        return false;
    call->query.given = &call->given;
    for (int i = 0; i < q->count; i++) {
        const struct argument *a = &q->command->argument[i];
        const struct item *item = &q->item[i];
        call->given.word[i] = item->word;
        call->given.column[i] = item->at ? text_column(q->text, item->at) : 0;
        if (!item_bind(item, q->text, &call->query, &call->given.quantity[i], &call->given.number[i],
                       problem) ||
            (a->bind && !a->bind(q, &call->query, &call->given, problem)))
            return false;
    }
    return true;
}

void *arguments_take(struct arguments *given, size_t size, const struct query *query, struct problem *problem)
{
    given->bound = arena_take(&given->memory, size);
    if (!given->bound)
        problem_status(problem, query->scene, DOM_NO_MEMORY);
    return given->bound;
}
