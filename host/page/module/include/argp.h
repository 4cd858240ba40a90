/* SPDX-License-Identifier: MIT
 * What the host's options need of glibc's <argp.h>, which wasi-libc has not. argp.c beside this folder parses with it. */
#ifndef GLINT_PAGE_ARGP_H
#define GLINT_PAGE_ARGP_H

#include <stdio.h>

typedef int error_t;
enum { ARGP_ERR_UNKNOWN = -1 };

struct argp_option {
    const char *name;
    int key;
    const char *arg;
    int flags;
    const char *doc;
    int group;
};
enum { OPTION_ARG_OPTIONAL = 1, OPTION_HIDDEN = 2, OPTION_DOC = 8 };

struct argp_state;
struct argp_child;
struct argp {
    const struct argp_option *options;
    error_t (*parser)(int key, char *text, struct argp_state *state);
    const char *args_doc, *doc;
    const struct argp_child *children;
    char *(*help_filter)(int key, const char *text, void *input);
    const char *argp_domain;
};
struct argp_child {
    const struct argp *argp;
    int flags;
    const char *header;
    int group;
};

/* A parser is called with the key of an option and its text, or one of these. */
enum {
    ARGP_KEY_ARG = 0,
    ARGP_KEY_END = 0x1000001,
    ARGP_KEY_NO_ARGS,
    ARGP_KEY_INIT,
    ARGP_KEY_SUCCESS,
    ARGP_KEY_ERROR = 0x1000006
};
struct argp_state {
    char *name;
    void *input;
    void **child_inputs;
    int next, argc;
};

#endif
