/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "line.h"
#include "command.h"
#include "complete.h"
#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <unistd.h>

#include <readline/history.h>
#include <readline/readline.h>

/* ---- A stream ---- */

void line_stream(struct session *session, FILE *in, const char *name)
{
    char *text = NULL;
    size_t size = 0;
    ssize_t length;
    session->source = name;
    session->line = 0;
    errno = 0;
    while (!session->quit && (length = getline(&text, &size, in)) != -1) {
        long errors = session->errors;
        session->line++;
        if (length > 0 && text[length - 1] == '\n')
            text[--length] = '\0';
        if (strlen(text) != (size_t)length)
            session_error(session, "the line has a NUL byte; commands are text");
        else
            command_run_text(session, text);
        if ((session->bail && session->errors > errors) || ferror(session->out))
            break;
        errno = 0;
    }
    if (ferror(in) || errno == ENOMEM)
        session_error(session, "cannot read on: %s", strerror(errno));
    free(text);
}

/* ---- A terminal: Readline's callback interface under pselect, so that no signal is missed ---- */

/* Set by the handlers; `interrupted` also stops a computation. */
static volatile sig_atomic_t interrupted, resized, suspended, ended;

static void on_signal(int number)
{
    if (number == SIGINT)
        interrupted = 1;
    else if (number == SIGWINCH)
        resized = 1;
    else if (number == SIGTSTP)
        suspended = 1;
    else
        ended = 1;
}

static const int watched[] = {SIGINT, SIGWINCH, SIGTSTP, SIGTERM, SIGHUP};
enum { WATCHED = sizeof watched / sizeof *watched };

static const char prompt[] = "domino> ";

/* Readline's handler takes no context. */
static struct session *prompt_session;

static void on_line(char *text)
{
    struct session *session = prompt_session;
    if (!text) {
        putc('\n', session->out);
        session->quit = true;
    } else {
        if (text[strspn(text, " \t")])
            add_history(text);
        interrupted = 0;
        command_run_text(session, text);
        free(text);
        interrupted = 0;
        fflush(session->out);
    }
    if (session->quit)
        rl_callback_handler_remove();
}

/* ^C drops the line; on an empty line it says how to leave. */
static void prompt_interrupt(void)
{
    interrupted = 0;
    bool empty = rl_end == 0;
    rl_free_line_state();
    rl_callback_sigcleanup();
    fputs("^C\n", rl_outstream);
    if (empty)
        fputs("'quit' or ^D leaves\n", rl_outstream);
    rl_replace_line("", 1);
    rl_on_new_line();
    rl_redisplay();
}

static void prompt_suspend(const sigset_t *awake)
{
    struct sigaction action = {.sa_handler = SIG_DFL}, ours;
    sigset_t blocked;
    suspended = 0;
    rl_deprep_terminal();
    sigaction(SIGTSTP, &action, &ours);
    raise(SIGTSTP);
    sigprocmask(SIG_SETMASK, awake, &blocked); /* here it stops, until SIGCONT */
    sigprocmask(SIG_SETMASK, &blocked, NULL);
    sigaction(SIGTSTP, &ours, NULL);
    rl_prep_terminal(1);
    rl_forced_update_display();
}

void line_prompt(struct session *session)
{
    struct sigaction action = {.sa_handler = on_signal}, before[WATCHED];
    sigset_t blocked, awake;
    sigemptyset(&blocked);
    for (int i = 0; i < WATCHED; i++) {
        sigaddset(&blocked, watched[i]);
        sigaction(watched[i], &action, &before[i]);
    }
    prompt_session = session;
    session->source = NULL;
    session->train.interrupt = &interrupted;
    rl_readline_name = "Domino";
    rl_catch_signals = 0;
    rl_catch_sigwinch = 0;
    rl_attempted_completion_function = complete_word;
    fprintf(session->out,
            "domino " DOM_VERSION ": how far can a domino train grow?  'help' lists the commands, "
            "try 'count 112'.\n");
    fflush(session->out);
    rl_callback_handler_install(prompt, on_line);

    sigprocmask(SIG_BLOCK, &blocked, &awake);
    while (!session->quit && !ended) {
        fd_set input;
        FD_ZERO(&input);
        FD_SET(STDIN_FILENO, &input);
        int ready = pselect(STDIN_FILENO + 1, &input, NULL, NULL, NULL, &awake);
        if (interrupted)
            prompt_interrupt();
        if (resized) {
            resized = 0;
            rl_resize_terminal();
        }
        if (suspended)
            prompt_suspend(&awake);
        if (ready > 0) {
            sigprocmask(SIG_SETMASK, &awake, NULL); /* ^C must reach a computation */
            rl_callback_read_char();
            sigprocmask(SIG_BLOCK, &blocked, NULL);
        } else if (ready < 0 && errno != EINTR) {
            session_error(session, "cannot read the terminal: %s", strerror(errno));
            break;
        }
    }
    rl_callback_handler_remove();
    session->train.interrupt = NULL;
    for (int i = 0; i < WATCHED; i++)
        sigaction(watched[i], &before[i], NULL);
    sigprocmask(SIG_SETMASK, &awake, NULL);
}
