/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/run.h"
#include "answer/format.h"
#include "io/terminal.h"
#include "picture/show.h"
#include "session/engine.h"
#include <string.h>

#define TRAIN_NOTE "the endless train with these parameters, and not the row: 'fall' runs the row."

/* Tells the user that the answer is about the endless train, and not about the row of the scene. This note
 * goes below the answer, or to standard error if the answer is a picture in a file. */
static void train_note(const struct session *session, struct answer *answer)
{
    const char *note =
        scene_has_engine(&session->state.scene)
            ? "(This is the endless train in the model, with feet on hinges and without bounce: "
              "'fall' and 'rowmax' run the row in the rigid-body engine.)"
            : "(This is " TRAIN_NOTE ")";
    if (!answer_for_people(answer))
        return;
    if (answer->path && ending_of(answer->path)->kind == ENDING_SHEET)
        fprintf(stderr, "%s\n", note);
    else
        answer_say(answer, "%s", note);
}

/* Returns true if the answer of the command is a picture. */
static bool is_picture(const struct command *c)
{
    return c->writes == WRITES_PICTURES || c->writes == WRITES_CHARTS;
}

/* Runs the function of the command that produces the answer for this output: `act`, `picture` or `run`. */
static bool run_function(struct session *session, const struct command *c, const struct query *query,
                         struct answer *answer, struct problem *problem)
{
    bool is_on_screen = is_picture(c) && !c->files && answer->style.format->for_people && !answer->path;
    if (is_on_screen && !picture_fits(answer, c->name, problem))
        return false;
    if (c->act)
        return c->act(session, query->given, answer, problem);
    if (answer->path && c->picture && ending_of(answer->path)->terminal)
        return c->picture(query, answer, problem);
    return c->run(query, answer, problem);
}

/* Runs a command and writes its answer to the output at the top of the stack. */
static bool run_command(struct session *session, const struct command *c, const struct query *query,
                        struct problem *problem)
{
    struct cell kept[ANSWER_CELLS];
    /* Clearing the array takes time, because it has about a kilobyte, and most lines of a script do not use
     * it. */
    if (c->principal)
        memset(kept, 0, sizeof kept);
    struct output *output = session->output, *end = output_end(output);
    bool is_not_row = c->train && session->state.scene.effect[DOM_EFFECT_row].on;
    struct answer answer = {
        .out = output->out,
        .path = output->path,
        .appended = output->append,
        .style = state_style(query->state),
        .command = c->name,
        .note = is_not_row ? TRAIN_NOTE : NULL,
        .csv.last_head = end->head,
        .columns = c->columns,
        .rows = c->rows,
        .blank_above = end->answered && session->source.name,
        .kept = c->principal ? kept : NULL,
    };
    if (output->format)
        answer.style.format = output->format;
    problem->place = 0;
    double begun = session->state.settings.timing ? terminal_clock() : 0;
    progress_begin();
    bool done = run_function(session, c, query, &answer, problem);
    progress_end();
    session->typed.is_last = session->typed.is_last && done && !c->columns;
    if (done && answer.note)
        train_note(session, &answer);
    const struct format *format = answer.style.format;
    const char *unsaid = done && format->end ? format->end(&answer) : NULL;
    if (unsaid)
        session_note(session, "%s", unsaid);
    session->wrote = answer.has_rows;
    end->answered = end->answered || (done && c->columns) || answer.wrote_text;
    end->error = answer.error ? answer.error : end->error;
    if (done && (answer.is_value || c->principal))
        session->ans.printed = answer.is_value;
    if (done && answer.is_value)
        session->ans.value = answer.value;
    else if (done && c->principal) {
        session->ans.command = c;
        memcpy(session->ans.cells, kept, sizeof kept);
    }
    if (done && session->state.settings.timing && c->columns) {
        /* The time must not appear in csv and json, which programs read. */
        bool is_for_people = answer.style.format->for_people && !answer.path;
        fprintf(is_for_people ? answer.out : stderr, "time: %.6g ms\n", 1e3 * (terminal_clock() - begun));
    }
    return done;
}

/* Runs a command through the pager if its answer may be longer than the terminal: a help page or, at the
 * prompt, any answer. */
static bool run_paged(struct session *session, const struct command *c, const struct query *query,
                      struct problem *problem)
{
    const bool has_pages = c->writes == WRITES_PAGES;
    if (!has_pages && !(session->source.prompt_width && c->columns && !is_picture(c) && !c->runs))
        return run_command(session, c, query, problem);
    const volatile sig_atomic_t *interrupt = session->state.scene.compute.interrupt;
    int error = output_end(session->output)->error;
    bool is_paged = pager_push(&session->output, has_pages ? 1 : 1.5, !session->means.safe, interrupt);
    bool done = run_command(session, c, query, problem);
    if (is_paged && output_pop(&session->output, true)) {
        /* If the user closed the pager before the end of the answer, this is not a write error. */
        output_end(session->output)->error = error;
        if (dom_raised(interrupt))
            problem_status(problem, &session->state.scene, DOM_INTERRUPTED);
    }
    return done;
}

/* ---- Files ---- */

/* Returns true if the extension of the file suits the answer of the command. Otherwise reports a problem. */
static bool ending_fits(const struct command *c, const char *path, struct problem *problem)
{
    char shown[NAMES_SHOWN];
    names_shown(path, shown);
    const struct ending *ending = ending_of(path);
    const bool draws = c->writes == WRITES_PICTURES, charts = c->writes == WRITES_CHARTS || c->picture;
    const char *pictures = charts ? ".svg, .png, .pdf, .tex or .gp" : ".svg, .png, .pdf or .gp";
    switch (ending->kind) {
    case ENDING_SHEET:
        if (c->writes == WRITES_DOCUMENTS)
            return ending->is_document ||
                   problem_error(problem,
                                 "'%s' names a picture, but '%s' writes a text; use .pdf, .tex, .md or .txt",
                                 shown, c->name);
        if (draws || charts)
            return (ending->terminal && (charts || strcmp(ending->text, ".tex") != 0)) ||
                   problem_error(problem, "'%s' names a document, but '%s' draws a picture; use %s", shown,
                                 c->name, pictures);
        return ending->terminal
                   ? problem_error(problem,
                                   "'%s' names a picture, but '%s' does not draw; 'draw' and 'plot' do",
                                   shown, c->name)
                   : problem_error(problem, "'%s' names a document, but '%s' cannot write one; 'explain' can",
                                   shown, c->name);
    case ENDING_DATA:
        return c->columns || c->runs || c->writes == WRITES_PAGES ||
               problem_error(problem,
                             "'%s' names a data file, but '%s' has no data; '%s > FILE.txt' writes its text",
                             shown, c->name, c->name);
    case ENDING_OTHER:
        return problem_error(
            problem, "the file extension of '%s' is unknown; use %s", shown,
            c->writes == WRITES_DOCUMENTS ? ".pdf, .tex, .md or .txt, or .csv or .json for its data"
            : c->writes == WRITES_CHARTS
                ? ".svg, .png, .pdf, .tex, .gp or .txt, or .csv or .json for its data"
            : c->writes == WRITES_PICTURES ? ".svg, .png, .pdf, .gp or .txt, or .csv or .json for its data"
            : c->picture            ? ".csv, .json or .txt, or for a picture .svg, .png, .pdf, .tex or .gp"
            : c->columns || c->runs ? ".csv, .json or .txt"
                                    : ".txt");
    case ENDING_NONE:
    case ENDING_TEXT:
        break;
    }
    return true;
}

/* Runs a command and writes its answer to a file, in the format of the file's extension. */
static bool run_into(struct session *session, const struct command *c, const struct query *query,
                     const char *path, bool appends, struct problem *problem)
{
    char shown[NAMES_SHOWN];
    const struct ending *ending = ending_of(path);
    const char *wrong = file_push(&session->output, path, appends, session->state.scene.compute.interrupt);
    bool done = !wrong;
    if (done) {
        /* a picture is drawn even after 'set output csv' */
        session->output->format = ending->kind == ENDING_SHEET ? &format_table : ending->format;
        session->output->is_head = session_answers(session)->is_head;
        done = run_command(session, c, query, problem);
        wrong = output_pop(&session->output, done);
        if (!done)
            return false;
    }
    return !wrong || problem_error(problem, "cannot write '%s': %s", names_shown(path, shown), wrong);
}

/* Runs a command that is followed by '>' or '>>' and the path of a file. */
static bool run_redirected(struct session *session, struct reader *r, const struct command *c,
                           const struct query *query)
{
    struct problem *problem = r->problem;
    bool appends = r->at[1] == '>';
    r->at = skip_blanks(r->at + (appends ? 2 : 1));
    reader_place(r, r->at);
    const char *path = read_file(r);
    r->at = skip_blanks(r->at);
    if (!path)
        return false;
    if (!*path)
        return problem_error(problem, "the file after '>' is missing; for example 'show > FILE'");
    if (!command_ends(r->at))
        return problem_error(
            problem, "only one word can follow '>'; put a file name with blanks between double quotes");
    if (session->means.safe)
        return problem_error(problem, "a safe session cannot read or write files");
    return ending_fits(c, path, problem) && run_into(session, c, query, path, appends, problem);
}

bool run_question(struct session *session, struct reader *r, const struct question *q)
{
    struct call call;
    struct query query = *r->query;
    query.next = &session->state;
    bool done = question_bind(q, &query, &call, r->problem);
    if (done)
        done = *r->at == '>' ? run_redirected(session, r, q->command, &call.query)
                             : run_paged(session, q->command, &call.query, r->problem);
    call_free(&call);
    return done;
}
