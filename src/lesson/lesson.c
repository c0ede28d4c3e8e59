/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'lesson', which runs a script and shows its lines. At a terminal, it waits until the reader has
 * typed each command. If the command 'lesson' stands in a file, the script is the rest of that file.
 * Otherwise the script is the tutorial: the build copies examples/tutorial.dom into tutorial.h. */
#include "interpreter/question.h"
#include "io/escape.h"
#include "io/io.h"
#include "io/terminal.h"
#include "language/text.h"
#include "prompt/input.h"
#include "session/session.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char tutorial[] = {
#include "tutorial.h"
};

static const char prompt[] = "domino> ";

/* Opens the tutorial as a stream that begins after the line 'lesson'. */
static FILE *tutorial_open(void)
{
    FILE *in = fmemopen(tutorial, sizeof tutorial, "r");
    char line[256];
    while (in && fgets(line, sizeof line, in) && strcmp(line, "lesson\n") != 0)
        continue;
    return in;
}

/* Escapes control characters, because the file may come from a stranger. */
static void line_show(const struct session *reader, const char *before, const char *line)
{
    char *shown = escape_copy(line);
    if (shown)
        fprintf(reader->output->out, "%s%s\n", before, shown);
    free(shown);
}

/* Waits until the reader types the command, or just presses Enter. Runs any other line and waits again.
 * Returns false if the reader ends the lesson. */
static bool reader_types(struct session *reader, const char *command)
{
    bool waits = true, has_typed = false;
    while (waits && !has_typed) {
        line_show(reader, "Type: ", command);
        char *line = line_edit(reader, prompt);
        const char *typed = line ? skip_blanks(line) : "q";
        if (!line)
            putc('\n', reader->output->out);
        has_typed = !*typed || strcmp(typed, command) == 0;
        if (strcmp(typed, "q") == 0)
            reader->quit = true;
        else if (!has_typed)
            command_run_text(reader, typed);
        waits = !session_stops(reader, reader->errors);
        free(line);
    }
    return waits;
}

static void lesson_line(struct session *reader, const char *line, bool waits)
{
    if (*line == '\0' || *line == '#') {
        line_show(reader, "", line + strspn(line, "#") + (line[0] == '#' && line[1] == ' '));
        return;
    }
    if (!waits)
        line_show(reader, prompt, line);
    if (!waits || reader_types(reader, line))
        command_run_text(reader, line);
}

static bool run_lesson(struct session *session, const struct arguments *given, struct answer *a,
                       struct problem *problem)
{
    (void)given;
    /* A separate session with default parameters, so that the parameters of `session` do not change. */
    struct session reader;
    bool in_file = session->source.stream && strcmp(session->source.name, "stdin") != 0;
    int width, height;
    bool waits = isatty(STDIN_FILENO) && terminal_size(session->output->out, &width, &height);
    char *line = NULL;
    size_t size = 0;
    if (!answer_for_people(a))
        return problem_error(problem, "a lesson needs tables; first enter 'set output table'");
    FILE *in = in_file ? session->source.stream : tutorial_open();
    if (!in)
        return problem_status(problem, &session->state.scene, DOM_NO_MEMORY);
    session_init(&reader, session->output->out);
    reader.state.scene.compute.interrupt = session->state.scene.compute.interrupt;
    reader.run_context.safe = session->run_context.safe;
    reader.source.prompt_width = waits ? (int)strlen(prompt) : 0;
    progress_end(); /* the progress display must not count the time that the reader takes */
    if (waits)
        fputs("Type each line that the lesson shows, or just press Enter. You may try other\n"
              "commands in between. Your own parameters stay as they are. 'q' ends the lesson.\n",
              reader.output->out);
    while (!session_stops(&reader, reader.errors) && text_read(&line, &size, in) != -1)
        lesson_line(&reader, line, waits);
    session->errors += waits ? 0 : reader.errors;
    session_close(&reader);
    free(line);
    if (!in_file)
        fclose(in);
    return true;
}

static const struct command lesson_commands[] = {
    {.name = "lesson",
     .synonyms = "tutorial tour learn course introduction begin start",
     .summary = "a tour in ten steps, from a tower of 112 m to a row of your own",
     .help = "At a terminal the lesson shows a line and waits until you type that line, or press Enter. You "
             "may type other commands in between; 'q' ends the lesson. The lesson runs in a session of its "
             "own, so your parameters stay as they are. To write a lesson yourself, begin a file with "
             "'lesson', as in examples/tutorial.dom.",
     .see = "help",
     .access.runs = true,
     .act = run_lesson},
    {.name = NULL},
};

static const struct command_group groups[] = {
    {"A lesson", "scripts", lesson_commands},
    {NULL, NULL, NULL},
};

static const struct first_line first[] = {
    {9, "lesson", "a tour in ten steps, from the tower to a row of your own", true},
    {0, NULL, NULL, false},
};

const struct feature lesson_feature = {.name = "lesson", .groups = groups, .first = first};
