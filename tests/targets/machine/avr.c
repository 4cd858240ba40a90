/* SPDX-License-Identifier: MIT
 * ATmega2560 under simavr: output by USART 0; asleep with interrupts off, it ends. */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

#include "machine.h"

extern uint8_t __heap_start[]; /* avr-libc's: above static data */
int main(void);

void machine_put(char c)
{
    while (!(UCSR0A & (1 << UDRE0)))
        ;
    UDR0 = (uint8_t)c;
}

int main(void)
{
    UCSR0B = 1 << TXEN0;
    machine_run(__heap_start);
    while (!(UCSR0A & (1 << UDRE0)))
        ;
    cli();
    sleep_mode();
    return 0;
}
