"""CMake builds the extension from the source tree that contains this folder.

Environment: KADR_BUILD names a build folder of Kadr to build in (quick if Kadr is already built there); by default a temporary folder is
used and removed. JOBS: how many compilers run in parallel.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent


def version():
    """Returns the version that CMakeLists.txt states."""
    lists = ROOT / 'CMakeLists.txt'
    found = lists.is_file() and re.search(r'^project\(kadr VERSION (\S+)', lists.read_text(), re.M)
    if not found:
        sys.exit(f'{ROOT} is not the source tree of Kadr: the folder python/ is built where it stands')
    return found[1]


class BuildByCMake(build_ext):
    """Builds the CMake target kadr_python."""

    def build_extension(self, ext):
        named = os.environ.get('KADR_BUILD')
        folder = Path(named).resolve() if named else Path(self.build_temp).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        options = [f'-DPython_EXECUTABLE={sys.executable}', '-DKADR_PYTHON=ON']
        if not (folder / 'CMakeCache.txt').is_file():
            options += ['-DCMAKE_BUILD_TYPE=Release', '-DKADR_PROGRAM=OFF', '-DKADR_TESTS=OFF']
            if shutil.which('ninja'):
                options += ['-G', 'Ninja']
        else:
            options = ['-DKADR_PYTHON=ON']   # keeps the folder's own configuration
        jobs = os.environ.get('JOBS', str(os.cpu_count() or 1))
        subprocess.run(['cmake', '-S', ROOT, '-B', folder, *options], check=True)
        subprocess.run(['cmake', '--build', folder, '--target', 'kadr_python', '--parallel', jobs], check=True)
        made = list((folder / 'python/kadr').glob('_kadr*.so'))
        if len(made) != 1:
            sys.exit(f'{folder}/python/kadr: {len(made)} extensions, not 1')
        to = Path(self.get_ext_fullpath(ext.name))
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(made[0], to)


# intermediate files of setuptools are kept out of the source tree
way = tempfile.TemporaryDirectory()
setup(options={'build': {'build_base': way.name}, 'egg_info': {'egg_base': way.name}}, version=version(), ext_modules=[Extension('kadr._kadr', [])], cmdclass={'build_ext': BuildByCMake})
