/* SPDX-License-Identifier: MIT
 * EXACT_MODEL=NAME in the environment: of the models that one alone (make run-exact MODEL=NAME). EXACT_EVERY=K: every K-th of what a test
 * runs through (make check). */
#ifndef GLINT_TEST_CHOSEN_H
#define GLINT_TEST_CHOSEN_H

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "glint.h"

#define CHOSEN_NAME(number, name, function, use, grain) #name,
#define CHOSEN_FUNCTION(number, name, function, use, grain) #function,
static const char *const model_names[] = {GLINT_MODELS(CHOSEN_NAME)};
/* Whose function a model's is: its own, or another's. */
static const char *const model_functions[] = {GLINT_MODELS(CHOSEN_FUNCTION)};

static inline uint32_t exact_every(void)
{
    const char *text = getenv("EXACT_EVERY");
    const int step = text ? atoi(text) : 1;
    return step > 0 && step <= 100 ? (uint32_t)step : 1;
}

/* The only one, or -1: all. Ends the program where the name is no model's. */
static inline int only_model(void)
{
    const char *only = getenv("EXACT_MODEL");
    if (!only || !*only)
        return -1;
    for (int model = 0; model < (int)GLINT_MODEL_COUNT; model++)
        if (!strcmp(only, model_names[model]))
            return model;
    fprintf(stderr, "EXACT_MODEL=%s: unknown model\n", only);
    exit(2);
}

static inline bool chosen(unsigned model)
{
    const int only = only_model();
    return only < 0 || model == (unsigned)only;
}

/* The pattern of cmocka's tests that begin with the chosen model's name, or with its function's; NULL: all. */
static inline const char *chosen_tests(const char *const names[])
{
    static char pattern[64];
    const int only = only_model();
    if (only < 0)
        return NULL;
    snprintf(pattern, sizeof pattern, "%s_*", names[only]);
    return pattern;
}

#endif
