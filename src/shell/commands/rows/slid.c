/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/rows/slid.h"
#include "language/quad.h"
#include <stdlib.h>

bool report_begin(const struct query *query, struct problem *problem, struct scene_row *scene)
{
    if (!scene->row.engine)
        return true;
    scene->report.hit = malloc(scene->row.count * sizeof *scene->report.hit);
    scene->engine.report = &scene->report;
    return scene->report.hit || problem_status(problem, query->scene, DOM_NO_MEMORY);
}

void report_end(struct scene_row *scene)
{
    if (scene->row.engine)
        free(scene->report.hit);
}

bool feet_slide(const struct scene_row *scene)
{
    return scene->row.engine && isfinite(scene->engine.effects.feet);
}

domq_real report_time_error(const struct scene_row *scene)
{
    const struct engine_settled *s = &scene->report.settled;
    return scene->row.engine ? (domq_real)(s->change * scene->report.seconds) : DOMQ_NAN;
}

domq_real report_slid(const struct scene_row *scene, size_t k)
{
    return scene->row.engine ? (domq_real)scene->report.hit[k].slid : DOMQ_NAN;
}

/* Prints which foot slides the farthest, over the height of its domino. */
static void slid_say(struct answer *a, const struct scene_row *scene, size_t hits)
{
    size_t most = 0;
    domq_real far = 0;
    for (size_t k = 0; k < hits; k++) {
        domq_real slid = quad(fabs)(report_slid(scene, k)) / scene->domino[k].height;
        most = slid > far ? k : most;
        far = quad_larger(far, slid);
    }
    domq_real way = quad(fabs)(report_slid(scene, most));
    if (far < (domq_real)1 / 1000)
        answer_say(a, "No foot slides by more than a thousandth of the height of its domino.");
    else
        answer_say(a, "Feet slide: that of domino %zu the farthest for its size, %s %s, %s of its height.",
                   most + 1, measured(way, "m", 3).text,
                   report_slid(scene, most) > 0 ? "forwards" : "backwards", measured(far, "share", 2).text);
}

void report_say(struct answer *a, const struct scene_row *scene, const struct domq_verdict *v)
{
    const struct engine_settled *s = &scene->report.settled;
    if (!scene->row.engine)
        return;
    if (feet_slide(scene))
        slid_say(a, scene, v->domino);
    answer_say(a,
               "Chipmunk %s, a rigid-body engine, ran it with %g steps in sqrt(h/g): with half as many the "
               "verdict is "
               "the same, and times agree to %.2g %%.",
               engine_version(), s->steps, 100 * s->change);
}

const char *report_why(const struct scene_row *scene, const struct domq_verdict *v)
{
    bool lies = scene->row.engine && v->end == DOM_ROW_STOPS && scene->report.settled.fall.lies;
    return lies ? "it falls, and the next one stays upright" : dom_row_end_text(v->end);
}
