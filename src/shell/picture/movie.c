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

bool movie_named(struct answer *a, struct problem *problem, const char *path)
{
    char shown[NAMES_SHOWN];
    const struct movie_kind *kind = kind_of(path);
    if (a->path)
        return problem_error(
            problem,
            "the animation is written into FILE, so that '>' has no answer to write; leave out the '>'");
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

bool movie_begin(const struct query *query, struct answer *a, struct problem *problem, struct movie *m,
                 const char *path, int width, int height, int delay)
{
    if (!movie_named(a, problem, path))
        return false;
    names_shown(path, m->shown);
    m->kind = kind_of(path);
    m->delay = delay;
    m->frames = NULL;
    m->file = NULL;
    const char *wrong = file_push(&m->file, path, false, query->scene->compute.interrupt);
    if (wrong)
        return problem_error(problem, "cannot write '%s': %s", m->shown, wrong);
    if (m->kind->ffmpeg && !(m->frames = io_temporary(NULL))) {
        (void)output_pop(&m->file, false);
        return problem_error(problem, "cannot draw: %s", strerror(errno));
    }
    height += m->kind->ffmpeg ? height % 2 : 0; /* its formats halve the dots of colours */
    if (!picture_animation(problem, &m->picture, m->frames ? m->frames : m->file->out, width, height,
                           delay)) {
        if (m->frames)
            fclose(m->frames);
        (void)output_pop(&m->file, false);
        return false;
    }
    if (m->frames)
        fprintf(m->picture.script,
                "set terminal pngcairo size %d,%d font 'sans,14' fontscale 0.72 noenhanced\n", width, height);
    else
        fprintf(m->picture.script,
                "set terminal gif animate delay %d loop 0 size %d,%d font 'sans,14' fontscale 0.72 "
                "noenhanced optimize\n",
                delay, width, height);
    return true;
}

static bool movie_convert(const struct query *query, struct problem *problem, struct movie *m)
{
    char rate[32], line[256] = "";
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
    int wrong = program_run(query, (char *const *)argv, m->frames, m->file->out, complaints);
    rewind(complaints);
    while (wrong && fgets(line, sizeof line, complaints) && strspn(line, " \t\n") == strlen(line))
        ;
    fclose(complaints);
    line[strcspn(line, "\n")] = '\0';
    if (wrong && dom_raised(query->scene->compute.interrupt))
        return problem_status(problem, query->scene, DOM_INTERRUPTED);
    if (wrong > 0)
        return problem_error(problem, "cannot run ffmpeg: %s", strerror(wrong));
    return !wrong ||
           problem_error(problem, "ffmpeg did not make '%s': %s", m->shown, *line ? line : "it was stopped");
}

bool movie_end(const struct query *query, struct problem *problem, struct movie *m, bool whole)
{
    bool drawn = picture_end(query, problem, &m->picture, whole);
    if (drawn && m->frames)
        drawn = movie_convert(query, problem, m);
    if (m->frames)
        fclose(m->frames);
    const char *wrong = output_pop(&m->file, drawn);
    return drawn && (!wrong || problem_error(problem, "cannot write '%s': %s", m->shown, wrong));
}
