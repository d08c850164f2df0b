"""Tests a session: motions, steps, snapshots, picture, axes over time. tests/library.py describes examples/library/part.nc."""
import tempfile
from math import pi, hypot
from pathlib import Path

import numpy
from cases import PART, raises, run_all

import kadr

ARC = 10 * pi   # mm, half a circle of radius 10


def test_motions():
    rows = kadr.Session(PART, control='nct').run().motions()
    assert rows['line'].tolist() == [4, 5, 6, 8, 9] and rows['block'].tolist() == [20, 30, 40, 60, 70]
    assert rows['kind'].tolist() == [kadr.Kind.RAPID] + [kadr.Kind.FEED] * 3 + [kadr.Kind.ARC_CW]
    assert rows['tool'].tolist() == [1, 1, 1, 2, 2]
    assert rows['to'].tolist() == [[0, 0, 0], [30, 0, 0], [30, 40, 0], [0, 0, 0], [20, 0, 0]]
    assert (rows['start'][1:] == rows['to'][:-1]).all()
    assert numpy.allclose(rows['length'], [0, 30, 40, 50, ARC]) and numpy.allclose(rows['seconds'], [0, 3, 4, 10, ARC / 5])
    assert rows['feed'].tolist() == [0, 600, 600, 300, 300]
    assert rows['center'][4].tolist() == [10, 0] and rows['turns'][4] == 0.5


def test_machine_coordinates():
    session = kadr.Session('%\nG54 G0 X1 Y2 Z3\nM30\n%\n', setup={'work_offsets': {'G54': {'X': 100, 'Y': -50}}}, control='nct').run()
    assert session.motions()['machine_to'][-1].tolist() == [101, -48, 3]
    assert session.position == {'X': 1, 'Y': 2, 'Z': 3} and session.machine_position == {'X': 101, 'Y': -48, 'Z': 3}


def test_steps():
    session = kadr.Session(PART, control='nct')
    assert session.state == 'running' and session.next is None
    seen = [(block.line, block.block, session.position['X'], session.position['Y']) for block in session if block.block]
    assert seen == [(3, 10, 0, 0), (4, 20, 0, 0), (5, 30, 30, 0), (6, 40, 30, 40), (7, 50, 30, 40), (8, 60, 0, 0), (9, 70, 20, 0), (10, 80, 20, 0)], seen
    assert session.state == 'ended' and session.step() is None
    assert session.motions().tobytes() == kadr.Session(PART, control='nct').run().motions().tobytes()


def test_calls_have_depth():
    session = kadr.Session('O0001\nM98 P0002\nM30\nO0002\nG0 X1\nM99\n', control='nct')
    assert [(block.line, block.depth) for block in session if block.line == 5] == [(5, 1)]


def test_snapshot_goes_on_as_if_never_stopped():
    whole = kadr.Session(PART, control='nct').run()
    session = kadr.Session(PART, control='nct')
    while session.step().line < 5:
        pass
    kept = session.snapshot()
    fork = session.fork()
    assert session.run().motions().tobytes() == whole.motions().tobytes() and session.seconds == whole.seconds
    for _ in range(2):
        session.restore(kept)
        assert session.next.line == 6 and session.position == {'X': 30, 'Y': 0, 'Z': 0} and len(session.motions()) == 2
        assert session.step().line == 6 and session.position['Y'] == 40
    assert fork.next.line == 6 and fork.run().motions().tobytes() == whole.motions().tobytes()
    other = kadr.Session(PART, control='nct')
    raises(kadr.Error, lambda: other.restore(kept), 'another program')


def test_many_motions_and_their_snapshots():
    lines = [f'X{i}' for i in range(1, 3001)]
    session = kadr.Session('G1 F100\n' + '\n'.join(lines) + '\nM30\n', control='nct')
    kept = []
    for block in session:
        if block.line in (1024, 1025, 1026, 2500):
            kept.append((session.snapshot(), len(session.motions())))
    whole = session.motions()
    assert whole['to'][:, 0].tolist() == list(range(1, 3001))
    for snapshot, count in reversed(kept):
        session.restore(snapshot)
        assert (session.motions()['to'][:, 0] == numpy.arange(1, count + 1)).all()
        assert session.run().motions().tobytes() == whole.tobytes()


def test_expressions_and_variables():
    session = kadr.Session('#100=7\n#101=#100*2\nM30\n', control='nct')
    session.step(), session.step()
    assert session.evaluate('#100+#101/2') == 14 and session.variables['#101'] == 14
    raises(kadr.Alarm, lambda: session.evaluate('#100+'))


def test_a_picture():
    session = kadr.Session(PART, control='nct')
    picture = session.plot()
    assert isinstance(picture, str) and picture.lstrip().startswith(('<?xml', '<svg')) and '</svg>' in picture
    assert picture._repr_svg_() == session._repr_svg_() == str(picture)
    assert session.png().startswith(b'\x89PNG') and session.state == 'running'
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / 'picture.svg'
        picture.save(str(path))
        assert path.read_text(encoding='utf-8') == picture


def test_axes_in_time():
    session = kadr.Session(PART, control='nct')
    rows = session.samples(rate=100)
    assert rows.dtype.names == ('t', 'X', 'Y', 'Z') and rows['t'][0] == 0
    assert numpy.allclose(numpy.diff(rows['t'])[:-1], 0.01) and numpy.allclose([rows[axis][-1] for axis in 'XYZ'], [20, 0, 0], atol=1e-6)
    speed = numpy.hypot(numpy.diff(rows['X']), numpy.diff(rows['Y']))[:-1] / 0.01
    assert 9.9 < speed.max() < 10.001                                            # F600
    planned = session.planned()
    assert planned.tool_change == 20 and planned.cutting > 7 + (50 + ARC) / 5    # two tool changes of 10 s (machine generic)
    assert abs(planned.total - rows['t'][-1]) < 0.02
    assert hypot(rows['X'].max() - 30, rows['Y'].max() - 40) < 0.02
    raises(kadr.Alarm, lambda: session.samples(max_seconds=1), 'samples_too_long')


def test_other_controls():
    assert kadr.controls() == sorted(kadr.controls()) and {'linuxcnc', 's2c42'} < set(kadr.controls()) and 'generic' in kadr.machines()
    own = kadr.Session(PART.parent / 'own.nc', control=str(PART.parent / 'own.toml')).run()
    assert own.control == 'ours' and own.seconds == 1.5
    guessed = kadr.Session(PART.parent.parent / 's2c42/flange.nc', control=None, setup=PART.parent.parent / 's2c42/flange.json').run()
    assert guessed.control == 's2c42' and len(guessed.motions()) == 178          # README.md


run_all(globals())
