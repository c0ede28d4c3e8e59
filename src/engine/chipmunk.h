/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The functions of the rigid-body engine Chipmunk 7. The library is loaded only when needed, since it may not
 * be installed.
 */
#ifndef ENGINE_CHIPMUNK_H
#define ENGINE_CHIPMUNK_H

#include "engine.h"
#include <chipmunk/chipmunk.h>
#include <chipmunk/chipmunk_structs.h>

/* Calls X(name) for each function of the library that is used. Few of them are getters, since most members of
 * Chipmunk's structures are read directly. */
#define CHIPMUNK_FUNCTIONS(X)                                                                                \
    X(cpSpaceNew)                                                                                            \
    X(cpSpaceFree)                                                                                           \
    X(cpSpaceStep)                                                                                           \
    X(cpSpaceSetGravity)                                                                                     \
    X(cpSpaceSetIterations)                                                                                  \
    X(cpSpaceSetCollisionSlop)                                                                               \
    X(cpSpaceSetCollisionBias)                                                                               \
    X(cpSpaceGetStaticBody)                                                                                  \
    X(cpSpaceAddDefaultCollisionHandler)                                                                     \
    X(cpSpaceAddBody)                                                                                        \
    X(cpSpaceAddShape)                                                                                       \
    X(cpSpaceAddConstraint)                                                                                  \
    X(cpSpaceRemoveBody)                                                                                     \
    X(cpSpaceRemoveShape)                                                                                    \
    X(cpSpaceRemoveConstraint)                                                                               \
    X(cpBodyNew)                                                                                             \
    X(cpBodyFree)                                                                                            \
    X(cpBodySetPosition)                                                                                     \
    X(cpBodySetAngle)                                                                                        \
    X(cpBodySetVelocity)                                                                                     \
    X(cpBodySetAngularVelocity)                                                                              \
    X(cpBodyLocalToWorld)                                                                                    \
    X(cpBodyGetVelocityAtWorldPoint)                                                                         \
    X(cpPolyShapeNewRaw)                                                                                     \
    X(cpSegmentShapeNew)                                                                                     \
    X(cpShapeFree)                                                                                           \
    X(cpShapeSetFilter)                                                                                      \
    X(cpPivotJointNew)                                                                                       \
    X(cpRotaryLimitJointNew)                                                                                 \
    X(cpConstraintFree)                                                                                      \
    X(cpConstraintSetErrorBias)                                                                              \
    X(cpArbiterGetShapes)                                                                                    \
    X(cpArbiterGetNormal)                                                                                    \
    X(cpArbiterGetCount)                                                                                     \
    X(cpArbiterGetDepth)                                                                                     \
    X(cpArbiterSetFriction)                                                                                  \
    X(cpArbiterSetRestitution)

struct chipmunk {
#define CHIPMUNK_MEMBER(name) __typeof__(name) *name;
    CHIPMUNK_FUNCTIONS(CHIPMUNK_MEMBER)
#undef CHIPMUNK_MEMBER
    char version[24]; /* "7.0.3" */
};

/* Sets *functions. The first call loads the library. Thread-safe. Returns ENGINE_NO_LIBRARY or
 * ENGINE_NO_MEMORY if loading fails. */
enum engine_status chipmunk_load(const struct chipmunk **functions);

#endif
