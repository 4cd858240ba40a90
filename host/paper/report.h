/* SPDX-License-Identifier: MIT
 * What becomes of the parts' results. */
#ifndef GLINT_PAPER_REPORT_H
#define GLINT_PAPER_REPORT_H

#include "paper/paper.h"

void paper_report(const struct paper *paper);     /* report.html, with the plots in it, and claims.json */
json_t *paper_summary(const struct paper *paper); /* what claims.json holds */

#endif
