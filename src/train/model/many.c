/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The same question about many trains. */
#include "numerics/api.h"
#include "numerics/interrupt.h"

enum dom_status dom_trains_ask(enum dom_question question, const struct dom_train *trains,
                               const double *tilts, size_t count, const struct dom_compute *compute,
                               void *answers, enum dom_status *statuses)
{
    bool interrupted = false;
    for (size_t k = 0; k < count; k++) {
        interrupted = interrupted || (compute && dom_interrupted(compute->interrupt));
        statuses[k] = DOM_INTERRUPTED;
        if (interrupted)
            continue;
        switch (question) {
#define ASK(name, find, type)                                                                                \
    case DOM_ASK_##name:                                                                                     \
        statuses[k] = find(&trains[k], compute, (type *)answers + k);                                        \
        break;
#define ASK_AT(name, find, type)                                                                             \
    case DOM_ASK_##name:                                                                                     \
        statuses[k] = find(&trains[k], compute, tilts[k], (type *)answers + k);                              \
        break;
            DOM_QUESTIONS(ASK, ASK_AT)
        default:
            return DOM_NO_METHOD;
        }
        interrupted = statuses[k] == DOM_INTERRUPTED;
    }
    return interrupted ? DOM_INTERRUPTED : DOM_OK;
}
