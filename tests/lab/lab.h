/* SPDX-License-Identifier: MIT */
/* The lab: what tests use inside the guest; what cannot be done fails the test. lab_clean is the teardown of every test.
 *
 * GPIO: a test makes a chip, starts a capture, runs the program under test, stops the capture, and has the bytes on the bus
 * and the picture on the screen:
 *
 *     struct chip chip;
 *     struct capture capture;
 *     struct screen screen;
 *     chip_create(&chip, "panel", NAMES, COUNT);
 *     capture_start(&capture, &chip, 16);
 *     assert_int_equal(run("glint stream ..."), 0);
 *     capture_stop(&capture);
 *     size_t count = decode_spi(&capture, SPI, bytes, ROOM);
 *     screen_show(&screen, bytes, count);
 *
 * USB: a gadget is a program that goes on beside the test. On the controllers dummy_udc.0 and dummy_udc.1 the guest's own
 * host sees it at once; on usbip-vudc.0 after usbip_attach. The kernel's driver for USB displays takes what looks like one
 * and makes /dev/fb0 of it; a program that uses libusb has to detach it.
 *
 *     struct process gadget;
 *     process_start(&gadget, "$GADGET --size 320x240 -o /run/tmp/picture.png");
 *     process_wait_for(&gadget, "on the bus");
 *     wait_for_file("/dev/fb0");
 *     assert_int_equal(run("$GLINT stream watchface --to usb --detach --frames 5"), 0);
 *     assert_int_equal(process_end(&gadget, SIGTERM), 0);
 */
#ifndef LAB_H
#define LAB_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/types.h>

enum { LAB_LINES_MAX = 32 };

struct chip {
    char name[32]; /* gpiochipN */
    char path[64]; /* /dev/gpiochipN */
    char label[32];
    const char *const *lines;
    unsigned count;
    unsigned base; /* the kernel's number of its first line */
};

/* A simulated chip of this label, with lines of these names. */
void chip_create(struct chip *chip, const char *label, const char *const lines[], unsigned count);
/* Also while a program uses it. */
void chip_remove(const struct chip *chip);
void chips_remove(void);
/* The simulated chip of this label, of the device tree. */
void chip_find(struct chip *chip, const char *label, const char *const lines[], unsigned count);
/* The line of this name. */
unsigned chip_line(const struct chip *chip, const char *name);

struct capture {
    const struct chip *chip;
    uint8_t *sets; /* in order: the line; bit 7: its value */
    size_t count;
    size_t lost; /* that the kernel could not keep */
};

enum { CAPTURE_HIGH = 0x80, CAPTURE_LINE = 0x7f };

/* Records every value that is set, in a buffer of this size: about 32 bytes for a line that is set. */
void capture_start(struct capture *capture, const struct chip *chip, unsigned buffer_mib);
/* Ends it and fails when anything was lost. */
void capture_stop(struct capture *capture);
/* Ends it and tells what was lost. */
void capture_stop_lossy(struct capture *capture);
void capture_free(struct capture *capture);

/* The lines before the first value that is set: what they are set to first, so that this is not an edge. */
void capture_levels(const struct capture *capture, bool high[LAB_LINES_MAX]);

/* As a Value Change Dump, one microsecond a change, for sigrok, whose decoders want two things. parallel tells a byte when the
 * next one comes: the clock is pulsed once more at the end. st7735 looks at D/C when the clock has fallen after a byte, where it
 * may be the next one's already: DC goes behind the clock. */
void capture_write_vcd(const struct capture *capture, const char *path, const char *clock);

/* What sigrok-cli writes about it with these arguments; to be freed. */
char *sigrok(const struct capture *capture, const char *clock, size_t *size, const char *arguments);

/* A byte on the bus; bit 8: D/C was high, so it is data. */
typedef uint16_t bus_byte;
enum { BUS_DATA = 0x100 };

/* SPI mode 0 or 3, most significant bit first, of the lines SCK MOSI CS DC. Fails where chip select ends within a byte or D/C
 * changes in one. Returns the number of bytes: at most room. */
size_t decode_spi(const struct capture *capture, bus_byte *bytes, size_t room);
/* Where SCK is whenever CS changes. Fails where CS never does, and where SCK is not always the same. */
bool clock_at_rest(const struct capture *capture);
/* 8080: the lines D0..D7 at the rising edge of WR while CS is low. */
size_t decode_i80(const struct capture *capture, bus_byte *bytes, size_t room);

/* sigrok's decoders find these bytes, in lines of the same names. */
void sigrok_agrees_on_spi(const struct capture *capture, const bus_byte *bytes, size_t count);
void sigrok_agrees_on_spi_mode_3(const struct capture *capture, const bus_byte *bytes, size_t count);
void sigrok_agrees_on_i80(const struct capture *capture, const bus_byte *bytes, size_t count);

/* A MIPI-DCS display as its commands leave it. The picture is as addressed: MADCTL is noted only. */
struct screen {
    unsigned width, height;
    uint16_t *pixels; /* RGB565; set by the test to what it was before */
    unsigned column_first, column_last, row_first, row_last;
    bool awake, on;
    bool shown; /* was on with what it shows now */
    uint8_t madctl, colmod;
    unsigned writes; /* RAMWR */
    size_t written;  /* pixels */
};

void screen_init(struct screen *screen, unsigned width, unsigned height);
/* Fails for a window that leaves the screen, and for more pixels than the window has. */
void screen_show(struct screen *screen, const bus_byte *bytes, size_t count);
void screen_free(struct screen *screen);
/* The bytes up to the command after which so many pixels are written. */
size_t frame_bytes(const bus_byte *bytes, size_t count, size_t pixels);

/* Runs a shell command; its exit status. */
int run(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Runs a shell command, which has to succeed; what it writes to standard output, to be freed, ends with a NUL. */
char *run_for_output(size_t *size, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A program that goes on while the test does something else; it ends with the test at the latest. What it writes to both
 * outputs is in a file. */
struct process {
    pid_t pid;
    char output[64];
};
void process_start(struct process *process, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Until it has written this. */
void process_wait_for(const struct process *process, const char *text);
/* Sends a signal, 0: none, and waits; its exit status as run() has it. */
int process_end(struct process *process, int signal);
void processes_end(void);

/* A test's teardown: no chip that was created and no program that was started is left to the next test. */
int lab_clean(void **state);

/* Until there is this file. */
void wait_for_file(const char *path);

/* Wires the gadget on usbip-vudc.0 to a port of the virtual host controller, as over a network. */
void usbip_attach(void);

#endif
