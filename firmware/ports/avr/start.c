/* SPDX-License-Identifier: MIT
 * ATmega2560, ATmega328P: output by USART 0. Under simavr: asleep with interrupts off, it ends. */
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
    UBRR0 = 16; /* 115200 baud at 16 MHz */
    UCSR0A = 1 << U2X0;
    UCSR0B = 1 << TXEN0;
    (void)machine_run(__heap_start);
    while (!(UCSR0A & (1 << UDRE0)))
        ;
    cli();
    sleep_mode();
    return 0;
}
