"""Checks that the examples of python/README.md run and give the results shown there."""
import doctest
import os

from cases import ROOT, run_all

import kadr


def test_readme():
    text = (ROOT / 'python/README.md').read_text(encoding='utf-8')
    test = doctest.DocTestParser().get_doctest(text.replace('```', ''), {'kadr': kadr}, 'README.md', None, 0)
    os.chdir(ROOT)
    said = []
    results = doctest.DocTestRunner(verbose=False).run(test, out=said.append)
    assert results.failed == 0 and results.attempted > 10, ''.join(said)


run_all(globals())
