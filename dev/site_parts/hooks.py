"""Hooks of MkDocs for `make site` (mkdocs.yml): the navigation, one for each language, and a check that the pages read as on GitHub."""
import logging
import re
from collections import Counter
from html.parser import HTMLParser
from pathlib import Path

from markdown_it import MarkdownIt
from mkdocs.structure.nav import Navigation

log = logging.getLogger('mkdocs.plugins.kadr')

ROOT = Path(__file__).resolve().parents[2]

# Sections of the navigation: title, pages. A `*` stands for all pages of that form which no other section has. Pages that are not there
# are left out, so a page can come and go without a change here.
ENGLISH = [
    ('Start', ['README.md', 'CHANGELOG.md']),
    ('Commands', ['docs/commands/*.md']),
    ('Controls', ['docs/controls/*.md']),
    ('Guides', ['docs/setup.md', 'docs/machines.md', 'docs/macros.md', 'docs/own-control.md', 'docs/checklist.md', 'docs/panel.md', 'docs/*.md']),
    ('Library', ['docs/library.md', 'api/cpp.md', 'python/README.md', 'api/python.md']),
    ('Examples', ['examples/README.md', 'examples/files.md']),
    ('Development', ['CONTRIBUTING.md', 'docs/architecture.md', 'docs/subsystems.md', 'docs/adding-a-control.md', 'docs/panel-protocol.md',
                     'docs/tests.md', 'docs/benchmarks.md', 'docs/dependencies.md', 'docs/glossary.md']),
]
RUSSIAN = [
    ('Начало', ['README.ru.md']),
    ('Команды', ['docs/ru/commands/*.md']),
    ('УЧПУ', ['docs/ru/controls/*.md']),
    ('Руководства', ['docs/ru/setup.md', 'docs/ru/machines.md', 'docs/ru/macros.md', 'docs/ru/own-control.md', 'docs/ru/*.md']),
]
LONGEST_TITLE = 34  # characters of a title in the navigation; a longer one is cut at its colon
COUNTED = ('h1', 'h2', 'h3', 'h4', 'li', 'ol', 'ul', 'table', 'tr', 'td', 'pre', 'img', 'blockquote')

navigations = {}  # language → Navigation


def is_russian(source):
    return source == 'README.ru.md' or source.startswith('docs/ru/')


def title_of(path):
    """Returns the title of a page for the navigation: its first heading."""
    heading = re.search(r'^# (.+)$', path.read_text(encoding='utf-8'), re.M)
    title = heading[1].replace('`', '') if heading else path.stem
    return title.split(':')[0] if len(title) > LONGEST_TITLE else title


def entries(root, names):
    """Returns the navigation of some pages. The codes of a control and its notes (ID.md, ID-notes.md) share an entry."""
    listed = []
    for name in names:
        notes = name.replace('.md', '-notes.md')
        if notes in names:
            listed.append({title_of(root / name): [{'Codes': name}, {'Notes': notes}]})
        elif name.replace('-notes.md', '.md') not in names or not name.endswith('-notes.md'):
            listed.append({title_of(root / name): name})
    return listed


def on_config(config):
    root = Path(config['docs_dir'])
    named = {name for _, names in ENGLISH + RUSSIAN for name in names}
    config['nav'] = []
    for title, patterns in ENGLISH + RUSSIAN:
        names = []
        for pattern in patterns:
            found = sorted(path.relative_to(root).as_posix() for path in root.glob(pattern))
            names += [name for name in found if name == pattern or (name not in named and name.count('.') == 1)]  # two: NAME.json.md
        if names:
            config['nav'].append({title: entries(root, names)})
    return config


def on_nav(nav, config, files):
    """Splits the navigation by language, so that a reader of Russian pages has Russian tabs."""
    def first_page(item):
        return item if item.is_page else first_page(item.children[0])

    for russian in (False, True):
        items = [item for item in nav.items if is_russian(first_page(item).file.src_path) == russian]
        pages = [page for page in nav.pages if is_russian(page.file.src_path) == russian]
        pages[0].previous_page = pages[-1].next_page = None
        navigations[russian] = Navigation(items, pages)
        navigations[russian].homepage = pages[0]
    return nav


def on_page_context(context, page, config, nav):
    """Shows the page in its own language, with a switch to the same page in the other one, or to that language's first page."""
    source = page.file.src_path
    russian = is_russian(source)
    twin = (source.replace('docs/ru/', 'docs/').replace('README.ru.md', 'README.md') if russian
            else source.replace('docs/', 'docs/ru/', 1) if source.startswith('docs/') else '')
    there = {other.file.src_path: other.url for other in navigations[not russian].pages}
    link = there.get(twin, navigations[not russian].homepage.url)
    config['theme']['language'] = 'ru' if russian else 'en'
    config['extra']['alternate'] = [{'name': name, 'lang': lang, 'link': link if other else page.url}
                                    for name, lang, other in (('English', 'en', russian), ('Русский', 'ru', not russian))]
    context['nav'] = navigations[russian]
    return context


class Elements(HTMLParser):
    """Counts the elements of a text that a reader sees as structure."""

    def __init__(self, html):
        super().__init__()
        self.count = Counter()
        self.feed(html)

    def handle_starttag(self, tag, attrs):
        if tag in COUNTED:
            self.count[tag] += 1


def on_page_content(html, page, config, files):
    """Warns, which ends a strict build, if the site shows other lists, tables or blocks of code than GitHub does."""
    if re.search('^::: ', page.markdown, re.M):  # made by mkdocstrings
        return html
    original = ROOT / page.file.src_path
    text = original.read_text(encoding='utf-8') if original.is_file() else page.markdown
    here, there = Elements(html).count, Elements(MarkdownIt('commonmark').enable('table').render(text)).count
    if here != there:
        log.warning('%s: the site has other elements than GitHub shows: %s', page.file.src_path,
                    ', '.join(f'{tag} {here[tag]} instead of {there[tag]}' for tag in COUNTED if here[tag] != there[tag]))
    return html
