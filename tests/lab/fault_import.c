/* SPDX-License-Identifier: MIT
 * A fault that the fuzzer of what a mesh's child sends is to find. */
#include "fault.h"
#include "mesh/soup.h"

void __real_soup_check_faces(const struct soup *soup);
void __wrap_soup_check_faces(const struct soup *soup);

/* Believes what was sent. */
void __wrap_soup_check_faces(const struct soup *soup)
{
    if (!fault_is("soup_check_faces"))
        __real_soup_check_faces(soup);
}
