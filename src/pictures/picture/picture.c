/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/picture/picture.h"
#include "answer/answer.h"
#include "domino_quad.h"
#include "io/escape.h"
#include "io/io.h"
#include "io/terminal.h"
#include "language/names.h"
#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

/* ---- The program gnuplot ---- */

enum { NOT_FOUND = 127 }; /* the exit status of a child that finds no gnuplot */

/* Waits for gnuplot and kills it after an interrupt. Returns its exit status, or -1 if it was killed. */
static int gnuplot_wait(pid_t child, const volatile sig_atomic_t *interrupt)
{
    const struct timespec moment = {.tv_nsec = 5000000};
    int status = 0;
    pid_t ended;
    while ((ended = waitpid(child, &status, WNOHANG)) == 0 || (ended < 0 && errno == EINTR)) {
        if (dom_raised(interrupt))
            kill(-child, SIGKILL); /* ^C does not reach the program's process group */
        nanosleep(&moment, NULL);
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

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

/* Reports why gnuplot drew nothing: it is not there, or the first line that it wrote to standard error. */
static void gnuplot_failed(int status, FILE *errors, struct problem *problem)
{
    char line[256] = "";
    rewind(errors);
    while (fgets(line, sizeof line, errors) && strspn(line, " \t\n^") == strlen(line))
        ;
    line[strcspn(line, "\n")] = '\0';
    if (status == NOT_FOUND)
        problem_error(problem, "pictures need gnuplot, which is not installed; run 'apt install "
                               "gnuplot-nox', or enter 'set output csv' for the data");
    else
        problem_error(problem, "gnuplot did not draw it: %s", *line ? line : "it was stopped");
}

/* Opens a temporary file, which is deleted when it is closed. */
static FILE *temporary_open(struct problem *problem)
{
    const int descriptor = io_temporary(NULL, NULL);
    FILE *file = descriptor >= 0 ? fdopen(descriptor, "w+") : NULL;
    const int error = errno;
    if (!file)
        problem_error(problem, "cannot make a temporary file in '%s': %s", names_shown(io_temporary_folder()),
                      strerror(error));
    return file;
}

/* Runs gnuplot, which reads `in` from its beginning and writes to `out`. */
static bool gnuplot_run(FILE *in, FILE *out, const volatile sig_atomic_t *interrupt, struct problem *problem)
{
    FILE *errors = temporary_open(problem);
    if (!errors)
        return false;
    const int file[] = {fileno(in), fileno(out), fileno(errors)};
    pid_t parent = getpid();
    fflush(in);
    rewind(in);
    lseek(file[0], 0, SEEK_SET);
    pid_t child = fork();
    if (child == 0)
        gnuplot_become(parent, file);
    const int status = child > 0 ? gnuplot_wait(child, interrupt) : -1;
    if (child < 0)
        problem_error(problem, "cannot run gnuplot: %s", strerror(errno));
    else if (status != 0 && dom_raised(interrupt))
        problem_error(problem, "%s", dom_status_text(DOM_INTERRUPTED));
    else if (status != 0)
        gnuplot_failed(status, errors, problem);
    fclose(errors);
    return status == 0;
}

/* ---- Scripts ---- */

/* A quote is written as "\047", in a string of its own. Within single quotes, gnuplot reads '' as a quote,
 * but not at the beginning of a string; and after "'" it would expand macros such as @NAME in the next
 * string. */
static void quoted(FILE *script, const char *text, size_t length, bool escapes)
{
    char piece[ESCAPE_PIECE];
    putc('\'', script);
    for (const char *end = text + length; text < end;) {
        if (*text == '\n' || *text == '\'') {
            fputs(*text++ == '\n' ? "'.\"\\n\".'" : "'.\"\\047\".'", script);
        } else if (escapes) {
            text += escape_next(text, piece);
            fputs(piece, script);
        } else {
            putc(*text++, script);
        }
    }
    putc('\'', script);
}

void gnuplot_text_part(FILE *script, const char *text, size_t length)
{
    quoted(script, text, length, true);
}

void gnuplot_text(FILE *script, const char *text)
{
    quoted(script, text, strlen(text), true);
}

/* Writes the head of a script that draws a .pdf file of the same name. The name begins with "./", because
 * gnuplot would run a name that begins with '|'. */
static void script_head(const struct answer *a)
{
    const char *slash = strrchr(a->path, '/'), *name = slash ? slash + 1 : a->path;
    char pdf[NAME_MAX + 1];
    snprintf(pdf, sizeof pdf, "%.*s.pdf", (int)(strrchr(name, '.') - name), name);
    fputs("# A picture and its data, written by the program domino. gnuplot draws it into a .pdf file of the "
          "same name.\nset output './'.",
          a->out);
    quoted(a->out, pdf, strlen(pdf), false); /* a control character belongs to the name */
    putc('\n', a->out);
}

static bool is_script(const struct answer *a)
{
    return extension_of(a->path)->is_script;
}

struct axis_unit measure_axis(double longest)
{
    return longest >= 2     ? (struct axis_unit){"m", 1}
           : longest >= 0.2 ? (struct axis_unit){"cm", 0.01}
                            : (struct axis_unit){"mm", 0.001};
}

bool picture_is_filed(const struct answer *a)
{
    return a->path && extension_of(a->path)->terminal;
}

bool picture_ready(const struct answer *a, struct problem *problem)
{
    return !(a->path && a->appended && extension_of(a->path)->kind >= EXTENSION_FILM) ||
           problem_error(problem, "'%s' can hold only one picture; '>' replaces it", names_shown(a->path));
}

/* Writes the terminal setting. The font sizes differ because each terminal has its own unit. */
static void terminal_script(const struct answer *a, double height, double wide, int delay, FILE *script)
{
    const char *name = extension_of(a->path)->terminal;
    fputs("set encoding utf8\nset terminal ", script);
    if (delay > 0)
        fprintf(script, "gif animate delay %d loop 0 size %d,%.0f font 'sans,14' fontscale 0.72 optimize",
                delay, PICTURE_WIDTH, height);
    else if (strcmp(name, "pdfcairo") == 0)
        fprintf(script, "pdfcairo size %.3fcm,%.3fcm font 'sans,14' fontscale %.3g", wide,
                wide * height / PICTURE_WIDTH, 0.51 * wide / 16);
    else if (strcmp(name, "pngcairo") == 0)
        fprintf(script, "pngcairo size %d,%.0f font 'sans,14' fontscale 1.44 linewidth 2 pointscale 2",
                2 * PICTURE_WIDTH, 2 * height);
    else
        fprintf(script, "svg size %d,%.0f dynamic font 'sans,14' background rgb 'white'", PICTURE_WIDTH,
                height);
    fputs(" noenhanced\n", script);
}

bool picture_begin(struct picture *p, const struct answer *a, double height, double wide, int delay,
                   const volatile sig_atomic_t *interrupt, struct problem *problem)
{
    *p = (struct picture){
        .script = is_script(a) ? a->out : temporary_open(problem), .answer = a, .interrupt = interrupt};
    if (!p->script)
        return false;
    if (is_script(a))
        script_head(a);
    terminal_script(a, height, wide, delay, p->script);
    return true;
}

/* Returns an error number if the disk was too full for the drawing, and 0 otherwise. */
static int drawing_error(FILE *drawing, long size)
{
    /* gnuplot does not report that the disk is full. If the file has no room for another block, the drawing
     * is probably incomplete. */
    static const char block[BUFSIZ];
    const ssize_t written = pwrite(fileno(drawing), block, sizeof block, size);
    const int error = written == sizeof block ? 0 : written < 0 ? errno : ENOSPC;
    return ftruncate(fileno(drawing), size) != 0 ? errno : error;
}

static bool draw(const struct picture *p, FILE *drawing, struct problem *problem)
{
    errno = 0;
    if (fflush(p->script) != 0 || ferror(p->script))
        return problem_error(problem, "cannot draw: %s", strerror(errno ? errno : ENOSPC));
    /* gnuplot first tries the terminal type in GNUTERM, and exits if it cannot use this type. */
    setenv("GNUTERM", "unknown", 1);
    if (!gnuplot_run(p->script, drawing, p->interrupt, problem))
        return false;
    fseek(drawing, 0, SEEK_END);
    long size = ftell(drawing);
    int error = size > 0 ? drawing_error(drawing, size) : 0;
    if (size <= 0)
        return problem_error(problem, "gnuplot drew nothing");
    if (error)
        return problem_error(problem, "cannot draw: %s", strerror(error));
    progress_end();
    char bytes[4096];
    rewind(drawing);
    for (size_t n; (n = fread(bytes, 1, sizeof bytes, drawing)) > 0;)
        fwrite(bytes, 1, n, p->answer->out);
    return true;
}

bool picture_end(struct picture *p, bool whole, struct problem *problem)
{
    if (is_script(p->answer))
        return whole;
    FILE *drawing = whole ? temporary_open(problem) : NULL;
    bool drawn = drawing && draw(p, drawing, problem);
    if (drawing)
        fclose(drawing);
    fclose(p->script);
    return drawn;
}
