"""Faults raise exceptions that describe them."""
import threading
import time

from cases import PART, raises, run_all

import kadr

FAULTY = '%\nN10 G0 X5\nN20 G1 X10 F100 Q\nN30 X20 R\nN40 M30\n%\n'   # Q, R without numbers


def test_an_alarm():
    session = kadr.Session(FAULTY, control='nct')
    alarm = raises(kadr.Alarm, session.run, '<text>:3:17: alarm number_missing: No number after address Q')
    assert (alarm.id, alarm.line, alarm.column, alarm.finding.block, alarm.finding.line_text) == ('number_missing', 3, 17, 'N20', 'N20 G1 X10 F100 Q')
    assert isinstance(alarm, kadr.Error) and alarm.hint and alarm.text == 'No number after address Q'
    assert session.state == 'stopped' and session.position['X'] == 5 and len(session.motions()) == 1
    raises(kadr.Alarm, session.run, 'number_missing')
    stepped = kadr.Session(FAULTY, control='nct')
    assert stepped.step().line == 2
    raises(kadr.Alarm, stepped.step, 'number_missing')


def test_check_finds_all():
    session = kadr.Session(FAULTY, lang='ru', control='nct')
    found = session.check()
    assert [(f.line, f.id, f.severity) for f in found] == [(3, 'number_missing', 'alarm'), (4, 'number_missing', 'alarm')]
    assert 'Q' in found[0].text and any('а' <= letter <= 'я' for letter in found[0].text) and session.state == 'running'
    assert kadr.Session(PART, control='nct').check() == []


def test_warnings_are_kept():
    session = kadr.Session('N10 G0 Х5\nN20 M30\n'.encode(), control='nct').run()   # a Cyrillic Х
    assert [warning.id for warning in session.warnings] == ['look_alike_letter']


def test_a_picture_of_a_stopped_program():
    assert '</svg>' in kadr.Session(FAULTY, control='nct').plot()
    raises(kadr.Alarm, lambda: kadr.Session(FAULTY, control='nct').samples(), 'number_missing')


def test_files():
    error = raises(FileNotFoundError, lambda: kadr.Session('none.nc', control='nct'), 'none.nc')
    assert error.filename == 'none.nc'
    raises(IsADirectoryError, lambda: kadr.Session('/tmp', control='nct'))
    raises(kadr.Error, lambda: kadr.Session(PART, setup='none.json', control='nct'), 'none.json')
    raises(kadr.Error, lambda: kadr.Session(PART, control='none.toml'), 'none.toml')


def test_wrong_arguments():
    raises(kadr.Error, lambda: kadr.Session(PART, control='nctt'), "'nctt'", 'nct')
    raises(kadr.Error, lambda: kadr.Session(PART, machine='none', control='nct'), "'none'", 'generic')
    raises(kadr.Error, lambda: kadr.Session(PART, setup={'zeros': 1}, control='nct'), 'zeros')
    raises(kadr.Error, lambda: kadr.Session('Liebe Grüße\nan alle\n', control=None), 'unknown control')
    raises(ValueError, lambda: kadr.Session(PART, setup={'feed': float('nan')}, control='nct'))
    raises(ValueError, lambda: kadr.Session(PART, lang='de', control='nct'), 'de')
    raises(TypeError, lambda: kadr.Session(3, control='nct'), 'int')
    raises(TypeError, lambda: kadr.Session(PART, setup=[1], control='nct'), 'list')
    for rate in (0, -1, float('nan'), 1e9):
        raises(ValueError, lambda: kadr.Session(PART, control='nct').samples(rate=rate), 'rate')


def test_too_many_motions():
    raises(kadr.Error, kadr.Session(PART, max_motions=3, control='nct').run, 'more than 3 motions')
    assert len(kadr.Session(PART, max_motions=5, control='nct').run().motions()) == 5


def test_a_session_is_of_one_thread():
    endless = kadr.Session('#1=0\n#2=0\nG1 F100\nWHILE[#2EQ0]DO1\n#1=#1+1\nX1\nX0\nEND1\nM30\n', max_motions=300_000, control='nct')
    ends = []

    def run():
        try:
            endless.run()
        except kadr.Error as error:
            ends.append(str(error))

    thread = threading.Thread(target=run)
    thread.start()
    turns, refused = 0, False
    while thread.is_alive():      # the interpreter lock is free meanwhile
        turns += 1
        if not refused:
            try:
                endless.snapshot()
            except kadr.Error as error:
                refused = 'another thread' in str(error)
        time.sleep(0.001)
    assert ends == ['more than 300000 motions: max_motions'] and turns > 3 and refused, (ends, turns, refused)


run_all(globals())
