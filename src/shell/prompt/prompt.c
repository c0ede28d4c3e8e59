/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The prompt. While Readline reads a line, it catches the signals that end or suspend the program: it
 * restores the terminal, and sends the signal again to the handlers of main.c or of the system. While a
 * command runs, the terminal has its usual modes. */
#include "interpreter/question.h"
#include "io/io.h"
#include "io/terminal.h"
#include "language/text.h"
#include "prompt/input.h"
#include "session/session.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <sys/stat.h>
#include <unistd.h>

#include <readline/history.h>
#include <readline/readline.h>

/* The session for Readline's functions, which pass no context. */
static struct session *prompt_session;

/* ---- The history, which all sessions share; each line is appended to its file before it runs ---- */

/* The number of lines that are kept. A file is shortened when it has twice as many. */
enum { HISTORY_LINES = 2000 };

/* The path of the history file, or "" if no history is kept. */
static char history_file[PATH_MAX];

/* Loads the history. The environment variable DOMINO_HISTORY names the file. If it is not set, the file is
 * $XDG_STATE_HOME/domino/history, or else ~/.local/state/domino/history. If it is empty, or not a regular
 * file, the history ends with the session. */
static void history_load(void)
{
    const char *chosen = getenv("DOMINO_HISTORY"), *state = getenv("XDG_STATE_HOME"), *home = getenv("HOME");
    struct stat status;
    int length = -1;
    using_history();
    stifle_history(HISTORY_LINES);
    if (chosen)
        length = snprintf(history_file, PATH_MAX, "%s", chosen);
    else if (state && *state == '/')
        length = snprintf(history_file, PATH_MAX, "%s/domino/history", state);
    else if (home && *home)
        length = snprintf(history_file, PATH_MAX, "%s/.local/state/domino/history", home);
    if (length < 0 || length >= PATH_MAX || (stat(history_file, &status) == 0 && !S_ISREG(status.st_mode)))
        *history_file = '\0';
    else if (read_history(history_file) == 0 && history_base + history_length > 2 * HISTORY_LINES) {
        char *real = realpath(history_file, NULL); /* a link must stay a link */
        if (real)
            history_truncate_file(real, HISTORY_LINES);
        free(real);
    }
    /* Makes the file and its folders if they are missing. Typed lines are private. */
    for (char *c = *history_file ? strchr(history_file + 1, '/') : NULL; c; c = strchr(c + 1, '/')) {
        *c = '\0';
        mkdir(history_file, 0700);
        *c = '/';
    }
    const int file = *history_file ? open(history_file, O_WRONLY | O_CREAT | O_CLOEXEC, 0600) : -1;
    if (file >= 0)
        close(file);
}

/* Adds a line to the history and to the history file, before the line runs. Blank lines, and lines that
 * repeat the previous line, are not added. If the file cannot be written, reports the error once, and then
 * leaves the file alone. */
static void history_keep(struct session *session, const char *text)
{
    HIST_ENTRY *last = history_length ? history_get(history_base + history_length - 1) : NULL;
    if (!text[strspn(text, " \t\r")] || (last && strcmp(last->line, text) == 0))
        return;
    add_history(text);
    const int reason = *history_file ? append_history(1, history_file) : 0;
    if (reason == 0)
        return;
    session_error(session, "cannot keep the history in '%s': %s", history_file, strerror(reason));
    *history_file = '\0';
}

/* ---- Completion ---- */

static struct {
    char **word;
    size_t count, next;
} candidates;

static void candidate_add(const char *candidate, void *context)
{
    (void)context;
    char **more = realloc(candidates.word, (candidates.count + 1) * sizeof *more);
    if (!more)
        return;
    candidates.word = more;
    candidates.word[candidates.count] = strdup(candidate);
    candidates.count += candidates.word[candidates.count] != NULL;
}

/* Readline calls this function until it returns NULL, the first time with `state` = 0. Readline also frees
 * the candidates. */
static char *candidate_next(const char *text, int state)
{
    (void)text;
    candidates.next = state ? candidates.next : 0;
    return candidates.next < candidates.count ? candidates.word[candidates.next++] : NULL;
}

static char **complete_word(const char *text, int start, int end)
{
    char *line = strndup(rl_line_buffer, (size_t)end);
    (void)start;
    /* If there are no candidates, Readline must not complete the names of files instead. */
    rl_attempted_completion_over = 1;
    candidates.count = 0;
    if (line)
        complete_line(prompt_session, line, !prompt_session->run_context.safe, candidate_add, NULL);
    free(line);
    const char *first = candidates.count ? candidates.word[0] : "";
    /* After the '(' of a function, Readline must not append a blank. */
    rl_completion_suppress_append = *first && first[strlen(first) - 1] == '(';
    return rl_completion_matches(text, candidate_next);
}

/* ---- Keys ---- */

static bool was_empty; /* Nothing had been typed when ^C ended the last line. */
static bool is_drawn;  /* False if the line must be drawn again, because the program was suspended. */

static bool is_raised(void)
{
    return dom_raised(prompt_session->state.scene.compute.interrupt);
}

/* The terminal, opened for non-blocking reads by this program alone; -1 if that failed. */
static int keyboard = -1;

/* Reads a key for Readline. After a signal that interrupts the line, the key is Enter, which ends the line,
 * or ^G if Readline is in the middle of a command of several keys. */
static int key_read(FILE *in)
{
    const unsigned long several = RL_STATE_MULTIKEY | RL_STATE_NUMERICARG | RL_STATE_VIMOTION;
    struct pollfd keys = {.fd = keyboard >= 0 ? keyboard : fileno(in), .events = POLLIN};
    fd_set input;
    for (;;) {
        rl_check_signals();
        if (is_raised()) {
            was_empty = rl_end == 0;
            return RL_ISSTATE(several) ? '\a' : '\n';
        }
        if (!is_drawn)
            rl_forced_update_display();
        is_drawn = true;
        if (poll(&keys, 1, 0) > 0) {
            unsigned char key;
            const ssize_t n = read(keys.fd, &key, 1);
            if (n == 1)
                return key;
            if (n == 0 || (errno != EAGAIN && errno != EINTR))
                return rl_getc(in); /* the end of the input, or an error */
            continue;               /* ^C has just discarded the keys; a blocking read would wait for more */
        }
        FD_ZERO(&input);
        FD_SET(keys.fd, &input);
        /* If a signal arrives after the check, it stays blocked until pselect is called. */
        sigset_t before = io_block();
        if (!rl_pending_signal() && !is_raised())
            pselect(keys.fd + 1, &input, NULL, NULL, NULL, &before);
        io_unblock(&before);
    }
}

/* Readline sets the terminal modes when it begins to read a line, and again after ^Z and 'fg', at whatever
 * moment the signal came. It draws the line only at the beginning. */
static void modes_set(int meta)
{
    rl_prep_terminal(meta);
    is_drawn = false;
}

static int line_begin(void)
{
    is_drawn = true;
    return 0;
}

static void readline_begin(void)
{
    static bool has_begun;
    if (has_begun)
        return;
    has_begun = true;
    rl_readline_name = "Domino"; /* the name that $if tests in an inputrc */
    rl_getc_function = key_read;
    rl_prep_term_function = modes_set;
    rl_startup_hook = line_begin;
    const char *terminal = ttyname(STDIN_FILENO);
    keyboard = terminal ? open(terminal, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY) : -1;
    rl_attempted_completion_function = complete_word;
    rl_completer_word_break_characters = " \t;";
    rl_completer_quote_characters = "\"";
    rl_filename_quote_characters = " \t;#>\"";
    rl_variable_bind("enable-bracketed-paste", "on");
    rl_completion_query_items = 0; /* a list of all commands fits on a screen */
    rl_initialize(); /* line_read asks for the size of the terminal, which this function finds out */
}

/* Reads a line. If the session is interrupted, the line has what was typed before. */
static char *line_read(struct session *session, const char *prompt)
{
    struct session *outer = prompt_session;
    prompt_session = session;
    readline_begin();
    rl_reset_screen_size();
    fflush(session->output->out);
    char *line = readline(prompt);
    prompt_session = outer;
    return line;
}

char *line_edit(struct session *session, const char *prompt)
{
    char *line = line_read(session, prompt);
    if (line && dom_raised(session->state.scene.compute.interrupt))
        *line = '\0';
    if (line)
        history_keep(session, line);
    return line;
}

/* ---- Lines ---- */

/* Runs a typed line, or the lines of a pasted text. */
static void lines_run(struct session *session, char *text)
{
    const bool is_pasted = strchr(text, '\n') != NULL;
    for (char *line; (line = strsep(&text, "\n")) != NULL && !is_raised() && !session->quit;) {
        session->is_last = !is_pasted;
        history_keep(session, line);
        command_run_text(session, line);
    }
}

static void greet(FILE *out)
{
    const struct first_line *first;
    const char *before = "Try";
    fputs("domino " DOM_VERSION ": how far can a domino row grow? ", out);
    for (int place = 1; (first = first_line_at(place)) != NULL; place = first->place + 1)
        if (first->greets) {
            fprintf(out, "%s '%s'", before, first->line);
            before = ",";
        }
    fputs(" or 'help'.\n", out);
}

void line_prompt(struct session *session, volatile sig_atomic_t *raised)
{
    const char *prompt = terminal_utf8() ? "domino❯ " : "domino> ";
    prompt_session = session;
    session->source.name = NULL;
    session->source.prompt_width = utf8_columns(prompt);
    history_load();
    greet(session->output->out);
    while (!session->quit && (*raised == 0 || *raised == SIGINT)) {
        const sigset_t before = io_block(); /* discards a ^C, but no signal that ends the session */
        if (*raised == SIGINT)
            *raised = 0;
        io_unblock(&before);
        char *line = line_read(session, prompt);
        if (*raised) { /* ^C discards what was typed */
            fputs(was_empty ? "'quit' or ^D leaves\n" : "", rl_outstream);
            fflush(rl_outstream);
        } else if (line)
            lines_run(session, line);
        else {
            putc('\n', session->output->out);
            session->quit = true;
        }
        free(line);
    }
    session->source.prompt_width = 0;
}
