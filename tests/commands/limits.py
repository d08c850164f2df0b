"""Runs every command where a resource is short: threads, memory, open files, disk space, a reader, time. Used by tests/every_command.py.

Each function of LIMITS yields pairs of the checked subject and its faults; each has a folder of its own."""
import itertools
import os
import resource
import shutil
import signal
import subprocess
import tempfile
from pathlib import Path

import harness
from commands.observed import STATUSES, text
from commands.programs import CUT, EXAMPLES, TOOLS

SHORT_OF = {   # a few programs with canned cycles, subprograms, macros, Russian letters; and a tape
    'mach3/bolt_circle.tap': 'mach3', 's2c42/flange.nc': 's2c42', 'fanuc/flange_taps.nc': 'fanuc', 'haas/local_subprogram.nc': 'haas', 's2c42/flange.tape': 's2c42'}
CUT_MORE = ('--stock', 'box:-60,-60,-20,60,60,0', '--resolution', '1', '--threads', '8')   # added to `cut` for every machine
ENDLESS = 'F1000\nG1 X#1\n#1=[1-#1]\nM99\n'   # mach3
FOR_EVER = ('--max-passes', '1000000000', '--max-blocks', '1000000000000')
MOST_S = 2.0                # s of processor time after a signal
MOST_READ = 128 << 20       # bytes of address space, for a program that never ends
NOBODY = {'user': 65534, 'group': 65534, 'extra_groups': []}
OLD = b'old\n'


def works(program, control, tools):
    """Returns command → its arguments and outputs, as many as the command can have."""
    words = ['--control', control]
    return {
        'run': (['run', program, *words, '--trace', 't.jsonl', '--plot', 'p.svg', '--samples', 's.csv', '--max-time', '2'], ('t.jsonl', 'p.svg', 's.csv')),
        'check': (['check', program, *words, '--format', 'json', '--output', 'f.json'], ('f.json',)),
        'cut': (['cut', program, *words, *CUT_MORE, '--tools', tools, '--out', 'x.stl', '--json', 'c.json', '--blocks', 'b.csv', '--plot', 'k.svg'],
                ('x.stl', 'c.json', 'b.csv', 'k.svg')),
        'report': (['report', program, *words, '--out', 'r.html'], ('r.html',)),
        'convert': (['convert', program, '--from', control, '--to', 'nct', '--out', 'n.nc', '--setup-out', 'n.json'], ('n.nc', 'n.json')),
        'diff': (['diff', program, program, *words, '--plot', 'd.svg'], ('d.svg',)),
        'setup': (['setup', program, *words, '--out', 'u.json'], ('u.json',)),
        'debug': (['debug', program, *words, '--trace', 'g.jsonl'], ('g.jsonl',)),
        'tape': (['tape', 'encode', program, 'x.tape'], ('x.tape',)),
    }


def of_each(kadr, most=len(SHORT_OF)):
    """Yields (command, program, words, outputs); the programs are in a sibling folder of the outputs."""
    inputs, kadr.folder = kadr.folder / 'inputs', kadr.folder / 'work'
    for folder in (inputs, kadr.folder):
        folder.mkdir()
        folder.chmod(0o755)
    Path(shutil.copy(EXAMPLES / 'cut/tools.toml', inputs)).chmod(0o644)
    for program, control in list(SHORT_OF.items())[:most]:
        copy = Path(shutil.copy(EXAMPLES / program, inputs))
        copy.chmod(0o644)
        for command, (words, outputs) in works(copy, control, inputs / 'tools.toml').items():
            if command not in ('tape', 'debug') or Path(program).suffix != '.tape':
                yield command, program, words, outputs
                clear(kadr.folder)


def clear(folder):
    for path in folder.iterdir():
        path.unlink()


def no_threads(kadr):
    """Runs as a user who may start no more processes."""
    root = os.geteuid() == 0
    if root:   # root has no such limit: the test becomes nobody, who must be able to read everything
        os.chmod(kadr.folder, 0o755)
        if not for_nobody(kadr):
            return harness.skipped('no threads: nobody may not begin the program')
    simple = [('', words, words.split(), ()) for words in ('--help', 'controls', 'explain nct G1', 'machines', 'man', 'completion bash')]
    for command, program, words, outputs in itertools.chain(simple, of_each(kadr)):
        kadr.folder.chmod(0o777)
        _, faults = kadr.observed(words, outputs, [(resource.RLIMIT_NPROC, 0)], **(NOBODY if root else {}))
        yield f'{command} {program}', faults


def for_nobody(kadr):
    """Copies the program, if necessary, to where user nobody may start it.  returns whether it starts there"""
    def begins():
        try:
            return kadr.call('--version', **NOBODY).returncode == 0
        except OSError:
            return False
    if begins():
        return True
    (kadr.folder / 'program').mkdir()
    for name in (kadr.program, Path(kadr.program).with_name('kadr-bodies.so')):
        if Path(name).exists():
            shutil.copy(name, kadr.folder / 'program')
    kadr.program = str(kadr.folder / 'program' / Path(kadr.program).name)
    return begins()


def least_to_begin(kadr):
    """Returns the least megabytes of address space with which the program prints its version: with less its libraries do not load."""
    def begins(megabytes):
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))
        return subprocess.run([kadr.program, '--version'], capture_output=True, preexec_fn=limit).returncode == 0
    return next(megabytes for megabytes in range(10, 200) if begins(megabytes))


def memory(kadr):
    """Runs with memory limits from barely enough to start up to enough for most commands."""
    if kadr.sanitized:
        return harness.skipped('little memory: a program with a sanitizer has no limit of address space')
    least = least_to_begin(kadr)
    for command, program, words, outputs in of_each(kadr, 2):
        for megabytes in (least, least + 3, least + 9, 40, 60, 80, 120, 200):
            _, faults = kadr.observed(words, outputs, [(resource.RLIMIT_AS, megabytes << 20)])
            yield f'{command} {program} {megabytes} MB', faults
            clear(kadr.folder)


def open_files(kadr):
    for command, program, words, outputs in of_each(kadr, 3):
        for most in (3, 4, 5, 6, 8):
            _, faults = kadr.observed(words, outputs, [(resource.RLIMIT_NOFILE, most)])
            yield f'{command} {program} {most}', faults
            clear(kadr.folder)


def full_disk(kadr):
    """Runs with no byte, or one page, left on the disk; root has a small disk for that, others a file size limit. A file that is written
    must be the same as with enough space; an old file stays or is replaced by such a file."""
    disk = kadr.folder / 'disk'
    disk.mkdir()
    mounted = os.geteuid() == 0 and subprocess.run(['mount', '-t', 'tmpfs', '-o', 'size=64k', 'none', disk], capture_output=True).returncode == 0
    try:
        for command, program, words, outputs in of_each(kadr, 3):
            usual = kadr.observed(words, outputs)[0].returncode
            whole = {name: (kadr.folder / name).read_bytes() for name in outputs if (kadr.folder / name).exists()}
            for name, left, old in (('full', 0, False), ('full, old files', 0, True), ('a page left', 4096, False)):
                if old and command == 'setup':   # this command refuses the name of an existing file
                    continue
                for output in outputs if old else ():
                    (disk / output).write_bytes(OLD)
                if mounted:
                    fill(disk, left)
                limits = {} if mounted else {'limits': [(resource.RLIMIT_FSIZE, left)], 'before': lambda: signal.signal(signal.SIGXFSZ, signal.SIG_IGN)}
                done, faults = kadr.observed(words, outputs, folder=disk, **limits)
                for output in outputs:
                    got = (disk / output).read_bytes() if (disk / output).exists() else None
                    if got is not None and got != whole.get(output) and not (old and got == OLD):
                        faults.append(f'left over: {output} of {len(got)} bytes, {len(whole.get(output, b""))} are whole')
                    if got != whole.get(output) and done.returncode == usual == 0:
                        faults.append(f'exit status 0 without {output}')
                yield f'{command} {program}, {name}', faults
                clear(disk)
    finally:
        if mounted:
            subprocess.run(['umount', disk], check=True)


def fill(disk, left):
    with open(disk / 'filler', 'wb', buffering=0) as filler:
        try:
            while filler.write(bytes(4096)):
                pass
        except OSError:
            filler.truncate(filler.tell() - left)


def file_size(kadr):
    """Runs under `ulimit -f` as a shell sets it: the signal is not ignored."""
    for command, program, words, outputs in of_each(kadr):
        _, faults = kadr.observed(words, outputs, [(resource.RLIMIT_FSIZE, 4096)])
        yield f'{command} {program}', faults


def no_reader(kadr):
    """`| true`, `| head`: the command ends as if all had been printed, and reports nothing about it."""
    tap, nc, waves = EXAMPLES / 'mach3/bolt_circle.tap', EXAMPLES / 's2c42/flange.nc', EXAMPLES / 'cut/waves.ngc'
    mach3 = ('--control', 'mach3')
    cut = ('cut', tap, *mach3, *CUT, '--tools', EXAMPLES / 'cut/tools.toml')
    for words in (('run', tap, *mach3), ('run', tap, *mach3, '--trace', '-'), ('run', waves, '--samples', '-', '--max-time', 9), ('check', tap, *mach3),
                  ('check', EXAMPLES / 'docs', '--format', 'json'), ('check', EXAMPLES / 'docs', '--format', 'sarif'), cut, (*cut, '--json', '-'),
                  ('convert', nc, '--from', 's2c42', '--to', 'nct'), ('diff', EXAMPLES / 'docs/bracket.ngc', EXAMPLES / 'docs/bracket_new.ngc'),
                  ('setup', tap, *mach3), ('report', tap, *mach3, '--out', 'r.html'), ('tape', 'decode', EXAMPLES / 's2c42/flange.tape'), ('tape', 'encode', nc, '-'),
                  ('mill', 'pocket', EXAMPLES / 'mill/cover.txt', '--tool-diameter', 12, '--depth', 8, *mach3), ('debug', tap, *mach3), ('explain', 'nct'), ('man',), ('controls',), ('machines',),
                  ('completion', 'bash'), ('--help',), ('run', '--help')):
        words = [str(word) for word in words]
        usual = kadr.call(*words, binary=True).stderr.splitlines()
        read, write = os.pipe()
        os.close(read)
        done, faults = kadr.observed(words, ('r.html',) if words[0] == 'report' else (), stdout=write, said=False)
        os.close(write)
        yield name_of(words), [*faults, *complaints(done.stderr, usual)]
        clear(kadr.folder)
    for words in (('run', waves, '--control', 'linuxcnc', '--trace', '-'), ('explain', 'nct', '--markdown')):
        process = kadr.start(*words, preexec_fn=kadr.bounded())
        process.stdout.read(100)
        process.stdout.close()
        said = process.stderr.read()
        faults = [] if process.wait() in STATUSES else [f'exit status {process.returncode}']
        yield f'{name_of(words)} | head -c 100', [*faults, *complaints(said)]


def complaints(said, usual=()):
    """Returns the messages, without the summary, that the program does not print otherwise."""
    for line in said.splitlines():
        if line.startswith(b'kadr:') and line not in usual and b'otherwise: --control' not in line:
            yield f'complains: {text(line)}'


def name_of(words):
    """Returns the command as it is written in the name of a check."""
    words = map(str, words)
    return ' '.join(os.path.relpath(word, harness.ROOT) if word.startswith(str(harness.ROOT)) else word for word in words).encode('unicode_escape').decode()


def signals(kadr):
    """Sends a signal while the command works: it ends soon, and the files that existed before, and only those, remain."""
    program = kadr.file('p.nc', ENDLESS)
    contour = kadr.file('c.txt', 'from 0 0\nline 200 0\nline 200 200\nline 0 200\nclose\n')
    kadr.file('tools.toml', TOOLS)
    milled = ['mill', 'pocket', contour, '--tool-diameter', '2', '--stepover', '0.02', '--depth', '50', '--pass', '0.1', '--control', 'mach3', '--output', 'm.nc', '--plot', 'm.svg']
    for command, (words, outputs) in {**works(program, 'mach3', 'tools.toml'), 'mill': (milled, ('m.nc', 'm.svg'))}.items():
        if command in ('setup', 'tape'):   # these end soon with any program
            continue
        words = [*words, *(FOR_EVER if command != 'mill' else ())]
        for sign in (signal.SIGHUP, signal.SIGQUIT, signal.SIGTERM, signal.SIGINT):
            for output in outputs:
                kadr.file(output, OLD)
            yield f'{sign.name}: {command}', list(interrupted(kadr, words, outputs, sign))
            for path in kadr.folder.glob('.kadr-*'):
                path.unlink()


def begun(kadr, words, before=lambda: None):
    """Starts a command and waits until it works, with its outputs open."""
    (kadr.folder / 'commands').write_bytes(b'continue\n')   # commands for kadr debug
    with open(kadr.folder / 'said', 'wb') as said, open(kadr.folder / 'commands', 'rb') as commands:
        process = kadr.start(*words, stdin=commands, stdout=subprocess.DEVNULL, stderr=said, preexec_fn=kadr.bounded(before=before))
    harness.until(lambda: harness.ended(process) or (harness.spent(process) > 0.05 and kadr.left_over()) or harness.spent(process) > 0.3)
    return process


def interrupted(kadr, words, outputs, sign, before=lambda: None):
    process = begun(kadr, words, before)
    if harness.ended(process):
        yield f'it is over, and should work on: {text((kadr.folder / "said").read_bytes())}'
    took = harness.spent_after(process, sign)
    if process.returncode not in (128 + sign, -sign):
        yield f'exit status {process.returncode}: {text((kadr.folder / "said").read_bytes())}'
    if took > MOST_S:
        yield f'it works on for {took:.1f} s'
    if kadr.left_over():
        yield f'left over: {kadr.left_over()}'
    if changed := [name for name in outputs if (kadr.folder / name).read_bytes() != OLD]:
        yield f'changed: {changed}'


def signals_alone(kadr):
    """Sends signals where no thread can be created that waits for them."""
    kadr.folder.chmod(0o777)
    root = os.geteuid() == 0
    if root and not for_nobody(kadr):
        return harness.skipped('signals without threads: nobody may not begin the program')

    def alone():
        if root:
            os.setgroups([])
            os.setgid(NOBODY['group'])
            os.setuid(NOBODY['user'])
        resource.setrlimit(resource.RLIMIT_NPROC, (0, 0))
    program = kadr.file('p.nc', ENDLESS)
    words, outputs = works(program, 'mach3', 'tools.toml')['run']
    for sign in (signal.SIGHUP, signal.SIGTERM, signal.SIGINT):
        for output in outputs:
            kadr.file(output, OLD).chmod(0o666)
        yield f'{sign.name}: run', list(interrupted(kadr, [*words, *FOR_EVER], outputs, sign, alone))
    process = kadr.start('serve', kadr.folder, '--port', '0', '--no-browser', stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=kadr.bounded(before=alone))
    faults = [] if harness.stands(process) else ['it does not stand']
    harness.spent_after(process, signal.SIGTERM)
    yield 'SIGTERM: serve', [*faults, *([] if process.returncode == 128 + signal.SIGTERM else [f'exit status {process.returncode}'])]


def nohup(kadr):
    """A signal that is ignored at the start stays ignored."""
    program = kadr.file('p.nc', ENDLESS)
    process = begun(kadr, ['run', program, '--control', 'mach3', *FOR_EVER], lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    process.send_signal(signal.SIGHUP)
    works_on = harness.at_work(process, harness.spent(process) + 0.4)
    harness.spent_after(process, signal.SIGTERM)
    yield 'run', [] if works_on else [f'SIGHUP ends it, exit status {process.returncode}']


def names(kadr):
    """Control characters in names and arguments do not reach the terminal."""
    bad = 'a\x1b[31m\x07\x01b'
    program = bad + '.nc'
    kadr.file(program, 'G0 X1\nG1 Q0\nM30\n')
    mach3 = ('--control', 'mach3')
    for words in (('run', program, *mach3), ('run', 'no' + program, *mach3), ('run', program), ('check', program, *mach3), ('check', program, *mach3, '--format', 'json'),
                  ('check', program, *mach3, '--format', 'sarif'), ('convert', program, '--from', 'mach3', '--to', 'nct'), ('diff', program, program, *mach3), ('setup', program, *mach3),
                  ('setup', program, *mach3, '--tools'), ('report', program, *mach3, '--out', bad + '.html'), ('debug', program, *mach3), ('tape', 'encode', program, bad + '/a'),
                  ('cut', program, *mach3, *CUT, '--tools', bad), ('run', program, *mach3, '--setup', bad), ('run', program, '--control', bad), ('run', program, '--machine', bad),
                  ('run', program, *mach3, '--trace', bad + '/a'), ('run', program, *mach3, '--zero', bad), ('run', '--' + bad), (bad,), ('explain', bad), ('explain', 'mach3', bad),
                  ('machines', bad), ('state', 'check', bad), ('mill', 'pocket', bad, '--tool-diameter', '8', '--depth', '1', *mach3)):
        _, faults = kadr.observed(list(words), (bad + '.html',))
        yield name_of(words), [fault for fault in faults if 'is not written' not in fault]
        (kadr.folder / (bad + '.html')).unlink(missing_ok=True)


def texts(kadr):
    """Nor do control characters in a program text, which is printed with its alarms."""
    kadr.file('p.nc', 'T1 M6 (a\x1b[31m\x07)\nG0 X1 (\x1b)\nG1 Z-1 F100 (MSG, \x07\x1b[31m)\nG1 Q0 (\x1b)\nM30\n')
    kadr.file('tools.toml', TOOLS)
    for command, (words, outputs) in works('p.nc', 'mach3', 'tools.toml').items():
        _, faults = kadr.observed(words, outputs, input=b'list\nstep\nwhere\ncontinue\n' if command == 'debug' else b'')
        yield command, faults
    for words in (['run', 'p.nc', '--control', 'mach3', '--trace', '-'], ['check', 'p.nc', '--control', 'mach3'], ['setup', 'p.nc', '--control', 'mach3', '--tools'],
                  ['explain', 'mach3', 'control_character'], ['diff', 'p.nc', 'x.tape', '--control', 'mach3']):
        _, faults = kadr.observed(words)
        yield name_of(words), faults


def pipe(kadr):
    """A pipe without a writer is refused where a file is expected; a program may come from a pipe."""
    tap, tools = EXAMPLES / 'mach3/bolt_circle.tap', EXAMPLES / 'cut/tools.toml'
    for name in ('fifo', 'fifo.stl'):
        os.mkfifo(kadr.folder / name)
    for words in (('check', tap, '--control', 'mach3', '--baseline', 'fifo'), ('cut', tap, '--control', 'mach3', *CUT, '--tools', 'fifo'),
                  ('cut', tap, '--control', 'mach3', '--stock', 'fifo.stl', '--tools', tools), ('cut', tap, '--control', 'mach3', *CUT, '--tools', tools, '--part', 'fifo.stl'),
                  ('cut', tap, '--control', 'mach3', *CUT, '--tools', tools, '--fixture', 'fifo.stl'), ('report', tap, '--control', 'mach3', '--out', 'r.html', *CUT, '--tools', 'fifo')):
        with open(kadr.folder / 'said', 'wb') as said:
            process = kadr.start(*words, stdout=subprocess.DEVNULL, stderr=said, preexec_fn=kadr.bounded())
        if harness.stands(process):
            process.kill()
            faults = ['it waits for ever']
        else:
            faults = [] if process.wait() == 2 and (kadr.folder / 'said').read_bytes() else [f'exit status {process.returncode}']
        yield name_of((words[0], *words[-2:])), faults


def device(kadr):
    """Reading stops for a program text without an end."""
    if kadr.sanitized:
        return harness.skipped('devices: a program with a sanitizer has no limit of address space')
    (kadr.folder / 'tools.toml').write_text(TOOLS)
    for command, (words, outputs) in works('/dev/zero', 'mach3', 'tools.toml').items():
        done, faults = kadr.observed(words, outputs, [(resource.RLIMIT_AS, MOST_READ)])
        yield f'{command} /dev/zero', [*faults, *read_whole(done)]
    with subprocess.Popen(['cat', '/dev/zero'], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as endless:
        done, faults = kadr.observed(['run', '-', '--control', 'mach3'], (), [(resource.RLIMIT_AS, MOST_READ)], stdin=endless.stdout)
        endless.stdout.close()
    yield 'cat /dev/zero | run -', [*faults, *read_whole(done)]


def read_whole(done):
    if b'out of memory' in done.stderr:
        yield 'it is read whole: out of memory'


def small(kadr):
    """Short programs that request much: time and memory stay in proportion to the request."""
    if kadr.sanitized:
        return harness.skipped('programs that ask for much: a program with a sanitizer has no limit of address space')
    for name, control, program, more in (('samples of a long cycle', 'haas', 'O1\nG73 X0 Y0 Z-99999 R1 Q0.001 F100\nM30\n', ('--samples', 's.csv', '--max-time', '1')),
                                         ('variable of a great number', 'linuxcnc', '#4294967295=1\nM2\n', ())):
        kadr.file('p.nc', program)
        done, faults = kadr.observed(['run', 'p.nc', '--control', control, *more], ('s.csv',) if more else (), [(resource.RLIMIT_CPU, 2)])
        yield name, [*faults, *(['out of memory'] if b'out of memory' in done.stderr else [])]


LIMITS = {'no threads': no_threads, 'memory': memory, 'open files': open_files, 'full disk': full_disk, 'file size': file_size, 'no reader': no_reader, 'signals': signals, 'signals alone': signals_alone, 'nohup': nohup,
          'names': names, 'texts': texts, 'pipe': pipe, 'device': device, 'small': small}


def over_limits(kadr):
    """Returns name → job; a job returns (check, faults)."""
    for name, check in LIMITS.items():
        def job(name=name, check=check):
            with tempfile.TemporaryDirectory(prefix='kadr_every_') as folder, type(kadr)(kadr.program, folder) as own:
                own.sanitized = kadr.sanitized
                for what, faults in check(own):
                    yield f'limits {what}' if name == 'signals' else f'limits {name}: {what}', faults
        yield f'limits {name}', job
