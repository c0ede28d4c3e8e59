/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'log', which copies a session into a file. */
#include "interpreter/command.h"
#include "io/io.h"
#include "session/session.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>

static struct {
    FILE *file;       /* NULL if there is no log */
    bool in_line;     /* the last line in the file is incomplete so far */
    bool in_sequence; /* the last character belongs to a control sequence: ESC, '[', numbers and a letter */
} record;

/* Ends the log, if there is one. Returns NULL, or the reason why the file could not be written. */
static const char *record_end(void)
{
    if (!record.file)
        return NULL;
    io_stdout_flush();
    const char *wrong = fclose(record.file) == 0 ? NULL : strerror(errno);
    free(output_reserved);
    output_reserved = NULL;
    record.file = NULL;
    io_copy = NULL;
    return wrong;
}

/* Copies what goes to standard output, without the control sequences of a terminal. Each line becomes a
 * comment, so that the log can be run as a script. */
static void record_output(const char *bytes, size_t count)
{
    for (const char *c = bytes; c < bytes + count; c++) {
        const bool is_control = record.in_sequence || *c == '\033' || *c == '\r';
        record.in_sequence = *c == '\033' || (record.in_sequence && (*c < '@' || *c == '['));
        if (is_control)
            continue;
        if (!record.in_line && *c != '\n')
            fputs("# ", record.file);
        record.in_line = *c != '\n';
        putc(*c, record.file);
    }
}

static void record_typed(const char *text, size_t length)
{
    io_stdout_flush(); /* the answers before it */
    if (record.file)   /* a session within this one may have ended the log */
        fprintf(record.file, "%.*s\n", (int)length, text);
}

static void record_message(const char *text)
{
    if (record.file)
        fprintf(record.file, "# %s\n", text);
}

static const char *record_flush(void)
{
    io_stdout_flush();
    return !record.file || (fflush(record.file) == 0 && !ferror(record.file)) ? NULL : record_end();
}

static void record_close(void)
{
    (void)record_end();
}

static const struct session_log session_log = {record_typed, record_message, record_flush, record_close};

/* Begins a log, which is appended to its file. If there is already a log, it ends. Returns NULL, or the
 * reason why the file cannot be written. */
static const char *record_begin(const char *path)
{
    struct stat status;
    char *target;
    const char *wrong = output_target(path, &target, &status);
    if (!wrong && output_is_standard(&status))
        wrong = output_in_use;
    io_stdout_flush(); /* the answers before this command do not belong in the log */
    if (record.file)
        fflush(record.file); /* it may be the same file */
    const bool in_line = !wrong && io_ends_in_line(path);
    const int opened = wrong ? -1 : io_open(path, O_WRONLY | O_CREAT | O_APPEND, 0666);
    FILE *file = opened < 0 ? NULL : io_stream(opened, "a");
    if (!file) {
        wrong = wrong ? wrong : strerror(errno);
        free(target);
        return wrong;
    }
    record_end();
    record.file = file;
    record.in_line = record.in_sequence = false;
    output_reserved = target;
    io_copy = record_output;
    fprintf(file, "%s# A log of domino " DOM_VERSION ": 'source' it to run its commands again.\n",
            in_line ? "\n" : "");
    return NULL;
}

/* Begins a log of the session, or ends it with 'off'. */
static bool run_log(struct session *session, const struct arguments *given, struct answer *a,
                    struct problem *problem)
{
    const char *wrong = NULL, *path = given->word[0];
    if (session->output->path)
        return problem_error(
            problem,
            "'%s' does not work while answers go to '%s'; enter 'log FILE' on a line of its own, "
            "without '>'",
            a->command, names_shown(session->output->path));
    if (strcmp(path, "off") == 0) {
        record_end();
        session->log = NULL;
    } else if (!(wrong = record_begin(path)))
        session->log = &session_log;
    return !wrong || problem_error(problem, "cannot write '%s': %s", names_shown(path), wrong);
}

static const struct command log_commands[] = {
    {.name = "log",
     .synonyms = "record transcript protocol journal file tee copy output",
     .argument = {{.name = "FILE", .kind = ARGUMENT_FILE}},
     .summary = "append all commands and answers to FILE until 'log off'",
     .help = "'source FILE' can run the commands again, because answers and errors are written as "
             "comments. Write './off' for a file named off.",
     .see = "save",
     .access.files = true,
     .act = run_log},
    {.name = NULL},
};

static const struct command_group groups[] = {
    {"A record of the session", "scripts", log_commands},
    {NULL, NULL, NULL},
};

const struct feature log_feature = {.name = "log", .groups = groups};
