/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: pictures */
/* The dominoes of a picture touch where the model says, do not overlap, and stand on the ground. */
#include "support.h"
#include <float.h>

#include "pictures/picture/stage.h"

static const double some_trains[][4] = {/* s, r, d, q */
                                        {0.3, 1, 7.0 / 48, 4},    {0.4, 1.5, 7.0 / 48, 4},
                                        {0.43, 2.1, 7.0 / 48, 3}, {0.54, 1.84, 7.0 / 48, 3},
                                        {0.2, 1.3, 0.001, 4},     {0.3, 1.05, 0.3, 3},
                                        {0.5, 2, 7.0 / 48, 4},    {0.05, 1, 0.6, 3}};

enum { DOMINOES = 200 }; /* the largest number of dominoes on a stage */
enum { SOME = sizeof some_trains / sizeof *some_trains, RANDOM = 400, TILTS = 5 };

/* A picture, its train, and the angles of this train. */
struct view {
    struct setup train;
    struct domq_angles angles;
    double theta;
    struct stage stage;
};

static _Noreturn void fail_view(const struct view *v, int k, const char *what, double off, double bound)
{
    fail_msg("%s at domino %d: off by %g, %g allowed, at s %.17g r %.17g d %.17g q %.17g theta %.17g", what,
             v->stage.domino[k].number, off, bound, (double)v->train.s, (double)v->train.r,
             (double)v->train.d, (double)v->train.q, v->theta);
    abort();
}

/* a domino this many times smaller than the head is a dot, and is the last one that is drawn */
enum { DOTS = 100 };

/* Returns a bound for the rounding errors of the corners of domino k, in heights of the head. The hinge is a
 * sum of k terms, and the tilt is the result of k steps of the chain, each of which adds a few rounding
 * errors. */
static double roundings(const struct view *v, int k)
{
    const struct drawn *own = &v->stage.domino[k];
    return DBL_EPSILON * (k + 1) * (fabs(own->foot) + own->height * (1 + (double)v->train.d));
}

/* Returns the allowed error for the position of domino k. Dominoes after the end of the chain are drawn at
 * theta_f, with an error of a tenth of a dot if 10,000 dots are as high as the head. */
static double allowed(const struct view *v, int k)
{
    return roundings(v, k) + (v->stage.domino[k].theta == (double)v->angles.theta_f ? 1e-5 : 0);
}

static bool is_dot(const struct drawn *domino)
{
    return domino->height < 1.0 / DOTS;
}

static double dot(struct point a, struct point b)
{
    return a.x * b.x + a.y * b.y;
}

/* Returns the distance between two dominoes along a side of one of them. It is negative if they overlap. */
static double gap_between(const struct drawn *a, const struct drawn *b)
{
    double widest = -(double)INFINITY;
    for (int side = 0; side < 4; side++) {
        double theta = side < 2 ? a->theta : b->theta;
        struct point axis =
            side % 2 ? (struct point){sin(theta), cos(theta)} : (struct point){cos(theta), -sin(theta)};
        double lo[2] = {(double)INFINITY, (double)INFINITY}, hi[2] = {-(double)INFINITY, -(double)INFINITY};
        for (int i = 0; i < CORNERS; i++) {
            lo[0] = fmin(lo[0], dot(axis, a->corner[i])), hi[0] = fmax(hi[0], dot(axis, a->corner[i]));
            lo[1] = fmin(lo[1], dot(axis, b->corner[i])), hi[1] = fmax(hi[1], dot(axis, b->corner[i]));
        }
        widest = fmax(widest, fmax(lo[0] - hi[1], lo[1] - hi[0]));
    }
    return widest;
}

/* Each contact is at the upper front edge of the follower, on the back face of the leader. Returns the number
 * of contacts. */
static int contacts_check(const struct view *v)
{
    int contacts = 0;
    for (int i = 1; i + 1 < (int)v->stage.count; i++) {
        const struct drawn *own = &v->stage.domino[i], *next = own + 1;
        if (!own->touched || is_dot(next))
            continue;
        const struct point from = own->corner[3], to = own->corner[2], face = {to.x - from.x, to.y - from.y},
                           contact = {own->contact.x - from.x, own->contact.y - from.y};
        double up = dot(face, contact) / own->height / own->height,
               off = fabs(face.x * contact.y - face.y * contact.x) / own->height,
               bound = allowed(v, i) + allowed(v, i + 1);
        assert_true(own->contact.x == next->corner[1].x && own->contact.y == next->corner[1].y);
        if (!(off <= bound))
            fail_view(v, i, "the contact is off the face", off, bound);
        if (!(up > 0 && up <= 1 + bound / own->height))
            fail_view(v, i, "the contact is beyond the face", up, 1);
        contacts++;
    }
    /* If followers detach, the head may have no follower at this tilt. */
    assert_true(contacts > 0 || v->angles.detaches || v->stage.count == 3);
    return contacts;
}

static void overlap_check(const struct view *v)
{
    for (int i = 0; i < (int)v->stage.count; i++) {
        const struct drawn *own = &v->stage.domino[i];
        for (int j = 0; j < CORNERS; j++)
            if (!(own->corner[j].y >= 0))
                fail_view(v, i, "below the ground", -own->corner[j].y, 0);
        for (int j = i + 1; j < (int)v->stage.count && j <= i + 3 && !is_dot(&v->stage.domino[j]); j++) {
            double gap = gap_between(own, &v->stage.domino[j]), bound = allowed(v, i) + allowed(v, j);
            if (!(gap >= -bound))
                fail_view(v, i, "it is inside another one", -gap, bound);
        }
    }
}

/* Each domino is r times smaller than its leader, at a distance of (s + d) times the leader's height. */
static void sizes_check(const struct view *v)
{
    double s = (double)v->train.s, d = (double)v->train.d, r = (double)v->train.r;
    const struct drawn *domino = v->stage.domino;
    assert_true(v->stage.count >= 3 && v->stage.count <= DOMINOES);
    assert_true(domino[1].foot == 0 && domino[1].height == 1);
    /* The next domino is (s + d) r in front of the head, since its gap is r times as wide as the head's gap.
     */
    assert_near("the next", domino[0].foot, (s + d) * r, 2 * DBL_EPSILON);
    for (int i = 0; i < (int)v->stage.count; i++) {
        const struct drawn *own = &domino[i];
        assert_int_equal(own->number, i - 1);
        assert_near("thickness", hypot(own->corner[3].x - own->foot, own->corner[3].y), d * own->height,
                    roundings(v, i) / (d * own->height));
        assert_near("height", hypot(own->corner[1].x - own->foot, own->corner[1].y), own->height,
                    roundings(v, i) / own->height);
        if (i == 0)
            continue;
        assert_near("growth", own[-1].height / own->height, r, 2 * DBL_EPSILON);
        double place = own[-1].foot - (s + d) * own[-1].height;
        if (!(fabs(own->foot - place) <= roundings(v, i)))
            fail_view(v, i, "place", fabs(own->foot - place), roundings(v, i));
    }
}

struct tilts {
    size_t count;
    double theta[DOMINOES];
};

static bool tilt_seen(const struct domq_link *link, void *context)
{
    struct tilts *tilts = context;
    tilts->theta[tilts->count++] = (double)link->theta;
    return tilts->count < DOMINOES;
}

/* The tilts agree with the chain to 1e-12, and no later domino is more upright than the last one of the
 * chain. Returns the number of tilts of the chain. */
static size_t tilts_check(struct view *v)
{
    struct tilts tilts = {.count = 0};
    v->train.tol = 1e-12;
    assert_status(ask_chain_walk(&v->train, v->theta, tilt_seen, &tilts), DOM_OK);
    assert_true(v->stage.domino[0].theta == 0);
    for (size_t i = 1; i < v->stage.count; i++) {
        double theta = v->stage.domino[i].theta;
        if (i <= tilts.count)
            assert_near("tilt", theta, tilts.theta[i - 1], 1e-11);
        else if (!(theta >= v->stage.domino[i - 1].theta &&
                   theta <= (double)v->angles.theta_f * (1 + 4 * DBL_EPSILON)))
            fail_view(v, (int)i, "it stands more upright than its leader", theta, 0);
    }
    return tilts.count < v->stage.count - 1 ? tilts.count : v->stage.count - 1;
}

/* The head does not reach the next domino before theta_c, and then hits it at the height cos theta_c. */
static void hit_check(const struct view *v, bool is_end)
{
    const struct drawn *next = &v->stage.domino[0];
    if (next->touched != is_end)
        fail_view(v, 0, is_end ? "the head does not hit" : "the head hits too early", 1, 0);
    if (is_end) {
        /* The face of the next domino is at the distance s r in front of the hinge of the head. Both hinges
         * are rounded. */
        assert_near("x", next->contact.x, (double)(v->train.s * v->train.r), 8 * DBL_EPSILON);
        assert_near("z", next->contact.y, cos(v->theta), 8 * DBL_EPSILON);
    } else {
        assert_true(isnan(next->contact.x) && isnan(next->contact.y));
    }
}

/* Views of the trains above, and of random ones, each at tilts from 0 to theta_c. */
TEST(a_train_is_drawn_where_the_model_has_it)
{
    uint64_t seed = 71;
    int contacts = 0;
    size_t tilts = 0;
    for (int which = 0; which < SOME + RANDOM; which++) {
        static struct view v;
        v.train = setup_default();
        if (which >= SOME)
            v.train = random_train(&seed);
        for (int i = 0; i < 4 && which < SOME; i++)
            *(domq_real *[]){&v.train.s, &v.train.r, &v.train.d, &v.train.q}[i] = some_trains[which][i];
        const struct setup train = v.train;
        for (int k = 0; k < TILTS; k++) {
            v.train = train;
            assert_status(ask_angles_find(&v.train, &v.angles), DOM_OK);
            v.theta = (double)v.angles.theta_c * k / (TILTS - 1);
            const struct domq_train drawn = setup_train(&v.train);
            const struct any_compute compute = setup_compute(&v.train);
            assert_status(stage_train(&v.stage, &drawn, &compute, v.theta), DOM_OK);
            contacts += contacts_check(&v);
            overlap_check(&v);
            sizes_check(&v);
            tilts += tilts_check(&v);
            hit_check(&v, k == TILTS - 1);
            free(v.stage.domino);
        }
    }
    print_message("# %d contacts, %zu tilts\n", contacts, tilts);
    assert_true(contacts > 5 * TILTS * (SOME + RANDOM) && tilts > (size_t)5 * TILTS * (SOME + RANDOM));
}
