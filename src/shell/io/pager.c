/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shows long texts on a terminal, with a pager program or page by page. */
#include "domino_quad.h"
#include "io/io.h"
#include "io/output.h"
#include "io/system.h"
#include "io/terminal.h"
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

/* Text is held back until there is enough of it for a pager. If this takes longer than HOLD_SECONDS, the text
 * is shown as it arrives, without a pager, so that the user need not wait. */
#define HOLD_SECONDS 0.5

/* The prompt that 'less' shows, in the syntax of its option -P. '?e' tests for the end of the text, and ':'
 * means "else". */
#define LESS_PROMPT "s?e(end) q\\: back:space\\: more, q\\: back."

/* The signals whose handlers change while a pager program runs. SIGQUIT is ignored. SIGTSTP (^Z) stops both
 * programs. SIGINT (^C) ends the computation. Once the computation has ended, SIGINT is ignored too. */
enum { QUIT, STOP, INTERRUPT, SIGNALS };
static const int signals[SIGNALS] = {SIGQUIT, SIGTSTP, SIGINT};

struct pager {
    /* must be the first member, so that a pointer to it is also a pointer to struct pager */
    struct output output;
    enum { HELD, DIRECT, PROGRAM, PAGES, LEFT } state;
    FILE *to; /* memory while the state is HELD; later the terminal, or the pipe to the pager program */
    char *text, *messages;
    size_t text_size, messages_size;
    double begun; /* the terminal_clock time when the first text arrived; 0 before that */
    int width, height;
    int rows;       /* the number of terminal rows that the current page has filled so far */
    double screens; /* text that fills at least this many screens is paged */
    bool may_run;
    const volatile sig_atomic_t *interrupt;
    pid_t child;
    struct sigaction before[SIGNALS];
    struct termios modes; /* the terminal modes before the pager program was started */
};

/* Returns how many rows of the terminal a line occupies. Escape sequences for colours take no columns. */
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

static const char *line_next(const char *line, const char *end)
{
    const char *last = memchr(line, '\n', (size_t)(end - line));
    return last ? last + 1 : end;
}

/* ---- A pager program ---- */

/* Starts a pager program that reads from the descriptor `text`. `command` is $PAGER, or NULL for 'less'. */
static bool program_start(const char *command, int text, pid_t *child)
{
    extern char **environ;
    /* If $PAGER does not exist, falls back to 'less' and, without 'less', to 'cat'. */
    static char shell[] =
        "set -- $PAGER; command -v \"$1\" >/dev/null || PAGER='less || cat'; eval \"$PAGER\"";
    char *const users[] = {"sh", "-c", shell, NULL}, *const less[] = {"less", "-FRX", "-P" LESS_PROMPT, NULL};
    char *const *argv = command ? users : less;
    setenv("LESS", "FRXP" LESS_PROMPT "$", 0);
    if (!command) { /* a key pressed by mistake must not write a file or run a program */
        setenv("LESSSECURE", "1", 1);
        setenv("LESSHISTFILE", "-", 1);
    }
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    sigset_t defaults;
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGPIPE);
    sigaddset(&defaults, SIGXFSZ);
    for (int i = 0; i < SIGNALS; i++)
        sigaddset(&defaults, signals[i]);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, text, STDIN_FILENO);
    int error = posix_spawnp(child, argv[0], &actions, &attributes, argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    return error == 0;
}

/* Starts the pager program and opens a pipe to it. If the pager is 'less' and the terminal is too simple for
 * it, nothing is started. Returns true if the pager program is running. */
static bool program_open(struct pager *p)
{
    const char *term = getenv("TERM"), *command = getenv("PAGER");
    int ends[2];
    command = command && *command ? command : NULL;
    if (!p->may_run || (!command && !(term && *term && strcmp(term, "dumb") != 0)) ||
        tcgetattr(STDIN_FILENO, &p->modes) != 0 || pipe(ends) != 0)
        return false;
    /* the pager program needs only its standard input, which is a copy of ends[0] */
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    bool is_started = program_start(command, ends[0], &p->child);
    close(ends[0]);
    fcntl(ends[1], F_SETFL, O_NONBLOCK);
    FILE *to = io_stream(ends[1], "w", p->interrupt);
    if (!is_started && to)
        fclose(to);
    if (!is_started || !to)
        return false;
    p->to = to;
    sigaction(SIGQUIT, &(struct sigaction){.sa_handler = SIG_IGN}, &p->before[QUIT]);
    sigaction(SIGTSTP, &(struct sigaction){.sa_handler = SIG_DFL}, &p->before[STOP]);
    sigaction(SIGINT, NULL, &p->before[INTERRUPT]);
    return true;
}

/* Closes the pipe and waits until the pager program has ended. If a signal ends the session during this time,
 * the pager program is terminated, too. */
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
    /* If the pager has been killed, it has not restored the terminal modes, so they are restored here. If the
     * session is in the background, however, another job is using the terminal, and its modes must not be
     * changed. */
    if (tcgetpgrp(STDIN_FILENO) == getpgrp())
        tcsetattr(STDIN_FILENO, TCSADRAIN, &p->modes);
    for (int i = 0; i < SIGNALS; i++)
        sigaction(signals[i], &p->before[i], NULL);
}

/* ---- Pages without a program ---- */

/* Asks whether to show another page. The terminal keeps its usual modes, in which a program receives whole
 * lines, so the user has to press Enter. */
static bool page_wanted(const struct pager *p)
{
    char answer[256] = "";
    ssize_t n = 0;
    fputs("-- more -- (Enter: next page; q and Enter: end) ", p->to);
    fflush(p->to);
    if (io_wait(STDIN_FILENO, false, NULL, p->interrupt))
        n = read(STDIN_FILENO, answer, sizeof answer);
    if (n <= 0)
        putc('\n', p->to);
    return n > 0 && *answer != 'q' && *answer != 'Q';
}

/* Writes lines page by page. Returns false if the user does not want another page. */
static bool pages_write(struct pager *p, const char *text, size_t size)
{
    const char *end = text + size;
    for (const char *next; text < end; text = next) {
        next = line_next(text, end);
        int more = line_rows(text, next - 1, p->width);
        if (p->rows > 0 && p->rows + more >= p->height) {
            if (!page_wanted(p))
                return false;
            p->rows = 0;
        }
        fwrite(text, 1, (size_t)(next - text), p->to);
        p->rows += more;
    }
    return true;
}

/* ---- The level ---- */

/* Writes text to its destination. Returns false on failure, usually because the user has quit. */
static bool pass_on(struct pager *p, const char *text, size_t size)
{
    bool is_written = p->state == PAGES ? pages_write(p, text, size) : fwrite(text, 1, size, p->to) == size;
    if (is_written && fflush(p->to) == 0)
        return true;
    if (p->state == PROGRAM)
        program_close(p);
    /* in the state HELD, a failure means that there is no memory */
    p->state = p->state == HELD ? HELD : LEFT;
    return false;
}

/* Begins to show the text that was held back, with a pager if `with_pages` is true. */
static bool show(struct pager *p, bool with_pages)
{
    if (p->to)
        fclose(p->to);
    p->to = p->output.below->out;
    if (with_pages)
        progress_end();
    p->state = !with_pages ? DIRECT : program_open(p) ? PROGRAM : PAGES;
    return pass_on(p, p->text ? p->text : "", p->text_size);
}

static ssize_t pager_write(void *pager, const char *text, size_t size)
{
    struct pager *p = pager;
    double now = terminal_clock();
    bool is_slow = p->begun > 0 && now - p->begun > HOLD_SECONDS;
    p->begun = p->begun > 0 ? p->begun : now;
    errno = EPIPE;
    if (p->state == LEFT || !pass_on(p, text, size))
        return 0;
    if (p->state != HELD)
        return (ssize_t)size;
    long rows = 0;
    for (const char *line = p->text, *end = line + p->text_size, *next; line < end; line = next) {
        next = line_next(line, end);
        rows += line_rows(line, next - 1, p->width);
    }
    bool is_short = !is_slow && (double)rows < p->screens * p->height;
    return is_short || show(p, !is_slow) ? (ssize_t)size : 0;
}

static const char *pager_pop(struct output *o, bool keep)
{
    struct pager *p = (struct pager *)o;
    (void)keep;
    fclose(o->out);
    if (p->state == HELD)
        show(p, false);
    if (p->state == PROGRAM)
        program_close(p);
    /* Messages are shown after the pager has ended. */
    if (o->messages != o->below->messages)
        fclose(o->messages);
    if (p->messages)
        fwrite(p->messages, 1, p->messages_size, o->below->messages);
    free(p->messages);
    free(p->text);
    return p->state == LEFT ? "the pager was closed before the end" : NULL;
}

bool pager_push(struct output **top, double screens, bool may_run, const volatile sig_atomic_t *interrupt)
{
    FILE *terminal = (*top)->out;
    int width, height;
    if (fileno(terminal) != STDOUT_FILENO || !isatty(STDIN_FILENO) ||
        !terminal_size(terminal, &width, &height) || width <= 0 || height <= 0)
        return false;
    struct pager *p = malloc(sizeof *p);
    FILE *out = p ? system_stream(p, "w", (struct system_stream){.write = pager_write}) : NULL;
    if (!out) {
        free(p);
        return false;
    }
    *p = (struct pager){.output = {.kind = OUTPUT_PAGER, .out = out, .pop = pager_pop},
                        .width = width,
                        .height = height,
                        .screens = screens,
                        .may_run = may_run,
                        .interrupt = interrupt};
    p->to = io_memory(&p->text, &p->text_size);
    p->output.messages = io_memory(&p->messages, &p->messages_size);
    setvbuf(out, NULL, _IOLBF, BUFSIZ);
    output_push(top, &p->output);
    if (!p->to)
        show(p, false);
    return true;
}
