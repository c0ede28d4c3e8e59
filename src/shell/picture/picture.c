/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture/picture.h"
#include "io/io.h"
#include "io/terminal.h"
#include "language/names.h"
#include "picture/ending.h"
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { TEXT_WIDTH = 79, TEXT_HEIGHT = 23, LEAST_WIDTH = 31, LEAST_HEIGHT = 13 };

bool picture_is_text(const struct answer *a)
{
    return !a->path || ending_of(a->path)->kind != ENDING_PICTURE;
}

void picture_room(const struct answer *a, int *width, int *height)
{
    terminal_size(a->out, width, height);
    *width = *width >= LEAST_WIDTH ? *width - 1 : TEXT_WIDTH;
    *height = *height >= LEAST_HEIGHT ? *height - 1 : TEXT_HEIGHT;
    *height = *height > TEXT_WIDTH / 2 ? TEXT_WIDTH / 2 : *height; /* no taller than wide */
}

bool picture_fits(const struct answer *a, const char *command, struct problem *problem)
{
    int width, height;
    terminal_size(a->out, &width, &height);
    return width == 0 || height == 0 || (width >= LEAST_WIDTH && height >= LEAST_HEIGHT) ||
           problem_error(problem,
                         "the terminal has %d x %d characters, and a picture needs %d x %d; enlarge it, or "
                         "enter '%s > %s.txt'",
                         width, height, LEAST_WIDTH, LEAST_HEIGHT, command, command);
}

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

bool picture_possible(void)
{
    return program_there("gnuplot");
}

static bool gnuplot_ready(struct problem *problem)
{
    return picture_possible() ||
           problem_error(problem, "pictures need gnuplot, which is not installed: 'apt install "
                                  "gnuplot-nox'; 'set output csv' gives the data");
}

bool picture_ready(struct answer *a, struct problem *problem)
{
    char shown[NAMES_SHOWN];
    if (a->appended)
        return problem_error(problem, "'%s' holds one picture, and '>>' cannot add another; '>' replaces it",
                             names_shown(a->path, shown));
    return gnuplot_ready(problem);
}

/* The script up to what every picture has in common. */
static bool script_begin(struct problem *problem, struct picture *picture, const char *terminal)
{
    /* Lines also differ by their points and dashes, for print and for colour-blind readers. */
    static const char *const colours[] = {"#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#555555"};
    static const int points[] = {1, 2, 6, 4, 8, 10};
    if (!gnuplot_ready(problem))
        return false;
    picture->script = io_temporary(NULL);
    if (!picture->script)
        return problem_error(problem, "cannot draw: %s", strerror(errno));
    fprintf(picture->script, "set encoding utf8\nset terminal %s\n", terminal);
    for (int k = 0; k < 6; k++)
        fprintf(picture->script, "set linetype %d lc rgb '%s' lw 2 dt %d pt %d ps 1\n", k + 1, colours[k],
                k % 5 + 1, points[k]);
    fprintf(picture->script,
            "set border 3\nset tics nomirror\nset datafile missing 'nan'\n"
            "set key below Left reverse samplen 4 height 0.6\n%s\n",
            picture->text ? ""
                          : "set grid lc rgb '#bbbbbb' lw 0.5 dt 1"); /* of characters, it hides curves */
    return true;
}

bool picture_begin(struct answer *a, struct problem *problem, struct picture *picture)
{
    char terminal[128];
    bool text = picture_is_text(a);
    int width, height;
    if (!text && !picture_ready(a, problem))
        return false;
    picture_room(a, &width, &height);
    if (text)
        snprintf(terminal, sizeof terminal, "dumb size %d,%d noenhanced", width, height);
    else
        snprintf(terminal, sizeof terminal, "%s enhanced", ending_of(a->path)->terminal);
    *picture = (struct picture){
        .out = a->out, .text = text, .theta = text ? "theta" : "\u03b8", .omega = text ? "omega" : "\u03c9"};
    return script_begin(problem, picture, terminal);
}

bool picture_on(struct problem *problem, struct picture *picture, FILE *out, const char *terminal)
{
    *picture = (struct picture){.out = out, .theta = "\u03b8", .omega = "\u03c9"};
    return script_begin(problem, picture, terminal);
}

bool picture_animation(struct problem *problem, struct picture *picture, FILE *out, int width, int height,
                       int delay)
{
    char terminal[128];
    snprintf(terminal, sizeof terminal, "gif animate delay %d loop 0 size %d,%d noenhanced optimize", delay,
             width, height);
    *picture = (struct picture){.out = out, .theta = "theta", .omega = "omega"};
    return script_begin(problem, picture, terminal);
}

bool picture_comes_to(const struct query *query, struct problem *problem, domq_real theta)
{
    struct domq_value omegasq, stop = {.value = DOMQ_NAN};
    const struct output_style *style = &query->state->settings.style;
    enum dom_status status =
        domq_cycle_omegasq(&query->scene->train, &query->scene->compute, theta, &omegasq);
    if (status == DOM_NO_FUEL)
        return problem_error(problem, "no domino effect: the fuel P is not positive, nothing moves; 'fuel' "
                                      "says why, 'rmax' how large r may be");
    if (status == DOM_STOPS)
        status = domq_cycle_stop(&query->scene->train, &query->scene->compute, &stop);
    if (status != DOM_OK)
        return problem_status(problem, query->scene, status);
    /* The end may have been rounded up to the 6 digits of a table: a picture does not show the difference. */
    if (stop.value < theta * (1 - (domq_real)1e-5))
        return problem_error(
            problem, "the train does not come to T = %.10g %s: it stops at %.10g %s, below the barrier",
            (double)style_angle(style, theta), style_angle_unit(style),
            (double)style_angle(style, stop.value), style_angle_unit(style));
    return true;
}

/* Waits for a program, and ends it after an interrupt: by itself it would continue at a ^C. */
static int program_wait(const struct query *query, pid_t child)
{
    const struct timespec moment = {.tv_nsec = 5000000};
    int status = 0;
    pid_t ended;
    while ((ended = waitpid(child, &status, WNOHANG)) == 0 || (ended < 0 && errno == EINTR)) {
        if (dom_raised(query->scene->compute.interrupt))
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

int program_run(const struct query *query, char *const argv[], FILE *script, FILE *drawing, FILE *complaints)
{
    const int file[] = {fileno(script), fileno(drawing), fileno(complaints)};
    pid_t parent = getpid();
    fflush(script);
    rewind(script);
    lseek(file[0], 0, SEEK_SET);
    pid_t child = fork();
    if (child == 0)
        program_become(argv, parent, file);
    return child < 0 ? errno : program_wait(query, child);
}

static int gnuplot_run(const struct query *query, FILE *script, FILE *drawing, FILE *complaints)
{
    char *const argv[] = {"gnuplot", "-d", "-", NULL};
    /* gnuplot tries the terminal of the environment before it reads the script, and ends without it. */
    return setenv("GNUTERM", "unknown", 1) == 0 ? program_run(query, argv, script, drawing, complaints)
                                                : errno;
}

/* Checks the size of the drawing: gnuplot does not report a full disk, and then the end of the drawing is
 * missing. Returns errno. */
static int drawing_room(FILE *drawing, long size)
{
    int wrong = posix_fallocate(fileno(drawing), size, BUFSIZ);
    return ftruncate(fileno(drawing), size) != 0 ? errno : wrong;
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

static bool draw(const struct query *query, struct problem *problem, const struct picture *picture,
                 FILE *drawing, FILE *complaints)
{
    char line[256] = "";
    errno = 0;
    if (fflush(picture->script) != 0 || ferror(picture->script))
        return problem_error(problem, "cannot draw: %s", strerror(errno ? errno : ENOSPC));
    int wrong = gnuplot_run(query, picture->script, drawing, complaints);
    if (wrong > 0)
        return problem_error(problem, "cannot run gnuplot: %s", strerror(wrong));
    if (wrong && dom_raised(query->scene->compute.interrupt))
        return problem_status(problem, query->scene, DOM_INTERRUPTED);
    rewind(complaints);
    while (wrong && fgets(line, sizeof line, complaints) && strspn(line, " \t\n^") == strlen(line))
        ;
    line[strcspn(line, "\n")] = '\0';
    if (wrong)
        return problem_error(problem, "gnuplot did not draw it: %s", *line ? line : "it was stopped");
    fseek(drawing, 0, SEEK_END);
    long size = ftell(drawing);
    if (size >= 0 && (wrong = drawing_room(drawing, size)) != 0)
        return problem_error(problem, "cannot draw: %s", strerror(wrong));
    if (size <= 0)
        return problem_error(problem, "gnuplot drew nothing");
    ticker_stop();
    drawing_copy(drawing, picture->out, picture->text);
    return true;
}

bool picture_end(const struct query *query, struct problem *problem, struct picture *picture, bool whole)
{
    FILE *drawing = whole ? io_temporary(NULL) : NULL, *complaints = drawing ? io_temporary(NULL) : NULL;
    bool drawn = complaints ? draw(query, problem, picture, drawing, complaints)
                            : whole && problem_error(problem, "cannot draw: %s", strerror(errno));
    if (drawing)
        fclose(drawing);
    if (complaints)
        fclose(complaints);
    fclose(picture->script);
    return drawn;
}
