/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The state of one calculator session: parameters, where input comes from, what went wrong.  parameters.h has
 * the table of the parameters.
 */
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
    struct undo *undo; /* earlier states; NULL: none */
    void (*undo_free)(struct undo *undo);
    struct output *output;  /* where answers go: the top of a stack */
    struct output standard; /* standard output, the bottom of the stack */
    FILE *out;              /* the stream of output */
    const char *source;     /* name of the script for messages; NULL at the prompt */
    FILE *script;           /* the stream whose lines run, for 'lesson'; NULL at the prompt and in -e */
    long line;
    int prompt_width;  /* at the prompt: columns before the line, for the caret; else 0 */
    const char *typed; /* the line that runs, as it was typed, not ended */
    int typed_length, typed_columns;
    bool fresh;          /* at the prompt: no output is below the typed line yet */
    const char *command; /* the one that runs, for notes */
    volatile sig_atomic_t
        *resumes; /* the interrupt, if SIGINT is to end a command and no script; else NULL */
    bool bail;    /* the first error ends the session */
    bool quit;
    bool wrote; /* the last command wrote rows */
    int depth;  /* of nested source commands */
    long errors;
};

/* Return the format that 'set output' has chosen; and that of answers here, which the ending of a file may
 * set. */
const struct format *session_format(const struct session *session);
const struct format *session_answers(const struct session *session);

/* Follows a change of the stack of output. */
void session_direct(struct session *session);

/* Begins a session in which every parameter has its default. */
void session_init(struct session *session, FILE *out);

/* Frees what the session holds. */
void session_close(struct session *session);

/* Returns a query of the session's state; its arguments and next state are still open. */
struct query session_query(struct session *session);

/* Writes a problem on stderr, in one line: where, what was wrong, what would be right. Counts it as an error.
 */
void session_problem(struct session *session, const struct problem *problem);

/* The same for a problem without a place in the line. */
void session_error(struct session *session, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Writes a note on stderr: no error, and not counted as one. */
void session_note(struct session *session, const char *format, ...) __attribute__((format(printf, 2, 3)));

/*
 * Returns true if the rest of the input must not be run: after quit, after ^C, if there is no reader of the
 * output, and with bail after an error (session->errors was `errors` before).
 */
bool session_stops(const struct session *session, long errors);

#endif
