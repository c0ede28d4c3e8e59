/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/picture/stage.h"
#include "language/quad.h"
#include <math.h>
#include <stdlib.h>

/* the maximum number of dominoes of a train */
enum { DOMINOES = 200 };
/* the smallest domino that is drawn, relative to the head; a smaller one would be a dot */
#define SMALLEST 0.01
/* the maximum width of a picture, relative to its height; dominoes that do not fit are not drawn */
#define WIDEST 2.4
/* the maximum height of a picture, relative to the head; a taller domino is cut off */
#define TALLEST 2.5

/* ---- One domino ---- */

static struct point direction(double theta)
{
    return (struct point){(double)quad(sin)((domq_real)theta), (double)quad(cos)((domq_real)theta)};
}

void drawn_corners(struct drawn *k)
{
    struct point up = direction(k->theta);
    /* The rounded foot rolls, so its centre moves forwards by radius * theta. */
    k->corner[0] =
        (struct point){k->foot + k->radius * (k->theta + up.y - 1 - up.x), k->radius * (1 - up.y - up.x)};
    k->corner[1] = along(k->corner[0], k->height, up.x, up.y);
    k->corner[2] = along(k->corner[1], k->thickness, -up.y, up.x);
    k->corner[3] = along(k->corner[0], k->thickness, -up.y, up.x);
}

/* The right half of a silhouette, from the ground up. The axis of the silhouette is at x = 0. x is a fraction
 * of the width of the silhouette, and y is a fraction of its height. */
enum { SILHOUETTE = 8 };
_Static_assert(2 * SILHOUETTE - 1 <= OUTLINE, "OUTLINE is too small for a silhouette");

int drawn_outline(const struct drawn *k, struct point outline[OUTLINE])
{
    static const struct point tower[SILHOUETTE] = {{0.5, 0},     {0.5, 0.38},  {0.4, 0.39}, {0.4, 0.66},
                                                   {0.26, 0.68}, {0.26, 0.87}, {0.06, 0.9}, {0, 1}},
                              person[SILHOUETTE] = {{0.3, 0},     {0.34, 0.45}, {0.5, 0.47},  {0.46, 0.8},
                                                    {0.14, 0.84}, {0.26, 0.88}, {0.24, 0.97}, {0, 1}};
    const struct point *half = k->number == NUMBER_PERSON ? person : tower, up = direction(k->theta);
    int n = 0;
    for (int i = 1 - SILHOUETTE; k->number <= NUMBER_TOWER && i < SILHOUETTE; i++) {
        const struct point *of = &half[SILHOUETTE - 1 - abs(i)];
        const struct point axis = along(k->corner[0], of->y * k->height, up.x, up.y);
        outline[n++] = along(axis, (0.5 + (i < 0 ? -of->x : of->x)) * k->thickness, -up.y, up.x);
    }
    if (n > 0)
        return n;
    /* At each corner, the outline turns from one of these directions to the next. */
    const struct point side[] = {{-up.x, -up.y}, {up.y, -up.x}, {up.x, up.y}, {-up.y, up.x}};
    for (int i = 0; i < CORNERS; i++) {
        if (!(k->radius > 0) || i == CORNERS - 1) {
            outline[n++] = k->corner[i];
            continue;
        }
        struct point centre =
            along(k->corner[i], -k->radius, side[i].x + side[i + 1].x, side[i].y + side[i + 1].y);
        for (int j = 0; j < ARC; j++) {
            struct point turn = direction((double)QUAD_PI / 2 * j / (ARC - 1));
            outline[n++] = along(centre, k->radius, turn.y * side[i].x + turn.x * side[i + 1].x,
                                 turn.y * side[i].y + turn.x * side[i + 1].y);
        }
    }
    return n;
}

/* Returns where the upper edge of a follower, which may be rounded, touches its leader. */
static struct point touch(const struct drawn *follower, const struct drawn *leader)
{
    struct point up = direction(follower->theta), face = direction(leader->theta);
    struct point centre = along(follower->corner[1], -follower->radius, up.y + up.x, up.y - up.x);
    return along(centre, follower->radius, face.y, -face.x);
}

int drawn_name(const struct drawn *k, char name[DRAWN_NAME])
{
    return k->number >= 0 ? snprintf(name, DRAWN_NAME, "%d", k->number)
                          : snprintf(name, DRAWN_NAME,
                                     k->number == NUMBER_NEXT     ? "next"
                                     : k->number == NUMBER_TOWER  ? "tower"
                                     : k->number == NUMBER_PERSON ? "person"
                                                                  : "");
}

bool drawn_locked(const struct drawn *k)
{
    return k->touched && !isfinite(k->of_own);
}

/* ---- The stage ---- */

bool stage_make(struct stage *stage, size_t room)
{
    *stage = (struct stage){.domino = calloc(room, sizeof *stage->domino)};
    return stage->domino != NULL;
}

void stage_free(struct stage *stage)
{
    free(stage->domino);
}

const struct drawn *stage_front(const struct stage *stage, size_t k)
{
    bool is_first = stage->domino[0].foot > stage->domino[stage->count - 1].foot;
    return &stage->domino[is_first ? k : stage->count - 1 - k];
}

struct axis_unit stage_unit(const struct stage *stage, double across)
{
    return stage->unit ? (struct axis_unit){stage->unit, 1} : measure_axis(across);
}

/* ---- The train ---- */

/* Used while the dominoes of a train are added to a stage, from the front to the back. */
struct filling {
    struct stage *stage;
    double s, r, d, rho;
    bool leans; /* the next follower leans on the domino that was added last */
};

static void train_add(struct filling *f, double height, double foot, double theta)
{
    struct stage *stage = f->stage;
    int number = (int)stage->count - 1;
    struct drawn *domino = &stage->domino[stage->count++];
    *domino = (struct drawn){.number = number,
                             .part = number < 0    ? STANDS
                                     : number == 0 ? HEAD
                                                   : FALLS,
                             .height = height,
                             .thickness = f->d * height,
                             .foot = foot,
                             .theta = theta,
                             .radius = f->rho * height,
                             .contact = {(double)NAN, (double)NAN},
                             .force = (double)NAN,
                             .of_own = (double)NAN};
    drawn_corners(domino);
}

static void train_follow(struct filling *f, double theta)
{
    struct drawn *leader = &f->stage->domino[f->stage->count - 1];
    train_add(f, leader->height / f->r, leader->foot - (f->s + f->d) * leader->height, theta);
    leader->touched = f->leans;
    if (f->leans)
        leader->contact = touch(leader + 1, leader);
}

static bool train_full(const struct stage *stage)
{
    const struct drawn *last = &stage->domino[stage->count - 1];
    return stage->count == DOMINOES || last->height < SMALLEST || last->foot < stage->left;
}

static bool train_link(const struct domq_link *link, void *context)
{
    struct filling *f = context;
    if (link->i > 0)
        train_follow(f, (double)link->theta);
    else
        train_add(f, 1, 0, (double)link->theta);
    f->leans = isfinite(link->arm_a);
    return !train_full(f->stage);
}

enum dom_status stage_train(struct stage *stage, const struct domq_train *train,
                            const struct any_compute *compute, domq_real theta)
{
    struct any_compute fine = *compute;
    struct domq_angles angles;
    struct filling f = {.stage = stage,
                        .s = (double)train->s,
                        .r = (double)train->r,
                        .d = (double)train->d,
                        .rho = (double)train->rho};
    double pitch = (f.s + f.d) * f.r, tall = f.r < TALLEST ? f.r : TALLEST, seen = 1.04 * tall;
    if (!stage_make(stage, DOMINOES))
        return DOM_NO_MEMORY;
    /* With the finest tolerance, the chain includes dominoes that are light, but large enough to be seen. */
    fine.tol = any_arithmetic(fine.precision).tol_floor;
    stage->unit = "h";
    stage->ruler = "x";
    stage->top = tall;
    stage->right = pitch + 0.12 * seen;
    stage->left = stage->right - WIDEST * seen;
    /* The head must be visible, even if the next domino is far away. */
    stage->left = stage->left > -1 ? -1 : stage->left;
    train_add(&f, f.r, pitch, 0);
    enum dom_status status = any_angles_find(train, compute, &angles);
    if (status == DOM_OK)
        status = any_chain_walk(train, &fine, theta, train_link, &f);
    if (status != DOM_OK)
        return status;
    while (!train_full(stage)) {
        /* The remaining dominoes are drawn at the limiting tilt; the difference is too small to see. */
        train_follow(&f, (double)angles.theta_f);
        f.leans = f.leans && !angles.detaches;
    }
    if (theta >= angles.theta_c * (1 - 4 * (domq_real)1e-10)) {
        stage->domino[0].touched = true; /* the head hits the next domino */
        stage->domino[0].contact = touch(&stage->domino[1], &stage->domino[0]);
    }
    double end = stage->domino[stage->count - 1].foot - 0.05 * seen;
    stage->left = end > stage->left ? end : stage->left;
    return DOM_OK;
}

static bool force_seen(const struct dom_force *f, void *context)
{
    struct stage *stage = context;
    if (f->i + 1 >= stage->count)
        return false;
    struct drawn *k = &stage->domino[f->i + 1];
    if (k->touched) {
        k->force = f->force;
        k->of_own = f->per_weight;
    }
    return true;
}

enum dom_status stage_forces(struct stage *stage, const struct domq_train *train,
                             const struct any_compute *compute, domq_real theta)
{
    const struct dom_train narrow = train_in_double(train);
    const struct dom_compute narrow_compute = compute_in_double(compute);
    return dom_cycle_forces(&narrow, &narrow_compute, (double)theta, force_seen, stage);
}
