#!/usr/bin/env python3
"""Checks controls/*.toml against their rules and against the engine's headers. Run: python3 tests/controls_table.py

The loader (src/config/control/control_file) refuses most of these faults too. This check lists all faults at once, without a build, and checks
what the loader does not: both languages, the manual's section, alarm texts and their arguments.
"""
import pathlib
import re
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
CONTROLS = ROOT / "controls"
CYRILLIC = re.compile("[А-Яа-яЁё]")


def header(name):
    return (ROOT / "src" / name).read_text(encoding="utf-8")


def macro_rows(text, macro):
    """Returns the X(…) rows of `#define MACRO(X)`, without comments."""
    body = re.search(r"#define " + macro + r"\(X\)((?:.*\\\n)*.*)", text)[1]
    return re.findall(r"X\(([^)]*)\)", re.sub(r"/\*.*?\*/", "", body))


def enum_names(text, enum):
    body = re.sub(r"//[^\n]*", "", re.search(r"enum class " + enum + r"[^{]*\{(.*?)\};", text, re.S)[1])
    return [n for n in re.findall(r"\w+", body) if n != "count"]


def struct_fields(text, struct):
    body = re.search(r"struct " + struct + r" \{(.*?)\n\};", text, re.S)[1]
    return re.findall(r"^\s+([\w:<>, ]+?) (\w+)(?:\{\}|\s*=\s*[^;]+)?;", body, re.M)


FUNCTION_H, DEF_H, GRAMMAR_H = header("config/control/function.h"), header("config/control/control_def.h"), header("lang/block/grammar.h")
PHASES = macro_rows(FUNCTION_H, "KADR_PHASES")
FUNCTIONS = dict(re.split(r",\s*", row)[:2] for row in macro_rows(FUNCTION_H, "KADR_FUNCTIONS"))  # name: its phase
ALARMS = macro_rows(header("base/alarm_ids.h"), "KADR_ALARMS")
STEPS = enum_names(DEF_H, "CycleStep")
VARIABLE_KINDS = macro_rows(DEF_H, "KADR_VARIABLE_KINDS")
UNITS = enum_names(DEF_H, "WordUnit")
BEHAVIOUR = {name: kind for kind, name in struct_fields(DEF_H, "Behaviour")}
PARAMETER_ENUMS = {"scope": enum_names(DEF_H, "ParameterScope"), "type": enum_names(DEF_H, "ParameterType"),
                   "when": enum_names(DEF_H, "ParameterClass")}
ENUMS = {name: enum_names(DEF_H, name) for name in ("ArcCenters", "ArcRadius", "LengthOffset", "CompensationEntry", "DwellUnit", "LaterWord", "CycleWords")}
ENUMS["Lathe"] = enum_names(header("config/control/code_system.h"), "Lathe")
END_OF_BLOCK = enum_names(GRAMMAR_H, "EndOfBlock")
OPERATIONS = set(enum_names(header("lang/expression/operation.h"), "Op"))
EXPRESSION_KEYS = {"operators": {"does", "binding"}, "functions": {"does", "operand", "of_two"}, "relations": {"does"}}
MOST_AXES = 16

# Keys that differ from the name of the field they fill.
GRAMMAR_KEYS = {name for _, name in struct_fields(GRAMMAR_H, "Grammar")} - {"words", "parameter_address", "label_address", "section_address", "custom_macros",
                                                                             "expression"}
GRAMMAR_KEYS |= {"macro", "formal_parameter", "parameters_in", "label", "section", "most_codes"}
TOP_KEYS = {"id", "name", "spec", "extends", "dialect", "format", "grammar", "expressions", "behaviour", "axes", "order", "address", "groups", "g", "m", "cycle",
            "variables", "parameters", "alarms", "defaults", "feed_codes", "speed_codes", "aliases", "guess", "encoding", "convert", "systems",
            "names", "cycle_parameters"}
TEXT_KEYS = {"en", "ru", "manual"}
ADDRESS_KEYS = TEXT_KEYS | {"does", "axis", "unit", "scale", "least", "most", "whole", "point", "format", "phase", "second", "many"}
CODE_KEYS = TEXT_KEYS | {"group", "does", "arg", "takes", "needs", "needs_axis", "own_block", "modal", "phase", "with", "works", "in_part", "told",
                         "from", "to"}
GROUP_KEYS = {"modal", "initial", "en", "ru"}
CYCLE_KEYS = TEXT_KEYS | {"steps", "body", "needs", "needs_spindle", "needs_spindle_cw", "needs_override_off", "printed",
                          "parameters", "left_out"}
VARIABLE_KEYS = TEXT_KEYS | {"from", "count", "stride", "repeat", "is", "ranges", "symbol", "first", "arg", "bit", "of", "access", "works"}
FIRST_UNWRITTEN = 1_000_000  # first_unwritten_variable of control_def.h
OWN_ALARM_KEYS = {"number", "en", "ru", "hint_en", "hint_ru"}
PARAMETER_KEYS = TEXT_KEYS | {"scope", "type", "when", "least", "most", "initial", "bits", "used", "as"}
ALARM_KEYS = {"severity", "args", "en", "ru", "hint_en", "hint_ru"}

ADDRESS_FUNCTIONS = {"block_number", "axis", "center", "word_of_code", "feed_word", "speed_word", "tool_word", "offset_word",
                     "formal_parameter", "code", "label", "dwell_word", "repeat_word", "call_word", "corrector_word", "machine_axis",
                     "increment_axis", "argument_only", "auxiliary_word", "spindle_word", "spindle_axis_word", "tool_call",
                     "length_number", "radius_number", "tool_of_table", "speed_of_spindle"}
COMMA_WORDS = {"c": ",C", "r": ",R", "a": ",A"}  # as written in `takes`; `*`: every axis of the channel
TEXT_OF_THE_PROGRAM = {"program_alarm"}  # their text comes from the program

# Names of the parameters, "0107" or "CLRG", that the rooms which obey parameters read; ranges of parameters (N1704 …) are
# counted there.
OBEYED = {number for room in ("control", "motion", "machine", "session") for path in sorted((ROOT / "src" / room).rglob("*.cpp"))
          for number in re.findall(r'"(\d{4}|[A-Z]{4})"', path.read_text(encoding="utf-8"))}

passed = 0
failures = []


def check(ok, what):
    global passed
    if ok:
        passed += 1
    else:
        failures.append(what)
    return ok


def load(path):
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, tomllib.TOMLDecodeError) as error:
        check(False, f"{path.name}: {error}")
        return None


def check_text(row, where, manual=True, proper_name=False):
    for key in ("en", "ru") + (("manual",) if manual else ()):
        check(isinstance(row.get(key), str) and row[key].strip() != "", f"{where}: {key} is missing")
    check(proper_name or not CYRILLIC.search(row.get("en", "")), f"{where}: Russian letters in the English text")
    check(CYRILLIC.search(row.get("ru", "")), f"{where}: the Russian text is not Russian")


def check_keys(row, known, where):
    for key in row:
        check(key in known, f"{where}: unknown key '{key}'")


def descriptor_letters(text):
    """Returns the addresses of a format: `3G2` gives G."""
    return {m[1] for m in re.finditer(r"(?<!\S)\d?([A-Z])(?=[+±*\d])\S*", text)}


def code_name(letter, key):
    tenth = round(float(key) * 10)
    return f"{letter}{tenth // 10}" + (f".{tenth % 10}" if tenth % 10 else "")


class Control:
    """One file of a control, merged with the file it extends."""

    def __init__(self, path, table):
        self.name, self.t = path.name, table
        self.addresses = table.get("address", {})
        self.groups = table.get("groups", {})
        self.order = table.get("order", {}).get("phases", [])
        self.axes = table.get("axes", {}).get("names", [])
        self.codes = {}  # "G43.4": row

    def at(self, *path):
        return f"{self.name}: " + " ".join(str(p) for p in path)

    def check(self):
        self.check_head()
        self.check_grammar()
        self.check_behaviour()
        self.check_expressions()
        self.check_order()
        self.check_addresses()
        for section, letter in (("g", "G"), ("m", "M")):
            self.check_codes(section, letter)
        self.check_groups()
        self.check_cycles()
        self.check_named()
        self.check_variables()
        self.check_own_alarms()

    def check_own_alarms(self):
        texts = load(CONTROLS / "alarms.toml") or {}
        for key, row in self.t.get("alarms", {}).items():
            where = self.at("alarms", key)
            check(key in ALARMS, f"{where}: is no alarm")
            check_keys(row, OWN_ALARM_KEYS, where)
            check(bool(row.get("en")) == bool(row.get("ru")), f"{where}: in one language only")
            check(bool(row.get("hint_en")) == bool(row.get("hint_ru")), f"{where}: hint in one language only")
            args = texts.get(key, {}).get("args", 0)
            for text in (row.get(k, "") for k in OWN_ALARM_KEYS - {"number"}):
                check(all(int(n) < args for n in re.findall(r"\{(\d+)\}", text)), f"{where}: more arguments than alarms.toml gives")

    def check_head(self):
        check_keys(self.t, TOP_KEYS, self.at())
        check(self.t.get("id") == self.name.removesuffix(".toml"), self.at("id is not the name of the file"))
        check_text(self.t.get("name", {}), self.at("name"), manual=False, proper_name=True)
        check(self.t.get("spec"), self.at("spec is missing"))
        if "parameters" in self.t:
            check(is_parameters(CONTROLS / f"{self.t['parameters']}.toml"), self.at("parameters: no table", self.t["parameters"]))
        check(1 <= len(self.axes) <= MOST_AXES, self.at("axes: 1 to", MOST_AXES))
        check(len(set(self.axes)) == len(self.axes), self.at("axes: one stands twice"))
        for axis in self.t.get("axes", {}).get("rotary", []):
            check(axis in self.axes, self.at("rotary", axis, "is no axis"))

    def check_grammar(self):
        grammar = self.t.get("grammar", {})
        check_keys(grammar, GRAMMAR_KEYS, self.at("grammar"))
        check(grammar.get("end_of_block", "line") in END_OF_BLOCK, self.at("grammar end_of_block"))
        for key in ("formal_parameter", "label", "section"):
            if key in grammar:
                check(grammar[key] in self.addresses, self.at("grammar", key, "has no address row"))
        for letter in grammar.get("parameters_in", ""):
            check(letter in self.addresses, self.at("parameters_in", letter, "has no address row"))
        for letter in grammar.get("most_codes", {}):
            check(letter in self.addresses, self.at("most_codes", letter, "has no address row"))

    def check_behaviour(self):
        for key, value in self.t.get("behaviour", {}).items():
            if not check(key in BEHAVIOUR, self.at("behaviour", key, "is not known")):
                continue
            kind = BEHAVIOUR[key]
            if key == "arc_radius_difference" and isinstance(value, list):  # while the unit is mm, and inch
                good = len(value) == 2 and all(isinstance(one, float) and one >= 0 for one in value)
            elif kind in ENUMS:
                good = value in ENUMS[kind]
            elif kind == "bool":
                good = isinstance(value, bool)
            else:
                good = isinstance(value, (int, float)) and not isinstance(value, bool) and value >= 0
                good = good and (kind == "double" or isinstance(value, int))
            check(good, self.at("behaviour", key, "=", value, "is no", kind))

    def check_expressions(self):
        rows = self.t.get("expressions", {})
        check_keys(rows, EXPRESSION_KEYS, "expressions")
        check(not rows or self.t["grammar"].get("expressions"), self.at("expressions: not with this grammar"))
        for section, table in rows.items():
            for text, row in table.items():
                check_keys(row, EXPRESSION_KEYS[section], self.at(section, text))
                check(row.get("does") in OPERATIONS, self.at(section, text, "does nothing that is known"))
                check(text == text.upper(), self.at(section, text, "is not in capitals"))

    def check_order(self):
        check(len(set(self.order)) == len(self.order), self.at("order: a phase twice"))
        for phase in self.order:
            check(phase in PHASES and phase != "none", self.at("order:", phase, "is no phase"))

    def check_function(self, row, where):
        does = row.get("does")
        if not check(does in FUNCTIONS, f"{where}: '{does}' is no function"):
            return
        phase = row.get("phase", FUNCTIONS[does])
        check(phase in PHASES, f"{where}: '{phase}' is no phase")
        check(phase == "none" or phase in self.order, f"{where}: phase '{phase}' is not in the order")

    def check_addresses(self):
        described = descriptor_letters(self.t.get("format", ""))
        for letter, row in self.addresses.items():
            where = self.at("address", letter)
            check(re.fullmatch(r"[A-Z]|,[CRAL]|[$@^]", letter), f"{where}: no letter")
            check_keys(row, ADDRESS_KEYS, where)
            check_text(row, where)
            self.check_function(row, where)
            check(row.get("does") in ADDRESS_FUNCTIONS, f"{where}: '{row.get('does')}' is no function of an address")
            if row.get("does") in ("axis", "center"):
                check(row.get("axis") in self.axes, f"{where}: no axis '{row.get('axis')}'")
            check(row.get("unit", "none") in UNITS, f"{where}: unit")
            form = row.get("format")
            if form is not None:
                check(re.fullmatch(r"\+?free|[+±]?\*?0?[1-9][0-9]?", form), f"{where}: format '{form}'")
            parameter = row.get("does") == "formal_parameter"
            check(form is not None or letter in described or parameter, f"{where}: no format, in the row or in `format`")
        for letter in described:
            check(letter in self.addresses, self.at("format:", letter, "has no address row"))
        for axis in self.axes:
            row = self.addresses.get(axis, {})
            named = row.get("does") == "axis" and row.get("axis") == axis
            check(named or row.get("does") == "machine_axis", self.at("axis", axis, "has no address of its name"))

    def check_codes(self, section, letter):
        for key, row in self.t.get(section, {}).items():
            where = self.at(letter + key)
            check_keys(row, CODE_KEYS, where)
            check_text(row, where)
            self.check_function(row, where)
            check(row.get("does") not in ADDRESS_FUNCTIONS, f"{where}: '{row.get('does')}' is a function of addresses")
            if "group" in row:
                check(row["group"] in self.groups, f"{where}: no group '{row['group']}'")
            takes = row.get("takes", "")
            check(len(set(takes)) == len(takes), f"{where}: takes a letter twice")
            for word in takes:
                check(COMMA_WORDS.get(word, word) in self.addresses or word == "*" or (word == "A" and self.t.get("grammar", {}).get("zero_between_slashes")),
                      f"{where}: takes {word}, which is no address")
            check(set(row.get("needs", "")) <= set(takes), f"{where}: needs what it does not take")
            if key == "other":
                check(letter == "M" and row.get("from", 0) <= row.get("to", 99999999), f"{where}: from, to")
                continue
            check("from" not in row and "to" not in row, f"{where}: from, to are for `other`")
            if not check(re.fullmatch(r"\d+(\.\d)?", key), f"{where}: no number of a code"):
                continue
            name = code_name(letter, key)
            check(name not in self.codes, f"{where}: stands twice")
            self.codes[name] = row
            if row.get("does") == "cycle":
                check(name in self.t.get("cycle", {}), f"{where}: no [cycle.{name}]")
        for name, row in self.codes.items():
            for other in row.get("with", []):
                partner = self.codes.get(other, {})
                check(partner.get("group") == row.get("group"), self.at(name, "with", other))

    def check_groups(self):
        used = {row.get("group") for section in ("g", "m") for row in self.t.get(section, {}).values()}
        for name, row in self.groups.items():
            where = self.at("group", name)
            check_keys(row, GROUP_KEYS, where)
            check_text(row, where, manual=False)
            check(name in used, f"{where}: no code")
            if "initial" in row:
                check(row.get("modal", True), f"{where}: initial, but not modal")
                code = self.codes.get(row["initial"])
                check(code is not None and code.get("group") == name, f"{where}: initial {row['initial']} is not of the group")
        for code in self.t.get("defaults", {}).get("end", []):
            check(code in self.codes, self.at("defaults end:", code, "is no code"))

    def check_named(self):
        """Statements, words and cycles of blocks with names: each parameter of a cycle has a meaning, and each meaning a parameter."""
        meanings, used = self.t.get("cycle_parameters", {}), set()
        for name, row in self.t.get("names", {}).items():
            where = self.at("names", name)
            check_keys(row, {"en", "ru", "manual", "parameters", "works"}, where)
            check_text(row, where)
            for parameter in row.get("parameters", "").split():
                key = f"{name}.{parameter}" if f"{name}.{parameter}" in meanings else parameter
                check(key in meanings, f"{where}: no meaning of {parameter}")
                used.add(key)
        for name, row in meanings.items():
            check_keys(row, {"en", "ru"}, self.at("cycle_parameters", name))
            check(row.get("en") and row.get("ru"), f"{self.at('cycle_parameters', name)}: a text is missing")
            check(name in used, f"{self.at('cycle_parameters', name)}: no cycle has it")

    def check_cycles(self):
        called = {name for name, row in self.codes.items() if row.get("does") == "cycle"}
        by_word = any(row.get("does") == "call_word" for row in self.addresses.values())
        for name, row in self.t.get("cycle", {}).items():
            where = self.at("cycle", name)
            check_keys(row, CYCLE_KEYS, where)
            check_text(row, where)
            check(name in called or (by_word and name[0] == "L"), f"{where}: no code calls it")
            check(("steps" in row) != ("body" in row), f"{where}: steps or a body")
            for step in row.get("steps", []):
                check(step in STEPS, f"{where}: '{step}' is no step")
            takes = self.codes.get(name, {}).get("takes", "")
            check(set(row.get("needs", "")) <= set(takes), f"{where}: needs what its code does not take")

    def check_variables(self):
        taken = {}
        most = self.t.get("grammar", {}).get("variables", 0)
        symbols = {}
        for row in self.t.get("variables", []):
            where = self.at("variable", row.get("symbol", row.get("from", row.get("ranges"))))
            check_keys(row, VARIABLE_KEYS, where)
            check_text(row, where)
            check(row.get("is") in VARIABLE_KINDS, f"{where}: '{row.get('is')}' is no kind")
            check(row.get("access", "RW") in ("R", "W", "RW"), f"{where}: access")
            check(("bit" in row) == ("of" in row), f"{where}: bit and of")
            ranges = row.get("ranges", [[row.get("from", 0), row.get("count", 1), row.get("stride", 0), row.get("repeat", 1)]])
            numbers = []
            for first, count, stride, repeat in (r if len(r) == 4 else r + [0, 1] for r in ranges):
                check(repeat == 1 or stride >= count, f"{where}: stride less than count")
                numbers += [first + i * stride + j for i in range(repeat) for j in range(count)]
            kind = (row.get("is"), row.get("arg", 0))
            check(all(taken.get(n, kind) == kind for n in numbers), f"{where}: a number twice")
            check(row.get("symbol") or not any(n in taken for n in numbers), f"{where}: a number twice")
            check((numbers[0] >= 1 or row.get("is") == "empty") and all(n <= most or n > FIRST_UNWRITTEN for n in numbers), f"{where}: beyond #{most}")
            taken.update(dict.fromkeys(numbers, kind))
            if "symbol" in row:
                check(row["symbol"] not in symbols, f"{where}: symbol twice")
                symbols[row["symbol"]] = ranges
        for row in self.t.get("variables", []):
            check("of" not in row or row["of"] in taken, self.at("variable", row.get("symbol"), "is a bit of no variable"))


def is_parameters(path):
    """True for a table of parameters, which is not a control itself."""
    return path.name.endswith("-parameters.toml") and path.is_file()


def check_parameters(name, table):
    base = table.pop("extends", None)
    below = load(CONTROLS / f"{base}.toml") if base is not None else {}
    check(below is not None and is_parameters(CONTROLS / f"{base}.toml") if base is not None else True, f"{name}: extends no table: {base}")
    numbers = [key for key in table if key.isdigit()]
    check(list(table)[:len(numbers)] == sorted(numbers), f"{name}: rows by number, then those without one")
    for key, row in table.items():
        where = f"{name}: {key}"
        if row is False:  # removes the row of the table that this one extends
            check(key in below, f"{where}: {base} has no such row")
            continue
        check(re.fullmatch(r"\d{4}|[A-Z]+", key), f"{where}: four digits, or capital letters")
        check_keys(row, PARAMETER_KEYS, where)
        check_text(row, where)
        for column, words in PARAMETER_ENUMS.items():
            check(row.get(column, "run_time" if column == "when" else None) in words, f"{where}: {column}")
        check(row.get("least", -1e300) <= row.get("most", 1e300), f"{where}: least is above most")
        check(row.get("type") == "bits" or "bits" not in row, f"{where}: bits")
        names = [n for n in row.get("bits", "").split() if n not in "-|"]
        check(len(names) == len(set(names)), f"{where}: a bit twice")
        check(row.get("used") or key not in OBEYED, f"{where}: the source asks for it, so `used = true`")


def check_alarms(table):
    check(list(table) == ALARMS, "alarms.toml: not the ids of alarm_ids.h in their order: "
          + " ".join(sorted(set(table) ^ set(ALARMS))))
    for name, row in table.items():
        where = f"alarms.toml: {name}"
        check_keys(row, ALARM_KEYS, where)
        check_text(row | ({"ru": "текст программы"} if name in TEXT_OF_THE_PROGRAM else {}), where, manual=False)
        check_text({"en": row.get("hint_en", ""), "ru": row.get("hint_ru", "")}, f"{where} hint", manual=False)
        check(not re.search(r"\bN\d{4}\b", " ".join(str(text) for text in row.values())),
              f"{where}: names a parameter of one control; that text stands in the control's file")
        check(row.get("severity", "alarm") in ("alarm", "warning", "note", "advice"), f"{where}: severity")
        args = row.get("args", -1)
        check(0 <= args <= 3, f"{where}: args 0 to 3")
        for key in ("en", "ru"):
            used = sorted({int(n) for n in re.findall(r"\{(\d+)\}", row.get(key, ""))})
            check(used == list(range(args)) or name in TEXT_OF_THE_PROGRAM, f"{where}: {key} uses {used}, args = {args}")
        for key in ("hint_en", "hint_ru"):
            check("{" not in row.get(key, ""), f"{where}: {key} has arguments")
    check_alarm_calls(table)


def split_arguments(text):
    """Returns the arguments of a call, from after its '('; None if the call does not end in the text."""
    parts, depth, part, quote = [], 0, "", ""
    for before, c in zip(" " + text, text):
        if quote:
            quote = "" if c == quote and before != "\\" else quote
        elif c in "\"'":
            quote = c
        elif c in "([{":
            depth += 1
        elif c in ")]}":
            if depth == 0:
                return parts + [part.strip()]
            depth -= 1
        elif c == "," and depth == 0:
            parts.append(part.strip())
            part = ""
            continue
        part += c
    return None


def check_alarm_calls(table):
    """Checks that every alarm(AlarmId::x, where, …) of the sources gives at least the arguments that the alarm's text uses."""
    for path in sorted((ROOT / "src").rglob("*.cpp")) + sorted((ROOT / "src").rglob("*.h")):
        text = path.read_text(encoding="utf-8")
        for call in re.finditer(r"\b(?:alarm|warning)\(\s*AlarmId::(\w+)\s*,", text):
            parts = split_arguments(text[call.end():])
            args = table.get(call[1], {}).get("args", 0)
            line = text.count("\n", 0, call.start()) + 1
            if parts is not None:
                check(len(parts) - 1 >= args, f"{path.relative_to(ROOT)}:{line}: {call[1]} gives {len(parts) - 1} arguments, its text uses {args}")


def merged(path, depth=0, over=""):
    """Lays a control's table over the one it extends, as src/config does. `over`: the control in place of the one that the file extends."""
    table = load(path)
    if table is None or "extends" not in table or depth == 8:
        return table
    base, base_over = over or table["extends"], ""
    if isinstance(base, list):
        base_over, base = base
    under = merged(CONTROLS / f"{base}.toml", depth + 1, base_over)
    if over and under is not None:  # no alarm numbers of another maker; a code with a meaning of its own keeps nothing of the code below it
        table.pop("alarms", None)
        for section in ("g", "m"):
            for key, row in table.get(section, {}).items():
                if isinstance(row, dict) and "does" in row:
                    under.get(section, {}).pop(key, None)
            table[section] = {key: row for key, row in table.get(section, {}).items() if row is not False or key in under.get(section, {})}
    return None if under is None else lay(under, table)


def lay(under, over):
    for key, value in over.items():
        both = isinstance(value, dict) and isinstance(under.get(key), dict)
        if key == "alarms" and isinstance(value, dict) and value.pop("alone", False):
            under[key] = value
        elif key == "variables" and isinstance(under.get(key), list):  # a row of the same symbol replaces the row below it
            symbols = {row.get("symbol") for row in value} - {None}
            # a row with nothing but a symbol only removes the row below it
            under[key] = [row for row in value if set(row) != {"symbol"}] + [row for row in under[key] if row.get("symbol") not in symbols]
        elif value is False and isinstance(under.get(key), dict):  # the control removes this row
            del under[key]
        else:
            under[key] = lay(under[key], value) if both else value
    return under


def check_names():
    """Checks that each id and alias means one control, and that each row of [guess] has a weight."""
    meant = {}
    lathe = tomllib.loads((CONTROLS / "dialects.toml").read_text(encoding="utf-8"))["lathe"]["read_by"]
    tables = {path.stem: tomllib.loads(path.read_text(encoding="utf-8")) for path in sorted(CONTROLS.glob("*.toml"))
              if path.name not in ("alarms.toml", "dialects.toml") and not is_parameters(path)}
    for name, table in tables.items():
        for alias in [name, *table.get("aliases", [])]:
            check(alias not in meant, f"{name}.toml: '{alias}' is the name of {meant.get(alias)}, too")
            check(re.fullmatch(r"[a-z0-9.-]+", alias) is not None, f"{name}.toml: '{alias}' is no name")
            meant[alias] = name
        guess = table.get("guess", {})
        # The evidence for the controls of lathes is with that of lathes in dialects.toml
        check(guess != {} or name in lathe, f"{name}.toml: no [guess]")
        check_guess(f"{name}.toml", guess)


def check_guess(where, guess):
    """Checks that each row of [guess] and of its tables has a weight."""
    check(set(guess) & {"text", "comment", "name"} == {key for key, row in guess.items() if isinstance(row, dict)}, f"{where}: [guess]: tables")
    for rows in [guess, *(row for row in guess.values() if isinstance(row, dict))]:
        for pattern, weight in rows.items():
            if not isinstance(weight, dict):
                check(isinstance(weight, (int, float)) and 0 < abs(weight) <= 20, f"{where}: [guess] {pattern}: {weight}")


def check_dialects(table, controls):
    """Checks that each language that Kadr does not read has its names and something that identifies it."""
    for name, row in table.items():
        where = f"dialects.toml: {name}"
        check(set(row) <= {"name", "guess", "refused_by", "read_by"}, f"{where}: {sorted(row)}")
        check(set(row.get("read_by", {})) <= controls, f"{where}: read_by: {sorted(row.get('read_by', {}))}")
        check(set(row.get("name", {})) == {"en", "ru"}, f"{where}: name: en, ru")
        check(set(row.get("refused_by", [])) <= controls, f"{where}: refused_by: {row.get('refused_by')}")
        check(row.get("guess", {}) != {}, f"{where}: no guess")
        check_guess(where, row.get("guess", {}))


def main():
    check_names()
    for name, found in (("phases", PHASES), ("functions", FUNCTIONS), ("alarms", ALARMS), ("steps", STEPS), ("behaviour", BEHAVIOUR)):
        check(len(found) > 5, f"headers: no {name} found")
    for path in sorted(CONTROLS.glob("*.toml")):
        before = len(failures)
        table = load(path) if path.name in ("alarms.toml", "dialects.toml") or is_parameters(path) else merged(path)
        if table is None:
            continue
        if path.name == "alarms.toml":
            check_alarms(table)
        elif path.name == "dialects.toml":
            check_dialects(table, {other.stem for other in CONTROLS.glob("*.toml")})
        elif is_parameters(path):
            check_parameters(path.name, table)
        else:
            Control(path, table).check()
        print(f"{path.name}: {'ok' if len(failures) == before else 'FAILED'}")
    for failure in failures:
        print("  " + failure)
    print(f"{passed} passed, {len(failures)} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
