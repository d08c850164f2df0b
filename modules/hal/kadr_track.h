/* The motion of Kadr's HAL component along the samples: a position in a private copy of them, and a time scale.
 *
 * The position is sample `at` + `part`. In each servo period it advances by `rate`, 0 to 1, the share of the planned speed. Hold, starved,
 * lost lease, override and resume are all ramps of the rate:
 *
 *   rate(τ) = from + (to − from)·(10 τ³ − 15 τ⁴ + 6 τ⁵),  τ = periods since the start / duration of the ramp
 *
 * Acceleration and jerk of the axes stay within their limits because Kadr has tried the ramp before: `brake` of each sample is the duration
 * of a ramp from 1 to 0 that begins there. From a constant rate r the same ramp takes brake/r periods: it passes the same positions, with
 * r² times the acceleration and r³ times the jerk. A ramp from 1 to 0 of an even duration ends at a whole sample.
 *
 * A ramp is always completed. A hold in a ramp to a rate above 0 acts after it.
 *
 * Everything here is plain arithmetic on the caller's memory: no input, no output, no allocation, no clock.
 *
 * SPDX-License-Identifier: Apache-2.0 OR GPL-2.0-or-later
 */
#ifndef KADR_TRACK_H
#define KADR_TRACK_H

#include <string.h>

#include "kadr_ring.h"

/* Samples that the interpolation needs after the position, and one period of travel. */
#define KADR_MARGIN 4.0
/* The longest ramp that a sample may ask for, in periods: half of it, and the margin, must fit into the ring. */
#define KADR_LONGEST_BRAKE 6000u
/* Samples that are copied in one period at most. */
#define KADR_COPIES 32

struct kadr_ramp {
  double from, to, periods; /* periods 0: a constant rate `to` */
};

struct kadr_track {
  /* Set by the caller. */
  int axes;
  double reach[KADR_AXES]; /* greatest travel of an axis in a period */

  uint64_t head;      /* number of accepted samples */
  uint64_t last_wait; /* number of the last accepted sample with KADR_WAIT */
  uint64_t base_at;   /* the position at the start of the ramp */
  double base_part;
  struct kadr_ramp ramp;
  double elapsed; /* periods since the start of the ramp */
  uint64_t at;    /* the present position */
  double part, rate;
  int stands; /* not 0: at rest at a sample that may not be left */
  enum kadr_fault fault;
  int fault_axis;
  uint32_t starved;
  struct kadr_sample ring[KADR_SAMPLES];
};

/* What the outside requests in a period. */
struct kadr_wants {
  int stop;         /* not 0: hold, or the lease is lost */
  uint64_t release; /* see kadr_command */
};

static inline double kadr_rate(const struct kadr_ramp* ramp, double elapsed) {
  const double u = ramp->periods > 0 ? elapsed / ramp->periods : 1;
  if (u >= 1) return ramp->to;
  return ramp->from + (ramp->to - ramp->from) * u * u * u * (10 + u * (-15 + u * 6));
}

/* Returns the number of samples that a ramp passes in its first `elapsed` periods: the integral of the rate. */
static inline double kadr_passed(const struct kadr_ramp* ramp, double elapsed) {
  const double n = ramp->periods;
  if (elapsed >= n) return n * (ramp->from + ramp->to) / 2 + ramp->to * (elapsed - n);
  {
    const double u = elapsed / n;
    return n * (ramp->from * u + (ramp->to - ramp->from) * u * u * u * u * (2.5 + u * (-3 + u)));
  }
}

/* The weights of the four samples around a position, for the cubic polynomial through them. `part` is the fraction after the second. */
static inline void kadr_weights(double part, double weights[4]) {
  const double a = part + 1, b = part, c = part - 1, d = part - 2;
  weights[0] = b * c * d / -6;
  weights[1] = a * c * d / 2;
  weights[2] = a * b * d / -2;
  weights[3] = a * b * c / 6;
}

static inline const struct kadr_sample* kadr_sample_of(const struct kadr_track* t, uint64_t number) {
  return &t->ring[number % KADR_SAMPLES];
}

/* Empties the track. The axes are at rest. */
static inline void kadr_track_reset(struct kadr_track* t) {
  t->head = t->last_wait = t->base_at = t->at = 0;
  t->base_part = t->part = t->elapsed = 0;
  t->ramp.from = t->ramp.to = t->rate = 1;
  t->ramp.periods = 0;
  t->stands = 1;
  t->fault = KADR_NO_FAULT;
  t->fault_axis = 0;
}

static inline int kadr_fail(struct kadr_track* t, enum kadr_fault fault, int axis) {
  t->fault = fault;
  t->fault_axis = axis;
  return 0;
}

/* True for a number that is neither infinite nor NaN, whatever the compiler assumes of floating-point numbers. */
static inline int kadr_is_finite(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return (bits >> 52 & 0x7FF) != 0x7FF;
}

/* Appends a sample if it is plausible. Returns 0 if it is not, or if there is no space; `fault` tells which. */
static inline int kadr_track_take(struct kadr_track* t, const struct kadr_sample* sample) {
  int a;
  struct kadr_sample* const to = &t->ring[t->head % KADR_SAMPLES];
  const struct kadr_sample* const last = t->head > 0 ? kadr_sample_of(t, t->head - 1) : 0;
  if (t->fault != KADR_NO_FAULT || (t->head > t->at && t->head - t->at > KADR_SAMPLES - 8)) return 0;
  memcpy(to, sample, sizeof *to);
  if ((to->flags & ~(unsigned)KADR_FLAGS) != 0 || to->brake > KADR_LONGEST_BRAKE || !kadr_is_finite((double)to->spindle))
    return kadr_fail(t, KADR_BAD_SAMPLE, 0);
  if ((to->flags & KADR_WAIT) == 0 && (last == 0 || (to->flags & (KADR_END | KADR_CHANGE_TOOL)) != 0))
    return kadr_fail(t, KADR_BAD_SAMPLE, 0);
  for (a = 0; a < t->axes; ++a) {
    if (!kadr_is_finite(to->position[a])) return kadr_fail(t, KADR_BAD_SAMPLE, a);
    if (last != 0) {
      const double travel = to->position[a] - last->position[a];
      if (!(travel <= t->reach[a] && travel >= -t->reach[a])) return kadr_fail(t, KADR_TOO_FAR, a);
    }
  }
  if ((to->flags & KADR_WAIT) != 0) t->last_wait = t->head;
  ++t->head;
  return 1;
}

/* Returns the number of samples after the position at + part. */
static inline double kadr_ahead(const struct kadr_track* t, uint64_t at, double part) {
  return t->head > at ? (double)(t->head - 1 - at) - part : 0;
}

/* Returns the duration of the ramp from a rate of 1 to rest that begins at this position. */
static inline double kadr_brake_at(const struct kadr_track* t, uint64_t at, double part) {
  double first = kadr_sample_of(t, at)->brake, next;
  if (part > 0 && at + 1 < t->head) {
    next = kadr_sample_of(t, at + 1)->brake;
    if (next > first) first = next;
  }
  return first;
}

/* True if the axes can stop from the position `at` + `part`: at a sample with KADR_WAIT, or by braking. */
static inline int kadr_is_provided(const struct kadr_track* t, uint64_t at, double part) {
  if (at + (part > 0) <= t->last_wait) return 1;
  if (at + 1 >= t->head) return 0;
  return kadr_ahead(t, at, part) >= kadr_brake_at(t, at, part) / 2 + KADR_MARGIN;
}

/* The same for the position that lies `further` samples after the sample `at`. */
static inline int kadr_is_provided_after(const struct kadr_track* t, uint64_t at, double further) {
  return kadr_is_provided(t, at + (uint64_t)further, further - (double)(uint64_t)further);
}

static inline void kadr_begin_ramp(struct kadr_track* t, double to, double periods) {
  t->base_at = t->at;
  t->base_part = t->part;
  t->ramp.from = t->stands ? to : t->rate;
  t->ramp.to = to;
  t->ramp.periods = t->stands ? 0 : periods;
  t->elapsed = 0;
  t->rate = t->ramp.from;
}

static inline int kadr_in_ramp(const struct kadr_track* t) { return t->elapsed < t->ramp.periods; }

/* Requests a ramp to a rate above 0, which the caller has tried from this position. Returns 1 if it begins, 0 if not: another ramp is not
 * complete, a number is wrong, or the samples do not suffice to brake after it. */
static inline int kadr_track_ramp(struct kadr_track* t, double to, double periods) {
  if (!(to >= 0.01 && to <= 1 && periods >= 2 && periods <= 1e6)) return 0;
  if (kadr_in_ramp(t) || t->head == 0 || t->fault != KADR_NO_FAULT) return 0;
  if (!t->stands && t->at + (t->part > 0) > t->last_wait && !kadr_is_provided_after(t, t->at, t->part + periods * (t->rate + to) / 2 + 1))
    return 0;
  kadr_begin_ramp(t, to, periods);
  return 1;
}

/* Brakes where something demands it, and the rate is constant and above 0. */
static inline void kadr_brake_if_needed(struct kadr_track* t, const struct kadr_wants* wants) {
  int starves;
  if (kadr_in_ramp(t) || t->rate <= 0) return;
  starves = !t->stands && !kadr_is_provided_after(t, t->at, t->part + t->rate);
  if (!wants->stop && t->fault == KADR_NO_FAULT && !starves) return;
  if (starves) ++t->starved;
  kadr_begin_ramp(t, 0, kadr_brake_at(t, t->at, t->part) / t->rate);
}

/* Stops at sample `number`, at which the axes are at rest by the plan, or which is the last one. */
static inline void kadr_stand_at(struct kadr_track* t, uint64_t number) {
  t->at = t->base_at = number;
  t->part = t->base_part = 0;
  if ((kadr_sample_of(t, number)->flags & KADR_WAIT) == 0) t->ramp.to = 0;
  t->ramp.from = t->rate = t->ramp.to;
  t->ramp.periods = t->elapsed = 0;
  t->stands = 1;
}

/* True if the axes could brake in time after the ramp that is not complete. */
static inline int kadr_is_ramp_provided(const struct kadr_track* t) {
  return !kadr_in_ramp(t) || kadr_is_provided_after(t, t->base_at, t->base_part + kadr_passed(&t->ramp, t->ramp.periods) + t->ramp.to);
}

/* True if sample `number` may not be left. */
static inline int kadr_is_barrier(const struct kadr_track* t, uint64_t number, uint64_t release) {
  if (number + 1 >= t->head) return 1;
  return (kadr_sample_of(t, number)->flags & KADR_WAIT) != 0 &&
         (number >= release || !kadr_is_provided(t, number + 1, 0) || !kadr_is_ramp_provided(t));
}

/* Advances by one servo period. */
static inline void kadr_track_step(struct kadr_track* t, const struct kadr_wants* wants) {
  double s;
  uint64_t whole, next;
  if (t->head == 0) return;
  kadr_brake_if_needed(t, wants);
  if (t->rate <= 0 && !kadr_in_ramp(t)) return;
  if (t->stands && kadr_is_barrier(t, t->at, wants->release)) return;
  t->stands = 0;
  t->elapsed += 1;
  s = t->base_part + kadr_passed(&t->ramp, t->elapsed);
  t->rate = kadr_rate(&t->ramp, t->elapsed);
  whole = (uint64_t)s;
  next = t->at + 1;
  if (t->base_at + whole >= next && kadr_is_barrier(t, next, wants->release)) {
    if ((kadr_sample_of(t, next)->flags & KADR_WAIT) == 0) kadr_fail(t, KADR_RAN_DRY, 0);
    kadr_stand_at(t, next);
    return;
  }
  t->at = t->base_at + whole;
  t->part = s - (double)whole;
  if (kadr_in_ramp(t)) return;
  /* A constant rate begins here. */
  t->base_at = t->at;
  t->base_part = t->part;
  t->ramp.from = t->ramp.to;
  t->ramp.periods = t->elapsed = 0;
  t->rate = t->ramp.to;
}

/* Writes the position of each axis. Before the first sample nothing is written. */
static inline void kadr_track_position(const struct kadr_track* t, double* position) {
  double weights[4];
  int a, k;
  const struct kadr_sample* around[4];
  if (t->head == 0) return;
  if (t->part <= 0) {
    memcpy(position, kadr_sample_of(t, t->at)->position, (size_t)t->axes * sizeof *position);
    return;
  }
  kadr_weights(t->part, weights);
  for (k = 0; k < 4; ++k) {
    /* Before the first and after the last sample the axes are at rest. */
    uint64_t number = t->at + (uint64_t)k;
    number = number > 0 ? number - 1 : 0;
    around[k] = kadr_sample_of(t, number + 1 > t->head ? t->head - 1 : number);
  }
  for (a = 0; a < t->axes; ++a) {
    /* The sum is taken from the second sample, so that equal positions give exactly this position. */
    const double at = around[1]->position[a];
    position[a] = at + (weights[0] * (around[0]->position[a] - at) +
                        (weights[2] * (around[2]->position[a] - at) + weights[3] * (around[3]->position[a] - at)));
  }
}

/* Returns what the track does, as kadr_state. */
static inline enum kadr_state kadr_track_state(const struct kadr_track* t) {
  if (t->head == 0) return KADR_EMPTY;
  if (t->rate <= 0 && !kadr_in_ramp(t)) return t->fault != KADR_NO_FAULT ? KADR_FAULT : KADR_HELD;
  if (t->stands && (kadr_sample_of(t, t->at)->flags & KADR_END) != 0) return KADR_ENDED;
  if (t->stands) return KADR_WAITING;
  return t->ramp.to <= 0 ? KADR_BRAKING : KADR_RUNNING;
}

#endif
