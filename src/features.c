/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The features of this build. The build makes the macros FEATURES and ABSENT from the folders that have a
 * feature.mk. */
#include "feature_list.h"
#include "interpreter/command.h"

#define FEATURE_DECLARE(name) extern const struct feature name##_feature;
FEATURES(FEATURE_DECLARE)

#define FEATURE_LIST(name) &name##_feature,
const struct feature *const every_feature[] = {FEATURES(FEATURE_LIST) NULL};

#define ABSENT_LIST(name, feature) {#name, #feature},
const struct absent_name absent_names[] = {ABSENT(ABSENT_LIST){NULL, NULL}};
