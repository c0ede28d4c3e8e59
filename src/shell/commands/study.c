/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows with random errors, and the floor that hinges need. */
#include "commands/falling.h"
#include "commands/tables.h"
#include "language/quad.h"
#include "parallel/workers.h"
#include <stdlib.h>

/* The scene's row and errors; false: there are none, which was reported. */
static bool study_make(struct session *session, domq_real rows, struct task_pool *pool,
                       struct scene_row *scene, struct domq_placement *p)
{
    const struct effect_state *errors = &session->effect[DOM_EFFECT_placement];
    if (!scene_row_make(session, scene))
        return false;
    if (!errors->on) {
        free(scene->domino);
        session_error(session, "no errors of placement are asked for: 'effect placement SIGMA' first");
        return false;
    }
    *p = (struct domq_placement){
        .sigma = errors->value[0],
        .heights = errors->value[1],
        .seed = (unsigned long)session->seed,
        .rows = (size_t)rows,
        .parallel = workers_tasks,
        .pool = pool,
    };
    pool->threads = session->threads;
    pool->interrupt = session->compute.interrupt;
    return true;
}

/* ---- placement ---- */

static bool placement_all(struct session *session, const struct call *call, const struct scene_row *scene,
                          const struct domq_placement *p)
{
    struct domq_study study;
    size_t *stops = calloc(scene->row.count, sizeof *stops);
    enum dom_status status =
        stops ? domq_placement_study(&scene->row, &scene->compute, p, &study, stops) : DOM_NO_MEMORY;
    if (status == DOM_OK)
        study_answer(call, p->sigma, p->heights, &study, stops, scene->row.count, NULL);
    free(stops);
    return status == DOM_OK || row_status(session, status);
}

static bool run_placement(struct session *session, const struct call *call)
{
    struct scene_row scene;
    struct domq_placement p;
    struct task_pool pool = {.progress = true};
    domq_real rows = call->count > 0 ? call->number[0] : 2000;
    if (!study_make(session, rows, &pool, &scene, &p))
        return false;
    bool done = session->shard.parts > 0 ? study_blocks(session, call, &scene, &p)
                                         : placement_all(session, call, &scene, &p);
    free(scene.domino);
    return done;
}

/* ---- budget ---- */

static const struct column budget_columns[] = {
    {"probability", "", "with which the whole row is to fall", 0},
    {"sigma", "m", "the errors of the gaps that allow it", 0},
    {"low", "m", "95 % interval of that, by the number of rows", 0},
    {"high", "m", "", 0},
    {"rows", "", "that were set up at each sigma", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_budget(struct session *session, const struct call *call)
{
    struct scene_row scene;
    struct domq_placement p;
    struct domq_budget budget;
    struct task_pool pool = {.progress = false}; /* how many studies it takes is not known */
    domq_real share = call->number[0], rows = call->count > 1 ? call->number[1] : 1000;
    if (!(share > 0 && share < 1))
        return session_error(session, "P = %s is no probability for this; P is between 0 and 1, such as 0.9",
                             quad_shown(share).text);
    if (!study_make(session, rows, &pool, &scene, &p))
        return false;
    enum dom_status status = domq_placement_budget(&scene.row, &scene.compute, &p, (double)share, &budget);
    free(scene.domino);
    if (status == DOM_STOPS)
        return session_no_answer(session, p.heights > 0
                                              ? "even with every gap exact fewer rows than that fall"
                                              : "even placed without any error the row does not fall: 'mend' "
                                                "looks for what saves it");
    if (status != DOM_OK)
        return session_status(session, status);
    bool free_of_it = !isfinite(budget.sigma);
    return answer_row(call->answer,
                      ROW(cell_real(share), cell_bound((domq_real)budget.sigma, DOMQ_NAN),
                          cell_bound((domq_real)budget.low, DOMQ_NAN),
                          cell_bound((domq_real)budget.high, DOMQ_NAN), cell_count(rows)),
                      free_of_it ? "errors as large as the largest gap still leave this probability" : NULL);
}

/* ---- slip ---- */

static const struct column slip_columns[] = {
    {"needs", "", "friction that the floor needs: the larger of the two below", 0},
    {"motion", "", "in motion, |R_x| / R_z", 0},
    {"theta", "rad", "tilt of the head then", 0},
    {"domino", "", "whose hinge: 0 = head, 1, 2, ... behind it", 0},
    {"hit", "", "the same in the collision, of impulses", 0},
    {"hit_domino", "", "", 0},
    {"slips", "", "more than 'effect floor' has?", 0},
    {NULL, NULL, NULL, 0},
};

static bool run_slip(struct session *session, const struct call *call)
{
    struct domq_floor f;
    const struct effect_state *floor = &session->effect[DOM_EFFECT_floor];
    enum dom_status status = domq_cycle_floor(&session->train, &session->compute, &f);
    if (status != DOM_OK)
        return session_status(session, status);
    bool slips = f.motion > floor->value[0] || f.hit > floor->value[0];
    struct cell motion = cell_narrow(f.motion, 6);
    answer_row(
        call->answer,
        ROW(f.hit > f.motion ? cell_bound(f.hit, DOMQ_NAN) : motion, motion, cell_bound(f.theta, DOMQ_NAN),
            cell_count((domq_real)f.domino), cell_bound(f.hit, DOMQ_NAN), cell_count((domq_real)f.hit_domino),
            floor->on ? cell_flag(slips) : cell_real(DOMQ_NAN)),
        !isfinite(f.motion) || !isfinite(f.hit) ? "a domino is lifted off the floor: no friction holds it"
                                                : NULL);
    if (floor->on && !slips)
        answer_say(call->answer, "A floor with %.4g holds every hinge.", (double)floor->value[0]);
    else if (floor->on)
        answer_say(call->answer, "A floor with %.4g does not hold: domino %zu slips first, %s.",
                   (double)floor->value[0], f.hit > floor->value[0] ? f.hit_domino : f.domino,
                   f.hit > floor->value[0] ? "in the collision" : "in motion");
    else
        answer_say(call->answer, "'effect floor MU' says what the floor has; 'fall' with it looks at a row.");
    return true;
}

const struct command study_commands[] = {
    {.name = "placement",
     .synonyms = "probability chance random risk precision",
     .argument = {{.name = "ROWS", .kind = ARGUMENT_COUNT, .optional = true}},
     .summary = "the probability that the whole row falls, and where not",
     .help = "The scene's row is set up ROWS times (2000), each gap with a random error: 'effect placement "
             "SIGMA'. Row number i is the same for the same 'seed', whatever 'threads' is. ^C stops it. With "
             "'domino --shard 2/7' it is the second of seven parts of the study, and answers with counts of "
             "blocks of 100 rows, which 'pool' adds up.",
     .example = "effect row 13; effect placement 8 mm; placement 500",
     .see = "pool budget effect",
     .principal = "probability",
     ANSWER(placement)},
    {.name = "pool",
     .synonyms = "cluster parallel merge combine add",
     .argument = {{.name = "FILE", .kind = ARGUMENT_FILE}},
     .summary = "what 'placement' answers, from the parts of a study",
     .help = "FILE, or '-' for standard input, is the outputs of 'domino --shard I/N' with 'set output csv' "
             "and 'placement' for all I, one behind the other in any order. The answer is that of the whole "
             "study, digit for digit. Rows that are missing are told, rows that stand there twice and blocks "
             "of another study are errors.",
     .see = "placement",
     .columns = placement_columns,
     .unswept = "it reads a file",
     .principal = "probability",
     .files = true,
     .run = run_pool},
    {.name = "budget",
     .synonyms = "probability chance random precision spacing tolerance",
     .argument = {{.name = "P", .kind = ARGUMENT_ANY},
                  {.name = "ROWS", .kind = ARGUMENT_COUNT, .optional = true}},
     .summary = "the errors of gaps that allow success with probability P",
     .help = "The sigma at which the share P of ROWS rows (1000) falls, the same rows at every sigma.",
     .example = "effect row 13; effect placement 1 mm; budget 0.9 200",
     .see = "placement mend",
     .principal = "sigma",
     ANSWER(budget)},
    {.name = "slip",
     .synonyms = "foot feet slide slippery ground",
     .train = true,
     .summary = "the floor friction that the train's hinges need",
     .help = "In motion, over the whole cycle and all dominoes that move, and in the collision.",
     .example = "effect floor 0.5; slip",
     .see = "effect fall",
     .principal = "needs",
     ANSWER(slip)},
    {.name = NULL},
};
