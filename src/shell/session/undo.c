/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/undo.h"
#include "session/parameters.h"
#include <stdlib.h>
#include <string.h>

enum { STEPS = 100, HELD_MOST = 4000000 /* dominoes and changed gaps of all steps */ };

struct step {
    struct state *state;
    char text[NAMES_SHOWN];
};

/* The steps back, and those forward again. */
struct undo {
    struct stack {
        struct step step[STEPS];
        int count;
    } back, forward;
};

static void state_free(struct state *state)
{
    if (state) {
        listed_free(&state->scene.listed);
        variables_free(&state->variables);
    }
    free(state);
}

struct state *undo_begin(struct session *session)
{
    struct state *state = malloc(sizeof *state);
    if (!state)
        return NULL;
    *state = session->state;
    bool shared = listed_share(&state->scene.listed, &session->state.scene.listed);
    if (variables_copy(&state->variables, &session->state.variables) && shared)
        return state;
    state_free(state);
    return NULL;
}

static bool row_equal(const struct listed_row *a, const struct listed_row *b)
{
    bool equal = a->domino == b->domino && a->changes == b->changes;
    for (size_t i = 0; equal && i < a->changes; i++)
        equal = a->placed[i].k == b->placed[i].k && a->placed[i].gap == b->placed[i].gap;
    return equal;
}

static bool state_equal(const struct state *a, const struct state *b)
{
    for (const struct parameter *p = session_parameters; p->name; p++) {
        if (parameter_get(a, p) != parameter_get(b, p))
            return false;
        for (int i = 1; p->effect && a->scene.effect[p->which].on && parameter_value(p, i); i++)
            if (a->scene.effect[p->which].value[i] != b->scene.effect[p->which].value[i])
                return false;
    }
    return row_equal(&a->scene.listed, &b->scene.listed) && variables_equal(&a->variables, &b->variables);
}

/* Moves a state into the session, whose walk goes on; what the session held is freed. */
static void state_put(struct session *session, struct state *state)
{
    const struct walk walk = session->state.scene.walk;
    listed_free(&session->state.scene.listed);
    variables_free(&session->state.variables);
    session->state = *state;
    session->state.scene.walk = walk;
    free(state);
}

static void drop_oldest(struct stack *stack)
{
    state_free(stack->step[0].state);
    stack->count--;
    memmove(stack->step, stack->step + 1, (size_t)stack->count * sizeof *stack->step);
}

static void drop_all(struct stack *stack)
{
    while (stack->count > 0)
        state_free(stack->step[--stack->count].state);
}

/* Adds a step, and drops the oldest where there are too many, or too much is held. */
static void push(struct stack *stack, struct state *state, const char *text)
{
    size_t held = 0;
    if (stack->count == STEPS)
        drop_oldest(stack);
    struct step *step = &stack->step[stack->count++];
    step->state = state;
    memmove(step->text, text, strlen(text) + 1);
    for (int i = 0; i < stack->count; i++)
        held += stack->step[i].state->scene.listed.count + stack->step[i].state->scene.listed.changes;
    for (; held > HELD_MOST && stack->count > 1; drop_oldest(stack))
        held -= stack->step[0].state->scene.listed.count + stack->step[0].state->scene.listed.changes;
}

static void undo_free(struct undo *undo)
{
    drop_all(&undo->back);
    drop_all(&undo->forward);
    free(undo);
}

void undo_keep(struct session *session, struct state *before, const char *text, size_t length)
{
    char shown[NAMES_SHOWN];
    char *copy = strndup(text, length);
    if (before && copy && !state_equal(&session->state, before) && !session->undo)
        session->undo = calloc(1, sizeof *session->undo);
    session->undo_free = undo_free;
    if (before && copy && session->undo && !state_equal(&session->state, before)) {
        drop_all(&session->undo->forward);
        push(&session->undo->back, before, names_shown(copy, shown));
    } else
        state_free(before);
    free(copy);
}

const char *undo_step(struct session *session, bool back, char text[NAMES_SHOWN])
{
    struct undo *undo = session->undo;
    struct stack *from = !undo ? NULL : back ? &undo->back : &undo->forward;
    struct state *now = from && from->count > 0 ? undo_begin(session) : NULL;
    if (!now)
        return NULL;
    struct step *step = &from->step[--from->count];
    memcpy(text, step->text, NAMES_SHOWN);
    state_put(session, step->state);
    push(back ? &undo->forward : &undo->back, now, text);
    return text;
}
