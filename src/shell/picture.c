/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture.h"
#include "names.h"
#include "terminal.h"
#include <errno.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static const struct {
    const char *ending, *terminal;
} kinds[] = {
    {".svg", "svg size 800,560 dynamic font 'sans,14' background rgb 'white'"},
    {".png", "pngcairo size 1000,700 font 'sans,13'"},
    {".pdf", "pdfcairo size 16cm,11cm font 'sans,11'"},
};
enum { KINDS = sizeof kinds / sizeof *kinds, TEXT_WIDTH = 79, TEXT_HEIGHT = 30 };

/* What gnuplot is to draw for this file; NULL where its ending is none of ours. */
static const char *terminal_for(const char *path)
{
    const char *ending = strrchr(path, '.');
    for (int k = 0; k < KINDS && ending; k++)
        if (strcasecmp(kinds[k].ending, ending) == 0)
            return kinds[k].terminal;
    return NULL;
}

bool picture_begin(struct session *session, struct picture *picture)
{
    char shown[NAMES_SHOWN];
    const char *path = session->redirected, *terminal = path ? terminal_for(path) : NULL;
    picture->text = !path || (strlen(path) > 4 && strcasecmp(path + strlen(path) - 4, ".txt") == 0);
    if (!picture->text && !terminal)
        return session_error(session,
                             "'%s' does not say as what to draw: its ending is .svg, .png, .pdf or .txt",
                             names_shown(path, shown));
    picture->script = tmpfile();
    if (!picture->script)
        return session_error(session, "cannot draw: %s", strerror(errno));
    int width = path ? 0 : terminal_width(session->out);
    if (picture->text)
        fprintf(picture->script, "set terminal dumb size %d,%d noenhanced\n",
                width > 40 ? width - 1 : TEXT_WIDTH, TEXT_HEIGHT);
    else
        fprintf(picture->script, "set terminal %s enhanced\n", terminal);
    /* Told apart by their points and dashes: in print and for people who see no colours. */
    static const char *const colours[] = {"#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7"};
    static const int points[] = {1, 2, 6, 4, 8};
    for (int k = 0; k < 5; k++)
        fprintf(picture->script, "set linetype %d lc rgb '%s' lw 2 dt %d pt %d ps 1\n", k + 1, colours[k],
                k + 1, points[k]);
    fprintf(picture->script,
            "set encoding utf8\nset border 3\nset tics nomirror\nset grid lc rgb '#bbbbbb' lw 0.5 dt 1\n");
    return true;
}

/* Runs gnuplot on the script; its output and its complaints go into files.  errno, or -1 if it failed. */
static int gnuplot_run(FILE *script, FILE *drawing, FILE *complaints)
{
    extern char **environ;
    char *const argv[] = {"gnuplot", "-", NULL};
    posix_spawn_file_actions_t actions;
    pid_t child;
    int status = 0;
    fflush(script);
    rewind(script);
    lseek(fileno(script), 0, SEEK_SET);
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, fileno(script), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, fileno(drawing), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, fileno(complaints), STDERR_FILENO);
    int failed = posix_spawnp(&child, argv[0], &actions, NULL, argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed)
        return failed;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        ;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? 0 : -1;
}

/* What was drawn, to where answers go; without the blank lines that a text begins with. */
static void drawing_copy(FILE *drawing, FILE *out, bool text)
{
    char block[4096];
    size_t n;
    rewind(drawing);
    while (text && fgets(block, sizeof block, drawing))
        if (strspn(block, " \f\r\n") < strlen(block)) {
            fputs(block, out);
            break;
        }
    while ((n = fread(block, 1, sizeof block, drawing)) > 0)
        fwrite(block, 1, n, out);
}

static bool draw(struct session *session, const struct picture *picture, FILE *drawing, FILE *complaints)
{
    char line[256] = "";
    int wrong = gnuplot_run(picture->script, drawing, complaints);
    if (wrong == ENOENT)
        return session_error(session,
                             "pictures need gnuplot, which is not installed: 'apt install gnuplot-nox'; "
                             "'set output csv' gives the data");
    if (wrong > 0)
        return session_error(session, "cannot run gnuplot: %s", strerror(wrong));
    rewind(complaints);
    while (wrong && fgets(line, sizeof line, complaints) && strspn(line, " \t\n^") == strlen(line))
        ;
    line[strcspn(line, "\n")] = '\0';
    if (wrong)
        return session_error(session, "gnuplot did not draw it: %s", *line ? line : "it was stopped");
    ticker_stop();
    drawing_copy(drawing, session->out, picture->text);
    return true;
}

bool picture_end(struct session *session, struct picture *picture)
{
    FILE *drawing = tmpfile(), *complaints = tmpfile();
    bool drawn = drawing && complaints ? draw(session, picture, drawing, complaints)
                                       : session_error(session, "cannot draw: %s", strerror(errno));
    if (drawing)
        fclose(drawing);
    if (complaints)
        fclose(complaints);
    fclose(picture->script);
    return drawn;
}
