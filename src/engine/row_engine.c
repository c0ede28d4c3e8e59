/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs the row of a scene in the engine: converts dominoes to boxes, and what the engine finds to the answers
 * that the library and the commands ask for. To add an effect, add its description and its number here, its
 * name to feature.mk, and its code to the engine. */
#include "engine/engine.h"
#include "interpreter/command.h"
#include "language/quad.h"
#include "precision/any.h"
#include "rows/rows.h"
#include <stdlib.h>
#include <string.h>

/* ---- Conversion between the library's and the engine's rows and units ---- */

/* The units in which the engine computes: the height h and the mass of the first domino, and the time
 * sqrt(h/g). With these units, rounding errors do not depend on the size of the dominoes. */
struct unit {
    double length, mass, time;
};

static struct unit unit_of(const struct dom_domino *first, double g)
{
    return (struct unit){first->height, first->mass, sqrt(first->height / g)};
}

/* Converts a row to the engine's units. The caller frees the dominoes, even after a failure. */
static enum dom_status row_convert(const struct dom_row *row, struct engine_row *engine,
                                   struct dom_domino **dominoes)
{
    const struct scene_engine *of_scene = row->engine->context;
    const struct unit unit = unit_of(row->domino, row->g);
    struct dom_domino *to = *dominoes = malloc(row->count * sizeof *to);
    struct dom_row *r = &engine->row;
    if (!to)
        return DOM_NO_MEMORY;
    for (const struct dom_domino *d = row->domino; d < row->domino + row->count; d++, to++) {
        *to = (struct dom_domino){.height = d->height / unit.length,
                                  .thickness = d->thickness / unit.length,
                                  .gap = d->gap / unit.length,
                                  .mass = d->mass / unit.mass,
                                  .radius = d->radius / unit.length,
                                  .width = d->width / unit.length};
        if (!(to->height > 0 && to->thickness > 0 && to->gap >= 0 && to->mass > 0) ||
            !isfinite(to->height + to->thickness + to->gap + to->mass))
            return DOM_BAD_HEIGHT;
    }
    *engine = (struct engine_row){.row = *row, .bounce = of_scene->bounce};
    r->domino = *dominoes;
    r->g = 1;
    r->push *= unit.time;
    r->feet = fmax(of_scene->feet + row->feet, 0);
    r->walls /= unit.length;
    r->boxes_above /= unit.length;
    r->release = 0;
    if (!(row->release > 0) || isnan(row->push))
        return DOM_OK;
    const enum dom_status status = dom_row_touch(row, NULL, &r->release);
    r->release = fmin(row->release, r->release);
    return status;
}

/* Reports the hits, in m, s and kg. */
static void hits_visit(const struct engine_hit *hit, const struct engine_fall *fall, struct unit unit,
                       dom_fall_visit *visit, void *context)
{
    const double none = DOM_NAN, speed = unit.length / unit.time;
    bool more = true;
    for (size_t k = 0; k < fall->hits && more; k++) {
        const double until = k + 1 < fall->hits ? hit[k + 1].time : fall->all ? fall->seconds : none;
        more = visit(&(struct dom_fall){.domino = k + 1,
                                        .time = hit[k].time * unit.time,
                                        .duration = (until - hit[k].time) * unit.time,
                                        .omega = hit[k].omega / unit.time,
                                        .kinetic = hit[k].kinetic * unit.mass * speed * speed,
                                        .barrier = none,
                                        .margin = none,
                                        .lost = none,
                                        .friction_work = none,
                                        .theta_m = none,
                                        .theta = none,
                                        .moving = k + 1},
                     context);
    }
}

static void verdict_fill(const struct engine_fall *fall, const struct dom_row *row, double seconds,
                         struct dom_verdict *verdict)
{
    const size_t last = fall->hits - 1;
    bool beyond = fall->lies && !fall->all && row->domino[last + 1].gap >= row->domino[last].height;
    *verdict = (struct dom_verdict){.end = fall->all                                      ? DOM_ROW_FALLS
                                           : fall->leans                                  ? DOM_ROW_LEANS
                                           : beyond                                       ? DOM_ROW_MISSES
                                           : last == 0 && !fall->lies && row->release > 0 ? DOM_ROW_BACK
                                                                                          : DOM_ROW_STOPS,
                                    .domino = fall->hits,
                                    .short_by = fall->all ? 0 : DOM_NAN,
                                    .seconds = seconds,
                                    .spare = DOM_NAN};
}

static enum dom_status row_watch(const struct dom_row *row, const struct dom_compute *compute,
                                 const double *times, size_t count, dom_moment_visit *visit, void *context,
                                 double *feet);

/* Runs a row in the engine. The library calls this function through struct dom_engine. */
static enum dom_status run_row(const struct dom_row *row, const struct dom_compute *compute, bool times,
                               dom_fall_visit *visit, void *context, struct dom_verdict *verdict)
{
    const struct scene_engine *of_scene = row->engine->context;
    const struct unit unit = unit_of(row->domino, row->g);
    struct engine_row engine;
    struct dom_domino *dominoes;
    struct engine_fall fall = {.same = false};
    struct engine_hit *hit = times ? malloc(row->count * sizeof *hit) : NULL;
    enum dom_status status = row_convert(row, &engine, &dominoes);
    if (times && !hit)
        status = DOM_NO_MEMORY;
    if (status == DOM_OK)
        status = engine_settle(&engine, times, compute->interrupt, hit, &fall);
    if (status == DOM_OK && times && !fall.same)
        status = DOM_NOT_CONVERGED;
    if (status == DOM_OK)
        verdict_fill(&fall, row, times ? fall.seconds * unit.time : (double)NAN, verdict);
    if (status == DOM_OK && times) {
        struct engine_report *report = of_scene->report;
        for (size_t k = 0; k < fall.hits && report; k++)
            report->slid[k] = hit[k].slid * unit.length;
        if (report)
            *report = (struct engine_report){.slid = report->slid,
                                             .lies = fall.lies,
                                             .change = fall.change,
                                             .steps = fall.grain.steps,
                                             .tolerance = fall.grain.tolerance,
                                             .zero = fall.zero * unit.time,
                                             .version = engine_version(),
                                             .watch = row_watch};
        if (visit)
            hits_visit(hit, &fall, unit, visit, context);
    }
    free(hit);
    free(dominoes);
    return status;
}

/* ---- Runs that are watched ---- */

struct watch {
    struct unit unit;
    double zero;          /* the reading of the engine's clock in s when the visitor's clock reads 0 */
    const double *times;  /* the next times to visit, in s */
    size_t left;          /* the number of elements left in `times` */
    double *tilt, *omega; /* the tilts and angular velocities of the dominoes after the last step */
    double *feet;         /* how far the feet have slid by the end of the last step, in m */
    double time;          /* the time of the last step, in s */
    size_t head;
    dom_moment_visit *visit;
    void *context;
    bool more; /* the visitor has not asked to stop */
};

/* Passes the state after the last step, and its time in s, to the visitor. */
static void watch_visit(struct watch *w, double time)
{
    const struct dom_moment moment = {
        .time = time, .head = w->head + 1, .moving = w->head + 1, .tilt = w->tilt, .omega = w->omega};
    w->more = w->visit(&moment, w->context);
    w->times++;
    w->left--;
}

/* The engine calls this function after each step. */
static bool watch_step(const struct world *world, void *context)
{
    struct watch *w = context;
    const double time = world->now * w->unit.time - w->zero, dt = time - w->time;
    w->time = time;
    w->head = world->head;
    for (size_t k = 0; k < world->count; k++) {
        const double tilt = world_tilt(world, k);
        w->omega[k] = dt > 0 ? (tilt - w->tilt[k]) / dt : 0;
        w->tilt[k] = tilt;
        w->feet[k] = world_slid(world, k) * w->unit.length;
    }
    /* Steps are so short that the state after a step serves for all times within the step. */
    while (w->more && w->left > 0 && *w->times <= time)
        watch_visit(w, *w->times);
    return w->more && w->left > 0;
}

static enum dom_status row_watch(const struct dom_row *row, const struct dom_compute *compute,
                                 const double *times, size_t count, dom_moment_visit *visit, void *context,
                                 double *feet)
{
    const struct scene_engine *of_scene = row->engine->context;
    const struct engine_report *report = of_scene->report;
    const struct engine_grain grain = {.steps = report->steps, .tolerance = report->tolerance};
    struct watch w = {.zero = report->zero,
                      .times = times,
                      .left = count,
                      .feet = feet,
                      .visit = visit,
                      .context = context,
                      .time = -report->zero,
                      .more = true};
    struct engine_fall fall;
    struct engine_row engine;
    struct dom_domino *dominoes = NULL;
    memset(feet, 0, row->count * sizeof *feet);
    w.unit = unit_of(row->domino, row->g);
    w.tilt = calloc(2 * row->count, sizeof *w.tilt);
    w.omega = w.tilt ? w.tilt + row->count : NULL;
    enum dom_status status = w.tilt ? row_convert(row, &engine, &dominoes) : DOM_NO_MEMORY;
    if (status == DOM_OK)
        status = engine_run(&engine, &grain, compute->interrupt, NULL, watch_step, &w, &fall);
    /* The state no longer changes after the motion has ended. */
    while (status == DOM_OK && w.more && w.left > 0)
        watch_visit(&w, w.time);
    free(dominoes);
    free(w.tilt);
    return status;
}

/* ---- Preparation ---- */

/* The smallest relative tolerance of searches that run the engine. */
#define ENGINE_TOL ((domq_real)1 / 10000)

/* The numbers of the effects. */
static int feet_number, bounce_number;

/* The values of the parameter 'method'. */
enum { METHOD_MODEL, METHOD_ENGINE };

static const char *engine_why(const struct scene *scene)
{
    return scene->effect[feet_number].on     ? "feet is on"
           : scene->effect[bounce_number].on ? "bounce is on"
           : scene->method == METHOD_ENGINE  ? "method is engine"
                                             : NULL;
}

/* Returns true if the engine includes all effects that are on. Otherwise reports the problem. */
static bool effects_check(const struct scene *scene, struct problem *problem)
{
    const unsigned known = 1U << DOM_EFFECT_friction | 1U << DOM_EFFECT_slope | 1U << DOM_EFFECT_edges |
                           1U << DOM_EFFECT_walls | 1U << DOM_EFFECT_row | 1U << DOM_EFFECT_push |
                           1U << DOM_EFFECT_release;
    for (int k = 0; k <= DOM_EFFECT_COUNT; k++) {
        const int effect = k < DOM_EFFECT_COUNT ? k : floor_number;
        if (scene->effect[effect].on && !(known >> k & 1))
            return problem_error(problem,
                                 "the rigid-body engine runs this row because %s, but does not include %s; "
                                 "first enter 'set %s off'",
                                 engine_why(scene), effect_at(effect)->name, effect_at(effect)->name);
    }
    return true;
}

static bool row_make(const struct scene *scene, struct scene_row *row, struct problem *problem)
{
    const struct effect_state *feet = &scene->effect[feet_number], *bounce = &scene->effect[bounce_number];
    const char *why = engine_why(scene);
    if (!effects_check(scene, problem))
        return false;
    if (row->row.count > ENGINE_MOST)
        return problem_error(problem,
                             "a row of %zu dominoes is too long for the rigid-body engine, which runs this "
                             "row because %s; the maximum is %d; enter, for example, 'set row 20'",
                             row->row.count, why, ENGINE_MOST);
    const enum dom_status loaded = engine_load();
    if (loaded == DOM_NO_MEMORY)
        return problem_status(problem, scene, DOM_NO_MEMORY);
    if (loaded != DOM_OK)
        return problem_error(
            problem,
            "%s, but the rigid-body engine Chipmunk 7 is not installed; on Debian, run 'apt-get "
            "install libchipmunk7'",
            why);
    row->engine = (struct scene_engine){.engine = {.run = run_row, .context = &row->engine},
                                        .feet = feet->on ? (double)feet->value[0] : HUGE_VAL,
                                        .bounce = bounce->on ? (double)bounce->value[0] : 0};
    row->row.engine = &row->engine.engine;
    row->compute.tol = quad_larger(row->compute.tol, ENGINE_TOL);
    return true;
}

static const struct engine_driver chipmunk_driver = {
    .train_note = "This answer is about dominoes that turn about a hinge. The rigid-body engine runs rows: "
                  "'set row 20; fall'.",
    .why = engine_why,
    .make = row_make};

/* ---- Effects ---- */

static const struct domq_effect feet = {
    .name = "feet",
    .synonyms = "foot slip slide slippery floor ground hinge engine chipmunk",
    .adds = "feet that can slip on the floor, instead of hinges",
    .help = "Feet are not hinged to the floor. A foot may lift off, and it slides if friction with the "
            "coefficient MU cannot hold it, during the motion or in a collision. The equations of the train "
            "have one degree of freedom and cannot describe this, so the rigid-body engine Chipmunk 7 runs "
            "the row. 'fall' reports how far feet slide. The time step of the engine is halved until the "
            "verdict and the times no longer change. The result depends on the start: a push of more than "
            "sqrt(2 g/h) lifts the first domino and throws it at the second. 'rowmax' finds the largest "
            "growth at which such a row falls; 'rmax' is for the endless train, whose feet are hinges.",
    .source = "Chipmunk 7, a rigid-body engine; Coulomb friction",
    .argument = {{.name = "MU",
                  .unit = "",
                  .meaning = "friction coefficient of the floor",
                  .lowest = 0,
                  .highest = 100,
                  .usual = (domq_real)1 / 2}},
    .needs = 1U << DOM_EFFECT_row,
    .dissipates = "sliding feet",
};

static const struct domq_effect bounce = {
    .name = "bounce",
    .synonyms = "restitution elastic elasticity rebound engine chipmunk",
    .adds = "dominoes that bounce off each other",
    .help = "After a collision, two dominoes separate at E times the speed at which they met. With E = 0, as "
            "in the paper, they stay together, and with E = 1 no energy is lost. The rigid-body engine "
            "Chipmunk 7 runs the row. The dominoes collide again and again, more and more softly, until they "
            "stay together. Up to E = 0.2, the largest growth changes by less than 0.2 %.",
    .source = "Chipmunk 7, a rigid-body engine; Newton's law of restitution",
    .argument = {{.name = "E",
                  .unit = "",
                  .meaning = "restitution between dominoes",
                  .lowest = 0,
                  .highest = 1,
                  .usual = (domq_real)1 / 5}},
    .needs = 1U << DOM_EFFECT_row,
    .dissipates = "bounces",
};

static const char method_help[] =
    "With 'engine', the rigid-body engine Chipmunk 7 runs every row, as an independent check: it uses "
    "none of the program's equations, and includes contacts that the model lacks. The time step is halved "
    "until the verdict no longer changes. One run takes about a hundred times as long, and a row can "
    "have at most 200 dominoes. With 'model', the engine runs only rows with 'set feet' or 'set bounce'. "
    "Endless trains always use the model.";

static const struct parameter method_parameter = {
    .name = "method",
    .offset = offsetof(struct state, scene.method),
    .meaning = "how rows are computed: by the model, or by a rigid-body engine",
    .value = (const struct domq_effect_argument[]){{.name = "method", .unit = "", .usual = METHOD_MODEL}},
    .synonyms = "engine chipmunk simulation second opinion compare check",
    .words = (const struct word[]){{"model", METHOD_MODEL}, {"engine", METHOD_ENGINE}, {NULL, 0}},
    .words_only = true,
    .help = method_help};
static const struct parameter
    feet_parameter = {.effect = &feet,
                      .number = &feet_number,
                      .by_engine = true,
                      .example = "set q hollow; set row 8; set feet 0.4; fall; set feet off; set row off",
                      .from = 0.05,
                      .to = 2},
    bounce_parameter = {.effect = &bounce,
                        .number = &bounce_number,
                        .by_engine = true,
                        .example =
                            "set q hollow; set row 8; set bounce 0.5; verdict; set bounce off; set row off",
                        .to = 1};

const struct feature engine_feature = {.name = "engine",
                                       .engine = &chipmunk_driver,
                                       .parameters = (const struct parameter *const[]){
                                           &method_parameter, &feet_parameter, &bounce_parameter, NULL}};
