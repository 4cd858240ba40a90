/* SPDX-License-Identifier: MIT
 * What a joint search has done, in a file (JSON), so that it goes on after it was stopped. */
#ifndef GLINT_SEARCH_CHECKPOINT_H
#define GLINT_SEARCH_CHECKPOINT_H

#include <stdint.h>

#include "paper/search.h"
#include "paper/search_best.h"

/* Replaces the file as a whole: it is either the last one or this one. */
void checkpoint_write(const char *path, const struct search_options *options, uint64_t sets_done,
                      const struct best *best);
/* Leaves both as they are where there is no such file; fail()s where it is of another search, or none. */
void checkpoint_read(const char *path, const struct search_options *options, uint64_t *sets_done, struct best *best);

#endif
