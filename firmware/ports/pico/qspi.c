/* SPDX-License-Identifier: MIT
 * A frame is select low, a byte that says by how many lines its data come, 24 bits with the command in their middle, data, select high
 * (as Arduino_GFX's and esp_lcd_co5300's drivers send it). The state machine sends 16 bits in nibbles; of what goes by one line each bit is
 * a nibble. */
#include "qspi.h"
#include "board.h"

#include <hardware/clocks.h>
#include <hardware/gpio.h>
#include <hardware/pio.h>

enum { BY_ONE_LINE = 0x02, PIXELS_BY_FOUR = 0x32 };
enum { MACHINE = 0, LINES = 4, WORD = 16, CYCLES_A_NIBBLE = 2 };
enum { BETWEEN_FRAMES_HZ = 20000000 }; /* select is high for 50 ns at least */
#define PIO pio0

static bool takes_pixels; /* the command that is open */

/* The panel takes a nibble when the clock rises. The machine waits for the next one with the clock low. */
void qspi_start(void)
{
    const uint16_t instructions[] = {(uint16_t)(pio_encode_out(pio_pins, LINES) | pio_encode_sideset(1, 0)),
                                     (uint16_t)(pio_encode_nop() | pio_encode_sideset(1, 1))};
    const struct pio_program program = {.instructions = instructions, .length = 2, .origin = -1};
    const unsigned at = (unsigned)pio_add_program(PIO, &program);
    const uint32_t most_hz = (uint32_t)BUS_HZ * CYCLES_A_NIBBLE;
    pio_sm_config config = pio_get_default_sm_config();
    sm_config_set_wrap(&config, at, at + 1);
    sm_config_set_sideset(&config, 1, false, false);
    sm_config_set_sideset_pins(&config, PIN_CLOCK);
    sm_config_set_out_pins(&config, PIN_DATA, LINES);
    sm_config_set_out_shift(&config, false, true, WORD);
    sm_config_set_fifo_join(&config, PIO_FIFO_JOIN_TX);
    sm_config_set_clkdiv_int_frac(&config, (uint16_t)((clock_get_hz(clk_sys) + most_hz - 1) / most_hz), 0);
    pio_sm_claim(PIO, MACHINE);
    pio_sm_set_consecutive_pindirs(PIO, MACHINE, PIN_DATA, LINES, true);
    pio_sm_set_consecutive_pindirs(PIO, MACHINE, PIN_CLOCK, 1, true);
    for (unsigned i = 0; i <= LINES; i++) {
        const unsigned pin = i < LINES ? (unsigned)PIN_DATA + i : (unsigned)PIN_CLOCK;
        pio_gpio_init(PIO, pin);
        gpio_set_slew_rate(pin, GPIO_SLEW_RATE_FAST);
    }
    pio_sm_init(PIO, MACHINE, at, &config);
    pio_sm_set_enabled(PIO, MACHINE, true);
}

static void put(uint32_t word)
{
    pio_sm_put_blocking(PIO, MACHINE, word << WORD); /* it shifts out from the left */
}

static void put_by_one_line(uint8_t byte)
{
    uint32_t nibbles = 0;
    for (unsigned bit = 0; bit < 8; bit++)
        nibbles |= (uint32_t)(byte >> bit & 1) << LINES * bit;
    put(nibbles >> WORD);
    put(nibbles);
}

/* It stalls when all has been sent. */
void qspi_end(void)
{
    const uint32_t stalls = 1u << (PIO_FDEBUG_TXSTALL_LSB + MACHINE);
    PIO->fdebug = stalls;
    while (!(PIO->fdebug & stalls))
        tight_loop_contents();
    gpio_put(PIN_CS, true);
}

void qspi_command(uint8_t command)
{
    qspi_end();
    busy_wait_at_least_cycles(clock_get_hz(clk_sys) / BETWEEN_FRAMES_HZ + 1);
    gpio_put(PIN_CS, false);
    takes_pixels = command == PANEL_MEMORY_WRITE || command == PANEL_MEMORY_CONTINUE;
    put_by_one_line(takes_pixels ? PIXELS_BY_FOUR : BY_ONE_LINE);
    put_by_one_line(0);
    put_by_one_line(command);
    put_by_one_line(0);
}

void qspi_data(const uint8_t *bytes, size_t count)
{
    if (takes_pixels)
        for (size_t i = 0; i + 1 < count; i += 2)
            put((uint32_t)bytes[i] << 8 | bytes[i + 1]);
    else
        for (size_t i = 0; i < count; i++)
            put_by_one_line(bytes[i]);
}

volatile void *qspi_pixels(void)
{
    return &PIO->txf[MACHINE];
}

unsigned qspi_dreq(void)
{
    return pio_get_dreq(PIO, MACHINE, true);
}
