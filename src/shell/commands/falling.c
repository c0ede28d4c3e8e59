/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/falling.h"

const char locks_farther_on[] =
    "what is left of the motion does not carry it over, and farther on friction locks: no energy would";

struct cell cell_narrow(domq_real value, int digits)
{
    struct cell cell = cell_bound(value, DOMQ_NAN);
    cell.digits = digits;
    return cell;
}

bool row_status(struct session *session, enum dom_status status)
{
    if (status < DOM_BAD_COUNT || status > DOM_BAD_MASS)
        return session_status(session, status);
    return session_no_answer(session,
                             "the dominoes of this row become larger or smaller than %s precision can hold; "
                             "fewer of them, a smaller r, or a wider precision",
                             domq_arithmetic(session->compute.precision)->name);
}

void verdict_say(struct session *session, struct answer *a, const struct scene_row *scene,
                 const struct domq_verdict *v, bool timed)
{
    size_t count = scene->row.count;
    if (v->end == DOM_ROW_FALLS && !timed)
        answer_say(a, "All %zu fall: nothing has to be mended.", count);
    else if (v->end == DOM_ROW_FALLS && count == 1)
        answer_say(a, isnan(scene->row.push) ? "It falls." : "It falls, and lies %.4g s after the push.",
                   (double)v->seconds);
    else if (v->end == DOM_ROW_FALLS && isfinite(v->seconds))
        answer_say(a, "All %zu fall; the last lies %.4g s after the %s.", count, (double)v->seconds,
                   isnan(scene->row.push) ? "first hit" : "push");
    else if (v->end == DOM_ROW_FALLS)
        answer_say(a, "All fall; one comes so close to a stop that its time has no value.");
    else if (v->end == DOM_ROW_STOPS && !isfinite(v->short_by))
        answer_say(a, "It stops at domino %zu of %zu: %s.", v->domino, count, locks_farther_on);
    else if (v->end == DOM_ROW_STOPS)
        answer_say(a, "It stops at domino %zu of %zu, short by %.4g %s: %s.%s", v->domino, count,
                   (double)v->short_by, scene_weighed(session) ? "J" : "m g h/2 of the first",
                   dom_row_end_text(v->end), count > 1 ? " 'mend' looks for what saves it." : "");
    else
        answer_say(a, "It ends at domino %zu of %zu: %s.", v->domino, count, dom_row_end_text(v->end));
    if (v->weakest > 0 && isfinite(v->spare))
        answer_say(a, "The weakest that goes on is domino %zu: it has %.4g times the energy that it needs.",
                   v->weakest, (double)v->spare + 1);
}
