"""Ctrl-C soon ends a long run, and Python remains usable."""
import os
import signal
import threading

import numpy  # noqa: F401  Session.samples imports it: Ctrl-C within that import is numpy's own matter
from cases import raises, run_all

import kadr

ENDLESS = '#1=0\n#2=0\nWHILE[#2EQ0]DO1\n#1=#1+1\nEND1\nM30\n'      # no motion at all: 20,000,000 repeated blocks


def interrupted(call):
    handler = signal.getsignal(signal.SIGINT)
    timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    raises(KeyboardInterrupt, call)     # without an interrupt it would end with the alarm of an endless program
    assert signal.getsignal(signal.SIGINT) is handler


def test_run():
    session = kadr.Session(ENDLESS, control='nct')
    kept = session.snapshot()
    interrupted(session.run)
    assert session.state == 'stopped'
    session.restore(kept)
    interrupted(session.run)


def test_check_plot_samples():
    for call in ('check', 'plot', 'samples'):
        interrupted(getattr(kadr.Session(ENDLESS, control='nct'), call))


def test_a_handler_of_the_program_itself():
    class Mine(Exception):
        pass

    def handler(*_):
        raise Mine

    before = signal.signal(signal.SIGINT, handler)
    try:
        threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT)).start()
        raises(Mine, kadr.Session(ENDLESS, control='nct').run)
    finally:
        signal.signal(signal.SIGINT, before)


run_all(globals())
