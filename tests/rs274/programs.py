"""Random LinuxCNC programs, by topic. Most blocks are valid; some programs end with an invalid one. What rs274's stub does not know
(tests/rs274/oracle.py) does not occur: no tool change, no probe, no input."""
import random

SYSTEMS = ['G54', 'G55', 'G56', 'G57', 'G58', 'G59', 'G59.1', 'G59.2', 'G59.3']
FAULTY = ['G1 X', 'G2 X5 Y5', 'G1 X1 X2', 'G0 G1 X1', 'G81 X1 Z-1', 'G53 X1 G91', 'X1 G80', 'F-1', 'S-5', 'T-1', 'G4', 'G10 L3 P1 X0', 'G43 H77',
          'M3 M4', 'G92', 'G2 X1 I1 R2', 'G17 G2 X1 K1', 'P5', 'L2', 'Q3', 'R1', '#9000=1', '#5400=1', 'G1 X#<none>', 'G1 X[1/0]', 'G1 X[SQRT[-1]]',
          'G1 X[1 FOO 2]', 'G1 X[1+', 'M200', 'G1.05', 'G500', '%5', 'O1 endif', 'O1 call', 'G93 G1 X5', 'G95 G1 X5 F1',
          'G33 X1', 'G33 X1 K1', 'G2 X9 Y9 R1', 'G3 X1 Y1 I0 J0', 'G28.1 G1', 'G52', 'G18 @5', '@5 X1', 'G5 X1 Y1 I1', 'G5.3', 'G5.1 X1 Y1']


class Program:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.lines = []
        self.labels = 100

    def number(self, most=50):
        r = self.random
        value = r.choice([r.uniform(-most, most), float(r.randint(-most, most)), 0.0])
        text = f'{value:.{r.choice([0, 1, 3, 4])}f}'
        return r.choice([text, text, f'[{text}+0]', f'[{text}*2/2]', f'-[{-float(text)}]'])

    def chance(self, part):
        return self.random.random() < part

    def words(self, letters, most=50, least=1):
        chosen = [c for c in letters if self.chance(0.6)] or list(self.random.sample(letters, least))
        return ' '.join(c + self.number(most) for c in chosen)

    def add(self, line):
        self.lines.append(line)

    # ---- blocks
    def straight(self):
        self.add(f'{self.random.choice(["G0", "G1", "G1", ""])} {self.words("XYZ" + ("AB" if self.chance(0.1) else ""))}'.strip())

    def arc(self):
        r = self.random
        plane = r.choice(['G17', 'G18', 'G19'])
        axes, centers, third = {'G17': ('XY', 'IJ', 'Z'), 'G18': ('ZX', 'KI', 'Y'), 'G19': ('YZ', 'JK', 'X')}[plane]
        helix = f' {third}{self.number(10)}' if self.chance(0.3) else ''
        turns = f' P{r.randint(1, 3)}' if self.chance(0.2) else ''
        sense = r.choice(['G2', 'G3'])
        self.add(plane)
        if self.chance(0.5):                              # a full circle, or an arc with given ends
            self.add(f'{sense} {centers[0]}{r.randint(1, 9)} {centers[1]}{r.randint(-9, 9)}{helix}{turns}')
        else:
            x, y = r.randint(-20, 20), r.randint(-20, 20)
            radius = r.choice([60, -60, 75.5, -90.25])
            self.add(f'G90 G0 {axes[0]}{x} {axes[1]}{y}')
            self.add(f'{sense} {axes[0]}{x + r.randint(1, 30)} {axes[1]}{y + r.randint(-30, 30)} R{radius}{helix}{turns}')
        self.add('G17')

    def mode(self):
        r = self.random
        self.add(r.choice(['G90', 'G91', 'G20', 'G21', 'G17', f'F{r.randint(50, 900)}', f'S{r.randint(100, 3000)}', 'G98', 'G99', 'G61', 'G64 P0.01',
                           'M3', 'M5', 'M8', 'M9', 'G4 P0.5', 'G94 F300', f'T{r.randint(0, 3)}', 'M48', 'M49', 'G90.1', 'G91.1']))
        if self.lines[-1].startswith('G90.1'):
            self.add('G91.1')

    def system(self):
        r = self.random
        self.add(r.choice([r.choice(SYSTEMS), f'G10 L2 P{r.randint(0, 9)} {self.words("XYZ", 20)}', f'G10 L2 P{r.randint(1, 9)} R{r.randint(-180, 180)}',
                           f'G10 L20 P{r.randint(0, 9)} {self.words("XYZ", 20)}', f'G92 {self.words("XYZ", 20)}', 'G92.1', 'G92.2', 'G92.3',
                           f'G52 {self.words("XY", 20)}', f'G43.1 Z{r.randint(-20, 20)}', 'G49', 'G28.1', 'G30.1', f'G28 {self.words("XYZ", 20)}', 'G30',
                           f'G53 G0 {self.words("XYZ", 20)}' if self.chance(0.5) else 'G54']))
        if 'G53' in self.lines[-1]:
            self.lines.insert(-1, 'G90')

    def cycle(self):
        r = self.random
        code = r.choice(['G81', 'G82 P0.2', 'G83 Q1.3', 'G73 Q0.9', 'G85', 'G89 P0.1', 'G86 P0.1', 'G84', 'G74'])
        self.add('M4' if code == 'G74' else 'M3')
        self.add(r.choice(['G98', 'G99']))
        count = f' L{r.randint(1, 3)}' if self.chance(0.3) and code != 'G74' else ''
        self.add(f'G90 G0 Z{r.randint(3, 12)}')
        self.add(f'{code} X{self.number(30)} Y{self.number(30)} Z{-r.randint(1, 5)} R{r.randint(0, 5)}{count}')
        for _ in range(r.randint(0, 3)):
            self.add(self.words('XY', 30) + (f' R{r.randint(0, 5)}' if self.chance(0.2) else '') + (f' Z{-r.randint(1, 5)}' if self.chance(0.2) else ''))
        self.add('G80')

    def polar(self):
        r = self.random
        self.add(f'G0 X{r.randint(1, 9)} Y{r.randint(1, 9)}')
        self.add(f'{r.choice(["G0", "G1"])} {r.choice([f"@{r.randint(1, 30)} ^{r.randint(-180, 180)}", f"^{r.randint(-90, 90)}", f"@{r.randint(1, 9)}"])}')

    def spline(self):
        r = self.random
        self.add('G90')
        self.add(r.choice([f'G5 X{r.randint(1, 20)} Y{r.randint(1, 20)} I1 J{r.randint(1, 5)} P-1 Q{r.randint(-5, -1)}',
                           f'G5.1 X{r.randint(1, 20)} Y{r.randint(1, 20)} I{r.randint(1, 5)} J{r.randint(1, 5)}']))
        self.add(f'G1 X{r.randint(21, 30)} Y0')

    def variable(self):
        r = self.random
        name = r.choice(['#1', '#31', '#100', '#<a>', '#<_common>'])
        self.add(f'{name}={self.number(20)}')
        self.add(f'G1 X{name} Y[{name}*{r.choice(["2", "0.5", "-1"])}+{r.randint(0, 9)}] Z[{r.choice(["SIN", "COS", "ABS", "FIX", "FUP", "ROUND"])}[{name}]]')

    def loop(self):
        r = self.random
        self.labels += 1
        o, n = f'O{self.labels}', r.randint(0, 4)
        kind = r.choice(['while', 'repeat', 'do', 'if'])
        self.add('#200=0')
        opening = {'while': f'{o} while [#200 LT {n}]', 'repeat': f'{o} repeat [{n}]', 'do': f'{o} do', 'if': f'{o} if [{n} GT 1]'}[kind]
        self.add(opening)
        self.straight()
        self.add('#200=[#200+1]')
        if kind in ('while', 'do') and self.chance(0.3):
            self.labels += 1
            self.add(f'O{self.labels} if [#200 EQ 2]')
            self.add(f'{o} {r.choice(["break", "continue"])}')
            self.add(f'O{self.labels} endif')
        if kind == 'if':
            self.add(f'{o} else')
            self.straight()
        self.add({'while': f'{o} endwhile', 'repeat': f'{o} endrepeat', 'do': f'{o} while [#200 LT {n}]', 'if': f'{o} endif'}[kind])

    def call(self):
        self.labels += 1
        o = f'O<sub{self.labels}>'
        self.lines[2:2] = [f'{o} sub', 'G1 X#1 Y[#2+#3]', f'{o} endsub [#1+1]' if self.chance(0.5) else f'{o} endsub']
        self.add(f'{o} call [{self.random.randint(1, 9)}] [{self.random.randint(1, 9)}] (remark) [#200]')
        self.add('(PRINT,value #<_value>)')

    def message(self):
        self.add(self.random.choice(['(PRINT,x #5420 y #5421)', '(MSG, text)', '(DEBUG,#200 %d #200 %.2f#5422)', '(plain remark)']))

    # ---- machine with U V W
    def straight_uvw(self):
        self.add(f'{self.random.choice(["G0", "G1", "G1", ""])} {self.words(self.random.choice(["UVW", "XYZUVW", "XYZ", "UVWAB"]))}'.strip())

    def system_uvw(self):
        r = self.random
        words = self.words(r.choice(['UVW', 'XYZUVW']), 20)
        self.add(r.choice([r.choice(SYSTEMS), f'G10 L2 P{r.randint(0, 9)} {words}', f'G10 L20 P{r.randint(0, 9)} {words}', f'G92 {words}', 'G92.1',
                           'G92.2', 'G92.3', f'G52 {words}', f'G43.1 W{r.randint(-20, 20)}', 'G49', 'G28.1', 'G30.1', f'G28 {words}', 'G30',
                           f'G10 L2 P{r.randint(1, 9)} R{r.randint(-180, 180)}', f'G10 L1 P{r.randint(1, 9)} {words}', f'G43 H{r.randint(1, 9)}']))

    def plane_uvw(self):
        r = self.random
        plane = r.choice(['G17', 'G18', 'G19', 'G17.1', 'G18.1', 'G19.1', 'G17.1', 'G18.1', 'G19.1'])
        of = 'UVW' if plane.endswith('.1') else 'XYZ'
        first, second, drill = {'G17': of, 'G18': of[2] + of[0] + of[1], 'G19': of[1] + of[2] + of[0]}[plane[:3]]
        if self.chance(0.1):                              # a letter of the other type of plane
            first = r.choice('XYZUVW')
        code = r.choice(['G81', 'G82 P0.2', 'G83 Q1.3', 'G73 Q0.9', 'G85', 'G89 P0.1', 'G86 P0.1', 'G87 I0.5 J0.3 K-0.2', 'G84', 'G74'])
        if of == 'XYZ' and plane != 'G17' and code in ('G84', 'G74'):
            code = 'G81'                                  # drilling along rotated axes: a fault of the control
        self.add(f'{plane} {"M4" if code == "G74" else "M3"} {r.choice(["G98", "G99"])} {r.choice(["G90", "G90", "G91"])}')
        self.add(f'G0 {drill}{r.randint(3, 12)}')
        count = f' L{r.randint(1, 3)}' if self.chance(0.3) and code != 'G74' else ''
        self.add(f'{code} {first}{self.number(30)} {second}{self.number(30)} {drill}{-r.randint(1, 5)} R{r.randint(0, 5)}{count}')
        for _ in range(r.randint(0, 2)):
            self.add(self.words(first + second, 30))
        self.add('G80 G90')
        self.add(r.choice(['G17', '', f'{r.choice(["G2", "G3"])} U5 V5 I2 J2', '@5 ^10']))

    def variable_uvw(self):
        self.add(self.random.choice(['(PRINT,#5426 #5427 #5428)', '(PRINT,#<_u> #<_v> #<_w> #<_abs_x>)', '(PRINT,#5227 #5217 #5167 #<_plane>)']))

    TOPICS = {
        'motions': ['straight', 'straight', 'arc', 'mode', 'polar', 'spline'],
        'systems': ['straight', 'system', 'system', 'mode'],
        'cycles': ['cycle', 'straight', 'mode', 'system'],
        'flow': ['loop', 'call', 'variable', 'straight', 'message'],
        'all': ['straight', 'arc', 'mode', 'system', 'cycle', 'polar', 'spline', 'variable', 'loop', 'call', 'message'],
    }
    UVW = ['straight_uvw', 'straight_uvw', 'system_uvw', 'plane_uvw', 'variable_uvw', 'straight', 'arc', 'mode', 'system']
    FAULTY_UVW = ['G1 U1 U2', 'G1 V', 'G5 X1 Y1 I1 J1 P-1 Q1 U3', 'G17.1 G2 U5 V5 I1', 'G17.1 G41', 'G81 U1 Z-1 R1', 'G17.1 G81 X1 W-1 R1', 'G80 U1', 'U5',
                  'G18.1 G81 U1 R1', 'G19.1 G84 U-3 R2', 'G17.1 G5.1 X1 Y1 I1 J1', 'G17.1 @5 ^9', 'G93 G1 U5 F2', 'G76 P1 Z-5 I1 J.5 K1 U3']


def random_program(seed, axes='XYZABC'):
    """(topic, text)"""
    program = Program(seed)
    topic = 'uvw' if 'U' in axes else list(Program.TOPICS)[seed % len(Program.TOPICS)]
    kinds, faulty = (Program.UVW, Program.FAULTY_UVW + FAULTY) if topic == 'uvw' else (Program.TOPICS[topic], FAULTY)
    program.add('G21 G90 G17 G40 G80')
    program.add('F200 S500')
    for _ in range(program.random.randint(4, 18)):
        getattr(program, program.random.choice(kinds))()
    if program.chance(0.3):
        program.lines.insert(program.random.randint(2, len(program.lines)), program.random.choice(faulty))
    program.add('M2')
    if any('G43' in line for line in program.lines):    # rs274's stub does not convert the tool length in force
        program.lines = ['G21' if line == 'G20' else line for line in program.lines]
    return topic, '\n'.join(program.lines)
