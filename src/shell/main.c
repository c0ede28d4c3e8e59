/* SPDX-License-Identifier: GPL-3.0-or-later */
/* domino: an interactive calculator for domino trains that grow. */
#include "commands/tables.h"
#include "interpreter/interpret.h"
#include "io/io.h"
#include "prompt/input.h"
#include <errno.h>
#include <getopt.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { EXIT_USAGE = 2 };

static const char usage[] = "usage: domino [-n] [--bail | --keep-going] [--safe] [--interruptible]\n"
                            "              [--shard I/N] [-e COMMANDS | -f FILE | FILE] ...\n";

static const char help[] =
    "\n"
    "Calculates how far a row of dominoes, each r times larger than the one before, can grow.\n"
    "Without -e, -f or FILE it reads commands from standard input: at a prompt on a terminal,\n"
    "else one command a line.  -e, -f and FILE stop at the first error; standard input goes on.\n"
    "\n"
    "  -e, --execute COMMANDS  run these commands, ';' between them\n"
    "  -f, --file FILE         run the commands in FILE ('-' is standard input)\n"
    "  -n, --no-init           do not run the start-up file, $XDG_CONFIG_HOME/domino/init.dom\n"
    "      --bail              stop at the first error, also on standard input\n"
    "      --keep-going        go on after errors, also in -e, -f and FILE\n"
    "      --safe              commands may not read or write files\n"
    "      --interruptible     SIGINT ends the command that runs, not the program\n"
    "      --shard I/N         of a curve, sweep or placement compute the part I of N\n"
    "  -h, --help              print this help\n"
    "  -V, --version           print the version\n"
    "\n"
    "Exit status: 0, 1 after an error in a command, 2 for wrong options.\n"
    "The command 'help' lists the commands: domino -e help\n";

static const struct option options[] = {
    {"execute", required_argument, NULL, 'e'},
    {"file", required_argument, NULL, 'f'},
    {"no-init", no_argument, NULL, 'n'},
    {"bail", no_argument, NULL, 'b'},
    {"keep-going", no_argument, NULL, 'k'},
    {"safe", no_argument, NULL, 's'},
    {"help", no_argument, NULL, 'h'},
    {"version", no_argument, NULL, 'V'},
    {"shard", required_argument, NULL, 'p'},
    {"interruptible", no_argument, NULL, 'i'},
    {NULL, 0, NULL, 0},
};

/* '-': a FILE counts in its place among the options. */
static const char short_options[] = "-e:f:nhV";

/* What the options say about the whole run. */
struct plan {
    bool init, prompt, sources;
    bool keep_going; /* -e, -f and FILE go on after an error */
};

/* ---- Signals that end a script, which first writes what it has found ---- */

/* Set by the handler: `interrupted` ends the command that runs, `ended` the script. */
static volatile sig_atomic_t interrupted, ended;

/* SIGINT ends the command alone. */
static bool interruptible;

static void on_signal(int number)
{
    __atomic_store_n(&interrupted, number, __ATOMIC_RELAXED); /* other threads look at it: dom_raised */
    if (number != SIGINT || !interruptible)
        ended = number;
}

/* A signal that ends the script ends each wait, too; a second one ends the program at once. */
static void signals_begin(struct session *session)
{
    static const int all[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction before, action = {.sa_handler = on_signal};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        bool command = all[i] == SIGINT && interruptible;
        action.sa_flags = command ? SA_RESTART : (int)SA_RESETHAND;
        if (command || (sigaction(all[i], NULL, &before) == 0 && before.sa_handler == SIG_DFL))
            sigaction(all[i], &action, NULL);
    }
    session->state.scene.compute.interrupt = &interrupted;
    session->resumes = interruptible ? &interrupted : NULL;
}

/* "2/7"; false, with a message, for anything else. */
static bool shard_read(const char *text, struct shard *shard)
{
    enum { PARTS_MAX = 1000000000 };
    char *slash, *end;
    bool digits = text[strspn(text, "0123456789/")] == '\0' && *text != '/';
    unsigned long part = strtoul(text, &slash, 10), parts = 0;
    if (digits && *slash == '/' && slash[1] != '/' && slash[1] != '\0') {
        parts = strtoul(slash + 1, &end, 10);
        parts = *end == '\0' ? parts : 0;
    }
    *shard = (struct shard){part, parts};
    if (part >= 1 && part <= parts && parts <= PARTS_MAX)
        return true;
    fprintf(stderr, "domino: --shard '%s': I/N is the part I of N, 1 <= I <= N <= %d, such as 2/7\n", text,
            PARTS_MAX);
    return false;
}

static bool stopped(const struct session *session)
{
    return session->quit || (session->bail && session->errors > 0);
}

static void run_file(struct session *session, const char *name)
{
    bool standard = strcmp(name, "-") == 0;
    FILE *in = standard ? io_stdin(&ended) : io_read(name, &ended);
    if (!in) {
        session->source.name = NULL;
        session_error(session, "domino: cannot open %s: %s", name, strerror(errno));
        return;
    }
    line_stream(session, in, standard ? "stdin" : name);
    if (!standard)
        fclose(in);
}

static void run_text(struct session *session, const char *text)
{
    session->source.name = "-e";
    session->source.line = 1;
    command_run_text(session, text);
}

/* Checks the options before the first command runs; returns false for wrong ones. */
static bool options_check(int argc, char **argv, struct session *session, struct plan *plan)
{
    int option;
    while ((option = getopt_long(argc, argv, short_options, options, NULL)) != -1) {
        if (option == 'b' || option == 'k') { /* the last one counts */
            session->bail = option == 'b';
            plan->keep_going = option == 'k';
        }
        session->means.safe = session->means.safe || option == 's';
        interruptible = interruptible || option == 'i';
        plan->init = plan->init && option != 'n';
        plan->sources = plan->sources || option == 'e' || option == 'f' || option == 1;
        if (option == 'h' || option == 'V') {
            fprintf(session->output->out, option == 'h' ? "%s%s" : "domino " DOM_VERSION "\n", usage, help);
            session->quit = true;
            return true;
        }
        if (option == 'p' && !shard_read(optarg, &session->means.shard))
            return false;
        if (option == '?') {
            fputs(usage, stderr);
            return false;
        }
    }
    plan->sources = plan->sources || optind < argc;
    return true;
}

/* Runs -e, -f and FILE in their order. */
static void run_sources(int argc, char **argv, struct session *session)
{
    optind = 0;
    for (int option;
         !stopped(session) && (option = getopt_long(argc, argv, short_options, options, NULL)) != -1;) {
        if (option == 'e')
            run_text(session, optarg);
        else if (option == 'f' || option == 1)
            run_file(session, optarg);
    }
    for (; !stopped(session) && optind < argc; optind++)
        run_file(session, argv[optind]); /* those after "--" */
}

/* The start-up file is for people: scripts do not depend on it. */
static void run_init(struct session *session)
{
    char path[PATH_MAX];
    struct stat status;
    if (!line_path("XDG_CONFIG_HOME", ".config", "init.dom", path, sizeof path) || stat(path, &status) != 0)
        return;
    if (S_ISFIFO(status.st_mode)) /* to read a FIFO could wait for ever */
        session_error(session, "domino: the start-up file %s is not a regular file", path);
    else
        run_file(session, path);
}

/* Returns true if standard output is a pipe whose reader has gone. */
static bool reader_gone(void)
{
    struct pollfd out = {.fd = STDOUT_FILENO};
    struct stat status;
    return fstat(STDOUT_FILENO, &status) == 0 && S_ISFIFO(status.st_mode) && poll(&out, 1, 0) == 1 &&
           (out.revents & POLLERR) != 0;
}

int main(int argc, char **argv)
{
    struct session session;
    struct plan plan = {.init = true};
    io_begin();
    /* A closed pipe and a file at its limit of size are write errors, which are reported. */
    bool dies = signal(SIGPIPE, SIG_IGN) == SIG_DFL; /* where the caller does not ignore it */
    signal(SIGXFSZ, SIG_IGN);
    command_registry(all_commands);
    session_init(&session, io_stdout(&ended));
    if (!options_check(argc, argv, &session, &plan))
        return EXIT_USAGE;
    plan.prompt = !plan.sources && !session.quit && isatty(STDIN_FILENO) && isatty(STDOUT_FILENO);
    if (!plan.prompt)
        signals_begin(&session);
    if (plan.prompt && plan.init)
        run_init(&session);
    if (plan.sources) {
        session.bail = !plan.keep_going; /* what comes after an error would answer for another scene */
        run_sources(argc, argv, &session);
    } else if (plan.prompt && !stopped(&session)) {
        line_prompt(&session);
        session.errors = 0; /* the person has seen them */
    } else if (!stopped(&session))
        run_file(&session, "-");

    bool failed = session.errors > 0;
    session_close(&session);
    /* Buffered output may fail as late as here. */
    errno = 0;
    bool gone = reader_gone(), lost = ferror(session.standard.out) != 0;
    if (fclose(session.standard.out) != 0 || lost) {
        if (dies &&
            (gone ||
             errno ==
                 EPIPE)) { /* 'domino | head' has what it asked for: no message, and the status of SIGPIPE */
            signal(SIGPIPE, SIG_DFL);
            raise(SIGPIPE);
        }
        int reason = session.standard.error ? session.standard.error : errno;
        if (!ended)
            fprintf(stderr, "domino: cannot write the output%s%s\n", reason ? ": " : "",
                    reason ? strerror(reason) : "");
        failed = true;
    }
    if (ended) {
        signal(ended, SIG_DFL);
        raise(ended);
    }
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
