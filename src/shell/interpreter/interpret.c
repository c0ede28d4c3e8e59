/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/interpret.h"
#include "answer/format.h"
#include "interpreter/run.h"
#include "session/undo.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* ---- Commands ---- */

/*
 * Returns true if a command has written nothing and needs an empty JSON object as its answer, because a
 * program that waits for an answer must receive one. The outputs of the parts of a sharded sweep are
 * concatenated, so only the first part writes such an object, and only for commands whose answers are not
 * tables.
 */
static bool is_silent(const struct session *session, const struct command *c, bool is_redirected)
{
    const struct shard *shard = &session->means.shard;
    bool is_first = shard->parts == 0 || (shard->part == 1 && !c->rows);
    /* After 'source', session->wrote refers only to the commands in the file. */
    bool is_source = c->runs && c->argument[0].kind == ARGUMENT_FILE;
    return is_first && (is_redirected || is_source || !session->wrote);
}

/* Parses and runs the command at the position of the reader, and moves the reader to the position where
 * parsing ended. */
static void run_command_at(struct session *session, struct reader *line)
{
    struct reader r = *line;
    struct problem problem;
    struct question q;
    const struct query query = session_query(session);
    problem_begin(&problem, NULL);
    r.query = &query;
    r.problem = &problem;
    if (command_parse(&r, &q)) {
        const struct command *c = q.command;
        const struct format *format = session_answers(session);
        /* 'undo' reverts all changes that a sourced file makes as one step. */
        bool is_step = c->changes && session->source.depth == 0;
        bool is_redirected = *r.at == '>';
        struct state *before = is_step ? undo_begin(&session->state) : NULL;
        session->command = c->name;
        bool done = run_question(session, &r, &q);
        /* A command that changes the output format, such as 'set output', writes no empty JSON object. */
        bool is_same = session_answers(session) == format;
        if (done && is_same && format->done && is_silent(session, c, is_redirected))
            format->done(session->output->out, c->name);
        if (is_step)
            undo_keep(&session->undo, &session->state, before, line->at,
                      (size_t)(text_end(line->at, ";") - line->at));
    }
    if (problem.kind != PROBLEM_NONE)
        session_problem(session, &problem);
    session->command = NULL;
    line->at = r.at;
    /* The user must see this answer while the next one is being computed. */
    fflush(output_base(session->output)->out);
}

/* ---- Lines ---- */

/* Returns true if the commands of the current line are logged. The commands of a sourced file are not logged,
 * because the 'source' command is. */
static bool has_log(struct session *session)
{
    return session->source.depth == 0 && output_find(&session->output, OUTPUT_LOG);
}

/* Runs the commands of a text. If one of them opens a log, the commands after that one are logged. */
static void run_commands(struct session *session, const struct text *text, const char *line, size_t length)
{
    struct arena arena = {.block = NULL};
    struct reader r = {.text = text, .at = text->line, .arena = &arena};
    bool is_logged = has_log(session);
    /* A line with several commands is logged at once, because a later command may fail after others have run.
     * A single command is held back until it is known whether the command failed. */
    if (is_logged)
        log_commands(&session->output, line, length, *text_end(text->line, ";") == ';');
    for (;;) {
        long errors = session->errors;
        const char *begin = skip_blanks(r.at), *end = text_end(begin, ";");
        if (begin < end) {
            r.at = begin;
            run_command_at(session, &r);
            arena_free(&arena);
            /* The parser, and not text_end, decides where a command ends: 'complete LINE' takes the rest of
             * the line, and a '"' within a word is an ordinary character. */
            end = r.at > end || command_ends(r.at) ? r.at : end;
        }
        if (*end != ';' || session_stops(session, errors))
            return;
        r.at = end + 1;
        if (!is_logged && has_log(session)) {
            const char *next = text_typed(text, skip_blanks(r.at));
            log_commands(&session->output, next, length - (size_t)(next - line), true);
            is_logged = true;
        }
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
    session->typed.text = line;
    session->typed.length = (int)length;
    session->typed.columns = text_column(&text, text.line + strlen(text.line)) - 1;
    run_commands(session, &text, line, length);
    /* The files of 'log' and 'tee' are flushed after each line, so that no lines are lost in a crash. */
    const char *wrong = records_flush(&session->output);
    if (wrong)
        session_error(session, "recording stops here, because the file cannot be written: %s", wrong);
    session->typed.text = NULL;
    text_free(&text);
}

/* If SIGINT ends only the running command and not the whole script, clears a SIGINT that arrived before or
 * during the commands that command_run_text runs. */
static void resume(struct session *session)
{
    if (session->resumes && session->source.depth == 0 && *session->resumes == SIGINT)
        *session->resumes = 0;
}

void command_run_text(struct session *session, const char *text)
{
    resume(session);
    for (bool more = true; more;) {
        long errors = session->errors;
        size_t length = strcspn(text, "\n");
        run_line(session, text, length);
        more = text[length] != '\0' && !session_stops(session, errors);
        text += length + 1;
        session->source.line += more;
    }
    resume(session);
}

/* ---- Streams ---- */

/*
 * Appends lines from a stream to *text until a line is not continued, the text is too long or the stream
 * ends. Adds the number of lines to *more. Returns false if a line contains a NUL byte, or if there is no
 * memory.
 */
static bool line_join(char **text, size_t *room, FILE *in, long *more)
{
    char *next = NULL;
    size_t size = 0, used = strlen(*text);
    ssize_t length = 0;
    bool goes_on = true, good = true;
    while (goes_on && good && used <= TEXT_MOST && (length = text_read(&next, &size, in)) != -1) {
        ++*more;
        good = strlen(next) == (size_t)length;
        goes_on = good && text_continues(next);
        size_t n = strlen(next);
        if (good && used + n >= *room) {
            char *larger = realloc(*text, used + n + 1);
            good = larger != NULL;
            *text = good ? larger : *text;
            *room = good ? used + n + 1 : *room;
        }
        if (good)
            memcpy(*text + used, next, n + 1);
        used += n;
    }
    free(next);
    return good;
}

void line_stream(struct session *session, FILE *in, const char *name)
{
    char *text = NULL;
    size_t size = 0;
    ssize_t length;
    const struct source outer = session->source;
    const char *command = session->command;
    session->source = (struct source){.name = name, .stream = in, .depth = outer.depth};
    session->command = NULL;
    errno = 0;
    while (!session->quit && (length = text_read(&text, &size, in)) != -1) {
        long errors = session->errors, more = 0;
        session->source.line++;
        bool is_text = strlen(text) == (size_t)length;
        if (is_text && text_continues(text))
            is_text = line_join(&text, &size, in, &more);
        if (is_text)
            command_run_text(session, text);
        else
            session_error(session, "the line has a NUL byte; commands are text");
        session->source.line += more;
        if (session_stops(session, errors) || (!is_text && length > TEXT_MOST))
            break;
        errno = 0;
    }
    int reason = ferror(in) || errno == ENOMEM ? errno : 0;
    if (reason && reason != ECANCELED)
        session_error(session, "cannot read the next line: %s", strerror(reason));
    free(text);
    session->source = outer;
    session->command = command;
    /* The interrupt is reported as a problem of 'source' and not of a line in the file. */
    if (reason == ECANCELED && session->command) {
        struct problem problem = {.command = session->command};
        problem_status(&problem, &session->state.scene, DOM_INTERRUPTED);
        session_problem(session, &problem);
    }
}

bool line_path(const char *variable, const char *fallback, const char *name, char *path, size_t size)
{
    const char *base = getenv(variable), *home = getenv("HOME");
    int length = -1;
    if (base && *base == '/')
        length = snprintf(path, size, "%s/domino/%s", base, name);
    else if (home && *home)
        length = snprintf(path, size, "%s/%s/domino/%s", home, fallback, name);
    return length > 0 && (size_t)length < size;
}
