/* SPDX-License-Identifier: MIT
 * What the kernel under the tests does wrong. */
#ifndef LAB_KERNEL_FAULTS_H
#define LAB_KERNEL_FAULTS_H

#include <stdio.h>
#include <sys/utsname.h>

/* Linux 6.1.176 hangs, or panics with usbip-vudc, when a gadget is unbound while the host's data is under way; 6.1.192 does
 * not. Skips the test there, and says so. */
#define SKIP_WHERE_UNBINDING_HANGS()                                                                                   \
    do {                                                                                                               \
        struct utsname name;                                                                                           \
        unsigned version = 0, patch = 0, sub = 0;                                                                      \
        if (uname(&name) == 0 && sscanf(name.release, "%u.%u.%u", &version, &patch, &sub) == 3 && version == 6 &&      \
            patch == 1 && sub < 192) {                                                                                 \
            printf("# Linux %s hangs when a gadget is unbound under load; 6.1.192 does not: install a newer "          \
                   "linux-source-6.1\n",                                                                               \
                   name.release);                                                                                      \
            skip();                                                                                                    \
        }                                                                                                              \
    } while (0)

#endif
