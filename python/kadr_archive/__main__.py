"""python3 -m kadr_archive"""
import sys

from kadr_archive.command import main

sys.exit(main())
