/* SPDX-License-Identifier: MIT
 * What hand.c takes of the Pico SDK's I2C; fuzz_imu.c stands in for it. Each access to data_cmd is one to the next of a few words. */
#ifndef LAB_SDK_I2C_H
#define LAB_SDK_I2C_H

#include <stdint.h>

enum { I2C_WORDS = 16 };
typedef struct {
    uint32_t enable, tar, clr_intr, raw_intr_stat, rxflr, words[I2C_WORDS];
} i2c_hw_t;
#define data_cmd words[i2c_next_word()]

/* As in the chip. */
enum {
    I2C_IC_DATA_CMD_CMD_BITS = 0x100,
    I2C_IC_DATA_CMD_STOP_BITS = 0x200,
    I2C_IC_DATA_CMD_RESTART_BITS = 0x400,
    I2C_IC_RAW_INTR_STAT_TX_ABRT_BITS = 0x40,
    I2C_IC_RAW_INTR_STAT_STOP_DET_BITS = 0x200
};

extern i2c_hw_t *const i2c0, *const i2c1;
unsigned i2c_next_word(void);
i2c_hw_t *i2c_get_hw(i2c_hw_t *i2c);
unsigned i2c_init(i2c_hw_t *i2c, unsigned clk_hz);
void i2c_deinit(i2c_hw_t *i2c);

#endif
