/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/picture/movie.h"
#include "io/terminal.h"
#include <string.h>
#include <strings.h>

enum { FRAME_LEAST = 170, FRAME_MOST = 420 }; /* the minimum and maximum height of a frame, in pixels */

/* The formats of films, and the options of ffmpeg for each format. */
enum { OPTIONS = 9, BEFORE = 16, ARGUMENTS = BEFORE + OPTIONS + 1 };
struct movie_kind {
    const char *extension;
    bool ffmpeg;
    const char *option[OPTIONS]; /* the options, followed by NULL */
};

static const struct movie_kind kinds[] = {
    {".gif", false, {NULL}},
    {".webm", true, {"-c:v", "libvpx-vp9", "-crf", "34", "-b:v", "0", "-f", "webm", NULL}},
    {".mp4", true, {"-c:v", "libx264", "-movflags", "frag_keyframe+empty_moov", "-f", "mp4", NULL}},
};

static const struct movie_kind *kind_of(const char *path)
{
    const char *extension = strrchr(path, '.');
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds && extension; k++)
        if (strcasecmp(extension, kinds[k].extension) == 0)
            return &kinds[k];
    return NULL;
}

bool movie_ready(const char *path, struct problem *problem)
{
    const struct movie_kind *kind = kind_of(path);
    return !kind->ffmpeg || program_exists("ffmpeg") ||
           problem_error(problem,
                         "%s needs ffmpeg, which is not installed; run 'apt install ffmpeg', or use a name "
                         "that ends in .gif",
                         kind->extension);
}

bool movie_begin(struct movie *m, const struct answer *a, const struct stage *stage, size_t frames, int delay,
                 const volatile sig_atomic_t *interrupt, struct problem *problem)
{
    char terminal[96], options[160];
    *m = (struct movie){.kind = kind_of(a->path), .answer = a, .delay = delay, .frames = frames};
    m->sheet = sheet_of(stage, FRAME_LEAST, FRAME_MOST);
    bool ffmpeg = m->kind->ffmpeg;
    int height = (int)m->sheet.height;
    height += ffmpeg ? height % 2 : 0; /* these formats store colours in blocks of 2 x 2 pixels */
    snprintf(terminal, sizeof terminal, "size %d,%d font 'sans,14' fontscale 0.72 noenhanced", SHEET_WIDTH,
             height);
    if (ffmpeg)
        snprintf(options, sizeof options, "pngcairo %s", terminal);
    else
        snprintf(options, sizeof options, "gif animate delay %d loop 0 %s optimize", delay, terminal);
    if (ffmpeg)
        m->drawn = temporary_open(problem);
    if ((m->drawn || !ffmpeg) &&
        picture_begin(&m->picture, ffmpeg ? m->drawn : a->out, options, interrupt, problem))
        return true;
    if (m->drawn)
        fclose(m->drawn);
    return false;
}

void movie_frame(struct movie *m, const struct stage *stage)
{
    FILE *script = m->picture.script;
    fprintf(script, "unset label\nunset arrow\n");
    if (stage->tall > 0)
        sheet_follow(&m->sheet, stage->at, stage->tall);
    sheet_palette(&m->sheet, (int)(m->frame % 2), script);
    stage_script(stage, &m->sheet, script);
    progress_show((double)++m->frame / (double)m->frames);
}

static bool movie_convert(struct movie *m, struct problem *problem)
{
    char rate[32], what[NAMES_SHOWN + 16];
    const char *argv[ARGUMENTS] = {"ffmpeg", "-hide_banner", "-loglevel",  "error", "-f", "image2pipe",
                                   "-c:v",   "png",          "-framerate", rate,    "-i", "pipe:0",
                                   "-an",    "-pix_fmt",     "yuv420p",    "-y"};
    int n = BEFORE;
    snprintf(rate, sizeof rate, "100/%d", m->delay);
    snprintf(what, sizeof what, "make '%s'", names_shown(m->answer->path));
    for (const char *const *option = m->kind->option; *option; option++)
        argv[n++] = *option;
    /* Standard output is a file. The name 'file:/dev/stdout' tells ffmpeg so. At the end, ffmpeg goes back in
     * a file to write the duration of the film, but it cannot go back in a pipe. */
    argv[n] = "file:/dev/stdout";
    return program_run((char *const *)argv, m->drawn, m->answer->out, what, m->picture.interrupt, problem);
}

bool movie_end(struct movie *m, bool whole, struct problem *problem)
{
    bool drawn = picture_end(&m->picture, whole, problem) && (!m->drawn || movie_convert(m, problem));
    if (m->drawn)
        fclose(m->drawn);
    return drawn;
}
