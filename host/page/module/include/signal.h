/* SPDX-License-Identifier: MIT
 * The page has no signals; base/stop.h needs the type's name. */
#ifndef GLINT_PAGE_SIGNAL_H
#define GLINT_PAGE_SIGNAL_H

typedef unsigned char sigset_t;

#endif
