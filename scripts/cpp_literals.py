"""String literals of C++ sources, with the calls that they stand in."""

import re

TOKEN = re.compile(r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<raw>R"(?P<delimiter>[^(\s]*)\(.*?\)(?P=delimiter)")
  | (?P<string>(?:u8|L|u|U)?"(?:[^"\\\n]|\\.)*")
  | (?P<char>'(?:[^'\\\n]|\\.)+')
  | (?P<include>^[ \t]*\#[ \t]*(?:include|error|pragma)[^\n]*)
  | (?P<name>[A-Za-z_]\w*(?:::[A-Za-z_]\w*)*)
  | (?P<number>[0-9][0-9a-fA-F'.xX]*)
  | (?P<other>[^\s])
""", re.X | re.S | re.M)
ESCAPE = re.compile(r"\\(u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8}|x[0-9a-fA-F]+|[0-7]{1,3}|.)", re.S)


def decode(literal):
    def one(match):
        body = match.group(1)
        if body[0] in "uUx":
            return chr(int(body[1:], 16))
        if body[0].isdigit():
            return chr(int(body, 8))
        return {"n": "\n", "t": "\t", "r": "\r"}.get(body, body)

    return ESCAPE.sub(one, literal[literal.index('"') + 1:-1])


class Literal:
    """Adjacent literals as one, with the names of the calls round it, innermost last, and its line."""

    def __init__(self, text, calls, method, path, line, added):
        self.text, self.calls, self.path, self.line = text, calls, path, line
        self.method = method  # the innermost call is one of an object's functions
        self.added = added  # joined to something else by +: a piece of a sentence

    def inside(self, names):
        return any(call.split("::")[-1] in names for call in self.calls)

    def of_method(self, name):
        return self.method and self.calls[-1] == name

    def place(self):
        return f"{self.path}:{self.line}"


def literals_of(path, source):
    out, stack, methods, previous, before, last_was_string = [], [], [], "", "", False
    for match in TOKEN.finditer(source):
        kind, text = match.lastgroup, match.group()
        if kind == "delimiter":
            kind = "raw"
        if kind in ("comment", "include"):
            continue
        if kind == "string":
            if last_was_string:
                out[-1].text += decode(text)
            else:
                line = source.count("\n", 0, match.start()) + 1
                out.append(Literal(decode(text), list(stack), bool(methods and methods[-1]), path, line, previous == "+"))
            last_was_string, before, previous = True, previous, "string"
            continue
        if text == "+" and last_was_string:
            out[-1].added = True
        last_was_string = False
        if text in "([{" and kind == "other":
            # A brace or a bracket is no call, but keeps the calls round it.
            stack.append(previous if text == "(" and re.match(r"[A-Za-z_]", previous) else "")
            methods.append(text == "(" and before == ".")
        elif text in ")]}" and kind == "other" and stack:
            stack.pop()
            methods.pop()
        before, previous = previous, text
    return out
