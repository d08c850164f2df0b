"""kadr-archive: checks, runs, compares and converts whole archives of part programs (docs/archive.md).

It is built on the module ``kadr`` and on the program ``kadr``; this package only finds the programs, distributes the work and keeps the
results in one SQLite file.
"""
