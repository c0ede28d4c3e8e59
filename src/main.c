/* SPDX-License-Identifier: GPL-3.0-or-later */
/* domino: an interactive calculator for domino trains that grow. */
#include "interpreter/question.h"
#include "io/io.h"
#include "io/terminal.h"
#include "prompt/input.h"
#include "session/session.h"
#include <errno.h>
#include <getopt.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

enum { EXIT_USAGE = 2 };

static const char usage[] =
    "usage: domino [-i] [--bail | --keep-going] [--safe] [-e COMMANDS | -f FILE | FILE] ...\n";

static const char help[] =
    "\n"
    "Calculates how much larger each domino of a row can be than the one before it.  Without\n"
    "-e, -f or FILE, domino reads commands from standard input, at a prompt if input and output\n"
    "are terminals.  An error in -e, -f or FILE ends the run; after an error on standard input,\n"
    "the next line is read.  A FILE whose name ends in .csv is a row: domino begins with it, and\n"
    "then reads commands as without FILE.\n"
    "\n"
    "  -e, --execute COMMANDS  run these commands, separated by ';'\n"
    "  -f, --file FILE         run the commands in FILE ('-' is standard input)\n"
    "  -i, --interactive       after -e, -f and FILE, read commands from standard input\n"
    "      --bail              stop at the first error, also in input from a pipe\n"
    "      --keep-going        go on after errors, even in -e, -f and FILE\n"
    "      --safe              commands may not read or write files\n"
    "  -h, --help              print this help\n"
    "  -V, --version           print the version, and what this program was built with\n"
    "\n"
    "Exit status: 0 if there were no errors, 1 if a command failed, 2 if an option is invalid.\n"
    "The command 'help' lists the commands: domino -e help\n";

/* -n has no effect: it is for scripts of versions that had a start-up file. */
static const struct option options[] = {
    {"execute", required_argument, NULL, 'e'}, {"file", required_argument, NULL, 'f'},
    {"no-init", no_argument, NULL, 'n'},       {"bail", no_argument, NULL, 'b'},
    {"keep-going", no_argument, NULL, 'k'},    {"safe", no_argument, NULL, 's'},
    {"help", no_argument, NULL, 'h'},          {"version", no_argument, NULL, 'V'},
    {"interactive", no_argument, NULL, 'i'},   {NULL, 0, NULL, 0},
};

/* What the command line asks for. */
struct plan {
    /* the commands of -e, the files of -f, and FILEs, in the order in which they were typed */
    struct typed {
        bool is_file;
        const char *text;
    } * typed;
    int sources;
    bool prompt;
    bool reads;      /* commands are read from standard input: without sources, after a row, and with -i */
    bool keep_going; /* continue after an error in -e, -f and FILE */
};

/* ---- Signals: before a script ends, it writes what it has found ---- */

/* The number of a signal that has arrived, or 0. The signal in `interrupted` ends the running command, and
 * the signal in `ended` ends the whole script. */
static volatile sig_atomic_t interrupted, ended;

/* False if a prompt opens, where SIGINT ends only the running command, or a file that runs before the
 * prompt. */
static bool sigint_ends;

static void on_signal(int number)
{
    if (number != SIGINT || sigint_ends)
        ended = number;
    /* The store is atomic because other threads read `interrupted` in dom_raised. */
    __atomic_store_n(&interrupted, ended ? ended : number, __ATOMIC_RELAXED);
}

/* Installs the signal handler. The first signal ends the script, after the script has written its results so
 * far. If the same signal arrives again, the program ends at once. A signal that was ignored when the program
 * started stays ignored, except for a SIGINT that does not end the program. */
static void signals_begin(void)
{
    static const int all[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction before, action = {.sa_handler = on_signal};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        const bool is_kept = all[i] == SIGINT && !sigint_ends;
        action.sa_flags = is_kept ? SA_RESTART : (int)SA_RESETHAND;
        if (is_kept || (sigaction(all[i], NULL, &before) == 0 && before.sa_handler == SIG_DFL))
            sigaction(all[i], &action, NULL);
    }
}

/* ---- Options ---- */

static bool is_row(const char *name)
{
    const char *extension = strrchr(name, '.');
    return extension && strcasecmp(extension, ".csv") == 0;
}

/* Reads all options before the first source runs. Returns false if an option is wrong. */
static bool options_read(int argc, char **argv, struct session *session, struct plan *plan)
{
    bool stays = false;
    /* The leading '-' makes getopt return each FILE as option 1, so that files and options arrive in the
     * order in which they were typed. */
    for (int option; (option = getopt_long(argc, argv, "-e:f:inhV", options, NULL)) != -1;) {
        if (option == '?') {
            fputs(usage, stderr);
            return false;
        }
        if (option == 'e' || option == 'f' || option == 1) {
            plan->typed[plan->sources++] = (struct typed){option != 'e', optarg};
            plan->reads = plan->reads && option == 1 && is_row(optarg);
        }
        /* If both --bail and --keep-going are given, the last one takes effect. */
        if (option == 'b' || option == 'k') {
            session->bail = option == 'b';
            plan->keep_going = option == 'k';
        }
        session->run_context.safe = session->run_context.safe || option == 's';
        stays = stays || option == 'i';
        if (option == 'V')
            command_run_text(session, "version");
        if (option == 'h')
            fprintf(session->output->out, "%s%s", usage, help);
        session->quit = option == 'V' || option == 'h';
        if (session->quit)
            return true;
    }
    for (; optind < argc; optind++) { /* the arguments after "--" are also files */
        plan->typed[plan->sources++] = (struct typed){true, argv[optind]};
        plan->reads = plan->reads && is_row(argv[optind]);
    }
    plan->reads = plan->reads || stays;
    return true;
}

/* ---- Sources of commands ---- */

static bool is_over(const struct session *session)
{
    return session->quit || interrupted || (session->bail && session->errors > 0);
}

static void run_file(struct session *session, const char *name)
{
    bool standard = strcmp(name, "-") == 0;
    session->source.name = NULL;
    if (is_row(name)) { /* as with 'set row FILE' */
        const struct parameter *row = parameter_find("row");
        struct problem problem;
        problem_begin(&problem, "domino");
        if (row ? !row->load(&session->state.scene, name, &session->run_context, &problem)
                : !problem_error(&problem, "this program has no rows"))
            session_problem(session, &problem);
        return;
    }
    FILE *in = standard ? io_stdin() : io_open_read(name);
    if (!in) {
        session_error(session, "domino: cannot open %s: %s", name, strerror(errno));
        return;
    }
    line_stream(session, in, standard ? "stdin" : name);
    if (!standard)
        fclose(in);
}

static void run_sources(struct session *session, const struct plan *plan)
{
    const bool bails = session->bail;
    session->bail = !plan->keep_going; /* after an error, later commands might be about the wrong scene */
    for (const struct typed *s = plan->typed; s < plan->typed + plan->sources && !is_over(session); s++)
        if (s->is_file)
            run_file(session, s->text);
        else {
            session->source.name = "-e";
            session->source.line = 1;
            command_run_text(session, s->text);
        }
    session->quit = session->quit || (!plan->prompt && is_over(session));
    session->bail = bails;
}

/* Closes standard output. If output was lost, prints a message and returns false. If standard output is a
 * pipe whose reader has gone, as in 'domino | head', SIGPIPE normally ends the program without a message. If
 * the program was started with SIGPIPE ignored, it prints the message instead. */
static bool output_close(FILE *out, bool ignores_pipe)
{
    if (fclose(out) == 0)
        return true;
    if (errno == EPIPE && !ignores_pipe) {
        signal(SIGPIPE, SIG_DFL);
        raise(SIGPIPE);
    }
    if (!ended)
        fprintf(stderr, "domino: cannot write the output: %s\n", strerror(errno));
    return false;
}

int main(int argc, char **argv)
{
    struct session session;
    struct plan plan = {.typed = calloc((size_t)argc + 1, sizeof *plan.typed), .reads = true};
    io_begin();
    /* By default, SIGPIPE and SIGXFSZ would end the program when a pipe has no reader or a file gets too
     * large. They are ignored, so that write(2) fails instead. */
    bool ignores_pipe = signal(SIGPIPE, SIG_IGN) == SIG_IGN;
    signal(SIGXFSZ, SIG_IGN);
    features_register(every_feature);
    session_init(&session, io_stdout(&ended));
    session.state.scene.compute.interrupt = io_interrupt = &interrupted;
    if (!plan.typed) {
        fputs("domino: out of memory\n", stderr);
        return EXIT_FAILURE;
    }
    if (!options_read(argc, argv, &session, &plan)) {
        free(plan.typed);
        fclose(session.standard.out);
        return EXIT_USAGE;
    }
    plan.prompt = plan.reads && !session.quit && isatty(STDIN_FILENO) && isatty(STDOUT_FILENO);
    sigint_ends = !plan.prompt;
    signals_begin();
    if (plan.sources > 0)
        run_sources(&session, &plan);
    if (plan.prompt)
        interrupted = ended;
    if (plan.prompt && !is_over(&session)) {
        line_prompt(&session, &interrupted);
        /* At a prompt, the user has already seen the errors, so they do not affect the exit status. */
        session.errors = 0;
    } else if (plan.reads && !is_over(&session))
        run_file(&session, "-");
    session_close(&session);
    free(plan.typed);
    bool is_good = output_close(session.standard.out, ignores_pipe) && session.errors == 0;
    if (ended) {
        signal(ended, SIG_DFL);
        raise(ended);
    }
    return is_good ? EXIT_SUCCESS : EXIT_FAILURE;
}
