/* SPDX-License-Identifier: MIT
 * The light follows the hand that holds the board, where it has an accelerometer. */
#ifndef HAND_H
#define HAND_H

#include "light_protocol.h"

void hand_start(void);
/* Call it often; it never waits. True: a tap or a shake. */
bool hand_poll(void);
/* Is there an accelerometer, and does it answer? */
bool hand_is_there(void);
/* Where the light is then, towards the picture's right, up and the viewer. True: it has moved since. */
bool hand_light(int32_t to_light[3]);
/* The same for a host, which only asks: light_device.h. */
enum light_sense hand_sense(int32_t to_light[3]);

#endif
