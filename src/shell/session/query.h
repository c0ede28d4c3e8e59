/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The input of a command: the state, the arguments, the last answer, and the context in which the command
 * runs. */
#pragma once

#include "answer/answer.h"
#include "session/scene.h"

struct command;
struct arguments;

/* The context in which a command runs. It does not affect the numbers. */
struct run_context {
    bool safe; /* commands must not read or write files */
    /* a command whose numbers suppose that its verdict is yes has no answer if it is no (sweep.needs_yes) */
    bool seeks_yes;
    bool sourced;       /* the command comes from a file that 'source' runs */
    const char *script; /* the path of the running script, or "-e" or "stdin"; NULL at the prompt */
    /* Shows a note to the user immediately. May be NULL. */
    void (*note)(void *context, const char *text);
    void *note_context;
};

void run_context_note(const struct run_context *run_context, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

enum { ANSWER_CELLS = 16 };

/* The last answer, for 'ans' in expressions. */
struct last_answer {
    const struct command *command; /* the command that gave the answer; NULL if there is no answer */
    struct cell cells[ANSWER_CELLS];
    bool with;    /* it was computed 'with' other settings than those of the session */
    bool printed; /* the last answer was the value of an expression, which is stored in `value` */
    struct quantity value;
};

/* The place that 'step', 'back' and 'goto' have reached in the motion of the train. */
struct walk {
    struct domq_train train; /* when the train of the scene changes, a new walk begins */
    int cycle;               /* the number of the cycle, counted from 1; 0 if no walk has begun */
    int event;               /* the index of the last event that has been reached or passed */
    bool is_between;         /* the place is between this event and the next */
    domq_real theta;         /* the tilt of the head at this place */
};

struct query {
    const struct state *state;
    const struct scene *scene; /* the scene of `state` */
    const struct arguments *given;
    const struct last_answer *ans;
    const struct run_context *run_context;
    struct walk *walk;
    struct state *next; /* the state that the command may change; NULL if changes are not kept */
    /* The answer in quad that this one is a part of, with which the feature 'errors' compares another answer.
     * Otherwise NULL. */
    struct reference *reference;
};

/* Returns the options for the library. */
static inline const struct any_compute *query_compute(const struct query *query)
{
    return &query->scene->compute;
}

static inline bool query_status(const struct query *query, struct problem *problem, enum dom_status status)
{
    return problem_status(problem, query->scene, status);
}
