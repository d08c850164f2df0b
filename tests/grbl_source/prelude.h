/* Included before each file of Grbl when it is compiled for a computer instead of an AVR. On the AVR a double is a float, and the functions
   of math.h work on floats; these definitions reproduce that. Written for dev/grbl_oracle; it contains no code of Grbl. */
#ifndef KADR_GRBL_PRELUDE
#define KADR_GRBL_PRELUDE

#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define atan2 atan2f
#define ceil ceilf
#define cos cosf
#define fabs fabsf
#define floor floorf
#define lround lroundf
#define round roundf
#define sin sinf
#define sqrt sqrtf
#define trunc truncf

/* Replaces what the headers of avr-libc define. */
#define F_CPU 16000000UL
#define ISR(name) void name(void)
#define PROGMEM
#define __flash
#define PSTR(text) (text)
#define pgm_read_byte_near(at) (*(const char*)(at))
#define cli()
#define sei()
#define _delay_ms(x)
#define _delay_us(x)
#define PCIE0 0
#define PCIE1 1
extern volatile uint8_t DDRB, DDRC, DDRD, PORTB, PORTC, PORTD, PINB, PINC, PIND, PCICR, PCMSK0, PCMSK1, SREG, MCUSR, WDTCSR;

#endif
