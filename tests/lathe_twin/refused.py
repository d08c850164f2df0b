"""Random programs of G71 and G72 with one fault in the figure or in the cycle's words, and the alarm that spec/fanuc-t 9.1 to 9.3 and 12
demand; the cycle makes no motion."""
from lathe_twin import programs
from lathe_twin.figures import Frame, Grid, random_figure
from lathe_twin.shapes import EPS

FAULTS = ('main', 'level', 'over', 'first', 'words', 'name', 'corner', 'side', 'depth', 'one_shot')


def random_program(chance):
    """Returns a program and the number of its alarm."""
    fault, grid = chance.choice(FAULTS), Grid(chance.random() < 0.25)
    two_axes = fault not in ('level', 'depth') and chance.random() < 0.4
    main = 'Z' if two_axes or chance.random() < 0.6 else 'X'
    while True:
        frame = Frame(main, chance.choice((1, -1)), chance.choice((1, -1)))
        start = (chance.randint(-20, 20) * 100, chance.randint(300, 900) * 200)
        figure = random_figure(chance, grid, frame, start, two_axes, code=0)
        to_frame, over = frame.into(grid.mm(*start))
        pieces = [piece.mapped(to_frame, over) for piece in figure.pieces]
        if programs.lowest(pieces) >= -EPS and programs.lowest(figure.pieces) > 5 and programs.deepest(pieces) > 0.1:
            break
    p = programs.Program(chance, grid, programs.set_up({}), {})
    p.lines.append('G20' if grid.inch else 'G21')
    p.position(*start)
    alarm = broken(chance, fault, p, frame, figure, start)
    code, depth = ('G71', 'U') if main == 'Z' else ('G72', 'W')
    if fault == 'depth':
        p.lines.append(f'{code} {depth}{chance.choice(("0", "-1."))} R0.1')
    else:
        p.lines.append(f'{code} {p.word(depth, 500)}R0.1')
    ns, nf = p.numbers(figure)
    if fault == 'name':
        nf += 1
    words = f'Q{nf}' if fault == 'words' and chance.random() < 0.5 else f'P{ns}' if fault == 'words' else f'P{ns} Q{nf}'
    p.lines.append(f'{code} {words} U0 W0 {p.feed_word()}')
    p.figure_text(figure)
    p.names.append(f'refused: {fault}')
    return p, alarm


def broken(chance, fault, p, frame, figure, start):
    """Plants the fault in the figure's blocks.  returns the number of the alarm"""
    grid, ahead, down = p.grid, frame.ahead, frame.down
    along, across = ('W', 'U') if frame.main == 'Z' else ('U', 'W')
    step = chance.randint(50, 400) * 2
    numbers = {'main': 64, 'level': 329, 'over': 322, 'first': 65, 'words': 61, 'name': 63, 'corner': 69, 'side': 325, 'depth': 62, 'one_shot': 325}
    if frame.main == 'X':                                  # 0064 is about the first axis of the plane, Z, in both cycles
        numbers |= {'main': 329, 'level': 64}
    if fault == 'main':
        figure.blocks.append(f'G1 {along}{grid.text(-ahead * step)} {across}{grid.text(0)}')
    elif fault == 'level':
        figure.blocks.append(f'G1 {along}{grid.text(ahead * step)} {across}{grid.text(down * step)}')
    elif fault == 'over':
        axis, here = ('X', start[1]) if frame.main == 'Z' else ('Z', start[0])
        figure.blocks.append(f'G1 {axis}{grid.text(here - down * step)}')
    elif fault == 'first':
        figure.blocks[0] = figure.blocks[0].replace('G00 ', 'G0 ').replace('G0 ', 'G2 ') + f'R{grid.text(90000)}'
    elif fault == 'corner':
        figure.blocks.append(f'G1 {along}{grid.text(ahead * step)} ,{chance.choice("CR")}0.01')
    elif fault == 'side':
        figure.blocks.insert(chance.randint(1, len(figure.blocks) - 1), chance.choice(('G42', 'G41', 'G40')))
    elif fault == 'one_shot':
        figure.blocks.insert(chance.randint(1, len(figure.blocks) - 1), chance.choice(('M98 P1', 'G28 U0', 'G20', 'G32 W-1. F1.')))
    return numbers[fault]
