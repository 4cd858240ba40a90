/* SPDX-License-Identifier: MIT
 * Must be refused: no bound to its stack. */
int bad_endless(int n);
int bad_endless(int n)
{
    volatile int here = n;
    return n > 0 ? bad_endless(n - 1) + bad_endless(n - 2) + here : 0;
}
