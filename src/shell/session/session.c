/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/session.h"
#include "answer/format.h"
#include "io/terminal.h"
#include <stdlib.h>
#include <string.h>

static void note(void *context, const char *text)
{
    session_note(context, "%s", text);
}

void session_init(struct session *session, FILE *out)
{
    *session = (struct session){.out = out, .standard = out};
    session->means = (struct means){.note = note, .context = session};
    state_init(&session->state);
}

const struct format *session_format(const struct session *session)
{
    return format_at(session->state.settings.style.output);
}

const struct format *session_answers(const struct session *session)
{
    return session->format ? session->format : session_format(session);
}

void recording_end(struct session *session)
{
    struct recording *r = &session->recording;
    if (r->stream) {
        terminal_lend(NULL, NULL);
        fclose(r->stream);
        session->out = session->standard = r->alone;
        r->stream = NULL;
    }
    record_close(&r->log);
    record_close(&r->tee);
}

void session_close(struct session *session)
{
    recording_end(session);
    state_close(&session->state);
    if (session->undo)
        session->undo_free(session->undo);
    session->undo = NULL;
}

struct query session_query(struct session *session)
{
    session->means.script = session->source;
    session->means.sourced = session->depth > 0;
    return (struct query){.state = &session->state,
                          .scene = &session->state.scene,
                          .ans = &session->ans,
                          .means = &session->means};
}

bool session_stops(const struct session *session, long errors)
{
    return session->quit || ferror(session->out) || (session->bail && session->errors > errors) ||
           dom_raised(session->state.scene.compute.interrupt);
}
