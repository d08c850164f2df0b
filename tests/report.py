#!/usr/bin/env python3
"""Tests kadr report: one self-contained file without active content, of a bounded size, never written in part; opened in Chromium where
available.

    report.py --kadr PROGRAM

Prints a line per failure, then `N passed, N failed`. If the program was built without its page, the test checks the message about that.
"""
import base64
import html.parser
import json
import os
import signal
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

import harness

EXAMPLES = harness.ROOT / 'examples'
EVIL = '</script><img src=x onerror=document.title=1>'

tally = harness.Tally()
expect = tally.expect


def run(kadr, *words, **more):
    return kadr.call('report', *words, **more)


class Page(html.parser.HTMLParser):
    """Collects addresses, and the texts of the elements that have an id."""

    def __init__(self, text):
        super().__init__()
        self.addresses, self.tags, self.held, self.inside, self.policy = [], [], {}, None, ''
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.tags.append(tag)
        self.addresses += [value for name, value in attributes if name in ('src', 'href', 'action', 'data', 'poster')]
        self.inside = given.get('id', self.inside if tag != 'script' else None)
        if given.get('http-equiv') == 'Content-Security-Policy':
            self.policy = given['content']

    def handle_endtag(self, tag):
        self.inside = None

    def handle_data(self, data):
        if self.inside:
            self.held[self.inside] = self.held.get(self.inside, '') + data


def content(path):
    """Returns the content of a report: its JSON parts by type."""
    page = Page(path.read_text(encoding='utf-8'))
    bytes_ = zlib.decompress(base64.b64decode(page.held['kadr-data'], validate=True))
    length, = struct.unpack_from('<I', bytes_)
    pieces, at = [], 4 + length
    while at < len(bytes_):
        kind, size = struct.unpack_from('<II', bytes_, at)
        pieces.append((kind, bytes_[at + 8:at + 8 + size]))
        at += 8 + size
    return page, json.loads(bytes_[4:4 + length]), pieces


def vertices(pieces):
    return sum(struct.unpack_from('<I', piece)[0] for kind, piece in pieces if kind == 1)


def what_is_inside(kadr, folder):
    program, out = folder / 'cover.nc', folder / 'cover.html'
    program.write_text(f'%\nO7 ({EVIL})\n(КРЕПИТЬ ЗА КРАЯ)\nG21 G90 G17 G94\nT1 M6 (ФРЕЗА 10)\nG54 G0 X0. Y0. Z5. S900 M3\nG1 Z-2. F200\nG3 X0. Y0. I10. J0.\n'
                       'M0 (ПОВЕРНУТЬ)\nG0 Z50.\nM30\n%\n', encoding='utf-8')
    made = run(kadr, program, '--control', 'fanuc', '--zero', 'G54=X-100,Y-50,Z-30', '--out', out, '--lang', 'ru')
    expect(made.returncode == 0, f'a report is written: {made.returncode} {made.stderr}')
    expect('кадр' in made.stdout.lower() or made.stdout, 'the summary is printed')
    page, data, pieces = content(out)
    expect(all(not a for a in page.addresses) and not page.addresses, f'no address in a src or href: {page.addresses}')
    expect("default-src 'none'" in page.policy and 'connect' not in page.policy and "'unsafe" not in page.policy, f'its policy: {page.policy}')
    expect(page.tags.count('img') == 0 and EVIL not in out.read_text(encoding='utf-8'), 'a comment does not become markup')
    expect(EVIL in data['sources'][0]['text'], 'the source is inside')
    expect(data['language'] == 'ru' and data['ru']['sheet']['comments'][1]['text'] == 'КРЕПИТЬ ЗА КРАЯ', 'Russian notes')
    expect(data['ru']['sheet']['stops'][0]['text'] == 'ПОВЕРНУТЬ', 'the note at a stop')
    expect(data['en']['sheet']['zeros'][0] == {'name': 'G54', 'values': {'X': -100, 'Y': -50, 'Z': -30}}, f'zeros: {data["en"]["sheet"]["zeros"]}')
    tool = data['en']['sheet']['tools'][0]
    expect(tool['number'] == 1 and tool['radius'] == 5 and tool['lines'] == [5] and tool['outline'], f'tools: {tool}')
    expect(data['en']['done']['state'] == 'ended' and data['en']['done']['seconds'] > 0, 'times')
    expect(vertices(pieces) > 20 and data['thinned'] == 0, 'the path is whole')
    expect('three' in data['licences'] and 'MIT' in data['licences'], 'the notices are inside')
    again = folder / 'again.html'
    run(kadr, program, '--control', 'fanuc', '--zero', 'G54=X-100,Y-50,Z-30', '--out', again, '--lang', 'ru')
    expect(again.read_bytes() == out.read_bytes(), 'the same input gives the same bytes')
    return out


def alarms(kadr, folder):
    program, out = folder / 'wrong.nc', folder / 'wrong.html'
    program.write_text('G21 G90\nG0 X0\nG1 X10\nM30\n')
    made = run(kadr, program, '--control', 'fanuc', '--out', out, '--lang', 'en')
    expect(made.returncode == 1, f'with an alarm status 1: {made.returncode}')
    _, data, _ = content(out)
    problem = next((p for p in data['en']['problems'] if p['severity'] == 'alarm'), None)
    expect(problem and problem['line'] == 3 and problem['text'] and problem['hint'], f'the alarm is in the report, with its hint: {problem}')
    russian = next((p for p in data['ru']['problems'] if p['severity'] == 'alarm'), {'text': ''})
    expect(any('а' <= c <= 'я' for c in russian['text']), 'in Russian too')
    expect(any(m['kind'] == 'alarm' and m['text'] == problem['text'] for m in data['en']['done']['marks']), 'the mark says the same')
    piped = run(kadr, '-', '--control', 'fanuc', '--out', folder / 'piped.html', '--lang', 'en', input=program.read_bytes(), binary=True)
    _, data, _ = content(folder / 'piped.html')
    expect(piped.returncode == 1 and data['sources'][0]['text'].startswith('G21 G90\nG0 X0'), 'standard input')
    printed = run(kadr, program, '--control', 'fanuc', '--out', '-', '--lang', 'en', binary=True)
    expect(printed.stdout.startswith(b'<!doctype html>') and printed.stdout.rstrip().endswith(b'</html>'), '--out - is the page alone')


def part(kadr, folder):
    out = folder / 'part.html'
    cut = EXAMPLES / 'cut'
    made = run(kadr, cut / 'plate.nc', '--control', 'mach3', '--tools', cut / 'tools.toml', '--stock', 'box:-40,-30,-20,40,30,0', '--resolution', 1, '--out', out, '--lang', 'en')
    expect(made.returncode == 0 and 'removed' in made.stdout, f'the part: {made.returncode} {made.stdout} {made.stderr}')
    _, data, pieces = content(out)
    solid = [piece for kind, piece in pieces if kind == 3]
    expect(len(solid) == 1 and struct.unpack_from('<I', solid[0])[0] > 50, 'its surface is inside')
    expect(0 < data['en']['cut']['left'] < data['en']['cut']['stock'] == 96000 and data['part']['off'] > 0, f'its volumes: {data["en"]["cut"]}')
    crash = run(kadr, cut / 'crash.nc', '--control', 'mach3', '--tools', cut / 'tools.toml', '--stock', 'box:-40,-30,-20,40,30,0', '--resolution', 1, '--out', out, '--lang', 'en')
    _, data, _ = content(out)
    command = kadr.call('cut', cut / 'crash.nc', '--control', 'mach3', '--tools', cut / 'tools.toml', '--stock', 'box:-40,-30,-20,40,30,0', '--resolution', 1, '--json', '-', '-q')
    wanted = [(f['id'], f['line']) for f in json.loads(command.stdout)['collisions']]
    for lang in ('en', 'ru'):
        findings = data[lang]['findings']
        expect([(f['id'], f['line']) for f in findings] == wanted, f'what kadr cut finds: {findings}')
        expect(all(f['severity'] == 'alarm' and f['text'] and f['hint'] and len(f['place']) == 3 for f in findings), f'findings are problems, with moment and place: {findings}')
    expect(crash.returncode == 1 and data['en']['findings'] and data['ru']['findings'][0]['text'] != data['en']['findings'][0]['text'], f'what is hit: {crash.returncode} {crash.stderr[-300:]}')


def live_files(path):
    """Returns what a live report opens, and its files as bytes."""
    page = Page(path.read_text(encoding='utf-8'))
    given = json.loads(zlib.decompress(base64.b64decode(page.held['kadr-files'], validate=True)))
    return page, given['open'], {name: text.encode('latin-1') for name, text in given['files'].items()}


def live(kadr, folder):
    """A live report is the given page with the files of the program, byte by byte; web/e2e/alone_live.mjs opens a real one."""
    place, out = folder / 'live', folder / 'live.html'
    (place / 'sub').mkdir(parents=True)
    (place / 'page.html').write_text('<html><body><script type="text/plain" id="kadr-engine-wasm">AAAA</script></body></html>')
    program = f'%\nO1 ({EVIL})\nG21 G90 G0 X0\nM98 P2\nM30\n%\n'.encode() + b'(\xff)'
    (place / 'main.nc').write_bytes(program)
    (place / 'O0002').write_text('%\nO2\nG0 X1.\nM99\n%\n')
    (place / 'sub/my.json').write_text('{"skip": [2]}')
    (folder / 'mills.toml').write_text('[[tool]]\nnumber = 1\nkind = "flat"\ndiameter = 10\nflute_length = 20\n')
    (folder / 'blank.stl').write_text('solid x\nendsolid x\n')
    made = run(kadr, place / 'main.nc', '--control', 'fanuc', '--setup', place / 'sub/my.json', '--tools', folder / 'mills.toml', '--live', place / 'page.html',
               '--out', out, '--lang', 'en')
    expect(made.returncode == 0 and 'blocks' in made.stdout, f'a live report is written: {made.returncode} {made.stdout} {made.stderr}')
    page, opening, files = live_files(out)
    expect(opening == {'file': 'main.nc', 'control': 'fanuc', 'setup': 'sub/my.json'}, f'what it opens: {opening}')
    expect(files == {'main.nc': program, 'O0002': (place / 'O0002').read_bytes(), 'sub/my.json': (place / 'sub/my.json').read_bytes(),
                     'main.toml': (folder / 'mills.toml').read_bytes()}, f'its files: {files}')
    expect(page.tags.count('img') == 0 and page.tags.count('script') == 2, 'a comment does not become markup')
    boxed = run(kadr, EXAMPLES / 'cut/plate.nc', '--control', 'mach3', '--tools', EXAMPLES / 'cut/tools.toml', '--stock', 'box:-40,-30,-20,40,30,0', '--fixture',
                'box:0,0,-30,1,1,-25', '--resolution', 2, '--live', place / 'page.html', '--out', out, '-q')
    _, opening, files = live_files(out)
    expect(boxed.returncode == 0 and json.loads(files[opening['setup']]) == {'stock': 'box:-40,-30,-20,40,30,0', 'fixtures': ['box:0,0,-30,1,1,-25']},
           f'blank and fixture are in its set-up: {boxed.stderr} {opening} {files.keys()}')
    for words, why in ((['--live', place / 'main.nc'], 'make web'), (['--live', place / 'page.html', '--zero', 'G54=X1'], '--setup'),
                       (['--live', place / 'no.html'], 'no.html')):
        refusal = run(kadr, place / 'main.nc', '--control', 'fanuc', *words, '--out', folder / 'none.html', '--lang', 'en')
        expect(refusal.returncode == 2 and why in refusal.stderr and not (folder / 'none.html').exists(), f'refused: {words} {refusal.returncode} {refusal.stderr}')


def size(kadr, folder):
    """100,000 blocks with arcs and irregular positions give less than 5 MB; in less than 5 s here, sooner on an idle machine."""
    program, out = folder / 'long.nc', folder / 'long.html'
    lines, state = ['G21 G90 G17 G94', 'T1 M6', 'G0 X0 Y0 Z5', 'G1 Z-1 F800'], 12345
    for i in range(100_000):
        state = (state * 1103515245 + 12345) & 0x7fffffff
        x, y = (state >> 8) % 200000 / 1000, (state >> 4) % 200000 / 1000
        lines.append(f'G1 X{x:.3f} Y{y:.3f} F{500 + state % 400}' if i % 5 else f'G3 X{x:.3f} Y{y:.3f} R{300 + i % 50}.5')
    program.write_text('\n'.join(lines + ['M30', '']))
    made = run(kadr, program, '--control', 'fanuc', '--out', out, '-q', '--lang', 'en')
    expect(made.returncode == 0, f'100,000 blocks: {made.returncode} {made.stderr[-300:]}')
    expect(out.stat().st_size <= 5_000_000, f'100,000 blocks are {out.stat().st_size} bytes')
    _, data, pieces = content(out)
    expect(data['en']['done']['blocks'] >= 100_000 and vertices(pieces) > 20_000, 'and hold their path')
    print(f'100,000 blocks: {out.stat().st_size} bytes, {vertices(pieces)} vertices, thinned by {data["thinned"]} mm')
    killed(kadr, folder, program)
    return out


def killed(kadr, folder, program):
    place = folder / 'killed'
    place.mkdir()
    for signal_, work in [(signal.SIGINT, 0.3), (signal.SIGTERM, 0.8), (signal.SIGINT, 1.5)]:
        process = kadr.start('report', program, '--control', 'fanuc', '--out', place / 'r.html', '-q', stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        if not harness.at_work(process, work):  # it ended before
            process.wait()
            (place / 'r.html').unlink()
            continue
        harness.spent_after(process, signal_)
        if process.returncode == 0:
            (place / 'r.html').unlink()
            continue
        expect(process.returncode == 128 + signal_, f'ended by {signal_!r}: {process.returncode}')
        expect(list(place.iterdir()) == [], f'ended by {signal_!r} it leaves nothing: {list(place.iterdir())}')


def refused(kadr, folder):
    program = folder / 'part.nc'
    program.write_text('G21 G90 G54\nG0 X0\nG1 X10 F100\nM30\n')
    before = program.read_bytes()
    made = run(kadr, program, '--control', 'fanuc', '--out', program, '--lang', 'en')
    expect(made.returncode == 2 and program.read_bytes() == before, f'not over the program: {made.returncode} {made.stderr}')
    link = folder / 'link.html'
    link.symlink_to(program)
    made = run(kadr, program, '--control', 'fanuc', '--out', link, '--lang', 'en')
    expect(made.returncode == 2 and program.read_bytes() == before, 'nor through a link')
    made = run(kadr, program, '--control', 'fanuc', '--out', folder / 'none' / 'r.html', '--lang', 'en')
    expect(made.returncode == 2 and 'none' in made.stderr, f'no such folder: {made.stderr}')
    if Path('/dev/full').exists():
        made = run(kadr, program, '--control', 'fanuc', '--out', '/dev/full', '--lang', 'en')
        expect(made.returncode == 2 and made.stderr.strip(), f'a full disk: {made.returncode} {made.stderr}')
    shut = folder / 'shut'
    shut.mkdir(mode=0o555)
    if os.geteuid() != 0:
        made = run(kadr, program, '--control', 'fanuc', '--out', shut / 'r.html', '--lang', 'en')
        expect(made.returncode == 2 and not list(shut.iterdir()), 'a folder that may not be written')
    old = folder / 'old.html'
    old.write_text('as it was')
    made = run(kadr, folder / 'missing.nc', '--control', 'fanuc', '--out', old, '--lang', 'en')
    expect(made.returncode == 2 and old.read_text() == 'as it was', 'no program: what was there stays')
    for words in [['--out'], [], ['--out', 'x.html', '--stock', 'box:0,0,0,1,1,1'], ['--out', 'x.html', '--tools', folder / 'none.toml']]:
        made = run(kadr, program, '--control', 'fanuc', *words, cwd=folder)
        expect(made.returncode == 2 and not (folder / 'x.html').exists(), f'refused: {words} {made.returncode}')


def licences(kadr):
    for word in ['--licences', '--licenses']:
        told = kadr.call(word)
        expect(told.returncode == 0 and 'Apache License' in told.stdout and 'Boost Software License' in told.stdout, f'{word}: {told.returncode}')
    return told.stdout


def browser(kadr, reports):
    web = Path(kadr.program).resolve().parent / 'web'
    if not Path('/usr/bin/chromium').exists() or not (web / 'node_modules' / 'playwright-core').is_dir():
        tally.skip('reports are opened in no browser: there is no Chromium, or no playwright-core beside the program')
        return
    shown = subprocess.run(['node', 'e2e/report.mjs', *map(str, reports)], cwd=web, capture_output=True, text=True, timeout=1200, check=False)
    print(shown.stdout, end='')
    expect(shown.returncode == 0, f'in Chromium: {shown.stdout[-2000:]}{shown.stderr[-2000:]}')


def main():
    with tempfile.TemporaryDirectory(prefix='kadr-report-') as name, harness.Kadr(harness.kadr_of(__doc__), name) as kadr:
        told, folder = licences(kadr), kadr.folder
        if 'three' not in told:
            made = run(kadr, EXAMPLES / 'cut' / 'plate.nc', '--out', folder / 'r.html', '--lang', 'en')
            expect(made.returncode == 2 and 'npm' in made.stderr and not (folder / 'r.html').exists(), f'without its page: {made.stderr}')
            tally.skip('no report is written: the program was built without its page')
        else:
            small = what_is_inside(kadr, folder)
            alarms(kadr, folder)
            refused(kadr, folder)
            part(kadr, folder)
            live(kadr, folder)
            long = size(kadr, folder)
            browser(kadr, [small, folder / 'wrong.html', long])
    return tally.result()


if __name__ == '__main__':
    sys.exit(main())
