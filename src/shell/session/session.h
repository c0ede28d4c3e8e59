/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The state of one calculator session: parameters, where input comes from, what went wrong.  parameters.h has
 * the table of the parameters; messages.c writes errors and notes.
 */
#ifndef SHELL_SESSION_H
#define SHELL_SESSION_H

#include "answer/output.h"
#include "domino_quad.h"
#include "io/record.h"
#include "language/variables.h"
#include "session/engine_effects.h"

struct command;

enum { ANSWER_CELLS = 16, SOURCE_DEPTH = 16 };

/* What the session asks of an effect. */
struct effect_state {
    bool on;
    domq_real value[DOM_EFFECT_ARGUMENTS];
};

/* The message of a session that is not to write it, and what it is about. */
struct captured_error {
    char text[512];
    int column;
    const char *command;
    bool no_answer; /* see session_no_answer */
};

/* Which part of a sweep or study is asked for: --shard part/parts. */
struct shard {
    size_t part, parts;
};

/* Dominoes that are listed in a file, and gaps that were changed since. */
struct listed_row {
    struct domq_domino *domino; /* NULL for none */
    size_t count;
    bool weighed;     /* masses are in kg; else they are relative */
    domq_real *width; /* m, of each, where masses follow from volumes; NULL: masses are given */
    char *path;
    struct placed {
        size_t k; /* from 1 */
        domq_real gap;
    } * placed;
    size_t changes;
    bool saved;      /* no gap was changed since the row was written to a file */
    size_t *holders; /* of the dominoes and the path: states of the session that share them; NULL: one */
};

/* The place of a walk through the cycles: at an event of a cycle, or between two. */
struct walk {
    struct domq_train
        train; /* the train of the session when the walk began; with another train the walk begins again */
    struct domq_compute compute; /* to a finer tolerance than the session's */
    domq_real tol;               /* the session's then */
    struct domq_event events[DOM_EVENTS_MAX];
    int count; /* of the events; 0: no walk has begun */
    int event; /* the last one that was passed */
    domq_real theta;
    int cycle;               /* from 1 */
    enum dom_status verdict; /* DOM_OK, or DOM_STOPS */
};

/* What 'log' and 'tee' have begun. */
struct recording {
    struct record log, tee;
    FILE *stream; /* writes to standard output and to the records; NULL: there are none */
    FILE *alone;  /* standard output while there are */
};

struct session {
    struct domq_train train;
    struct domq_compute compute; /* without bounds of errors: see session_compute */
    struct domq_scale scale;
    domq_real mass, density;   /* of the first domino, in kg; of solid dominoes, in kg/m^3; 0: not known */
    struct output_style style; /* output, digits, angle */
    unsigned timing, hints;
    unsigned method;         /* what runs rows, see engine.h */
    domq_real seed, threads; /* of random rows; 0 threads: as many as there are processors */
    struct effect_state effect[EFFECT_COUNT];
    struct listed_row listed; /* the row, where it is not counted */
    struct variables variables;
    struct undo *undo; /* earlier states; NULL: none */
    void (*undo_free)(struct undo *undo);
    const struct scope *scope; /* the function that is being evaluated; NULL: none */
    struct walk walk;
    FILE *out;              /* where answers go: standard output, or the file after '>' */
    FILE *standard;         /* standard output, also while answers go to a file */
    char head[ANSWER_HEAD]; /* the last head that csv wrote into `out`; "" for none */
    const char *source;     /* name of the script for messages; NULL at the prompt */
    long line;
    int column;        /* of what a message is about, from 1; 0 for none */
    int prompt_width;  /* at the prompt: columns before the line, for the caret; else 0 */
    const char *typed; /* the line that runs, as it was typed, not ended */
    int typed_length, typed_columns;
    bool fresh;                  /* at the prompt: no output is below the typed line yet */
    bool appended;               /* the file comes after '>>' */
    const char *redirected;      /* the name of the file after '>', which `out` is; NULL: none */
    const struct format *format; /* of that file, if its ending names one; NULL: as 'set output' has it */
    const char *command;         /* the one that runs, for messages */
    struct captured_error
        *captured_error; /* unless NULL, takes the first message: this session is a point of a sweep */
    struct recording recording;
    struct shard shard; /* parts is 0 where the whole is asked for */
    bool bail;          /* the first error ends the session */
    bool safe;          /* commands may not touch files */
    bool quit;
    bool answered; /* something was answered before */
    bool wrote;    /* the last command wrote rows */
    int depth;     /* of nested source commands */
    long errors;
    int write_error; /* errno of the first answer that could not be written; 0 for none */
    struct {
        const struct command *command; /* that gave the last answer; NULL for none */
        struct cell cells[ANSWER_CELLS];
        bool printed; /* the last answer was the value of an expression */
        struct quantity value;
    } ans;
};

/* Return the format that 'set output' has chosen; and that of answers here, which the ending of a file may
 * set. */
const struct format *session_format(const struct session *session);
const struct format *session_answers(const struct session *session);

/* Closes the records, so that answers go to standard output alone. */
void recording_end(struct session *session);

enum { SEED_DEFAULT = 1, DIGITS_DEFAULT = 6 };

/* Begins a session in which every parameter has its default. */
void session_init(struct session *session, FILE *out);

/* Frees what the session holds. */
void session_close(struct session *session);

/* Turns every effect off, and frees what the session holds for them. */
void effects_reset(struct session *session);

/* Copies the values of the effects to the session's train. */
void effects_apply(struct session *session);

/* Returns true if changed gaps of the row are in no file yet. */
static inline bool row_unsaved(const struct session *session)
{
    return session->listed.changes > 0 && !session->listed.saved;
}

/* Copies a row that shares its dominoes with the other one; each is freed on its own.  False: no memory. */
bool listed_share(struct listed_row *to, struct listed_row *from);

/* Frees a listed row. */
void listed_free(struct listed_row *row);

/* Returns the share of the volume of a domino that is filled: by its walls, or all of a solid block. */
domq_real session_filled(const struct session *session, domq_real height, domq_real thickness,
                         domq_real width);

/* Return the first domino's mass in kg, of a block of these sizes in m, or of h and d; 0: not known. */
domq_real session_block_mass(const struct session *session, domq_real height, domq_real thickness);
domq_real session_mass(const struct session *session);

enum message {
    MESSAGE_ERROR,     /* the line is wrong */
    MESSAGE_NO_ANSWER, /* the line is right, but has no answer with these values: a sweep goes on */
    MESSAGE_NOTE,      /* no error, and not counted as one: why an answer is not whole */
};

/* Writes one line on stderr: where, what was wrong, what would be right.  Returns false. */
bool session_report(struct session *session, enum message what, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
#define session_error(session, ...)     session_report(session, MESSAGE_ERROR, __VA_ARGS__)
#define session_no_answer(session, ...) session_report(session, MESSAGE_NO_ANSWER, __VA_ARGS__)
#define session_note(session, ...)      (void)session_report(session, MESSAGE_NOTE, __VA_ARGS__)

/* The part of a session in so many points, or other parts of an answer: its first number, and how many it
 * has. */
struct range {
    size_t first, count;
};
struct range session_part(const struct session *session, size_t points);

/*
 * Returns true if the rest of the input must not be run: after quit, after ^C, if there is no reader of the
 * output, and with bail after an error (session->errors was `errors` before).
 */
bool session_stops(const struct session *session, long errors);

/* Reports that the walls have no room in domino k, or in that of a train if k is 0.  Returns false. */
bool session_no_room(struct session *session, size_t k, domq_real thickness);

/* Reports a library status that is not DOM_OK.  Returns false. */
bool session_status(struct session *session, enum dom_status status);

/* Returns how to compute an answer: with bounds of its errors if the session asks for them. */
struct domq_compute session_compute(const struct session *session);

#endif
