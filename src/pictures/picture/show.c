/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws charts and stages to the destination of an answer. */
#include "answer/answer.h"
#include "io/terminal.h"
#include "pictures/picture/chart.h"
#include "pictures/picture/stage.h"

/* Draws a chart, or a stage if chart is NULL. */
static bool show(const struct answer *a, const struct chart *chart, const struct stage *stage,
                 const volatile sig_atomic_t *interrupt, struct problem *problem)
{
    enum { TEXT_WIDTH = 79, TEXT_HEIGHT = 23, PDF_WIDE = 16 };
    enum { STAGE_LEAST = 190, STAGE_MOST = 560 }; /* the minimum and maximum height of a sheet, in dots */
    if (picture_is_filed(a)) {
        struct picture picture;
        const struct sheet sheet =
            stage ? sheet_of(stage, STAGE_LEAST, STAGE_MOST) : (struct sheet){.height = PICTURE_HEIGHT};
        if (!picture_begin(&picture, a, sheet.height, PDF_WIDE, 0, interrupt, problem))
            return false;
        if (chart)
            chart_script(chart, picture.script);
        else
            stage_script(stage, &sheet, picture.script);
        return picture_end(&picture, true, problem);
    }
    int width, height;
    const struct display display = display_of(a->out);
    progress_end();
    terminal_size(a->out, &width, &height);
    width = width >= PICTURE_LEAST_WIDTH ? width - 1 : TEXT_WIDTH;
    height =
        height >= PICTURE_LEAST_HEIGHT ? height - 1 : TEXT_HEIGHT; /* one line is left for the next prompt */
    /* The height is at most half of the usual width, because characters are twice as tall as wide. */
    height = height > TEXT_WIDTH / 2 ? TEXT_WIDTH / 2 : height;
    return (chart ? chart_text(chart, display, width, height, a->out)
                  : stage_text(stage, display, width, height, a->out)) ||
           problem_error(problem, "%s", dom_status_text(DOM_NO_MEMORY));
}

bool chart_show(struct chart *chart, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem)
{
    chart_prepare(chart);
    const bool shown = chart->failed ? problem_error(problem, "%s", dom_status_text(DOM_NO_MEMORY))
                                     : show(a, chart, NULL, interrupt, problem);
    chart_free(chart);
    return shown;
}

bool stage_show(const struct stage *stage, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem)
{
    return show(a, NULL, stage, interrupt, problem);
}
