/* SPDX-License-Identifier: MIT
 * Fuzzes what the Pico makes of an accelerometer: the driver of its bus (hand.c), the sensor's (imu.c), and the tilt, by a sensor and a bus
 * that may do anything. Input: the time (4 bytes), then steps: what (1), and what it needs. After each input the bus hangs, and the light
 * circles; then there is a sensor that lies flat, and the light is above it; and one that sticks, which is none. */
#include <string.h>

#define PANEL_WIDTH 240
#define PANEL_HEIGHT 240
#define PANEL_CONTROLLER PANEL_GC9A01
#define PANEL_TURN 1
#define BOARD_ID waveshare_rp2040_lcd_1_28
#define PIN_TE (-1)
#define TURNS_MESH 0
#include "../../firmware/ports/pico/hand.c"

#include "fuzz.h"

/* ---- the chip ---- */

static i2c_hw_t block;
i2c_hw_t *const i2c0 = &block, *const i2c1 = &block;
static uint32_t now_us, waited_us;
static unsigned accesses, stops, circles, follows;
static unsigned released; /* SDA is, after so many looks */

unsigned i2c_next_word(void)
{
    return accesses++ % I2C_WORDS;
}

i2c_hw_t *i2c_get_hw(i2c_hw_t *i2c)
{
    return i2c;
}

unsigned i2c_init(i2c_hw_t *i2c, unsigned clk_hz)
{
    i2c->enable = 1;
    return clk_hz;
}

void i2c_deinit(i2c_hw_t *i2c)
{
    stops++;
    i2c->enable = 0;
}

void gpio_init(unsigned pin)
{
    check(pin == PIN_SDA || pin == PIN_SCL);
}

void gpio_set_function(unsigned pin, unsigned function)
{
    check((pin == PIN_SDA || pin == PIN_SCL) && function == GPIO_FUNC_I2C);
}

void gpio_pull_up(unsigned pin)
{
    check(pin == PIN_SDA || pin == PIN_SCL);
}

bool gpio_get(unsigned pin)
{
    check(pin == PIN_SDA);
    return released == 0 || --released == 0;
}

/* The sensor may hold SDA: we never drive it. */
void gpio_set_dir(unsigned pin, bool out)
{
    check(pin == PIN_SCL || !out);
}

void busy_wait_us(uint64_t us)
{
    waited_us += (uint32_t)us;
}

uint32_t board_us(void)
{
    return now_us;
}

void board_say(const char *text)
{
    circles += strstr(text, "the light circles") != NULL;
    follows += strstr(text, "the light follows") != NULL;
}

/* ---- what holds ---- */

enum { LIGHT_MOST = 4 * 32768, ABOVE_LEAST = 32000, ASIDE_MOST = 1000 };

static void look(void)
{
    int32_t sensed[3] = {0, 0, 0}, light[3];
    const enum light_sense sense = hand_sense(sensed);
    check(circles <= 1 && follows <= 1);
    if (!hand_is_there()) {
        check(sense == LIGHT_SENSOR_SILENT && !sensed[0] && !sensed[1] && !sensed[2]);
        check(circles == 1 || follows == 0); /* where it was there, it has been told that it is not */
        return;
    }
    check(sense == LIGHT_SENSED && follows == 1);
    (void)hand_light(light);
    for (unsigned k = 0; k < 3; k++)
        check(light[k] == sensed[k] && light[k] <= LIGHT_MOST && light[k] >= -LIGHT_MOST);
    check(light[2] >= TILT_ONE_G);
}

/* It never waits for longer than the clocks of a byte, and never asks the block for more than its FIFO holds. */
static void poll_once(void)
{
    accesses = 0;
    waited_us = 0;
    const bool is_knocked = hand_poll();
    check(accesses <= I2C_WORDS / 2 && waited_us <= 2 * CLOCKS_OF_A_BYTE * HALF_CLOCK_US);
    check(!is_knocked || hand_is_there());
    look();
}

/* ---- the sensor ---- */

static void answer(uint32_t happened, size_t count, const uint8_t *bytes)
{
    block.raw_intr_stat = happened;
    block.rxflr = (uint32_t)count;
    for (unsigned i = 0; i < I2C_WORDS; i++)
        block.words[i] = bytes[i % IMU_BYTES_MAX];
}

/* As a QMI8658 does: 5 says which part it is, and that there is a new sample. */
static void answer_well(const int16_t sample[3])
{
    uint8_t bytes[IMU_BYTES_MAX] = {5};
    for (unsigned i = 0; i < IMU_BYTES_MAX && hand.wanted == IMU_BYTES_MAX; i++)
        bytes[i] = (uint8_t)((uint16_t)sample[i / 2] >> 8 * (i % 2));
    answer(I2C_IC_RAW_INTR_STAT_STOP_DET_BITS, hand.wanted, bytes);
}

/* At rest, with a sensor's noise. */
static void lie_flat(void)
{
    static unsigned count;
    const int16_t noise = (int16_t)(count++ % 7), sample[3] = {noise, (int16_t)-noise, (int16_t)(IMU_ONE_G + noise)};
    answer_well(sample);
}

/* One that hangs by itself gives the same numbers for ever. */
static void stick(void)
{
    answer_well((const int16_t[3]){1, 2, IMU_ONE_G});
}

static void hang(void)
{
    block.raw_intr_stat = 0;
}

/* ---- steps ---- */

static void next_answer(unsigned what, struct input *input)
{
    uint8_t bytes[IMU_BYTES_MAX];
    int16_t sample[3];
    if (what == 0) {
        hang();
    } else if (what == 1) {
        lie_flat();
    } else if (what == 2) {
        for (unsigned k = 0; k < 3; k++)
            sample[k] = (int16_t)next_word(input);
        answer_well(sample);
    } else {
        const uint32_t happened = next_word(input);
        const size_t count = next_byte(input);
        for (unsigned i = 0; i < IMU_BYTES_MAX; i++)
            bytes[i] = (uint8_t)next_byte(input);
        answer(what == 3 ? happened | I2C_IC_RAW_INTR_STAT_STOP_DET_BITS : happened, count % 8, bytes);
    }
}

static void step(struct input *input)
{
    static const uint32_t pauses_us[] = {0, 100, 300, 500, 1000, 2500, 20000, 300000};
    static const unsigned times[] = {1, 4, 30, 300};
    const unsigned what = next_byte(input), how = next_byte(input);
    released = how >> 5;
    for (unsigned i = 0; i < times[how % 4]; i++) {
        now_us += pauses_us[how / 4 % 8];
        next_answer(what % 5, input);
        poll_once();
    }
}

static void poll_for(uint32_t us, void (*behave)(void))
{
    enum { FRAME_US = 4000 };
    for (uint32_t at = 0; at < us; at += FRAME_US) {
        now_us += FRAME_US;
        behave();
        poll_once();
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input input = {data, data + size};
    memset(&block, 0, sizeof block);
    memset(&hand, 0, sizeof hand);
    memset(&tilt, 0, sizeof tilt);
    imu = (struct imu){.bus = &bus};
    circles = follows = released = 0;
    now_us = next_word(&input) | (uint32_t)next_word(&input) << 16;
    hand_start();
    while (input.at < input.end)
        step(&input);
    stops = 0;
    poll_for(IMU_START_US + 500000, hang);
    check(!hand_is_there() && circles == 1 && stops > 0);
    poll_for(1000000, lie_flat);
    int32_t light[3];
    check(hand_sense(light) == LIGHT_SENSED && light[2] >= ABOVE_LEAST);
    check(light[0] <= ASIDE_MOST && light[0] >= -ASIDE_MOST && light[1] <= ASIDE_MOST && light[1] >= -ASIDE_MOST);
    poll_for(5000000, stick);
    check(!hand_is_there());
    return 0;
}
