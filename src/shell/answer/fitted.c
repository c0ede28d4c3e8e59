/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answer/fitted.h"
#include "io/escape.h"
#include <stdlib.h>
#include <string.h>

/*
 * The one place where numbers that the precision does not hold become cells without a value; the reason of
 * that, unless the row has its own.
 */
static const char *row_finite(struct answer *a, struct cell *shown, const char *reason,
                              char lost[ANSWER_REASON])
{
    const enum dom_precision precision = a->style.precision;
    const char *key = NULL;
    for (int i = 0; a->columns[i].key; i++)
        if (!cell_finite(&a->style, shown[i])) {
            shown[i].kind = CELL_NONE;
            key = key ? key : a->columns[i].key;
        }
    if (!key)
        return reason;
    snprintf(lost, ANSWER_REASON, "%s is beyond what %s precision can hold%s", key,
             domq_arithmetic(precision)->name,
             precision == DOM_QUAD ? "" : "; 'set precision quad' holds more");
    if (a->style.output == OUTPUT_TABLE && !*a->unsaid) /* said below it, once */
        memcpy(a->unsaid, lost, sizeof a->unsaid);
    return a->style.output == OUTPUT_TABLE || (reason && *reason) ? reason : lost;
}

/* In csv the first of the rows decides whether there is a column for reasons. */
static const char *row_reason(struct answer *a, const char *reason)
{
    if (a->style.output != OUTPUT_CSV || a->swept)
        return reason;
    a->reasoned = a->begun ? a->reasoned : reason != NULL;
    if (a->reasoned)
        return reason ? reason : "";
    if (reason && !*a->unsaid)
        snprintf(a->unsaid, sizeof a->unsaid, "%s", reason);
    return NULL;
}

/* Words as people may read them; what is to be freed is in own.  In json they are escaped as they are
 * written. */
static const char *row_escape(const struct answer *a, struct cell *shown, const char *reason,
                              char *own[ANSWER_COLUMNS])
{
    int n = 0;
    for (; a->columns[n].key; n++) {
        own[n] = NULL;
        if (shown[n].kind == CELL_WORD && escape_needed(shown[n].word)) {
            own[n] = escape_copy(shown[n].word);
            shown[n].word = own[n] ? own[n] : "?";
        }
    }
    own[n] = reason && escape_needed(reason) ? escape_copy(reason) : NULL;
    return own[n] ? own[n] : reason;
}

const char *row_fit(struct answer *a, struct cell *shown, const char *reason, struct fitted *fitted)
{
    memset(fitted->own, 0, sizeof fitted->own);
    reason = row_reason(a, row_finite(a, shown, reason, fitted->lost));
    return a->style.output == OUTPUT_JSON ? reason : row_escape(a, shown, reason, fitted->own);
}

void fitted_free(struct fitted *fitted)
{
    for (int n = 0; n < ANSWER_COLUMNS; n++)
        free(fitted->own[n]);
}
