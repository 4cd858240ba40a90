/* SPDX-License-Identifier: MIT
 * Must be refused: a floating-point multiplication. */
float bad_floating(float a, float b);
float bad_floating(float a, float b)
{
    return a * b;
}
