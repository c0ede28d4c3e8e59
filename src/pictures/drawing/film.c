/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/drawing/film.h"
#include "interpreter/feature.h"
#include "io/terminal.h"
#include "pictures/drawing/play.h"
#include <math.h>

enum { FRAME_LEAST = 170, FRAME_MOST = 420 }; /* the minimum and maximum height of a frame, in pixels */

void film_follow(struct stage *stage, const struct drawn *from, const struct drawn *to, double part)
{
    const double more = to->height - from->height, share = fmin(fmax(part, 0), 1),
                 growth = pow(to->height / from->height, share);
    /* The size of the view grows exponentially, and the place moves in proportion to it. */
    const double way = fabs(more) > 1e-9 * from->height ? (growth - 1) * from->height / more : share;
    stage->at = from->foot + way * (to->foot - from->foot);
    stage->tall = 2.6 * from->height * growth;
}

bool film_frame(struct film *f, const struct stage *stage)
{
    if (f->player)
        return player_frame(f->player, stage);
    fputs("unset label\nunset arrow\n", f->picture.script);
    if (stage->tall > 0)
        sheet_follow(&f->sheet, stage->at, stage->tall);
    sheet_palette(&f->sheet, (int)(f->frame % 2), f->picture.script);
    stage_script(stage, &f->sheet, f->picture.script);
    progress_show((double)++f->frame / (double)f->frames);
    return true;
}

static bool film_play(struct film *f, bool (*watch)(struct film *film))
{
    struct problem other;
    f->player = player_begin(f->out->out, f->delay, f->query->scene->compute.interrupt, f->problem);
    if (!f->player)
        return false;
    const bool good = watch(f);
    return player_end(f->player, good ? f->problem : &other) && good;
}

bool film_make(struct film *f, const struct stage *stage, bool (*watch)(struct film *film))
{
    char terminal[TERMINAL_TEXT];
    if (f->is_data)
        return watch(f);
    if (!f->out->path)
        return film_play(f, watch);
    snprintf(f->out->made, sizeof f->out->made, "%zu frames, %.3g s", f->frames,
             (double)f->frames * f->delay / 100);
    f->sheet = sheet_of(stage, FRAME_LEAST, FRAME_MOST);
    snprintf(terminal, sizeof terminal,
             "gif animate delay %d loop 0 size %d,%d font 'sans,14' fontscale 0.72 noenhanced optimize",
             f->delay, SHEET_WIDTH, (int)f->sheet.height);
    return picture_begin(&f->picture, f->out, terminal, f->query->scene->compute.interrupt, f->problem) &&
           picture_end(&f->picture, watch(f), f->problem);
}
