/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/rows/falling.h"
#include "commands/rows/slid.h"
#include "language/quad.h"

const char locks_farther_on[] =
    "its energy is too small, and farther on friction locks, so that no energy is enough";

struct cell cell_narrow(domq_real value, int digits)
{
    struct cell cell = cell_bound(value, DOMQ_NAN);
    cell.digits = digits;
    return cell;
}

bool row_status(const struct query *query, struct problem *problem, enum dom_status status)
{
    enum dom_precision precision = query->scene->compute.precision;
    if (status == DOM_NOT_CONVERGED && scene_has_engine(query->scene))
        return problem_no_answer(problem,
                                 "the rigid-body engine cannot decide: the row comes to no end, or with ever "
                                 "shorter steps the verdict still changes; try a slightly different row");
    if (status == DOM_NO_LEAN && !scene_has_engine(query->scene))
        return problem_no_answer(problem,
                                 "dominoes of this row lean, and a row with rounded edges cannot have "
                                 "them; enter 'effect edges off', or a row whose file has no column "
                                 "lean and no radius");
    if (status == DOM_NO_LEAN)
        return problem_no_answer(problem,
                                 "dominoes of this row lean, and a rigid-body engine runs the row, since %s; "
                                 "turn that off, or enter a row whose file has no column lean",
                                 scene_engine_why(query->scene));
    if (status < DOM_BAD_COUNT || status > DOM_BAD_MASS)
        return problem_status(problem, query->scene, status);
    if (scene_has_engine(query->scene))
        return problem_no_answer(problem,
                                 "the dominoes of this row have no size or no mass in double precision");
    return problem_no_answer(problem,
                             "the dominoes of this row become larger or smaller than %s precision can hold; "
                             "use fewer dominoes or a smaller r%s",
                             domq_arithmetic(precision)->name,
                             precision == DOM_QUAD ? "" : ", or 'set precision quad'");
}

struct measured share_text(domq_real share)
{
    int digits = share < 1 ? 2 : 3, most = 12;
    domq_real off = quad(fabs)(1 - share), unit = (domq_real)1 / 200; /* half of 1 % */
    for (; off > 0 && off < unit && digits < most; digits++)
        unit /= 10;
    return measured(share, "share", digits);
}

/* The share from which energy is shown as a multiple. */
#define MANY 10

struct words energy_words(domq_real share)
{
    struct words words;
    if (share < MANY)
        snprintf(words.text, sizeof words.text, "%.60s of the energy that it needs", share_text(share).text);
    else
        snprintf(words.text, sizeof words.text, "%.60s times the energy that it needs",
                 measured(share, "", 3).text);
    return words;
}

struct words all_fall_words(size_t count)
{
    struct words words;
    if (count > 2)
        snprintf(words.text, sizeof words.text, "All %zu fall", count);
    else
        snprintf(words.text, sizeof words.text, "%s", count == 2 ? "Both fall" : "It falls");
    return words;
}

domq_real fall_share(const struct domq_fall *f)
{
    return f->barrier > 0 && isfinite(f->barrier) ? f->kinetic / f->barrier : DOMQ_NAN;
}

/* Prints that all dominoes fall. */
static void all_say(struct answer *a, const struct scene_row *scene, const struct domq_verdict *v, bool timed)
{
    size_t count = scene->row.count;
    const char *start = isnan(scene->row.push) ? "first hit" : "push";
    const struct words fall = all_fall_words(count);
    if (!timed)
        answer_say(a, "%s: no gap has to change.", fall.text);
    else if (count == 1 && isnan(scene->row.push))
        answer_say(a, "%s.", fall.text);
    else if (isfinite(v->seconds))
        answer_say(a, "%s%s lies %s after the %s.", fall.text, count == 1 ? ", and" : "; the last",
                   measured(v->seconds, "s", 4).text, start);
    else
        answer_say(a, "%s, but one almost stops, so that its time cannot be computed.", fall.text);
}

/* Prints where the row ends, and why. */
static void end_say(struct answer *a, const struct scene_row *scene, const struct domq_verdict *v,
                    const struct domq_fall *last)
{
    size_t count = scene->row.count;
    if (v->end == DOM_ROW_STOPS && isfinite(v->short_by))
        answer_say(a, "The row stops at domino %zu of %zu, which has %s.%s", v->domino, count,
                   energy_words(fall_share(last)).text,
                   count > 1 ? " 'mend' looks for a change that saves the row." : "");
    else
        answer_say(a, "The row ends at domino %zu of %zu: %s.", v->domino, count,
                   v->end == DOM_ROW_STOPS && !scene->row.engine ? locks_farther_on : report_why(scene, v));
}

void verdict_say(struct answer *a, const struct scene_row *scene, const struct domq_verdict *v,
                 const struct domq_fall *last, bool timed)
{
    bool falls = v->end == DOM_ROW_FALLS;
    if (falls)
        all_say(a, scene, v, timed);
    else
        end_say(a, scene, v, last);
    if (v->weakest == 0 || !isfinite(v->spare))
        return;
    const char *which = falls ? "" : "Of the dominoes before it, ";
    answer_say(a, "%s%comino %zu has the least to spare: it has %s.", which, falls ? 'D' : 'd', v->weakest,
               energy_words(v->spare + 1).text);
}
