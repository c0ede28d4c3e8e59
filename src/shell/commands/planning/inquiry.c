/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/planning/inquiry.h"
#include "language/quad.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- Reading ---- */

/* Returns the length of a word that may be a command, with a dot and a key after it. */
static size_t word_length(const char *c)
{
    return strspn(c, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.");
}

/* Finds the command and the key that a word names; false if it names none. */
static bool command_named(const char *word, size_t length, struct inquiry *q)
{
    char name[64];
    snprintf(name, sizeof name, "%.*s", (int)(length < sizeof name ? length : sizeof name - 1), word);
    char *dot = strchr(name, '.');
    if (dot)
        *dot = '\0';
    const struct command *c = command_find(name);
    if (!c || !c->columns || !c->columns->key)
        return false;
    q->command = c;
    q->key = dot ? names_exact(command_keys, c, dot + 1) : c->principal ? command_principal(c) : -1;
    return true;
}

/* Keeps what was typed, without blanks at its end. */
static void name_keep(struct inquiry *q, const char *begin, const char *end)
{
    char typed[NAMES_SHOWN];
    while (end > begin && isspace((unsigned char)end[-1]))
        end--;
    int length = end - begin < NAMES_SHOWN ? (int)(end - begin) : NAMES_SHOWN - 1;
    snprintf(typed, sizeof typed, "%.*s", length, begin);
    names_shown(typed, q->name);
}

static bool key_missing(struct session *session, const struct inquiry *q)
{
    char keys[256] = "";
    const struct column *c = q->command->columns;
    for (int n = 0; c->key && n < (int)sizeof keys; c++)
        n += snprintf(keys + n, sizeof keys - (size_t)n, "%s%s.%s", n ? ", " : "", q->command->name, c->key);
    return session_error(session, "which number of '%s'? One of %s", q->command->name, keys);
}

bool inquiry_read(struct reader *r, struct inquiry *q)
{
    struct session *session = r->session;
    const char *begin = r->at, *end = text_end(begin, ";>");
    size_t length = word_length(begin);
    const char *next = skip_blanks(begin + length);
    bool ends = next >= end || (next > begin + length && !strchr("+-*/^)", *next));
    *q = (struct inquiry){.text = r->text, .at = begin};
    name_keep(q, begin, end);
    if (ends && command_named(begin, length, q)) {
        if (q->command->unswept)
            return session_error(session, "'%s' is not varied: %s", q->command->name, q->command->unswept);
        if (q->key < 0 || q->key >= ANSWER_CELLS)
            return key_missing(session, q);
        q->at = begin + length;
    }
    r->at = end;
    return true;
}

const char *inquiry_names(const void *context, int k)
{
    const char *name;
    for (int i = 0; (name = command_names(context, i)) != NULL; i++) {
        const struct command *c = command_find(name);
        if ((c->principal || c->holds) && !c->unswept && k-- == 0)
            return name;
    }
    return NULL;
}

bool inquiry_read_left(struct reader *r, struct inquiry *q)
{
    const char *end = text_end(r->at, "=;>");
    *q = (struct inquiry){.text = r->text, .at = r->at, .stops = "="};
    name_keep(q, r->at, end);
    r->at = end;
    return true;
}

/* ---- Asking ---- */

/* Runs the command in a session that is a copy; false: no answer. */
static bool ask_command(struct session *point, struct probe *p, struct quantity *value)
{
    const struct inquiry *q = p->inquiry;
    const struct command *c = q->command;
    struct cell kept[ANSWER_CELLS] = {{.kind = CELL_NONE}};
    struct answer answer = {.style = session_style(point),
                            .columns = c->columns,
                            .rows = c->rows,
                            .kept = p->verdict ? NULL : kept};
    struct call call = {.answer = &answer};
    struct reader r = {.session = point, .text = q->text, .at = q->at};
    point->command = c->name;
    bool done = command_allowed(point, c) && read_arguments(&r, c, &call) && c->run(point, &call);
    call_free(&call);
    *value = (struct quantity){.value = answer.holds == ANSWER_YES ? 1 : -1};
    if (!done || p->verdict)
        return done && (answer.holds != ANSWER_OPEN || session_no_answer(point, "nothing is decided"));
    struct cell cell = kept[q->key];
    if (cell.kind == CELL_WORD || cell.kind == CELL_FLAG)
        return session_error(point, "%s.%s is a word, and not a number", c->name, c->columns[q->key].key);
    if (cell.kind == CELL_NONE)
        return session_no_answer(point, "%s.%s does not exist here: '%s' says why", c->name,
                                 c->columns[q->key].key, c->name);
    *value = expression_unit(c->columns[q->key].unit);
    value->value *= cell.number;
    return true;
}

/* Evaluates the expression in a session that is a copy. */
static bool ask_expression(struct session *point, const struct inquiry *q, struct quantity *value)
{
    domq_real number;
    struct reader r = {
        .session = point, .text = q->text, .at = q->at, .stops = q->stops, .last = q->stops == NULL};
    point->column = reader_column(&r, r.at);
    if (!read_quantity(&r, &(struct argument){.name = "ANSWER", .kind = ARGUMENT_ANY}, value, &number))
        return false;
    r.at = skip_blanks(r.at);
    return command_ends(r.at) || *r.at == '>' || (q->stops && strchr(q->stops, *r.at)) ||
           session_error(point,
                         "ANSWER is a command with its arguments, or an expression such as "
                         "'rmax(0.3)'; it ends before '%.20s'",
                         r.at);
}

/* Gives a copy of the session the value; false: the value is not in the range, or its effect not possible. */
static bool probe_put(struct session *point, const struct parameter *p, domq_real value)
{
    if (value != EFFECT_OFF && !parameter_check(point, p, 0, value))
        return false;
    if (p->effect && value != EFFECT_OFF && !effect_needs(point, p->which))
        return false;
    parameter_put(point, p, value);
    return true;
}

domq_real probe_at(struct probe *p, domq_real value)
{
    struct session point = *p->session;
    p->error = (struct captured_error){.text = ""};
    p->wrong = false;
    point.captured_error = &p->error;
    point.threads = 1;
    point.shard.parts = 0;
    struct quantity answer = {.value = 0};
    bool put = !p->parameter || probe_put(&point, p->parameter, value);
    bool done = put && (p->inquiry->command ? ask_command(&point, p, &answer)
                                            : ask_expression(&point, p->inquiry, &answer));
    p->wrong = put && !done && !p->error.no_answer;
    if (!done)
        return DOMQ_NAN;
    p->unit = answer;
    return isfinite(answer.value) ? answer.value : DOMQ_NAN;
}

bool probe_report(struct session *session, const struct probe *p)
{
    if (dom_raised(session->compute.interrupt))
        return session_status(session, DOM_INTERRUPTED);
    const char *command = session->command;
    session->column = p->error.column;
    session->command = p->error.command ? p->error.command : command;
    if (p->error.no_answer)
        session_no_answer(session, "%s", p->error.text);
    else
        session_error(session, "%s", p->error.text);
    session->command = command;
    return false;
}
