/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A session: its state, its input and output, and its messages. */
#pragma once

#include "answer/answer.h"
#include "io/output.h"
#include "session/query.h"

enum { SOURCE_DEPTH = 16 };

/* A log of the session. It gets the answers from io_copy. */
struct session_log {
    void (*typed)(const char *text, size_t length); /* logs a command, before it runs */
    void (*message)(const char *text);              /* logs an error or a note */
    /* Is called after each line, in case of a crash. If the log cannot be written, ends it and returns the
     * reason; otherwise returns NULL. */
    const char *(*flush)(void);
    void (*close)(void);
};

struct session {
    struct state state;
    struct last_answer ans;
    struct walk walk;
    char *details; /* the rest of the last answer, for 'details'; NULL if that answer was whole */
    struct run_context run_context;
    struct undo *undo; /* the history of states; NULL until a command has changed the state */

    struct output *output; /* the top of the stack of outputs, which receives the answers */
    struct output standard;
    /* NULL if there is no log. Sessions that 'lesson' or 'help' open have none. */
    const struct session_log *log;

    struct source {
        const char *name; /* the name of the running script, for messages; NULL at the prompt */
        FILE *stream;     /* the stream of the script, for 'lesson'; NULL at the prompt and for -e */
        long line;        /* the number of the current line in the script */
        int depth;        /* how deeply 'source' commands are nested */
        int prompt_width; /* the width of the prompt in columns; 0 in a script */
    } source;

    bool is_last;        /* the session is at the prompt, and nothing has been written below the typed line */
    const char *command; /* the name of the command that is running, for notes */
    /* True if the first error ends the session: with --bail, and for -e, -f and FILE without --keep-going. At
     * the prompt, the error then ends only the line in which it occurs. */
    bool bail;
    bool quit;
    char made[64]; /* see answer.made */
    bool wrote;    /* the last command wrote an answer that has rows */
    long errors;
};

/* Initialises a session that writes to `out`. Every parameter has its default. */
void session_init(struct session *session, FILE *out);

void session_close(struct session *session);

/* Returns the format of the next answer. The output file's extension takes precedence over 'set output'. */
const struct format *session_format(const struct session *session);

/* Returns a query, which is the input of a command, for the session's state. The caller sets the members
 * `given` and `next`. */
struct query session_query(struct session *session);

/* Writes an error message with its position to stderr and increments session->errors. */
void session_problem(struct session *session, const struct problem *problem);

/* Like session_problem, for an error without a position in the line. */
#define session_error(session, ...) session_say(session, true, __VA_ARGS__)

/* Writes a message that is not an error to stderr. */
#define session_note(session, ...) session_say(session, false, __VA_ARGS__)
void session_say(struct session *session, bool is_error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Returns true if no more lines may run. The reason may be 'quit', an interrupt or a failed write. If
 * session->bail is true, it may also be an error in the last line. `errors` is the value that session->errors
 * had before this line. */
bool session_stops(const struct session *session, long errors);

/* ---- The history of the session's states, for 'undo' and 'redo' ---- */

/* Must be called before a command. Returns a copy of the state, for undo_keep. If memory runs out, returns
 * NULL, and the command cannot be undone. */
struct state *undo_begin(const struct state *state);

/* Must be called after a command. If the command has changed the state, adds a step to the history. The
 * command is the first `length` bytes of `text`. `before` is what undo_begin returned before the command, and
 * undo_keep takes ownership of it. *undo must be NULL before the first call. */
void undo_keep(struct undo **undo, const struct state *state, struct state *before, const char *text,
               size_t length);

/* If `back` is true, undoes the last command. Otherwise redoes the command that was undone last. Returns the
 * text of the command, or NULL if there is no such command. */
const char *undo_step(struct undo *undo, struct state *state, bool back);
