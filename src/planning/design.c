/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command 'design', which finds a row with a given safety and a last domino of a given height, and the
 * wishes of 'design' and 'improve', such as 'safety 2 hall 20 m'. */
#include "answer/answer.h"
#include "chance/chance.h"
#include "language/quad.h"
#include "planning/planning.h"
#include "rows/rows.h"
#include "train/train.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* ---- Parsing wishes, in any order ---- */

/* 'design' has the wishes before 'sizes', and 'improve' those from 'hall' on. */
enum wish { FALLS, SAFETY, HALL, GRID, BOARDS, SIZES, WISHES };

static const char *const names[WISHES + 1] = {"falls", "safety", "hall", "grid", "boards", "sizes"};

/* The largest probability that 'falls' accepts. Designs are then tried with 200000 random rows. */
#define FALLS_MOST ((domq_real)9999 / 10000)

static const struct wishes usual_wishes = {.safety = 2, .hall = (domq_real)HUGE_VAL};

struct domq_domino domino_from_double(const struct dom_domino *domino)
{
#define VALUE(member) .member = quad_decimal(domino->member),
#define NONE(...)
    return (struct domq_domino){DOM_MEMBERS_domino(VALUE, NONE, NONE)};
#undef VALUE
#undef NONE
}

const struct wishes *wishes_of(const struct query *query)
{
    return query->given->bound ? query->given->bound : &usual_wishes;
}

const char *design_wishes(const void *context, int k)
{
    (void)context;
    return k < SIZES ? names[k] : NULL;
}

const char *improve_wishes(const void *context, int k)
{
    (void)context;
    return names[k + HALL];
}

/* The wishes as they were parsed. An item that the user did not type is zero. */
struct wishes_parsed {
    struct item value[BOARDS], board[BOARDS_MOST];
    size_t boards;
    /* The unit at the end of the list of boards, in m: 0.01 for '1, 2, 3 cm'. If the list does not end with a
     * unit of length, 0.001, which stands for mm. */
    domq_real board_unit;
    bool sizes;
};

/* Returns the length unit at the end of the text from `from` to `end` in m, or 1 mm if there is none. */
static domq_real unit_at_end(const char *from, const char *end)
{
    char name[8];
    const char *at = end;
    while (at > from && isalpha((unsigned char)at[-1]))
        at--;
    struct quantity unit = {.value = 0};
    if (name_copy(at, (size_t)(end - at), name, sizeof name))
        unit = expression_unit(name);
    return quantity_alike(unit, (struct quantity){.length = 1}) ? unit.value : (domq_real)1 / 1000;
}

/* Parses a list of thicknesses, as in '9, 12, 15 mm'. */
static bool boards_parse(struct reader *r, struct wishes_parsed *w)
{
    static const struct argument board = {.name = "boards", .kind = ARGUMENT_ANY};
    bool more;
    w->boards = 0;
    do {
        if (w->boards == BOARDS_MOST)
            return problem_error(r->problem, "there are more than %d boards; leave some out", BOARDS_MOST);
        r->at = skip_blanks(r->at);
        reader_place(r, r->at);
        r->stops = ",";
        const char *from = r->at;
        const bool good = item_parse(r, &board, &w->board[w->boards++]);
        r->stops = NULL;
        if (!good)
            return false;
        w->board_unit = unit_at_end(from, r->at);
        r->at = skip_blanks(r->at);
        more = *r->at == ',';
        r->at += more;
    } while (more);
    return true;
}

bool wishes_parse(struct reader *r, struct question *q)
{
    const struct argument *own = q->command->argument;
    while (own->parse != wishes_parse)
        own++;
    names_list *const list = own->choices;
    static const struct argument values[BOARDS] = {{.name = "falls", .kind = ARGUMENT_ANY},
                                                   {.name = "safety", .kind = ARGUMENT_ANY},
                                                   {.name = "hall", .kind = ARGUMENT_HEIGHT},
                                                   {.name = "grid", .kind = ARGUMENT_HEIGHT}};
    const struct argument wish = {.name = "WISHES", .kind = ARGUMENT_CHOICE, .noun = "wish", .choices = list};
    struct wishes_parsed *w = q->parsed = reader_memory(r, sizeof *w);
    if (!w)
        return false;
    while (!reader_ends(r)) {
        struct item name;
        reader_place(r, r->at);
        if (!item_parse(r, &wish, &name))
            return false;
        const int k = (int)name.number + (list == improve_wishes ? HALL : 0);
        const bool ends = k != SIZES && reader_ends(r);
        reader_place(r, r->at);
        if (ends)
            return problem_error(r->problem, "the value of '%s' is missing; write, for example, '%s'",
                                 names[k],
                                 k == FALLS    ? "falls 99 %"
                                 : k == SAFETY ? "safety 2"
                                 : k == HALL   ? "hall 20 m"
                                 : k == BOARDS ? "boards 9, 12, 15 mm"
                                               : "grid 1 mm");
        if (k == SIZES)
            w->sizes = true;
        else if (k == BOARDS ? !boards_parse(r, w) : !item_parse(r, &values[k], &w->value[k]))
            return false;
    }
    return true;
}

bool grid_check(domq_real grid, domq_real first, struct problem *problem)
{
    return grid < first || problem_no_answer(problem,
                                             "a grid of %s is too coarse: domino 1 is %s tall and cannot "
                                             "reach across a gap of this length; enter a finer grid",
                                             measured(grid, "m", 6).text, measured(first, "m", 6).text);
}

/* ---- Binding wishes ---- */

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

/* Computes and sorts the thicknesses of the boards. The unit at the end of the list also applies to
 * numbers without a unit, such as the 1 and the 2 in '1, 2, 3 cm'. If the list does not end with a unit,
 * these numbers are in mm, the usual unit for boards. */
static bool boards_bind(const struct question *q, const struct query *query, struct wishes *w,
                        struct problem *problem)
{
    const struct wishes_parsed *parsed = q->parsed;
    struct quantity board[BOARDS_MOST] = {{.value = 0}};
    w->boards = parsed->boards;
    for (size_t i = 0; i < w->boards; i++) {
        domq_real thickness;
        if (!item_bind(&parsed->board[i], q->text, query, &board[i], &thickness, problem))
            return false;
        const bool bare = quantity_is_number(board[i]),
                   length = quantity_alike(board[i], (struct quantity){.length = 1});
        if (!(thickness > 0) || (!bare && !length))
            return problem_error(
                problem, "the thickness of a board must be a length above 0, as in 'boards 9, 12, 15 mm'");
        w->board[i] = (double)(bare ? thickness * parsed->board_unit : thickness);
    }
    qsort(w->board, w->boards, sizeof *w->board, compare);
    return true;
}

bool wishes_bind(const struct question *q, const struct query *query, struct arguments *given,
                 struct problem *problem)
{
    const struct wishes_parsed *parsed = q->parsed;
    struct quantity unit[BOARDS] = {{.value = 0}};
    struct wishes *w = arguments_take(given, sizeof *w, query, problem);
    if (!w)
        return false;
    *w = usual_wishes;
    w->sizes = parsed->sizes;
    domq_real *const value[BOARDS] = {&w->falls, &w->safety, &w->hall, &w->grid};
    for (int k = 0; k < BOARDS; k++)
        if (parsed->value[k].argument &&
            !item_bind(&parsed->value[k], q->text, query, &unit[k], value[k], problem))
            return false;
    if (parsed->value[FALLS].argument &&
        !(quantity_is_number(unit[FALLS]) && w->falls > 0 && w->falls <= FALLS_MOST))
        return problem_error(problem, "'falls' is a probability of at most 99.99 %%, as in 'falls 99 %%'");
    if (!quantity_is_number(unit[SAFETY]))
        return problem_error(
            problem, "the safety is a number without a unit; 2 means twice the energy that a domino needs");
    return boards_bind(q, query, w, problem);
}

/* ---- design ---- */

const struct column design_columns[] = {
    {"s", "h", "the gap divided by the height", 0},
    {"r", "", "the growth from domino to domino", 0},
    {"steps", "", "n, with h r^n = H: the row has n + 1 dominoes", 0},
    {"feet", "m", "the length from the back of the first domino to the front of the last one", 0},
    {"length", "m", "the length of the row, including its fallen last domino", 0},
    {"mass", "kg", "the mass of all dominoes, if masses are known", 0},
    {"safety", "", "the energy of the weakest domino, divided by the energy that it needs", 0},
    {"weakest", "", "the number of the weakest domino", 0},
    {"train", "", "the energy of the endless train, divided by the energy that it needs", 0},
    {"seconds", "s", "the time until the last domino lies on the floor, as 'fall' measures it", 0},
    {"probability", "share", "with 'falls': the share of the random rows that fall", 0},
    {"low", "share", "with 'falls': the lower end of the 95 % interval of the probability", 0},
    {NULL, NULL, NULL, 0},
};

/* A wish, and the design that was found for it. */
struct designing {
    struct dom_wish wish;
    struct dom_limits sizes;
    const struct dom_limits *limits; /* `sizes`, or NULL if the dominoes may have any size */
    struct dom_train train;
    struct dom_compute compute;
    struct dom_design found;
    struct domq_domino *domino; /* the dominoes of the design */
    domq_real mass;             /* the mass of all dominoes in kg, or NaN if it is not known */
    struct dom_study study;     /* the random rows of the last design; no rows without 'falls' */
    size_t tried;               /* the number of its dominoes */
};

static void designing_begin(const struct query *query, const struct wishes *w, struct designing *d)
{
    const struct scene *scene = query->scene;
    *d = (struct designing){.wish = {.first = (double)scene->scale.h,
                                     .height = (double)query->given->number[0],
                                     .safety = (double)w->safety,
                                     .hall = (double)w->hall,
                                     .g = (double)scene->scale.g,
                                     .push = (double)scene_push(scene, scene->scale.h),
                                     .release = (double)scene_release(scene),
                                     .walls = (double)scene_walls(scene),
                                     .boxes_above = (double)scene_boxes_above(scene)},
                            .sizes = {.sizes = true,
                                      .q = (double)scene->train.q,
                                      .hall = (double)w->hall,
                                      .grid = (double)w->grid,
                                      .board = w->board,
                                      .boards = w->boards},
                            .train = train_in_double(&scene->train),
                            .compute = compute_in_double(&scene->compute),
                            .mass = DOMQ_NAN};
    d->limits = w->grid > 0 || w->boards > 0 ? &d->sizes : NULL;
}

/* Finds a design and makes its dominoes. */
static bool design_find(const struct query *query, struct designing *d, struct problem *problem)
{
    const domq_real mass = scene_mass(query->scene);
    struct dom_domino *domino = NULL;
    enum dom_status status = dom_design_find(&d->train, &d->wish, d->limits, &d->compute, &d->found, &domino);
    free(d->domino);
    d->domino = domino ? malloc((d->found.steps + 1) * sizeof *d->domino) : NULL;
    if (domino && !d->domino)
        status = DOM_NO_MEMORY;
    d->mass = mass > 0 ? 0 : DOMQ_NAN;
    for (size_t k = 0; d->domino && k <= d->found.steps; k++) {
        d->domino[k] = domino_from_double(&domino[k]);
        d->domino[k].mass *= mass > 0 ? mass : 1;
        d->mass += d->domino[k].mass;
    }
    free(domino);
    return status == DOM_OK || problem_status(problem, query->scene, status);
}

/* ---- The answer ---- */

/* Explains why no row fulfils the wish and says what the user can change. */
enum { REASON = 640 };
static void infeasible_text(const struct designing *d, domq_real falls, char text[REASON])
{
    const double needs = d->found.needs;
    const struct measured safety = measured(d->wish.safety, "", 6),
                          more = measured(round_digits(quad_decimal(needs), 4, true), "", 4),
                          less = measured(round_digits(quad_decimal(needs), 4, false), "", 4);
    if (d->study.rows > 0)
        snprintf(
            text, REASON,
            "infeasible: no row that was tried falls with a probability of %s; of the last one, with %zu "
            "dominoes, %s; make the errors smaller%s",
            measured(falls, "share", 6).text, d->tried, study_words(&d->study).text,
            isfinite(d->wish.hall) ? ", or the hall longer" : "");
    else if (d->found.limit == DOM_DESIGN_HALL)
        snprintf(
            text, REASON,
            "infeasible: the shortest row that was found with a safety of %s is %s m long, including its "
            "fallen last domino; 'hall %s m' is long enough",
            safety.text, measured(needs, "", 4).text, more.text);
    else if (d->found.limit == DOM_DESIGN_START && needs <= sqrt(2 * d->wish.g / d->wish.first))
        snprintf(text, REASON,
                 "infeasible: the start is too weak for a safety of %s at the second domino; domino 1 "
                 "needs a push of %s at its top; first enter 'set push %.40s'",
                 safety.text, measured(needs * d->wish.first, "m/s", 2).text, more.text);
    else if (d->found.limit == DOM_DESIGN_START) /* a stronger push lifts the first domino off the floor */
        snprintf(text, REASON,
                 "infeasible: no row with a safety of %s was found, whatever the push of domino 1; enter "
                 "a smaller safety%s, or another height of domino 1 with 'set h'",
                 safety.text, d->limits ? ", other boards or a finer grid" : "");
    else if (needs > 1)
        snprintf(text, REASON,
                 "infeasible: no growth gives a safety of %s here; a safety below %s is possible",
                 safety.text, less.text);
    else
        snprintf(text, REASON, "infeasible: not even equal dominoes keep falling here, whatever the gap%s",
                 d->train.mu > 0 ? "; enter a smaller friction" : "");
}

/* Writes the numbers of a design. If none was found, most of them are NaN. */
static void design_row(struct answer *a, const struct designing *of, const char *reason)
{
    const struct dom_design *d = &of->found;
    const struct dom_study *s = &of->study;
    const struct cell none = cell_real(DOMQ_NAN);
    answer_row(a,
               ROW(cell_real(d->s), cell_computed(d->r),
                   d->steps > 0 ? cell_count((domq_real)d->steps) : none, cell_narrow(d->feet, 5),
                   cell_narrow(d->length, 5), cell_narrow(of->mass, 5), cell_narrow(d->row, 5),
                   d->weakest > 0 ? cell_count((domq_real)d->weakest) : none, cell_narrow(d->train, 5),
                   cell_narrow(d->seconds, 5),
                   s->rows > 0 ? cell_computed((domq_real)s->fall / (domq_real)s->rows) : none,
                   s->rows > 0 ? cell_computed((domq_real)s->low) : none),
               reason);
}

/* Prints how safe the design is. */
static void design_say(const struct query *query, struct answer *a, const struct designing *d)
{
    const struct dom_design *f = &d->found;
    const struct scene *scene = query->scene;
    char growth[160] = "", weakest[CELL_TEXT + 120] = "", boxes[192];
    if (f->weakest > 0)
        snprintf(weakest, sizeof weakest, " The weakest, domino %zu, %s.", f->weakest,
                 energy_words(f->row).text);
    if (!d->limits)
        snprintf(growth, sizeof growth,
                 ", each %.4g times as large as the one before, with gaps of %.4g times the height", f->r,
                 f->s);
    if (scene_boxes_above(scene) > 0)
        snprintf(boxes, sizeof boxes, "dominoes, those above %s hollow",
                 measured(scene_boxes_above(scene), "m", 4).text);
    else
        snprintf(boxes, sizeof boxes, "%s", dominoes_words(scene->train.q, "dominoes").text);
    answer_say(a, "%zu %s%s; the last is %s tall, and the row %s long.%s", f->steps + 1, boxes, growth,
               measured(d->wish.height, "m", 4).text, measured(f->length, "m", 4).text, weakest);
    if (query->next && scene_engine(&query->next->scene))
        answer_say(
            a,
            "This is an answer of the model, which treats feet as hinges; 'verdict' runs the row in the "
            "rigid-body engine, because %s.",
            scene_engine(&query->next->scene));
}

/* Makes the design the row of the session. */
static bool design_keep(struct state *next, const struct designing *d, struct problem *problem)
{
    const size_t steps = d->found.steps;
    const domq_real count = (domq_real)steps + 1, s = quad_decimal(d->found.s),
                    r = quad(pow)(d->domino[steps].height / next->scene.scale.h, 1 / (domq_real)steps);
    return parameter_set(next, parameter_find("row"), &count, 1, NULL, problem) &&
           parameter_set(next, parameter_find("s"), &s, 1, NULL, problem) &&
           parameter_set(next, parameter_find("r"), &r, 1, NULL, problem) &&
           (!d->limits || scene_row_set(&next->scene, d->domino, steps + 1, true, problem));
}

/* ---- Designs that fall with a probability ---- */

/* At most this many numbers of dominoes are tried. With more dominoes than that, their errors add up. */
enum { NUMBERS_MOST = 25 };

/* Counts how many random rows of a design fall. If they fall with the probability `falls`, at least 20 of
 * them (10 in the engine) are expected not to fall; fewer failures would say little about it. */
static bool design_study(const struct query *query, struct designing *d, domq_real falls,
                         struct problem *problem)
{
    struct state state = *query->state;
    struct query of_row = *query;
    struct dom_random_error error[DOM_ERROR_COUNT];
    const bool engine = query->next && scene_engine(&query->next->scene);
    const double rows = ceil((engine ? 10 : 20) / (double)(1 - falls));
    state.scene.slot = NULL;
    of_row.state = &state;
    of_row.scene = &state.scene;
    const bool good = design_keep(&state, d, problem) &&
                      study_run(&of_row, problem, (size_t)fmax(rows, engine ? 100 : 2000), &d->study, error);
    slot_drop(state.scene.slot);
    return good;
}

/* Tries designs with more and more dominoes, until the lower end of the interval reaches the probability. */
static bool falls_find(const struct query *query, domq_real falls, struct designing *d,
                       struct problem *problem)
{
    struct dom_random_error error[DOM_ERROR_COUNT];
    if (!errors_check(query->scene, problem))
        return false;
    if (!scene_errors(query->scene, error))
        return problem_no_errors(problem, "'falls'");
    for (int k = 0; k < NUMBERS_MOST; k++) {
        if (!design_find(query, d, problem))
            return false;
        if (d->found.limit != DOM_DESIGN_FITS)
            break;
        d->tried = d->found.steps + 1;
        if (!design_study(query, d, falls, problem))
            return false;
        if ((domq_real)d->study.low >= falls)
            return true;
        d->wish.dominoes = d->tried + 1;
    }
    d->found.limit = d->found.limit == DOM_DESIGN_FITS ? DOM_DESIGN_SAFETY : d->found.limit;
    return true;
}

/* Prints the answer. If the command can change the session, the design becomes the row of the session. */
static bool design_answer(const struct query *query, struct answer *a, struct designing *d,
                          struct problem *problem)
{
    const bool keeps = a->out && !a->sink.take && query->next;
    struct query of_row = *query;
    struct answer list = {.out = answer_rest(a), .style = a->style};
    if (keeps && !design_keep(query->next, d, problem))
        return false;
    of_row.scene = keeps ? &query->next->scene : NULL;
    if (keeps && a->path && !a->style.format->for_people)
        return row_list(&of_row, 0, a, problem);
    design_row(a, d,
               isinf(d->found.row)
                   ? "no domino after the first needs energy to fall over, so no safety is known"
                   : NULL);
    if (answer_for_people(a))
        design_say(query, a, d);
    if (d->study.rows > 0)
        answer_say(a, "%s, with 95 %% confidence.", study_words(&d->study).text);
    answer_detail(a, "%s", "");
    if (list.out && keeps && !row_list(&of_row, 0, &list, problem))
        return false;
    if (keeps)
        answer_say(a, "The session now has this row: 'row' lists it, 'fall' runs it, 'undo' takes it back.");
    return true;
}

bool run_design(const struct query *query, struct answer *a, struct problem *problem)
{
    const struct wishes *w = wishes_of(query);
    struct designing d;
    char reason[REASON];
    designing_begin(query, w, &d);
    if (!grid_check(w->grid, query->scene->scale.h, problem))
        return false;
    if (!(d.wish.height > d.wish.first))
        return problem_no_answer(problem,
                                 "H = %s is not more than the height of the first domino, h = %s; enter a "
                                 "larger H, or a smaller h with 'set h'",
                                 measured(d.wish.height, "m", 6).text, measured(d.wish.first, "m", 6).text);
    bool good = w->falls > 0 ? falls_find(query, w->falls, &d, problem) : design_find(query, &d, problem);
    const bool fits = d.found.limit == DOM_DESIGN_FITS;
    if (good)
        answer_set_verdict(a, fits);
    if (good && fits)
        good = design_answer(query, a, &d, problem);
    else if (good) {
        infeasible_text(&d, w->falls, reason);
        if (a->path && !a->style.format->for_people) /* no file is written without a row */
            good = problem_no_answer(problem, "%s", reason);
        else
            answer_say(a, "%s.", reason);
        if (good && !answer_for_people(a))
            design_row(a, &d, reason);
    }
    free(d.domino);
    return good;
}
