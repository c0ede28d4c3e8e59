/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The commands.  A row of a command table drives dispatch, arguments and their errors, help, completion
 * and the use of a command as a name in expressions.
 */
#ifndef SHELL_COMMAND_H
#define SHELL_COMMAND_H

#include "language/names.h"
#include "session/parameters.h"
#include "session/query.h"

/* What an argument is; it decides how it is read, what is wrong with it, and what completion offers. */
enum argument_kind {
    ARGUMENT_NONE,
    ARGUMENT_TILT,      /* an angle in [0, theta_c] */
    ARGUMENT_OF,        /* a value for the parameter argument.of */
    ARGUMENT_HEIGHT,    /* a length > 0 */
    ARGUMENT_LENGTH,    /* a length >= 0 */
    ARGUMENT_COUNT,     /* an integer in 1 .. COUNT_MAX */
    ARGUMENT_ANY,       /* any value */
    ARGUMENT_NUMBER,    /* a plain number */
    ARGUMENT_PARAMETER, /* the name of a parameter; without a value after it, or of a variable */
    ARGUMENT_EFFECT,    /* the name of an effect */
    ARGUMENT_VALUE,     /* a value for the parameter or effect before it, or a file that gives it */
    ARGUMENT_TOPIC,     /* a command, a parameter or a variable */
    ARGUMENT_CHOICE,    /* one of the names in argument.choices; its number */
    ARGUMENT_PLACE,     /* the same, as -1 - its number, or an angle in [0, theta_c] */
    ARGUMENT_WORD,      /* any word, or several between "..." */
    ARGUMENT_FILE,      /* a path, between "..." if it has blanks */
    ARGUMENT_GRID,      /* values of parameters and effects, up to a ':' */
    ARGUMENT_COMMAND,   /* ':' and a command that answers */
    ARGUMENT_WORDS,     /* all that is left of the command: argument.parse parses the words and values */
    ARGUMENT_UNIT,      /* "to" and a unit */
    ARGUMENT_REST,      /* the rest of the line as it is */
};

#define COUNT_MAX 10000000

struct reader;
struct question;
struct arguments;
struct session;

struct argument {
    const char *name;
    enum argument_kind kind;
    const char
        *of;   /* the parameter of ARGUMENT_OF; what the choices are; what not any value of ARGUMENT_ANY is */
    int which; /* of the parameter's values, from 0 */
    bool optional;
    names_list *choices; /* the names that it takes, or that completion offers for it */
    /* Parse and bind ARGUMENT_GRID, ARGUMENT_COMMAND, ARGUMENT_WORDS and ARGUMENT_UNIT; what parse finds is
     * question->parsed, and bind makes given->bound of it. The context of choices of ARGUMENT_WORDS is the
     * word before the one that is completed. Where choices is value_names, it is a definition. */
    bool (*parse)(struct reader *reader, struct question *question);
    bool (*bind)(const struct question *question, const struct query *query, struct arguments *given,
                 struct problem *problem);
    int (*most)(const struct scene *scene); /* of ARGUMENT_COUNT; NULL: COUNT_MAX */
    const char *most_of;                    /* the name of what `most` limits */
};

enum { ARGUMENTS_MAX = 3 };

/* The arguments that a command is given, as they were read. */
struct arguments {
    int count; /* number of arguments that were given */
    domq_real number[ARGUMENTS_MAX];
    struct quantity quantity[ARGUMENTS_MAX]; /* of ARGUMENT_ANY */
    const char *word[ARGUMENTS_MAX];
    const struct parameter
        *parameter; /* the parameter that ARGUMENT_PARAMETER or ARGUMENT_EFFECT names; NULL: none */
    const struct variable *variable; /* the one that ARGUMENT_PARAMETER, ARGUMENT_TOPIC or a definition names;
                                        NULL: none */
    int column[ARGUMENTS_MAX];       /* their places in the line, for messages */
    void *bound;                     /* the result of argument.bind, or NULL */
    void (*bound_free)(void *bound); /* frees that result; or NULL */
};

struct command {
    const char *name;
    struct argument argument[ARGUMENTS_MAX];
    const char *summary;          /* one line */
    const char *synonyms;         /* other words that people look for, for 'apropos'; or NULL */
    const char *equation;         /* of the paper, or NULL */
    const char *help;             /* more, or NULL */
    const char *example;          /* commands that show it, or NULL */
    const char *see;              /* other commands, or NULL */
    const struct column *columns; /* of the answer, or NULL */
    const char *principal;        /* the key of its value in an expression; NULL: none */
    bool rows;
    const char *echo;    /* the column that repeats this parameter, unless an argument takes its place */
    const char *unswept; /* why 'sweep' does not take it, though it answers; or NULL */
    bool train;          /* is about the endless train */
    bool draws;          /* gives a picture in a table */
    const char *holds;   /* what is true if its answer is yes, see answer_holds; NULL: it decides nothing */
    bool runs;           /* runs other commands, whose answers go where its own would */
    bool files;          /* touches files: not in a safe session */
    bool changes;        /* may change parameters, effects, the row or variables: 'undo' takes it back */
    bool pages;          /* gives a long text, which a terminal shows a page at a time */
    const char
        *shortest; /* the shortest beginning that means this command, though others begin so; or NULL */
    /* Answers the query, and gives its next state; or describes a problem and returns false. */
    bool (*run)(const struct query *query, struct answer *answer, struct problem *problem);
    /* The same for a command that acts on the session itself; run is then NULL. */
    bool (*act)(struct session *session, const struct arguments *given, struct answer *answer,
                struct problem *problem);
    /* Draws the answer into a file whose ending is that of a picture; NULL: the answer has none. */
    bool (*picture)(const struct query *query, struct answer *answer, struct problem *problem);
};

struct command_group {
    const char *title;
    const struct command *commands; /* ends with a NULL name */
};

/*
 * Sets the groups that all functions below look in, which end with a NULL title: once, before the first
 * command runs.  The list itself is at the top of the house, in commands/registry.c, since only there every
 * command is known.
 */
void command_registry(const struct command_group *groups);
const struct command_group *command_groups(void);

/* Lists for names.h: commands; commands and parameters; keys of the command that is the context. */
const char *command_names(const void *context, int k);
const char *topic_names(const void *context, int k);
const char *command_keys(const void *command, int k);

/* Returns the k-th of the topics that people also know by this word, or NULL: 'growth' is r, and 'speed' is
 * several. */
const char *topic_meant(const char *word, int k);

/* Lists for names.h every name that has a value in a state; without one (NULL) those that every state has. */
const char *value_names(const void *context, int k);

/* Returns the command with exactly this name, or NULL. */
const struct command *command_find(const char *name);

enum { USAGE_SIZE = 96 };

/* Returns the index of the principal column of a command that has one. */
int command_principal(const struct command *command);

/* Writes the usage of a command: "rmax [S]". */
const char *command_usage(const struct command *command, char usage[USAGE_SIZE]);

/* Returns the unit of the values of an argument, 1 for a plain number. */
struct quantity argument_unit(const struct argument *argument);

/* Checks a value for an argument of this kind, and stores it.  Reports what is wrong and returns false. */
bool argument_check(const struct query *query, const struct argument *argument, struct quantity quantity,
                    domq_real *number, struct problem *problem);

/*
 * Returns the most arguments that a command may have as a name in expressions: those before the first that
 * cannot be a value (a file, a word). *fewest: the arguments that are required. -1: the command has no value
 * there.
 */
int command_values(const struct command *command, int *fewest);

/* Reports an error where a safe session may not run the command, since it touches files. */
bool command_allowed(const struct means *means, const struct command *command, struct problem *problem);

/* Runs a command whose arguments are read, as expressions do: the answer is kept, not written. */
bool command_keep(const struct query *query, const struct command *command, struct cell *kept,
                  struct problem *problem);

/*
 * Runs every command of a text: lines, and ';' between commands; '#' begins a comment; '> FILE' and
 * '>> FILE' send an answer to a file.
 */
void command_run_text(struct session *session, const char *text);

/* omega from tau^2 omega^2 and the bound of that; at rest the bound is that of a root near 0. */
struct cell cell_omega(domq_real omegasq, domq_real error, domq_real tau);

/* The cell of a member of a result, with the bound of its error. */
#define CELL_OF(result, member) cell_bound((result).member, (result).error.member)

/* The same in another unit: both times a factor. */
#define CELL_TIMES(result, member, factor)                                                                   \
    cell_bound((result).member *(factor), (result).error.member *(factor))

#define ROW(...) ((const struct cell[]){__VA_ARGS__})

#endif
