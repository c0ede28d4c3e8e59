/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* asprintf */
#include "interpreter/interpret.h"
#include "interpreter/question.h"
#include "io/output.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* ---- Lines ---- */

/* Runs the commands of a line. Each of them is logged before it runs, but not those of a sourced file,
 * because the log has the command 'source'. */
static void run_commands(struct session *session, const struct text *text)
{
    struct arena arena = {.block = NULL};
    struct reader r = {.text = text, .at = text->line, .arena = &arena};
    for (;;) {
        long errors = session->errors;
        const char *begin = skip_blanks(r.at), *end = text_end(begin, ";");
        if (begin < end) {
            const char *typed = text_typed(text, begin);
            if (session->has_log && session->source.depth == 0)
                log_command(typed, (size_t)(text_typed(text, end) - typed));
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
    /* The log is flushed after each line, in case of a crash. */
    const char *wrong = session->has_log ? log_flush() : NULL;
    session->has_log = session->has_log && !wrong;
    if (wrong)
        session_error(session, "recording stops here, because the file cannot be written: %s", wrong);
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
