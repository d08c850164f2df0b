/* What the source of Grbl 1.1 calls, as JSON lines (the protocol of tests/grbl_oracle.py): the machine beneath it. Grbl reads its lines
   from standard input by its own protocol_main_loop; the linker gives some of its calls to the functions `__wrap_…` here (dev/grbl_oracle).
   Besides the keys of the protocol an arc has `segments` and `points`: those of its lines that end at a quarter, a half, three quarters. */
#include "grbl.h"

volatile uint8_t DDRB, DDRC, DDRD, PORTB, PORTC, PORTD, PINB, PINC, PIND, PCICR, PCMSK0, PCMSK1, SREG, MCUSR, WDTCSR;
system_t sys;
int32_t sys_position[N_AXIS], sys_probe_position[N_AXIS];
volatile uint8_t sys_probe_state, sys_rt_exec_state, sys_rt_exec_alarm, sys_rt_exec_motion_override, sys_rt_exec_accessory_override;

static int line = 0;           /* of the program, while it is read */
static int in_probe = 0, collects = 0;
static float (*points)[N_AXIS] = NULL;
static int count = 0;

static void print_point(const float *p) { printf("[%.9g, %.9g, %.9g]", p[0], p[1], p[2]); }

/* ---- lines */

uint8_t serial_read(void) {
  static int ended = 0;
  int c;
  do c = getchar();  /* what acts at once is taken out of the stream where it comes in */
  while (c == '!' || c == '?' || c == '~' || c >= 0x80);
  if (c == EOF) {
    if (!ended) return ended = 1, ++line, '\n';
    exit(0);
  }
  if (c == '\n') ++line;
  return (uint8_t)c;
}

/* A line end comes before the line is looked at. */
void report_status_message(uint8_t code) {
  if (code != STATUS_OK) printf("{\"line\": %d, \"error\": %d}\n", line, code);
}

void report_build_info(char *text) { (void)text; }
void report_execute_startup_message(char *text, uint8_t code) { (void)text, (void)code; }
void report_feedback_message(uint8_t code) { (void)code; }
void report_gcode_modes(void) {}
void report_grbl_help(void) {}
void report_grbl_settings(void) {}
void report_ngc_parameters(void) {}
void report_probe_parameters(void) {}
void report_realtime_status(void) {}
void report_startup_line(uint8_t n, char *text) { (void)n, (void)text; }

static void end_by_alarm(int code) {
  printf("{\"line\": %d, \"alarm\": %d}\n", line, code);
  exit(0);
}
void report_alarm_message(uint8_t code) { end_by_alarm(code); }

#ifndef KADR_GRBL_TIMES /* times.c has the planner and the stepper of Grbl in place of these */

/* ---- real time: what is asked for happens at once */

void __wrap_protocol_execute_realtime(void) {
  if (sys_rt_exec_alarm) end_by_alarm(sys_rt_exec_alarm);
  if (sys_rt_exec_state & EXEC_FEED_HOLD) printf("{\"line\": %d, \"do\": \"stop\"}\n", line);
  sys_rt_exec_state = 0;
  sys.suspend = 0;
  sys.state = STATE_IDLE;
}
void __wrap_protocol_buffer_synchronize(void) { __wrap_protocol_execute_realtime(); }
void __wrap_protocol_auto_cycle_start(void) {}
void __wrap_mc_reset(void) {}

/* ---- motions */

uint8_t plan_buffer_line(float *target, plan_line_data_t *pl_data) {
  if (collects) {
    memcpy(points[count++], target, sizeof points[0]);
    return PLAN_OK;
  }
  const int rapid = (pl_data->condition & PL_COND_FLAG_RAPID_MOTION) != 0;
  printf("{\"line\": %d, \"do\": \"%s\", \"to\": ", line, in_probe ? "probe" : rapid ? "rapid" : "feed");
  print_point(target);
  printf(", \"feed\": %.9g, \"inverse\": %s}\n", pl_data->feed_rate,
         (pl_data->condition & PL_COND_FLAG_INVERSE_TIME) ? "true" : "false");
  return PLAN_OK;
}
uint8_t plan_check_full_buffer(void) { return 0; }
plan_block_t *plan_get_current_block(void) { return NULL; }
void plan_cycle_reinitialize(void) {}
void plan_reset(void) {}
void plan_update_velocity_profile_parameters(void) {}
void st_prep_buffer(void) {}
void st_update_plan_block_parameters(void) {}
void plan_sync_position(void) {}
void st_reset(void) {}
void st_go_idle(void) {}
void st_wake_up(void) {}
void st_generate_step_dir_invert_masks(void) {}
#endif

void probe_configure_invert_mask(uint8_t away) { (void)away; }
uint8_t probe_get_state(void) { return 0; }

#ifndef KADR_GRBL_TIMES
void __real_mc_arc(float *, plan_line_data_t *, float *, float *, float, uint8_t, uint8_t, uint8_t, uint8_t);
void __wrap_mc_arc(float *target, plan_line_data_t *pl_data, float *position, float *offset, float radius, uint8_t first, uint8_t second,
                   uint8_t normal, uint8_t clockwise) {
  const char *const planes[] = {"YZ", "ZX", "XY"};
  const int inverse = (pl_data->condition & PL_COND_FLAG_INVERSE_TIME) != 0;
  const float feed = pl_data->feed_rate;
  const float start[2] = {position[first], position[second]};
  const float center[2] = {position[first] + offset[first], position[second] + offset[second]};
  if (points == NULL) points = malloc(sizeof(float[N_AXIS]) * 70000);
  count = 0;
  collects = 1;
  __real_mc_arc(target, pl_data, position, offset, radius, first, second, normal, clockwise);
  collects = 0;
  double swept = 0, from[2] = {(double)start[0] - center[0], (double)start[1] - center[1]};
  for (int i = 0; i < count && count > 1; ++i) {
    const double to[2] = {(double)points[i][first] - center[0], (double)points[i][second] - center[1]};
    swept += (atan2)(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
    from[0] = to[0], from[1] = to[1];
  }
  printf("{\"line\": %d, \"do\": \"%s\", \"to\": ", line, clockwise ? "arc_cw" : "arc_ccw");
  print_point(target);
  printf(", \"feed\": %.9g, \"inverse\": %s, \"center\": [%.9g, %.9g], \"plane\": \"%s\", \"radius\": %.9g, \"turns\": %.9g, ", feed,
         inverse ? "true" : "false", center[0], center[1], planes[normal], radius, (fabs)(swept) / (2 * M_PI));
  printf("\"segments\": %d, \"points\": [", count);
  for (int quarter = 1; quarter < 4; ++quarter) {
    const int at = (int)((int64_t)count * quarter / 4);
    if (quarter > 1) printf(", ");
    printf("[%.9g, ", (double)at / count);
    if (at == 0) printf("[%.9g, %.9g]]", start[0], start[1]);
    else printf("[%.9g, %.9g]]", points[at - 1][first], points[at - 1][second]);
  }
  printf("]}\n");
}
#endif

uint8_t __real_mc_probe_cycle(float *, plan_line_data_t *, uint8_t);
uint8_t __wrap_mc_probe_cycle(float *target, plan_line_data_t *pl_data, uint8_t flags) {
  in_probe = 1;
  const uint8_t done = __real_mc_probe_cycle(target, pl_data, flags);
  in_probe = 0;
  return done;
}

void __wrap_mc_homing_cycle(uint8_t mask) {
  (void)mask;
  printf("{\"line\": %d, \"do\": \"home\", \"to\": [0, 0, 0]}\n", line);
  memset(sys_position, 0, sizeof sys_position);
  gc_sync_position();
}

#ifndef KADR_GRBL_TIMES
void __wrap_mc_dwell(float seconds) { printf("{\"line\": %d, \"do\": \"dwell\", \"seconds\": %.9g}\n", line, seconds); }
#endif

/* ---- spindle, coolant */

static void spindle(uint8_t state, float rpm) {
  const char *const dir = state == SPINDLE_DISABLE ? "off" : state == SPINDLE_ENABLE_CW ? "cw" : "ccw";
  printf("{\"line\": %d, \"do\": \"spindle\", \"dir\": \"%s\", \"rpm\": %.9g}\n", line, dir, rpm);
}
void spindle_sync(uint8_t state, float rpm) { spindle(state, rpm); }
void spindle_set_state(uint8_t state, float rpm) { spindle(state, rpm); }
void spindle_stop(void) {}
void spindle_init(void) {}
void coolant_sync(uint8_t mode) { printf("{\"line\": %d, \"do\": \"coolant\", \"flood\": %s}\n", line, (mode & COOLANT_FLOOD_ENABLE) ? "true" : "false"); }
void coolant_set_state(uint8_t mode) { coolant_sync(mode); }
void coolant_stop(void) {}
uint8_t coolant_get_state(void) { return 0; }

/* ---- what is stored, and its checksum */

static unsigned char memory[4096];
unsigned char eeprom_get_char(unsigned int at) { return memory[at]; }
void eeprom_put_char(unsigned int at, unsigned char value) { memory[at] = value; }
void memcpy_to_eeprom_with_checksum(unsigned int to, char *from, unsigned int size) { memcpy(memory + to, from, size); }
int memcpy_from_eeprom_with_checksum(char *to, unsigned int from, unsigned int size) {
  memcpy(to, memory + from, size);
  return 1;
}

int main(void) {
  setvbuf(stdout, NULL, _IOFBF, 1 << 16);
  settings_restore(SETTINGS_RESTORE_ALL);
  memset(&sys, 0, sizeof sys);
  sys.f_override = DEFAULT_FEED_OVERRIDE;
  sys.r_override = DEFAULT_RAPID_OVERRIDE;
  sys.spindle_speed_ovr = DEFAULT_SPINDLE_SPEED_OVERRIDE;
  gc_init();
  protocol_main_loop();
  return 0;
}
