/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A session: its state, its input and output, and its messages. */
#ifndef SHELL_SESSION_H
#define SHELL_SESSION_H

#include "answer/answer.h"
#include "io/output.h"
#include "session/query.h"

enum { SOURCE_DEPTH = 16 };

struct session {
    struct state state;
    struct ans ans;
    struct means means;
    struct undo *undo; /* NULL until something has changed */

    struct output *output; /* the top of the stack of outputs */
    struct output standard;

    struct source {
        const char *name; /* the name of the script, for messages; NULL at the prompt */
        FILE *stream;     /* the stream of the script, for 'lesson'; NULL at the prompt and for -e */
        long line;        /* the number of the current line in the script */
        int depth;        /* how deeply 'source' commands are nested */
        int prompt_width; /* the number of columns before the typed line; 0 in a script */
    } source;

    struct typed {
        const char *text; /* the line that runs, which does not end with a NUL byte; NULL between lines */
        int length, columns;
        bool is_last; /* at the prompt: there is no output below the line yet */
    } typed;

    const char *command; /* the command that runs, for notes */
    /* The flag that SIGINT sets, if SIGINT ends only the command and not the script. Otherwise NULL. */
    volatile sig_atomic_t *resumes;
    bool bail; /* the first error ends the session */
    bool quit;
    bool wrote; /* the last command wrote rows */
    long errors;
};

/* Begins a session in which every parameter has its default. */
void session_init(struct session *session, FILE *out);

void session_close(struct session *session);

/* Returns the format of the next answer: that of the file that it goes to, or else that of 'set output'. */
const struct format *session_answers(const struct session *session);

/* Returns a query of the session's state. The caller sets its arguments and next state. */
struct query session_query(struct session *session);

/* Writes an error message with its place to stderr, and counts it. */
void session_problem(struct session *session, const struct problem *problem);

/* Writes an error message that has no place in the line. */
void session_error(struct session *session, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Writes a message to stderr that is no error. */
void session_note(struct session *session, const char *format, ...) __attribute__((format(printf, 2, 3)));

/*
 * Returns true if no more lines may run: after 'quit', after an interrupt, if nobody reads the output, and
 * with
 * --bail after an error. `errors` is the number of errors before the last line.
 */
bool session_stops(const struct session *session, long errors);

#endif
