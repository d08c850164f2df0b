"""The programs that bench/optimality plans: (name, blocks) pairs in RS-274, lengths in mm. They are the same in every run."""
import math


def line(x=None, y=None, z=None):
    return 'G1 ' + ' '.join(f'{letter}{value:.4f}' for letter, value in zip('XYZ', (x, y, z)) if value is not None)


def surface():
    """A freeform surface, machined back and forth in rows of 0.5 mm segments."""
    yield 'G0 X-5'
    for row in range(8):
        y = row * 0.5
        steps = range(61) if row % 2 == 0 else range(60, -1, -1)
        for i in steps:
            x = i * 0.5
            yield line(x, y, 2 * math.sin(0.3 * x + 0.4 * y) + 0.7 * math.cos(0.9 * x - 0.2 * y))


LETTERS = {  # strokes: lists of points; 'ccw' or 'cw' with a radius before a point is an arc that ends there; 4 wide, 6 high
    'K': [[(0, 0), (0, 6)], [(4, 6), (0, 2)], [(1.333, 3.333), (4, 0)]],
    'A': [[(0, 0), (2, 6), (4, 0)], [(0.667, 2), (3.333, 2)]],
    'D': [[(0, 0), (0, 6), (1, 6), ('cw', 3), (4, 3), ('cw', 3), (1, 0), (0, 0)]],
    'R': [[(0, 0), (0, 6), (2.5, 6), ('cw', 1.5), (2.5, 3), (0, 3)], [(2, 3), (4, 0)]],
    'S': [[(4, 5), ('ccw', 1.2), (3, 6), (1.5, 6), ('ccw', 1.5), (1.5, 3), (2.5, 3), ('cw', 1.5), (2.5, 0), (1, 0), ('cw', 1.2), (0, 1)]],
    'O': [[(2, 6), ('ccw', 2), (0, 4), (0, 2), ('ccw', 2), (2, 0), ('ccw', 2), (4, 2), (4, 4), ('ccw', 2), (2, 6)]],
    '3': [[(0, 5), ('cw', 1.5), (2, 6), ('cw', 1.5), (2, 3), ('cw', 1.5), (2, 0), ('cw', 1.5), (0, 1)]],
}


def engraving():
    yield 'G0 X5'
    yield 'G0 Y-5'
    for row, text in enumerate(('KADR', 'ROADS', '3D3SK', 'SOAR3')):
        for column, letter in enumerate(text):
            for stroke in LETTERS[letter]:
                yield from stroked([step if isinstance(step[0], str) else (step[0] + 5.5 * column, step[1] - 8 * row) for step in stroke])


def stroked(stroke):
    yield f'G0 X{stroke[0][0]:.3f} Y{stroke[0][1]:.3f}'
    yield line(z=-0.2)
    arc = None
    for step in stroke[1:]:
        if isinstance(step[0], str):
            arc = step
        elif arc:
            yield f'{"G2" if arc[0] == "cw" else "G3"} X{step[0]:.3f} Y{step[1]:.3f} R{arc[1]}'
            arc = None
        else:
            yield line(*step)
    yield 'G0 Z1'


def pocket():
    """Rings of rounded rectangles, from the inside outwards."""
    yield line(0, 0)
    for ring in range(1, 25):
        x, y, r = 8 + ring, 3 + ring, 0.5 + 0.4 * ring
        yield line(x - r, -y)
        yield f'G3 X{x:.3f} Y{-y + r:.3f} R{r:.3f}'
        yield line(x, y - r)
        yield f'G3 X{x - r:.3f} Y{y:.3f} R{r:.3f}'
        yield line(-x + r, y)
        yield f'G3 X{-x:.3f} Y{y - r:.3f} R{r:.3f}'
        yield line(-x, -y + r)
        yield f'G3 X{-x + r:.3f} Y{-y:.3f} R{r:.3f}'
        yield line(0, -y)


def circles():
    """Full circles of several radii, as on a plate with bores."""
    for row in range(3):
        for column, r in enumerate((0.5, 1, 2, 3, 5, 8, 12)):
            yield f'G0 X{column * 25 + r:.3f} Y{row * 25}'
            yield line(z=-1)
            yield f'G3 I{-r} J0'
            yield f'G3 I{-r} J0'
            yield 'G0 Z1'


def spiral():
    """An Archimedean spiral of short line segments."""
    for i in range(541):
        angle = math.radians(6 * i)
        r = 0.5 + 1.5 * angle / (2 * math.pi)
        yield line(r * math.cos(angle), r * math.sin(angle))


def zigzag():
    """Parallel passes 20 mm long, 0.6 mm apart."""
    for i in range(90):
        yield line(0 if i % 2 == 0 else 20, i * 0.6)
        yield line(20 if i % 2 == 0 else 0, i * 0.6)


PROGRAMS = [surface, engraving, pocket, circles, spiral, zigzag]


def text_of(program, feed):
    """Returns the text of a program; `feed` is in mm/min."""
    return '\n'.join([f'G21 G90 G17 G91.1 G64 P0.01 F{feed}', 'G0 Z1', *program(), 'M30', ''])
