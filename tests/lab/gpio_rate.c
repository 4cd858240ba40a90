/* SPDX-License-Identifier: MIT
 * Nanoseconds of a call that sets lines: what glint's buses and libgpiod take of it in user space, and the whole beside a bare
 * loop of the same ioctl on as many lines of the same simulated chip. A figure, no test: how long the kernel takes is the simulated
 * chip's affair. */
#include "unit.h"

#include <fcntl.h>
#include <linux/gpio.h>
#include <stdio.h>
#include <string.h>
#include <stdarg.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include "sinks/wires/bus.h"
#include "sinks/wires/chip.h"
#include "lab.h"

static const char *const spi_names[] = {"SCK", "MOSI", "DC"};
static const char *const i80_names[] = {"D0", "D1", "D2", "D3", "D4", "D5", "D6", "D7", "DC", "WR"};
static const char *const unnamed[] = {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j"};
enum {
    SPI_LINES = sizeof spi_names / sizeof *spi_names,
    I80_LINES = sizeof i80_names / sizeof *i80_names,
    SETS = 1024,
    ROUNDS = 200
};

/* libc's place is taken: libgpiod's calls, too, come here. */
static bool kernel_is_left_out;
int ioctl(int descriptor, unsigned long request, ...)
{
    va_list arguments;
    va_start(arguments, request);
    void *argument = va_arg(arguments, void *);
    va_end(arguments);
    return kernel_is_left_out ? 0 : (int)syscall(SYS_ioctl, descriptor, request, argument);
}

static double now_ns(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return 1e9 * (double)time.tv_sec + (double)time.tv_nsec;
}

static double least(double a, double b)
{
    return a < b ? a : b;
}

/* ---- the bare loop, as libgpiod does it: version 1 by the kernel's first interface, version 2 by its second ---- */

#if GLINT_WITH_GPIO == 1
static struct gpiohandle_request request;
static struct gpiohandle_data values;
#else
static struct gpio_v2_line_request request;
static struct gpio_v2_line_values values;
#endif

static void bare_open(const struct chip *chip, unsigned lines)
{
    const int descriptor = open(chip->path, O_RDWR);
    assert_true(descriptor >= 0);
#if GLINT_WITH_GPIO == 1
    request = (struct gpiohandle_request){.flags = GPIOHANDLE_REQUEST_OUTPUT, .lines = lines};
    for (unsigned i = 0; i < lines; i++)
        request.lineoffsets[i] = i;
    assert_int_equal(ioctl(descriptor, GPIO_GET_LINEHANDLE_IOCTL, &request), 0);
#else
    request = (struct gpio_v2_line_request){.config.flags = GPIO_V2_LINE_FLAG_OUTPUT, .num_lines = lines};
    values.mask = (1u << lines) - 1;
    for (unsigned i = 0; i < lines; i++)
        request.offsets[i] = i;
    assert_int_equal(ioctl(descriptor, GPIO_V2_GET_LINE_IOCTL, &request), 0);
#endif
    close(descriptor);
}

static double bare_round(void)
{
    const double start = now_ns();
    for (unsigned i = 0; i < SETS; i++) {
#if GLINT_WITH_GPIO == 1
        values.values[0] = i & 1;
        ioctl(request.fd, GPIOHANDLE_SET_LINE_VALUES_IOCTL, &values);
#else
        values.bits = i & 1;
        ioctl(request.fd, GPIO_V2_LINE_SET_VALUES_IOCTL, &values);
#endif
    }
    return now_ns() - start;
}

/* ---- the bus ---- */

static struct gpio_bus *bus_open(enum gpio_bus_kind kind)
{
    static struct gpio_options options; /* stays while the bus does */
    static const char *const spi[ROLES] = {[ROLE_SCK] = "SCK", [ROLE_MOSI] = "MOSI", [ROLE_DC] = "DC"};
    static const char *const i80[ROLES] = {
        "D0", "D1", "D2", "D3", "D4", "D5", "D6", "D7", [ROLE_DC] = "DC", [ROLE_WR] = "WR"};
    options.kind = kind;
    for (unsigned i = 0; i < ROLES; i++)
        options.lines[i].text = (kind == GPIO_BUS_SPI ? spi : i80)[i];
    return gpio_bus_open(&options);
}

static double bus_round(struct gpio_bus *bus, enum gpio_bus_kind kind)
{
    static uint8_t bytes[SETS / 2];
    const size_t count = kind == GPIO_BUS_SPI ? SETS / 16 : SETS / 2;
    for (size_t i = 0; i < count; i++)
        bytes[i] = (uint8_t)(i * 37);
    const struct panel_bus panel = gpio_bus_panel(bus);
    const double start = now_ns();
    assert_true(panel.data(bus, bytes, count));
    return now_ns() - start;
}

/* The least of rounds that take turns: others may use the machine. */
static void print_rate(const char *name, enum gpio_bus_kind kind, const char *const lines[], unsigned count)
{
    struct chip chip, own;
    double bare = 1e18, whole = 1e18, user = 1e18;
    chip_create(&chip, "rate", lines, count);
    chip_create(&own, "bare", unnamed, count);
    struct gpio_bus *bus = bus_open(kind);
    bare_open(&own, count);
    for (int round = 0; round < ROUNDS; round++) {
        bare = least(bare, bare_round());
        whole = least(whole, bus_round(bus, kind));
        kernel_is_left_out = true;
        user = least(user, bus_round(bus, kind));
        kernel_is_left_out = false;
    }
    printf("libgpiod %s, --bus %-4s, %2u lines: %3.0f ns a call in user space; at %.0f %% of a bare ioctl's rate\n",
           gpio_library_version(), name, count, user / SETS, 100 * bare / whole);
    close(request.fd);
    gpio_bus_close(bus);
    chip_remove(&own);
    chip_remove(&chip);
}

static void print_rates(void **state)
{
    (void)state;
    print_rate("spi", GPIO_BUS_SPI, spi_names, SPI_LINES);
    print_rate("8080", GPIO_BUS_8080, i80_names, I80_LINES);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test_teardown(print_rates, lab_clean)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
