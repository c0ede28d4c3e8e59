/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact forces of a train at a tilt, for a drawing. */
#include "entry/study.h"
#include "motion/motion.h"
#include <stdlib.h>

/* The headers of the kernel declare functions that only its own sources define. */
#pragma GCC diagnostic ignored "-Wunused-function"

enum dom_status dom_cycle_forces(const struct dom_train *train, const struct dom_compute *compute,
                                 double theta, dom_force_visit *visit, void *context)
{
    struct request request;
    struct motion m;
    struct kinematics kinematics = {.n = 0};
    const struct geometry *geometry = &m.segment.geometry;
    enum dom_status status = train_request_of(train, compute, &request);
    if (status != DOM_OK)
        return status;
    status = motion_prepare(&request, false, &m);
    if (status == DOM_OK)
        status = geometry_tilt(geometry, theta, &kinematics.head);
    if (status == DOM_OK && theta > m.end * (1 + 4 * REAL_EPSILON))
        status = DOM_STOPS;
    if (status == DOM_OK)
        status = forces_motion(&m.segment, fmin(theta, m.end), &kinematics);
    size_t n = status == DOM_OK ? kinematics.n : 0;
    struct loaded *list = status == DOM_OK ? forces_find(geometry, &kinematics, &n) : NULL;
    for (size_t i = 0; list && i < n; i++) {
        const struct dom_force force = {.i = i,
                                        .force = list[i].force,
                                        .per_weight = list[i].force * list[i].size / list[i].link.weight,
                                        .impulse = list[i].impulse};
        if (!visit(&force, context))
            break;
    }
    motion_end(&m);
    free(list);
    return status == DOM_OK && !list ? DOM_NO_MEMORY : status;
}
