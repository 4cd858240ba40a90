/* SPDX-License-Identifier: MIT
 * What the frames of a stream took, and what they would take over USB. */
#ifndef GLINT_STREAM_STATS_H
#define GLINT_STREAM_STATS_H

#include "plan/plan.h"

struct stream_stats;
struct stream_stats *stats_new(const struct sink *sink);
void stats_add(struct stream_stats *stats, const struct plan_result *result);
void stats_show(struct stream_stats *stats); /* a line on a terminal, some times a second */
/* The sums at the end, as text or JSON. */
void stats_print(const struct stream_stats *stats, bool json, FILE *stream);
void stats_free(struct stream_stats *stats);

#endif
