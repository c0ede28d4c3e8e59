/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/drawing/film.h"
#include "io/terminal.h"

enum { SHEET_LEAST = 170, SHEET_MOST = 420 }; /* minimum and maximum height of a frame, in pixels */

bool film_make(struct film *f, const struct stage *stage, bool (*watch)(struct film *film))
{
    if (!f->answer) {
        f->sheet = sheet_of(stage, SHEET_LEAST, SHEET_MOST);
        if (!movie_begin(&f->movie, f->query->given->word[0], (int)f->sheet.width, (int)f->sheet.height,
                         f->delay, f->query->scene->compute.interrupt, f->problem))
            return false;
    }
    bool done = watch(f);
    return f->answer ? done : movie_end(&f->movie, done, f->problem);
}

void film_frame(struct film *f, const struct stage *stage)
{
    FILE *script = f->movie.picture.script;
    fprintf(script, "unset label\nunset arrow\n");
    sheet_palette(&f->sheet, (int)(f->frame % 2), script);
    stage_script(stage, &f->sheet, script);
    progress_show((double)++f->frame / (double)f->frames);
}
