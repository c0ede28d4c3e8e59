/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/drawing/film.h"
#include "answer/format.h"
#include "interpreter/feature.h"
#include "io/io.h"
#include "io/terminal.h"
#include "pictures/picture/screen.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

void film_follow(struct stage *stage, const struct drawn *from, const struct drawn *to, double part)
{
    const double more = to->height - from->height, share = fmin(fmax(part, 0), 1),
                 growth = pow(to->height / from->height, share);
    /* The size of the view grows exponentially, and the place moves in proportion to it. */
    const double way = fabs(more) > 1e-9 * from->height ? (growth - 1) * from->height / more : share;
    stage->at = from->foot + way * (to->foot - from->foot);
    stage->tall = 2.6 * from->height * growth;
}

/* ---- At the terminal ---- */

static void screen_show(const struct film *f)
{
    fputs("\033[H", f->screen);
    for (const char *line = f->text; *line;) {
        const size_t n = strcspn(line, "\n");
        fprintf(f->screen, "%.*s\033[K\r\n", (int)n, line);
        line += n + (line[n] == '\n');
    }
    fprintf(f->screen, "%s\033[J",
            f->is_stopped ? "(stopped: space continues, the right arrow shows the next frame, q ends)"
                          : "(space stops, q ends)");
    fflush(f->screen);
}

/* Draws the frame into f->text. Returns false if memory runs out. */
static bool frame_draw(struct film *f, const struct stage *stage)
{
    int width, height;
    free(f->text);
    f->text = NULL;
    FILE *text = io_memory(&f->text, &f->size);
    if (!text)
        return false;
    terminal_size(f->out->out, &width, &height);
    width = width > PICTURE_LEAST_WIDTH ? width - 1 : PICTURE_LEAST_WIDTH;
    height = height > PICTURE_LEAST_HEIGHT ? height - 1 : PICTURE_LEAST_HEIGHT;
    const bool is_drawn = stage_text(stage, display_of(f->out->out), width, height, text);
    return fclose(text) == 0 && is_drawn && f->text;
}

/* Shows the frame, and handles keys until it is time for the next one: the space bar stops and continues the
 * film, the right arrow shows the next frame, and 'q' ends the film. */
static bool frame_play(struct film *f)
{
    const double delay = f->delay / 100.0, now = terminal_clock();
    f->next = fmax(f->next, now - delay) + delay; /* after a slow frame, wait anew */
    screen_show(f);
    for (;;) {
        const int key =
            screen_key(f->is_stopped ? 1 : f->next - terminal_clock(), f->query->scene->compute.interrupt);
        if (key == KEY_END)
            return false;
        if (key == ' ' || key == KEY_BACK || key == KEY_RIGHT) {
            f->is_stopped = key == KEY_RIGHT || f->is_stopped != (key == ' ');
            f->next = terminal_clock();
            screen_show(f);
        }
        if (key == KEY_RIGHT || (!f->is_stopped && terminal_clock() >= f->next))
            return true;
    }
}

/* Plays the film, and leaves the last frame on the terminal. */
static bool film_play(struct film *f, bool (*watch)(struct film *film))
{
    const volatile sig_atomic_t *interrupt = f->query->scene->compute.interrupt;
    f->screen = screen_begin(f->out->out);
    if (!f->screen)
        return problem_error(
            f->problem,
            "an animation can be shown only on a terminal; enter 'animate > film.gif' for a file");
    f->next = terminal_clock();
    bool good = watch(f);
    screen_end();
    if (good && (f->failed || dom_raised(interrupt)))
        good = problem_error(f->problem, "%s", dom_status_text(f->failed ? DOM_NO_MEMORY : DOM_INTERRUPTED));
    if (good && f->text)
        fputs(f->text, f->out->out);
    free(f->text);
    return good;
}

/* ---- Both ---- */

bool film_frame(struct film *f, const struct stage *stage)
{
    if (f->screen) {
        f->failed = !frame_draw(f, stage);
        return !f->failed && frame_play(f);
    }
    fputs("unset label\nunset arrow\n", f->picture.script);
    if (stage->tall > 0)
        sheet_follow(&f->sheet, stage->at, stage->tall);
    sheet_palette(&f->sheet, (int)(f->frame % 2), f->picture.script);
    stage_script(stage, &f->sheet, f->picture.script);
    progress_show((double)++f->frame / (double)f->frames);
    return true;
}

bool film_make(struct film *f, const struct stage *stage, bool (*watch)(struct film *film))
{
    enum { FRAME_LEAST = 170, FRAME_MOST = 420 }; /* the minimum and maximum height of a frame, in pixels */
    if (f->is_data)
        return watch(f);
    if (!f->out->path)
        return film_play(f, watch);
    snprintf(f->out->made, sizeof f->out->made, "%zu frames, %.3g s", f->frames,
             (double)f->frames * f->delay / 100);
    f->sheet = sheet_of(stage, FRAME_LEAST, FRAME_MOST);
    return picture_begin(&f->picture, f->out, f->sheet.height, 0, f->delay,
                         f->query->scene->compute.interrupt, f->problem) &&
           picture_end(&f->picture, watch(f), f->problem);
}
