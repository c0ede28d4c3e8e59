/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Answers the same question about many trains, so that slow languages such as Python need no loop. */
#include "numerics/interrupt.h"
#include "numerics/real.h"

typedef enum dom_status find_train(const struct dom_train *train, const struct dom_compute *compute,
                                   void *answer);
typedef enum dom_status find_tilt(const struct dom_train *train, const struct dom_compute *compute,
                                  dom_real theta, void *answer);

/* Defines a wrapper around a function that answers a question. All wrappers take a void pointer, so they fit
 * into one table. */
#define FINDS(find, kind)                                                                                    \
    static enum dom_status one_##find(const struct dom_train *train, const struct dom_compute *compute,      \
                                      void *answer)                                                          \
    {                                                                                                        \
        return dom_##find(train, compute, (kind *)answer);                                                   \
    }
#define FINDS_AT(find, kind)                                                                                 \
    static enum dom_status one_##find(const struct dom_train *train, const struct dom_compute *compute,      \
                                      dom_real theta, void *answer)                                          \
    {                                                                                                        \
        return dom_##find(train, compute, theta, (kind *)answer);                                            \
    }
FINDS(angles_find, struct dom_angles)
FINDS_AT(contact_find, struct dom_contact)
FINDS_AT(energy_find, struct dom_energy)
FINDS(fuel_find, struct dom_fuels)
FINDS(launch_find, struct dom_launch)
FINDS(barrier_find, struct dom_barrier)
FINDS_AT(cycle_omegasq, dom_real)
FINDS(cycle_duration, dom_real)
FINDS(limit_rmax, struct dom_limit)
FINDS(limit_pair, struct dom_limit)
FINDS(limit_best, struct dom_best)

static const struct {
    find_train *train; /* for questions without a tilt, otherwise NULL */
    find_tilt *tilt;   /* for questions with a tilt, otherwise NULL */
    size_t size;       /* size of the result */
} questions[] = {
    [DOM_ASK_ANGLES] = {one_angles_find, NULL, sizeof(struct dom_angles)},
    [DOM_ASK_CONTACT] = {NULL, one_contact_find, sizeof(struct dom_contact)},
    [DOM_ASK_ENERGY] = {NULL, one_energy_find, sizeof(struct dom_energy)},
    [DOM_ASK_FUEL] = {one_fuel_find, NULL, sizeof(struct dom_fuels)},
    [DOM_ASK_LAUNCH] = {one_launch_find, NULL, sizeof(struct dom_launch)},
    [DOM_ASK_BARRIER] = {one_barrier_find, NULL, sizeof(struct dom_barrier)},
    [DOM_ASK_OMEGASQ] = {NULL, one_cycle_omegasq, sizeof(dom_real)},
    [DOM_ASK_DURATION] = {one_cycle_duration, NULL, sizeof(dom_real)},
    [DOM_ASK_RMAX] = {one_limit_rmax, NULL, sizeof(struct dom_limit)},
    [DOM_ASK_PAIR] = {one_limit_pair, NULL, sizeof(struct dom_limit)},
    [DOM_ASK_BEST] = {one_limit_best, NULL, sizeof(struct dom_best)},
};

enum dom_status dom_trains_ask(enum dom_question question, const struct dom_train *trains,
                               const dom_real *tilts, size_t count, const struct dom_compute *compute,
                               void *answers, enum dom_status *statuses)
{
    if ((unsigned)question >= sizeof questions / sizeof *questions)
        return DOM_NO_METHOD;
    bool interrupted = false;
    for (size_t k = 0; k < count; k++) {
        interrupted = interrupted || (compute && dom_interrupted(compute->interrupt));
        void *answer = (char *)answers + k * questions[question].size;
        statuses[k] = interrupted ? DOM_INTERRUPTED
                      : questions[question].train
                          ? questions[question].train(&trains[k], compute, answer)
                          : questions[question].tilt(&trains[k], compute, tilts[k], answer);
        interrupted = interrupted || statuses[k] == DOM_INTERRUPTED;
    }
    return interrupted ? DOM_INTERRUPTED : DOM_OK;
}
