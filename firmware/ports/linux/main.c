/* SPDX-License-Identifier: MIT
 * glint-gadget: this board as a USB display. */
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include "display.h"

const char *argp_program_version = "glint-gadget " GLINT_VERSION_STRING;

/* One that is closed would be the next file's number: messages would go to the USB host. Reads and writes still fail. */
static void hold_standard_streams(void)
{
    for (int number = STDIN_FILENO; number <= STDERR_FILENO; number++)
        if (fcntl(number, F_GETFD) < 0 && open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY) != number)
            exit(1);
}

int main(int argc, char **argv)
{
    hold_standard_streams();
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
