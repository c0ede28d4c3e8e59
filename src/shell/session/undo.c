/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/undo.h"
#include "language/names.h"
#include "session/parameters.h"
#include "session/row.h"
#include <stdlib.h>
#include <string.h>

enum {
    STEPS = 100, /* the maximum number of steps */
    /* The maximum total length of the arrays listed_row.domino and listed_row.change in all steps, which
     * limits the memory for the history. */
    HELD_MOST = 4000000
};

/* A step for each command that has changed the state. The first `done` steps can be undone. Each of them
 * holds the state before its command. The other steps have been undone, and can be redone. Each of them holds
 * the state after its command. */
struct undo {
    struct step {
        struct state *state;
        char text[NAMES_SHOWN];
    } step[STEPS];
    int done, count;
};

static void state_free(struct state *state)
{
    if (state)
        state_close(state);
    free(state);
}

struct state *undo_begin(const struct state *state)
{
    struct state *copy = malloc(sizeof *copy);
    if (!copy)
        return NULL;
    *copy = *state;
    bool shared = listed_share(&copy->scene.listed, &state->scene.listed);
    if (variables_copy(&copy->variables, &state->variables) && shared)
        return copy;
    state_free(copy);
    return NULL;
}

/* Removes the steps with the indices from `from` up to, but not including, `to`. */
static void steps_drop(struct undo *undo, int from, int to)
{
    for (int k = from; k < to; k++)
        state_free(undo->step[k].state);
    memmove(&undo->step[from], &undo->step[to], (size_t)(undo->count - to) * sizeof *undo->step);
    undo->count -= to - from;
}

void undo_keep(struct undo **undo, const struct state *state, struct state *before, const char *text,
               size_t length)
{
    char *copy = strndup(text, length);
    if (!*undo)
        *undo = calloc(1, sizeof **undo);
    struct undo *u = *undo;
    const bool good = before && copy && u;
    bool is_equal = good && state->scene.listed.domino == before->scene.listed.domino &&
                    row_changes_equal(&state->scene, &before->scene) &&
                    variables_equal(&state->variables, &before->variables);
    for (const struct parameter *p = session_parameters; p->name && is_equal; p++)
        is_equal = parameter_equal(state, before, p);
    if (good && !is_equal) {
        steps_drop(u, u->done, u->count);
        if (u->count == STEPS)
            steps_drop(u, 0, 1);
        u->step[u->count].state = before;
        escape_text(copy, u->step[u->count++].text, NAMES_SHOWN);
        size_t held = 0;
        for (int k = u->count - 1; k >= 0; k--) {
            held += u->step[k].state->scene.listed.count + u->step[k].state->scene.listed.changes;
            if (held > HELD_MOST && k < u->count - 1) {
                steps_drop(u, 0, k + 1);
                break;
            }
        }
        u->done = u->count;
    } else
        state_free(before);
    free(copy);
}

const char *undo_step(struct undo *undo, struct state *state, bool back)
{
    if (!undo || undo->done == (back ? 0 : undo->count))
        return NULL;
    struct step *step = &undo->step[back ? --undo->done : undo->done++];
    const struct state left = *state;
    *state = *step->state;
    *step->state = left;
    return step->text;
}

void undo_free(struct undo *undo)
{
    if (undo)
        steps_drop(undo, 0, undo->count);
    free(undo);
}
