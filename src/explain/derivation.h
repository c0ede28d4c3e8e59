/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Derivations show where a number comes from. A quantity has an equation, which the user sees, or an
 * expression with which the library computes it, or both. The program then shows the number that the library
 * computes, and a test checks that the equation gives the same number. */
#pragma once

#include "interpreter/question.h"

extern const struct command effect_commands[];

/* Bits for the properties of a train that decide which equations hold for it. */
enum {
    HAS_SLOPE = 1,
    HAS_LOSS = 2, /* an effect takes energy while dominoes move */
    HAS_EDGES = 4,
    HAS_WALLS = 8,
    HAS_PAPER = 16, /* the fuel is computed by the paper's closed form */
    HAS_DETACHED = 32,
    HAS_REACH = 64,             /* the reach 1/s limits the largest growth */
    HAS_DETACHED_AT_TILT = 128, /* at the tilt that the user asked about, the head's follower has detached */
};

/* Some quantities are sums over all dominoes. For such a quantity, the member `equation` is the term of
 * domino i, and this enum tells at which tilt of the head the terms are evaluated. */
enum sum {
    SUM_NONE,
    SUM_LAUNCH, /* the tilt 0 */
    SUM_TILT,   /* the tilt theta that the user asked about */
    SUM_TOP,    /* the tilt theta_m, where the train is highest */
};

/* A quantity, and the equation by which it follows from other quantities. The equation may depend on the
 * train, so a name can have several entries. The first entry whose conditions hold is used. */
struct derived {
    const char *name, *letters; /* the symbol as it is typed, and with Greek letters */
    unsigned with;              /* the conditions under which this entry is used, as bits */
    unsigned ends; /* under these conditions the equation does not hold, and the derivation ends */
    enum sum sum;
    const char *equation; /* NULL if there is no equation in closed form; the derivation then ends here */
    /*
     * How to find the number:
     * - '$' and the name of a parameter or effect, or
     * - an expression for the library, where '@' is the value that the user typed.
     * NULL for a quantity whose number the equation gives, or that is different in each term of a sum.
     */
    const char *library;
    const char *unit;
    const char *reference; /* the number and the label of the equation in the paper, or "" */
    const char *words;     /* what the quantity is and, if the derivation ends here, why it ends */
    bool is_given;         /* the number is given rather than derived */
};
extern const struct derived derived_list[];

/* A question of the command 'explain', and the quantities that answer it. */
struct explained {
    const char *name; /* a command, or the label of an equation of the paper */
    /* "theta", "s" or "H" if the user can type a value of this quantity after the question, as in
     * 'explain omega 0.2'. NULL if the question takes no value. */
    const char *value;
    /* The quantities that answer the question, with blanks between them. For an equation, they are what it
     * defines, or its two sides. */
    const char *roots;
    /* what the paper's form of an equation needs more than a train that falls */
    enum needs {
        COMMAND,        /* the question is a command */
        HOLDS,          /* derived_list has forms for trains with effects */
        BARE,           /* no effects, and the exact fuel */
        PAIR,           /* as BARE, and domino 1 tips over before it hits (5; b0) */
        LEANING,        /* as BARE, and domino 2 leans on domino 1 at this tilt */
        LEANING_AT_HIT, /* as LEANING, but when the head is hit, at the tilt 0 */
    } needs;
};
extern const struct explained explained_list[];

/* A names_list of the questions that are commands. */
const char *explained_names(const void *context, int k);

/* ---- A derivation ---- */

enum { STEPS_MOST = 40, NEEDS_MOST = 10, TERMS_SHOWN = 3 };

/* One number in a derivation. */
struct step {
    const struct derived *derived;
    const char *name;                     /* derived->name */
    const char *reference, *unit, *words; /* as in `derived`, but adapted to the train */
    const struct tree *tree;              /* the parsed equation, or NULL */
    const struct step *needs[NEEDS_MOST];
    int count;       /* number of elements in `needs` */
    domq_real value; /* the number that the library computes; NaN if there is none */
    domq_real *term; /* the values of the terms if the step is a sum */
    size_t terms;
    int depth; /* number of equations on the shortest path to the answer; 0 for the answer itself */
};

struct derivation {
    struct query query; /* a query about the member `state` */
    /* A copy of the session's state, with changes. It shares memory with the original. */
    struct state state;
    struct problem *problem;
    struct arena arena;
    unsigned has; /* the conditions that the train fulfils */
    domq_real theta, height;
    struct step step[STEPS_MOST];
    int count;
    /* The tilts and slopes of all dominoes, at launch and at the tilt of the current sum. */
    struct chain {
        struct domq_link *link;
        size_t count;
    } launch, at;
    size_t i; /* index of the domino whose term is being computed */
};

/* Makes the steps of a derivation: one for each quantity that the answer to the question depends on. The
 * caller must call derivation_end, even after a failure. */
bool derivation_make(struct derivation *derivation, const struct query *query,
                     const struct explained *explained, domq_real value, struct problem *problem);
void derivation_end(struct derivation *derivation);

/* Evaluates an expression of the calculator, such as "launch.J0", in the state of a query. Sets *value to NaN
 * if it has no value. Returns false on an error. */
bool expression_value(const struct query *query, const char *expression, domq_real *value,
                      struct problem *problem);

/* ---- Comparisons with the paper ---- */

extern const struct column recipe_columns[], paper_columns[];
bool run_recipe(const struct query *query, struct answer *a, struct problem *problem);
bool run_paper(const struct query *query, struct answer *a, struct problem *problem);
