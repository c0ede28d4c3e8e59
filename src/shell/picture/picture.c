/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture/picture.h"
#include "domino_quad.h"
#include "io/io.h"
#include "io/terminal.h"
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* ---- Programs ---- */

bool program_exists(const char *name)
{
    const char *folder = getenv("PATH") ? getenv("PATH") : "/bin:/usr/bin";
    char path[4096];
    for (size_t n; folder; folder = folder[n] ? folder + n + 1 : NULL) {
        n = strcspn(folder, ":");
        snprintf(path, sizeof path, "%.*s/%s", (int)n, n ? folder : ".", name);
        if (access(path, X_OK) == 0)
            return true;
    }
    return false;
}

/* Waits for a program, which does not see a ^C itself, and kills it after an interrupt. Returns true if it
 * was successful. */
static bool program_wait(pid_t child, const volatile sig_atomic_t *interrupt)
{
    const struct timespec moment = {.tv_nsec = 5000000};
    int status = 0;
    pid_t ended;
    while ((ended = waitpid(child, &status, WNOHANG)) == 0 || (ended < 0 && errno == EINTR)) {
        if (dom_raised(interrupt))
            kill(-child, SIGKILL); /* the whole process group */
        nanosleep(&moment, NULL);
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/* Becomes the program, in the child process. */
static void program_become(char *const argv[], pid_t parent, const int file[3])
{
    /*
     * In a process group of its own a program gets no ^Z. It would stop, and this program, which stops only
     * when the command is done, would wait for it without end.
     */
    setpgid(0, 0);
    /* The program is to end with this one, which may have ended already. */
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(127);
    for (int i = 0; i < 3; i++)
        dup2(file[i], i);
    execvp(argv[0], argv);
    dprintf(STDERR_FILENO, "%s\n", strerror(errno));
    _exit(127);
}

/* Describes the failure of a program by the first line that it wrote to standard error. */
static bool program_failed(const char *name, const char *what, FILE *errors, struct problem *problem)
{
    char line[256] = "";
    rewind(errors);
    while (fgets(line, sizeof line, errors) && strspn(line, " \t\n^") == strlen(line))
        ;
    line[strcspn(line, "\n")] = '\0';
    return problem_error(problem, "%s did not %s: %s", name, what, *line ? line : "it was stopped");
}

bool program_run(char *const argv[], FILE *in, FILE *out, const char *what,
                 const volatile sig_atomic_t *interrupt, struct problem *problem)
{
    FILE *errors = io_temporary(NULL);
    if (!errors)
        return problem_error(problem, "cannot draw: %s", strerror(errno));
    const int file[] = {fileno(in), fileno(out), fileno(errors)};
    pid_t parent = getpid();
    fflush(in);
    rewind(in);
    lseek(file[0], 0, SEEK_SET);
    pid_t child = fork();
    if (child == 0)
        program_become(argv, parent, file);
    bool done = child > 0 && program_wait(child, interrupt);
    if (child < 0)
        problem_error(problem, "cannot run %s: %s", argv[0], strerror(errno));
    else if (!done && dom_raised(interrupt))
        problem_error(problem, "%s", dom_status_text(DOM_INTERRUPTED));
    else if (!done)
        program_failed(argv[0], what, errors, problem);
    fclose(errors);
    return done;
}

/* ---- gnuplot ---- */

bool gnuplot_ready(struct problem *problem)
{
    return program_exists("gnuplot") ||
           problem_error(problem, "pictures need gnuplot, which is not installed: 'apt install "
                                  "gnuplot-nox'; 'set output csv' gives the data");
}

bool picture_begin(struct picture *p, FILE *out, const char *terminal, const volatile sig_atomic_t *interrupt,
                   struct problem *problem)
{
    if (!gnuplot_ready(problem))
        return false;
    *p = (struct picture){.script = io_temporary(NULL), .out = out, .interrupt = interrupt};
    if (!p->script)
        return problem_error(problem, "cannot draw: %s", strerror(errno));
    fprintf(p->script, "set encoding utf8\nset terminal %s\n", terminal);
    return true;
}

/*
 * Returns the error with which the drawing cannot be whole, or 0. gnuplot does not report a full disk, on
 * which the end of the drawing is missing: there is then no room for another block.
 */
static int drawing_error(FILE *drawing, long size)
{
    int error = posix_fallocate(fileno(drawing), size, BUFSIZ);
    return ftruncate(fileno(drawing), size) != 0 ? errno : error;
}

static bool draw(const struct picture *p, FILE *drawing, struct problem *problem)
{
    /* gnuplot reads the script in blocks if it has a name, and byte by byte from "-". */
    char *const argv[] = {"gnuplot", "-d", "/dev/stdin", NULL};
    char block[4096];
    errno = 0;
    if (fflush(p->script) != 0 || ferror(p->script))
        return problem_error(problem, "cannot draw: %s", strerror(errno ? errno : ENOSPC));
    /* gnuplot tries the terminal of the environment before it reads the script, and ends if there is none. */
    setenv("GNUTERM", "unknown", 1);
    if (!program_run(argv, p->script, drawing, "draw it", p->interrupt, problem))
        return false;
    fseek(drawing, 0, SEEK_END);
    long size = ftell(drawing);
    int error = size > 0 ? drawing_error(drawing, size) : 0;
    if (size <= 0)
        return problem_error(problem, "gnuplot drew nothing");
    if (error)
        return problem_error(problem, "cannot draw: %s", strerror(error));
    progress_end();
    rewind(drawing);
    for (size_t n; (n = fread(block, 1, sizeof block, drawing)) > 0;)
        fwrite(block, 1, n, p->out);
    return true;
}

bool picture_end(struct picture *p, bool whole, struct problem *problem)
{
    FILE *drawing = whole ? io_temporary(NULL) : NULL;
    bool drawn = drawing ? draw(p, drawing, problem)
                         : whole && problem_error(problem, "cannot draw: %s", strerror(errno));
    if (drawing)
        fclose(drawing);
    fclose(p->script);
    return drawn;
}
