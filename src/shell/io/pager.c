/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Long texts at a terminal: through a program, or a page at a time. */
#include "domino_quad.h"
#include "io/io.h"
#include "io/output.h"
#include "io/terminal.h"
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

/* A text that comes more slowly than this is shown as it comes. */
#define HOLD_SECONDS 0.5

/* Signals of the terminal that act otherwise while the program runs: as system(3) does, but ^Z stops both
 * programs, and ^C ends what is still being computed; it is ignored once that has ended. */
enum { QUIT, STOP, INTERRUPT, SIGNALS };
static const int signals[SIGNALS] = {SIGQUIT, SIGTSTP, SIGINT};

struct pager {
    struct output output; /* first: a pointer to one is a pointer to the other */
    enum { HELD, DIRECT, PROGRAM, PAGES, LEFT } state;
    FILE *to; /* takes the text: memory while it is held, then the terminal or the program */
    char *text, *messages;
    size_t text_size, messages_size;
    double begun;            /* when the first of the text came; 0: nothing has come */
    int width, height, rows; /* of the terminal, and of the page so far */
    double screens;          /* a shorter text is shown as it is */
    bool programs;           /* may be run */
    const volatile sig_atomic_t *interrupt;
    pid_t child;
    struct sigaction before[SIGNALS];
    struct termios modes; /* of the terminal before the program */
};

/* Returns how many rows of the terminal a line takes; what colours it takes none. */
static int line_rows(const char *line, const char *end, int width)
{
    int columns = 0;
    for (; line < end; line++)
        if (*line == '\033')
            line += strcspn(line, "m");
        else
            columns += ((unsigned char)*line & 0xc0) != 0x80;
    return columns > width ? (columns + width - 1) / width : 1;
}

/* Returns the end of a line, after its '\n'. */
static const char *line_end(const char *line, const char *end)
{
    const char *last = memchr(line, '\n', (size_t)(end - line));
    return last ? last + 1 : end;
}

/* ---- A program ---- */

/* The prompt of less, in whose language '?e' asks for the end and ':' separates what is shown then. */
#define LESS_PROMPT "s?e(end) q\\: back:space\\: more, q\\: back."

/* Starts the program, which reads the text from the file.  Returns false if there is none. */
static bool program_start(int text, pid_t *child)
{
    extern char **environ;
    const char *pager = getenv("PAGER");
    /* A program that does not exist loses no text. */
    static char shown[] =
        "set -- $PAGER; command -v \"$1\" >/dev/null || PAGER='less || cat'; eval \"$PAGER\"";
    char *const own[] = {"sh", "-c", shown, NULL}, *const less[] = {"less", "-FRX", "-P" LESS_PROMPT, NULL};
    bool usual = !(pager && *pager);
    char *const *argv = usual ? less : own;
    setenv("LESS", "FRXP" LESS_PROMPT "$", 0);
    if (usual) { /* what is typed at it by mistake writes no file and runs no program */
        setenv("LESSSECURE", "1", 1);
        setenv("LESSHISTFILE", "-", 1);
    }
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    sigset_t back;
    sigemptyset(&back);
    sigaddset(&back, SIGPIPE);
    sigaddset(&back, SIGXFSZ);
    for (int i = 0; i < SIGNALS; i++)
        sigaddset(&back, signals[i]);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigdefault(&attributes, &back);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, text, STDIN_FILENO);
    int failed = posix_spawnp(child, argv[0], &actions, &attributes, argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    return failed == 0;
}

/* Runs the program at the end of a pipe, to which the text then goes; returns false if there is none. */
static bool program_open(struct pager *p)
{
    const char *term = getenv("TERM"), *pager = getenv("PAGER");
    int ends[2];
    if (!p->programs || (!(pager && *pager) && !(term && *term && strcmp(term, "dumb") != 0)) ||
        tcgetattr(STDIN_FILENO, &p->modes) != 0 || pipe2(ends, O_CLOEXEC) != 0)
        return false;
    bool started = program_start(ends[0], &p->child);
    close(ends[0]);
    fcntl(ends[1], F_SETFL, O_NONBLOCK);
    FILE *to = io_stream(ends[1], "w", p->interrupt);
    if (!started || !to) {
        if (to)
            fclose(to);
        return false;
    }
    p->to = to;
    const struct sigaction ignored = {.sa_handler = SIG_IGN}, usual = {.sa_handler = SIG_DFL};
    sigaction(SIGQUIT, &ignored, &p->before[QUIT]);
    sigaction(SIGTSTP, &usual, &p->before[STOP]);
    sigaction(SIGINT, NULL, &p->before[INTERRUPT]);
    return true;
}

/* Ends the text, and waits for the program; a signal that ends the session ends the program, too. */
static void program_close(struct pager *p)
{
    const struct timespec moment = {.tv_nsec = 20000000};
    pid_t ended;
    fclose(p->to);
    sigaction(SIGINT, &(struct sigaction){.sa_handler = SIG_IGN}, NULL);
    while ((ended = waitpid(p->child, NULL, WNOHANG)) == 0 || (ended < 0 && errno == EINTR)) {
        if (dom_raised(p->interrupt) && *p->interrupt != SIGINT)
            kill(p->child, SIGTERM);
        nanosleep(&moment, NULL);
    }
    /* A program that was killed leaves its own modes; in the background they are another job's. */
    if (tcgetpgrp(STDIN_FILENO) == getpgrp())
        tcsetattr(STDIN_FILENO, TCSADRAIN, &p->modes);
    for (int i = 0; i < SIGNALS; i++)
        sigaction(signals[i], &p->before[i], NULL);
}

/* ---- Without a program ---- */

/* Asks for the next page; returns false if there is to be none.  The terminal keeps its modes. */
static bool next_page(const struct pager *p)
{
    char answer[256] = "";
    ssize_t n = 0;
    fputs("-- more -- (Enter: next page; q, Enter: end) ", p->to);
    fflush(p->to);
    if (io_wait(STDIN_FILENO, POLLIN, NULL, p->interrupt))
        n = read(STDIN_FILENO, answer, sizeof answer);
    if (n <= 0)
        putc('\n', p->to);
    return n > 0 && *answer != 'q' && *answer != 'Q';
}

/* Writes lines, and asks before each page; returns false after an answer that ends the text. */
static bool pages_write(struct pager *p, const char *text, size_t size)
{
    const char *end = text + size;
    for (const char *next; text < end; text = next) {
        next = line_end(text, end);
        int more = line_rows(text, next - 1, p->width);
        if (p->rows > 0 && p->rows + more >= p->height) {
            if (!next_page(p))
                return false;
            p->rows = 0;
        }
        fwrite(text, 1, (size_t)(next - text), p->to);
        p->rows += more;
    }
    return true;
}

/* ---- The level ---- */

/* Writes to where the text goes now; returns false if the reader has left. */
static bool pass(struct pager *p, const char *text, size_t size)
{
    bool written = p->state == PAGES ? pages_write(p, text, size) : fwrite(text, 1, size, p->to) == size;
    if (written && fflush(p->to) == 0)
        return true;
    if (p->state == PROGRAM)
        program_close(p);
    p->state = p->state == HELD ? HELD : LEFT; /* for what is held there may be no memory */
    return false;
}

/* Decides how the text that was held is shown. */
static bool show(struct pager *p, bool pages)
{
    if (p->to)
        fclose(p->to);
    p->to = p->output.below->out;
    if (pages)
        ticker_stop();
    p->state = !pages ? DIRECT : program_open(p) ? PROGRAM : PAGES;
    return pass(p, p->text ? p->text : "", p->text_size);
}

static ssize_t pager_write(void *pager, const char *text, size_t size)
{
    struct pager *p = pager;
    double now = terminal_clock();
    bool slow = p->begun > 0 && now - p->begun > HOLD_SECONDS;
    p->begun = p->begun > 0 ? p->begun : now;
    errno = EPIPE;
    if (p->state == LEFT || !pass(p, text, size))
        return 0;
    if (p->state != HELD)
        return (ssize_t)size;
    long rows = 0;
    for (const char *line = p->text, *end = line + p->text_size, *next; line < end; line = next) {
        next = line_end(line, end);
        rows += line_rows(line, next - 1, p->width);
    }
    return (!slow && (double)rows < p->screens * p->height) || show(p, !slow) ? (ssize_t)size : 0;
}

static const char *pager_pop(struct output *o, bool keep)
{
    struct pager *p = (struct pager *)o;
    (void)keep;
    terminal_lend(o->out, false);
    fclose(o->out);
    if (p->state == HELD)
        show(p, false);
    if (p->state == PROGRAM)
        program_close(p);
    if (o->messages != o->below->messages)
        fclose(o->messages);
    if (p->messages)
        fwrite(p->messages, 1, p->messages_size, o->below->messages);
    free(p->messages);
    free(p->text);
    return p->state == LEFT ? "the reader has left" : NULL;
}

bool pager_push(struct output **top, double screens, bool programs, const volatile sig_atomic_t *interrupt)
{
    FILE *terminal = (*top)->out;
    int width, height;
    if (fileno(terminal) != STDOUT_FILENO || !isatty(STDIN_FILENO) ||
        !terminal_size(terminal, &width, &height) || width <= 0 || height <= 0)
        return false;
    struct pager *p = malloc(sizeof *p);
    FILE *out = p ? fopencookie(p, "w", (cookie_io_functions_t){.write = pager_write}) : NULL;
    if (!out) {
        free(p);
        return false;
    }
    *p = (struct pager){.output = {.kind = OUTPUT_PAGER, .out = out, .pop = pager_pop},
                        .width = width,
                        .height = height,
                        .screens = screens,
                        .programs = programs,
                        .interrupt = interrupt};
    p->to = io_memory(&p->text, &p->text_size);
    p->output.messages = io_memory(&p->messages, &p->messages_size);
    setvbuf(out, NULL, _IOLBF, BUFSIZ);
    output_push(top, &p->output);
    terminal_lend(out, true);
    if (!p->to)
        show(p, false);
    return true;
}
