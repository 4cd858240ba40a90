/* SPDX-License-Identifier: MIT
 * I2C without waiting: the block's FIFO holds a whole transfer, to and fro. */
#include "hand.h"
#include "board.h"
#include "imu.h"
#include "tilt.h"

#include <hardware/gpio.h>
#include <hardware/i2c.h>
#include <hardware/timer.h>

#define I2C (PIN_SDA / 2 % 2 ? i2c1 : i2c0) /* the chip's, by the pin */
enum { I2C_HZ = 400000, HALF_CLOCK_US = 5, CLOCKS_OF_A_BYTE = 9 };

static struct {
    size_t wanted; /* bytes of the transfer under way */
    bool is_there;
    bool said_lost, said_there;
} hand;
static struct tilt tilt;

/* ---- the bus ---- */

static void use_i2c(void)
{
    (void)i2c_init(I2C, I2C_HZ);
    gpio_set_function(PIN_SDA, GPIO_FUNC_I2C);
    gpio_set_function(PIN_SCL, GPIO_FUNC_I2C);
    gpio_pull_up(PIN_SDA);
    gpio_pull_up(PIN_SCL);
}

static void begin(void *context, uint8_t address, const uint8_t *bytes, size_t count, size_t wanted)
{
    (void)context;
    i2c_hw_t *const hw = i2c_get_hw(I2C);
    hw->enable = 0;
    hw->tar = address;
    hw->enable = 1;
    (void)hw->clr_intr;
    hand.wanted = wanted;
    for (size_t i = 0; i < count; i++)
        hw->data_cmd = bytes[i] | (i + 1 == count && wanted == 0 ? I2C_IC_DATA_CMD_STOP_BITS : 0);
    for (size_t i = 0; i < wanted; i++)
        hw->data_cmd = I2C_IC_DATA_CMD_CMD_BITS | (i == 0 ? I2C_IC_DATA_CMD_RESTART_BITS : 0) |
                       (i + 1 == wanted ? I2C_IC_DATA_CMD_STOP_BITS : 0);
}

static enum imu_transfer ask(void *context, uint8_t *read)
{
    (void)context;
    i2c_hw_t *const hw = i2c_get_hw(I2C);
    const uint32_t happened = hw->raw_intr_stat;
    if (!(happened & I2C_IC_RAW_INTR_STAT_STOP_DET_BITS))
        return IMU_UNDER_WAY;
    if ((happened & I2C_IC_RAW_INTR_STAT_TX_ABRT_BITS) || hw->rxflr != hand.wanted)
        return IMU_FAILED;
    for (size_t i = 0; i < hand.wanted; i++)
        read[i] = (uint8_t)hw->data_cmd;
    return IMU_ENDED;
}

/* A device that was cut off in the middle of a byte holds SDA low until it has got that byte's clocks (UM10204, 3.1.16). */
static void stop(void *context)
{
    (void)context;
    i2c_deinit(I2C);
    gpio_init(PIN_SDA); /* inputs, pulled up */
    gpio_init(PIN_SCL);
    for (unsigned i = 0; i < CLOCKS_OF_A_BYTE && !gpio_get(PIN_SDA); i++) {
        gpio_set_dir(PIN_SCL, GPIO_OUT); /* low */
        busy_wait_us(HALF_CLOCK_US);
        gpio_set_dir(PIN_SCL, GPIO_IN);
        busy_wait_us(HALF_CLOCK_US);
    }
    use_i2c();
}

static const struct imu_bus bus = {begin, ask, stop, NULL};
static struct imu imu = {.bus = &bus};

/* ---- the hand ---- */

void hand_start(void)
{
    if (HAS_IMU)
        use_i2c();
}

static void say_once(bool *said, const char *text)
{
    if (!*said)
        board_say(text);
    *said = true;
}

bool hand_poll(void)
{
    static const int8_t axes[3] = {BOARD_FACT(BOARD_ID, RIGHT), BOARD_FACT(BOARD_ID, UP),
                                   BOARD_FACT(BOARD_ID, TOWARDS)};
    int16_t sample[3], turned[3];
    if (!HAS_IMU)
        return false;
    switch (imu_poll(&imu, board_us(), sample)) {
    case IMU_SAMPLE:
        hand.is_there = true;
        say_once(&hand.said_there, "the light follows the hand\r\n");
        tilt_turn(turned, sample, axes, PANEL_TURN);
        return tilt_add(&tilt, turned);
    case IMU_LOST:
        hand.is_there = false;
        tilt = (struct tilt){0};
        say_once(&hand.said_lost, TURNS_MESH ? "the accelerometer does not answer: the light stands still\r\n"
                                             : "the accelerometer does not answer: the light circles\r\n");
        return false;
    default:
        return false;
    }
}

bool hand_is_there(void)
{
    return HAS_IMU && hand.is_there;
}

bool hand_light(int32_t to_light[3])
{
    return tilt_light(&tilt, to_light);
}

enum light_sense hand_sense(int32_t to_light[3])
{
    if (!HAS_IMU)
        return LIGHT_NO_SENSOR;
    if (!hand.is_there)
        return LIGHT_SENSOR_SILENT;
    tilt_look(&tilt, to_light);
    return LIGHT_SENSED;
}
