"""The text in source files that people read: comments and docstrings of code, every line of a page. Used by dev/words."""
import io
import re
import tokenize
from pathlib import Path

# strings and characters come first, so that a // in them is not read as a comment
C_LIKE = re.compile(r'R"(?P<mark>\w*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|`(?:\\.|[^`\\])*`|'
                    r'(?P<line>//[^\n]*)|(?P<block>/\*.*?\*/)', re.DOTALL)
NUMBER_SIGN = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|(?P<line>(?:^|(?<=\s))#[^\n]*)', re.MULTILINE)


def comments_of(name, text):
    """Returns (line, comment): consecutive lines of `//` or `#` are one comment, without these signs; a page gives every line."""
    ending = Path(name).suffix
    if ending in {'.h', '.cpp', '.js', '.mjs', '.ts'}:
        return joined(matches(C_LIKE, text))
    if ending == '.py' or (ending == '' and text.startswith('#!/usr/bin/env python3')):
        return python_comments(text)
    if ending in {'.toml', '.cmake', '.sh', ''}:
        return joined(matches(NUMBER_SIGN, text))
    return [(i + 1, line) for i, line in enumerate(text.splitlines()) if line.strip()]


def matches(pattern, text):
    """Yields (line, column, text) of each comment."""
    at = line = 0
    for found in pattern.finditer(text):
        line, at = line + text.count('\n', at, found.start()), found.start()
        groups = found.groupdict()
        if comment := groups.get('line') or groups.get('block'):
            yield line + 1, at - text.rfind('\n', 0, at), comment


def python_comments(text):
    rows = []
    try:
        for token in tokenize.generate_tokens(io.StringIO(text).readline):
            is_docstring = token.type == tokenize.STRING and token.string.startswith(('"""', "'''"))
            if token.type == tokenize.COMMENT or is_docstring:
                rows.append((*token.start, token.string))
    except (tokenize.TokenError, SyntaxError):
        return []
    return joined(rows)


def joined(rows):
    """Joins comments in the same column of consecutive lines."""
    all_rows, last, where = [], None, None
    for line, column, text in rows:
        plain = ' '.join(re.sub(r'^[/#*!<\s]+|\*/$|^["\']{3}|["\']{3}$', '', part.strip()) for part in text.splitlines()).strip()
        if last is not None and where == (line - 1, column):
            all_rows[-1] = (all_rows[-1][0], f'{all_rows[-1][1]} {plain}'.strip())
        elif plain:
            all_rows.append((line, plain))
        last, where = plain, (line + text.count('\n'), column)
    return all_rows
