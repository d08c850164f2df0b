/* The shared memory between Kadr and its HAL component: a file of this layout in /dev/shm. The component creates the file, Kadr opens it.
 * The header is valid C99 and C++. It includes nothing of LinuxCNC and nothing of Kadr.
 *
 *   Kadr ── samples, head, lease, hold, release, ramp ──▶ kadr_command, sample[] ──▶ component
 *   Kadr ◀── state, position ── kadr_status, written in each servo period ◀────────── component
 *
 * A sample is the position of all axes at one servo instant. Samples are numbered from 0 in each generation; sample n is in
 * sample[n % KADR_SAMPLES]. Lengths are in mm, angles in degrees. All numbers are in the byte order of the computer.
 *
 * The component trusts nothing in this memory: it copies each sample and checks the copy (kadr_track.h).
 *
 * SPDX-License-Identifier: Apache-2.0 OR GPL-2.0-or-later
 */
#ifndef KADR_RING_H
#define KADR_RING_H

#include <stdint.h>

#define KADR_RING_MAGIC 0x474E495252444B41ULL
#define KADR_RING_VERSION 1u
#define KADR_AXES 9
#define KADR_SAMPLES 4096u
#define KADR_HEAD_BITS 40

/* Flags of a sample. */
enum kadr_flag {
  /* By the plan the axes are at rest here. The component stands until kadr_command.release is greater than the number of the sample, and
   * enough samples follow. The first sample has this flag. */
  KADR_WAIT = 1,
  KADR_END = 2,          /* end of the program; with KADR_WAIT */
  KADR_FLOOD = 4,        /* flood coolant is on */
  KADR_MIST = 8,         /* mist coolant is on */
  KADR_CHANGE_TOOL = 16, /* a change to the tool `tool` is requested; with KADR_WAIT */
  KADR_FLAGS = 31
};

struct kadr_sample {
  double position[KADR_AXES]; /* machine coordinates */
  float spindle;              /* speed of the spindle, rev/min; below 0: counterclockwise; 0: off */
  uint32_t line, pass;        /* line of the program and its pass; 0: none */
  uint16_t file;              /* number of the file of the line; 0: the program */
  uint16_t brake;             /* even number of periods of the shortest ramp from this sample to rest, see kadr_track.h */
  uint16_t flags;             /* kadr_flag */
  uint16_t tool;              /* tool in the spindle; with KADR_CHANGE_TOOL the tool to be changed to */
  uint32_t reserved;
};

/* Written by Kadr alone. Each field is stored atomically; what a field refers to is stored before it. */
struct kadr_command {
  /* Number of samples that are written, in the lower KADR_HEAD_BITS bits, and above them the number of the generation, from 1. A new
   * generation discards the samples before; it may begin only while the axes are at rest. */
  uint64_t head;
  uint64_t beat;       /* the lease: Kadr changes it often; if it does not change for the lease time, the component brakes */
  uint64_t release;    /* samples with KADR_WAIT and a number below this may be left */
  uint32_t hold;       /* not 0: brake, and stand */
  uint32_t ramp;       /* number of the request below; stored after it. A new number is a new request */
  uint64_t ramp_at;    /* the ramp begins at the period in which the position is nearest to sample ramp_at + ramp_part */
  double ramp_part;    /* 0 to 1 */
  double ramp_to;      /* share of the planned speed at the end of the ramp, 0.01 to 1 */
  double ramp_periods; /* duration of the ramp in servo periods */
};

enum kadr_state {
  KADR_OFF = 0,     /* not enabled: the position command follows the feedback */
  KADR_EMPTY = 1,   /* enabled, no samples */
  KADR_RUNNING = 2, /* at a constant share of the planned speed, or on the way to one above 0 */
  KADR_BRAKING = 3,
  KADR_HELD = 4,    /* at rest at a share of 0; only a ramp goes on */
  KADR_WAITING = 5, /* at rest at a sample with KADR_WAIT */
  KADR_ENDED = 6,   /* at rest at the sample with KADR_END */
  KADR_FAULT = 7    /* at rest, samples are not accepted until the component was disabled */
};

enum kadr_fault {
  KADR_NO_FAULT = 0,
  KADR_BAD_HEAD = 1,     /* the number of samples went back, or grew by more than the ring has */
  KADR_BAD_SAMPLE = 2,   /* a number is not finite, a flag is unknown, a ramp is longer than the ring */
  KADR_TOO_FAR = 3,      /* a sample is further from the one before than the axis can travel in a period */
  KADR_BAD_START = 4,    /* the first sample is not at the position of the axis */
  KADR_RAN_DRY = 5,      /* the samples ended in motion, and the axes stopped at once; it cannot happen if each `brake` is right */
  KADR_FOLLOWING = 6,    /* the following error was too great */
  KADR_DRIVE = 7,        /* amp-fault-in of a joint */
  KADR_LIMIT_SWITCH = 8, /* a limit switch of a joint */
  KADR_FAULTS = 9
};

/* Written by the component alone. `sequence` is odd while it writes; a reader repeats until it is even and the same before and after. */
struct kadr_status {
  uint64_t sequence;
  uint64_t ticks;      /* number of servo periods since the component was loaded */
  uint64_t generation; /* of the accepted samples */
  uint64_t taken;      /* number of samples that the component has copied and accepted; their places in the ring are free */
  uint64_t at;         /* the position lies between the samples `at` and at + 1 … */
  double part;         /* … at this fraction */
  double rate;         /* share of the planned speed, 0 to 1 */
  double position[KADR_AXES];
  double feedback[KADR_AXES];
  double spindle_feedback; /* rev/min */
  uint32_t state;          /* kadr_state */
  uint32_t fault;          /* kadr_fault */
  uint32_t fault_axis;     /* axis of the fault, from 0 */
  uint32_t ramp;           /* number of the last request for a ramp that was executed or refused */
  uint32_t ramp_refused;   /* not 0: it was refused */
  uint32_t starved;        /* how often the component has braked because the samples came too late */
  uint32_t leases_lost;    /* how often it has braked because the lease ended */
  uint32_t at_speed;       /* not 0: the spindle is at its speed */
  uint32_t tool_changed;   /* not 0: the requested tool change is done */
  uint32_t reserved;
};

/* Written once, when the component is loaded. `magic` is stored last. */
struct kadr_header {
  uint64_t magic;
  uint32_t version, size;  /* KADR_RING_VERSION, sizeof(struct kadr_ring) */
  uint32_t axes;           /* number of joints, 1 to KADR_AXES */
  uint32_t period_ns;      /* servo period; 0: the thread has not run yet */
  double speed[KADR_AXES]; /* greatest speed of each joint that the component accepts, per second */
};

struct kadr_ring {
  struct kadr_header header;
  struct kadr_command command;
  struct kadr_status status;
  struct kadr_sample sample[KADR_SAMPLES];
};

#endif
