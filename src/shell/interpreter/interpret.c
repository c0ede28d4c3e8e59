/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs lines: the commands in them, with their answers in the files after '>'. */
#include "answer/format.h"
#include "interpreter/question.h"
#include "io/terminal.h"
#include "picture/show.h"
#include "session/engine.h"
#include "session/parameters.h"
#include "session/session.h"
#include "session/undo.h"
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#define TRAIN_NOTE "the endless train at these parameters, not the row: 'fall' runs that."

/*
 * Reports to a person that the answer is not about the row: below the answer, or on standard error if a
 * picture takes the answer's file, whose format has no room for sentences.
 */
static void say_train(const struct session *session, struct answer *answer)
{
    const char *note =
        scene_has_engine(&session->state.scene)
            ? "(This is the endless train in the model, with feet on hinges and without bounce: "
              "'fall' and 'rowmax' run the row in the rigid-body engine.)"
            : "(This is " TRAIN_NOTE ")";
    if (!answer_for_people(answer))
        return;
    if (answer->path && ending_of(answer->path)->kind == ENDING_PICTURE)
        fprintf(stderr, "%s\n", note);
    else
        answer_say(answer, "%s", note);
}

/* Runs a command whose arguments have been read. */
static bool run_call(struct session *session, const struct command *c, const struct query *query,
                     struct problem *problem)
{
    struct cell kept[ANSWER_CELLS];
    if (c->principal) /* without a principal column the cells are not kept */
        memset(kept, 0, sizeof kept);
    struct output *output = session->output, *end = output_end(output);
    struct answer answer = {
        .out = output->out,
        .path = output->path,
        .appended = output->append,
        .style = state_style(query->state),
        .command = c->name,
        .note = c->train && session->state.scene.effect[DOM_EFFECT_row].on ? TRAIN_NOTE : NULL,
        .head = end->head,
        .columns = c->columns,
        .rows = c->rows,
        .blank_above = end->answered && session->source,
        .kept = c->principal ? kept : NULL,
    };
    if (output->format)
        answer.style.format = output->format;
    problem->place = 0;
    double begun = session->state.settings.timing ? terminal_clock() : 0;
    progress_begin();
    bool draws = answer.path && c->picture && ending_of(answer.path)->kind == ENDING_PICTURE;
    bool shown = c->draws && !c->files && answer.style.format->for_people && !answer.path;
    bool done = shown && !picture_fits(&answer, c->name, problem) ? false
                : c->act ? c->act(session, query->given, &answer, problem)
                : draws  ? c->picture(query, &answer, problem)
                         : c->run(query, &answer, problem);
    progress_end();
    session->fresh = session->fresh && done && !c->columns;
    if (done && answer.note)
        say_train(session, &answer);
    const char *unsaid = done ? answer_end(&answer) : NULL;
    if (unsaid)
        session_note(session, "%s", unsaid);
    session->wrote = answer.has_rows;
    end->answered = end->answered || (done && c->columns) || answer.told;
    end->error = answer.error ? answer.error : end->error;
    if (done && answer.is_value) {
        session->ans.printed = true;
        session->ans.value = answer.value;
    } else if (done && c->principal) {
        session->ans.printed = false;
        session->ans.command = c;
        memcpy(session->ans.cells, kept, sizeof kept);
    }
    if (done && session->state.settings.timing && c->columns) {
        /* Programs that read csv or json find it where it does not disturb. */
        bool people = answer.style.format->for_people && !answer.path;
        fprintf(people ? answer.out : stderr, "time: %.6g ms\n", 1e3 * (terminal_clock() - begun));
    }
    return done;
}

/* Runs a command whose answer may be longer than the terminal: a help page, or any answer at the prompt. */
static bool run_paged(struct session *session, const struct command *c, const struct query *query,
                      struct problem *problem)
{
    if (!c->pages && !(session->prompt_width && c->columns && !c->draws && !c->runs))
        return run_call(session, c, query, problem);
    const volatile sig_atomic_t *interrupt = session->state.scene.compute.interrupt;
    int error = output_end(session->output)->error;
    bool paged = pager_push(&session->output, c->pages ? 1 : 1.5, !session->means.safe, interrupt);
    bool done = run_call(session, c, query, problem);
    const char *left = paged ? output_pop(&session->output, true) : NULL;
    if (left) { /* the answer was not lost: it was read as far as the reader wanted */
        output_end(session->output)->error = error;
        if (dom_raised(interrupt))
            problem_status(problem, &session->state.scene, DOM_INTERRUPTED);
    }
    return done;
}

/* Reports an error where the ending of a file does not fit what the command writes. */
static bool ending_fits(const struct command *c, const char *path, struct problem *problem)
{
    char shown[NAMES_SHOWN];
    const struct ending *ending = ending_of(path);
    bool draws = c->draws || c->picture;
    switch (ending->kind) {
    case ENDING_PICTURE:
        return draws ||
               problem_error(problem,
                             "'%s' is the name of a picture, and '%s' draws none; 'draw' and 'plot' do",
                             names_shown(path, shown), c->name);
    case ENDING_DATA:
        return c->columns || c->runs || c->pages ||
               problem_error(problem,
                             "'%s' is the name of data, and '%s' answers with none; '%s > FILE.txt' "
                             "writes what it says",
                             names_shown(path, shown), c->name, c->name);
    case ENDING_OTHER:
        return problem_error(problem, "no format has the ending of '%s'; use %s", names_shown(path, shown),
                             c->draws     ? ".svg, .png, .pdf or .txt, or .csv or .json for its data"
                             : c->picture ? ".csv, .json or .txt, or for a picture .svg, .png or .pdf"
                             : c->columns || c->runs ? ".csv, .json or .txt"
                                                     : ".txt");
    case ENDING_NONE:
    case ENDING_TEXT:
        break;
    }
    return true;
}

/* Runs a command whose answer goes to the file after '>' or '>>', in the format of the file's ending. */
static bool run_redirected(struct session *session, struct reader *r, const struct command *c,
                           const struct query *query)
{
    struct problem *problem = r->problem;
    const volatile sig_atomic_t *interrupt = session->state.scene.compute.interrupt;
    bool append = r->at[1] == '>';
    r->at = skip_blanks(r->at + (append ? 2 : 1));
    reader_place(r, r->at);
    char *path = read_file(r), shown[NAMES_SHOWN];
    r->at = skip_blanks(r->at);
    const char *wrong = NULL;
    bool done = false;
    if (!path)
        problem_error(problem, "%s", unclosed);
    else if (!*path)
        problem_error(problem, "the file after '>' is missing; for example 'show > FILE'");
    else if (!command_ends(r->at))
        problem_error(problem,
                      "only one word can follow '>'; put a file name with blanks between double quotes");
    else if (session->means.safe)
        problem_error(problem, "a safe session cannot read or write files");
    else if (!ending_fits(c, path, problem))
        done = false; /* which was reported */
    else if ((wrong = file_push(&session->output, path, append, interrupt)) != NULL)
        problem_error(problem, "cannot write '%s': %s", names_shown(path, shown), wrong);
    else {
        const struct ending *ending = ending_of(path);
        session->output->format = ending->kind == ENDING_PICTURE
                                      ? &format_table /* for people, also with 'set output csv' */
                                      : ending->format;
        session->output->is_head = session_answers(session)->is_head;
        done = run_call(session, c, query, problem);
        wrong = output_pop(&session->output, done);
        if (done && wrong)
            done = problem_error(problem, "cannot write '%s': %s", names_shown(path, shown), wrong);
    }
    return done;
}

/*
 * Returns true if a program is to get an object of a command that gave no answer.  Parts of a sweep
 * concatenate to the whole: there the first one writes such objects, and none for a part without points.
 */
static bool is_silent(const struct session *session, const struct command *c, bool file)
{
    const struct shard *shard = &session->means.shard;
    bool due = shard->parts == 0 || (shard->part == 1 && !c->rows);
    bool sourced = c->runs && c->argument[0].kind == ARGUMENT_FILE; /* which writes its answers before */
    return due && (file || sourced || !session->wrote);
}

/* Binds the arguments of a command and runs it. */
static bool run_question(struct session *session, struct reader *r, const struct question *q,
                         bool is_redirected)
{
    struct call call;
    struct query query = *r->query;
    query.next = &session->state;
    bool done = question_bind(q, &query, &call, r->problem);
    if (done)
        done = is_redirected ? run_redirected(session, r, q->command, &call.query)
                             : run_paged(session, q->command, &call.query, r->problem);
    call_free(&call);
    return done;
}

/* Runs the command at the reader, which moves on behind it. */
static void run_command(struct session *session, struct reader *line)
{
    struct reader reader = *line, *r = &reader;
    const char *begin = r->at;
    fflush(output_base(session->output)->out); /* no answer waits for the next one */
    struct problem problem;
    problem_begin(&problem, NULL);
    const struct query query = session_query(session);
    r->query = &query;
    r->problem = &problem;
    struct question q;
    if (command_parse(r, &q)) {
        /* A program that waits for an answer gets one also where there is none to give. */
        const struct command *c = q.command;
        const struct format *format = session_answers(session);
        session->command = c->name;
        /* A file that is sourced is one change. */
        bool changes = c->changes && session->depth == 0;
        struct state *before = changes ? undo_begin(&session->state) : NULL;
        bool file = *r->at == '>';
        bool done = run_question(session, r, &q, file);
        bool same = session_answers(session) == format; /* 'set output' itself answers nothing */
        if (done && same && format->done && is_silent(session, c, file))
            format->done(session->output->out, c->name);
        if (changes)
            undo_keep(&session->undo, &session->state, before, begin, (size_t)(text_end(begin, ";") - begin));
    }
    if (problem.kind != PROBLEM_NONE)
        session_problem(session, &problem);
    session->command = NULL;
    line->at = r->at;
}

/* Writes what waits for log and tee, so that a crash loses nothing of them. */
static void records_write(struct session *session)
{
    const char *wrong = records_flush(&session->output);
    if (wrong)
        session_error(session, "the record ends here, since its file cannot be written: %s", wrong);
}

static void run_line(struct session *session, const char *line, size_t length)
{
    struct text text;
    if (length > TEXT_MOST) {
        session_error(session, "the line is longer than %d MB; put its commands on lines of their own",
                      TEXT_MOST >> 20);
        return;
    }
    if (!text_make(&text, line, length)) {
        session_error(session, "out of memory");
        return;
    }
    struct arena arena = {.block = NULL};
    struct reader r = {.text = &text, .at = text.line, .arena = &arena};
    /* What a file commands is in that file. */
    bool logged = output_find(&session->output, OUTPUT_LOG) && session->depth == 0;
    if (logged) /* where there are several commands, one may fail after others have run */
        log_commands(&session->output, line, length, *text_end(text.line, ";") == ';');
    session->typed = line;
    session->typed_length = (int)(length < INT_MAX ? length : INT_MAX);
    session->typed_columns = text_column(&text, text.line + strlen(text.line)) - 1;
    for (;;) {
        long errors = session->errors;
        const char *begin = skip_blanks(r.at), *end = text_end(begin, ";");
        if (begin < end) {
            r.at = begin;
            run_command(session, &r);
            arena_free(&arena);
            /* Where reading came to the end of the command, that is it: 'complete LINE' takes the rest, and
             * in the middle of a word a '"' is a letter. */
            end = r.at > end || command_ends(r.at) ? r.at : end;
        }
        if (*end != ';' || session_stops(session, errors))
            break;
        r.at = end + 1;
        if (!logged && output_find(&session->output, OUTPUT_LOG) && session->depth == 0) { /* begun here */
            const char *rest = text_typed(&text, skip_blanks(r.at));
            log_commands(&session->output, rest, length - (size_t)(rest - line), true);
            logged = true;
        }
    }
    records_write(session);
    session->typed = NULL;
    text_free(&text);
}

/* Forgets a SIGINT that came before these commands, or has ended them, where it does not end the script. */
static void resume(struct session *session)
{
    if (session->resumes && session->depth == 0 && *session->resumes == SIGINT)
        *session->resumes = 0;
}

void command_run_text(struct session *session, const char *text)
{
    resume(session);
    for (bool more = true; more;) {
        long errors = session->errors;
        size_t length = strcspn(text, "\n");
        run_line(session, text, length);
        more = text[length] != '\0' && !session_stops(session, errors);
        text += length + 1;
        session->line += more;
    }
    resume(session);
}
