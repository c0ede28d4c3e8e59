/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* asprintf */
#include "answer/answer.h"
#include "interpreter/question.h"
#include "io/io.h"
#include "io/output.h"
#include "io/terminal.h"
#include "session/row.h"
#include "session/session.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* ---- Answers ---- */

/* Keeps the answer for 'ans', and its rest for 'details'. Prints the rest at once if the command ends with
 * this word. */
static void answer_keep(struct session *session, const struct command *c, const struct query *query,
                        struct answer *answer, const struct cell kept[ANSWER_CELLS])
{
    char *text = answer->details.rest ? rest_end(answer->details.rest) : NULL;
    if (text && query->given->question->details)
        fprintf(answer->out, "\n%s", text);
    if (c->columns) {
        free(session->details);
        session->details = text;
    } else
        free(text);
    if (answer->is_value || c->principal)
        session->ans.printed = answer->is_value;
    if (answer->is_value)
        session->ans.value = answer->value;
    else if (c->principal) {
        session->ans.command = c;
        session->ans.with = query->state != &session->state;
        memcpy(session->ans.cells, kept, ANSWER_CELLS * sizeof *kept);
    }
}

/* Says what is special about the numbers of an answer: they are in double, they are about the endless train
 * and not about the row, or some have no error. If the answer is a picture in a file, the note about the
 * train goes to standard error. */
static void notes_say(const struct command *c, const char *in_double, struct answer *answer)
{
    if (in_double)
        (answer->details.rest ? answer_detail : answer_say)(answer, "(%s)", in_double);
    const char *note = answer->note != in_double && answer_for_people(answer) ? answer->note : NULL;
    if (note && answer->path && extension_of(answer->path)->kind == EXTENSION_SHEET)
        fprintf(stderr, "(%s)\n", note);
    else if (note)
        answer_say(answer, "(%s)", note);
    if (answer->errors.has_no_room)
        answer_say(answer, "Where a column has no room for errors, 'set output csv' shows them.");
    else if (answer->errors.has_unknown)
        answer_say(answer,
                   c->precision == PRECISION_AS_SET
                       ? "Where no error is given, 30 digits lead to another answer, or a part of the "
                         "answer is computed in double precision only."
                       : "No errors are given: '%s' computes in double precision only.",
                   c->name);
}

/* Runs a command and writes its answer to the output at the top of the stack. */
static bool run_command(struct session *session, const struct command *c, const struct query *query,
                        struct problem *problem)
{
    struct cell kept[ANSWER_CELLS];
    struct rest rest;
    /* `kept` is needed only if the command has a value for 'ans'. Clearing it for every command would slow
     * down scripts. */
    if (c->principal)
        memset(kept, 0, sizeof kept);
    rest.out = NULL;
    struct output *output = session->output;
    const char *note = c->train ? scene_train_note(query->scene) : NULL;
    /* in another precision than that of the session */
    const char *in_double = c->precision == PRECISION_DOUBLE && query->scene->compute.precision != IN_DOUBLE
                                ? "This answer is computed in double precision."
                                : NULL;
    struct answer answer = {
        .out = output->out,
        .path = output->path,
        .style = state_style(query->state),
        .command = c->name,
        .note = note ? note : in_double,
        .csv.last_header = output->header,
        .columns = c->columns,
        .rows = c->rows,
        .details.brief =
            c->brief && query->state->settings.style.errors ? "*" : c->brief, /* errors need numbers */
        .details.rest = c->brief ? &rest : NULL,
        .progress.interrupt = query->scene->compute.interrupt,
        .progress.blank_above = output->answered && session->source.name,
        .kept = c->principal ? kept : NULL,
    };
    if (output->format)
        answer.style.format = output->format;
    problem->place = 0;
    session->made[0] = '\0';
    progress_begin();
    bool done = c->act ? c->act(session, query->given, &answer, problem)
                       : command_compute(c, query, &answer, problem);
    progress_end();
    if (done && c->columns && dom_raised(answer.progress.interrupt))
        done = problem_status(problem, query->scene, DOM_INTERRUPTED);
    session->is_last = session->is_last && done && !c->columns && !answer.progress.wrote_text;
    if (done)
        notes_say(c, in_double, &answer);
    if (done && *answer.late_reason && answer_for_people(&answer))
        answer_say(&answer, "%s", answer.late_reason);
    else if (done && *answer.late_reason)
        session_note(session, "%s", answer.late_reason);
    if (done)
        answer_keep(session, c, query, &answer, kept);
    else if (answer.details.rest)
        free(rest_end(answer.details.rest));
    session->wrote = answer.progress.has_rows;
    if (*answer.made) /* copying an empty text would take a twentieth of the time of a short line */
        snprintf(session->made, sizeof session->made, "%s", answer.made);
    output->answered = output->answered || (done && c->columns) || answer.progress.wrote_text;
    return done;
}

/* ---- Files ---- */

static bool extension_fits(const struct command *c, const char *path, bool appends, struct problem *problem)
{
    const enum extension_kind kind = extension_of(path)->kind;
    const bool films = c->writes == WRITES_FILMS, draws = c->writes == WRITES_PICTURES,
               has_data = c->columns || c->access.runs || films || c->writes == WRITES_PAGES;
    const bool fits = kind == EXTENSION_FILM    ? films
                      : kind == EXTENSION_DATA  ? has_data
                      : kind == EXTENSION_SHEET ? draws
                                                : kind != EXTENSION_OTHER && !films;
    if (fits && appends && (kind == EXTENSION_FILM || kind == EXTENSION_SHEET))
        return problem_error(problem, "'%s' can hold only one picture; '>' replaces it", names_shown(path));
    return fits || problem_error(problem, "'%s' cannot write '%s'; use %s", c->name, names_shown(path),
                                 draws      ? ".svg, .png, .pdf, .gp or .txt (for the data: .csv or .json)"
                                 : films    ? ".gif (for the data: .csv or .json)"
                                 : has_data ? ".csv, .json or .txt"
                                            : ".txt");
}

/* At a terminal, says which file has been written, and what it contains. Scripts get no such message. */
static void wrote_say(const struct session *session, const char *path)
{
    struct stat file;
    const char *const units[] = {"bytes", "kB", "MB", "GB"}, *made = session->made;
    int unit = 0;
    if (session->source.stream || session->source.depth > 0 || !terminal_shows(stderr) ||
        stat(path, &file) != 0 || !S_ISREG(file.st_mode))
        return;
    progress_end();
    double size = (double)file.st_size;
    for (; size >= 1000 && unit < 3; unit++)
        size /= 1000;
    fprintf(stderr, "wrote %s: %s%s%.*f %s\n", names_shown(path), made, *made ? ", " : "",
            unit > 0 && size < 10, size, units[unit]);
}

static bool run_redirected(struct session *session, struct reader *r, const struct command *c,
                           const struct query *query)
{
    struct problem *problem = r->problem;
    bool appends = r->at[1] == '>';
    r->at = skip_blanks(r->at + (appends ? 2 : 1));
    reader_place(r, r->at);
    const char *path = read_file(r);
    r->at = skip_blanks(r->at);
    if (!path)
        return false;
    if (!*path)
        return problem_error(problem, "the file after '>' is missing; enter, for example, 'show > FILE'");
    if (!command_ends(r->at))
        return problem_error(problem,
                             "only one word can follow '>'; put a file name with blanks in double quotes");
    if (session->run_context.safe)
        return problem_error(problem, "a safe session cannot read or write files");
    if (!extension_fits(c, path, appends, problem))
        return false;
    const char *wrong = output_push(&session->output, path, appends);
    if (!wrong) {
        /* The extension determines the format. With format_table, a picture is drawn even after 'set output
         * csv'. */
        const struct extension *extension = extension_of(path);
        const bool is_shown = extension->kind == EXTENSION_SHEET || extension->kind == EXTENSION_FILM;
        session->output->format = is_shown ? &format_table : extension->format;
        session->output->is_header = session_format(session)->is_header;
        const bool done = run_command(session, c, query, problem);
        wrong = output_pop(&session->output, done);
        if (!done)
            return false;
    }
    if (wrong)
        return problem_error(problem, "cannot write '%s': %s", names_shown(path), wrong);
    wrote_say(session, path);
    return true;
}

/* ---- Commands ---- */

/* Parses and runs the command at the reader's position, writes its answer to standard output or a file, and
 * moves the reader to where parsing ended. */
static void run_command_at(struct session *session, struct reader *line)
{
    struct reader r = *line;
    struct problem problem;
    struct question q;
    struct query query = session_query(session);
    problem_begin(&problem, NULL);
    query.next = &session->state;
    r.query = &query;
    r.problem = &problem;
    if (command_parse(&r, &q)) {
        const struct command *c = q.command;
        const struct format *format = session_format(session);
        /* All changes that a sourced file makes are a single step for 'undo'. */
        bool is_step = c->access.changes && session->source.depth == 0;
        bool is_redirected = *r.at == '>';
        struct state *before = is_step ? undo_begin(&session->state) : NULL;
        session->command = c->name;
        struct call call;
        bool done = question_bind(&q, &query, &call, &problem);
        if (done)
            done = is_redirected ? run_redirected(session, &r, c, &call.query)
                                 : run_command(session, c, &call.query, &problem);
        if (done && c->writes == WRITES_SCRIPTS)
            wrote_say(session, call.given.word[0]);
        arena_free(&call.given.memory);
        /* A command that writes no answer to standard output gives an empty JSON object, because a program
         * may be waiting for an answer; but not if it changes the output format. 'source' has no answer of
         * its own. */
        const bool is_source = c->access.runs && c->argument[0].kind == ARGUMENT_FILE;
        if (done && session_format(session) == format && format->done &&
            (is_redirected || is_source || !session->wrote))
            format->done(session->output->out, c->name);
        if (is_step)
            undo_keep(&session->undo, &session->state, before, line->at,
                      (size_t)(text_end(line->at, ";") - line->at));
    }
    if (problem.kind != PROBLEM_NONE) {
        /* Messages for people name the command as help does, 'step to' rather than 'goto'. */
        if (q.command && q.command->typed.phrase && problem.command == q.command->name &&
            session_format(session)->for_people)
            problem.command = q.command->typed.phrase;
        session_problem(session, &problem);
    }
    session->command = NULL;
    line->at = r.at;
    io_row(session->standard.out);
}

/* ---- Lines ---- */

/* Runs the commands of a line. Each of them is logged before it runs, but not those of a sourced file,
 * because the log has the command 'source'. */
static void run_commands(struct session *session, const struct text *text)
{
    struct arena arena = {.block = NULL};
    struct reader r = {.text = text, .at = text->line, .arena = &arena, .names = name_resolve};
    for (;;) {
        long errors = session->errors;
        const char *begin = skip_blanks(r.at), *end = text_end(begin, ";");
        if (begin < end) {
            const char *typed = text_typed(text, begin);
            if (session->log && session->source.depth == 0)
                session->log->typed(typed, (size_t)(text_typed(text, end) - typed));
            r.at = begin;
            run_command_at(session, &r);
            arena_free(&arena);
            /* The next ';' is not always the end of the command. For example, 'complete LINE' takes the rest
             * of the line. Only the parser knows where a command ends. */
            end = r.at > end || command_ends(r.at) ? r.at : end;
        }
        if (*end != ';' || session_stops(session, errors))
            return;
        r.at = end + 1;
    }
}

static void run_line(struct session *session, const char *line, size_t length)
{
    struct text text;
    if (length > TEXT_MOST) {
        session_error(session, "the line is longer than %d MB; put each command on a line of its own",
                      TEXT_MOST >> 20);
        return;
    }
    if (!text_make(&text, line, length)) {
        session_error(session, "out of memory");
        return;
    }
    run_commands(session, &text);
    const char *wrong = session->log ? session->log->flush() : NULL;
    if (wrong) {
        session->log = NULL;
        session_error(session, "recording stops here, because the file cannot be written: %s", wrong);
    }
    text_free(&text);
}

/* Runs the lines of a stream. Returns the error that ends the stream, or 0. */
static int run_lines(struct session *session, FILE *in)
{
    char *line = NULL;
    size_t size = 0;
    ssize_t length;
    bool goes_on = !session->quit;
    errno = 0;
    while (goes_on && (length = text_read(&line, &size, in)) != -1) {
        const long errors = session->errors;
        bool is_text = strlen(line) == (size_t)length;
        session->source.line++;
        if (is_text)
            run_line(session, line, strlen(line));
        else
            session_error(session, "the line contains a NUL byte; commands are text");
        goes_on = !session_stops(session, errors) && (is_text || length <= TEXT_MOST);
        errno = 0;
    }
    int reason = ferror(in) || errno == ENOMEM ? errno : 0;
    if (reason && reason != ECANCELED)
        session_error(session, "cannot read the next line: %s", strerror(reason));
    free(line);
    return reason;
}

void command_run_text(struct session *session, const char *text)
{
    FILE *in = strchr(text, '\n') ? fmemopen((char *)text, strlen(text), "r") : NULL;
    if (in) {
        session->source.line--; /* it is already the number of the first line */
        run_lines(session, in);
        fclose(in);
    } else
        run_line(session, text, strlen(text));
}

/* ---- Streams ---- */

void line_stream(struct session *session, FILE *in, const char *name)
{
    const struct source outer = session->source;
    const char *command = session->command;
    session->source = (struct source){.name = name, .stream = in, .depth = outer.depth};
    session->command = NULL;
    const int reason = run_lines(session, in);
    session->source = outer;
    session->command = command;
    /* An interrupt is reported for the command 'source', not for a line of the file. */
    if (reason == ECANCELED && session->command) {
        struct problem problem = {.command = session->command};
        problem_status(&problem, &session->state.scene, DOM_INTERRUPTED);
        session_problem(session, &problem);
    }
}

/* ---- A line that is being typed ---- */

bool line_preview(struct session *session, const char *line, size_t length, const char *tail,
                  struct offer *offer)
{
    struct run_context run_context = session->run_context;
    struct query query = session_query(session);
    struct problem problem;
    struct question question;
    struct text text;
    struct arena arena = {.block = NULL};
    char *whole = NULL;
    int size = asprintf(&whole, "%.*s%s", (int)length, line, tail);
    if (size < 0 || !text_make(&text, whole, (size_t)size)) {
        free(size < 0 ? NULL : whole);
        return false;
    }
    run_context.note = NULL;
    query.run_context = &run_context;
    struct reader r = {.query = &query,
                       .problem = &problem,
                       .text = &text,
                       .arena = &arena,
                       .evaluates = !offer,
                       .offer = offer};
    if (offer)
        offer->cursor = text.line + strlen(text.line) - 1;
    bool good = true;
    for (const char *begin = text.line, *end;; begin = end + 1) {
        r.at = begin = skip_blanks(begin);
        end = text_end(begin, ";");
        problem_begin(&problem, NULL);
        question.command = NULL;
        r.names = offer ? NULL : name_resolve; /* completion reads on after a name that is not known */
        const bool is_whole = begin == end || command_parse(&r, &question);
        const int behind = text_column(&text, text.line + strlen(text.line));
        good = is_whole || (question.command && problem.column >= behind);
        if (is_whole && begin != end && *r.at == '>') {
            r.at = skip_blanks(r.at + 1 + (r.at[1] == '>'));
            offer_kind(&r, OFFER_FILE);
        }
        arena_free(&arena);
        if (*end != ';')
            break;
    }
    text_free(&text);
    free(whole);
    return good;
}
