/* SPDX-License-Identifier: MIT
 * Must be refused: a counter that lives on between calls. */
int bad_counter(void);
int bad_counter(void)
{
    static int count;
    return ++count;
}
