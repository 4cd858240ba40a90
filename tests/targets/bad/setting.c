/* SPDX-License-Identifier: MIT
 * Must be refused: a global variable with a value. */
extern int bad_setting;
int bad_setting = 7;
