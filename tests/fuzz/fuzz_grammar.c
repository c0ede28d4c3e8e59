/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Runs sessions of grammatical lines, which are generated from the program's tables of commands. The input
 * bytes choose the command, each argument according to its kind, and expressions in which any command may be
 * a function. Half of the sessions may not use files. The others do so in a scratch folder, and no file name
 * leads out of it. See 'make fuzz'.
 */
#include "interpreter/command.h"
#include "interpreter/question.h"
#include "session.h"
#include <dirent.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* The remaining bytes, and the line that is being written. */
struct maker {
    const uint8_t *data;
    size_t size;
    unsigned at;
    FILE *line;
};

/* Returns a number below n, or 0 if no bytes are left. n is at most 256. The number also depends on the
 * position of the byte, so that repeated bytes do not repeat the line. */
static unsigned pick(struct maker *m, unsigned n)
{
    if (m->size == 0)
        return 0;
    m->size--;
    return (*m->data++ + 37 * m->at++) % 256 % n;
}

static void put(const struct maker *m, const char *text)
{
    fputs(text, m->line);
}

/* Writes one of several texts, which a '|' separates. */
static void put_one(struct maker *m, const char *texts)
{
    unsigned n = 1;
    for (const char *c = texts; *c; c++)
        n += *c == '|';
    for (unsigned k = pick(m, n); k > 0; k--)
        texts = strchr(texts, '|') + 1;
    fprintf(m->line, "%.*s", (int)strcspn(texts, "|"), texts);
}

/* Writes one name of a list, sometimes shortened or with one more letter. */
static const char *put_name(struct maker *m, names_list *list, const void *context)
{
    unsigned n = 0;
    while (list(context, (int)n))
        n++;
    const char *name = n ? list(context, (int)((pick(m, 256) * 256 + pick(m, 256)) % n)) : "";
    unsigned way = pick(m, 32);
    fprintf(m->line, "%.*s%s", way == 1 ? 2 : 100, name, way == 2 ? "x" : "");
    return name;
}

/* ---- Expressions ---- */

static void put_expression(struct maker *m, int depth);

static void put_number(struct maker *m)
{
    if (pick(m, 4))
        fprintf(m->line, "%u.%u", pick(m, 8) / 4, pick(m, 256));
    else
        put_one(
            m, "0|1|2|3|0.5|0.1|1.5|0.999|1e-9|1e-12|7/48|10|100|1e6|1e9|1e30|1e39|1e308|1e400|1e4000|1e4932|"
               "1e-39|1e-320|1e-4900|4294967295|10000000|0x10|.5|5.|1e|99|1.7976931348623157e308|3.4e38");
}

static void put_call(struct maker *m, int depth)
{
    unsigned n = pick(m, 4);
    put(m, "(");
    for (unsigned i = 0; i < n; i++) {
        put(m, i ? ", " : "");
        put_expression(m, depth + 1);
    }
    put(m, ")");
}

static void put_value(struct maker *m, int depth)
{
    const char *name;
    switch (pick(m, 8)) {
    case 0: /* any command, with or without a key */
        name = put_name(m, command_names, NULL);
        if (pick(m, 2))
            put_call(m, depth);
        if (pick(m, 3) == 0) {
            put(m, ".");
            put_name(m, command_keys, command_find(name) ? command_find(name) : command_find("rmax"));
        }
        break;
    case 1:
        put_name(m, value_names, NULL);
        if (pick(m, 2))
            put_call(m, depth);
        break;
    case 2:
        put(m, "ans.");
        put_name(m, command_keys, command_find("rmax"));
        break;
    case 3:
        put_name(m, parameter_names, NULL);
        break;
    default:
        put_number(m);
        if (pick(m, 6) == 0) {
            put(m, " ");
            put_name(m, expression_units, NULL);
        }
    }
}

static void put_expression(struct maker *m, int depth)
{
    switch (depth > 4 ? 0 : pick(m, 8)) {
    case 1:
        put(m, "(");
        put_expression(m, depth + 1);
        put(m, ")");
        break;
    case 2:
        put_expression(m, depth + 1);
        put_one(m, " + |-|*|/|^| - |\xe2\x88\x92|\xc3\x97");
        put_expression(m, depth + 1);
        break;
    case 3:
        put(m, "-");
        put_expression(m, depth + 1);
        break;
    default:
        put_value(m, depth);
    }
}

/* ---- Arguments ---- */

/* None of these names leads out of the folder, since they contain no '/' and no '~'. */
static void put_file(struct maker *m)
{
    put_one(m,
            "row.csv|\"row.csv\"|\"a \"\"b\"\".csv\"|s.dom|s.dom|a.txt|a.svg|\"a b.csv\"|a.csv|gone|-|a.gif|"
            "\"\x1b[31m\"|\"\xff\x9b.csv\"|\"\xe2\x80\xae.csv\"|\xce\xb8.csv");
}

static void put_parameter_value(struct maker *m, const struct parameter *p)
{
    if (p && p->words && pick(m, 4))
        put_name(m, parameter_words, p);
    else if (p && p->effect && pick(m, 2))
        put_one(m, "1 mm|3|row.csv|\"a \"\"b\"\".csv\"");
    else if (p && pick(m, 2)) {
        domq_real lowest = p->value->lowest, highest = p->value->highest;
        fprintf(m->line, "%.17g", (double)(lowest + (highest - lowest) * pick(m, 256) / 255));
    } else
        put_expression(m, 0);
}

static void put_command(struct maker *m, const struct command *c, int depth);

static const char *swept_names(const void *context, int k)
{
    const char *name;
    for (int i = 0; (name = command_names(context, i)) != NULL; i++)
        if (command_find(name)->columns && k-- == 0)
            return name;
    return NULL;
}

/* Writes some of the names that an argument allows, each with up to four numbers. */
static void put_grid(struct maker *m, names_list *names)
{
    for (unsigned axes = 1 + pick(m, 3); axes > 0; axes--) {
        put_name(m, names, NULL);
        for (unsigned n = 1 + pick(m, 4), list = pick(m, 2); n > 0; n--) {
            put(m, " ");
            if (pick(m, 4))
                put_number(m);
            else
                put_expression(m, 2);
            put(m, list && n > 1 ? "," : "");
        }
        put(m, pick(m, 4) ? " " : " log ");
    }
}

static void put_argument(struct maker *m, const struct argument *a, const struct parameter **named, int depth)
{
    switch (a->kind) {
    case ARGUMENT_VALUE_OF:
        put_parameter_value(m, parameter_find(a->parameter));
        break;
    case ARGUMENT_VALUE:
        put_parameter_value(m, *named);
        break;
    case ARGUMENT_COUNT:
        if (pick(m, 4))
            fprintf(m->line, "%u", pick(m, 256));
        else
            put_expression(m, 0);
        break;
    case ARGUMENT_PARAMETER:
        *named = parameter_find(put_name(m, parameter_names, NULL));
        break;
    case ARGUMENT_CHOICE:
    case ARGUMENT_PLACE:
        if (pick(m, 4))
            put_name(m, a->choices, NULL);
        else
            put_expression(m, 0);
        break;
    case ARGUMENT_REST:
        put_one(m, "barrier|\"a b\"|\"|\"\x1b[3m\"|\xc2\x9b|\xff|x\ty|#|on");
        break;
    case ARGUMENT_FILE:
        put_file(m);
        break;
    case ARGUMENT_UNIT:
        put(m, pick(m, 8) ? "to " : "ti ");
        put_name(m, expression_units, NULL);
        break;
    case ARGUMENT_GRID:
        put_grid(m, a->choices ? a->choices : parameter_names);
        break;
    case ARGUMENT_WORDS:
        if (pick(m, 2))
            put_name(m, a->choices ? a->choices : topic_names, NULL);
        else
            put_expression(m, 0);
        break;
    case ARGUMENT_COMMAND:
        if (a->choices && depth == 0) {
            put_command(m, command_find(put_name(m, a->choices, NULL)), 1);
            break;
        }
        put(m, ": ");
        if (pick(m, 2)) {
            put_expression(m, 0);
            put(m, " = ");
            put_expression(m, 0);
        } else if (depth == 0)
            put_command(m, command_find(put_name(m, swept_names, NULL)), 1);
        break;
    default:
        put_expression(m, 0);
    }
}

/* Writes the arguments of a command after its name. */
static void put_command(struct maker *m, const struct command *c, int depth)
{
    const struct parameter *named = NULL;
    for (int i = 0; c && i < ARGUMENTS_MAX && c->argument[i].kind; i++) {
        if (c->argument[i].optional && pick(m, 3) == 0)
            break;
        put(m, " ");
        put_argument(m, &c->argument[i], &named, depth);
    }
}

/* Writes a line that does not begin with a command: an expression, an assignment, a definition or a
 * question. */
static void put_form(struct maker *m)
{
    switch (pick(m, 4)) {
    case 0:
        put_name(m, parameter_names, NULL);
        put(m, pick(m, 4) ? " = " : " ? ");
        break;
    case 1:
        put_one(
            m, "let x = |x = |let y = |let f(s) = |let f(a) = f(a)*|let k(a, b) = a*f(b) + |k(1, |f(|f(x) + |"
               "let k(a,a) = |? ");
        break;
    case 2:
        put(m, pick(m, 2) ? "undo; redo; " : "undo; undo; ");
        break;
    default:
        break;
    }
    put_expression(m, 0);
    put(m, pick(m, 6) ? "" : pick(m, 2) ? ")" : " to mm");
}

static void put_line(struct maker *m)
{
    unsigned way = pick(m, 8);
    /* One line in eight is a setting, because settings affect all later lines. */
    if (way == 0)
        put_one(m,
                "set output json|set output csv|set output json|set precision float|set precision quad|set "
                "errors on|"
                "effect row 3|set angle deg|effect row row.csv|effect friction 0.2|effect walls 1 mm|"
                "effect floor 0.1|effect placement 1 mm|set r 1e6; effect row 60|set s 1; set r 1|set h 1e9");
    else if (way == 1)
        put_form(m);
    else
        put_command(m, command_find(put_name(m, command_names, NULL)), 0);
    if (pick(m, 8) == 1) {
        put(m, pick(m, 2) ? " > " : " >> ");
        put_file(m);
    }
    put_one(m, "\n|\n|\n|\n|\n|\n|\n|\n|\n|\n|\n|\n|; | # what\n|\r\n");
}

/* ---- The scratch folder ---- */

static char scratch[] = "/tmp/domino-fuzz-XXXXXX";

static void scratch_clean(void)
{
    DIR *folder = opendir(".");
    for (const struct dirent *entry; folder && (entry = readdir(folder)) != NULL;)
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0)
            unlink(entry->d_name);
    if (folder)
        closedir(folder);
}

/* Restores the initial state of the folder, which holds two csv files. */
static void scratch_fill(void)
{
    static const char *const names[] = {"row.csv", "a \"b\".csv"};
    scratch_clean();
    for (int k = 0; k < 2; k++) {
        FILE *row = fopen(names[k], "w");
        if (!row)
            abort();
        fputs("height (mm), thickness (mm), gap (mm)\n48, 7, -\n48, 7, 20\n60, 8, 25\n", row);
        fclose(row);
    }
}

static void scratch_remove(void)
{
    scratch_clean();
    rmdir(scratch);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static bool there;
    char *text = NULL;
    size_t length = 0;
    if (!there && (!mkdtemp(scratch) || chdir(scratch) != 0 || atexit(scratch_remove) != 0))
        abort();
    there = true;
    features_register(every_feature);
    scratch_fill();
    struct maker m = {.data = data, .size = size, .line = open_memstream(&text, &length)};
    if (!m.line)
        abort();
    bool safe = pick(&m, 2) == 0;
    /* Every session begins with commands as functions, so that each command soon occurs. */
    for (int functions = 0; functions < 4; functions++) {
        put(&m, "print ");
        put_name(&m, command_names, NULL);
        put_call(&m, 4);
        put(&m, "\n");
    }
    for (int lines = 0; m.size > 0 && lines < 12; lines++)
        put_line(&m);
    fclose(m.line);
    if (getenv("FUZZ_SHOW")) /* prints a failing input */
        fwrite(text, 1, length, stderr);
    if (length > 0)
        fuzz_session(text, length, safe);
    free(text);
    return 0;
}
