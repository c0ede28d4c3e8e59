/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/session.h"
#include "answer/format.h"
#include "io/terminal.h"
#include <stdlib.h>
#include <string.h>

void session_init(struct session *session, FILE *out)
{
    *session = (struct session){.train = domq_train_default(),
                                .compute = domq_compute_default(),
                                .scale = domq_scale_default(),
                                .out = out,
                                .standard = out};
    session->style.digits = DIGITS_DEFAULT;
    session->style.header = true;
    session->seed = SEED_DEFAULT;
    session->hints = 1;
}

void listed_free(struct listed_row *row)
{
    if (!row->holders || --*row->holders == 0) {
        free(row->domino);
        free(row->width);
        free(row->path);
        free(row->holders);
    }
    free(row->placed);
    *row = (struct listed_row){.domino = NULL};
}

bool listed_share(struct listed_row *to, struct listed_row *from)
{
    size_t size = from->changes * sizeof *from->placed;
    *to = (struct listed_row){.domino = NULL};
    if (from->domino && !from->holders && (from->holders = malloc(sizeof *from->holders)) != NULL)
        *from->holders = 1;
    struct placed *placed = size ? malloc(size) : NULL;
    if ((from->domino && !from->holders) || (size && !placed)) {
        free(placed);
        return false;
    }
    *to = *from;
    to->placed = placed;
    if (size)
        memcpy(placed, from->placed, size);
    if (from->holders)
        ++*from->holders;
    return true;
}

const struct format *session_format(const struct session *session)
{
#define FORMAT_POINTER(name) &format_##name,
    static const struct format *const formats[] = {FORMATS(FORMAT_POINTER)};
#undef FORMAT_POINTER
    return formats[session->style.output];
}

const struct format *session_answers(const struct session *session)
{
    return session->format ? session->format : session_format(session);
}

void effects_apply(struct session *session)
{
#define APPLY(name, member, status)                                                                          \
    session->train.member =                                                                                  \
        session->effect[DOM_EFFECT_##name].on ? session->effect[DOM_EFFECT_##name].value[0] : 0;
    DOM_DYNAMICS(APPLY)
#undef APPLY
}

void effects_reset(struct session *session)
{
    for (int k = 0; k < EFFECT_COUNT; k++)
        session->effect[k] = (struct effect_state){.on = false};
    listed_free(&session->listed);
    effects_apply(session);
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
    effects_reset(session);
    variables_free(&session->variables);
    if (session->undo)
        session->undo_free(session->undo);
    session->undo = NULL;
}

domq_real session_filled(const struct session *session, domq_real height, domq_real thickness,
                         domq_real width)
{
    struct domq_box box = {.filled = 1};
    domq_real walls = session->train.walls * session->scale.h;
    return walls > 0 && domq_box_find(height, thickness, width, walls, &box) == DOM_OK ? box.filled : 1;
}

domq_real session_block_mass(const struct session *session, domq_real height, domq_real thickness)
{
    domq_real filled = session_filled(session, height, thickness, height / 2);
    return session->mass > 0 ? session->mass : session->density * height * height * thickness / 2 * filled;
}

domq_real session_mass(const struct session *session)
{
    domq_real h = session->scale.h;
    return session_block_mass(session, h, session->train.d * h);
}

struct range session_part(const struct session *session, size_t points)
{
    struct shard s = session->shard;
    if (s.parts == 0)
        return (struct range){0, points};
    /* points k / parts, rounded down, without the product, which may be too large. */
    size_t whole = points / s.parts, rest = points % s.parts, k = s.part - 1;
    size_t first = whole * k + rest * k / s.parts, end = whole * (k + 1) + rest * (k + 1) / s.parts;
    return (struct range){first, end - first};
}

bool session_stops(const struct session *session, long errors)
{
    return session->quit || ferror(session->out) || (session->bail && session->errors > errors) ||
           dom_raised(session->compute.interrupt);
}

struct domq_compute session_compute(const struct session *session)
{
    struct domq_compute compute = session->compute;
    compute.errors = session->style.errors;
    return compute;
}
