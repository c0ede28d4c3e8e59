/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The reader: a position in the line that is being parsed, and functions that read words from this
 * position. */
#ifndef SHELL_READER_H
#define SHELL_READER_H

#include "interpreter/command.h"
#include "interpreter/expression.h"
#include "language/text.h"

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

struct routine;

struct reader {
    /* The query whose state determines which names are known. NULL if no names are, as in a csv file. */
    const struct query *query;
    struct problem *problem;
    const struct text *text; /* the line; NULL for the body of a function, where problems have no column */
    const char *at;          /* the next character */
    struct arena *arena;     /* the memory for parsed expressions and words */
    /* Additional characters that end a word or value, such as ','. May be NULL. */
    const char *stops;
    /* Letters that are names, not units, when they stand alone after a blank. For example, if the letters are
     * "sg", then the s in "r 2 s 0.3" is the parameter s, not seconds. If this member is not NULL, the word
     * "feet" after a blank is also a name, because there is an effect called feet. */
    const char *no_unit;
    int depth, deepest; /* the level of the next value, counted up to NESTING_MOST, and the largest so far */
    int nested, nodes;  /* the numbers of open parentheses and of nodes in the expression */
    /* Resolves a name whose arguments have been parsed. On failure, sets the problem and returns false. If
     * the pointer is NULL, names stay as they are. */
    bool (*names)(struct reader *reader, struct tree *name);
    /* Parses a "with" after a value in parentheses, as in "(rmax with q hollow d 0.1)". The reader is at the
     * "with". Returns a tree for the value and its "with", or NULL after an error. */
    struct tree *(*with)(struct reader *reader, struct tree *value);
    const struct variable *scope; /* the function whose body is being parsed, or NULL */
    struct routine *routines;     /* the 'let' functions that the command has used so far */
    bool unresolved;     /* names in expressions are left unresolved, as in the definition of a function */
    bool evaluates;      /* each value is computed and checked as soon as it has been parsed */
    bool last;           /* the last argument of the command is being read */
    bool details;        /* the word 'details' may end the command */
    struct offer *offer; /* records what may be typed; NULL unless the line is only previewed */
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
void offer_value(const struct reader *reader, const struct argument *argument, bool is_inside);

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

/* Reads a word, up to a blank, a ';' or one of the characters in `stops`, and returns a copy in the arena. If
 * `quotes` is true, it may also be a string in double quotes, in which '""' stands for one '"'. If the
 * closing quote is missing, sets the reader's problem and returns NULL. */
char *read_word(struct reader *reader, bool quotes);

/* Reads a word or quoted text as it was typed, without replacing Greek letters. */
char *read_text(struct reader *reader);

/* Reads the name of a file, which may be in double quotes. Replaces '~' or '~USER' at the beginning of the
 * name with a home directory. */
char *read_file(struct reader *reader);

#endif
