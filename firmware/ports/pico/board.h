/* SPDX-License-Identifier: MIT
 * A Raspberry Pi Pico with a panel on SPI1: the pins of Waveshare's Pico-LCD boards. */
#ifndef BOARD_H
#define BOARD_H

#include "fault.h"
#include "hal.h"

enum { PIN_UART_TX = 0, PIN_DC = 8, PIN_CS = 9, PIN_CLOCK = 10, PIN_DATA = 11, PIN_RESET = 12, PIN_BACKLIGHT = 13 };
enum { UART_BAUD = 115200, WATCHDOG_MS = 1000, BACKLIGHT_HZ = 25000 };
/* ST7789: what its data sheet allows. ILI9341: three times as much, as most of its drivers do. */
enum { SPI_HZ = PANEL_CONTROLLER == PANEL_ILI9341 ? 31250000 : 62500000 };

/* The panel scans its rows SCAN_HZ times a second, and pauses while its tearing line (TE) is high. A frame that is written
 * more slowly than it is scanned starts behind the scan, when TE falls; a faster one ahead of it, when TE rises. */
enum { SCAN_HZ = 60, SCAN_ROWS = PANEL_ROWS + 24, IS_BEHIND_SCAN = PANEL_WIDTH * 16 * SCAN_HZ * SCAN_ROWS > SPI_HZ };
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
