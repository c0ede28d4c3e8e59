/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands and features. Each command is one entry of a table. The entry says everything about the command:
 * its syntax, its help, what completion offers, and which value the command has in an expression. */
#pragma once

#include "language/names.h"
#include "language/text.h"
#include "session/parameters.h"
#include "session/query.h"
#include "session/row.h"

/* The kind of an argument determines how it is parsed and checked, and what completion offers. */
enum argument_kind {
    ARGUMENT_NONE,
    /* Arguments that are expressions: */
    ARGUMENT_TILT,     /* an angle in [0, theta_c] */
    ARGUMENT_VALUE_OF, /* a value of the parameter that argument.parameter names */
    ARGUMENT_HEIGHT,   /* a length > 0 */
    ARGUMENT_COUNT,    /* an integer in 1 .. COUNT_MAX */
    ARGUMENT_ANY,      /* a value in any unit */
    ARGUMENT_NUMBER,   /* a plain number */
    /* An angle in [0, theta_c], or one of the choices. Choice number k is stored as -1 - k, which is not an
     * angle in this range. */
    ARGUMENT_PLACE,
    /* Arguments that are words or names: */
    ARGUMENT_CHOICE,    /* one of the choices, stored as its index */
    ARGUMENT_PARAMETER, /* the name of a parameter; variables are accepted if no ARGUMENT_VALUE follows */
    ARGUMENT_VALUE,     /* a value of the parameter that an earlier argument names, or a file */
    ARGUMENT_FILE,      /* a path, in double quotes if it contains blanks */
    ARGUMENT_REST,      /* the rest of the line, unparsed, including any ';' */
    /* Arguments that are parsed by a function of their own (argument.parse): */
    ARGUMENT_GRID,    /* parameter names, each followed by values */
    ARGUMENT_COMMAND, /* a command that computes something, after an optional ':' */
    ARGUMENT_WORDS,   /* words and values, as far as argument.parse reads */
    ARGUMENT_UNIT,    /* the word "to" followed by a unit */
};

#define COUNT_MAX 10000000

struct reader;
struct question;
struct arguments;
struct session;

struct argument {
    const char *name;
    enum argument_kind kind;
    const char *parameter; /* for ARGUMENT_VALUE_OF: the name of the parameter */
    int which; /* for ARGUMENT_VALUE_OF: the index of the value, if the parameter has several values */
    /* The noun in messages, such as "picture". For an ARGUMENT_ANY with a noun, completion offers no values.
     */
    const char *noun;
    bool optional;
    names_list *choices;
    /* For the kinds from ARGUMENT_GRID on, which have a syntax of their own: `parse` reads the argument and
     * stores its result in question->parsed, from which `bind` computes given->bound. */
    bool (*parse)(struct reader *reader, struct question *question);
    bool (*bind)(const struct question *question, const struct query *query, struct arguments *given,
                 struct problem *problem);
};

enum { ARGUMENTS_MAX = 4 };

/* The arguments of a command after all their expressions have been evaluated. */
struct arguments {
    int count;
    domq_real number[ARGUMENTS_MAX];
    struct quantity quantity[ARGUMENTS_MAX]; /* the elements of `number` with their units */
    const char *word[ARGUMENTS_MAX];
    int column[ARGUMENTS_MAX]; /* the column of each argument in the typed line, for messages */
    void *bound;               /* the result of argument.bind */
    struct arena memory;       /* for arguments_take */
    const struct question *question;
};

/* A command. Strings and pointers that a command does not need are NULL. */
struct command {
    const char *name;
    struct {
        /* Two words for this command, such as "step back". Help shows them instead of the name. In its table,
         * the command follows the one whose name is the first word, or others with the same first word. */
        const char *phrase;
        /* The command with the same first argument that replaces this one if its name follows that argument,
         * as in "count 112 m fewest". */
        const char *variant;
        bool is_hidden; /* help and completion do not mention the command, which remains for scripts */
    } typed;
    struct argument argument[ARGUMENTS_MAX];
    const char *summary;  /* one line */
    const char *synonyms; /* other words that users may look for, separated by blanks */
    const char *equation; /* the numbers of the paper's equations */
    const char *help;     /* the text that 'help' shows below the summary */
    const char *example;
    const char *see; /* related commands */
    const struct column *columns;
    /* For a command whose columns depend on its first argument: returns the columns for value k of it, and
     * stores its name and summary. Returns NULL after the last value. */
    const struct column *(*parts)(int k, const char **name, const char **summary);
    const char *principal; /* the key of the column that holds the value of the command in expressions */
    bool rows;             /* the answer is a table that may have several rows */
    /* The keys of the columns that an answer for people shows, or "*" for all; 'details' prints the rest.
     * NULL if the answer is whole without 'details'. */
    const char *brief;
    struct {
        /* The parameter whose value a column of the answer only repeats, such as "s", or NULL. A sweep over
         * this parameter leaves the column out, unless an argument replaces the value, as in 'rmax 0.4'. */
        const char *echo;
        /* The key of the last column if it takes long to compute, or NULL. Sweeps leave it out, and
         * expressions can use it only as a column of 'ans'. */
        const char *slow_column;
        /* Why sweeps and searches refuse this command although it has columns, worded for the message "'plot'
         * cannot be swept: it draws", or NULL. */
        const char *refusal;
        /* The numbers suppose that the verdict is yes, so a search for the best number leaves out places
         * where it is no (run_context.seeks_yes). */
        bool needs_yes;
    } sweep;
    /* Returns true if energies are in J because masses are known in this scene; otherwise their unit is
     * "mgh/2". NULL for a command whose units do not depend on the scene. */
    bool (*in_joules)(const struct scene *scene);
    bool train;    /* the answer is about the endless train */
    bool is_print; /* the answer is the value of an expression, and messages leave out the name */
    enum {
        PRECISION_MIXED,
        /* The whole answer is in the precision of the session, so its numbers have errors: their differences
         * from a computation in quad precision. */
        PRECISION_AS_SET,
        PRECISION_DOUBLE, /* the answer is computed in double, whatever the precision of the session is */
    } precision;
    enum {
        WRITES_DATA,
        WRITES_PICTURES, /* in csv and json: the data of a picture */
        WRITES_FILMS,
        WRITES_PAGES,   /* text that has data in csv and json, although it has no columns */
        WRITES_SCRIPTS, /* a script, to the file that is the command's first argument */
    } writes;
    /* For a yes-or-no question: the statement that is true if the answer is yes (see answer_set_verdict). */
    const char *holds;
    /* What the command uses besides its query: */
    struct {
        bool runs;  /* it runs other commands, whose answers go to the same output */
        bool files; /* it reads or writes files, so a safe session refuses to run it */
        /* it may change parameters, effects, the row or variables, and 'undo' can revert the change */
        bool changes;
    } access;
    /* Computes the answer to a query and stores any new state in query->next. On failure, sets *problem and
     * returns false. */
    bool (*run)(const struct query *query, struct answer *answer, struct problem *problem);
    /* Called instead of `run` if the command needs the whole session, not only its state. */
    bool (*act)(struct session *session, const struct arguments *given, struct answer *answer,
                struct problem *problem);
};

/* The columns and the function of a command that prints an answer, both named after the command. */
#define ANSWER(name_) .columns = name_##_columns, .run = run_##name_

struct command_group {
    const char *title;
    const char *word;               /* the word that 'help' accepts; groups that share it follow each other */
    const struct command *commands; /* the name of the last element is NULL */
};

/* ---- Features ---- */

/* A line to type in the first five minutes, for 'help'. Lines appear in the order of their places. */
struct first_line {
    int place;
    const char *line, *does;
    bool greets; /* also suggested when a session begins */
};

/* A feature is a part of the program that a build can leave out: a folder of src/ with a feature.mk, which
 * names the features that it needs, and one record. The shell knows features only by this record.
 * The shell itself and the train, which no build leaves out, have records, too. */
struct engine_driver;
struct method;
struct plot;

struct feature {
    const char *name;                    /* its folder; a_b for a folder b in a folder a */
    const struct command_group *groups;  /* its commands; the last title is NULL */
    const struct first_line *first;      /* the last place is 0 */
    const struct plot *const *plots;     /* tables of charts for 'plot'; the last one is NULL */
    const struct engine_driver *engine;  /* a rigid-body engine */
    const char *row_note;                /* the note of answers about a train while a row is set */
    const struct method *method;         /* what 'cost' compares with */
    const struct aggregates *aggregates; /* functions of the columns of tables (interpreter/question.h) */
    void (*progress)(bool begins);       /* shows the progress of a command (io/terminal.h) */
    /* Runs a command in place of command_answer, which it calls; at most one feature does */
    bool (*compute)(const struct command *command, const struct query *query, struct answer *answer,
                    struct problem *problem);
    const struct parameter *const *parameters; /* the last one is NULL */
    /* Names that have values in expressions, unless 'let' defines the same name. The function returns the
     * longest of them with which a text begins, its end in the text and its value, or NULL. The command with
     * the name of the feature explains them. */
    names_list *names;
    const char *(*value)(const char *text, const char **end, struct quantity *value);
};

/* The features of this build, each after those that it needs. The last one is NULL (features.c). */
extern const struct feature *const every_feature[];

/* Registers a list of features with all that their records name. Must be called before the first command
 * runs. */
void features_register(const struct feature *const *list);

/* Returns the feature that gives a value to the name at the beginning of the text, or NULL. Stores the name,
 * its end in the text, and the value. */
const struct feature *feature_value(const char *text, const char **name, const char **end,
                                    struct quantity *value);

/* A names_list (see names.h) of the names that features give to values. */
const char *feature_names(const void *context, int k);

/* Returns feature number k, counted from 0, or NULL if there are no more. */
const struct feature *feature_at(int k);

/* Returns the first of the lines at this place or a later one, or NULL. */
const struct first_line *first_line_at(int place);

/* Returns true for the shell and the train, which every build has. */
bool feature_is_always(const struct feature *feature);

/* ---- The commands of all features ---- */

/* Returns the groups of all features; the title of the last one is NULL. */
const struct command_group *command_groups(void);

/* Functions of type names_list (see names.h): */
const char *command_names(const void *context, int k);
const char *offered_commands(const void *context,
                             int k); /* without hidden ones and those that two words stand for */
const char *topic_names(const void *context, int k);  /* all commands and parameters */
const char *answer_keys(const void *command, int k);  /* the columns of a command's answer */
const char *command_keys(const void *command, int k); /* the columns that sweeps and expressions can use */

/* A names_list of the names that are known in expressions: the built-in names, 'sum', the names of features
 * such as landmarks, 'ans', the variables of the state `context`, and all commands and parameters, even those
 * without a value. If `context` is NULL, the list has neither variables nor the names of features, which a
 * variable may hide. */
const char *value_names(const void *context, int k);

const struct command *command_find(const char *name);

int command_count(void);
/* Returns command number k, counted from 0, or NULL if there are no more. */
const struct command *command_at(int k);

/* Returns the index of the command's principal column. The command must have one. */
int command_principal(const struct command *command);

/* Returns the most values that the command takes in parentheses, and stores the fewest in *fewest. Returns -1
 * if the command needs an argument that is not a value. */
int command_values(const struct command *command, int *fewest);

/* Like command_values. Also returns -1 if the command has no value in an expression. */
int command_arity(const struct command *command, int *fewest);

/* Returns true if an expression can use the columns of the command's answer, as in 'sum(chain(0).weight)'.
 * The command may be NULL. */
bool command_is_table(const struct command *command);

/* Returns a command with its arguments, such as "rmax [S]". The text lives until the end of the block. */
enum { USAGE_SIZE = 96 };
#define command_usage(command) command_usage_write(command, (char[USAGE_SIZE]){""})
const char *command_usage_write(const struct command *command, char usage[USAGE_SIZE]);

/* Returns true unless the session is safe (--safe) and the command reads or writes files, which is reported.
 */
static inline bool command_allowed(const struct run_context *run_context, const struct command *command,
                                   struct problem *problem)
{
    return !(command->access.files && run_context->safe) ||
           problem_error(problem, "a safe session cannot read or write files");
}

/* Returns an answer that is not printed. It stores the cells of its last row in `kept`. */
struct answer answer_kept(const struct query *query, const struct command *command,
                          struct cell kept[ANSWER_CELLS]);

/* Checks the unit and the range of an argument's value, and stores the value in SI units. On failure, sets
 * *problem and returns false. */
bool argument_check(const struct query *query, const struct argument *argument, struct quantity quantity,
                    domq_real *number, struct problem *problem);

/* Runs a command and whatever a feature does with its answer (feature.compute). */
bool command_compute(const struct command *command, const struct query *query, struct answer *answer,
                     struct problem *problem);

#define ROW(...) ((const struct cell[]){__VA_ARGS__})
