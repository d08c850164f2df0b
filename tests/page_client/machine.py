"""A machine with fast axes, at its panel. Used by tests/panel*.py."""
import time

from page_client.client import expect

FAST = """id = "fast"
tool_change = 0
[axes]
X = {rapid = 60000, limits = [-500, 500], acceleration = 5000, jerk = 1000000}
Y = {rapid = 60000, limits = [-500, 500], acceleration = 5000, jerk = 1000000}
Z = {rapid = 60000, limits = [-500, 500], acceleration = 5000, jerk = 1000000}
"""


def until(page, wanted, seconds=60):
    """Returns the panel once the condition is true; a busy machine is no fault."""
    end = time.monotonic() + seconds
    while True:
        panel = page.ask('panel')
        if wanted(panel) or time.monotonic() > end:
            expect(wanted(panel), f'the panel comes to it: {panel}')
            return panel
        time.sleep(0.005)


def stands(page, mode='standing'):
    return until(page, lambda p: p['mode'] == mode)
