/* SPDX-License-Identifier: MIT
 * For the SDK, the assembler included: a Pico. */
#include "boards/pico.h"
