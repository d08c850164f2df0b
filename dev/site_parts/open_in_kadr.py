"""Links of the documentation that open an example in Kadr itself: the page without a server (docs/web.md), which is a part of the site.

A link holds the files of the example in its address, so it works on a static host and from the disk alike (web/src/engine/given.ts):

    kadr/index.html#files=BASE64        base64 of zlib of {"open": {file, control, machine, setup}, "files": {path: text}}

Each character of a text is a byte of the file. From the disk, open_in_kadr.js leads to kadr/kadr.html, the same page as one file.
"""
import base64
import json
import os
import re
import shlex
import shutil
import zlib
from pathlib import PurePosixPath

FOLDER = 'kadr'  # of the page in the site
PROGRAMS = ('.nc', '.nct', '.ngc', '.tap', '.h', '.mpf', '.tape')
BESIDE = PROGRAMS + ('.spf', '.sub', '.txt', '.ini', '.json')  # files that a program or a set-up may name
TO_PAGE = ('control', 'machine', 'setup', 'tools')  # options that the link holds
NO_MATTER = ('plot', 'out', 'trace', 'stock', 'lang', 'part', 'fixture', 'colour')  # options without which the page shows the same program
COMMAND = re.compile(r'(?:\$ )?kadr (?:run|cut|check|report) (.*)')
TEXTS = {False: 'Open in Kadr', True: 'Открыть в Kadr'}


def is_there(root):
    """Returns whether `make web` has built the page."""
    return (root / 'build/web/site/index.html').is_file() and (root / 'build/web/kadr.html').is_file()


def add_page(root, site):
    """Copies the page into the site."""
    shutil.copytree(root / 'build/web/site', site / FOLDER, dirs_exist_ok=True)
    shutil.copy(root / 'build/web/kadr.html', site / FOLDER)


class Example:
    """A program with what a command says of it. Paths are those in the tree."""

    def __init__(self, program, options):
        self.program, self.options = program, options

    def __eq__(self, other):
        return (self.program, self.options) == (other.program, other.options)


def example_of(line, files, folder):
    """Returns the example that a line of a page runs; None if it runs none, or with options that the page has not.
    files: the paths of the tree; folder: where the command runs, `''` or `'examples'`"""
    match = COMMAND.fullmatch(line.strip())
    if not match:
        return None
    try:
        words = shlex.split(match[1])
    except ValueError:
        return None
    options, programs = {}, []
    words.reverse()
    while words:
        word = words.pop()
        if word == '-q':
            continue
        if not word.startswith('-'):
            programs.append(os.path.normpath(os.path.join(folder, word)))
        elif word.removeprefix('--') in TO_PAGE + NO_MATTER and words:
            options[word.removeprefix('--')] = words.pop()
        else:
            return None
    if len(programs) != 1 or programs[0] not in files or not programs[0].endswith(PROGRAMS):
        return None
    kept = {name: value for name, value in options.items() if name in TO_PAGE}
    for name, value in kept.items():
        path = os.path.normpath(os.path.join(folder, value))
        if path in files:
            kept[name] = path
        elif name in ('setup', 'tools') or value.endswith('.toml'):
            return None
    return Example(programs[0], kept)


def beside(root, example, files):
    """Returns the files of the program's folder that it calls or names: their names, or the numbers of subprograms, occur in it or in its set-up."""
    folder = PurePosixPath(example.program).parent
    texts = ''.join((root / name).read_bytes().decode('latin-1') for name in (example.program, example.options.get('setup')) if name in files)
    found = []
    for name in sorted(files):
        path = PurePosixPath(name)
        if path.parent != folder or name == example.program or not name.endswith(BESIDE):
            continue
        number = path.stem.lstrip('O0')
        if path.name in texts or (number.isdigit() and re.search(rf'\D0*{number}\b', texts)):
            found.append(name)
    return found


def address_of(root, example, files):
    """Returns the part of the address after `#`. In the page the files lie as in examples/, without that folder."""
    def place(name):
        return name.removeprefix('examples/')

    names = {name: place(name) for name in [example.program, *beside(root, example, files)]}
    for option in ('setup', 'control', 'machine'):
        if example.options.get(option) in files:
            names[example.options[option]] = place(example.options[option])
    if 'tools' in example.options:  # a tools file of the program's own name belongs to it
        names[example.options['tools']] = str(PurePosixPath(place(example.program)).with_suffix('.toml'))
    question = {'file': place(example.program)}
    for option in ('setup', 'control', 'machine'):
        if option in example.options:
            question[option] = names.get(example.options[option], example.options[option])
    content = {to: (root / name).read_bytes().decode('latin-1') for name, to in names.items()}
    packed = zlib.compress(json.dumps({'open': question, 'files': content}, ensure_ascii=False).encode(), 9)
    return 'files=' + base64.urlsafe_b64encode(packed).decode().rstrip('=')


def link(root, example, files, folder, russian=False):
    """Returns a link that opens an example, for a page in this folder of the site."""
    page = os.path.relpath(f'{FOLDER}/index.html', folder or '.')
    name = PurePosixPath(example.program).name
    return f'<a class="open-in-kadr" href="{page}#{address_of(root, example, files)}">{TEXTS[russian]}: {name}</a>'
