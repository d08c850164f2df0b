"""LinuxCNC's stand-alone interpreter as an oracle: runs a program in `rs274` (Debian's linuxcnc-uspace) and returns the actions as in a
golden case.

Three changes are made around the interpreter, none in it. A constant of the executable makes its stub of the machine report that a user
unit is an inch; a copy with the constant 1 is a machine in mm (tool table and parameter file are then in mm). Another constant says that
there are six axes; a copy has nine, for programs with U V W. A preloaded library prints nine decimals instead of the stub's four, and
before a call with U V W, which the stub does not print, a line ALSO_UVW with them. The stub does not know some things, so no test may
depend on them: tool length and rotation where the interpreter requests the position (after M6, M61, M66, G38.n), where a probe touches,
inputs.
"""
import math
import os
import re
import shutil
import struct
import subprocess
import tempfile
from pathlib import Path

PROGRAM = os.environ.get('KADR_RS274', '/usr/bin/rs274')
USER_UNIT = struct.pack('<d', 0.03937007874016)     # user units per mm in the stub
SIX_AXES, NINE_AXES = b'\xb8\x3f\x00\x00\x00\xc3', b'\xb8\xff\x01\x00\x00\xc3'     # return 0x3f, 0x1ff: a bit an axis
CANONICAL = re.compile(r' *\d+ N[0-9.]* *([A-Z_.0-9]+)\((.*)\)$')
AXES = 'XYZABCUVW'
PLANES = {'XY': ('XY', 'Z'), 'XZ': ('ZX', 'Y'), 'YZ': ('YZ', 'X')}
KINDS = {'spindle', 'dwell', 'message', 'coolant', 'tool', 'speed', 'stop', 'm'}
SHIM = r'''
#define _GNU_SOURCE
#include <dlfcn.h>
#include <elf.h>
#include <link.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>
static int out(FILE* f, const char* fmt, va_list ap) {
  char b[4096];
  size_t n = 0;
  for (const char* p = fmt; *p && n < sizeof b - 5;) {
    if (!strncmp(p, "%.4f", 4)) { memcpy(b + n, "%.9f", 4); n += 4; p += 4; }
    else if (!strncmp(p, "%f", 2)) { memcpy(b + n, "%.9f", 4); n += 4; p += 2; }
    else b[n++] = *p++;
  }
  b[n] = 0;
  return vfprintf(f, b, ap);
}
int fprintf(FILE* f, const char* fmt, ...) { va_list ap; va_start(ap, fmt); int r = out(f, fmt, ap); va_end(ap); return r; }
int __fprintf_chk(FILE* f, int flag, const char* fmt, ...) {
  (void)flag;
  va_list ap;
  va_start(ap, fmt);
  int r = out(f, fmt, ap);
  va_end(ap);
  return r;
}
typedef double d;
static void also(d u, d v, d w) { if (u || v || w) printf("    0 N..... ALSO_UVW(%.9f, %.9f, %.9f)\n", u, v, w); }
#define NINE d x, d y, d z, d a, d b, d c, d u, d v, d w
#define GIVEN x, y, z, a, b, c, u, v, w
static void (*feed)(int, NINE), (*rapid)(int, NINE), (*system_at)(int, NINE), (*shift)(NINE), (*probe)(int, NINE, unsigned char);
static void (*arc)(int, d, d, d, d, int, d, d, d, d, d, d, d);
static void my_feed(int n, NINE) { also(u, v, w); feed(n, GIVEN); }
static void my_rapid(int n, NINE) { also(u, v, w); rapid(n, GIVEN); }
static void my_system(int n, NINE) { also(u, v, w); system_at(n, GIVEN); }
static void my_shift(NINE) { also(u, v, w); shift(GIVEN); }
static void my_probe(int n, NINE, unsigned char t) { also(u, v, w); probe(n, GIVEN, t); }
static void my_arc(int n, d p, d q, d r, d s, int t, d e, d a, d b, d c, d u, d v, d w) { also(u, v, w); arc(n, p, q, r, s, t, e, a, b, c, u, v, w); }
static struct { const char* name; void* mine; void** theirs; } calls[] = {
    {"_Z13STRAIGHT_FEEDiddddddddd", (void*)my_feed, (void**)&feed},       {"_Z17STRAIGHT_TRAVERSEiddddddddd", (void*)my_rapid, (void**)&rapid},
    {"_Z14SET_G5X_OFFSETiddddddddd", (void*)my_system, (void**)&system_at}, {"_Z14SET_G92_OFFSETddddddddd", (void*)my_shift, (void**)&shift},
    {"_Z14STRAIGHT_PROBEidddddddddh", (void*)my_probe, (void**)&probe},   {"_Z8ARC_FEEDiddddiddddddd", (void*)my_arc, (void**)&arc}};
static int of_library(struct dl_phdr_info* info, size_t size, void* given) {  /* the interpreter's calls of the stub go through its table */
  (void)size, (void)given;
  if (!strstr(info->dlpi_name, "librs274")) return 0;
  const ElfW(Dyn)* dyn = 0;
  for (int i = 0; i < info->dlpi_phnum; ++i)
    if (info->dlpi_phdr[i].p_type == PT_DYNAMIC) dyn = (void*)(info->dlpi_addr + info->dlpi_phdr[i].p_vaddr);
  const ElfW(Sym)* symbols = 0;
  const char* names = 0;
  const ElfW(Rela)* tables[2] = {0, 0};
  size_t sizes[2] = {0, 0};
  for (; dyn && dyn->d_tag != DT_NULL; ++dyn) {
    if (dyn->d_tag == DT_SYMTAB) symbols = (void*)dyn->d_un.d_ptr;
    if (dyn->d_tag == DT_STRTAB) names = (void*)dyn->d_un.d_ptr;
    if (dyn->d_tag == DT_JMPREL) tables[0] = (void*)dyn->d_un.d_ptr;
    if (dyn->d_tag == DT_PLTRELSZ) sizes[0] = dyn->d_un.d_val;
    if (dyn->d_tag == DT_RELA) tables[1] = (void*)dyn->d_un.d_ptr;
    if (dyn->d_tag == DT_RELASZ) sizes[1] = dyn->d_un.d_val;
  }
  for (int t = 0; t < 2; ++t)
    for (size_t i = 0; i < sizes[t] / sizeof(ElfW(Rela)); ++i)
      for (size_t n = 0; n < sizeof calls / sizeof *calls; ++n) {
        if (strcmp(names + symbols[ELF64_R_SYM(tables[t][i].r_info)].st_name, calls[n].name)) continue;
        void** at = (void**)(info->dlpi_addr + tables[t][i].r_offset);
        const size_t page = (size_t)sysconf(_SC_PAGESIZE);
        mprotect((void*)((size_t)at / page * page), page, PROT_READ | PROT_WRITE);
        *calls[n].theirs = dlsym(RTLD_DEFAULT, calls[n].name);
        *at = calls[n].mine;
      }
  return 1;
}
__attribute__((constructor)) static void begin(void) { dl_iterate_phdr(of_library, 0); }
'''


class Absent(Exception):
    """This machine has no oracle; the text states what is missing."""


class Oracle:
    """`folder`: where the oracle's copy is created; it must exist as long as the oracle is used."""

    def __init__(self, folder):
        if not os.path.exists(PROGRAM):
            raise Absent('rs274 is not here (Debian package linuxcnc-uspace)')
        compiler = shutil.which('gcc') or shutil.which('cc')
        if compiler is None:
            raise Absent('no C compiler')
        self.program, self.shim = Path(folder, 'rs274mm'), Path(folder, 'decimals.so')
        data = Path(PROGRAM).read_bytes()
        if data.count(USER_UNIT) != 1:
            raise Absent(f'{PROGRAM} is not the version that is known here')
        if data.count(SIX_AXES) != 1:
            raise Absent(f'{PROGRAM} does not say its axes as is known here')
        metric = data.replace(USER_UNIT, struct.pack('<d', 1.0))
        self.nine_axes = Path(folder, 'rs274uvw')
        for path, made in ((self.program, metric), (self.nine_axes, metric.replace(SIX_AXES, NINE_AXES))):
            path.write_bytes(made)
            path.chmod(0o755)
        source = Path(folder, 'decimals.c')
        source.write_text(SHIM)
        subprocess.run([compiler, '-shared', '-fPIC', '-O1', '-o', self.shim, source], check=True)

    def run(self, folder, name, seconds=10, axes='XYZABC'):
        """Runs the file `name` of the folder, which contains tool.tbl and p.var; returns (canonical lines, text of the alarm or None)."""
        program = self.nine_axes if 'U' in axes else self.program
        with tempfile.TemporaryDirectory(prefix='rs274home') as home:   # a separate home: the tool table is a shared file ~/.tool.mmap
            done = subprocess.run([str(program), '-t', 'tool.tbl', '-v', 'p.var', '-g', name], cwd=folder, capture_output=True,
                                  timeout=seconds, stdin=subprocess.DEVNULL,
                                  env={**os.environ, 'HOME': home, 'LD_PRELOAD': str(self.shim), 'LC_ALL': 'C'})
        noise = ('executing', 'link (', 'PYTHON:', 'ModuleNotFoundError:')  # the last two come from a build without Python
        said = [line for line in done.stderr.decode('latin-1').splitlines() if line and not line.startswith(noise)]
        lines = done.stdout.decode('latin-1').splitlines()
        return lines, None if done.returncode == 0 else said[0] if said else 'ended without a word'


def number(value):
    value = round(value, 6)
    return int(value) if value == int(value) else value


class Converter:
    """Converts canonical calls to actions (tests/golden/README.md): motions and the types named."""

    def __init__(self, kinds=frozenset(KINDS)):
        self.kinds, self.actions = kinds, []
        self.here = dict.fromkeys(AXES, 0.0)             # work position in mm
        self.factor, self.plane, self.feed, self.per_rev, self.lead = 1.0, 'XY', 0.0, False, None
        self.g92, self.g5x, self.length = (dict.fromkeys(AXES, 0.0) for _ in range(3))
        self.rotation, self.speed, self.tool = 0.0, 0.0, 0
        self.inverse = self.turning = self.changing = self.spline_open = False
        self.used = set()
        self.uvw = [0.0, 0.0, 0.0]                       # for the next call

    def all(self, lines):
        last = max((i for i, line in enumerate(lines) if 'SET_FEED_MODE' in line), default=-1)
        ends = any('PROGRAM_END()' in line for line in lines)
        for i, line in enumerate(lines):
            self.ending = i == last and ends
            self.line(line)
        return self.actions

    def line(self, text):
        found = CANONICAL.match(text)
        if found:
            self.call(found[1], found[2])
        elif text:
            self.add('message', text=text.strip())       # (PRINT, …)

    def add(self, kind, **fields):
        group = {'toolchange': 'tool', 'optional_stop': 'stop'}.get(kind, kind)
        if group in self.kinds:
            self.actions.append({'do': kind, **fields})

    def motion(self, do, target, length=None, **fields):
        to = {a: number(v) for a, v in target.items() if a in 'XYZ' or a in self.used or abs(v) > 1e-9}
        self.used |= {a for a in to if a not in 'XYZ'}
        action = {'do': do, 'to': to, **fields}
        moves = any(abs(target[a] - self.here[a]) > 1e-9 for a in 'XYZUVW')
        if self.spline_open:
            self.spline_open, moves = False, True        # its start is not printed
        if do in ('rapid', 'feed') and not moves and all(abs(target[a] - self.here[a]) <= 1e-9 for a in 'ABC'):
            return                                       # a motion without length: a trace may leave it out
        if do.startswith('arc') or (do == 'feed' and moves):
            if self.inverse:
                length = length or self.way(target, 'XYZ') or self.way(target, 'UVW')
                action.update(feed=number(self.feed / length), unit='1/min')
            else:
                action.update(feed=number(self.feed), unit='mm/rev' if self.per_rev else 'mm/min')
        self.actions.append(action)
        self.here = dict(target)

    def way(self, target, axes):
        way = math.dist([target[a] for a in axes], [self.here[a] for a in axes])
        return way if way > 1e-7 else 0

    def frame(self):
        return dict(self.g5x), dict(self.g92), self.rotation, dict(self.length)

    def change_frame(self, change):
        """The work position changes with the frame; the machine does not move."""
        g5x, g92, rotation, length = self.frame()
        p = {a: self.here[a] + g92[a] for a in AXES}
        turn(p, rotation)
        machine = {a: p[a] + g5x[a] + length[a] for a in AXES}
        change()
        p = {a: machine[a] - self.g5x[a] - self.length[a] for a in AXES}
        turn(p, -self.rotation)
        self.here = {a: p[a] - self.g92[a] for a in AXES}

    def lengths(self, values):
        return dict(zip(AXES, [v * self.factor for v in values[:3]] + values[3:6] + [v * self.factor for v in values[6:9] or self.uvw]))

    def call(self, name, inside):
        args = [float(v) for v in re.findall(r'-?\d+(?:\.\d+)?(?:e[-+]\d+)?|-?nan|-?inf', inside)] if '"' not in inside else []
        handler = getattr(self, 'on_' + name.lower(), None)
        if handler is not None:
            handler(args, inside)
        if name != 'ALSO_UVW':
            self.uvw = [0.0, 0.0, 0.0]

    def on_also_uvw(self, args, _):
        self.uvw = args

    # ---- motions
    def on_straight_traverse(self, args, _):
        self.motion('rapid', self.lengths(args))

    def on_straight_feed(self, args, _):
        if self.lead is None:
            self.motion('feed', self.lengths(args))
        else:
            self.motion('thread', self.lengths(args), lead=number(self.lead * self.factor))

    def on_straight_probe(self, args, _):
        self.motion('probe', self.lengths(args))

    def on_rigid_tap(self, args, _):
        there, back = {**self.here, **dict(zip('XYZ', [v * self.factor for v in args[:3]]))}, dict(self.here)
        for target in (there, back):
            self.motion('thread', target, lead=number(self.lead * self.factor))

    def on_arc_feed(self, args, _):
        (first, second), third = PLANES[self.plane]
        end1, end2, c1, c2 = (v * self.factor for v in args[:4])
        sense, end3 = int(args[4]), args[5] * self.factor
        x1, y1 = self.here[first] - c1, self.here[second] - c2
        swept = math.atan2(end2 - c2, end1 - c1) - math.atan2(y1, x1)
        swept = swept if sense > 0 else -swept
        while swept <= 1e-9:
            swept += 2 * math.pi
        swept += (abs(sense) - 1) * 2 * math.pi
        length = math.hypot(math.hypot(x1, y1) * swept, end3 - self.here[third])
        target = {**self.lengths([0.0] * 3 + args[6:9]), first: end1, second: end2, third: end3}
        self.motion('arc_ccw' if sense > 0 else 'arc_cw', target, length, center={first: number(c1), second: number(c2)},
                    plane=first + second, turns=number(swept / 2 / math.pi))

    def on_nurbs_feed(self, args, _):
        self.actions.append({'do': 'spline'})             # the next motion shows where it ends
        self.spline_open = True

    # ---- frames
    def on_use_length_units(self, _, inside):
        self.factor = 25.4 if 'INCHES' in inside else 1.0

    def on_select_plane(self, _, inside):
        self.plane = inside[-2:]

    def on_set_g5x_offset(self, args, _):
        self.change_frame(lambda: self.g5x.update(self.lengths(args[1:])))

    def on_set_g92_offset(self, args, _):
        self.change_frame(lambda: self.g92.update(self.lengths(args)))

    def on_use_tool_length_offset(self, args, _):
        self.change_frame(lambda: self.length.update(self.lengths(args)))

    def on_set_xy_rotation(self, args, _):
        self.change_frame(lambda: setattr(self, 'rotation', args[0]))

    # ---- feed, spindle
    def on_set_feed_rate(self, args, _):
        self.feed = args[0] * self.factor

    def on_set_feed_mode(self, args, _):
        self.per_rev = args[1] == 1
        self.changing = self.ending

    def on_start_speed_feed_sync(self, args, _):
        self.lead = args[0]

    def on_stop_speed_feed_synch(self, _args, _):
        self.lead = None

    def on_comment(self, _, inside):
        if 'feed mode set to' in inside:
            self.inverse = 'inverse time' in inside

    def on_set_spindle_speed(self, args, _):
        self.speed = args[1]

    def on_start_spindle_clockwise(self, *_):
        self.start('cw')

    def on_start_spindle_counterclockwise(self, *_):
        self.start('ccw')

    def start(self, sense):
        self.turning = True
        self.add('spindle', dir=sense, rpm=number(self.speed))

    def on_stop_spindle_turning(self, *_):
        if self.turning:                                  # M6 and M2 stop it by themselves: the trace may show that
            self.add('spindle', dir='stop', **({'optional': True} if self.changing else {}))
        self.turning = False

    def on_orient_spindle(self, args, _):
        self.add('spindle', dir='orient', angle=number(args[1]))

    # ---- other calls
    def on_dwell(self, args, _):
        self.add('dwell', seconds=number(args[0]))

    def on_message(self, _, inside):
        self.add('message', text=inside.strip('"').strip())

    def on_select_tool(self, args, _):
        self.tool = int(args[0])
        self.add('tool', tool=self.tool)

    def on_start_change(self, *_):
        self.changing = True

    def on_change_tool(self, *_):
        self.changing = False
        self.add('toolchange', tool=self.tool)

    def on_mist_on(self, *_):
        self.add('coolant', code='M7')

    def on_flood_on(self, *_):
        self.add('coolant', code='M8')

    def on_mist_off(self, *_):                            # M2 calls this when mist is on
        self.add('coolant', code='M9', **({'optional': True} if self.changing else {}))

    def on_program_stop(self, *_):
        self.add('stop')

    def on_optional_program_stop(self, *_):
        self.add('optional_stop')

    def on_set_motion_output_bit(self, args, _):
        self.add('m', code='M62', number=int(args[0]))

    def on_clear_motion_output_bit(self, args, _):
        self.add('m', code='M63', number=int(args[0]))

    def on_set_aux_output_bit(self, args, _):
        self.add('m', code='M64', number=int(args[0]))

    def on_clear_aux_output_bit(self, args, _):
        self.add('m', code='M65', number=int(args[0]))

    def on_set_motion_output_value(self, args, _):
        self.add('m', code='M67', number=int(args[0]), value=number(args[1]))

    def on_set_aux_output_value(self, args, _):
        self.add('m', code='M68', number=int(args[0]), value=number(args[1]))


def turn(p, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    p['X'], p['Y'] = p['X'] * c - p['Y'] * s, p['X'] * s + p['Y'] * c
