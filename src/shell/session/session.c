/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/session.h"
#include "answer/answer.h"
#include "io/escape.h"
#include "io/io.h"
#include "io/terminal.h"
#include "language/names.h"
#include "session/parameters.h"
#include "session/row.h"
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static void note(void *context, const char *text)
{
    session_note(context, "%s", text);
}

void session_init(struct session *session, FILE *out)
{
    *session = (struct session){.standard.out = out};
    session->output = &session->standard;
    session->run_context = (struct run_context){.note = note, .note_context = session};
    state_init(&session->state);
}

const struct format *session_format(const struct session *session)
{
    return session->output->format ? session->output->format : formats[session->state.settings.style.output];
}

struct query session_query(struct session *session)
{
    session->run_context.script = session->source.name;
    session->run_context.sourced = session->source.depth > 0;
    return (struct query){.state = &session->state,
                          .scene = &session->state.scene,
                          .ans = &session->ans,
                          .walk = &session->walk,
                          .run_context = &session->run_context};
}

bool session_stops(const struct session *session, long errors)
{
    return session->quit || ferror(session->output->out) || (session->bail && session->errors > errors) ||
           dom_raised(session->state.scene.compute.interrupt);
}

/* ---- Errors and notes ---- */

/* At the prompt, writes a caret below the column of the error, unless something stands between the typed line
 * and the caret. The terminal wraps a line that is longer than its width. */
static void session_caret(const struct session *session, int column)
{
    const int width = terminal_width(stderr), at = session->source.prompt_width + column;
    if (session->source.prompt_width && column && session->is_last && width > 0)
        fprintf(stderr, "%*s\n", (at - 1) % width + 1, "^");
}

static void session_write(struct session *session, const struct problem *problem, bool is_error)
{
    char line[2 * PROBLEM_TEXT], text[4 * sizeof line];
    const char *source = session->source.name;
    /* control characters could hide the message */
    source = source && escape_needed(source) ? names_shown(source) : source;
    int n = 0;
    /* the answer so far must come before the message if stdout and stderr are the same file */
    output_flush(session->output);
    progress_end();
    session_caret(session, problem->column);
    if (source && problem->column)
        n = snprintf(line, sizeof line, "%s:%ld:%d: ", source, session->source.line, problem->column);
    else if (source)
        n = snprintf(line, sizeof line, "%s:%ld: ", source, session->source.line);
    n = n < (int)sizeof line / 2 ? n : (int)sizeof line / 2;
    if (problem->command)
        n += snprintf(line + n, sizeof line - (size_t)n, "%s: ", problem->command);
    snprintf(line + n, sizeof line - (size_t)n, "%s", problem->text);
    escape_text(line, text, sizeof text);
    if (session->log)
        session->log->message(text);
    /* A script's error message also stands among the answers, if the output format can represent errors. */
    const struct format *format = formats[session->state.settings.style.output];
    if (is_error && format->failed && session->source.name) {
        format->failed(session->standard.out, problem->command, problem->text, session->source.name,
                       session->source.line, problem->column);
        output_flush(&session->standard);
    }
    write_wrapped(stderr, text, 0, terminal_width(stderr));
    putc('\n', stderr);
    session->is_last = false;
}

void session_problem(struct session *session, const struct problem *problem)
{
    session_write(session, problem, true);
    session->errors++;
}

void session_say(struct session *session, bool is_error, const char *format, ...)
{
    struct problem problem = {.command = is_error ? NULL : session->command};
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(problem.text, sizeof problem.text, format, arguments);
    va_end(arguments);
    session_write(session, &problem, is_error);
    session->errors += is_error;
}

/* ---- The query ---- */

void run_context_note(const struct run_context *run_context, const char *format, ...)
{
    char text[PROBLEM_TEXT];
    va_list arguments;
    if (!run_context->note)
        return;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    run_context->note(run_context->note_context, text);
}

/* ---- Undo ---- */

enum {
    STEPS = 100,        /* the maximum number of steps */
    HELD_MOST = 4000000 /* the maximum of the sum of slot.size over all steps, which limits the memory */
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
    if (copy->scene.slot)
        copy->scene.slot->holders++;
    if (variables_copy(&copy->variables, &state->variables))
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
    bool is_equal = good && state->scene.slot == before->scene.slot &&
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
            const struct slot *slot = u->step[k].state->scene.slot;
            held += slot ? slot->size : 0;
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

void session_close(struct session *session)
{
    while (session->output->below)
        output_pop(&session->output, true);
    if (session->log)
        session->log->close();
    state_close(&session->state);
    if (session->undo)
        steps_drop(session->undo, 0, session->undo->count);
    free(session->undo);
    free(session->details);
    session->undo = NULL;
}
