/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture/movie.h"
#include <string.h>
#include <strings.h>

/* The formats of films, and the options of ffmpeg for each format. */
enum { OPTIONS = 9, BEFORE = 16, ARGUMENTS = BEFORE + OPTIONS + 1 };
struct movie_kind {
    const char *ending;
    bool ffmpeg;
    const char *option[OPTIONS]; /* a list that ends with NULL */
};

static const struct movie_kind kinds[] = {
    {".gif", false, {NULL}},
    {".webm", true, {"-c:v", "libvpx-vp9", "-crf", "34", "-b:v", "0", "-f", "webm", NULL}},
    {".mp4", true, {"-c:v", "libx264", "-movflags", "frag_keyframe+empty_moov", "-f", "mp4", NULL}},
};

static const struct movie_kind *kind_of(const char *path)
{
    const char *ending = strrchr(path, '.');
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds && ending; k++)
        if (strcasecmp(ending, kinds[k].ending) == 0)
            return &kinds[k];
    return NULL;
}

bool movie_named(const char *path, struct problem *problem)
{
    const struct movie_kind *kind = kind_of(path);
    if (!kind)
        return problem_error(problem,
                             "'%s' is not the name of an animation: use the extension .gif, .webm or .mp4",
                             names_shown(path));
    return !kind->ffmpeg || program_exists("ffmpeg") ||
           problem_error(
               problem,
               "%s needs ffmpeg, which is not installed: 'apt install ffmpeg', or a name that ends in .gif",
               kind->ending);
}

bool movie_begin(struct movie *m, const char *path, int width, int height, int delay,
                 const volatile sig_atomic_t *interrupt, struct problem *problem)
{
    char terminal[96], options[160];
    if (!movie_named(path, problem))
        return false;
    *m = (struct movie){.kind = kind_of(path), .delay = delay};
    escape_text(path, m->shown, sizeof m->shown);
    const char *wrong = file_push(&m->file, path, false, interrupt);
    if (wrong)
        return problem_error(problem, "cannot write '%s': %s", m->shown, wrong);
    bool ffmpeg = m->kind->ffmpeg;
    height += ffmpeg ? height % 2 : 0; /* these formats store colours in blocks of 2 x 2 pixels */
    snprintf(terminal, sizeof terminal, "size %d,%d font 'sans,14' fontscale 0.72 noenhanced", width, height);
    if (ffmpeg)
        snprintf(options, sizeof options, "pngcairo %s", terminal);
    else
        snprintf(options, sizeof options, "gif animate delay %d loop 0 %s optimize", delay, terminal);
    if (ffmpeg)
        m->frames = temporary_open(problem);
    if ((m->frames || !ffmpeg) &&
        picture_begin(&m->picture, ffmpeg ? m->frames : m->file->out, options, interrupt, problem))
        return true;
    if (m->frames)
        fclose(m->frames);
    (void)output_pop(&m->file, false);
    return false;
}

static bool movie_convert(struct movie *m, struct problem *problem)
{
    char rate[32], what[NAMES_SHOWN + 16];
    const char *argv[ARGUMENTS] = {"ffmpeg", "-hide_banner", "-loglevel",  "error", "-f", "image2pipe",
                                   "-c:v",   "png",          "-framerate", rate,    "-i", "pipe:0",
                                   "-an",    "-pix_fmt",     "yuv420p",    "-y"};
    int n = BEFORE;
    snprintf(rate, sizeof rate, "100/%d", m->delay);
    snprintf(what, sizeof what, "make '%s'", m->shown);
    for (const char *const *option = m->kind->option; *option; option++)
        argv[n++] = *option;
    /* ffmpeg writes to a file, because in a pipe it could not go back to write the duration of the film. The
     * other elements of argv are NULL. */
    argv[n] = "file:/dev/stdout";
    return program_run((char *const *)argv, m->frames, m->file->out, what, m->picture.interrupt, problem);
}

bool movie_end(struct movie *m, bool whole, struct problem *problem)
{
    bool drawn = picture_end(&m->picture, whole, problem) && (!m->frames || movie_convert(m, problem));
    if (m->frames)
        fclose(m->frames);
    const char *wrong = output_pop(&m->file, drawn);
    return drawn && (!wrong || problem_error(problem, "cannot write '%s': %s", m->shown, wrong));
}
