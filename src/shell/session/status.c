/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a status of the library means for a scene, and what would be right. */
#include "answer/measure.h"
#include "language/quad.h"
#include "session/scene.h"
#include <stdio.h>

bool problem_no_room(struct problem *problem, const struct scene *scene, size_t k, domq_real thickness)
{
    char which[32] = "the domino";
    if (k > 0)
        snprintf(which, sizeof which, "domino %zu", k);
    return problem_no_answer(problem,
                             "walls of %s leave no room in %s, which is %s thick: they are %s at most, which "
                             "makes it solid",
                             measured(scene->train.walls * scene->scale.h, "m", 4).text, which,
                             measured(thickness, "m", 4).text, measured(thickness / 2, "m", 4).text);
}

bool problem_no_stand(struct problem *problem, const struct scene *scene, size_t k, domq_real limit)
{
    const double degree = (double)QUAD_PI / 180, alpha = (double)scene->train.alpha / degree;
    char which[32] = "no domino", example[32] = "off";
    if (k > 0)
        snprintf(which, sizeof which, "domino %zu", k);
    if (limit > 0)
        snprintf(example, sizeof example, "%.2g deg", copysign((double)limit, alpha) / degree / 2);
    return problem_no_answer(problem,
                             "%s %s stand upright on a slope of %.4g deg; for %s thickness%s the limit is "
                             "%.4g deg; for example 'effect slope %s'",
                             which, k > 0 ? "cannot" : "can", alpha, k > 0 ? "its" : "this",
                             scene->train.rho > 0 ? " and rounded edges" : "", (double)limit / degree,
                             example);
}

bool problem_status(struct problem *problem, const struct scene *scene, enum dom_status status)
{
    const struct domq_train *t = &scene->train;
    problem->place = 0;
    if (status == DOM_INTERRUPTED || status == DOM_NO_MEMORY) /* no matter with which values */
        return problem_error(problem, "%s", dom_status_text(status));
    if (status == DOM_NO_ROUND && t->rho > t->d / 2)
        return problem_no_answer(problem,
                                 "edges with a radius of %s h do not fit: the radius is at most half of the "
                                 "thickness; here 'effect edges %.6g' is the largest",
                                 quad_shown(t->rho).text, (double)(t->d / 2));
    if (status == DOM_NO_STAND) {
        domq_real lean[2];
        domq_lean_limits(&(struct domq_domino){.height = 1, .thickness = t->d}, 0, t->rho, lean);
        return problem_no_stand(problem, scene, 0, lean[1]);
    }
    if (status == DOM_OUT_OF_REACH)
        return problem_no_answer(problem,
                                 "r s = %s > %.6g: the head falls past the next domino without touching it; "
                                 "at s = %s r may be up to "
                                 "%s%.17g",
                                 quad_shown(t->r * t->s).text, (double)(domq_train_reach(t) * t->s),
                                 quad_shown(t->s).text, t->rho == 0 ? "1/s = " : "",
                                 (double)domq_train_reach(t));
    if (status == DOM_NO_METHOD && domq_dynamics(t) && t->fuel == DOM_FUEL_PAPER)
        return problem_no_answer(
            problem, "'fuel paper' cannot be combined with %s; enter 'set fuel exact' or 'effect %s off'",
            domq_dynamics(t)->name, domq_dynamics(t)->name);
    if (status == DOM_NOT_CONVERGED && scene->compute.precision != DOM_QUAD)
        return problem_no_answer(problem,
                                 "%s of %.3g; 'set precision %s' has more digits, 'set tol' allows fewer",
                                 dom_status_text(status), (double)scene->compute.tol,
                                 scene->compute.precision == DOM_FLOAT ? "double" : "quad");
    if (status == DOM_NO_ROOM)
        return problem_no_room(problem, scene, 0, t->d * scene->scale.h);
    if (status == DOM_TOO_LONG)
        return problem_no_answer(problem, "%s; use a larger s, d or tol", dom_status_text(status));
    return problem_no_answer(problem, "%s", dom_status_text(status));
}
