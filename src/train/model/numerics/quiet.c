/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerics/quiet.h"
#include <gsl/gsl_errno.h>
#include <pthread.h>

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static unsigned inside;
static gsl_error_handler_t *before;

void dom_quiet_begin(void)
{
    pthread_mutex_lock(&lock);
    if (inside++ == 0)
        before = gsl_set_error_handler_off();
    pthread_mutex_unlock(&lock);
}

void dom_quiet_end(void)
{
    pthread_mutex_lock(&lock);
    if (--inside == 0)
        gsl_set_error_handler(before);
    pthread_mutex_unlock(&lock);
}
