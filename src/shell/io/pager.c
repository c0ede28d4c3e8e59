/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/pager.h"
#include "domino_quad.h"
#include "io/io.h"
#include "io/terminal.h"
#include <errno.h>
#include <poll.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

FILE *pager_begin(struct pager *p, FILE *out)
{
    int width, height;
    *p = (struct pager){.out = out};
    if (fileno(out) == STDOUT_FILENO && isatty(STDIN_FILENO) && terminal_size(out, &width, &height) &&
        width > 0 && height > 0)
        p->memory = io_memory(&p->text, &p->size);
    if (p->memory)
        terminal_lend(p->memory, out);
    return p->memory ? p->memory : out;
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
    return columns > width ? (columns + width - 1) / width : 1;
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

/* Signals of the terminal while the program runs: as system(3) does, but ^Z stops both programs. */
static const struct {
    int number;
    void (*handler)(int);
} during[] = {{SIGINT, SIG_IGN}, {SIGQUIT, SIG_IGN}, {SIGTSTP, SIG_DFL}};
enum { DURING = sizeof during / sizeof *during };

/* Starts the program, which reads the text from the file.  Returns an error number, or 0. */
static int program_start(FILE *text, pid_t *child)
{
    extern char **environ;
    char *pager = getenv("PAGER");
    char *const own[] = {"sh", "-c", pager, NULL}, *const less[] = {"less", "-FRX", NULL};
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
    posix_spawn_file_actions_adddup2(&actions, fileno(text), STDIN_FILENO);
    int failed = posix_spawnp(child, argv[0], &actions, &attributes, argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    return failed;
}

/* Waits for the end of the program; a signal that ends the session ends the program, too. */
static int program_wait(pid_t child, const volatile sig_atomic_t *interrupt)
{
    enum { NOT_FOUND = 127 };
    const struct timespec moment = {.tv_nsec = 20000000};
    int status = 0;
    pid_t ended;
    while ((ended = waitpid(child, &status, WNOHANG)) == 0 || (ended < 0 && errno == EINTR)) {
        if (dom_raised(interrupt))
            kill(child, SIGTERM);
        nanosleep(&moment, NULL);
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == NOT_FOUND ? ENOENT : 0;
}

/* Runs the program with the text; returns false if there is none. */
static bool program_shows(const struct pager *p, const volatile sig_atomic_t *interrupt)
{
    const char *term = getenv("TERM"), *pager = getenv("PAGER");
    if (!(pager && *pager) && !(term && *term && strcmp(term, "dumb") != 0))
        return false;
    struct sigaction before[DURING];
    struct termios modes;
    pid_t child = -1;
    FILE *text = tmpfile();
    bool whole = text && fwrite(p->text, 1, p->size, text) == p->size && fflush(text) == 0, known = false;
    int wrong = ENOENT;
    if (whole) {
        lseek(fileno(text), 0, SEEK_SET);
        fflush(p->out);
        for (int i = 0; i < DURING; i++)
            sigaction(during[i].number, &(struct sigaction){.sa_handler = during[i].handler}, &before[i]);
        known = tcgetattr(STDIN_FILENO, &modes) == 0;
        wrong = program_start(text, &child);
        wrong = wrong ? wrong : program_wait(child, interrupt);
        /* A program that was killed leaves its own modes; in the background they are another job's. */
        if (known && tcgetpgrp(STDIN_FILENO) == getpgrp())
            tcsetattr(STDIN_FILENO, TCSADRAIN, &modes);
        for (int i = 0; i < DURING; i++)
            sigaction(during[i].number, &before[i], NULL);
    }
    if (text)
        fclose(text);
    return wrong == 0;
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

static void pages_show(const struct pager *p, int width, int height, const volatile sig_atomic_t *interrupt)
{
    const char *end = p->text + p->size;
    int rows = 0;
    for (const char *line = p->text, *next; line < end; line = next) {
        next = line_end(line, end);
        int more = line_rows(line, next - 1, width);
        if (rows > 0 && rows + more >= height) {
            if (!next_page(p->out, interrupt))
                return;
            rows = 0;
        }
        fwrite(line, 1, (size_t)(next - line), p->out);
        rows += more;
    }
}

void pager_end(struct pager *p, bool programs, const volatile sig_atomic_t *interrupt)
{
    int width, height;
    if (!p->memory)
        return;
    terminal_lend(NULL, NULL);
    fclose(p->memory);
    ticker_stop();
    bool fits = !terminal_size(p->out, &width, &height) || width == 0 ||
                text_rows(p->text, p->text + p->size, width) < height || dom_raised(interrupt);
    if (p->text && fits)
        fwrite(p->text, 1, p->size, p->out);
    else if (p->text && !(programs && program_shows(p, interrupt)))
        pages_show(p, width, height, interrupt);
    free(p->text);
}
