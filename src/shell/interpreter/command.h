/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands. Each command is a row of a table. The way its arguments are read, its errors, its help, its
 * completion and its value in expressions all follow from that row. */
#ifndef SHELL_COMMAND_H
#define SHELL_COMMAND_H

#include "language/names.h"
#include "session/parameters.h"
#include "session/query.h"

/* The kind of an argument says how it is parsed and checked, and what completion offers. */
enum argument_kind {
    ARGUMENT_NONE,
    /* Kinds that an expression gives: */
    ARGUMENT_TILT,   /* an angle in [0, theta_c] */
    ARGUMENT_OF,     /* a value of the parameter that `of` names */
    ARGUMENT_HEIGHT, /* a length > 0 */
    ARGUMENT_LENGTH, /* a length >= 0 */
    ARGUMENT_COUNT,  /* an integer in 1 .. COUNT_MAX */
    ARGUMENT_ANY,    /* a value in any unit */
    ARGUMENT_NUMBER, /* a plain number */
    ARGUMENT_PLACE,  /* an angle as above, or one of the choices, for which the number is -1 - index */
    /* Kinds of words and names: */
    ARGUMENT_CHOICE,    /* one of the choices; the number is its index */
    ARGUMENT_EFFECT,    /* the name of an effect */
    ARGUMENT_PARAMETER, /* the name of a parameter, or of a variable unless a value follows */
    ARGUMENT_VALUE,     /* a value of the parameter or effect before it, or a file with values */
    ARGUMENT_TOPIC,     /* a command, a parameter or a variable */
    ARGUMENT_WORD,      /* any word, or a text between "..." */
    ARGUMENT_FILE,      /* a path; with blanks in it, between "..." */
    ARGUMENT_REST,      /* the rest of the line as it is, also behind ';' */
    /* Kinds that the argument's own function parses: */
    ARGUMENT_GRID,    /* names, each with values */
    ARGUMENT_COMMAND, /* a command that answers, perhaps after ':' */
    ARGUMENT_WORDS,   /* words and values up to the end of the command */
    ARGUMENT_UNIT,    /* "to" and a unit */
};

#define COUNT_MAX 10000000

struct reader;
struct question;
struct arguments;
struct session;

struct argument {
    const char *name;
    enum argument_kind kind;
    const char *of; /* the parameter of ARGUMENT_OF; else what a value or choice is called in messages */
    int which;      /* index of the value of that parameter */
    bool optional;
    names_list *choices;
    /* For the last four kinds: `parse` makes question->parsed, and `bind` computes given->bound from that in
     * a state. */
    bool (*parse)(struct reader *reader, struct question *question);
    bool (*bind)(const struct question *question, const struct query *query, struct arguments *given,
                 struct problem *problem);
};

enum { ARGUMENTS_MAX = 3 };

/* The arguments of a command, bound in a state. */
struct arguments {
    int count;
    domq_real number[ARGUMENTS_MAX];
    struct quantity quantity[ARGUMENTS_MAX]; /* the number with its unit */
    const char *word[ARGUMENTS_MAX];
    int column[ARGUMENTS_MAX];         /* columns in the line, for messages */
    const struct parameter *parameter; /* named by ARGUMENT_PARAMETER or ARGUMENT_EFFECT, or NULL */
    const struct variable *variable;   /* named by ARGUMENT_PARAMETER, ARGUMENT_TOPIC or 'let', or NULL */
    void *bound;                       /* the result of argument.bind */
    void *memory;                      /* of that result, see arguments_take */
};

/* A command. Strings and pointers that do not apply to it are NULL. */
struct command {
    const char *name;
    struct argument argument[ARGUMENTS_MAX];
    const char *summary;  /* one line */
    const char *synonyms; /* other words that people look for, with blanks between them */
    const char *equation; /* the equations of the paper */
    const char *help;     /* the text below the summary */
    const char *example;  /* commands that show it */
    const char *see;      /* related commands */
    const struct column *columns;
    const char *principal; /* the key of the column that is its value in expressions */
    bool rows;             /* The answer may have several rows. */
    const char *echo;      /* the column that repeats this parameter, unless an argument gives its value */
    const char *unswept;   /* why 'sweep' refuses a command that answers */
    bool train;            /* The answer is about the endless train. */
    bool draws;            /* The answer is a picture in a table. */
    const char *holds;     /* what is true if the answer is yes, see answer_holds */
    bool runs;             /* It runs other commands, which write to its output. */
    bool files;            /* It reads or writes files, which a safe session refuses. */
    bool changes; /* It may change parameters, effects, the row or variables, which 'undo' reverts. */
    bool pages;   /* The answer is a long text, for the pager. */
    const char
        *shortest; /* the shortest abbreviation that means this command, although others begin with it, too */
    /* Answers a query and writes its next state. Returns false with a problem. */
    bool (*run)(const struct query *query, struct answer *answer, struct problem *problem);
    /* Does the same in place of `run` for a command that acts on the session. */
    bool (*act)(struct session *session, const struct arguments *given, struct answer *answer,
                struct problem *problem);
    /* Draws the answer into a file with the ending of a picture. */
    bool (*picture)(const struct query *query, struct answer *answer, struct problem *problem);
};

struct command_group {
    const char *title;
    const struct command *commands; /* ends with a NULL name */
};

/*
 * Registers the groups of all commands, which end with a NULL title, before the first command runs. The list
 * comes from commands/registry.c, since this folder is below the commands.
 */
void command_registry(const struct command_group *groups);
const struct command_group *command_groups(void);

/* Lists for names.h: all commands; commands and parameters; the keys of the command that is the context. */
const char *command_names(const void *context, int k);
const char *topic_names(const void *context, int k);
const char *command_keys(const void *command, int k);

/* Lists for names.h all names that have a value in the state that is the context, or, if that is NULL, in
 * every state. */
const char *value_names(const void *context, int k);

/* Returns topic k of those that people also call by this word, or NULL: 'growth' is r, 'speed' is several. */
const char *topic_meant(const char *word, int k);

/* Returns the command with this name, or NULL. */
const struct command *command_find(const char *name);

/* Returns the index of the principal column of a command that has one. */
int command_principal(const struct command *command);

/*
 * Returns the maximum number of arguments that a command takes in an expression: those before the first that
 * is no value. `fewest` is the minimum. Returns -1 if the command has no value.
 */
int command_values(const struct command *command, int *fewest);

/* Writes the usage of a command: "rmax [S]". */
enum { USAGE_SIZE = 96 };
const char *command_usage(const struct command *command, char usage[USAGE_SIZE]);

/* Returns true unless the command touches files and the session is safe, which is a problem. */
bool command_allowed(const struct means *means, const struct command *command, struct problem *problem);

/* Runs a command whose arguments are bound, and keeps the cells of its answer instead of writing them. */
bool command_keep(const struct query *query, const struct command *command, struct cell *kept,
                  struct problem *problem);

/* Returns the unit in which an argument is measured, 1 for a plain number. */
struct quantity argument_unit(const struct argument *argument);

/* Stores the value of an argument as a number. Returns false with a problem if it does not fit. */
bool argument_check(const struct query *query, const struct argument *argument, struct quantity quantity,
                    domq_real *number, struct problem *problem);

/* Returns omega from tau^2 omega^2 and its error bound. At rest, the bound is that of the root of a number
 * near 0. */
struct cell cell_omega(domq_real omegasq, domq_real error, domq_real tau);

/* The cell of a member of a result with its error bound; the same, multiplied by a factor. */
#define CELL_OF(result, member) cell_bound((result).member, (result).error.member)
#define CELL_TIMES(result, member, factor)                                                                   \
    cell_bound((result).member *(factor), (result).error.member *(factor))

#define ROW(...) ((const struct cell[]){__VA_ARGS__})

#endif
