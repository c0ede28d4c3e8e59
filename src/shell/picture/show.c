/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where a picture goes: in characters or as a real picture into the terminal, or into a file. */
#include "picture/show.h"
#include "io/io.h"
#include "io/terminal.h"
#include "language/names.h"
#include "picture/ending.h"
#include "picture/graphics.h"
#include "picture/picture.h"
#include <errno.h>
#include <string.h>

enum { TEXT_WIDTH = 79, TEXT_HEIGHT = 23, LEAST_WIDTH = 31, LEAST_HEIGHT = 13 };
enum { STAGE_LEAST = 190, STAGE_MOST = 560 }; /* heights of a sheet, in dots */

bool picture_is_text(const struct answer *a)
{
    return !a->path || ending_of(a->path)->kind != ENDING_PICTURE;
}

bool picture_fits(const struct answer *a, const char *command, struct problem *problem)
{
    int width, height;
    terminal_size(a->out, &width, &height);
    return width == 0 || height == 0 || (width >= LEAST_WIDTH && height >= LEAST_HEIGHT) ||
           problem_error(problem,
                         "the terminal has %d x %d characters, and a picture needs %d x %d; enlarge it, or "
                         "enter '%s > %s.txt'",
                         width, height, LEAST_WIDTH, LEAST_HEIGHT, command, command);
}

bool picture_ready(const struct answer *a, struct problem *problem)
{
    char shown[NAMES_SHOWN];
    if (picture_is_text(a))
        return true;
    if (a->appended)
        return problem_error(problem, "'%s' holds one picture, and '>>' cannot add another; '>' replaces it",
                             names_shown(a->path, shown));
    return gnuplot_ready(problem);
}

/* Draws in characters. The line of the next prompt is not counted. */
static bool show_text(const struct answer *a, const struct chart *chart, const struct stage *stage)
{
    int width, height;
    struct look look = look_of(a->out);
    progress_end();
    terminal_size(a->out, &width, &height);
    width = width >= LEAST_WIDTH ? width - 1 : TEXT_WIDTH;
    height = height >= LEAST_HEIGHT ? height - 1 : TEXT_HEIGHT;
    height = height > TEXT_WIDTH / 2 ? TEXT_WIDTH / 2 : height; /* no taller than wide */
    return chart ? chart_text(chart, look, width, height, a->out)
                 : stage_text(stage, look, width, height, a->out);
}

/* Draws by gnuplot: into a file, or, without a path, into a terminal that shows pictures. */
static bool show_drawn(const struct answer *a, const struct chart *chart, const struct stage *stage,
                       const volatile sig_atomic_t *interrupt, struct problem *problem)
{
    struct picture picture;
    struct sheet sheet = {.width = 0};
    char terminal[160];
    int width = 0, height = STAGE_MOST;
    FILE *drawing = a->path ? a->out : io_temporary(NULL);
    if (!drawing)
        return problem_error(problem, "cannot draw: %s", strerror(errno));
    if (!a->path)
        graphics_size(a->out, &width, &height);
    if (stage)
        sheet = sheet_of(stage, STAGE_LEAST, a->path ? height : height * SHEET_WIDTH / width);
    if (!a->path)
        graphics_terminal(a->out, width, stage ? (int)(sheet.height * width / SHEET_WIDTH) : height,
                          stage != NULL, terminal, sizeof terminal);
    else if (stage)
        sheet_terminal(&sheet, a->path, terminal, sizeof terminal);
    else
        snprintf(terminal, sizeof terminal, "%s enhanced", ending_of(a->path)->terminal);
    bool drawn = picture_begin(&picture, drawing, terminal, interrupt, problem);
    if (drawn && stage)
        stage_script(stage, &sheet, picture.script);
    else if (drawn)
        chart_script(chart, picture.script);
    drawn = drawn && picture_end(&picture, true, problem);
    if (!a->path) {
        drawn = drawn && graphics_write(drawing, a->out);
        fclose(drawing);
    }
    return drawn;
}

/* Returns true if gnuplot draws the picture; else it is drawn in characters. */
static bool by_gnuplot(const struct answer *a)
{
    return !picture_is_text(a) ||
           (!a->path && graphics_of(a->out) != GRAPHICS_NONE && program_there("gnuplot"));
}

static bool show(const struct answer *a, const struct chart *chart, const struct stage *stage,
                 const volatile sig_atomic_t *interrupt, struct problem *problem)
{
    if (by_gnuplot(a))
        return show_drawn(a, chart, stage, interrupt, problem);
    return show_text(a, chart, stage) || problem_error(problem, "%s", dom_status_text(DOM_NO_MEMORY));
}

struct marks picture_marks(const struct answer *a)
{
    return by_gnuplot(a) ? script_marks : text_marks(look_of(a->out));
}

bool chart_show(struct chart *chart, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem)
{
    chart_fit(chart);
    bool shown = chart->failed ? problem_error(problem, "%s", dom_status_text(DOM_NO_MEMORY))
                               : show(a, chart, NULL, interrupt, problem);
    chart_free(chart);
    return shown;
}

bool stage_show(const struct stage *stage, const struct answer *a, const volatile sig_atomic_t *interrupt,
                struct problem *problem)
{
    return show(a, NULL, stage, interrupt, problem);
}
