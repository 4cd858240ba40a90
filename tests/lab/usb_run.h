/* SPDX-License-Identifier: MIT
 * Runs glint stream to a display of usb_display.h. */
#ifndef LAB_USB_RUN_H
#define LAB_USB_RUN_H

#include "run.h"

#include "gud_protocol.h"
#include "usb_display.h"

#define STREAM "$GLINT stream watchface --to usb "
#define OURS "--vid-pid 1209:0001 "

static struct usb_display_config config;
static struct usb_display display;

/* A stream that goes on while the test does; what it says on standard error goes to a file or a terminal. */
static inline pid_t start_to(const char *path, const char *command)
{
    const pid_t process = fork();
    assert_true(process >= 0);
    if (process == 0) {
        if (!freopen(path, "w", stderr))
            _exit(126);
        execl("/bin/sh", "sh", "-c", command, NULL);
        _exit(127);
    }
    return process;
}

static inline pid_t start(const char *command)
{
    return start_to("stream.err", command);
}

static inline void assert_exits(pid_t process, int status)
{
    int result;
    assert_int_equal(waitpid(process, &result, 0), process);
    assert_true(WIFEXITED(result));
    assert_int_equal(WEXITSTATUS(result), status);
}

static inline void honest(void)
{
    usb_display_defaults(&config, 120, 80);
}

static inline struct gud_descriptor descriptor(void)
{
    struct gud_descriptor d;
    gud_descriptor_unpack(&d, config.descriptor);
    return d;
}

static inline void set_descriptor(struct gud_descriptor d)
{
    gud_descriptor_pack(config.descriptor, &d);
}

/* An honest display but for what happens within the second frame. */
static inline void trouble(enum usb_trouble what, bool lasts)
{
    honest();
    struct gud_descriptor d = descriptor();
    d.compression = 0;
    set_descriptor(d);
    config.trouble = what;
    config.trouble_at = 19200 + 50; /* within the second frame */
    config.trouble_lasts = lasts;
    usb_display_be(&display, &config);
}

static inline int clean(void **state)
{
    usb_displays_unplug(state);
    return scratch_remove(state);
}

#endif
