/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures by gnuplot: a script, and the program that draws it. */
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

bool program_there(const char *name)
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

bool gnuplot_ready(struct problem *problem)
{
    return program_there("gnuplot") ||
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

/* Waits for a program, and ends it after an interrupt: by itself it would continue at a ^C. */
static int program_wait(pid_t child, const volatile sig_atomic_t *interrupt)
{
    const struct timespec moment = {.tv_nsec = 5000000};
    int status = 0;
    pid_t ended;
    while ((ended = waitpid(child, &status, WNOHANG)) == 0 || (ended < 0 && errno == EINTR)) {
        if (dom_raised(interrupt))
            kill(-child, SIGKILL); /* the whole group */
        nanosleep(&moment, NULL);
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? 0 : -1;
}

/* Becomes the program, in the child process. */
static void program_become(char *const argv[], pid_t parent, const int file[3])
{
    /*
     * In a process group of its own a program gets no ^Z: it would stop, and this program, which stops when
     * the command is done, would wait for it without end.
     */
    setpgid(0, 0);
    /* It ends with this program, whatever ends that; which may have happened already. */
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(127);
    for (int i = 0; i < 3; i++)
        dup2(file[i], i);
    execvp(argv[0], argv);
    dprintf(STDERR_FILENO, "%s\n", strerror(errno));
    _exit(127);
}

int program_run(char *const argv[], FILE *in, FILE *out, FILE *complaints,
                const volatile sig_atomic_t *interrupt)
{
    const int file[] = {fileno(in), fileno(out), fileno(complaints)};
    pid_t parent = getpid();
    fflush(in);
    rewind(in);
    lseek(file[0], 0, SEEK_SET);
    pid_t child = fork();
    if (child == 0)
        program_become(argv, parent, file);
    return child < 0 ? errno : program_wait(child, interrupt);
}

bool program_failed(const char *name, int wrong, FILE *complaints, const char *what,
                    const volatile sig_atomic_t *interrupt, struct problem *problem)
{
    char line[256] = "";
    if (wrong > 0)
        return problem_error(problem, "cannot run %s: %s", name, strerror(wrong));
    if (dom_raised(interrupt))
        return problem_error(problem, "%s", dom_status_text(DOM_INTERRUPTED));
    rewind(complaints);
    while (fgets(line, sizeof line, complaints) && strspn(line, " \t\n^") == strlen(line))
        ;
    line[strcspn(line, "\n")] = '\0';
    return problem_error(problem, "%s did not %s: %s", name, what, *line ? line : "it was stopped");
}

/* Checks the size of the drawing: gnuplot does not report a full disk, and then the end of the drawing is
 * missing. Returns errno. */
static int drawing_room(FILE *drawing, long size)
{
    int wrong = posix_fallocate(fileno(drawing), size, BUFSIZ);
    return ftruncate(fileno(drawing), size) != 0 ? errno : wrong;
}

static bool draw(const struct picture *p, FILE *drawing, FILE *complaints, struct problem *problem)
{
    char *const argv[] = {"gnuplot", "-d", "/dev/stdin",
                          NULL}; /* by its name: from "-" it reads byte by byte */
    ;
    char block[4096];
    errno = 0;
    if (fflush(p->script) != 0 || ferror(p->script))
        return problem_error(problem, "cannot draw: %s", strerror(errno ? errno : ENOSPC));
    /* gnuplot tries the terminal of the environment before it reads the script, and ends without it. */
    int wrong = setenv("GNUTERM", "unknown", 1) == 0
                    ? program_run(argv, p->script, drawing, complaints, p->interrupt)
                    : errno;
    if (wrong)
        return program_failed("gnuplot", wrong, complaints, "draw it", p->interrupt, problem);
    fseek(drawing, 0, SEEK_END);
    long size = ftell(drawing);
    if (size >= 0 && (wrong = drawing_room(drawing, size)) != 0)
        return problem_error(problem, "cannot draw: %s", strerror(wrong));
    if (size <= 0)
        return problem_error(problem, "gnuplot drew nothing");
    progress_end();
    rewind(drawing);
    for (size_t n; (n = fread(block, 1, sizeof block, drawing)) > 0;)
        fwrite(block, 1, n, p->out);
    return true;
}

bool picture_end(struct picture *p, bool whole, struct problem *problem)
{
    FILE *drawing = whole ? io_temporary(NULL) : NULL, *complaints = drawing ? io_temporary(NULL) : NULL;
    bool drawn = complaints ? draw(p, drawing, complaints, problem)
                            : whole && problem_error(problem, "cannot draw: %s", strerror(errno));
    if (drawing)
        fclose(drawing);
    if (complaints)
        fclose(complaints);
    fclose(p->script);
    return drawn;
}
