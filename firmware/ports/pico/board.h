/* SPDX-License-Identifier: MIT
 * A board with an RP2040 or RP2350 and a panel on its SPI, or on QSPI by PIO; which one, BOARD_ID says, a row of boards.def. */
#ifndef BOARD_H
#define BOARD_H

#include "fault.h"
#include "hal.h"

enum { IMU_NONE, IMU_QMI8658 };
enum board_facts {
#define BOARD(name, id, chip, panel, turn, dc, cs, clock, data, reset, backlight, uart_tx, imu, sda, scl, right, up,   \
              towards)                                                                                                 \
    id##_TURN = turn, id##_DC = dc, id##_CS = cs, id##_CLOCK = clock, id##_DATA = data, id##_RESET = reset,            \
    id##_BACKLIGHT = backlight, id##_UART_TX = uart_tx, id##_IMU = IMU_##imu, id##_SDA = sda, id##_SCL = scl,          \
    id##_RIGHT = right, id##_UP = up, id##_TOWARDS = towards,
#include "boards.def"
};
#define BOARD_JOINED(id, fact) id##_##fact
#define BOARD_FACT(id, fact) BOARD_JOINED(id, fact)
enum {
    PIN_DC = BOARD_FACT(BOARD_ID, DC),
    PIN_CS = BOARD_FACT(BOARD_ID, CS),
    PIN_CLOCK = BOARD_FACT(BOARD_ID, CLOCK),
    PIN_DATA = BOARD_FACT(BOARD_ID, DATA),
    PIN_RESET = BOARD_FACT(BOARD_ID, RESET),
    PIN_BACKLIGHT = BOARD_FACT(BOARD_ID, BACKLIGHT),
    PIN_POWER = PIN_BACKLIGHT, /* of a panel on QSPI, which emits light */
    PIN_UART_TX = BOARD_FACT(BOARD_ID, UART_TX),
    PIN_SDA = BOARD_FACT(BOARD_ID, SDA),
    PIN_SCL = BOARD_FACT(BOARD_ID, SCL),
    HAS_IMU = BOARD_FACT(BOARD_ID, IMU)
};
enum { UART_BAUD = 115200, WATCHDOG_MS = 1000, BACKLIGHT_HZ = 25000 };
enum {
    BUS_HZ = BOARD_FACT(PANEL_CONTROLLER, HZ),
    IS_QSPI = (int)BOARD_FACT(PANEL_CONTROLLER, BUS) == (int)PANEL_ON_QSPI,
    BUS_LINES = IS_QSPI ? 4 : 1
};
/* Of the picture on the panel; PANEL_TURN: its part that the build was told. */
enum { BOARD_ROTATION = (PANEL_TURN + BOARD_FACT(BOARD_ID, TURN)) % 4 };

/* The panel scans its rows SCAN_HZ times a second, and pauses while its tearing line (TE) is high. A frame that is written
 * more slowly than it is scanned starts behind the scan, when TE falls; a faster one ahead of it, when TE rises. */
enum {
    SCAN_HZ = 60,
    SCAN_ROWS = BOARD_FACT(PANEL_CONTROLLER, ROWS) + 24,
    IS_BEHIND_SCAN = PANEL_WIDTH * 16 / BUS_LINES * SCAN_HZ * SCAN_ROWS > BUS_HZ
};
enum { HAS_TE = PIN_TE >= 0, TE = HAS_TE ? PIN_TE : 0, TE_TIMEOUT_US = 40000 /* its slowest scan takes 26 ms */ };

/* Clocks run already. Returns the fault for which the board was restarted, if there was one. */
enum fault board_start(void);
/* Restarts the board by the watchdog; board_start then returns the fault. */
void board_fail(enum fault fault);
extern const struct hal board_hal;
void board_say(const char *text); /* over the UART; waits while its FIFO is full */
void board_alive(void);           /* call it at least every WATCHDOG_MS */
uint32_t board_us(void);          /* since the start, modulo 2^32 */

#endif
