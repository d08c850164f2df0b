#!/usr/bin/env python3
"""Checks the texts that people read, texts/*.toml: tests/texts.py [--generator BUILD/src/kadr_embed_texts]

Every id is in every language and is used in src; placeholders and forms agree; Russian texts are Russian, English texts are not; no other
file of src has Russian texts, apart from those that read Russian. With --generator, faulty files are refused with a sentence.
"""
import argparse
import re
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CYRILLIC = re.compile('[А-Яа-яЁё]')
HOLE = re.compile(r'\{\{|\}\}|(\{\d*(?::[^{}]*)?\})')
# Files whose Russian words Kadr reads, in programs, or compares letters with.
READS_RUSSIAN = {
    'src/lang/block/lexer.cpp', 'src/lang/text/encoding.cpp', 'src/lang/text/end_mark.h', 'src/lang/text/shop_words.h',
    'src/lang/text/tool_figures.cpp',
    'src/lang/text/tool_size.cpp', 'src/lang/text/tool_words.cpp', 'src/lang/text/written_letters.cpp',
    'src/out/text/explain/asked_code.cpp', 'src/out/text/explain/code_page.cpp', 'src/session/milling/mill_request.cpp',
}
MOST_READERS = 12
# English texts that name what is written in Russian: a control, values of options.
ENGLISH_WITH_CYRILLIC = {'help_examples.mill', 'mill_options.scheme', 'mill_options.plunge', 'program_options.work_zero'}
FORMS = {'one_other': 2, 'slavic': 3, 'none': 1}

passed, failures = 0, []


def check(ok, what):
    global passed
    if ok:
        passed += 1
    else:
        failures.append(what)


def forms(value):
    return value if isinstance(value, list) else [value]


def holes(text):
    """Returns the placeholders of a text, sorted if they are numbered."""
    found = [m[1] for m in HOLE.finditer(text) if m[1]]
    return sorted(found) if any(hole[1].isdigit() for hole in found) else found


def check_language(path, table, original):
    rule = table.get('language', {}).get('plurals')
    check(rule in FORMS, f'{path.name}: plurals is {rule}')
    ids = {(section, key) for section, rows in table.items() if section != 'language' for key in rows}
    wanted = {(section, key) for section, rows in original.items() if section != 'language' for key in rows}
    for section, key in sorted(wanted - ids):
        check(False, f'{path.name}: {section}.{key} is missing')
    for section, key in sorted(ids - wanted):
        check(False, f'{path.name}: {section}.{key} is not in en.toml')
    for section, key in sorted(ids & wanted):
        where, own, first = f'{path.name}: {section}.{key}', table[section][key], original[section][key]
        check(isinstance(own, list) == isinstance(first, list), f'{where}: forms for numbers in one language only')
        check(not isinstance(own, list) or len(own) == FORMS.get(rule), f'{where}: {len(forms(own))} forms')
        kinds = {tuple(sorted(set(re.sub(r'[{}]', '', hole) for hole in holes(form)))) for form in forms(own) + forms(first) if holes(form)}
        check(isinstance(own, list) or holes(own) == holes(first) or sorted(holes(own)) == sorted(holes(first)) and any(h[1].isdigit() for h in holes(own)),
              f'{where}: placeholders {holes(forms(own)[0])}, in English {holes(forms(first)[0])}')
        check(not isinstance(own, list) or len(kinds) <= 1, f'{where}: the forms have different placeholders')
        for form in forms(own):
            check(form.strip() != '', f'{where}: is empty')


def cyrillic_in(path):
    """Returns the lines of a source whose string literals have Cyrillic letters, comments aside."""
    lines = []
    for number, line in enumerate(path.read_text(encoding='utf-8').splitlines(), 1):
        code = re.sub(r'^((?:[^"/]|"(?:\\.|[^"\\])*"|/(?!/))*)//.*$', r'\1', line)
        if CYRILLIC.search(''.join(re.findall(r'"(?:\\.|[^"\\])*"', code))):
            lines.append(number)
    return lines


def check_sources(original):
    sources = {path: path.read_text(encoding='utf-8') for path in sorted((ROOT / 'src').rglob('*')) if path.suffix in ('.h', '.cpp')}
    used = set()
    for text in sources.values():
        used |= set(re.findall(r'texts::(\w+)::(\w+)', text))
        for alias, section in re.findall(r'namespace (\w+) = (?:kadr::)?texts::(\w+);', text):
            used |= {(section, key) for key in re.findall(rf'\b{alias}::(\w+)', text)}
    for section, rows in original.items():
        for key in rows if section != 'language' else ():
            check((section, key) in used, f'en.toml: {section}.{key} is not used')
    for path in sources:
        name = str(path.relative_to(ROOT))
        lines = cyrillic_in(path)
        check(not lines or name in READS_RUSSIAN, f'{name}: Russian text in line {", ".join(map(str, lines[:5]))}: it belongs to texts/ru.toml')
        check(bool(lines) or name not in READS_RUSSIAN, f'{name}: has no Russian letters any more: remove it from READS_RUSSIAN')
    check(len(READS_RUSSIAN) <= MOST_READERS, f'{len(READS_RUSSIAN)} files read Russian, at most {MOST_READERS} may')


EN = '[language]\nname = "English"\nplurals = "one_other"\n'
RU = '[language]\nname = "Русский"\nplurals = "slavic"\n'
FAULTY = [  # English, Russian, what the generator says
    (EN + '[a]\nb = "one {}"\n', RU + '[a]\nb = "один"\n', 'placeholders'),
    (EN + '[a]\nb = "one"\n', RU + '[a]\nb = "один"\nc = "два"\n', 'a.c is not in texts/en.toml'),
    (EN + '[a]\nb = ["{} row", "{} rows"]\n', RU + '[a]\nb = ["{} строка", "{} строк"]\n', '3 forms'),
    (EN + '[a]\nb = ["{} row", "{} rows"]\n', RU + '[a]\nb = "строк"\n', 'forms for numbers'),
    (EN + '[a]\nclass = "one"\n', RU, 'an id has'),
    (EN + '[a]\nB = "one"\n', RU, 'an id has'),
    (EN + '[a]\nb = "{} {0}"\n', RU, 'numbered'),
    (EN + '[a]\nb = "{} {"\n', RU, 'b:'),
    (EN + '[a]\nb = ""\n', RU, 'missing'),
    (EN + '[a]\nb = "one"\nb = "two"\n', RU, 'en.toml:6'),
    (EN.replace('one_other', 'two'), RU, 'plurals'),
]
GOOD = (EN + '[a]\nb = "one {0} of {1}"\nc = "{ braces }"\nd = ["{} row of {}", "{} rows of {}"]\n',
        RU + '[a]\nb = "{1}: один {0}"\nd = ["{} строка из {}", "{} строки из {}", "{} строк из {}"]\n')


def generate(generator, english, russian):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (('en', english), ('ru', russian)):
            (Path(folder) / f'{name}.toml').write_text(text, encoding='utf-8')
        done = subprocess.run([generator, f'{folder}/out', f'{folder}/en.toml', f'{folder}/ru.toml'], capture_output=True, text=True)
        out = {path.name: path.read_text(encoding='utf-8') for path in (Path(folder) / 'out').rglob('*') if path.is_file()}
    return done, out


def check_generator(generator):
    for english, russian, said in FAULTY:
        done, _ = generate(generator, english, russian)
        check(done.returncode == 1 and said in done.stderr, f'{said}: ends with {done.returncode}: {done.stderr.strip()}')
    done, out = generate(generator, *GOOD)
    check(done.returncode == 0, f'a good file is refused: {done.stderr}')
    for row in ('TextId<2> b{0, 0}', 'TextId<0> c{0, 1}', 'PluralId<1> d{0, 2}'):
        check(row in out.get('a.h', ''), f'a.h has no {row}')
    check(out.get('texts.cpp', '').count('"{ braces }"') == 2, 'a missing translation is not the English text')


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--generator', help='the program of dev/embed_texts.cpp')
    parser.add_argument('--kadr', help='not used')
    arguments = parser.parse_args()
    tables = {path: tomllib.loads(path.read_text(encoding='utf-8')) for path in sorted((ROOT / 'texts').glob('*.toml'))}
    original = tables[ROOT / 'texts' / 'en.toml']
    for path, table in tables.items():
        check_language(path, table, original)
    for section, rows in original.items():
        for key, value in rows.items() if section != 'language' else ():
            check(not any(CYRILLIC.search(form) for form in forms(value)) or f'{section}.{key}' in ENGLISH_WITH_CYRILLIC, f'en.toml: {section}.{key}: Russian letters')
    check_sources(original)
    if arguments.generator:
        check_generator(arguments.generator)
    for failure in failures:
        print('  ' + failure)
    print(f'{passed} passed, {len(failures)} failed')
    return 1 if failures else 0


if __name__ == '__main__':
    sys.exit(main())
