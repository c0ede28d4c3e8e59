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
                                                   {0.26, 0.68}, {0.26, 0.87}, {0.06, 0.9}, {0, 1}};
    const struct point up = direction(k->theta);
    int n = 0;
    for (int i = 1 - SILHOUETTE; k->number == NUMBER_TOWER && i < SILHOUETTE; i++) {
        const struct point *of = &tower[SILHOUETTE - 1 - abs(i)];
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

bool drawn_locked(const struct drawn *k)
{
    return k->touched && !isfinite(k->of_own);
}

/* ---- The stage ---- */

const struct drawn *stage_front(const struct stage *stage, size_t k)
{
    bool is_first = stage->domino[0].foot > stage->domino[stage->count - 1].foot;
    return &stage->domino[is_first ? k : stage->count - 1 - k];
}

int stage_names(const struct stage *stage, double letter, double apart, bool snaps, double left, double right,
                struct drawn_name name[NAMES])
{
    static const char *const words[] = {[-NUMBER_NEXT] = "next", [-NUMBER_TOWER] = "tower"};
    int count = 0;
    for (int pass = 0; pass < 2; pass++)
        for (size_t k = 0; k < stage->count && count < NAMES; k++) {
            const struct drawn *d = stage_front(stage, k);
            struct drawn_name *own = &name[count];
            const double middle = d->foot - d->thickness / 2;
            if (drawn_marked(d) != (pass == 0) || !(middle >= left && middle <= right))
                continue;
            const int letters = d->number >= 0
                                    ? snprintf(own->text, sizeof own->text, "%d", d->number)
                                    : snprintf(own->text, sizeof own->text, "%s", words[-d->number]);
            own->from = fmax(fmin(middle - letters * letter / 2, right - letters * letter), left);
            if (snaps)
                own->from = left + letter * round((own->from - left) / letter);
            own->to = own->from + letters * letter;
            own->is_weakest = d->part == WEAKEST;
            bool fits = true;
            for (const struct drawn_name *other = name; other < own && fits; other++)
                fits = own->to + apart <= other->from || own->from - apart >= other->to;
            count += fits;
        }
    return count;
}

struct axis_unit stage_unit(const struct stage *stage, double across)
{
    return stage->unit ? (struct axis_unit){stage->unit, 1} : measure_axis(across);
}

/* ---- The train ---- */

/* The tilts of the head and its followers, and whether a follower leans on each of them. */
struct tilts {
    size_t count;
    double theta[DOMINOES];
    bool has_leaning[DOMINOES];
};

static bool tilt_take(const struct domq_link *link, void *context)
{
    struct tilts *t = context;
    t->theta[t->count] = (double)link->theta;
    t->has_leaning[t->count++] = isfinite(link->arm_a);
    return t->count < DOMINOES;
}

/* Adds dominoes from the front to the back, until they are too small or too far away to be seen. Those beyond
 * the known tilts are drawn at the limiting tilt theta_f; the difference is too small to see. */
static void train_fill(struct stage *stage, const struct domq_train *train, const struct tilts *tilts,
                       const struct domq_angles *angles)
{
    const double r = (double)train->r, d = (double)train->d, pitch = (double)train->s + d;
    double height = r, foot = pitch * r;
    bool has_leaning = false; /* the next domino leans on this one */
    while (stage->count < DOMINOES && (stage->count < 2 || (height >= SMALLEST && foot >= stage->left))) {
        const size_t i = stage->count - 1; /* the number of the next domino in the chain */
        struct drawn *domino = &stage->domino[stage->count++];
        foot = stage->count > 1 ? foot - pitch * height : foot;
        height = stage->count > 1 ? height / r : height;
        *domino = (struct drawn){.number = (int)stage->count - 2,
                                 .part = stage->count == 1   ? STANDS
                                         : stage->count == 2 ? HEAD
                                                             : FALLS,
                                 .height = height,
                                 .thickness = d * height,
                                 .foot = foot,
                                 .theta = stage->count == 1  ? 0
                                          : i < tilts->count ? tilts->theta[i]
                                                             : (double)angles->theta_f,
                                 .radius = (double)train->rho * height,
                                 .contact = {(double)NAN, (double)NAN},
                                 .force = (double)NAN,
                                 .of_own = (double)NAN};
        drawn_corners(domino);
        if (has_leaning) {
            domino[-1].touched = true;
            domino[-1].contact = touch(domino, &domino[-1]);
        }
        has_leaning =
            stage->count > 1 && (i < tilts->count ? tilts->has_leaning[i] : has_leaning && !angles->detaches);
    }
}

enum dom_status stage_train(struct stage *stage, const struct domq_train *train,
                            const struct any_compute *compute, domq_real theta)
{
    struct any_compute fine = *compute;
    struct domq_angles angles;
    struct tilts tilts = {.count = 0};
    const double r = (double)train->r, pitch = (double)(train->s + train->d) * r,
                 tall = r < TALLEST ? r : TALLEST, seen = 1.04 * tall;
    *stage = (struct stage){.domino = calloc(DOMINOES, sizeof *stage->domino)};
    if (!stage->domino)
        return DOM_NO_MEMORY;
    /* With the finest tolerance, the chain includes dominoes that are light, but large enough to be seen. */
    fine.tol = any_arithmetic(fine.precision).tol_floor;
    enum dom_status status = any_angles_find(train, compute, &angles);
    if (status == DOM_OK)
        status = any_chain_walk(train, &fine, theta, tilt_take, &tilts);
    if (status != DOM_OK)
        return status;
    stage->unit = "h";
    stage->ruler = "x";
    stage->top = tall;
    stage->right = pitch + 0.12 * seen;
    /* The head must be visible, even if the next domino is far away. */
    stage->left = fmin(stage->right - WIDEST * seen, -1);
    train_fill(stage, train, &tilts, &angles);
    if (theta >= angles.theta_c * (1 - 4 * (domq_real)1e-10)) {
        stage->domino[0].touched = true; /* the head hits the next domino */
        stage->domino[0].contact = touch(&stage->domino[1], &stage->domino[0]);
    }
    stage->left = fmax(stage->left, stage->domino[stage->count - 1].foot - 0.05 * seen);
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
