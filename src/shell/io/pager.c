/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/pager.h"
#include "domino_quad.h"
#include "io/io.h"
#include "io/terminal.h"
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

/* A text that comes more slowly than this is read while it comes. */
#define HOLD_SECONDS 0.5

/* Signals of the terminal while the program runs: as system(3) does, but ^Z stops both programs, and ^C stops
 * what is still being computed. */
static const struct {
    int number;
    void (*handler)(int);
} during[] = {{SIGQUIT, SIG_IGN}, {SIGTSTP, SIG_DFL}, {SIGINT, SIG_IGN}};
enum { DURING = sizeof during / sizeof *during };

struct pager {
    FILE *out, *stream;
    enum { HELD, DIRECT, PROGRAM, PAGES, LEFT } state;
    char *text; /* what is held */
    size_t size, room;
    double begun; /* when the first of it came; 0: nothing has */
    int width, height, rows;
    bool programs;
    const volatile sig_atomic_t *interrupt;
    pid_t child;
    int pipe;
    struct sigaction before[DURING];
    struct termios modes;
    bool known; /* the modes are */
};

/* Messages that wait until the text is read. */
static FILE *messages;
static char *messages_text;
static size_t messages_size;

FILE *pager_messages(void)
{
    return messages ? messages : stderr;
}

/* Returns how many rows of the terminal a line takes; what colours it takes none. */
static int line_rows(const char *line, const char *end, int width)
{
    int columns = 0;
    while (line < end) {
        if (*line == '\033')
            line += strcspn(line, "m");
        else
            columns += ((unsigned char)*line & 0xc0) != 0x80;
        line++;
    }
    return width > 0 && columns > width ? (columns + width - 1) / width : 1;
}

/* Returns the end of a line, after its '\n'. */
static const char *line_end(const char *line, const char *end)
{
    const char *last = memchr(line, '\n', (size_t)(end - line));
    return last ? last + 1 : end;
}

static long text_rows(const char *text, const char *end, int width)
{
    long rows = 0;
    for (const char *next; text < end; text = next) {
        next = line_end(text, end);
        rows += line_rows(text, next - 1, width);
    }
    return rows;
}

/* ---- A program ---- */

/* Starts the program, which reads the text from the file.  Returns an error number, or 0. */
static int program_start(int text, pid_t *child)
{
    extern char **environ;
    char *pager = getenv("PAGER");
    /* A program that does not exist loses no text. */
    static char shown[] =
        "set -- $PAGER; command -v \"$1\" >/dev/null || PAGER='less || cat'; eval \"$PAGER\"";
    char *const own[] = {"sh", "-c", shown, NULL}, *const less[] = {"less", "-FRX", NULL};
    char *const *argv = pager && *pager ? own : less;
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    sigset_t back;
    sigemptyset(&back);
    sigaddset(&back, SIGPIPE);
    sigaddset(&back, SIGXFSZ);
    for (int i = 0; i < DURING; i++)
        sigaddset(&back, during[i].number);
    if (setenv("LESS", "FRX", 0) != 0)
        return errno;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigdefault(&attributes, &back);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, text, STDIN_FILENO);
    int failed = posix_spawnp(child, argv[0], &actions, &attributes, argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    return failed;
}

/* Opens a pipe to the program; returns false if there is none. */
static bool program_open(struct pager *p)
{
    const char *term = getenv("TERM"), *pager = getenv("PAGER");
    int ends[2];
    if (!p->programs || (!(pager && *pager) && !(term && *term && strcmp(term, "dumb") != 0)) ||
        pipe2(ends, O_CLOEXEC) != 0)
        return false;
    fflush(p->out);
    ticker_stop();
    for (int i = 0; i < DURING; i++)
        sigaction(during[i].number, NULL, &p->before[i]);
    for (int i = 0; i < DURING; i++)
        if (during[i].number != SIGINT)
            sigaction(during[i].number, &(struct sigaction){.sa_handler = during[i].handler}, NULL);
    p->known = tcgetattr(STDIN_FILENO, &p->modes) == 0;
    int wrong = program_start(ends[0], &p->child);
    close(ends[0]);
    p->pipe = ends[1];
    fcntl(p->pipe, F_SETFL, O_NONBLOCK);
    if (wrong) {
        close(p->pipe);
        for (int i = 0; i < DURING; i++)
            sigaction(during[i].number, &p->before[i], NULL);
    }
    return wrong == 0;
}

/* Writes to the program; returns false if it has ended, or after an interrupt. */
static bool program_write(const struct pager *p, const char *text, size_t size)
{
    while (size > 0) {
        ssize_t n = write(p->pipe, text, size);
        if (n < 0 && errno == EAGAIN && !io_wait(p->pipe, POLLOUT, NULL, p->interrupt))
            return false;
        if (n < 0 && errno != EAGAIN && errno != EINTR)
            return false;
        text += n > 0 ? n : 0;
        size -= n > 0 ? (size_t)n : 0;
    }
    return true;
}

/* Waits for the end of the program; a signal that ends the session ends the program, too. */
static void program_close(struct pager *p)
{
    const struct timespec moment = {.tv_nsec = 20000000};
    int status = 0;
    pid_t ended;
    close(p->pipe);
    sigaction(SIGINT, &(struct sigaction){.sa_handler = SIG_IGN}, NULL);
    while ((ended = waitpid(p->child, &status, WNOHANG)) == 0 || (ended < 0 && errno == EINTR)) {
        if (dom_raised(p->interrupt) && *p->interrupt != SIGINT)
            kill(p->child, SIGTERM);
        nanosleep(&moment, NULL);
    }
    /* A program that was killed leaves its own modes; in the background they are another job's. */
    if (p->known && tcgetpgrp(STDIN_FILENO) == getpgrp())
        tcsetattr(STDIN_FILENO, TCSADRAIN, &p->modes);
    for (int i = 0; i < DURING; i++)
        sigaction(during[i].number, &p->before[i], NULL);
}

/* ---- Without a program ---- */

/* Asks for the next page; returns false if there is to be none.  The terminal keeps its modes. */
static bool next_page(FILE *out, const volatile sig_atomic_t *interrupt)
{
    char answer[256] = "";
    ssize_t n = 0;
    fputs("-- more -- (Enter: next page; q, Enter: end) ", out);
    fflush(out);
    if (io_wait(STDIN_FILENO, POLLIN, NULL, interrupt))
        n = read(STDIN_FILENO, answer, sizeof answer);
    if (n <= 0)
        putc('\n', out);
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
            if (!next_page(p->out, p->interrupt))
                return false;
            p->rows = 0;
        }
        fwrite(text, 1, (size_t)(next - text), p->out);
        p->rows += more;
    }
    fflush(p->out);
    return true;
}

/* ---- The stream ---- */

static bool hold(struct pager *p, const char *text, size_t size)
{
    if (p->size + size > p->room) {
        size_t room = 2 * (p->size + size);
        char *more = realloc(p->text, room);
        if (!more)
            return false;
        p->text = more;
        p->room = room;
    }
    memcpy(p->text + p->size, text, size);
    p->size += size;
    return true;
}

/* Passes a piece on in the state of the pager. */
static bool pass(struct pager *p, const char *text, size_t size)
{
    bool done = p->state == PROGRAM ? program_write(p, text, size)
                : p->state == PAGES ? pages_write(p, text, size)
                                    : fwrite(text, 1, size, p->out) == size && fflush(p->out) == 0;
    if (done)
        return true;
    if (p->state == PROGRAM)
        program_close(p);
    p->state = LEFT;
    return false;
}

static ssize_t stream_write(void *pager, const char *text, size_t size)
{
    struct pager *p = pager;
    errno = EPIPE;
    if (p->state == LEFT)
        return 0;
    if (p->state != HELD)
        return pass(p, text, size) ? (ssize_t)size : 0;
    double now = terminal_clock();
    bool slow = p->begun > 0 && now - p->begun > HOLD_SECONDS;
    p->begun = p->begun > 0 ? p->begun : now;
    if (!hold(p, text, size))
        return 0;
    if (slow)
        p->state = DIRECT;
    else if (text_rows(p->text, p->text + p->size, p->width) >= p->height)
        p->state = program_open(p) ? PROGRAM : PAGES;
    return p->state == HELD || pass(p, p->text, p->size) ? (ssize_t)size : 0;
}

FILE *pager_begin(struct pager **pager, FILE *out, bool programs, const volatile sig_atomic_t *interrupt)
{
    int width, height;
    *pager = NULL;
    if (fileno(out) != STDOUT_FILENO || !isatty(STDIN_FILENO) || !terminal_size(out, &width, &height) ||
        width <= 0 || height <= 0)
        return out;
    struct pager *p = malloc(sizeof *p);
    if (!p)
        return out;
    *p = (struct pager){
        .out = out, .width = width, .height = height, .programs = programs, .interrupt = interrupt};
    p->stream = fopencookie(p, "w", (cookie_io_functions_t){.write = stream_write});
    if (!p->stream) {
        free(p);
        return out;
    }
    setvbuf(p->stream, NULL, _IOLBF, BUFSIZ);
    terminal_lend(p->stream, out);
    messages = io_memory(&messages_text, &messages_size);
    *pager = p;
    return p->stream;
}

void pager_end(struct pager *p)
{
    if (!p)
        return;
    terminal_lend(NULL, NULL);
    fclose(p->stream);
    if (p->state == HELD)
        fwrite(p->text ? p->text : "", 1, p->size, p->out);
    if (p->state == PROGRAM)
        program_close(p);
    free(p->text);
    free(p);
    if (!messages)
        return;
    fclose(messages);
    messages = NULL;
    if (messages_text)
        fwrite(messages_text, 1, messages_size, stderr);
    free(messages_text);
    messages_text = NULL;
}
