/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The state of one calculator session: parameters, where input comes from, what went wrong.
 * One table knows every parameter; set, show, reset, help and completion read it.
 */
#ifndef SHELL_SESSION_H
#define SHELL_SESSION_H

#include "domino.h"
#include "output.h"

struct session {
    struct dom_train train;
    struct dom_scale scale;
    enum output output;
    FILE *out;
    const char *source; /* name of the script for messages; NULL at the prompt */
    long line;
    const char *command; /* the one that runs, for messages */
    bool bail;           /* the first error ends the session */
    bool quit;
    long errors;
    bool answered; /* something was answered before */
};

void session_init(struct session *session, FILE *out);

/* One line on stderr: where, what was wrong, what would be right.  Counts, and returns false. */
bool session_error(struct session *session, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Also for a library status that is not DOM_OK. */
bool session_status(struct session *session, enum dom_status status);

/* A name for a value: hollow = 3, exact = 0. */
struct word {
    const char *name;
    double value;
};

struct parameter {
    const char *name, *unit, *meaning;
    double fallback, lowest, highest;
    const struct word *words; /* names for some values; NULL for none */
    bool words_only;          /* stored as an enum */
    size_t offset;            /* in struct session */
    bool setting;             /* of the calculator rather than of the model: a plain reset keeps it */
};

/* All parameters in the order of show; ends with a NULL name. */
extern const struct parameter session_parameters[];

const struct parameter *parameter_find(const char *name);
double parameter_get(const struct session *session, const struct parameter *parameter);
void parameter_put(struct session *session, const struct parameter *parameter, double value);

/*
 * Text as a value of this parameter: a number, a quotient of two, or one of its words, in its range.
 * What is wrong is an error of the session.
 */
bool parameter_parse(struct session *session, const struct parameter *parameter, const char *text,
                     double *value);

/* The name of a value that has one, else NULL. */
const char *parameter_word(const struct parameter *parameter, double value);

/* "1e-12 .. 1", or "exact | paper". */
void parameter_range(const struct parameter *parameter, char *text, size_t size);

#endif
