/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture/scene.h"
#include "language/quad.h"
#include <float.h>

#define SMALLEST 0.01 /* of the head: smaller ones are dots */
#define WIDEST   2.4  /* of a picture, in its own height: dominoes farther back are left out */
#define TALLEST  2.5  /* of a picture, in heights of the head: a larger next domino is cut off */

/* ---- From the model to corners ---- */

struct drawn drawn_at(int number, double height, double foot, double theta, double d, double radius)
{
    struct drawn k = {.number = number,
                      .height = height,
                      .foot = foot,
                      .theta = theta,
                      .radius = radius,
                      .contact = {(double)NAN, (double)NAN},
                      .force = (double)NAN,
                      .of_own = (double)NAN};
    double x = (double)quad(sin)((domq_real)theta), y = (double)quad(cos)((domq_real)theta);
    /* The centre of the rounded foot moves on by radius theta. */
    k.corner[0] = (struct point){foot + radius * (theta + y - 1 - x), radius * (1 - y - x)};
    k.corner[1] = along(k.corner[0], height, x, y);
    k.corner[2] = along(k.corner[1], d * height, -y, x);
    k.corner[3] = along(k.corner[0], d * height, -y, x);
    return k;
}

struct drawn drawn_for_people(const struct drawn *domino)
{
    struct drawn k = *domino;
    double least = 4 * DBL_EPSILON * (fabs(k.foot) + k.height);
    for (int i = 0; i <= CORNERS; i++) {
        struct point *p = i < CORNERS ? &k.corner[i] : &k.contact;
        p->x = fabs(p->x) < least ? 0 : p->x;
        p->y = fabs(p->y) < least ? 0 : p->y;
    }
    return k;
}

int drawn_outline(const struct drawn *k, struct point outline[OUTLINE])
{
    double x = (double)quad(sin)((domq_real)k->theta), y = (double)quad(cos)((domq_real)k->theta);
    /* Each edge turns the outline from one of these directions to the next: down, forwards, up, back. */
    const struct point way[] = {{-x, -y}, {y, -x}, {x, y}, {-y, x}};
    int n = 0;
    for (int i = 0; i < CORNERS; i++) {
        if (!(k->radius > 0) || i == CORNERS - 1) {
            outline[n++] = k->corner[i];
            continue;
        }
        struct point centre =
            along(k->corner[i], -k->radius, way[i].x + way[i + 1].x, way[i].y + way[i + 1].y);
        for (int j = 0; j < ARC; j++) {
            double turn = (double)QUAD_PI / 2 * j / (ARC - 1), from = (double)quad(cos)((domq_real)turn),
                   to = (double)quad(sin)((domq_real)turn);
            outline[n++] = along(centre, k->radius, from * way[i].x + to * way[i + 1].x,
                                 from * way[i].y + to * way[i + 1].y);
        }
    }
    return n;
}

/* Returns where a follower touches the back of its leader: its upper edge is an arc around a centre. */
static struct point touch(const struct drawn *own, const struct drawn *leader)
{
    double x = (double)quad(sin)((domq_real)own->theta), y = (double)quad(cos)((domq_real)own->theta);
    struct point centre = along(own->corner[1], -own->radius, y + x, y - x);
    return along(centre, own->radius, (double)quad(cos)((domq_real)leader->theta),
                 -(double)quad(sin)((domq_real)leader->theta));
}

static bool scene_full(const struct stage *scene)
{
    const struct drawn *last = &scene->domino[scene->count - 1];
    return scene->count == DOMINOES || last->height < SMALLEST || last->foot < scene->left;
}

/* What a walk down the train fills. */
struct filling {
    struct stage *scene;
    double s, r, d, rho;
    bool leans; /* the next one on the last one */
};

static void stage_add(struct filling *f, double theta)
{
    struct stage *scene = f->scene;
    struct drawn *leader = &scene->domino[scene->count - 1];
    struct drawn own =
        drawn_at(scene->count - 1, leader->height / f->r, leader->foot - (f->s + f->d) * leader->height,
                 theta, f->d, f->rho * leader->height / f->r);
    if (f->leans) {
        leader->touched = true;
        leader->contact = touch(&own, leader);
    }
    scene->domino[scene->count++] = own;
}

static bool scene_link(const struct domq_link *link, void *context)
{
    struct filling *f = context;
    if (link->i > 0)
        stage_add(f, (double)link->theta);
    else
        f->scene->domino[f->scene->count++] = drawn_at(0, 1, 0, (double)link->theta, f->d, f->rho);
    f->leans = isfinite(link->arm_a);
    return !scene_full(f->scene);
}

enum dom_status stage_make(const struct domq_train *train, const struct domq_compute *compute,
                           domq_real theta, double behind, struct stage *scene)
{
    struct domq_compute fine = *compute;
    struct domq_angles angles;
    struct filling f = {.scene = scene,
                        .s = (double)train->s,
                        .r = (double)train->r,
                        .d = (double)train->d,
                        .rho = (double)train->rho};
    double pitch = (f.s + f.d) * f.r;
    fine.tol = domq_arithmetic(fine.precision)->tol_floor; /* what is light is not always small */
    scene->top = 1.04 * (f.r < TALLEST ? f.r : TALLEST);
    scene->right = pitch + 0.12 * scene->top;
    scene->left = behind > 0 ? -behind : scene->right - WIDEST * scene->top;
    scene->left = scene->left > -1 ? -1 : scene->left; /* the head is in it, however far the next one is */
    scene->count = 1;
    scene->domino[0] = drawn_at(-1, f.r, pitch, 0, f.d, f.rho * f.r);
    enum dom_status status = domq_angles_find(train, compute, &angles);
    if (status == DOM_OK)
        status = domq_chain_walk(train, &fine, theta, scene_link, &f);
    if (status != DOM_OK)
        return status;
    while (!scene_full(scene)) {
        stage_add(&f, (double)angles.theta_f); /* these lie, as far as anybody can see */
        f.leans = f.leans && !angles.detaches;
    }
    if (theta >= angles.theta_c * (1 - 4 * (domq_real)1e-10)) {
        scene->domino[0].touched = true; /* the head hits it */
        scene->domino[0].contact = touch(&scene->domino[1], &scene->domino[0]);
    }
    double end = scene->domino[scene->count - 1].foot - 0.05 * scene->top;
    scene->left = end > scene->left ? end : scene->left;
    return DOM_OK;
}

static bool scene_force(const struct domq_force *f, void *context)
{
    struct stage *scene = context;
    if (f->i + 1 >= (size_t)scene->count)
        return false;
    struct drawn *k = &scene->domino[f->i + 1];
    if (k->touched) {
        k->force = (double)f->force;
        k->of_own = (double)f->of_own;
    }
    return true;
}

enum dom_status scene_forces(const struct domq_train *train, const struct domq_compute *compute,
                             domq_real theta, struct stage *scene)
{
    return domq_cycle_forces(train, compute, theta, scene_force, scene);
}

/* ---- By gnuplot ---- */

void script_domino(FILE *script, const struct drawn *k, struct place at, double from)
{
    struct point outline[OUTLINE];
    int n = drawn_outline(k, outline);
    fprintf(script, "set object polygon from ");
    for (int i = 0; i <= n; i++)
        fprintf(script, "%s%.7g,%.7g", i ? " to " : "", at.shift + at.scale * outline[i % n].x,
                at.scale * outline[i % n].y);
    fprintf(script, " fs solid 1 border lc rgb 'black' lw 1 fc rgb '%s'\n",
            k->number < 0    ? "#a0a0a0"
            : k->number == 0 ? "#f0d080"
                             : "#f8f0d8");
    double x =
        k->corner[0].x + 0.3 * (k->corner[1].x - k->corner[0].x) + (k->corner[3].x - k->corner[0].x) / 2;
    double y = 0.3 * k->corner[1].y + 0.7 * k->corner[0].y + k->corner[3].y / 2;
    if (k->number >= 0 && x > from)
        fprintf(script, "set label '%d' at %.7g,%.7g center front\n", k->number, at.shift + at.scale * x,
                at.scale * y);
    if (k->touched && k->height > 0.04)
        fprintf(script, "set label '' at %.7g,%.7g point pt 7 ps 0.6 lc rgb 'black' front\n",
                at.shift + at.scale * k->contact.x, at.scale * k->contact.y);
}

void script_axes(FILE *script, double left, double right, double top)
{
    fprintf(script,
            "set size ratio -1\nset xrange [%.7g:%.7g]\nset yrange [0:%.7g]\nunset grid\nunset key\n"
            "set xlabel 'x [h]'\nset ylabel 'z [h]'\n",
            left, right, top);
}
