/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A question is a command with its arguments, after parsing. The names in the arguments have been resolved,
 * but their values have not been computed. To bind a question means to compute these values in a state, and
 * to check whether they are allowed. A sweep therefore parses its question once and binds it at every point.
 * Several threads can use the same question. The memory of a question is in the arena of the line.
 *
 * The functions that take a reader parse text at its position and move the reader to the end of this text.
 * After an error they set the reader's problem, and return false or NULL. The others have a *problem.
 */
#pragma once

#include "interpreter/command.h"
#include "language/text.h"
#include "language/units.h"
#include "session/query.h"

/* ---- Expressions (parse.c, evaluate.c) ---- */

/*
 * Expressions: 7/48, pi/18, 10 deg, 4.8 cm, 0.9*s, rmax(0.3), ans.margin, if(r > 1.5, 1, 0).
 *
 * The parser turns an expression into a tree. Evaluation does not change the tree, so threads can share it.
 *
 * A chain is a node for several operators of the same precedence, as in "a - b + c". Its children are the
 * operands a, b and c. Each operand except the first stores the operator before it.
 *
 * A blank ends an expression unless an operator follows, so a line can hold several expressions. After a
 * blank, a sign directly before a value belongs to that value: "1 - 2" is one expression, but "1 -2" is two.
 * In parentheses, there is only one expression, so "(1 -2)" is a difference.
 */

/*
 * How deeply values may be nested. Parsing and evaluating are recursive, and the parser counts the levels: a
 * parenthesis, a sign, an exponent and a call take one level each. The body of a 'let' function is parsed at
 * the level of its call.
 */
enum { NESTING_MOST = 200 };

struct evaluation;
struct reader;
struct tree;

/* Computes the value of a node. After an error, sets evaluation->problem and returns false. */
typedef bool evaluator(struct evaluation *evaluation, const struct tree *tree, struct quantity *result);

struct tree {
    /* The parser knows numbers, operators and built-in functions. For all other names, this is NULL until the
     * callback reader.names resolves the name. */
    evaluator *compute;
    /* For an operand of a chain: the operator before the operand, as one character. '<=' is 'l', '>=' is 'g',
     * '==' is '=', '!=' is '!', 'and' is '&', 'or' is '|'. */
    char op;
    /* Where an error in the operation `op` is reported: at the operator or, for '^', at the exponent. */
    const char *op_at;
    const char *at; /* where an error in this node is reported */
    const char *name,
        *key;    /* of a name: in "ans.margin", the name is "ans" and the key is "margin", or NULL */
    bool called; /* the name is followed by arguments in parentheses */
    int count;   /* the number of children; only a chain has more than EXPRESSION_ARGUMENTS */
    struct tree *child, *next; /* the first child and the next sibling of this node */
    struct quantity value;     /* of a number; for other names, the unit */
    const void *refers; /* what the name stands for: a function, a parameter, a variable or a command */
    int index;          /* of the argument of a function, of the column of an answer, or of an aggregate */
    const struct tree *body; /* the body of a 'let' function */
};

/* Report an error in an expression: one in the expression itself, or one that depends on the values of
 * parameters, and need not occur with other values. Both are false, so that a function that fails can end
 * with `return expression_wrong(...)`. */
#define expression_wrong(problem, at_, ...) ((problem)->at = (at_), problem_error(problem, __VA_ARGS__))
#define expression_no_value(problem, at_, ...)                                                               \
    ((problem)->at = (at_), problem_no_answer(problem, __VA_ARGS__))

/* Decides whether the word before c is the beginning of an expression rather than a command. Returns true if
 * there is an operator or 'to' at c. */
bool goes_on(const char *c);

/* Parses the longest expression at the reader's position, and moves the reader to its end. After an error,
 * sets the reader's problem, leaves the reader at the place of the error, and returns NULL. */
struct tree *expression_parse(struct reader *reader);

struct rows;

struct evaluation {
    struct problem *problem;
    const struct query *query;
    const struct quantity *argument; /* the arguments of the 'let' function that is being evaluated */
    struct rows *rows;               /* of the feature `sums` */
    void *context;                   /* for evaluators of features */
    /* the number of radians in the session's angle unit, which applies to angles typed without a unit */
    domq_real angle;
};

evaluator expression_evaluate;

/* The evaluators of what the parser itself resolves. */
evaluator number_value, function_value, chain_value, minus_value, not_value, if_value;

/* Evaluates the children of a node. */
bool arguments_evaluate(struct evaluation *evaluation, const struct tree *tree,
                        struct quantity argument[EXPRESSION_ARGUMENTS]);

/* Returns the built-in function with this name, or NULL. Stores the number of arguments of the function in
 * *arguments. */
const struct function *function_find(const char *name, int *arguments);

/* A names_list (see names.h) of the built-in names. */
const char *expression_names(const void *context, int k);

/* Resolves a name. Is the callback reader.names. A name can stand for a parameter, a variable, a 'let'
 * function, a command or the last answer. To choose one column of an answer, the user appends a dot and the
 * key of the column, as in 'rmax.r' or 'ans.margin'. */
bool name_resolve(struct reader *reader, struct tree *name);

/* Resolves the name of a command whose number, in the column of the name's key, `compute` finds. */
bool command_resolve(struct reader *reader, struct tree *name, const struct command *command,
                     evaluator *compute);

/* Runs the command of a name. The caller sets answer->kept and may set answer->sink. */
bool command_run(struct evaluation *evaluation, const struct tree *name, const struct quantity *argument,
                 struct answer *answer);

/* A feature that computes numbers of the columns of a table. */
struct aggregates {
    const char *name; /* completed and suggested like a name of a value */
    const char *help; /* a paragraph of the help of 'print' */
    /* Resolves a name, like name_resolve, if it is one of the feature or a table, and otherwise returns
     * false. After an error, tree->compute is NULL. If reader.names is NULL, it only finds out what the name
     * is. */
    bool (*resolve)(struct reader *reader, struct tree *name);
};
extern const struct aggregates *aggregates; /* NULL without such a feature */

/* Returns what is needed to evaluate trees in the state of a query. An error has a position if it is one of
 * the expression (problem.at), and none if a command in it has no answer. */
struct evaluation query_evaluation(const struct query *query, struct problem *problem);

/* ---- The reader (reader.c) ---- */

/* The reader: a position in the line that is being parsed, and functions that read words from this
 * position. */
enum { OFFER_LISTS = 16 };

/* What completion offers at the cursor, besides names and values. */
enum offer_kind { OFFER_FILE = 1, OFFER_UNIT = 2, OFFER_VARIABLE = 4 };

/* What the user may type next, for completion. To find out, the line is parsed with a
 * special cursor character at its end. Each parsing function that reaches this character records what it
 * would accept there. The function then fails, unless it accepts arbitrary text, such as a file name. */
struct offer {
    const char *cursor;
    int lists; /* the number of lists whose names may be typed at the cursor */
    names_list *names[OFFER_LISTS];
    const void *context[OFFER_LISTS];
    /* The argument whose expression is at the cursor. If there is no such argument, its kind is
     * ARGUMENT_NONE. */
    struct argument value;
    bool is_inside;                    /* the cursor is not at the beginning of the expression */
    unsigned kinds;                    /* bits of enum offer_kind */
    const struct command *command;     /* the command whose argument is at the cursor, or NULL */
    const struct parameter *parameter; /* the parameter or effect whose value is at the cursor, or NULL */
};

/* The 'let' functions whose bodies are being parsed: each of them has called the one before it. */
struct scope {
    const struct variable *function;
    const struct scope *outer;
};

struct reader {
    /* The query whose state determines which names are known. NULL if no names are, as in a csv file. */
    const struct query *query;
    struct problem *problem;
    const struct text *text; /* the line; NULL for a text that nobody has typed */
    const char *at;          /* the next character */
    struct arena *arena;     /* the memory for parsed expressions and words */
    /* Additional characters that end a word or value, such as ','. May be NULL. */
    const char *stops;
    /* Letters that are names, not units, when they stand alone after a blank. For example, if the letters are
     * "sg", then the s in "r 2 s 0.3" is the parameter s, not seconds. If this member is not NULL, the word
     * "feet" after a blank is also a name, because there is an effect called feet. */
    const char *no_unit;
    int depth;         /* the level of the next value, counted up to NESTING_MOST */
    int nested, nodes; /* the numbers of open parentheses, and of nodes in the command */
    /* Resolves a name whose arguments have been parsed. On failure, sets the problem and returns false. If
     * the pointer is NULL, names stay as they are, as in the definition of a function. */
    bool (*names)(struct reader *reader, struct tree *name);
    const struct scope *scope; /* NULL outside the bodies of functions */
    bool evaluates;            /* each value is computed and checked as soon as it has been parsed */
    bool details;              /* the word 'details' may end the command */
    struct offer *offer;       /* records what may be typed; NULL unless the line is only previewed */
};

/* Returns the offer in which to record what may be typed, or NULL if the reader is not at the cursor. A '"'
 * directly before the cursor counts as the cursor. */
static inline struct offer *reader_offer(const struct reader *r)
{
    struct offer *o = r->offer;
    return o && (r->at == o->cursor || (*r->at == '"' && r->at + 1 == o->cursor)) ? o : NULL;
}

/* If the reader is at the cursor, these functions record what may be typed there. */
void offer_kind(const struct reader *reader, enum offer_kind kind);
void offer_names(const struct reader *reader, names_list *list, const void *context);

/* Sets the place of the next problem to the column of `at`. */
void reader_place(const struct reader *reader, const char *at);

static inline bool command_ends(const char *c)
{
    return *c == '\0' || *c == ';' || *c == '#';
}

/* Skips blanks. Returns true if there are no more arguments, because the command ends here, or because there
 * is a '>', one of the words 'with' and 'details', or one of the characters in `stops`. */
bool reader_ends(struct reader *reader);

/* Returns true if the next word is `word`, not a longer word that begins with `word`. */
bool word_is_next(const struct reader *reader, const char *word);

/* If the next word is `word`, skips this word with the blanks after it and returns true. If the reader is at
 * the cursor, completion offers `word`. */
bool reader_takes(struct reader *reader, const char *word);

/* Return zeroed memory, and a copy of the first `length` bytes of a string, in the arena. If memory runs out,
 * set the reader's problem and return NULL. */
void *reader_memory(struct reader *reader, size_t size);
char *reader_copy(struct reader *reader, const char *text, size_t length);

/* Reads a word, up to a blank, a ';' or one of the characters in `stops`, and returns a copy in the arena.
 * Unless it is a bare word, it may also be a string in double quotes, in which '""' stands for one '"'. If
 * the closing quote is missing, sets the reader's problem and returns NULL. */
enum word_form { WORD_BARE, WORD_QUOTED, WORD_TYPED /* as it was typed: Greek letters are kept */ };
char *read_word(struct reader *reader, enum word_form form);

/* Reads the name of a file, which may be in double quotes. Replaces '~' or '~USER' at the beginning of the
 * name with a home directory. */
char *read_file(struct reader *reader);

/* ---- Commands (command_read.c) ---- */

/*
 * Returns the command of a line and moves the reader to its arguments. Most lines begin with the name of a
 * command. The others are shorthands, such as 2+2 for 'print', r = 2 for 'set', q alone for 'show', or rmax?
 * for 'help'. If a command and a parameter have the same name, the name stands for the command. If the name
 * of a parameter is also an abbreviation of a command, the name stands for the parameter, so 'q' does not
 * mean 'quit'.
 */
const struct command *command_read(struct reader *reader);

/* Finds the command that another command runs, such as 'verdict' in 'assert verdict'. If the text is an
 * expression, as in 'assert rmax < 2', returns 'print'. Other shorthands are not allowed. Completion offers
 * the names in the list `offered`. */
const struct command *command_read_inner(struct reader *reader, names_list *offered);

/* Parses the beginning of a definition, up to the '=', as in "x =" or "f(s, d) =". Returns the position after
 * the '='. If the text does not begin in this way, returns NULL. */
const char *definition_head(const char *text, struct variable *variable);

/* Returns true if a variable or function can have this name. Otherwise reports what the name means. */
bool name_free(struct problem *problem, const char *name);

/* ---- Values (item.c) ---- */

/* One value in the arguments of a command. The user has typed it as an expression, or as a word that stands
 * for a value. */
struct item {
    const struct argument *argument;
    const struct tree *value; /* the expression, or NULL if `number` is the value */
    domq_real number;
    const char *word; /* the word, name or path that was typed, or NULL */
    const char *at;   /* the position of the value in the line; may be NULL */
};

/* Parses a value of an argument: an expression, or one of the words that the argument takes. The item keeps a
 * pointer to the argument. */
bool item_parse(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses a value that is no word. */
bool item_parse_expression(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses value number i of a parameter. */
bool item_parse_value(struct reader *reader, const struct parameter *parameter, int i, struct item *item);

/* Parses one value of a list such as "r 1.5 s 0.3". If the value of an effect is the word "on", the effect
 * gets its usual value. */
bool item_parse_listed(struct reader *reader, const struct parameter *parameter, struct item *item);

/* Parses the name of a parameter of the model or of an effect. If the next word is not a name at all, the
 * error message ends with the text `form`, which shows what the command expects. */
const struct parameter *parameter_parse(struct reader *reader, const char *form);

/* Computes and checks the value of an item. Stores the value in *number. If `quantity` is not NULL, also
 * stores the value with its unit in *quantity. A problem says at which column of the line `text` the value
 * is. */
bool item_bind(const struct item *item, const struct text *text, const struct query *query,
               struct quantity *quantity, domq_real *number, struct problem *problem);

/* Returns true if the name is known in expressions (see value_names). */
bool is_value_name(const struct state *state, const char *name);

/* Adds the name of a value to an error in its expression, and finds the column of the error if `text` is not
 * NULL. Returns false. */
bool item_wrong(struct problem *problem, const struct text *text, const char *name);

/* ---- Questions (question_parse.c) ---- */

struct question {
    const struct command *command;
    int key; /* index of the requested column of the answer, or -1 for the whole answer */
    int count;
    struct item item[ARGUMENTS_MAX];
    const struct parameter *parameter; /* the one that an ARGUMENT_PARAMETER names, or NULL */
    const struct variable *variable;   /* the one that the name of a parameter stands for, or NULL */
    void *parsed;                      /* the result of argument.parse */
    struct assignment {
        const struct parameter *parameter;
        struct item item;
    } * with;     /* the pairs "NAME VALUE" after 'with', up to ASSIGNED_MAX */
    int assigned; /* the number of these pairs */
    bool details; /* the command ends with the word 'details' */
    const struct text *text;
    const char *name; /* the text from question_name, for messages and headings */
};

bool command_parse(struct reader *reader, struct question *question);

/* Parses the arguments of question->command. They extend to the end of the command, to a '>', or to one of
 * the characters in the reader's `stops`. */
bool question_parse(struct reader *reader, struct question *question);

/* The result of question_bind: the values of the arguments, and the query that the command answers. */
struct call {
    struct query query;
    struct arguments given;
    struct state state; /* the state after the assignments of 'with', if there are any */
};

/* Binds a question in the state of a query. Even after an error, the caller must free call->given.memory. */
bool question_bind(const struct question *question, const struct query *query, struct call *call,
                   struct problem *problem);

/* Allocates zeroed memory in the arena given->memory and stores its address in given->bound. The function
 * argument.bind calls this function to get memory for its result. Returns NULL if memory runs out. */
void *arguments_take(struct arguments *given, size_t size, const struct query *query,
                     struct problem *problem);

/* Runs a command, in double if it computes in double only. Fails if the verdict is no and the search wants
 * only answers whose verdict is yes. */
bool command_answer(const struct command *command, const struct query *query, struct answer *answer,
                    struct problem *problem);

/* ---- Lines (interpret.c) ---- */

/* Runs the commands in a string of one or more lines. ';' separates commands, and '#' begins a comment. After
 * a command, '> NAME' writes the answer to a file, and '>> NAME' appends the answer to a file. */
void command_run_text(struct session *session, const char *text);

/* Runs the commands of a stream line by line. `name` is the name of the stream in error messages. */
void line_stream(struct session *session, FILE *in, const char *name);

/* ---- A line that is being typed, for completion. No command is run. ---- */

/* The character that marks the cursor. No name, value or operator contains this character. */
#define PREVIEW_CURSOR "\001"

/*
 * Parses a line that is not complete yet, and returns true if its last command is right so far. The line
 * consists of `length` bytes of the text `line`, followed by the text `tail`. If `offer` is NULL, also
 * computes and checks the values in the line. If `offer` is not NULL and `tail` ends with PREVIEW_CURSOR,
 * stores in *offer what may be typed at the cursor.
 */
bool line_preview(struct session *session, const char *line, size_t length, const char *tail,
                  struct offer *offer);
