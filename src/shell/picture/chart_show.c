/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where a chart is drawn: in characters, in a terminal that shows pictures, or in a file. */
#include "picture/graphics.h"
#include "picture/picture.h"

bool chart_ready(struct answer *a, struct problem *problem)
{
    return picture_is_text(a) || picture_ready(a, problem);
}

static bool chart_file(const struct query *query, struct answer *a, struct problem *problem,
                       const struct chart *c)
{
    struct picture picture;
    if (!picture_begin(a, problem, &picture))
        return false;
    chart_script(c, picture.script);
    return picture_end(query, problem, &picture, true);
}

bool chart_show(const struct query *query, struct answer *a, struct problem *problem, struct chart *c)
{
    bool shown = false;
    int width, height;
    if (c->failed) {
        problem_status(problem, query->scene, DOM_NO_MEMORY);
    } else if (chart_fit(c), !picture_is_text(a)) {
        shown = chart_file(query, a, problem, c);
    } else if (!a->path && graphics_of(a->out) != GRAPHICS_NONE && picture_possible()) {
        shown = graphics_show(query, a, problem, c);
    } else {
        picture_room(a, &width, &height);
        shown = chart_text(c, look_of(a->out), width, height, a->out) ||
                problem_status(problem, query->scene, DOM_NO_MEMORY);
    }
    chart_free(c);
    return shown;
}
