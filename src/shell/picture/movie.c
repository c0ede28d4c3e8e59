/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture/movie.h"
#include "io/io.h"
#include <errno.h>
#include <string.h>
#include <strings.h>

/* What ffmpeg makes of the frames; both forms can be written into a pipe. */
enum { OPTIONS = 9, BEFORE = 16, ARGUMENTS = BEFORE + OPTIONS + 1 };
struct movie_kind {
    const char *ending;
    bool ffmpeg;
    const char *option[OPTIONS]; /* with a NULL at the end */
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
    char shown[NAMES_SHOWN];
    const struct movie_kind *kind = kind_of(path);
    if (!kind)
        return problem_error(problem,
                             "'%s' is not the name of an animation: use the ending .gif, .webm or .mp4",
                             names_shown(path, shown));
    return !kind->ffmpeg || program_there("ffmpeg") ||
           problem_error(
               problem,
               "%s needs ffmpeg, which is not installed: 'apt install ffmpeg', or a name that ends in .gif",
               kind->ending);
}

bool movie_begin(struct movie *m, const char *path, int width, int height, int delay,
                 const volatile sig_atomic_t *interrupt, struct problem *problem)
{
    char terminal[160];
    if (!movie_named(path, problem))
        return false;
    names_shown(path, m->shown);
    m->kind = kind_of(path);
    m->delay = delay;
    m->frames = NULL;
    m->file = NULL;
    const char *wrong = file_push(&m->file, path, false, interrupt);
    if (wrong)
        return problem_error(problem, "cannot write '%s': %s", m->shown, wrong);
    height += m->kind->ffmpeg ? height % 2 : 0; /* its formats halve the dots of colours */
    if (m->kind->ffmpeg)
        snprintf(terminal, sizeof terminal, "pngcairo size %d,%d font 'sans,14' fontscale 0.72 noenhanced",
                 width, height);
    else
        snprintf(terminal, sizeof terminal,
                 "gif animate delay %d loop 0 size %d,%d font 'sans,14' fontscale 0.72 noenhanced optimize",
                 delay, width, height);
    bool begun = !m->kind->ffmpeg || (m->frames = io_temporary(NULL)) ||
                 problem_error(problem, "cannot draw: %s", strerror(errno));
    begun = begun &&
            picture_begin(&m->picture, m->frames ? m->frames : m->file->out, terminal, interrupt, problem);
    if (!begun && m->frames)
        fclose(m->frames);
    if (!begun)
        (void)output_pop(&m->file, false);
    return begun;
}

static bool movie_convert(struct movie *m, struct problem *problem)
{
    char rate[32], what[NAMES_SHOWN + 16];
    const char *argv[ARGUMENTS] = {"ffmpeg", "-hide_banner", "-loglevel",  "error", "-f", "image2pipe",
                                   "-c:v",   "png",          "-framerate", rate,    "-i", "pipe:0",
                                   "-an",    "-pix_fmt",     "yuv420p",    "-y"};
    int n = BEFORE;
    snprintf(rate, sizeof rate, "100/%d", m->delay);
    for (const char *const *option = m->kind->option; *option; option++)
        argv[n++] = *option;
    /* Its standard output under a name: as a file ffmpeg goes back in it, and writes how long the film is. */
    argv[n] = "file:/proc/self/fd/1"; /* a NULL follows */
    FILE *complaints = io_temporary(NULL);
    if (!complaints)
        return problem_error(problem, "cannot draw: %s", strerror(errno));
    const volatile sig_atomic_t *interrupt = m->picture.interrupt;
    int wrong = program_run((char *const *)argv, m->frames, m->file->out, complaints, interrupt);
    snprintf(what, sizeof what, "make '%s'", m->shown);
    if (wrong)
        program_failed("ffmpeg", wrong, complaints, what, interrupt, problem);
    fclose(complaints);
    return !wrong;
}

bool movie_end(struct movie *m, bool whole, struct problem *problem)
{
    bool drawn = picture_end(&m->picture, whole, problem);
    if (drawn && m->frames)
        drawn = movie_convert(m, problem);
    if (m->frames)
        fclose(m->frames);
    const char *wrong = output_pop(&m->file, drawn);
    return drawn && (!wrong || problem_error(problem, "cannot write '%s': %s", m->shown, wrong));
}
