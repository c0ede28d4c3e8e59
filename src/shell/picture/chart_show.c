/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where a chart is drawn: in characters, in a terminal that shows pictures, or in a file. */
#include "picture/graphics.h"
#include "picture/picture.h"

bool chart_ready(struct session *session)
{
    return picture_is_text(session) || picture_ready(session);
}

static bool chart_file(struct session *session, const struct chart *c)
{
    struct picture picture;
    if (!picture_begin(session, &picture))
        return false;
    chart_script(c, picture.script);
    return picture_end(session, &picture, true);
}

bool chart_show(struct session *session, struct chart *c)
{
    bool shown = false;
    int width, height;
    if (c->failed) {
        session_status(session, DOM_NO_MEMORY);
    } else if (chart_fit(c), !picture_is_text(session)) {
        shown = chart_file(session, c);
    } else if (!session->redirected && graphics_of(session->out) != GRAPHICS_NONE && picture_possible()) {
        shown = graphics_show(session, c);
    } else {
        picture_room(session, &width, &height);
        shown = chart_text(c, look_of(session->out), width, height, session->out) ||
                session_status(session, DOM_NO_MEMORY);
    }
    chart_free(c);
    return shown;
}
