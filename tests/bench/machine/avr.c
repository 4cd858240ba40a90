/* SPDX-License-Identifier: MIT
 * ATmega2560 under simavr: timer 1 counts cycles, its overflows are counted by an interrupt, whose own cycles are taken
 * off. */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/pgmspace.h>

#include "clock.h"

static volatile uint16_t overflows;
/* jmp 3, the handler 33, reti 5; for the entry simavr charges nothing. */
enum { INTERRUPT = 41 };

ISR(TIMER1_OVF_vect)
{
    overflows++;
}

void clock_begin(void)
{
    TCCR1A = 0;
    TCCR1B = 1 << CS10;
    TIMSK1 = 1 << TOIE1;
    sei();
}

uint32_t clock_now(void)
{
    cli();
    uint16_t low = TCNT1, high = overflows;
    if (TIFR1 & (1 << TOV1)) { /* one is due */
        low = TCNT1;
        high++;
    }
    sei();
    return ((uint32_t)high << 16 | low) - (uint32_t)high * INTERRUPT;
}

extern const struct glint_vec lines_int16[SPHERE_LINES][SPHERE_W];

void sphere_line(enum bench_map map, unsigned k)
{
    (void)map;
    memcpy_P(bench_line.normals, lines_int16[k], sizeof lines_int16[k]);
}
