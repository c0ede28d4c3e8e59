/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The answer of a command, and its errors. */
#include "interpreter/question.h"

/* A sink (answer.h) that writes nothing. */
static void row_drop(struct answer *answer, const struct cell *cells, const char *reason)
{
    (void)answer, (void)cells, (void)reason;
}

/* Computes an answer in quad precision. */
static void reference_compute(const struct command *c, const struct query *query, const struct answer *answer,
                              struct reference *reference)
{
    struct state state;
    struct query exact;
    struct problem ignored;
    struct domq_angles angles;
    struct arguments given = *query->given;
    struct answer a = *answer;
    const struct domq_arithmetic quad = any_arithmetic(IN_QUAD);
    problem_begin(&ignored, c->name);
    reference->is_void = quad.bits == 0 || !query_with(query, NULL, 0, &state, &exact, &ignored);
    if (reference->is_void)
        return;
    /* If the session computes in quad precision, too, the reference must have another tolerance, so that the
     * sums and the iterations end elsewhere. */
    struct any_compute *compute = &state.scene.compute;
    compute->tol = compute->precision != IN_QUAD || compute->tol > 100 * quad.tol_default ? quad.tol_default
                   : compute->tol >= 100 * quad.tol_floor                                 ? compute->tol / 100
                                                          : compute->tol * 100;
    compute->precision = IN_QUAD;
    state.settings.style.errors = 0;
    state.settings.threads = 1; /* the rows come in order */
    /* A tilt that the session has rounded up to theta_c must not exceed theta_c in quad precision. */
    for (int i = 0; i < given.count; i++) {
        const enum argument_kind kind = c->argument[i].kind;
        if ((kind == ARGUMENT_TILT || kind == ARGUMENT_PLACE) &&
            any_angles_find(&state.scene.train, compute, &angles) == DOM_OK)
            given.number[i] = quad_smaller(given.number[i], angles.theta_c);
    }
    exact.given = &given;
    exact.reference = reference;
    a.sink.take = row_drop;
    a.errors.recorder = reference;
    a.details.brief = NULL;
    a.details.rest = NULL;
    a.kept = NULL;
    a.style.errors = 0;
    reference->is_void = !c->run(&exact, &a, &ignored) || reference->is_void;
}

/* Runs the command. Fails if the verdict is no and the search wants only answers whose verdict is yes. */
static bool command_run(const struct command *c, const struct query *query, struct answer *answer,
                        struct problem *problem)
{
    return c->run(query, answer, problem) &&
           (!c->sweep.needs_yes || !query->run_context->seeks_yes || answer->verdict != ANSWER_NO ||
            problem_no_answer(problem, "the verdict of '%s' is no%s%s", c->name,
                              *answer->late_reason ? ": " : "", answer->late_reason));
}

bool command_compute(const struct command *c, const struct query *query, struct answer *answer,
                     struct problem *problem)
{
    /* The engine computes in double precision only. */
    const bool has_errors = c->precision == PRECISION_AS_SET && (c->train || !scene_has_engine(query->scene));
    if (query->reference && !(has_errors && query->scene->compute.precision == IN_QUAD))
        query->reference->is_void = true;
    if (c->precision == PRECISION_DOUBLE) {
        struct scene scene = *query->scene; /* shares the memory of the original */
        struct query in_double = *query;
        scene.compute.tol = (domq_real)compute_in_double(&scene.compute).tol;
        scene.compute.precision = IN_DOUBLE;
        in_double.scene = &scene;
        answer->in_double = true;
        return command_run(c, &in_double, answer, problem);
    }
    if (!has_errors || !query->state->settings.style.errors || (!answer->out && !answer->sink.take))
        return command_run(c, query, answer, problem);
    struct reference reference = {.is_void = false};
    answer->errors.row = 0;
    reference_compute(c, query, answer, &reference);
    answer->errors.reference = &reference;
    const bool done = command_run(c, query, answer, problem);
    answer->errors.reference = NULL;
    reference_free(&reference);
    return done;
}
