/* SPDX-License-Identifier: MIT
 * Unknown values, told in one wording. */
#ifndef GLINT_BASE_UNKNOWN_H
#define GLINT_BASE_UNKNOWN_H

#include <argp.h>

/* Ends the program through refuse(): "ORIGIN: unknown WHAT 'TEXT'; did you mean 'NAME'? choose from NAME, ...". The question
 * comes only where a name is close. `origin` is an option, or where the text stands in a file; NULL: left out. `names` ends
 * with NULL. */
_Noreturn void refuse_unknown(const struct argp_state *state, const char *origin, const char *what, const char *text,
                              const char *const *names);

#endif
