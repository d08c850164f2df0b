/* How long the source of Grbl 1.1 needs for a program: its own planner and its own generator of step segments (stepper.c), whose timer ticks
   are counted. A program comes on standard input, `$` lines before it set the controller; `SECONDS` is printed at the end. The buffer is
   always full, as with a sender that is fast enough. Built by dev/grbl_oracle --times; contains no code of Grbl. */
#define KADR_GRBL_TIMES
#include "oracle.c"

/* The registers of the timers, which nothing reads. */
volatile uint8_t TCCR0A, TCCR0B, TCCR1A, TCCR1B, TCNT0, TIMSK0, TIMSK1, OCR0A;
volatile uint16_t OCR1A, TCNT1;
enum { CS01 = 1, CS10 = 0, CS11 = 1, CS12 = 2, WGM12 = 3, WGM13 = 4, WGM10 = 0, WGM11 = 1, COM1A0 = 6, COM1A1 = 7, COM1B0 = 4, COM1B1 = 5,
       OCIE0A = 1, OCIE0B = 2, TOIE0 = 0, OCIE1A = 1 };
#include "stepper.c"

uint8_t spindle_compute_pwm_value(float rpm) { return (void)rpm, 0; }
void spindle_set_speed(uint8_t value) { (void)value; }
void probe_state_monitor(void) {}

static double seconds = 0;

/* Executes segments until the planner has space, or until nothing is left. */
static void play(int to_the_end) {
  for (;;) {
    if (!to_the_end && !plan_check_full_buffer()) return;
    st_prep_buffer();
    if (segment_buffer_head == segment_buffer_tail) return;
    const segment_t *const segment = &segment_buffer[segment_buffer_tail];
    seconds += (double)segment->n_step * segment->cycles_per_tick / F_CPU;
    if (++segment_buffer_tail == SEGMENT_BUFFER_SIZE) segment_buffer_tail = 0;
  }
}

void __wrap_protocol_execute_realtime(void) {
  if (sys_rt_exec_alarm) end_by_alarm(sys_rt_exec_alarm);
  sys_rt_exec_state = 0;
  sys.suspend = 0;
  sys.state = STATE_IDLE;
}
void __wrap_protocol_auto_cycle_start(void) { play(0); }
void __wrap_protocol_buffer_synchronize(void) { play(1); }
void __wrap_mc_reset(void) {}
void __wrap_mc_dwell(float wait) {
  play(1);
  seconds += wait;
}

static void print_seconds(void) {
  play(1);
  fprintf(stderr, "%.6f\n", seconds);
}

__attribute__((constructor)) static void begin(void) {
  plan_reset();
  st_reset();
  atexit(print_seconds);
}
