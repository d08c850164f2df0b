"""Runs the functions test_… of a file and prints `passed NAME` or `failed NAME: why` for each, then `done`."""
import sys
import traceback
from pathlib import Path

ROOT = Path(sys.argv[1])
PART = ROOT / 'examples/library/part.nc'


def raises(kind, call, *pieces):
    """Checks that the call raises this exception, with these parts in its text."""
    try:
        call()
    except kind as error:
        missing = [piece for piece in pieces if piece not in str(error)]
        assert not missing, f'{error!r} does not say {missing}'
        return error
    raise AssertionError(f'no {kind.__name__}')


def run_all(names):
    for name, test in list(names.items()):
        if not name.startswith('test_'):
            continue
        try:
            test()
            print('passed', name)
        except Exception:
            print('failed', name + ':', ' | '.join(traceback.format_exc().splitlines()[-4:]))
    print('done')
