/* SPDX-License-Identifier: MIT
 * glint-gadget: this board as a USB display. */
#include <stdlib.h>

#include "display.h"

const char *argp_program_version = "glint-gadget " GLINT_VERSION_STRING;

int main(int argc, char **argv)
{
    struct options options;
    options_default(&options);
    argp_err_exit_status = 2;
    unsetenv("ARGP_HELP_FMT"); /* with some margins argp writes without end */
    argp_parse(&gadget_argp, argc, argv, 0, NULL, &options);
    static struct display display;
    display_open(&display, &options);
    const struct usb_function function = display_function(&display);
    return display_run(&display, &options, &function) ? 0 : 1;
}
