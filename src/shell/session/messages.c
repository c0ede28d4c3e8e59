/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Errors and notes of a session: where, what is wrong, what would be right. */
#include "answer/format.h"
#include "answer/measure.h"
#include "io/escape.h"
#include "io/pager.h"
#include "io/terminal.h"
#include "language/names.h"
#include "language/quad.h"
#include "session/session.h"
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* Blanks before a line that is repeated above its caret. */
enum { CARET_INDENT = 2 };

/* Returns true if the typed line may be written again: it was pasted, perhaps. */
static bool typed_is_plain(const struct session *session)
{
    char *typed = strndup(session->typed, (size_t)session->typed_length);
    bool plain = typed && !escape_needed(typed);
    free(typed);
    return plain;
}

/*
 * At the prompt a caret points at the place: in the typed line, if that is the line above, else in a
 * copy of it.
 */
static void session_caret(const struct session *session)
{
    int width = terminal_width(stderr), at = session->prompt_width + session->column;
    if (!session->prompt_width || !session->column || !session->typed)
        return;
    bool above = session->fresh && width > 0;
    if (!above && (session->typed_columns + CARET_INDENT >= width || !typed_is_plain(session)))
        return;
    if (above) /* a long line goes on in the next row */
        at = (at - 1) % width + 1;
    if (!above)
        fprintf(pager_messages(), "%*s%.*s\n", CARET_INDENT, "", session->typed_length, session->typed);
    fprintf(pager_messages(), "%*s\n", above ? at : session->column + CARET_INDENT, "^");
}

/* Keeps the first message of a point of a sweep, which has no terminal. */
static void session_keep(const struct session *session, bool no_answer, const char *format, va_list arguments)
{
    struct captured_error *h = session->captured_error;
    if (*h->text)
        return;
    h->column = session->column;
    h->command = session->command;
    h->no_answer = no_answer;
    vsnprintf(h->text, sizeof h->text, format, arguments);
}

/* Writes an error for the program that reads the answers, if their format has a place for one. */
static void session_tell(const struct session *session, const char *text)
{
    const struct format *format = session_format(session);
    const struct failure failure = {session->command, text, session->source, session->line, session->column};
    if (!format->failed || !session->source)
        return;
    format->failed(session->standard, &failure);
    fflush(session->standard);
}

static void session_write(struct session *session, enum message what, const char *format, va_list arguments)
{
    char line[1024], text[4 * sizeof line], shown[NAMES_SHOWN];
    const char *source = session->source;
    if (source && escape_needed(source))
        source = names_shown(source, shown); /* a name may not hide the message after it */
    int n = 0;
    fflush(session->out); /* so that both streams keep their order where they share a file */
    ticker_stop();
    session_caret(session);
    if (source && session->column)
        n = snprintf(line, sizeof line, "%s:%ld:%d: ", source, session->line, session->column);
    else if (source)
        n = snprintf(line, sizeof line, "%s:%ld: ", source, session->line);
    n = n < (int)sizeof line / 2 ? n : (int)sizeof line / 2;
    if (session->command)
        n += snprintf(line + n, sizeof line - (size_t)n, "%s: ", session->command);
    vsnprintf(line + n, sizeof line - (size_t)n, format, arguments);
    /* What a sourced file did before its error is done. */
    record_commands(&session->recording.log, what != MESSAGE_NOTE && session->depth == 0);
    if (what != MESSAGE_NOTE)
        session_tell(session, line + n);
    escape_text(line, text, sizeof text);
    if (session->recording.log.file)
        fprintf(session->recording.log.file, "# %s\n", text);
    FILE *out = pager_messages();
    bool colour = terminal_colour(stderr) && !session->source;
    fputs(!colour ? "" : what == MESSAGE_NOTE ? "\033[33m" : "\033[31m", out);
    output_wrapped(out, text, 0, session->prompt_width ? terminal_width(stderr) : 0);
    fputs(colour ? "\033[m\n" : "\n", out);
    session->fresh = false;
}

bool session_report(struct session *session, enum message what, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (session->captured_error && what != MESSAGE_NOTE)
        session_keep(session, what == MESSAGE_NO_ANSWER, format, arguments);
    else
        session_write(session, what, format, arguments);
    va_end(arguments);
    session->errors += what != MESSAGE_NOTE;
    return false;
}

bool session_no_room(struct session *session, size_t k, domq_real thickness)
{
    char which[32] = "the domino";
    if (k > 0)
        snprintf(which, sizeof which, "domino %zu", k);
    return session_no_answer(session,
                             "walls of %s leave no room in %s, which is %s thick: they are %s at most, which "
                             "makes it solid",
                             measured(session->train.walls * session->scale.h, "m", 4).text, which,
                             measured(thickness, "m", 4).text, measured(thickness / 2, "m", 4).text);
}

bool session_status(struct session *session, enum dom_status status)
{
    const struct domq_train *t = &session->train;
    session->column = 0;
    if (status == DOM_INTERRUPTED || status == DOM_NO_MEMORY) /* no matter with which values */
        return session_error(session, "%s", dom_status_text(status));
    if (status == DOM_NO_ROUND && t->rho > t->d / 2)
        return session_no_answer(session,
                                 "edges with a radius of %s h do not fit: the radius is at most half of the "
                                 "thickness; here 'effect edges %.6g' is the largest",
                                 quad_shown(t->rho).text, (double)(t->d / 2));
    domq_real stands = quad(atan)(t->d), degree = 2 * quad(atan)(1) / 90;
    if (status == DOM_NO_STAND && !session->listed.domino && quad(fabs)(t->alpha) >= stands)
        return session_no_answer(session,
                                 "no upright domino stands on this slope of %.4g deg: it is less than %.4g "
                                 "deg, where tan theta_u = d; for example 'effect slope %.2g deg'",
                                 (double)(t->alpha / degree), (double)(stands / degree),
                                 (double)(stands / degree / 2));
    if (status == DOM_OUT_OF_REACH && t->rho > 0) {
        domq_real span = 1 - t->rho * (2 - 2 * quad(atan)(1)); /* l + rho pi/2 */
        return session_no_answer(session,
                                 "r s = %s: the head falls past the next domino without touching it; with "
                                 "these rounded edges r s is at most %.6g, so that at s = %s r may be up to "
                                 "%.6g",
                                 quad_shown(t->r * t->s).text, (double)span, quad_shown(t->s).text,
                                 (double)(span / t->s));
    }
    if (status == DOM_OUT_OF_REACH)
        return session_no_answer(session,
                                 "r s = %s > 1: the head falls past the next domino without touching it; "
                                 "at s = %s r may be up to 1/s = %.17g",
                                 quad_shown(t->r * t->s).text, quad_shown(t->s).text, (double)(1 / t->s));
    if (status == DOM_NO_METHOD && domq_dynamics(t) && t->fuel == DOM_FUEL_PAPER)
        return session_no_answer(
            session, "'fuel paper' cannot be combined with %s; enter 'set fuel exact' or 'effect %s off'",
            domq_dynamics(t)->name, domq_dynamics(t)->name);
    if (status == DOM_NOT_CONVERGED && session->compute.precision != DOM_QUAD)
        return session_no_answer(session,
                                 "%s of %.3g; 'set precision %s' has more digits, 'set tol' allows fewer",
                                 dom_status_text(status), (double)session->compute.tol,
                                 session->compute.precision == DOM_FLOAT ? "double" : "quad");
    if (status == DOM_NO_ROOM)
        return session_no_room(session, 0, t->d * session->scale.h);
    if (status == DOM_TOO_LONG)
        return session_no_answer(session, "%s; use a larger s, d or tol", dom_status_text(status));
    return session_no_answer(session, "%s", dom_status_text(status));
}
