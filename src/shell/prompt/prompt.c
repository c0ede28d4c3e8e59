/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The prompt. Readline runs through its callback interface, and pselect waits for a key. Signals are blocked,
 * except in pselect and while Readline handles a key, which may run a command. So no signal is missed between
 * the checks of the flags and pselect. */
#define _GNU_SOURCE /* asprintf */
#include "interpreter/command.h"
#include "interpreter/interpret.h"
#include "io/terminal.h"
#include "language/text.h"
#include "prompt/input.h"
#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <unistd.h>

#include <readline/readline.h>

/* ---- Signals ---- */

/* The signal handler sets these flags. While a command runs, its threads check the flag `interrupted` in
 * dom_raised. */
static volatile sig_atomic_t interrupted, resized, suspended, ended;

static void on_signal(int number)
{
    if (number != SIGWINCH && number != SIGTSTP)
        __atomic_store_n(&interrupted, number, __ATOMIC_RELAXED);
    if (number == SIGWINCH)
        resized = 1;
    else if (number == SIGTSTP)
        suspended = 1;
    else if (number != SIGINT)
        ended = number;
}

/* The signals that are caught. Before a signal ends the program, the prompt ends and restores the mode of the
 * terminal. */
static const int watched[] = {SIGINT,  SIGWINCH, SIGTSTP, SIGTERM,   SIGHUP,  SIGQUIT, SIGALRM,
                              SIGUSR1, SIGUSR2,  SIGXCPU, SIGVTALRM, SIGPROF, SIGIO,   SIGPWR};
enum { WATCHED = sizeof watched / sizeof *watched };

/* The lines typed so far of a command that continues on the next line after a backslash. NULL if there is no
 * such command. */
static char *unfinished;

static bool is_joined;    /* The running command was typed on several lines. */
static bool has_warned;   /* The user has been warned that unsaved changes will be lost. */
static bool is_installed; /* Readline calls on_line for each line. */

static const char *prompt_text(struct session *session, char *text, size_t size);
static void prompt_set(struct session *session);

/* Handles ^C at the prompt. If the user has typed something, discards it. If the line is empty, prints how to
 * leave the program. */
static void prompt_interrupt(void)
{
    interrupted = 0;
    bool empty = rl_end == 0 && !unfinished;
    rl_free_line_state();
    rl_callback_sigcleanup();
    fputs("^C\n", rl_outstream);
    if (empty)
        fputs("'quit' or ^D leaves\n", rl_outstream);
    rl_replace_line("", 1);
    rl_on_new_line();
    if (unfinished) {
        free(unfinished);
        unfinished = NULL;
        prompt_set(prompt_session);
    }
    rl_redisplay();
}

static void prompt_suspend(const sigset_t *awake)
{
    struct sigaction action = {.sa_handler = SIG_DFL}, ours;
    sigset_t blocked;
    suspended = 0;
    /* This call may raise SIGTTOU, which is ignored, because SIGTTOU would stop the program a second time. */
    rl_deprep_terminal();
    sigaction(SIGTSTP, &action, &ours);
    raise(SIGTSTP);
    sigprocmask(SIG_SETMASK, awake, &blocked); /* The program stops here until SIGCONT. */
    sigprocmask(SIG_SETMASK, &blocked, NULL);
    sigaction(SIGTSTP, &ours, NULL);
    rl_prep_terminal(1);
    rl_forced_update_display();
}

/* ---- Lines ---- */

/* Adds a typed line to the unfinished command, if there is one. Returns the whole command. If the line ends
 * with a backslash, the command is not complete yet, and the function returns NULL. The caller frees the
 * command. */
static char *line_whole(struct session *session, char *line)
{
    bool before = is_joined = unfinished != NULL, goes_on = text_continues(line);
    char *whole = NULL;
    if (asprintf(&whole, "%s%s", before ? unfinished : "", line) < 0)
        whole = NULL;
    free(unfinished);
    unfinished = goes_on ? whole : NULL;
    if (before || unfinished)
        prompt_set(session);
    return goes_on ? NULL : whole;
}

/* Warns of unsaved changes to the row and keeps the session open. A second attempt to leave succeeds. */
static void leave_warn(struct session *session)
{
    if (has_warned || !row_unsaved(&session->state.scene))
        return;
    has_warned = true;
    session->quit = false;
    session_note(session, "the changes to the row are not saved; 'save FILE' or 'row > FILE.csv' saves them; "
                          "to leave without saving, enter 'quit' or press ^D once more");
}

/* ^Z stops a computation at once: the terminal has its usual modes while a line runs. */
static void line_run(struct session *session, const char *line)
{
    struct sigaction stop = {.sa_handler = SIG_DFL}, ours;
    history_keep(session, line);
    sigaction(SIGTSTP, &stop, &ours);
    command_run_text(session, line);
    sigaction(SIGTSTP, &ours, NULL);
}

/* Runs a typed line, or the lines of a pasted text. A pasted text with the line ends of other systems has an
 * empty line after each line, which does not end an unfinished command. */
static void lines_run(struct session *session, char *text)
{
    const bool is_pasted = strchr(text, '\n') != NULL;
    /* An earlier ^C must not interrupt this line, but a signal that ends the session must. */
    interrupted = ended;
    for (char *line; (line = strsep(&text, "\n")) != NULL && !interrupted && !session->quit;) {
        bool is_blank = *skip_blanks(line) == '\0';
        char *whole = is_pasted && is_blank ? NULL : line_whole(session, line);
        session->typed.is_last = !is_joined && !is_pasted;
        if (whole)
            line_run(session, whole);
        free(whole);
    }
    interrupted = 0;
}

static void on_line(char *text)
{
    struct session *session = prompt_session;
    char prompt[64];
    if (!text) {
        putc('\n', session->output->out);
        session->quit = true;
    } else
        lines_run(session, text);
    if (session->quit)
        leave_warn(session);
    else
        has_warned = false;
    free(text);
    fflush(session->output->out);
    if (session->quit)
        rl_callback_handler_remove();
    else if (!is_installed) {
        is_installed = true;
        rl_callback_handler_install(prompt_text(session, prompt, sizeof prompt), on_line);
    }
}

/* Readline expects \001 and \002 around bytes that take no space on the screen. */
static const char *prompt_text(struct session *session, char *text, size_t size)
{
    const char *mark = terminal_utf8() ? "❯" : ">";
    if (unfinished) {
        /* The width 0 turns off the caret of error messages, because a caret cannot point into a command
         * that spans several lines. */
        session->source.prompt_width = 0;
        snprintf(text, size, "  ...%s ", mark);
        return text;
    }
    bool colour = terminal_colour(session->output->out);
    snprintf(text, size, colour ? "\001\033[1m\002domino%s\001\033[m\002 " : "domino%s ", mark);
    session->source.prompt_width = (int)strlen("domino> ");
    return text;
}

static void prompt_set(struct session *session)
{
    char text[64];
    rl_set_prompt(prompt_text(session, text, sizeof text));
}

static void readline_begin(void)
{
    static bool has_begun;
    if (has_begun)
        return;
    has_begun = true;
    rl_readline_name = "Domino"; /* the name that $if tests in an inputrc */
    rl_catch_signals = 0;
    rl_catch_sigwinch = 0;
    rl_attempted_completion_function = complete_word;
    rl_completer_word_break_characters = " \t;";
    rl_completer_quote_characters = "\"";
    rl_filename_quote_characters = " \t;#>\"";
    rl_filename_quoting_function = complete_quote;
    rl_variable_bind("enable-bracketed-paste", "on");
    /* rl_initialize binds the keys of the inputrc, which overlay_begin may rebind. */
    rl_initialize();
    overlay_begin();
}

struct signals {
    struct sigaction before[WATCHED], ttou; /* the actions of the signals before the prompt began */
    sigset_t blocked;                       /* the watched signals */
    sigset_t awake; /* the signal mask while the prompt waits for a key, or handles a key */
};

static void signals_begin(struct signals *s)
{
    /* Without SA_RESTART, ^C could make a write fail, and set the stream's error indicator. */
    const struct sigaction action = {.sa_handler = on_signal, .sa_flags = SA_RESTART},
                           ignore = {.sa_handler = SIG_IGN};
    sigemptyset(&s->blocked);
    for (int i = 0; i < WATCHED; i++) {
        sigaddset(&s->blocked, watched[i]);
        sigaction(watched[i], &action, &s->before[i]);
    }
    sigaction(SIGTTOU, &ignore, &s->ttou);
}

static void signals_end(const struct signals *s)
{
    for (int i = 0; i < WATCHED; i++)
        sigaction(watched[i], &s->before[i], NULL);
    sigaction(SIGTTOU, &s->ttou, NULL);
    sigprocmask(SIG_SETMASK, &s->awake, NULL);
}

/* Returns false if the terminal cannot be read. */
static bool key_read(struct session *session, const struct signals *s)
{
    fd_set input;
    FD_ZERO(&input);
    FD_SET(STDIN_FILENO, &input);
    overlay_show(session);
    int ready = pselect(STDIN_FILENO + 1, &input, NULL, NULL, NULL, &s->awake);
    overlay_remove();
    if (ready < 0 && errno != EINTR) {
        session_error(session, "cannot read the terminal: %s", strerror(errno));
        return false;
    }
    if (ready > 0) {
        /* ^C must be able to interrupt a computation that the key starts. */
        sigprocmask(SIG_SETMASK, &s->awake, NULL);
        rl_callback_read_char();
        sigprocmask(SIG_BLOCK, &s->blocked, NULL);
    }
    return true;
}

void line_prompt(struct session *session)
{
    struct signals signals;
    char prompt[64];
    signals_begin(&signals);
    prompt_session = session;
    session->source.name = NULL;
    session->state.scene.compute.interrupt = &interrupted;
    history_load(session);
    readline_begin();
    fprintf(session->output->out,
            "domino " DOM_VERSION ": how far can a domino row grow? Try 'count 112', 'lesson' or 'help'.\n");
    fflush(session->output->out);
    is_installed = true;
    rl_callback_handler_install(prompt_text(session, prompt, sizeof prompt), on_line);
    sigprocmask(SIG_BLOCK, &signals.blocked, &signals.awake);
    for (bool is_open = true; is_open && !session->quit && !ended; is_open = key_read(session, &signals)) {
        /* Signals that arrived while a line ran are handled before the next key. */
        if (interrupted)
            prompt_interrupt();
        if (resized) {
            resized = 0;
            rl_resize_terminal();
        }
        if (suspended)
            prompt_suspend(&signals.awake);
    }
    rl_callback_handler_remove();
    is_installed = false;
    free(unfinished);
    unfinished = NULL;
    session->state.scene.compute.interrupt = NULL;
    session->source.prompt_width = 0;
    signals_end(&signals);
    if (ended) {
        fflush(session->output->out);
        /* The terminal has been restored, so the signal may now end the program. */
        raise(ended);
    }
}

/* ---- A line of a lesson ---- */

/* Readline calls this function ten times a second while it waits for a key. */
static int edit_watch(void)
{
    if (dom_raised(prompt_session->state.scene.compute.interrupt)) {
        rl_replace_line("", 1);
        rl_done = 1;
    }
    return 0;
}

char *line_edit(struct session *session, const char *prompt)
{
    struct session *outer = prompt_session;
    if (is_installed)
        rl_callback_handler_remove();
    readline_begin();
    is_installed = false;
    prompt_session = session;
    fflush(session->output->out);
    rl_event_hook = edit_watch;
    rl_catch_signals = rl_catch_sigwinch =
        1; /* Readline restores the terminal, and then calls our handlers */
    char *line = readline(prompt);
    rl_catch_signals = rl_catch_sigwinch = 0;
    rl_event_hook = NULL;
    prompt_session = outer;
    if (line)
        history_keep(session, line);
    return line;
}
