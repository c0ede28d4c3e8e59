/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws pictures to the destination of an answer. In a file, the extension determines the format. */
#include "answer/extension.h"
#include "io/terminal.h"
#include "language/names.h"
#include "pictures/picture/chart.h"
#include "pictures/picture/stage.h"
#include <string.h>

enum { TEXT_WIDTH = 79, TEXT_HEIGHT = 23 };
enum { STAGE_LEAST = 190, STAGE_MOST = 560 }; /* the minimum and maximum height of a sheet, in dots */

/* ---- Before a picture is drawn ---- */

/* Returns true if the answer goes to a picture file, such as .png. */
static bool is_filed(const struct answer *a)
{
    return a->path && extension_of(a->path)->terminal;
}

bool picture_ready(const struct answer *a, struct problem *problem)
{
    if (is_filed(a) && a->appended)
        return problem_error(problem, "'%s' can hold only one picture; '>' replaces it",
                             names_shown(a->path));
    return !is_filed(a) || extension_of(a->path)->is_script || gnuplot_ready(problem);
}

struct marks picture_marks(const struct answer *a)
{
    return is_filed(a) ? script_marks : text_marks(display_of(a->out));
}

/* ---- Drawing a chart, or a stage if chart is NULL ---- */

static bool show_text(const struct answer *a, const struct chart *chart, const struct stage *stage)
{
    int width, height;
    struct display display = display_of(a->out);
    progress_end();
    terminal_size(a->out, &width, &height);
    width = width >= PICTURE_LEAST_WIDTH ? width - 1 : TEXT_WIDTH;
    height =
        height >= PICTURE_LEAST_HEIGHT ? height - 1 : TEXT_HEIGHT; /* one line is left for the next prompt */
    /* The height is at most half of the usual width, because characters are twice as tall as wide. */
    height = height > TEXT_WIDTH / 2 ? TEXT_WIDTH / 2 : height;
    return chart ? chart_text(chart, display, width, height, a->out)
                 : stage_text(stage, display, width, height, a->out);
}

/* Draws a picture with gnuplot. */
static bool show_drawn(const struct answer *a, const struct chart *chart, const struct stage *stage,
                       const volatile sig_atomic_t *interrupt, struct problem *problem)
{
    struct picture picture;
    struct sheet sheet;
    char terminal[TERMINAL_TEXT];
    if (chart)
        chart_terminal(chart, extension_of(a->path)->terminal, terminal);
    else {
        sheet = sheet_of(stage, STAGE_LEAST, STAGE_MOST);
        sheet_terminal(&sheet, extension_of(a->path)->terminal, false, terminal);
    }
    if (!picture_begin(&picture, a, terminal, interrupt, problem))
        return false;
    if (chart)
        chart_script(chart, picture.script);
    else
        stage_script(stage, &sheet, picture.script);
    return picture_end(&picture, true, problem);
}

static bool show(const struct answer *a, const struct chart *chart, const struct stage *stage,
                 const volatile sig_atomic_t *interrupt, struct problem *problem)
{
    if (is_filed(a))
        return show_drawn(a, chart, stage, interrupt, problem);
    return show_text(a, chart, stage) || problem_error(problem, "%s", dom_status_text(DOM_NO_MEMORY));
}

bool chart_show(struct chart *chart, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem)
{
    chart->tex = is_filed(a) && strcmp(extension_of(a->path)->text, ".tex") == 0;
    const char *wrong = chart->failed ? dom_status_text(DOM_NO_MEMORY) : chart_dress(chart);
    const bool chosen = chart->look.has_range[0] || chart->look.has_range[1] ||
                        chart->look.scale[0] != CHART_SCALE_USUAL ||
                        chart->look.scale[1] != CHART_SCALE_USUAL;
    if (!wrong && !chart_prepare(chart) && chosen)
        wrong =
            "no point of the chart is within the ranges of its axes; change xrange, yrange, xscale or yscale";
    bool shown = wrong ? problem_error(problem, "%s", wrong) : show(a, chart, NULL, interrupt, problem);
    chart_free(chart);
    return shown;
}

bool stage_show(const struct stage *stage, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem)
{
    return show(a, NULL, stage, interrupt, problem);
}
