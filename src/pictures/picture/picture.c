/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* memfd_create */
#include "pictures/picture/picture.h"
#include "answer/answer.h"
#include "domino_quad.h"
#include "io/escape.h"
#include "io/io.h"
#include "io/terminal.h"
#include "language/names.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

struct axis_unit measure_axis(double longest)
{
    return longest >= 2     ? (struct axis_unit){"m", 1}
           : longest >= 0.2 ? (struct axis_unit){"cm", 0.01}
                            : (struct axis_unit){"mm", 0.001};
}

/* ---- The program gnuplot ---- */

enum { NOT_FOUND = 127 }; /* the exit status of a child that finds no gnuplot */

/* Makes the child process run gnuplot. */
static void gnuplot_become(pid_t parent, const int file[3])
{
    /* gnuplot would read a script named "-" byte by byte. It reads /dev/stdin in blocks. */
    char *const argv[] = {"gnuplot", "-d", "/dev/stdin", NULL};
    /* ^Z stops a whole process group, but at the prompt, this program catches ^Z. If the child were in the
     * same group, only the child would stop, and this program would wait for the child forever. */
    setpgid(0, 0);
    /* The program must end when its parent ends. The parent may already have ended. */
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    if (getppid() != parent)
        _exit(1);
    for (int i = 0; i < 3; i++)
        dup2(file[i], i);
    execvp(argv[0], argv);
    const int error = errno;
    dprintf(STDERR_FILENO, "%s\n", strerror(error));
    _exit(error == ENOENT ? NOT_FOUND : 1);
}

/* Copies what the child writes into a pipe to the file of the answer, and waits for its end. Kills the child
 * after an interrupt. Returns its exit status, or -1 if it was killed. *has_drawn tells whether it wrote
 * anything. */
static int gnuplot_copy(const struct picture *p, pid_t child, int pipe, bool *has_drawn)
{
    char bytes[4096];
    ssize_t n = 1;
    int status = 0;
    struct pollfd ready = {.fd = pipe, .events = POLLIN};
    while (n != 0) {
        /* An interrupt can come just before poll, so poll does not wait for ever. */
        if (poll(&ready, 1, 100) > 0 && (n = read(pipe, bytes, sizeof bytes)) > 0)
            *has_drawn = fwrite(bytes, 1, (size_t)n, p->answer->out) > 0;
        if (dom_raised(io_interrupt))
            kill(-child, SIGKILL); /* ^C does not reach the program's process group */
    }
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        continue;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/* Reports why gnuplot drew nothing: it is not there, or the first line that it wrote to standard error. */
static void gnuplot_failed(int status, FILE *errors, struct problem *problem)
{
    char line[256] = "";
    if (status == NOT_FOUND)
        problem_error(problem, "pictures need gnuplot, which is not installed; run 'apt install "
                               "gnuplot-nox', or enter 'set output csv' for the data");
    rewind(errors);
    while (fgets(line, sizeof line, errors) && strspn(line, " \t\n^") == strlen(line))
        ;
    line[strcspn(line, "\n")] = '\0';
    problem_error(problem, "gnuplot did not draw it: %s", *line ? line : "it was stopped");
}

/* Opens a file in memory, which gnuplot can read. */
static FILE *temporary_open(struct problem *problem)
{
    const int descriptor = memfd_create("picture", MFD_CLOEXEC);
    FILE *file = descriptor >= 0 ? fdopen(descriptor, "w+") : NULL;
    if (!file)
        problem_error(problem, "cannot draw: %s", strerror(errno));
    return file;
}

/* Runs gnuplot, which reads the script and writes to the file of the answer. */
static bool gnuplot_run(const struct picture *p, struct problem *problem)
{
    int ends[2];
    errno = 0;
    if (fflush(p->script) != 0 || ferror(p->script))
        return problem_error(problem, "cannot draw: %s", strerror(errno ? errno : ENOSPC));
    FILE *errors = temporary_open(problem);
    if (!errors)
        return false;
    lseek(fileno(p->script), 0, SEEK_SET);
    /* gnuplot first tries the terminal type in GNUTERM, and exits if it cannot use this type. */
    setenv("GNUTERM", "unknown", 1);
    const pid_t parent = getpid();
    const bool is_piped = pipe(ends) == 0;
    for (int i = 0; i < 2 && is_piped; i++)
        fcntl(ends[i], F_SETFD, FD_CLOEXEC);
    const pid_t child = is_piped ? fork() : -1;
    if (child == 0)
        gnuplot_become(parent, (const int[]){fileno(p->script), ends[1], fileno(errors)});
    bool good = false, has_drawn = false;
    if (child < 0)
        problem_error(problem, "cannot run gnuplot: %s", strerror(errno));
    if (is_piped)
        close(ends[1]);
    if (child > 0) {
        const int status = gnuplot_copy(p, child, ends[0], &has_drawn);
        good = status == 0 && has_drawn;
        if (status != 0 && dom_raised(io_interrupt))
            problem_error(problem, "%s", dom_status_text(DOM_INTERRUPTED));
        else if (status != 0)
            gnuplot_failed(status, errors, problem);
        else if (!has_drawn)
            problem_error(problem, "gnuplot drew nothing");
    }
    if (is_piped)
        close(ends[0]);
    fclose(errors);
    return good;
}

/* ---- Scripts ---- */

/* A quote is written as "\047", in a string of its own. Within single quotes, gnuplot reads '' as a quote,
 * but not at the beginning of a string; and after "'" it would expand macros such as @NAME in the next
 * string. */
void gnuplot_text_part(FILE *script, const char *text, size_t length)
{
    char piece[ESCAPE_PIECE];
    putc('\'', script);
    for (const char *end = text + length; text < end;) {
        if (*text == '\n' || *text == '\'') {
            fputs(*text++ == '\n' ? "'.\"\\n\".'" : "'.\"\\047\".'", script);
        } else {
            text += escape_next(text, false, piece);
            fputs(piece, script);
        }
    }
    putc('\'', script);
}

void gnuplot_text(FILE *script, const char *text)
{
    gnuplot_text_part(script, text, strlen(text));
}

static bool is_script(const struct answer *a)
{
    return extension_of(a->path)->is_script;
}

bool picture_is_filed(const struct answer *a)
{
    return a->path && extension_of(a->path)->terminal;
}

bool picture_begin(struct picture *p, const struct answer *a, double height, double wide, int delay,
                   struct problem *problem)
{
    const char *terminal = extension_of(a->path)->terminal;
    FILE *script = is_script(a) ? a->out : temporary_open(problem);
    *p = (struct picture){.script = script, .answer = a};
    if (!script)
        return false;
    if (is_script(a)) {
        /* The name begins with "./", because gnuplot would run a name that begins with '|'. */
        const char *slash = strrchr(a->path, '/'), *name = slash ? slash + 1 : a->path;
        char pdf[NAME_MAX + 1];
        snprintf(pdf, sizeof pdf, "%.*s.pdf", (int)(strrchr(name, '.') - name), name);
        fputs("# A picture and its data, written by the program domino. gnuplot draws it into a .pdf file of "
              "the same name.\nset output './'.",
              script);
        gnuplot_text(script, pdf);
        putc('\n', script);
    }
    /* The font sizes differ because each terminal has its own unit. */
    fputs("set encoding utf8\nset terminal ", script);
    if (delay > 0)
        fprintf(script, "gif animate delay %d loop 0 size %d,%.0f font 'sans,14' fontscale 0.72 optimize",
                delay, PICTURE_WIDTH, height);
    else if (strcmp(terminal, "pdfcairo") == 0)
        fprintf(script, "pdfcairo size %.3fcm,%.3fcm font 'sans,14' fontscale %.3g", wide,
                wide * height / PICTURE_WIDTH, 0.51 * wide / 16);
    else if (strcmp(terminal, "pngcairo") == 0)
        fprintf(script, "pngcairo size %d,%.0f font 'sans,14' fontscale 1.44 linewidth 2 pointscale 2",
                2 * PICTURE_WIDTH, 2 * height);
    else
        fprintf(script, "svg size %d,%.0f dynamic font 'sans,14' background rgb 'white'", PICTURE_WIDTH,
                height);
    fputs(" noenhanced\n", script);
    return true;
}

bool picture_end(struct picture *p, bool whole, struct problem *problem)
{
    if (is_script(p->answer))
        return whole;
    const bool drawn = whole && gnuplot_run(p, problem);
    progress_end();
    fclose(p->script);
    return drawn;
}
