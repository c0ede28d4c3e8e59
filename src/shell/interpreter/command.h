/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Each command is one entry of a table. The entry says everything about the command: its syntax, its help,
 * what completion offers, and which value the command has in an expression. */
#ifndef SHELL_COMMAND_H
#define SHELL_COMMAND_H

#include "language/arena.h"
#include "language/names.h"
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
    ARGUMENT_TOPIC,     /* a command, a parameter or a variable */
    ARGUMENT_WORD,      /* a single word, or several words in double quotes */
    ARGUMENT_FILE,      /* a path, in double quotes if it contains blanks */
    ARGUMENT_REST,      /* the rest of the line, unparsed, including any ';' */
    /* Arguments that are parsed by a function of their own (argument.parse): */
    ARGUMENT_GRID,    /* parameter names, each followed by values */
    ARGUMENT_COMMAND, /* a command that computes something, after an optional ':' */
    ARGUMENT_WORDS,   /* all remaining words and values of the command */
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
    /* The noun for the value in messages, such as "picture". If an ARGUMENT_ANY has a noun, completion offers
     * no values for this argument. */
    const char *noun;
    bool optional;
    names_list *choices;
    /* Some arguments have a syntax of their own: the kinds from ARGUMENT_GRID to ARGUMENT_UNIT. The function
     * `parse` reads such an argument and stores its result in question->parsed. The function `bind` computes
     * values from this result and stores them in given->bound. */
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
    const char *typed[ARGUMENTS_MAX]; /* where the argument begins in the line; may be NULL */
    int column[ARGUMENTS_MAX];        /* the column of each argument in the typed line, for messages */
    /* The parameter that was named as an ARGUMENT_PARAMETER. NULL if there is none. */
    const struct parameter *parameter;
    /* The variable that an argument names. The argument may be an ARGUMENT_PARAMETER, an ARGUMENT_TOPIC or
     * the name after 'let'. NULL if no variable was named. */
    const struct variable *variable;
    bool details;        /* the answer includes what 'details' would print */
    void *bound;         /* the result of argument.bind */
    struct arena memory; /* for arguments_take */
};

/* A command. Strings and pointers that a command does not need are NULL. */
struct command {
    const char *name;
    struct {
        /* Two words that stand for this command, such as "step back". In its table, this command follows the
         * command whose name is the first word, directly or after others with the same first word. Help
         * shows these words, and `name` is a synonym that help does not mention. */
        const char *phrase;
        /* The name of a command with the same first argument that replaces this command if its name follows
         * that argument, as in "count 112 m fewest". */
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
    /* For a command whose columns depend on its first argument: stores the name and the summary of its value
     * number k, counted from 0, and returns the columns of the answer. Returns NULL if there are no more. */
    const struct column *(*parts)(int k, const char **name, const char **summary);
    const char *principal; /* the key of the column that holds the value of the command in expressions */
    bool rows;             /* the answer is a table that may have several rows */
    /* The keys of the columns that an answer for people shows, or "*" for all; 'details' prints the rest.
     * NULL if the answer is whole without 'details'. */
    const char *brief;
    struct {
        /* The name of the parameter whose value a column of the answer only repeats, such as "s". A sweep
         * over this parameter already shows its values, so the sweep leaves the column out. If an argument
         * replaces the value, as in 'rmax 0.4', the sweep keeps the column. NULL if no column repeats a
         * parameter. */
        const char *echo;
        /* The key of the last column, if this column takes a long time to compute. Sweeps leave this column
         * out, and expressions can use it only as a column of 'ans'. NULL if no column is slow. */
        const char *slow_column;
        /* Why 'sweep' refuses this command, worded for the message "'plot' cannot be varied: it draws". NULL
         * if 'sweep' accepts the command. A command without columns needs no reason here, because 'sweep'
         * accepts no such command. */
        const char *refusal;
        /* The numbers of the answer are only meaningful if its verdict is yes, so a search for the best
         * number leaves out places where the verdict is no (run_context.seeks_yes). */
        bool needs_yes;
    } sweep;
    /* For a command whose energies are in J if masses are known: returns true if they are known in this
     * scene. If they are not, the unit is "mgh/2". NULL if the units of the columns do not depend on the
     * scene. */
    bool (*in_joules)(const struct scene *scene);
    bool train; /* the answer is about the endless train */
    /* The answer is the value of an expression. Messages do not mention 'print', because the user can omit
     * it. */
    bool is_print;
    enum {
        PRECISION_MIXED,
        /* The whole answer is computed in the precision of the session. Then the numbers have errors: their
         * differences from a computation in quad precision. */
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

/* Returns the groups of all features; the title of the last one is NULL. */
const struct command_group *command_groups(void);

/* Returns true for the word of a group, and for "all", which stands for all groups. */
bool group_named(const char *word);

/* Functions of type names_list (see names.h): */
const char *command_names(const void *context, int k);
const char *offered_commands(const void *context,
                             int k); /* without hidden ones and those that two words stand for */
const char *topic_names(const void *context, int k);  /* all commands and parameters */
const char *answer_keys(const void *command, int k);  /* the columns of a command's answer */
const char *command_keys(const void *command, int k); /* the columns that sweeps and expressions can use */

/* A names_list of the names that are known in expressions: the built-in names, 'sum', landmarks, 'ans', the
 * variables of the state `context`, and all commands and parameters, even those without a value, such as
 * 'quit'. If `context` is NULL, the list has no variables, nor 'sum' and landmarks, which a variable may
 * hide. */
const char *value_names(const void *context, int k);

/* Several topics can have the same synonym, such as 'speed'. Returns the name of topic number k, counted from
 * 0, among those with this synonym. Returns NULL if there are no more. If the word is the first synonym of a
 * parameter, only this parameter is returned. */
const char *topic_by_synonym(const char *word, int k);

const struct command *command_find(const char *name);

int command_count(void);
/* Returns command number k, counted from 0, or NULL if there are no more. */
const struct command *command_at(int k);

/* Returns the unit that a column of the command's answer has in this scene. */
const char *command_unit(const struct command *command, int column, const struct scene *scene);

/* Returns the index of the command's principal column. The command must have one. */
int command_principal(const struct command *command);

/* Returns the maximum number of values that the command takes in parentheses and stores the minimum in
 * *fewest. Returns -1 if the command needs an argument that is not a value. */
int command_values(const struct command *command, int *fewest);

/* Like command_values. Also returns -1 if the command has no value in an expression. */
int command_arity(const struct command *command, int *fewest);

/* Returns true if an expression can use the columns of the command's answer, as in 'sum(chain(0).weight)'.
 * The command may be NULL. */
bool command_is_table(const struct command *command);

/* Returns a string that shows the arguments of a command, such as "rmax [S]". The string is in a compound
 * literal, so it lives until the end of the block that contains the call. */
enum { USAGE_SIZE = 96 };
#define command_usage(command) command_usage_write(command, (char[USAGE_SIZE]){""})
const char *command_usage_write(const struct command *command, char usage[USAGE_SIZE]);

/* Returns true if the session may run the command. In safe mode (--safe), a session must not run commands
 * that read or write files. For such a command, sets *problem and returns false. */
static inline bool command_allowed(const struct run_context *run_context, const struct command *command,
                                   struct problem *problem)
{
    return !(command->access.files && run_context->safe) ||
           problem_error(problem, "a safe session cannot read or write files");
}

/* Returns an answer that is not printed. It stores the cells of its last row in `kept`. */
struct answer answer_kept(const struct query *query, const struct command *command,
                          struct cell kept[ANSWER_CELLS]);

/* Returns the unit in which the value of an argument is stored, as a quantity such as 1 m. For a plain
 * number, the quantity is 1. */
struct quantity argument_unit(const struct argument *argument);

/* Checks whether the value of an argument has a suitable unit and is in the range that the argument allows.
 * If so, stores the value in SI units. Otherwise, sets *problem and returns false. */
bool argument_check(const struct query *query, const struct argument *argument, struct quantity quantity,
                    domq_real *number, struct problem *problem);

/* Returns omega. Omega is computed from its square: omegasq is tau^2 omega^2. */
struct cell cell_omega(domq_real omegasq, domq_real tau);

#define ROW(...) ((const struct cell[]){__VA_ARGS__})

#endif
