/* SPDX-License-Identifier: MIT
 * The panel's bus by DMA, flash read ahead by the XIP streamer and DMA, pins, UART, watchdog. */
#include "board.h"
#include "qspi.h"
#include "second_core.h"

#include <hardware/clocks.h>
#include <hardware/dma.h>
#include <hardware/gpio.h>
#include <hardware/irq.h>
#include <hardware/pwm.h>
#include <hardware/spi.h>
#include <hardware/structs/io_bank0.h>
#include <hardware/structs/xip_ctrl.h>
#ifdef PICO_RP2040
#include <hardware/structs/vreg_and_chip_reset.h>
#else
#include <hardware/structs/powman.h>
#endif
#include <hardware/timer.h>
#include <hardware/uart.h>
#include <hardware/watchdog.h>

#define SPI (PIN_CLOCK / 8 % 2 ? spi1 : spi0) /* the chip's, by the pin */
#define UART ((PIN_UART_TX + 4) / 8 % 2 ? uart1 : uart0)
/* SPI divides the clock by an even number; a slower bus would tear, and no message would say so. */
typedef char spi_has_the_panels_clock[IS_QSPI || SYS_CLK_HZ % (2 * BUS_HZ) == 0 ? 1 : -1];

static struct {
    unsigned send, fetch; /* DMA channels */
    unsigned bits;        /* of the SPI's frames */
    void (*volatile done)(void *);
    void *volatile argument;
    uint32_t te_asked_us; /* while it waits for TE */
    bool te_is_awaited, te_is_dead;
} board;

/* ---- the panel's bus ---- */

/* ST7789 modules without CS need a clock that idles high (mode 3); ILI9341 takes that, too. With CPHA = 1 frames
 * follow each other without a gap. */
static void set_format(unsigned bits)
{
    spi_set_format(SPI, bits, SPI_CPOL_1, SPI_CPHA_1, SPI_MSB_FIRST);
    board.bits = bits;
}

static void wait_for_dma(void)
{
    while (board.done)
        tight_loop_contents();
}

/* The frame's size and D/C may change only while nothing is being sent. */
static void wait_for_spi(unsigned bits, bool data)
{
    wait_for_dma();
    while (spi_is_busy(SPI))
        tight_loop_contents();
    if (bits != board.bits)
        set_format(bits);
    gpio_put(PIN_DC, data);
}

static bool command(void *context, uint8_t byte)
{
    (void)context;
    wait_for_spi(8, false);
    spi_write_blocking(SPI, &byte, 1);
    return true;
}

static bool data(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    wait_for_spi(8, true);
    spi_write_blocking(SPI, bytes, count);
    return true;
}

static bool framed_command(void *context, uint8_t byte)
{
    (void)context;
    wait_for_dma();
    qspi_command(byte);
    return true;
}

static bool framed_data(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    wait_for_dma();
    qspi_data(bytes, count);
    return true;
}

static bool framed_end(void *context)
{
    (void)context;
    wait_for_dma();
    qspi_end();
    return true;
}

static bool reset(void *context, bool active)
{
    (void)context;
    gpio_put(PIN_RESET, !active);
    return true;
}

static bool backlight(void *context, uint8_t percent)
{
    (void)context;
    pwm_set_gpio_level(PIN_BACKLIGHT, percent);
    return true;
}

static void wait_ms(void *context, unsigned ms)
{
    (void)context;
    for (; ms; ms--) {
        board_alive();
        busy_wait_us(1000);
    }
}

/* ---- pixels out, words in ---- */

static void is_sent(void)
{
    dma_channel_acknowledge_irq0(board.send);
    void (*const done)(void *) = board.done;
    board.done = NULL;
    done(board.argument);
}

static void flush(void *context, const uint16_t *pixels, size_t count, void (*done)(void *), void *argument)
{
    (void)context;
    if (!IS_QSPI && board.bits != 16)
        wait_for_spi(16, true);
    wait_for_dma();
    board.argument = argument;
    board.done = done;
    dma_channel_transfer_from_buffer_now(board.send, pixels, count);
}

/* The streamer reads flash in the background, behind the processor's own reads, and DMA empties its FIFO: a DMA from
 * flash would delay the other one at each word. */
static void fetch(void *context, uint32_t *to, const uint32_t *from, size_t words)
{
    (void)context;
    dma_channel_wait_for_finish_blocking(board.fetch);
    xip_ctrl_hw->stream_addr = (uint32_t)from;
    dma_channel_transfer_to_buffer_now(board.fetch, to, words);
    xip_ctrl_hw->stream_ctr = words;
}

static bool fetched(void *context)
{
    (void)context;
    return !dma_channel_is_busy(board.fetch);
}

/* ---- in step with the panel's scan ---- */

enum { TE_EDGE = IS_BEHIND_SCAN ? GPIO_IRQ_EDGE_FALL : GPIO_IRQ_EDGE_RISE };

/* The pin's latch, without an interrupt. A dead line delays one frame; its next edge revives it. */
static bool may_begin(void *context)
{
    (void)context;
    const bool edge = io_bank0_hw->intr[TE / 8] >> TE % 8 * 4 & TE_EDGE;
    if (!board.te_is_awaited) {
        if (board.te_is_dead && !edge)
            return true;
        if (board.te_is_dead)
            board_say("TE is back\r\n");
        board.te_is_dead = false;
        board.te_is_awaited = true;
        gpio_acknowledge_irq(TE, TE_EDGE);
        board.te_asked_us = time_us_32();
        return false;
    }
    if (!edge && time_us_32() - board.te_asked_us < TE_TIMEOUT_US)
        return false;
    if (!edge)
        board_say("TE is dead: frames begin at any time\r\n");
    board.te_is_dead = !edge;
    board.te_is_awaited = false;
    return true;
}

const struct hal board_hal = {{IS_QSPI ? framed_command : command, IS_QSPI ? framed_data : data,
                               IS_QSPI ? framed_end : NULL, reset, IS_QSPI ? NULL : backlight, wait_ms, NULL},
                              flush,
                              fetch,
                              fetched,
                              HAS_TE ? may_begin : NULL,
                              SECOND_CORE ? second_core_fork : NULL,
                              SECOND_CORE ? second_core_join : NULL,
                              NULL};

/* ---- start, messages ---- */

static void start_dma(void)
{
    board.send = (unsigned)dma_claim_unused_channel(true);
    dma_channel_config config = dma_channel_get_default_config(board.send);
    channel_config_set_transfer_data_size(&config, DMA_SIZE_16);
    channel_config_set_dreq(&config, IS_QSPI ? qspi_dreq() : spi_get_dreq(SPI, true));
    dma_channel_configure(board.send, &config, IS_QSPI ? qspi_pixels() : &spi_get_hw(SPI)->dr, NULL, 0, false);
    dma_channel_set_irq0_enabled(board.send, true);
    irq_set_exclusive_handler(DMA_IRQ_0, is_sent);
    irq_set_enabled(DMA_IRQ_0, true);

    board.fetch = (unsigned)dma_claim_unused_channel(true);
    config = dma_channel_get_default_config(board.fetch);
    channel_config_set_read_increment(&config, false);
    channel_config_set_write_increment(&config, true);
    channel_config_set_dreq(&config, DREQ_XIP_STREAM);
    dma_channel_configure(board.fetch, &config, NULL, (const void *)XIP_AUX_BASE, 0, false);
}

static void start_output(unsigned pin, bool value)
{
    gpio_init(pin);
    gpio_put(pin, value);
    gpio_set_dir(pin, GPIO_OUT);
}

/* Above audible frequencies. At a level of 0 the pin is always low, at 100 high. */
static void start_backlight(void)
{
    const unsigned slice = pwm_gpio_to_slice_num(PIN_BACKLIGHT);
    pwm_config config = pwm_get_default_config();
    pwm_config_set_clkdiv_int(&config, clock_get_hz(clk_sys) / (BACKLIGHT_HZ * PANEL_BRIGHTEST));
    pwm_config_set_wrap(&config, PANEL_BRIGHTEST - 1);
    pwm_set_gpio_level(PIN_BACKLIGHT, PANEL_OFF);
    pwm_init(slice, &config, true);
    gpio_set_function(PIN_BACKLIGHT, GPIO_FUNC_PWM);
}

static void start_spi(void)
{
    start_backlight();
    spi_init(SPI, BUS_HZ);
    set_format(8); /* the clock idles high before the panel leaves its reset: a later rise would count as a bit */
    gpio_set_function(PIN_CLOCK, GPIO_FUNC_SPI);
    gpio_set_function(PIN_DATA, GPIO_FUNC_SPI);
    start_output(PIN_RESET, true);
    start_output(PIN_DC, true);
    start_output(PIN_CS, false); /* the panel is alone on its bus */
}

static void start_qspi(void)
{
    start_output(PIN_POWER, true);
    start_output(PIN_RESET, true);
    start_output(PIN_CS, true);
    qspi_start();
}

/* RAM may keep its contents over a dip of the supply, which the chip reports as a power-up: the contents tell them apart. */
static uint32_t __uninitialized_ram(running);
enum { RUNNING = 0x74736f6d };

static bool supply_was_off(void)
{
#ifdef PICO_RP2040
    return vreg_and_chip_reset_hw->chip_reset & VREG_AND_CHIP_RESET_CHIP_RESET_HAD_POR_BITS;
#else
    return powman_hw->chip_reset & (POWMAN_CHIP_RESET_HAD_POR_BITS | POWMAN_CHIP_RESET_HAD_BOR_BITS);
#endif
}

/* A loader also restarts the board by the watchdog; that is no fault. */
static enum fault reason_of_start(void)
{
    const uint32_t kept = watchdog_hw->scratch[0];
    watchdog_hw->scratch[0] = FAULT_NONE;
    if (watchdog_enable_caused_reboot())
        return kept > FAULT_NONE && kept < FAULTS ? (enum fault)kept : FAULT_HUNG;
    return supply_was_off() && running == RUNNING ? FAULT_SUPPLY : FAULT_NONE;
}

void board_fail(enum fault fault)
{
    watchdog_hw->scratch[0] = fault;
    for (;;)
        tight_loop_contents();
}

enum fault board_start(void)
{
    const enum fault reason = reason_of_start();
    running = RUNNING;
    watchdog_enable(WATCHDOG_MS, true);
    uart_init(UART, UART_BAUD);
    gpio_set_function(PIN_UART_TX, GPIO_FUNC_UART);
    if (IS_QSPI)
        start_qspi();
    else
        start_spi();
    if (HAS_TE)
        gpio_init(TE); /* an input */
    start_dma();
    return reason;
}

void board_say(const char *text)
{
    for (; *text; text++)
        uart_putc_raw(UART, *text);
}

void board_alive(void)
{
    watchdog_update();
}

uint32_t board_us(void)
{
    return time_us_32();
}
