/* SPDX-License-Identifier: GPL-3.0-or-later */
/* domino: an interactive calculator for domino trains that grow. */
#include "command.h"
#include "line.h"
#include <errno.h>
#include <getopt.h>
#include <locale.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { EXIT_USAGE = 2 };

static const char usage[] = "usage: domino [--bail] [-e COMMANDS | -f FILE | FILE] ...\n";

static const char help[] =
    "\n"
    "Calculates how far a row of dominoes, each r times larger than the one before, can grow.\n"
    "Without -e, -f or FILE it reads commands from standard input: at a prompt on a terminal,\n"
    "else one command a line.\n"
    "\n"
    "  -e, --execute COMMANDS  run these commands, ';' between them\n"
    "  -f, --file FILE         run the commands in FILE ('-' is standard input)\n"
    "      --bail              stop at the first error\n"
    "  -h, --help              print this help\n"
    "  -V, --version           print the version\n"
    "\n"
    "Exit status: 0, 1 after an error in a command, 2 for wrong options.\n"
    "The command 'help' lists the commands: domino -e help\n";

static const struct option options[] = {
    {"execute", required_argument, NULL, 'e'}, {"file", required_argument, NULL, 'f'},
    {"bail", no_argument, NULL, 'b'},          {"help", no_argument, NULL, 'h'},
    {"version", no_argument, NULL, 'V'},       {NULL, 0, NULL, 0},
};

static bool stopped(const struct session *session)
{
    return session->quit || (session->bail && session->errors > 0);
}

static void run_file(struct session *session, const char *name)
{
    if (strcmp(name, "-") == 0) {
        line_stream(session, stdin, "stdin");
        return;
    }
    FILE *in = fopen(name, "r");
    if (!in) {
        session->source = NULL;
        session_error(session, "domino: cannot open %s: %s", name, strerror(errno));
        return;
    }
    line_stream(session, in, name);
    fclose(in);
}

static void run_text(struct session *session, const char *text)
{
    session->source = "-e";
    session->line = 1;
    command_run_text(session, text);
}

/* Options are judged before the first command runs. */
static bool options_valid(int argc, char **argv, struct session *session)
{
    int option;
    while ((option = getopt_long(argc, argv, "-e:f:hV", options, NULL)) != -1) {
        if (option == 'b')
            session->bail = true;
        else if (option == 'h' || option == 'V') {
            printf(option == 'h' ? "%s%s" : "domino " DOM_VERSION "\n", usage, help);
            session->quit = true;
            return true;
        } else if (option == '?') {
            fputs(usage, stderr);
            return false;
        }
    }
    return true;
}

int main(int argc, char **argv)
{
    struct session session;
    setlocale(LC_CTYPE, "");  /* never LC_NUMERIC: the decimal point is a point */
    signal(SIGPIPE, SIG_IGN); /* a closed pipe is a write error, which is reported */
    session_init(&session, stdout);
    if (!options_valid(argc, argv, &session))
        return EXIT_USAGE;

    bool sources = false, prompt = false;
    optind = 0;
    for (int option;
         !stopped(&session) && (option = getopt_long(argc, argv, "-e:f:hV", options, NULL)) != -1;) {
        sources = sources || option != 'b';
        if (option == 'e')
            run_text(&session, optarg);
        else if (option != 'b')
            run_file(&session, optarg);
    }
    for (; !stopped(&session) && optind < argc; optind++, sources = true)
        run_file(&session, argv[optind]); /* those behind "--" */
    if (!sources && !stopped(&session)) {
        prompt = isatty(STDIN_FILENO) && isatty(STDOUT_FILENO);
        if (prompt)
            line_prompt(&session);
        else
            line_stream(&session, stdin, "stdin");
    }
    bool failed = session.errors > 0 && !prompt;
    errno = 0;
    if (ferror(stdout) || fclose(stdout) != 0) {
        fprintf(stderr, "domino: cannot write the output%s%s\n", errno ? ": " : "",
                errno ? strerror(errno) : "");
        failed = true;
    }
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
