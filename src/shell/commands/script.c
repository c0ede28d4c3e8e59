/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands for scripts: source and echo. */
#include "interpreter/question.h"
#include "io/escape.h"
#include "io/io.h"
#include "session/session.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

static bool run_source(struct session *session, const struct arguments *given, struct answer *a,
                       struct problem *problem)
{
    const char *name = given->word[0];
    (void)a;
    bool standard = strcmp(name, "-") == 0;
    if (session->source.depth == SOURCE_DEPTH)
        return problem_error(problem, "files are nested %d deep; perhaps one of them sources itself",
                             SOURCE_DEPTH);
    FILE *in = standard ? io_stdin() : io_open_read(name);
    if (!in && errno == ECANCELED)
        return problem_status(problem, &session->state.scene, DOM_INTERRUPTED);
    if (!in)
        return problem_error(problem, "cannot read '%s': %s", names_shown(name), strerror(errno));
    long errors = session->errors;
    session->source.depth++;
    line_stream(session, in, standard ? "stdin" : name);
    session->source.depth--;
    if (!standard)
        fclose(in);
    /* ^C can end the file between two of its commands, which then report nothing. */
    if (session->errors == errors && dom_raised(session->state.scene.compute.interrupt))
        return problem_status(problem, &session->state.scene, DOM_INTERRUPTED);
    return session->errors == errors;
}

/* ---- Text ---- */

/* Parses the rest of the command as a single string. If it is in double quotes, it may contain ';', '>' and
 * '#'. */
static bool echo_parse(struct reader *r, struct question *q)
{
    const char *begin = r->at, *end = text_end(begin, ";>");
    const char *quote = *begin == '"' ? text_quote(begin) : NULL;
    struct item *item = &q->item[0];
    if (*begin == '"' && (!quote || skip_blanks(quote) >= end)) {
        item->word = read_word(r, WORD_TYPED);
    } else {
        while (end > begin && strchr(" \t\r\f\v", end[-1]))
            end--;
        const char *typed = text_typed(r->text, begin);
        item->word = reader_copy(r, typed, (size_t)(text_typed(r->text, end) - typed));
        r->at = end;
    }
    return item->word != NULL;
}

static const struct column echo_columns[] = {
    {"text", "", "the text", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_echo(const struct query *query, struct answer *a, struct problem *problem)
{
    const char *text = query->given->count ? query->given->word[0] : "";
    if (!answer_for_people(a))
        return answer_cells(a, cell_word(text));
    char *shown = escape_copy(text);
    if (shown)
        fprintf(a->out, "%s\n", shown);
    free(shown);
    return shown || query_status(query, problem, DOM_NO_MEMORY);
}

const struct command script_commands[] = {
    {.name = "source",
     .synonyms = "script load open read batch import file",
     .argument = {{.name = "FILE", .kind = ARGUMENT_FILE}},
     .summary = "run the commands in FILE; '-' is standard input",
     .see = "save",
     .access.files = true,
     .access.runs = true,
     .access.changes = true,
     .act = run_source},
    {.name = "echo",
     .synonyms = "write text say message",
     .argument = {{.name = "TEXT", .kind = ARGUMENT_WORDS, .parse = echo_parse, .optional = true}},
     .summary = "write TEXT, as a heading or to mark the end of an answer",
     .help = "Put TEXT between double quotes if it contains ';', '>' or ' #'.",
     .example = "echo hollow dominoes; rmax with q hollow",
     .see = "print",
     .sweep.refusal = "it computes nothing",
     ANSWER(echo)},
    {.name = NULL},
};
