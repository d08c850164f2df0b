"""The build backend: setuptools, also the system's where pip hides it (Debian: python3-setuptools, python3-wheel)."""
import sys

DEBIAN = '/usr/lib/python3/dist-packages'
try:
    import setuptools.build_meta
except ImportError:
    sys.path.append(DEBIAN)
    import setuptools.build_meta
try:
    import wheel                     # noqa: F401
except ImportError:
    sys.path.append(DEBIAN)
from setuptools.build_meta import *  # noqa: E402,F401,F403


def get_requires_for_build_wheel(config_settings=None):
    """Returns no requirements, so that pip fetches nothing: setuptools would request wheel, which is installed already."""
    return []
