/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The functions of Chipmunk 7, a rigid-body engine, loaded when a row first needs them: a program that never
 * asks for it neither loads nor initialises it, and runs without it.
 */
#ifndef ENGINE_CHIPMUNK_H
#define ENGINE_CHIPMUNK_H

#include "engine.h"
#include <chipmunk/chipmunk.h>

/* The functions that are used: X(name). */
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
    X(cpBodyGetPosition)                                                                                     \
    X(cpBodySetPosition)                                                                                     \
    X(cpBodyGetAngle)                                                                                        \
    X(cpBodySetAngle)                                                                                        \
    X(cpBodyGetVelocity)                                                                                     \
    X(cpBodySetVelocity)                                                                                     \
    X(cpBodyGetAngularVelocity)                                                                              \
    X(cpBodySetAngularVelocity)                                                                              \
    X(cpBodyLocalToWorld)                                                                                    \
    X(cpBodyGetVelocityAtWorldPoint)                                                                         \
    X(cpPolyShapeNewRaw)                                                                                     \
    X(cpSegmentShapeNew)                                                                                     \
    X(cpShapeFree)                                                                                           \
    X(cpShapeSetFilter)                                                                                      \
    X(cpShapeSetUserData)                                                                                    \
    X(cpShapeGetUserData)                                                                                    \
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

/* Finds the functions. ENGINE_NO_LIBRARY, ENGINE_NO_MEMORY: there are none. The first call loads the library.
 * Any thread may call. */
enum engine_status chipmunk_load(const struct chipmunk **functions);

#endif
