/* kadr: a HAL component that moves joints along the samples that Kadr writes into shared memory, and brakes along their path by itself if
 * Kadr holds, is late, or dies. It is the client of kadr_ring.h; kadr_track.h has the motion. docs/hal.md describes the pins.
 *
 *   loadrt kadr ring=mill joints=3
 *   addf kadr.period servo-thread
 *
 * Copyright (C) 2026 the authors of Kadr. SPDX-License-Identifier: GPL-2.0-or-later
 * This program is free software; you can redistribute it and/or modify it under the terms of the GNU General Public License as published by
 * the Free Software Foundation; either version 2 of the License, or (at your option) any later version. It is distributed WITHOUT ANY
 * WARRANTY; see COPYING.
 */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "hal.h"
#include "kadr_track.h"
#include "rtapi.h"
#include "rtapi_app.h"

MODULE_AUTHOR("the authors of Kadr");
MODULE_DESCRIPTION("Moves joints along the samples that Kadr writes");
MODULE_LICENSE("GPL");

static char* ring = "kadr";
RTAPI_MP_STRING(ring, "name of the ring: the file /dev/shm/kadr-NAME");
static int joints = 3;
RTAPI_MP_INT(joints, "number of joints, 1 to 9");

struct joint_pins {
  hal_float_t *motor_pos_cmd, *motor_pos_fb, *f_error, *max_speed, *max_f_error;
  hal_bit_t *amp_enable_out, *amp_fault_in, *pos_lim_sw_in, *neg_lim_sw_in;
};

struct pins {
  struct joint_pins joint[KADR_AXES];
  hal_bit_t *emc_enable_in, *motion_enabled, *in_position, *feed_hold;
  hal_bit_t *spindle_on, *spindle_forward, *spindle_reverse, *spindle_at_speed;
  hal_float_t *spindle_speed_out, *spindle_speed_in;
  hal_bit_t *coolant_flood, *coolant_mist, *tool_change, *tool_changed;
  hal_s32_t *tool_number, *program_line, *state, *fault, *fault_joint;
  hal_u32_t *sample, *starved, *leases_lost;
  hal_float_t *rate, *lease_time, *start_tolerance;
};

static int component;
static struct pins* pins;        /* in HAL's shared memory */
static struct kadr_ring* shared; /* shared with Kadr */
static char path[64];
static struct kadr_track track;
static struct kadr_status status;
static uint64_t generation, beat;
static uint32_t ramp;     /* number of the last request of a ramp */
static double since_beat; /* s */
static int has_beat_lost;
static enum kadr_fault hard_fault; /* a fault after which the joints do not follow any more */
static int hard_fault_joint;
static double position[KADR_AXES];

#define LOAD(field) __atomic_load_n(&(field), __ATOMIC_ACQUIRE)

static void load_double(const double* from, double* to) { __atomic_load(from, to, __ATOMIC_ACQUIRE); }

static void be_off(void) {
  int j;
  kadr_track_reset(&track);
  generation = 0;
  for (j = 0; j < joints; ++j) position[j] = *pins->joint[j].motor_pos_fb;
}

/* Notes a fault of the machine. The joints follow their feedback from now on, without being enabled. */
static void look_for_hard_faults(void) {
  int j;
  for (j = 0; j < joints && hard_fault == KADR_NO_FAULT; ++j) {
    const struct joint_pins* const p = &pins->joint[j];
    const double error = position[j] - *p->motor_pos_fb;
    if (!(error <= *p->max_f_error && error >= -*p->max_f_error)) hard_fault = KADR_FOLLOWING;
    if (*p->amp_fault_in) hard_fault = KADR_DRIVE;
    if (*p->pos_lim_sw_in || *p->neg_lim_sw_in) hard_fault = KADR_LIMIT_SWITCH;
    hard_fault_joint = j;
  }
}

/* The first sample must be where the joints are. */
static int begins_here(const struct kadr_sample* first) {
  int j;
  for (j = 0; j < joints; ++j) {
    const double away = first->position[j] - position[j];
    if (!(away <= *pins->start_tolerance && away >= -*pins->start_tolerance)) return kadr_fail(&track, KADR_BAD_START, j);
  }
  return 1;
}

static int is_at_rest(void) {
  const enum kadr_state state = kadr_track_state(&track);
  return state != KADR_RUNNING && state != KADR_BRAKING;
}

/* Copies new samples. */
static void take_samples(void) {
  const uint64_t word = LOAD(shared->command.head), head = word & (((uint64_t)1 << KADR_HEAD_BITS) - 1);
  struct kadr_sample sample;
  int n;
  if (track.fault != KADR_NO_FAULT) return;
  if (word >> KADR_HEAD_BITS != generation) {
    if (!is_at_rest()) {
      kadr_fail(&track, KADR_BAD_HEAD, 0);
      return;
    }
    generation = word >> KADR_HEAD_BITS;
    kadr_track_reset(&track);
  }
  if (head < track.head || head - track.at > 2 * (uint64_t)KADR_SAMPLES) {
    kadr_fail(&track, KADR_BAD_HEAD, 0);
    return;
  }
  for (n = 0; n < KADR_COPIES && track.head < head; ++n) {
    memcpy(&sample, &shared->sample[track.head % KADR_SAMPLES], sizeof sample);
    if (track.head == 0 && !begins_here(&sample)) return;
    if (!kadr_track_take(&track, &sample)) return;
  }
}

/* Begins a requested ramp if its position has come. */
static void take_ramp(void) {
  const uint32_t number = LOAD(shared->command.ramp);
  const uint64_t at = LOAD(shared->command.ramp_at);
  double part, to, periods, away;
  load_double(&shared->command.ramp_part, &part);
  load_double(&shared->command.ramp_to, &to);
  load_double(&shared->command.ramp_periods, &periods);
  if (number == ramp || LOAD(shared->command.ramp) != number) return;
  if (track.head == 0 || !kadr_is_finite(part) || !kadr_is_finite(to) || !kadr_is_finite(periods)) {
    status.ramp_refused = 1;
  } else {
    away = at > track.at ? (double)(at - track.at) : -(double)(track.at - at);
    away += part - track.part;
    if (away > track.rate / 2 && !track.stands && track.rate > 0) return; /* not yet */
    status.ramp_refused = away < -track.rate / 2 - 1e-6 || away > track.rate / 2 + 1e-6 || !kadr_track_ramp(&track, to, periods);
  }
  ramp = status.ramp = number;
}

static void look_at_lease(double seconds) {
  const uint64_t now = LOAD(shared->command.beat);
  const int was_lost = has_beat_lost;
  since_beat = now == beat ? since_beat + seconds : 0;
  beat = now;
  has_beat_lost = since_beat > *pins->lease_time;
  if (has_beat_lost && !was_lost && !is_at_rest()) ++status.leases_lost;
}

static void follow_samples(double seconds) {
  struct kadr_wants wants;
  take_samples();
  look_at_lease(seconds);
  wants.stop = has_beat_lost || LOAD(shared->command.hold) != 0 || *pins->feed_hold;
  wants.release = LOAD(shared->command.release);
  if (!wants.stop) take_ramp();
  kadr_track_step(&track, &wants);
  kadr_track_position(&track, position);
}

/* Sets the outputs that a sample states. Without samples everything is off. */
static void set_machine(enum kadr_state state) {
  const struct kadr_sample* const now =
      track.head > 0 && state != KADR_OFF && hard_fault == KADR_NO_FAULT ? kadr_sample_of(&track, track.at) : 0;
  const double speed = now != 0 ? (double)now->spindle : 0;
  *pins->spindle_on = speed < 0 || speed > 0;
  *pins->spindle_forward = speed > 0;
  *pins->spindle_reverse = speed < 0;
  *pins->spindle_speed_out = speed;
  *pins->coolant_flood = now != 0 && (now->flags & KADR_FLOOD) != 0;
  *pins->coolant_mist = now != 0 && (now->flags & KADR_MIST) != 0;
  *pins->tool_change = now != 0 && state == KADR_WAITING && (now->flags & KADR_CHANGE_TOOL) != 0;
  *pins->tool_number = now != 0 ? now->tool : 0;
  *pins->program_line = now != 0 && now->line <= 0x7FFFFFFF ? (int)now->line : 0;
}

static void set_joints(int enabled) {
  int j;
  for (j = 0; j < joints; ++j) {
    struct joint_pins* const p = &pins->joint[j];
    *p->amp_enable_out = enabled;
    *p->motor_pos_cmd = position[j];
    *p->f_error = position[j] - *p->motor_pos_fb;
  }
  *pins->motion_enabled = enabled;
}

static void set_status(enum kadr_state state) {
  int j;
  struct kadr_status* const to = &shared->status;
  ++status.ticks;
  status.generation = generation;
  status.taken = track.head;
  status.at = track.at;
  status.part = track.part;
  status.rate = state == KADR_RUNNING || state == KADR_BRAKING ? track.rate : 0;
  for (j = 0; j < joints; ++j) {
    status.position[j] = position[j];
    status.feedback[j] = *pins->joint[j].motor_pos_fb;
  }
  status.spindle_feedback = *pins->spindle_speed_in;
  status.state = state;
  status.fault = hard_fault != KADR_NO_FAULT ? hard_fault : track.fault;
  status.fault_axis = (uint32_t)(hard_fault != KADR_NO_FAULT ? hard_fault_joint : track.fault_axis);
  status.starved = track.starved;
  status.at_speed = *pins->spindle_at_speed;
  status.tool_changed = *pins->tool_changed;
  ++status.sequence;
  __atomic_store_n(&to->sequence, status.sequence, __ATOMIC_RELAXED);
  __atomic_thread_fence(__ATOMIC_RELEASE);
  memcpy((char*)to + sizeof to->sequence, (const char*)&status + sizeof status.sequence, sizeof status - sizeof status.sequence);
  ++status.sequence;
  __atomic_store_n(&to->sequence, status.sequence, __ATOMIC_RELEASE);
  *pins->state = (int)state;
  *pins->fault = (int)status.fault;
  *pins->fault_joint = (int)status.fault_axis;
  *pins->rate = status.rate;
  *pins->sample = (hal_u32_t)track.at;
  *pins->starved = track.starved;
  *pins->leases_lost = status.leases_lost;
  *pins->in_position = state != KADR_RUNNING && state != KADR_BRAKING;
}

/* The function of the servo thread. */
static void period(void* unused, long nanoseconds) {
  const double seconds = (double)nanoseconds * 1e-9;
  const int enabled = *pins->emc_enable_in;
  enum kadr_state state = KADR_OFF;
  int j;
  (void)unused;
  for (j = 0; j < joints; ++j) {
    const double speed = *pins->joint[j].max_speed;
    track.reach[j] = speed * seconds * 1.05 + 1e-6;
    __atomic_store(&shared->header.speed[j], &speed, __ATOMIC_RELAXED);
  }
  __atomic_store_n(&shared->header.period_ns, (uint32_t)nanoseconds, __ATOMIC_RELEASE);
  if (!enabled) hard_fault = KADR_NO_FAULT;
  else look_for_hard_faults();
  if (!enabled || hard_fault != KADR_NO_FAULT) {
    be_off();
    if (enabled) state = KADR_FAULT;
  } else {
    follow_samples(seconds);
    state = kadr_track_state(&track);
    if (track.head == 0 && track.fault != KADR_NO_FAULT) state = KADR_FAULT;
  }
  set_joints(enabled && hard_fault == KADR_NO_FAULT);
  set_machine(state);
  set_status(state);
}

static int export_joint(int j) {
  struct joint_pins* const p = &pins->joint[j];
  const char* const prefix = "kadr.joint";
  int bad = hal_pin_float_newf(HAL_OUT, &p->motor_pos_cmd, component, "%s.%d.motor-pos-cmd", prefix, j);
  bad |= hal_pin_float_newf(HAL_IN, &p->motor_pos_fb, component, "%s.%d.motor-pos-fb", prefix, j);
  bad |= hal_pin_float_newf(HAL_OUT, &p->f_error, component, "%s.%d.f-error", prefix, j);
  bad |= hal_pin_float_newf(HAL_IN, &p->max_speed, component, "%s.%d.max-speed", prefix, j);
  bad |= hal_pin_float_newf(HAL_IN, &p->max_f_error, component, "%s.%d.max-f-error", prefix, j);
  bad |= hal_pin_bit_newf(HAL_OUT, &p->amp_enable_out, component, "%s.%d.amp-enable-out", prefix, j);
  bad |= hal_pin_bit_newf(HAL_IN, &p->amp_fault_in, component, "%s.%d.amp-fault-in", prefix, j);
  bad |= hal_pin_bit_newf(HAL_IN, &p->pos_lim_sw_in, component, "%s.%d.pos-lim-sw-in", prefix, j);
  bad |= hal_pin_bit_newf(HAL_IN, &p->neg_lim_sw_in, component, "%s.%d.neg-lim-sw-in", prefix, j);
  if (bad) return bad;
  *p->max_speed = 1000;
  *p->max_f_error = 1;
  return 0;
}

static int export_pins(void) {
  int j, bad = 0;
  for (j = 0; j < joints && !bad; ++j) bad = export_joint(j);
  if (bad) return bad;
#define PIN(type, direction, field, name) bad |= hal_pin_##type##_newf(direction, &pins->field, component, "kadr." name)
  PIN(bit, HAL_IN, emc_enable_in, "emc-enable-in");
  PIN(bit, HAL_OUT, motion_enabled, "motion-enabled");
  PIN(bit, HAL_OUT, in_position, "in-position");
  PIN(bit, HAL_IN, feed_hold, "feed-hold");
  PIN(bit, HAL_OUT, spindle_on, "spindle.0.on");
  PIN(bit, HAL_OUT, spindle_forward, "spindle.0.forward");
  PIN(bit, HAL_OUT, spindle_reverse, "spindle.0.reverse");
  PIN(bit, HAL_IN, spindle_at_speed, "spindle.0.at-speed");
  PIN(float, HAL_OUT, spindle_speed_out, "spindle.0.speed-out");
  PIN(float, HAL_IN, spindle_speed_in, "spindle.0.speed-in");
  PIN(bit, HAL_OUT, coolant_flood, "coolant-flood");
  PIN(bit, HAL_OUT, coolant_mist, "coolant-mist");
  PIN(bit, HAL_OUT, tool_change, "tool-change");
  PIN(bit, HAL_IN, tool_changed, "tool-changed");
  PIN(s32, HAL_OUT, tool_number, "tool-number");
  PIN(s32, HAL_OUT, program_line, "program-line");
  PIN(s32, HAL_OUT, state, "state");
  PIN(s32, HAL_OUT, fault, "fault");
  PIN(s32, HAL_OUT, fault_joint, "fault-joint");
  PIN(u32, HAL_OUT, sample, "sample");
  PIN(u32, HAL_OUT, starved, "starved");
  PIN(u32, HAL_OUT, leases_lost, "leases-lost");
  PIN(float, HAL_OUT, rate, "rate");
  PIN(float, HAL_IN, lease_time, "lease-time");
  PIN(float, HAL_IN, start_tolerance, "start-tolerance");
#undef PIN
  if (bad) return bad;
  *pins->spindle_at_speed = 1;
  *pins->lease_time = 1;
  *pins->start_tolerance = 0.01;
  return 0;
}

/* Creates the file of the ring. A file of that name that is left of an earlier run is replaced, so that no old program has access. */
static int create_ring(void) {
  int file;
  const char* c;
  for (c = ring; *c != 0; ++c)
    if (!((*c >= '0' && *c <= '9') || (*c >= 'A' && *c <= 'Z') || (*c >= 'a' && *c <= 'z') || *c == '-' || *c == '_')) return -EINVAL;
  if (c == ring || c - ring > 40) return -EINVAL;
  snprintf(path, sizeof path, "/dev/shm/kadr-%s", ring);
  unlink(path);
  file = open(path, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (file < 0) return -errno;
  if (ftruncate(file, sizeof *shared) == 0) shared = mmap(0, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_POPULATE, file, 0);
  else shared = MAP_FAILED;
  close(file);
  if (shared == MAP_FAILED) {
    shared = 0;
    unlink(path);
    return -ENOMEM;
  }
  shared->header.version = KADR_RING_VERSION;
  shared->header.size = sizeof *shared;
  shared->header.axes = (uint32_t)joints;
  __atomic_store_n(&shared->header.magic, KADR_RING_MAGIC, __ATOMIC_RELEASE);
  return 0;
}

static void remove_ring(void) {
  if (shared == 0) return;
  munmap(shared, sizeof *shared);
  shared = 0;
  unlink(path);
}

int rtapi_app_main(void) {
  int bad;
  if (joints < 1 || joints > KADR_AXES) {
    rtapi_print_msg(RTAPI_MSG_ERR, "kadr: joints=%d: 1 to %d are possible\n", joints, KADR_AXES);
    return -EINVAL;
  }
  component = hal_init("kadr");
  if (component < 0) return component;
  track.axes = joints;
  kadr_track_reset(&track);
  bad = create_ring();
  if (bad) rtapi_print_msg(RTAPI_MSG_ERR, "kadr: ring=%s: the file in /dev/shm cannot be created: %d\n", ring, bad);
  if (!bad) {
    pins = hal_malloc(sizeof *pins);
    bad = pins == 0 ? -ENOMEM : export_pins();
  }
  if (!bad) bad = hal_export_funct("kadr.period", period, 0, 1, 0, component);
  if (bad) {
    remove_ring();
    hal_exit(component);
    return bad;
  }
  hal_ready(component);
  return 0;
}

void rtapi_app_exit(void) {
  hal_exit(component);
  remove_ring();
}
