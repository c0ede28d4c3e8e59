/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From text to commands: lines, arguments, expressions in the session's names, files behind '>'. */
#include "command.h"
#include "effects.h"
#include "redirect.h"
#include "terminal.h"
#include "text.h"
#include "wide.h"
#include <ctype.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include <readline/tilde.h>

/* One line that is being run. */
struct reader {
    struct session *session;
    struct text *text;
    const char *at;
    bool last; /* the argument that is read is the command's last */
};

static int column_of(const struct reader *r, const char *place)
{
    return text_column(r->text, place);
}

static const char *skip_blanks(const char *c)
{
    return c + strspn(c, " \t\r\f\v");
}

/* Does the command end here?  Comments begin at a blank. */
static bool ends(const char *c)
{
    return *c == '\0' || *c == ';' || *c == '#';
}

/* ---- The names of a session in expressions ---- */

static bool cell_quantity(struct expression *e, const char *name, const struct command *c, int i,
                          const struct cell *cells, struct quantity *result)
{
    if (cells[i].kind == CELL_WORD)
        return expression_fail(e, "%s.%s is a word, '%s', and no number", name, c->columns[i].key,
                               cells[i].word);
    if (cells[i].kind == CELL_NONE)
        return expression_fail(e, "%s.%s does not exist here: '%s' says why", name, c->columns[i].key,
                               c->name);
    *result = expression_unit(c->columns[i].unit);
    result->value *= cells[i].number;
    return true;
}

static bool key_quantity(struct expression *e, const char *name, const char *key, const struct command *c,
                         const struct cell *cells, struct quantity *result)
{
    char message[NAMES_MESSAGE], what[64];
    int i = c->principal;
    if (key) {
        snprintf(what, sizeof what, "key of %s", c->name);
        i = names_find(command_keys, c, what, key, message);
        if (i < 0)
            return expression_fail(e, "%s", message);
    }
    return cell_quantity(e, name, c, i, cells, result);
}

/* rmax(0.3): the command runs, and one number of its answer is the value. */
static bool command_quantity(struct expression *e, const struct command *c, const char *key,
                             const struct quantity *arguments, int count, struct quantity *result)
{
    struct session *session = e->context;
    struct cell cells[ANSWER_CELLS];
    struct call call = {.count = count};
    int fewest = 0, most = 0;
    for (; most < ARGUMENTS_MAX && c->argument[most].kind; most++)
        fewest += !c->argument[most].optional;
    if (count < fewest || count > most) {
        char usage[USAGE_SIZE];
        return expression_fail(e, "%d value%s for '%s'", count, count == 1 ? "" : "s",
                               command_usage(c, usage));
    }
    /* The message of what fails in there has been written when it returns. */
    for (int i = 0; i < count; i++)
        if (!argument_check(session, &c->argument[i], arguments[i], &call.number[i]))
            return false;
    return command_keep(session, c, &call, cells) && key_quantity(e, c->name, key, c, cells, result);
}

static const char *value_names(const void *context, int k)
{
    for (int n = 0; expression_name(n); n++)
        if (k-- == 0)
            return expression_name(n);
    return k == 0 ? "ans" : topic_names(context, k - 1);
}

static bool lookup(struct expression *e, const char *name, const char *key, const struct quantity *arguments,
                   int count, struct quantity *result)
{
    struct session *session = e->context;
    const struct parameter *p = parameter_find(name);
    const struct command *c = command_find(name);
    if (p && !p->words_only && !key && count == 0) {
        *result = expression_unit(p->unit);
        result->value *= parameter_get(session, p);
        return true;
    }
    if (strcmp(name, "ans") == 0 && count == 0)
        return session->ans.command
                   ? key_quantity(e, name, key, session->ans.command, session->ans.cells, result)
                   : expression_fail(e, "there is no earlier answer");
    if (c && c->principal >= 0)
        return command_quantity(e, c, key, arguments, count, result);
    const char *close = names_closest(value_names, NULL, name);
    return expression_fail(
        e, close && strcmp(close, name) != 0 ? "'%s' has no value; did you mean '%s'?" : "'%s' has no value",
        name, close);
}

/* ---- Arguments ---- */

static const char unclosed[] = "this '\"' is never closed";

/* A run of characters without blanks, or what stands between "..."; NULL where a '"' is never closed. */
static char *read_word(struct reader *r, bool quotes)
{
    const char *begin = r->at;
    size_t length = strcspn(begin, " \t\r\f\v;");
    if (quotes && *begin == '"') {
        length = strcspn(++begin, "\"");
        if (begin[length] == '\0')
            return NULL;
    }
    r->at = begin + length + (quotes && begin[length] == '"');
    return strndup(begin, length);
}

/* A file name, '~' being the home folder. */
static char *read_file(struct reader *r)
{
    char *word = read_word(r, true), *path = word ? tilde_expand(word) : NULL;
    free(word);
    return path;
}

static const char *unit_names(const void *context, int k)
{
    (void)context;
    return expression_unit_name(k);
}

/* Is the word behind a value a value itself?  If not, it was meant as a unit. */
static bool known_word(struct session *session, struct reader *r, const char *at)
{
    struct reader behind = {.session = session, .text = r->text, .at = at};
    char *word = read_word(&behind, false), shown[NAMES_SHOWN];
    size_t name = word ? strspn(word, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") : 0;
    if (word)
        word[name] = '\0';
    bool known = word && names_exact(value_names, NULL, word) >= 0;
    if (!known && word) {
        const char *close = names_closest(unit_names, NULL, word);
        session->column = column_of(r, at);
        names_shown(word, shown);
        if (close && strcmp(close, word) == 0)
            session_error(session, "the unit '%s' stands behind a number or a ')'", shown);
        else if (close)
            session_error(session, "'%s' is no unit; did you mean '%s'?", shown, close);
        else
            session_error(session, "'%s' is no unit and has no value", shown);
    }
    free(word);
    return known;
}

static bool read_quantity(struct reader *r, const struct argument *a, struct quantity *q, dom_real *number)
{
    struct session *session = r->session;
    struct expression e = {.text = r->at,
                           .lookup = lookup,
                           .context = session,
                           .angle = session->style.angle == ANGLE_DEG ? PI / 180 : 1};
    int begin = session->column;
    long errors = session->errors;
    if (!expression_evaluate(&e, q)) {
        session->column = column_of(r, e.end);
        if (session->errors > errors && e.message[0] == '\0')
            return false;
        char shown[NAMES_SHOWN], word[NAMES_SHOWN];
        snprintf(word, sizeof word, "%.*s", (int)strcspn(e.end, " \t;"), e.end);
        if (*word == '\0')
            return session_error(session, "%s: %s", a->name, e.message);
        return session_error(session, "%s at '%s': %s", a->name, names_shown(word, shown), e.message);
    }
    if (!isspace((unsigned char)*e.end) && (!ends(e.end) || *e.end == '#') && *e.end != '>') {
        char shown[NAMES_SHOWN];
        session->column = column_of(r, e.end);
        return session_error(session, "%s ends before '%s'; here an operator or a blank is missing", a->name,
                             names_shown(e.end, shown));
    }
    const char *next = skip_blanks(e.end);
    if (r->last && isalpha((unsigned char)*next) && next > e.end && !known_word(session, r, next))
        return false;
    r->at = e.end;
    session->column = begin;
    return argument_check(session, a, *q, number);
}

/* Is the word a name that expressions know? */
static bool is_value_name(const char *word)
{
    return names_exact(value_names, NULL, word) >= 0;
}

/* A value for a parameter: one of its words, or an expression. */
static bool read_value(struct reader *r, const struct parameter *p, const char *name, dom_real *number)
{
    const char *begin = r->at;
    char message[NAMES_MESSAGE] = "", what[32];
    char *word = read_word(r, false);
    int k = -1;
    /* A word for a number may not hide a name: 'set q h' is the parameter h. */
    bool wordlike = word && word[strspn(word, "abcdefghijklmnopqrstuvwxyz")] == '\0' && *word;
    if (word && p->words) {
        snprintf(what, sizeof what, "value of %s", p->name);
        k = p->words_only || (wordlike && !is_value_name(word))
                ? names_find(parameter_words, p, what, word, message)
                : names_exact(parameter_words, p, word);
    }
    free(word);
    if (k >= 0) {
        *number = p->words[k].value;
        return true;
    }
    if (*message) {
        char range[64];
        parameter_range(r->session, p, range, sizeof range);
        return session_error(r->session, p->words_only ? "%s (%s is one of %s)" : "%s (%s is a number in %s)",
                             message, p->name, range);
    }
    r->at = begin;
    struct quantity q = {0, 0, 0, 0};
    return read_quantity(r, &(struct argument){.name = name, .kind = ARGUMENT_OF, .of = p->name}, &q, number);
}

/* 'help sin', 'help cm', 'help units' are about expressions. */
static bool is_expression_topic(const char *word)
{
    static const char *const topics[] = {"ans",         "unit",     "units",    "expression",
                                         "expressions", "function", "functions"};
    for (size_t i = 0; i < sizeof topics / sizeof *topics; i++)
        if (strcmp(topics[i], word) == 0)
            return true;
    return is_value_name(word) || names_exact(unit_names, NULL, word) >= 0;
}

/* One of the argument's names; what is none of them hears which there are. */
static bool read_choice(struct reader *r, const struct argument *a, char **word, dom_real *number)
{
    char message[NAMES_MESSAGE], shown[NAMES_SHOWN], all[128] = "";
    *word = read_word(r, false);
    int k = *word ? names_find(a->choices, NULL, a->of, *word, message) : -1;
    *number = k;
    if (k >= 0)
        return true;
    const char *name;
    for (int n = 0; (name = a->choices(NULL, n)) != NULL; n++) {
        size_t used = strlen(all);
        snprintf(all + used, sizeof all - used, "%s%s", n ? ", " : "", name);
    }
    if (*word && !strstr(message, "did you mean"))
        return session_error(r->session, "'%s' is no %s; those are: %s", names_shown(*word, shown), a->of,
                             all);
    return session_error(r->session, "%s", message);
}

/* One of the names, as -1 - its number; or an angle. */
static bool read_place(struct reader *r, const struct argument *a, struct call *call, int i)
{
    char message[NAMES_MESSAGE];
    const char *begin = r->at;
    char *name = read_word(r, false);
    bool letters =
        name && *name && name[strspn(name, "abcdefghijklmnopqrstuvwxyz")] == '\0' && !is_value_name(name);
    int place = !name     ? -1
                : letters ? names_find(a->choices, NULL, a->of, name, message)
                          : names_exact(a->choices, NULL, name);
    r->at = place >= 0 ? r->at : begin;
    free(name);
    if (place >= 0) {
        call->number[i] = -1 - place;
        return true;
    }
    if (letters && read_choice(r, a, &call->word[i], &call->number[i]))
        return true;
    return !letters && read_quantity(r, a, &call->quantity[i], &call->number[i]);
}

/* 'on', 'off', a value of the effect before it, or the file in its place. */
static bool read_effect(struct reader *r, struct call *call, int i)
{
    enum dom_effect_name effect = (enum dom_effect_name)call->number[0];
    const struct dom_effect_argument *of = &dom_effect(effect)->argument[i - 1];
    char usage[EFFECT_USAGE], shown[NAMES_SHOWN], word[NAMES_SHOWN];
    snprintf(word, sizeof word, "%.*s", (int)strcspn(r->at, " \t;>#"), r->at);
    bool turned = strcmp(word, "on") == 0 || strcmp(word, "off") == 0;
    if (i > DOM_EFFECT_ARGUMENTS || (!of->name && !turned) || call->word[1])
        return session_error(r->session, "'%s' is one argument too many; usage: effect %s",
                             names_shown(word, shown), effect_usage(effect, usage));
    size_t length = strlen(word);
    bool named = (isalpha((unsigned char)*word) && !is_value_name(word) && !strchr(word, '(')) ||
                 (length > 4 && strcmp(word + length - 4, ".csv") == 0);
    if ((turned && i == 1) || (of->or_file && (named || strchr("\"./~", *word)))) {
        call->word[i] = read_file(r);
        return call->word[i] || session_error(r->session, unclosed);
    }
    struct argument a = {.name = of->name, .kind = ARGUMENT_EFFECT, .effect = of};
    return read_quantity(r, &a, &call->quantity[i], &call->number[i]);
}

static bool read_argument(struct reader *r, const struct command *c, struct call *call)
{
    struct session *session = r->session;
    int i = call->count;
    const struct argument *a = &c->argument[i];
    session->column = call->column[i] = column_of(r, r->at);
    r->last = i + 1 == ARGUMENTS_MAX || !c->argument[i + 1].kind;
    char message[NAMES_MESSAGE];
    switch (a->kind) {
    case ARGUMENT_OF:
        return read_value(r, parameter_find(a->of), a->name, &call->number[i]);
    case ARGUMENT_VALUE: {
        const struct parameter *p = &session_parameters[(int)call->number[i - 1]];
        return read_value(r, p, p->name, &call->number[i]);
    }
    case ARGUMENT_PARAMETER:
    case ARGUMENT_TOPIC:
        call->word[i] = read_word(r, false);
        names_list *list = a->kind == ARGUMENT_TOPIC ? topic_names : parameter_names;
        int k = call->word[i] ? names_find(list, NULL, a->kind == ARGUMENT_TOPIC ? "topic" : "parameter",
                                           call->word[i], message)
                              : -1;
        if (k < 0 && a->kind == ARGUMENT_TOPIC && call->word[i] && is_expression_topic(call->word[i]))
            k = names_exact(topic_names, NULL, "print");
        call->number[i] = k;
        char *equals = k < 0 && call->word[i] ? strchr(call->word[i], '=') : NULL;
        if (equals)
            return session_error(session, "a blank stands between a name and its value, and no '='");
        if (k < 0 && call->word[i])
            effect_hint(call->word[i], message);
        return k >= 0 || session_error(session, "%s", message);
    case ARGUMENT_CHOICE:
        return read_choice(r, a, &call->word[i], &call->number[i]);
    case ARGUMENT_PLACE:
        return read_place(r, a, call, i);
    case ARGUMENT_EFFECT:
        return read_effect(r, call, i);
    case ARGUMENT_WORD:
    case ARGUMENT_FILE:
        call->word[i] = a->kind == ARGUMENT_FILE ? read_file(r) : read_word(r, true);
        return call->word[i] ? *call->word[i] || session_error(session, "%s is missing", a->name)
                             : session_error(session, unclosed);
    case ARGUMENT_REST:
        call->word[i] = strdup(r->at);
        r->at += strlen(r->at);
        return call->word[i] != NULL;
    default:
        return read_quantity(r, a, &call->quantity[i], &call->number[i]);
    }
}

static bool read_arguments(struct reader *r, const struct command *c, struct call *call)
{
    char usage[USAGE_SIZE], shown[NAMES_SHOWN];
    struct session *session = r->session;
    for (call->count = 0; call->count < ARGUMENTS_MAX && c->argument[call->count].kind; call->count++) {
        const struct argument *a = &c->argument[call->count];
        r->at = skip_blanks(r->at);
        if (a->kind != ARGUMENT_REST && (ends(r->at) || *r->at == '>'))
            break;
        if (!read_argument(r, c, call))
            return false;
    }
    r->at = skip_blanks(r->at);
    session->column = column_of(r, r->at);
    if (call->count < ARGUMENTS_MAX && c->argument[call->count].kind && !c->argument[call->count].optional)
        return session_error(session, "%s is missing; usage: %s", c->argument[call->count].name,
                             command_usage(c, usage));
    if (!ends(r->at) && *r->at != '>') {
        char *word = read_word(r, false);
        session_error(session, "'%s' is one argument too many; usage: %s",
                      names_shown(word ? word : "", shown), command_usage(c, usage));
        free(word);
        return false;
    }
    return true;
}

/* ---- Commands ---- */

/* The command has been read, and nothing was wrong with it. */
static bool run_call(struct session *session, const struct command *c, struct call *call)
{
    struct cell kept[ANSWER_CELLS] = {{.kind = CELL_NONE}};
    struct answer answer = {
        .out = session->out,
        .style = session_style(session),
        .columns = c->columns,
        .rows = c->rows,
        .gap = session->answered && session->source,
        .kept = c->principal >= 0 ? kept : NULL,
    };
    call->answer = &answer;
    session->column = 0;
    double begun = terminal_clock();
    ticker_start();
    bool done = c->run(session, call);
    ticker_stop();
    call->answer = NULL;
    double seconds = terminal_clock() - begun;
    session->fresh = session->fresh && done && !c->columns;
    if (done && c->train && session->effect[DOM_EFFECT_row].on && answer_for_people(&answer))
        answer_say(&answer,
                   "(This is the endless train at these parameters, not the row: 'fall' runs that.)");
    session->answered = session->answered || (done && c->columns);
    session->write_error = answer.lost ? answer.lost : session->write_error;
    if (done && c->principal >= 0) {
        session->ans.command = c;
        memcpy(session->ans.cells, kept, sizeof kept);
    }
    if (done && session->timing && c->columns) {
        /* Programs that read csv or json find it where it does not disturb. */
        bool people = session->style.output == OUTPUT_TABLE && !session->redirected;
        fprintf(people ? session->out : stderr, "time: %.6g ms\n", 1e3 * seconds);
    }
    return done;
}

/* What stands behind '>' or '>>' is a file that takes the answer. */
static bool run_redirected(struct reader *r, const struct command *c, struct call *call)
{
    struct session *session = r->session;
    struct redirect redirect;
    bool append = r->at[1] == '>';
    r->at = skip_blanks(r->at + (append ? 2 : 1));
    session->column = column_of(r, r->at);
    char *path = read_file(r), shown[NAMES_SHOWN];
    r->at = skip_blanks(r->at);
    const char *wrong = NULL;
    bool done = false;
    if (!path)
        session_error(session, unclosed);
    else if (!*path)
        session_error(session, "the file behind '>' is missing");
    else if (!ends(r->at))
        session_error(session,
                      "only one word may stand behind '>'; a file name with blanks stands between \"...\"");
    else if (session->safe)
        session_error(session, "files are off in a safe session");
    else if ((wrong = redirect_open(&redirect, path, append)) != NULL)
        session_error(session, "cannot write '%s': %s", names_shown(path, shown), wrong);
    else {
        FILE *out = session->out;
        bool answered = session->answered;
        session->out = redirect.file;
        session->redirected = path;
        session->appended = append;
        session->answered = false;
        done = run_call(session, c, call);
        session->out = out;
        session->redirected = NULL;
        session->answered = answered;
        wrong = redirect_close(&redirect, done);
        if (done && wrong)
            done = session_error(session, "cannot write '%s': %s", names_shown(path, shown), wrong);
    }
    free(path);
    return done;
}

/* Runs the command at the reader; false if the rest of the line is not to be read. */
static void run_command(struct reader *r)
{
    struct session *session = r->session;
    char message[NAMES_MESSAGE];
    session->column = column_of(r, r->at);
    size_t length = strcspn(r->at, " \t\r\f\v;>");
    char *name = strndup(r->at, length);
    r->at += length;
    const struct command *c = NULL;
    int k = name ? names_find(command_names, NULL, "command", name, message) : -1;
    if (k < 0) {
        bool known = name && strstr(message, "did you mean");
        if (name && strcspn(name, "0123456789(+-*/^=") == 0)
            snprintf(message, sizeof message, "an expression is no command; 'print' evaluates it");
        known = (name && effect_hint(name, message)) || known;
        session_error(session, known || !strstr(message, "unknown") ? "%s" : "%s; 'help' lists the commands",
                      message);
    } else {
        c = command_find(command_names(NULL, k));
        session->command = c->name;
        struct call call = {.count = 0};
        if (c->files && session->safe)
            session_error(session, "files are off in a safe session");
        else if (read_arguments(r, c, &call))
            (void)(*r->at == '>' ? run_redirected(r, c, &call) : run_call(session, c, &call));
        for (int i = 0; i < ARGUMENTS_MAX; i++)
            free(call.word[i]);
    }
    free(name);
    session->command = NULL;
    session->column = 0;
}

/* Behind the command that begins at c: the ';' or comment that ends it, not looking into "...". */
static const char *command_end(const char *c)
{
    bool blank = true, quote = false;
    for (; *c; c++) {
        quote = quote != (*c == '"');
        if (!quote && (*c == ';' || (*c == '#' && blank)))
            break;
        blank = isspace((unsigned char)*c);
    }
    return c;
}

static void run_line(struct session *session, const char *line, size_t length)
{
    struct text text;
    if (!text_make(&text, line, length)) {
        session_error(session, "out of memory");
        return;
    }
    struct reader r = {.session = session, .text = &text, .at = text.line};
    session->typed = line;
    session->typed_length = (int)(length < INT_MAX ? length : INT_MAX);
    session->typed_columns = text_column(&text, text.line + strlen(text.line)) - 1;
    for (;;) {
        long errors = session->errors;
        const char *begin = skip_blanks(r.at), *end = command_end(begin);
        if (begin < end) {
            r.at = begin;
            run_command(&r);
            end = r.at > end ? r.at : end; /* 'complete LINE' takes the rest */
        }
        if (*end != ';' || session_stops(session, errors))
            break;
        r.at = end + 1;
    }
    session->typed = NULL;
    text_free(&text);
}

void command_run_text(struct session *session, const char *text)
{
    for (;;) {
        long errors = session->errors;
        size_t length = strcspn(text, "\n");
        run_line(session, text, length);
        if (text[length] == '\0' || session_stops(session, errors))
            return;
        text += length + 1;
        session->line++;
    }
}
