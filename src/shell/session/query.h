/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The input of a command: a state, the command's arguments, the last answer, and the means of computing. */
#ifndef SHELL_QUERY_H
#define SHELL_QUERY_H

#include "answer/answer.h"
#include "session/scene.h"

struct command;
struct arguments;

/* The part of a sweep or study that the option --shard requests, counted from 1. Without --shard, `parts` is
 * 0. */
struct shard {
    size_t part, parts;
};

/* The circumstances in which a command runs, which do not change the numbers in its answer. */
struct means {
    struct shard shard;
    bool safe;          /* commands may not touch files */
    bool sourced;       /* the command comes from a file that 'source' runs */
    const char *script; /* the path of the script, to find files in its directory; NULL at the prompt */
    /* Shows a note to the user at once. May be NULL. */
    void (*note)(void *context, const char *text);
    void *context; /* for `note` */
};

/* Shows a note to the user. */
void means_note(const struct means *means, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Returns the range of points that --shard requests: the index of the first point, and the number of
 * points. */
struct range {
    size_t first, count;
};
struct range means_part(const struct means *means, size_t points);

enum { ANSWER_CELLS = 16 };

/* The last answer, for 'ans' in expressions. */
struct ans {
    const struct command *command; /* the command of the last answer; NULL if there has been none */
    struct cell cells[ANSWER_CELLS];
    bool printed; /* the last answer was the value of an expression, which is stored in `value` */
    struct quantity value;
};

/* How far the commands that step through the motion of the train have come. `theta` is the tilt that they
 * have reached, at an event or between two events of a cycle. */
struct walk {
    struct domq_train train; /* the train of the walk; when the scene's train changes, a new walk begins */
    struct domq_compute compute; /* the options of the walk, with a smaller tolerance than the session's */
    domq_real tol;               /* the session's tolerance when the walk began */
    struct domq_event events[DOM_EVENTS_MAX];
    int count; /* the number of events; 0 if no walk has begun */
    int event; /* the index of the last event that the walk has passed */
    domq_real theta;
    int cycle;               /* the number of the cycle, from 1 */
    enum dom_status verdict; /* DOM_OK or DOM_STOPS */
};

struct query {
    const struct state *state;
    const struct scene *scene; /* the scene of `state` */
    const struct arguments *given;
    const struct ans *ans;
    const struct means *means;
    struct walk *walk;  /* the session's walk through the motion of the train */
    struct state *next; /* the state that the command may change; NULL if changes are not kept */
};

/* query_options returns the options for computations of the library, which request error bounds if the
 * settings do. query_compute returns a pointer to these options, which live until the end of the block that
 * contains the call. */
static inline struct domq_compute query_options(const struct query *query)
{
    struct domq_compute compute = query->scene->compute;
    compute.errors = query->state->settings.style.errors;
    return compute;
}
#define query_compute(query) ((const struct domq_compute[]){query_options(query)})

/* Calls problem_status for the scene of a query. */
static inline bool query_status(const struct query *query, struct problem *problem, enum dom_status status)
{
    return problem_status(problem, query->scene, status);
}

#endif
