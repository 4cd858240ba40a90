/* SPDX-License-Identifier: MIT
 * A highlight as the angle between the normal and the half vector grows: the modified Schlick function, exact, in units
 * of 1/65536. Fits an Arduino Uno. */
#include <glint.h>

void setup()
{
    Serial.begin(115200);
    for (int32_t c = 65536; c >= 57344; c -= 1024) { /* the cosine, Q16.16; n = 60 */
        Serial.print(c);
        Serial.print(' ');
        Serial.println(glint_msh(60, c));
    }
}

void loop()
{
}
