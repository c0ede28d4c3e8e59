/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands about the session itself. */
#include "commands/tables.h"
#include "interpreter/command.h"
#include "interpreter/line.h"
#include "io/io.h"
#include "io/redirect.h"
#include "language/quad.h"
#include "session/effects.h"
#include <errno.h>
#include <string.h>

/* The parameter that the i-th argument names. */
static const struct parameter *parameter_of(const struct call *call, int i)
{
    return &session_parameters[(int)call->number[i]];
}

static bool choose_precision(struct session *session, const struct call *call, enum dom_precision precision)
{
    if (domq_arithmetic(precision)->bits == 0)
        return session_error(session, "%s: %s", domq_arithmetic(precision)->name,
                             dom_status_text(DOM_NO_PRECISION));
    /* A file that is sourced goes on to say what it wants. */
    if (session_precision(session, precision) && session->depth == 0)
        answer_say(call->answer, "tol is now %g", (double)session->compute.tol);
    return true;
}

static bool run_set(struct session *session, const struct call *call)
{
    const struct parameter *p = parameter_of(call, 0);
    if (strcmp(p->name, "precision") == 0)
        return choose_precision(session, call, (enum dom_precision)call->number[1]);
    if (strcmp(p->name, "fuel") == 0 && call->number[1] == DOM_FUEL_PAPER && session->train.mu > 0)
        return session_error(
            session, "the paper's closed form of the fuel knows no friction: they exclude each other; "
                     "'effect friction off' first");
    parameter_put(session, p, call->number[1]);
    return true;
}

static const struct column show_columns[] = {
    {"name", "", "what 'set' calls it", 9},
    {"value", "", "its value now", 12},
    {"unit", "", "h: heights of the domino", 5},
    {"range", "", "the values that it may have", 17},
    {"default", "", "its value at the start", 8},
    {"meaning", "", "what it stands for", 24},
    {NULL, NULL, NULL, 0},
};

enum { SHOW_COLUMNS = sizeof show_columns / sizeof *show_columns };

/* A parameter as it is shown: the cells of its row, and the words in them. */
struct shown {
    char range[64], value[WIDE_TEXT], fallback[WIDE_TEXT];
    struct cell cell[SHOW_COLUMNS];
};

static void shown_make(const struct session *session, const struct parameter *p, struct shown *shown)
{
    domq_real value = parameter_get(session, p), fallback = parameter_fallback(session, p);
    bool words = session->style.output == OUTPUT_TABLE || p->words_only;
    parameter_range(session, p, shown->range, sizeof shown->range);
    parameter_text(p, value, (int)session->style.digits, shown->value, sizeof shown->value);
    parameter_text(p, fallback, 6, shown->fallback, sizeof shown->fallback);
    const struct cell cells[] = {cell_word(p->name),
                                 words ? cell_word(shown->value) : cell_real(value),
                                 cell_word(p->unit),
                                 cell_word(shown->range),
                                 words ? cell_word(shown->fallback) : cell_real(fallback),
                                 cell_word(p->meaning)};
    memcpy(shown->cell, cells, sizeof cells);
}

static bool run_show(struct session *session, const struct call *call)
{
    struct column fitted[SHOW_COLUMNS];
    struct shown shown;
    memcpy(fitted, show_columns, sizeof fitted);
    for (int pass = 0; pass < 2; pass++) {
        for (const struct parameter *p = session_parameters; p->name; p++) {
            if (call->count == 1 && p != parameter_of(call, 0))
                continue;
            shown_make(session, p, &shown);
            for (int i = 0; pass == 0 && fitted[i + 1].key; i++) /* the last one is wrapped */
                if (shown.cell[i].kind == CELL_WORD)
                    column_fit(&fitted[i], shown.cell[i].word);
            if (pass == 1)
                answer_row(call->answer, shown.cell, NULL);
        }
        call->answer->columns = pass == 0 ? fitted : show_columns;
    }
    return true;
}

static bool run_reset(struct session *session, const struct call *call)
{
    const struct parameter *p;
    for (int k = 0; (p = parameter_in_order(k)) != NULL; k++) {
        if (call->count == 1 ? p != parameter_of(call, 0) : p->setting)
            continue;
        if (strcmp(p->name, "precision") == 0)
            session_precision(session, DOM_DOUBLE);
        else
            parameter_put(session, p, parameter_fallback(session, p));
    }
    if (call->count == 0)
        effects_reset(session);
    return true;
}

static bool run_save(struct session *session, const struct call *call)
{
    struct redirect file;
    char shown[NAMES_SHOWN], value[WIDE_TEXT];
    const struct parameter *p;
    if (!effects_savable(session))
        return false;
    const char *wrong = redirect_open(&file, call->word[0], false, session->compute.interrupt);
    if (!wrong) {
        fprintf(file.file, "# A session of domino " DOM_VERSION ": 'source' it, or 'domino -f' it.\n");
        effects_save_off(session, file.file);
        for (int k = 0; (p = parameter_in_order(k)) != NULL; k++) {
            parameter_text(p, parameter_get(session, p), WIDE_DIGITS, value, sizeof value);
            fprintf(file.file, "set %s %s\n", p->name, value);
        }
        effects_save(session, file.file);
        wrong = redirect_close(&file, true);
    }
    return !wrong ||
           session_error(session, "cannot write '%s': %s", names_shown(call->word[0], shown), wrong);
}

static bool run_source(struct session *session, const struct call *call)
{
    char shown[NAMES_SHOWN];
    const char *name = call->word[0];
    if (session->depth == SOURCE_DEPTH)
        return session_error(session, "files are nested %d deep; does one source itself?", SOURCE_DEPTH);
    FILE *in = io_read(name, session->compute.interrupt);
    if (!in)
        return session_error(session, "cannot read '%s': %s", names_shown(name, shown), strerror(errno));
    long errors = session->errors;
    session->depth++;
    line_stream(session, in, name);
    session->depth--;
    fclose(in);
    return session->errors == errors;
}

static const struct column print_columns[] = {
    {"value", "", "in SI units, and the unit of angles", 0},
    {"unit", "", "", 6},
    {NULL, NULL, NULL, 0},
};

static bool run_print(struct session *session, const struct call *call)
{
    struct quantity q = call->quantity[0];
    char unit[48], number[WIDE_TEXT];
    expression_unit_text(q, unit, sizeof unit);
    if (q.length == 0 && q.time == 0 && q.angle == 1) {
        q.value = style_angle(&session->style, q.value);
        snprintf(unit, sizeof unit, "%s", style_angle_unit(&session->style));
    }
    if (answer_for_people(call->answer))
        answer_say(call->answer, "%s%s%s", quad_text(q.value, (int)call->answer->style.digits, number),
                   *unit ? " " : "", unit);
    else
        answer_row(call->answer, ROW(cell_unbounded(q.value), cell_word(unit)), NULL);
    return true;
}

static bool run_quit(struct session *session, const struct call *call)
{
    (void)call;
    session->quit = true;
    return true;
}

const struct command session_commands[] = {
    {.name = "set",
     .argument = {{.name = "NAME", .kind = ARGUMENT_PARAMETER}, {.name = "VALUE", .kind = ARGUMENT_VALUE}},
     .summary = "give a parameter a value",
     .help =
         "VALUE is one of the parameter's words (hollow, json) or an expression: 7/48, 4.8 cm, 0.9*s, rmax. "
         "Each value is judged alone; whether r s <= 1 holds is seen when a command needs it.",
     .example = "set d 7 mm / 48 mm; set r 0.99*rmax; show r",
     .see = "show reset",
     .run = run_set},
    {.name = "show",
     .argument = {{.name = "NAME", .kind = ARGUMENT_PARAMETER, .optional = true}},
     .summary = "the parameters: value, unit, range, default, meaning",
     .example = "show fuel",
     .see = "set reset",
     .columns = show_columns,
     .rows = true,
     .run = run_show},
    {.name = "reset",
     .argument = {{.name = "NAME", .kind = ARGUMENT_PARAMETER, .optional = true}},
     .summary = "the parameter NAME, or all of the model, to the defaults",
     .help = "Without NAME the settings of the session are kept: output, digits, angle, timing.",
     .example = "set s 0.3; reset s; print s",
     .see = "set show",
     .run = run_reset},
    {.name = "print",
     .argument = {{.name = "VALUE", .kind = ARGUMENT_ANY}},
     .summary = "the value of an expression",
     .help = "Numbers, + - * / ^ and parentheses; units m mm cm km in ft s ms rad deg; pi; sin cos tan asin "
             "acos "
             "atan atan2 exp ln log log10 sqrt abs floor ceil round hypot min max; the parameters; 'ans' and "
             "'ans.KEY', the last answer; commands, with a key or without: rmax, rmax(0.3).r_max_paper.",
     .example = "print ln(112 m / h) / ln(rmax)",
     .see = "set",
     .columns = print_columns,
     .run = run_print},
    {.name = "save",
     .argument = {{.name = "FILE", .kind = ARGUMENT_FILE}},
     .summary = "write the parameters into FILE, for 'source'",
     .see = "source",
     .files = true,
     .run = run_save},
    {.name = "source",
     .argument = {{.name = "FILE", .kind = ARGUMENT_FILE}},
     .summary = "run the commands in FILE",
     .see = "save",
     .files = true,
     .run = run_source},
    {.name = "exit", .summary = "the same as quit", .see = "quit", .run = run_quit},
    {.name = "quit", .summary = "leave; so does the end of the input (^D)", .run = run_quit},
    {.name = NULL},
};
