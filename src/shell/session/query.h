/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A question in the form in which an answer gets it: the state, the arguments, the last answer, and the
 * means. */
#ifndef SHELL_QUERY_H
#define SHELL_QUERY_H

#include "answer/answer.h"
#include "session/scene.h"

struct command;
struct arguments;

/* Which part of a sweep or study is asked for: --shard part/parts. */
struct shard {
    size_t part, parts;
};

/* How to compute and where from: none of it changes an answer. */
struct means {
    struct shard shard;                            /* parts is 0 where the whole is asked for */
    bool safe;                                     /* files may not be touched */
    bool sourced;                                  /* the command is in a file that is sourced */
    const char *script;                            /* names files beside itself; NULL at the prompt */
    void (*note)(void *context, const char *text); /* tells a person more, at once; NULL: nobody is told */
    void *context;                                 /* of note */
};

/* Tells what is no problem, and worth knowing. */
void means_note(const struct means *means, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The part of so many points, or other parts of an answer, that is asked for: its first number, and its size.
 */
struct range {
    size_t first, count;
};
struct range means_part(const struct means *means, size_t points);

enum { ANSWER_CELLS = 16 };

/* The last answer, as expressions use it. */
struct ans {
    const struct command *command; /* that gave it; NULL for none */
    struct cell cells[ANSWER_CELLS];
    bool printed; /* it was the value of an expression */
    struct quantity value;
};

struct query {
    const struct state *state;
    const struct scene *scene; /* of the state */
    const struct arguments *given;
    const struct ans *ans;
    const struct means *means;
    struct state *next; /* the state that the command leaves; NULL: nothing is kept */
};

/* Returns how to compute an answer: with bounds of its errors if the settings ask for them. */
struct domq_compute query_compute(const struct query *query);

#endif
