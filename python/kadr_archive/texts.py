"""What people read on the terminal and in the report, in English and Russian."""
from __future__ import annotations

import difflib
import os
from typing import Iterable

LANGUAGE = 'en'
ALL: dict[str, tuple[str, str]] = {
    'what': ('Checks, runs, compares and converts archives of part programs.', 'Проверяет, исполняет, сравнивает и переводит архивы управляющих программ.'),
    'check_help': ('checks all programs as kadr check does', 'проверяет все программы, как kadr check'),
    'run_help': ('runs all programs as kadr run does: times, tools, extents', 'исполняет все программы, как kadr run: времена, инструменты, габариты'),
    'convert_help': ('converts all programs as kadr convert does, with proof', 'переводит все программы, как kadr convert, с доказательством'),
    'cut_help': ('cuts a program as kadr cut does, by windows in several processes', 'обрабатывает по УП заготовку, как kadr cut, по окнам в нескольких процессах'),
    'cut_others': ('All other options are those of kadr cut.', 'Остальные ключи — те же, что у kadr cut.'),
    'windows': ('into how many windows the blank is divided; default: two for each worker', 'на сколько окон делится заготовка; по умолчанию два на процесс'),
    'temporary': ('folder for the files of the windows, seen by all workers; default: that of --out', 'папка для файлов окон, видимая всем узлам; по умолчанию папка --out'),
    'window_limits': ('--windows and --workers are above 0', '--windows и --workers больше 0'),
    'window_killed': ('kadr-archive: the process of window {} of {} was killed twice: too little memory?', 'kadr-archive: процесс окна {} из {} убит дважды: мало памяти?'),
    'cut_interrupted': ('kadr-archive: interrupted; nothing is kept', 'kadr-archive: прервано; ничего не сохранено'),
    'diff_help': ('compares two states of the archive', 'сравнивает два состояния архива'),
    'report_help': ('writes a report in HTML', 'пишет отчёт в HTML'),
    'csv_help': ('writes results as CSV', 'пишет результаты в CSV'),
    'runs_help': ('lists the runs that the file remembers', 'перечисляет прогоны, которые помнит файл'),
    'sources': ('folders, zip files, and text files with a path in each line', 'папки, файлы zip и текстовые файлы с путём в каждой строке'),
    'db': ('file of the results (SQLite); created if it is missing', 'файл результатов (SQLite); создаётся, если его нет'),
    'control': ('control of all programs; default: .kadr.toml, else guessed from each text', 'УЧПУ всех программ; иначе .kadr.toml или угадывается по тексту'),
    'control_for': ('control of the programs that match a pattern', 'УЧПУ программ, подходящих под образец'),
    'exclude': ('passes over the files that match the pattern', 'пропускает файлы, подходящие под образец'),
    'machine': ('machine profile, as for kadr run', 'описание станка, как у kadr run'),
    'setup': ('state before the start, as for kadr run', 'состояние перед пуском, как у kadr run'),
    'strict': ('a warning counts as an error', 'предупреждение считается ошибкой'),
    'again': ('tries programs again that exceeded a limit or were quarantined', 'снова пробует программы, превысившие предел или изолированные'),
    'workers': ('processes on this computer', 'число процессов на этом компьютере'),
    'scheduler': ('address of a Dask scheduler, tcp://HOST:PORT', 'адрес планировщика Dask, tcp://УЗЕЛ:ПОРТ'),
    'scheduler_file': ('file that the Dask scheduler has written', 'файл, записанный планировщиком Dask'),
    'by_content': ('the workers do not see the files: programs are sent by their content', 'узлы не видят файлов: программы передаются содержимым'),
    'most_seconds': ('limit for each program, s', 'предел времени на программу, с'),
    'most_memory': ('limit for each process, MB', 'предел памяти на процесс, МБ'),
    'quiet': ('no progress bar and no totals', 'без хода работы и без итогов'),
    'to': ('the other control', 'другое УЧПУ'),
    'out_folder': ('folder for the new programs, in the same sub-folders', 'папка для новых программ, с теми же вложенными папками'),
    'diff_from': ('the earlier run; default: the last but one', 'прежний прогон; по умолчанию предпоследний'),
    'diff_to': ('the later run; default: the last', 'новый прогон; по умолчанию последний'),
    'report_out': ('folder for the report', 'папка отчёта'),
    'which_run': ('the run; default: the last', 'прогон; по умолчанию последний'),
    'rows': ('programs that the report lists in each table, each with its own page', 'сколько программ перечисляет каждая таблица отчёта, каждую со своей страницей'),
    'csv_out': ('the file; default: standard output', 'файл; по умолчанию стандартный вывод'),
    'lang': ('language of messages and of the report', 'язык сообщений и отчёта'),
    'no_control': ('{}: no control has this id', '{}: нет УЧПУ с таким именем'),
    'no_machine': ('{}: no machine has this id', '{}: нет станка с таким именем'),
    'meant': ('meant: {}?', 'может быть, {}?'),
    'no_json': ('{}: no JSON: {}', '{}: не JSON: {}'),
    'limits': ('--workers, --most-seconds and --most-memory are above 0', '--workers, --most-seconds и --most-memory больше 0'),
    'interrupted': ('kadr-archive: interrupted; what is done is kept, and the next run goes on from there',
                    'kadr-archive: прервано; сделанное сохранено, следующий прогон продолжит'),
    'package': ('install the packages that docs/archive.md names', 'установите пакеты, названные в docs/archive.md'),
    'totals': ('programs: {}, worked on now: {}', 'программ: {}, обработано сейчас: {}'),
    'ok': ('without errors', 'без ошибок'),
    'warned': ('of these with warnings', 'из них с предупреждениями'),
    'alarm': ('with errors', 'с ошибками'),
    'ok_convert': ('converted and proven', 'переведено и доказано'),
    'alarm_convert': ('not converted', 'не переведено'),
    'unknown': ('of no known control', 'неизвестного УЧПУ'),
    'refused': ('refused', 'отклонено'),
    'time': ('over the time limit', 'превысили предел времени'),
    'memory': ('over the memory limit', 'превысили предел памяти'),
    'killed': ('quarantined', 'изолировано'),
    'unreadable': ('unreadable', 'не читается'),
    'undone': ('not done', 'не сделано'),
    'no_run': ('no run is stored', 'нет ни одного прогона'),
    'no_such_run': ('no run {}', 'нет прогона {}'),
    'no_run_before': ('no complete run of the same kind and sources before run {}', 'до прогона {} нет полного прогона того же вида с теми же источниками'),
    'cut_off': ('interrupted', 'прерван'),
    'missing': ('missing now', 'больше нет'),
    'new': ('new', 'новая'),
    'text_differs': ('text differs', 'текст изменён'),
    'differences': ('programs that differ: {} (runs {} and {})', 'различаются программ: {} (прогоны {} и {})'),
    'page_title': ('Archive of programs', 'Архив программ'),
    'state': ('result', 'результат'),
    'finding': ('finding', 'замечание'),
    'control_is': ('control', 'УЧПУ'),
    'tool': ('tool', 'инструмент'),
    'machine_is': ('machine', 'станок'),
    'programs': ('programs', 'программ'),
    'program': ('program', 'программа'),
    'severity': ('kind', 'вид'),
    'severity_alarm': ('error', 'ошибка'),
    'severity_warning': ('warning', 'предупреждение'),
    'severity_advice': ('advice', 'совет'),
    'severity_note': ('note', 'примечание'),
    'times': ('times', 'раз'),
    'cutting_time': ('cutting', 'резание'),
    'machining_time': ('machining time', 'машинное время'),
    'size': ('size', 'размер'),
    'first_finding': ('first finding', 'первое замечание'),
    'shown_of': ('{} of {} are listed', 'показано {} из {}'),
    'by_state': ('By result', 'По результату'),
    'by_finding': ('By finding', 'По замечаниям'),
    'by_control': ('By control', 'По УЧПУ'),
    'by_tool': ('By tool', 'По инструментам'),
    'by_machine': ('By machine', 'По станкам'),
    'no_tools': ('Times and tools appear after kadr-archive run.', 'Времена и инструменты появятся после kadr-archive run.'),
    'none_found': ('none', 'нет'),
    'no_page': ('The page of this program could not be made: {}', 'Страницу этой программы сделать не удалось: {}'),
    'overview': ('Overview', 'Обзор'),
    'sources_are': ('Sources', 'Источники'),
    'made_by': ('Kadr {}, run {} of {}', 'Kadr {}, прогон {} от {}'),
    'report_made': ('{}: pages of programs: {}, made now: {}', '{}: страниц программ: {}, сделано сейчас: {}'),
    'bar_finding': ('finding', 'поиск'),
    'bar_check': ('checking', 'проверка'),
    'bar_run': ('running', 'исполнение'),
    'bar_convert': ('converting', 'перевод'),
    'bar_cut': ('cutting', 'обработка'),
    'bar_pages': ('pages', 'страницы'),
}


def choose(words: list[str]) -> None:
    """Sets the language: --lang, else LANG, as the program kadr does."""
    global LANGUAGE
    given = next((b for a, b in zip(words, words[1:]) if a == '--lang'), None) or next((w[7:] for w in words if w.startswith('--lang=')), None)
    environment = os.environ.get('LC_ALL') or os.environ.get('LC_MESSAGES') or os.environ.get('LANG') or ''
    LANGUAGE = given if given in ('en', 'ru') else 'ru' if environment.startswith('ru') else 'en'


def state(name: str, what: str) -> str:
    """Returns the words for the state of a result of `check`, `run` or `convert`."""
    return of(f'{name}_{what}' if f'{name}_{what}' in ALL else name)


def reason(error: BaseException) -> str:
    """Returns the sentence about an error: of the operating system without its number, the file first."""
    name, text = getattr(error, 'filename', None), getattr(error, 'strerror', None)
    return f'{os.fsdecode(name)}: {text[0].lower()}{text[1:]}' if name and text else str(error)


def like(wrong: str, right: Iterable[str]) -> str:
    """Returns the right word that a wrong one resembles, in brackets; empty if it resembles none."""
    near = difflib.get_close_matches(wrong, list(right), 1)
    return f' ({of("meant").format(near[0])})' if near else ''


def of(key: str) -> str:
    return ALL[key][LANGUAGE == 'ru']
