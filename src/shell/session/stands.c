/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/stands.h"
#include "answer/measure.h"
#include "language/quad.h"
#include <stdio.h>

bool lean_stands(const struct domq_domino *domino, domq_real alpha, char message[LEAN_MESSAGE])
{
    domq_real lean[2], limit;
    domq_lean_limits(domino, alpha, 0, lean);
    if (domino->lean > lean[0] && domino->lean < lean[1])
        return true;
    limit = domino->lean < 0 ? lean[0] : lean[1];
    snprintf(
        message, LEAN_MESSAGE,
        "with its top %s off plumb this domino falls over by itself; the most this domino can lean%s is %s",
        measured(domino->height * quad(sin)(domino->lean), "m", 4).text, alpha != 0 ? " on this slope" : "",
        measured(domino->height * quad(sin)(limit), "m", 4).text);
    return false;
}

bool row_stands(const struct scene *scene, const struct domq_row *row, struct problem *problem)
{
    for (size_t k = 0; k < row->count; k++) {
        const struct domq_domino *domino = &row->domino[k];
        const bool listed = scene->listed.domino;
        char message[LEAN_MESSAGE];
        domq_real level[2];
        domq_lean_limits(domino, 0, row->rho, level);
        if (row->alpha != 0 && !(quad(fabs)(row->alpha) < level[1]))
            return problem_no_stand(problem, scene, listed ? k + 1 : 0, level[1]);
        if (row->rho == 0 && !lean_stands(domino, row->alpha, message))
            return problem_no_answer(problem, "domino %zu: %s", k + 1, message);
    }
    return true;
}
