"""Adds to a random program the cycles that cut along straight lines: G90, G92, G94, G74, G75, G76."""
from lathe_twin import lines


def single(p):
    """Adds G90, G92 or G94 with blocks that repeat it."""
    chance, grid = p.chance, p.grid
    code = chance.choice(('G90', 'G92', 'G94'))
    start = (chance.randint(-20, 20) * 100, chance.randint(300, 900) * 200)
    ahead, down = chance.choice((1, -1)), chance.choice((1, -1))
    p.position(*start)
    p.names.append(code)
    end, taper, lead = (0, 0), 0, None
    for number in range(chance.randint(1, 4)):
        words, end, taper = single_words(p, start, end, taper, ahead, down, code, first=number == 0)
        if code == 'G92':
            steps = chance.randint(5, 30) * 100
            if lead is None or chance.random() < 0.2:
                lead = p.mm(steps)
                words += p.word('F', steps)
                p.feed = None
        else:
            words += p.feed_word()
        p.lines.append(f'{code + " " if number == 0 else ""}{words}')
        here, there = grid.mm(*start), grid.mm(*end)
        if code == 'G92':
            run_out = p.parameters.get(5130, 0) * 0.1 * lead
            p.add(lines.threading(here, there, p.mm(taper), run_out, p.parameters.get(5131, 0)), lead=lead)
        else:
            p.add((lines.turning if code == 'G90' else lines.facing)(here, there, p.mm(taper)), p.feed)


def single_words(p, start, end, taper, ahead, down, code, first):
    """Returns the words of a block, its end point and its taper; the first block names all."""
    chance = p.chance
    z = start[0] + ahead * chance.randint(8000, 40000) if first or chance.random() < 0.4 else end[0]
    x = start[1] + down * 2 * chance.randint(200, 6000) if first or z == end[0] or chance.random() < 0.4 else end[1]
    words = p.target('X', 'U', start[1], x) if first or x != end[1] else ''
    words += p.target('Z', 'W', start[0], z) if first or z != end[0] else ''
    words = words or p.word('X', x)                        # only an axis word repeats the cycle
    if chance.random() < (0.4 if first else 0.15):
        most = min(abs(x - start[1]) // 2, abs(z - start[0]), 3000)
        taper = p.signed(0, most)
        words += p.word('R', taper)
    elif not first and abs(taper) > min(abs(x - start[1]) // 2, abs(z - start[0])):
        taper = 0
        words += 'R0. '
    return words, (z, x), taper


# ---- pecks

def pecking(p):
    """Adds G74 or G75."""
    chance, grid = p.chance, p.grid
    along = chance.choice((0, 1))                          # 0: G74
    code = 'G75' if along else 'G74'
    start = (chance.randint(-20, 20) * 100, chance.randint(300, 900) * 200)
    p.position(*start)
    drill = chance.random() < 0.3
    deep, aside = p.signed(20, 200) * 50, p.signed(10, 100) * 50           # true steps
    step = chance.randint(max(1, abs(deep) // 8), abs(deep) * 5 // 4)
    column = chance.randint(max(1, abs(aside) // 5), abs(aside) * 5 // 4)
    relief = 0 if chance.random() < 0.6 else chance.randint(1, 400) if not drill else p.signed(1, 400)
    escape = chance.randint(0, min(step, 500))
    end = (start[0] + deep, start[1] + 2 * aside) if not along else (start[0] + aside, start[1] + 2 * deep)
    write_pecks(p, code, along, drill, start, end, column, step, relief, escape)
    there = list(grid.mm(*end))
    if drill:
        there[1 - along] = None
    made = lines.pecks(grid.mm(*start), tuple(there), p.mm(column), p.mm(step), p.parameters[5139], p.mm(relief), along)
    p.add(made, p.feed)


def write_pecks(p, code, along, drill, start, end, column, step, relief, escape):
    chance = p.chance
    x = '' if drill and not along else p.target('X', 'U', start[1], end[1])
    z = '' if drill and along else p.target('Z', 'W', start[0], end[0])
    in_x, in_z = (step, column) if along else (column, step)
    p.names.append(code)
    if relief >= 0 and chance.random() < 0.25:             # the sign of D is nowhere stated
        p.parameters.setdefault(5139, 0.0)
        i = '' if drill and not along else p.word('I', in_x)
        k = '' if drill and along else p.word('K', in_z)
        d = (p.raw('D', relief) if chance.random() < 0.5 else p.word('D', relief)) if relief else ''
        p.lines.append(f'{code} {x}{z}{i}{k}{d}{p.feed_word()}')
        p.names[-1] += ' in one block'
        return
    if 5139 not in p.parameters or chance.random() < 0.8:
        p.lines.append(f'{code} {p.word("R", escape)}')
        p.parameters[5139] = p.mm(escape)
    i = '' if drill and not along else p.raw('P', in_x)
    k = '' if drill and along else p.raw('Q', in_z)
    r = p.word('R', relief) if relief or chance.random() < 0.3 else ''
    p.lines.append(f'{code} {x}{z}{i}{k}{r}{p.feed_word()}')


# ---- threads

def multiple(p):
    """Adds G76."""
    chance, grid = p.chance, p.grid
    start = (chance.randint(-20, 20) * 100, chance.randint(300, 900) * 200)
    p.position(*start)
    height = chance.randint(20, 250) * 10
    first = chance.randint(height // 8, height)
    end = (start[0] + p.signed(8000, 40000), start[1] + p.signed(1, 1) * 2 * (height + chance.randint(100, 2000)))
    taper = p.signed(1, 500) if chance.random() < 0.3 else 0
    steps = chance.randint(5, 30) * 100
    words = (p.target('X', 'U', start[1], end[1]) + p.target('Z', 'W', start[0], end[0]))
    angle = chance.choice((80, 60, 55, 30, 29, 0))
    if chance.random() < 0.25:
        one_block_thread(p, words, taper, height, first, angle, steps)
        mode = p.thread_mode
    else:
        mode = 1
        if chance.random() < 0.85 or 5142 not in p.parameters or p.parameters.get(5141, 0) >= p.mm(height):
            m, r = chance.randint(1, 4), chance.choice((0, 0, 10, 5, chance.randint(1, 20)))
            least, allowance = chance.randint(0, height // 2), chance.choice((0, chance.randint(1, height // 3)))
            p.lines.append(f'G76 P{m:02}{r:02}{angle:02} {p.raw("Q", least)}{p.word("R", allowance)}')
            p.parameters.update({5142: m, 5130: r, 5143: angle, 5140: p.mm(least), 5141: p.mm(allowance)})
        angle = p.parameters.get(5143, 0)
        if p.parameters[5140] > p.mm(height):
            height = int(p.parameters[5140] / grid.unit) + 1
            end = (end[0], start[1] + (1 if end[1] > start[1] else -1) * 2 * (height + 500))
            words = (p.target('X', 'U', start[1], end[1]) + p.target('Z', 'W', start[0], end[0]))
        p.lines.append(f'G76 {words}{p.word("R", taper) if taper else ""}{p.raw("P", height)}{p.raw("Q", first)}{p.word("F", steps)}')
        p.names.append('G76')
    lead, run_out = p.mm(steps), p.parameters.get(5130, 0) * 0.1 * p.mm(steps)
    made = lines.multiple_thread(grid.mm(*start), grid.mm(*end), p.mm(taper), p.mm(height), p.mm(first), p.parameters.get(5140, 0),
                                 p.parameters.get(5141, 0), int(p.parameters.get(5142, 1) or 1), angle, run_out, p.parameters.get(5131, 0), mode in (3, 4))
    p.add(made, lead=lead)
    p.feed = None


def one_block_thread(p, words, taper, height, first, angle, steps):
    """`G76 X Z I K D F A P`: the smallest depth, allowance and run-out of the parameters."""
    chance = p.chance
    mode = chance.choice((1, 3))
    while p.parameters.get(5140, 0) > p.mm(height) or p.parameters.get(5141, 0) >= p.mm(height):
        p.lines.append('G76 P010000 Q0 R0')
        p.parameters.update({5142: 1, 5130: 0, 5143: 0, 5140: 0, 5141: 0})
    d = p.raw('D', first) if chance.random() < 0.5 else p.word('D', first)
    i = p.word('I', taper) if taper or chance.random() < 0.3 else ''
    p.lines.append(f'G76 {words}{i}{p.word("K", height)}{d}{p.word("F", steps)}A{angle} {f"P{mode}" if mode != 1 or chance.random() < 0.5 else ""}')
    p.names.append('G76 in one block')
    p.thread_mode = mode
