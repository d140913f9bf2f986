"""C++ sources as far as counting them needs: statements, functions, classes, names at namespace scope, beginnings of
comments.

Braces and parentheses are followed token by token; nothing is preprocessed and no type is known, which this project's
style allows. Used by structure.py, whose help defines what a statement is."""

import re

# Comments, and what could hide or feign one: raw strings, strings, characters, numbers with separators.
COMMENT = re.compile(
    r"""//[^\n]*|R"([^(\s]*)\(.*?\)\1"|"(?:[^"\\\n]|\\.)*"|\b[0-9]['.\w]*|'(?:[^'\\\n]|\\.)+'""", re.S)
ODD_WORD = re.compile(r"[/<!\s]*(of|what|where|how|who|which|that|when|whose|why)\b", re.I)

TOKEN = re.compile(r"""
    (?P<comment>//(?:[^\n\\]|\\.|\\\n)*|/\*.*?\*/)
  | (?P<directive>^[ \t]*\#(?:[^\n\\]|\\.|\\\n)*)
  | (?P<text>(?:u8|L|u|U)?(?:R"(?P<limit>[^(\s]*)\(.*?\)(?P=limit)"|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)+'))
  | (?P<number>\.?[0-9](?:[eEpP][+-]|['.\w])*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<mark>->|::|<=>|<<=|<<|>=|<=|==|!=|&&|\|\||\+=|-=|\*=|/=|[^\s\w])
    """, re.X | re.S | re.M)
CLASS_KEYS = {"class", "struct", "union", "enum"}
AFTER_PARAMETERS = {"const", "noexcept", "override", "final", "mutable", "volatile", "&", "&&", "try"}
SPECIFIERS = {"static", "inline", "constexpr", "consteval", "constinit", "typedef", "extern", "friend", "const",
              "virtual", "thread_local"}
BUILT_IN = {"int", "double", "float", "bool", "char", "unsigned", "signed", "long", "short", "auto", "void", "const"}
HELD = "{}"  # stands for a closed pair of braces that belongs to an expression


def odd_comments(text):
    """Comments whose first word is an ODD_WORD, so that they do not name what they are about: lines and texts.

    A comment goes on in whole lines below; behind code in those that begin in its column."""
    out, line, at = [], 1, 0
    last_line, last_column, last_behind = -1, 0, False
    for found in COMMENT.finditer(text):
        token, begin = found.group(), found.start()
        if not token.startswith("//"):
            continue
        line += text.count("\n", at, begin)
        at = begin
        column = begin - text.rfind("\n", 0, begin)
        behind = text[begin - column + 1:begin].strip() != ""
        goes_on = not behind and last_line == line - 1 and (column == last_column or not last_behind)
        if not goes_on and ODD_WORD.match(token):
            out.append((line, token))
        last_line, last_column, last_behind = line, column, last_behind if goes_on else behind
    return out


class Scope:
    """Between a pair of braces: which kind, and the tokens since its last statement ended."""

    def __init__(self, kind, name="", line=0, goes_on=False):
        self.kind, self.name, self.line, self.goes_on = kind, name, line, goes_on
        self.members = []  # tokens of each declaration of a class
        self.clear()

    def clear(self):
        self.head, self.open, self.match, self.start = [], [], {}, 0

    def push(self, token, line):
        if not self.head:
            self.start = line
        self.head.append(token)
        if token in "([":
            self.open.append(len(self.head) - 1)
        elif token in ")]" and self.open:
            self.match[len(self.head) - 1] = self.open.pop()


class Source:
    """One source: counts, classes, names at namespace scope."""

    def __init__(self, path, text):
        self.path, self.lines = path, text.count("\n") + (not text.endswith("\n") and text != "")
        self.statements = 0
        self.functions = []     # (name, lines, first line)
        self.classes = []       # (name, members)
        self.names = []         # (kind, namespace, name, types of parameters)
        self.code = ""
        self.scopes = [Scope("namespace")]
        self.read(text)
        self.balanced = len(self.scopes) == 1

    # --- tokens

    def read(self, text):
        line, at = 1, 0
        code = []
        for found in TOKEN.finditer(text):
            line += text.count("\n", at, found.start())
            at = found.start()
            kind, token = found.lastgroup, found.group()
            if kind in ("comment", "directive"):
                continue
            code.append('""' if kind == "text" else token)
            self.take('""' if kind == "text" else token, line)
        self.code = " ".join(code)

    # --- structure

    def take(self, token, line):
        scope = self.scopes[-1]
        if token == "{":
            self.open_brace(scope, line)
        elif token == "}":
            self.close_brace(line)
        elif token == ";" and not scope.open:
            self.statements += 1
            self.declare(scope, False)
            scope.clear()
        elif token == ":" and scope.head and not scope.open and (
                scope.head[0] in ("case", "default") or scope.head[-1] in ("public", "private", "protected")):
            scope.clear()
        else:
            scope.push(token, line)

    def open_brace(self, scope, line):
        kind, name = self.brace_kind(scope)
        if kind != "value":
            self.statements += 1
        if kind in ("class", "enum", "function"):
            self.declare(scope, True)
        goes_on = kind in ("value", "lambda")
        start = scope.start if scope.head else line
        if not goes_on and kind not in ("class", "enum"):
            scope.clear()
        self.scopes.append(Scope(kind, name, start, goes_on or kind in ("class", "enum")))

    def close_brace(self, line):
        if len(self.scopes) == 1:
            return
        scope = self.scopes.pop()
        if scope.kind == "function":
            self.functions.append((scope.name, line - scope.line + 1, scope.line))
        elif scope.kind == "class":
            self.classes.append((scope.name, scope.members))
        if scope.kind in ("class", "enum"):
            self.scopes[-1].clear()
            self.scopes[-1].push(HELD, line)
        elif scope.goes_on:
            self.scopes[-1].push(HELD, line)

    def brace_kind(self, scope):
        head, last = scope.head, scope.head[-1] if scope.head else None
        if self.is_lambda(scope):
            return "lambda", ""
        if scope.kind in ("value", "enum") or scope.open:
            return "value", ""
        if not head:
            return "block", ""
        first = start_of(head)
        if "namespace" in head[:2]:
            return "namespace", "".join(t for t in head if t not in ("inline", "namespace")) or "(unnamed)"
        if head[:2] == ["extern", '""']:
            return "namespace", ""
        if first < len(head) and head[first] in CLASS_KEYS and not {"(", "="} & set(without_attributes(head[first:])):
            return ("enum" if head[first] == "enum" else "class"), class_name(head[first:])
        if scope.kind in ("namespace", "class") and self.ends_function(scope):
            return "function", function_name(head)
        if last in ("else", "do", "try") or self.closing(scope) is not None:
            return "block", ""
        return "value", ""

    def closing(self, scope):
        """Place of the parenthesis that ends parameters or a condition right before this place, or None."""
        head = scope.head
        at = len(head) - 1
        while at >= 0:
            if head[at] == ")":
                before = head[scope.match.get(at, 0) - 1] if scope.match.get(at, 0) else ""
                if before in ("noexcept", "__attribute__"):
                    at = scope.match[at] - 2
                    continue
                return at
            if head[at] in AFTER_PARAMETERS:
                at -= 1
                continue
            # A type that is returned: -> name<...>
            back = at
            while back >= 0 and (re.fullmatch(r"\w+|::|<|>|,|\*|&|&&", head[back])) and head[back] != "return":
                back -= 1
            if back >= 0 and head[back] == "->" and back < at:
                at = back - 1
                continue
            return None
        return None

    def is_lambda(self, scope):
        head = scope.head
        floor = scope.open[-1] if scope.open else -1
        at = self.closing(scope)
        if at is not None and at > floor:
            before = scope.match.get(at, 0) - 1
            if before > 1 and head[before] == ">":
                while before > 0 and head[before] != "]":
                    before -= 1
            if before < 0 or head[before] != "]":
                return before >= 0 and head[before] == "requires"
        else:
            before = len(head) - 1
            while before > floor and head[before] in AFTER_PARAMETERS:
                before -= 1
            if before > floor and head[before] == "requires":
                return True
            if before <= floor or head[before] != "]":
                return False
        opening = scope.match.get(before)
        if opening is None:
            return False
        ahead = head[opening - 1] if opening > 0 else ""
        return not re.fullmatch(r"\w+|]|>", ahead) or ahead == "return"

    def ends_function(self, scope):
        head = scope.head
        first = next((i for i, t in enumerate(head) if t == "("), None)
        if first is None or "=" in without_attributes(head[:first]) and "operator" not in head[:first]:
            return False
        if self.closing(scope) is not None and ":" not in head:
            return True
        # A list of initial values: its own braces follow a name, the body follows what is closed.
        after = False
        depth = 0
        for t in head:
            depth += (t == "(") - (t == ")")
            after = after or (t == ":" and depth == 0)
        return (after and head[-1] in (")", HELD)) or self.closing(scope) is not None

    # --- names

    def declare(self, scope, with_body):
        if scope.kind == "class" and not with_body:
            scope.members.append(scope.head)
        if scope.kind != "namespace":
            return
        space = "::".join(s.name for s in self.scopes if s.name)
        declared = declaration(scope.head, with_body)
        if declared:
            self.names.append((declared[0], space, declared[1], declared[2]))


def start_of(head):
    """Place behind template<...>, attributes and specifiers."""
    at = 0
    while at < len(head):
        if head[at] == "template" and at + 1 < len(head) and head[at + 1] == "<":
            at = behind(head, at + 1, "<", ">")
        elif head[at] == "[" and head[at + 1:at + 2] == ["["]:
            at = behind(head, at, "[", "]")
        elif head[at] in ("__attribute__", "alignas") and head[at + 1:at + 2] == ["("]:
            at = behind(head, at + 1, "(", ")")
        elif head[at] == "requires" and CLASS_KEYS.intersection(head[at:]):
            at = next(k for k in range(at, len(head)) if head[k] in CLASS_KEYS)
        elif head[at] in SPECIFIERS:
            at += 1
        else:
            break
    return at


def behind(head, at, opening, closing):
    depth = 0
    while at < len(head):
        depth += (head[at] == opening) - (head[at] == closing)
        at += 1
        if depth == 0:
            break
    return at


def without_attributes(head):
    out, at = [], 0
    while at < len(head):
        if head[at] in ("alignas", "__attribute__", "decltype", "noexcept") and head[at + 1:at + 2] == ["("]:
            at = behind(head, at + 1, "(", ")")
        else:
            out.append(head[at])
            at += 1
    return out


def class_name(head):
    names = [t for t in without_attributes(head) if t not in CLASS_KEYS and t not in ("[", "]")]
    if not names or not re.fullmatch(r"[A-Za-z_]\w*", names[0]):
        return ""
    return names[0]


def parameters_at(head):
    """Place of the parenthesis that opens the parameters, or None: the first one outside of angle brackets."""
    depth = 0
    for at, token in enumerate(head):
        if token == "operator":
            return None
        if token in ("=", HELD) and depth == 0:
            return None
        depth += (token == "<") - (token == ">")
        if token == "(" and depth <= 0:
            return at
    return None


def function_name(head):
    head = without_attributes(head[start_of(head):])
    if "operator" in head:
        return "operator" + head[head.index("operator") + 1] if head[-1] != "operator" else "operator"
    at = parameters_at(head)
    if not at:
        return "?"
    begin = at - 1
    while begin > 1 and head[begin - 1] in ("::", "~"):
        begin -= 2 if head[begin - 1] == "::" else 1
    if re.fullmatch(r"TEST(_F|_P)?|TYPED_TEST", head[at - 1]):
        return "".join(head[at - 1:behind(head, at, "(", ")")]).replace(",", ", ")
    return "".join(head[begin:at])


def types_of(parameters):
    """Types of parameters without their names and default values."""
    out, current, depth, skipping = [], [], 0, False
    for token in parameters + [","]:
        if token == "," and depth == 0:
            if len(current) > 1 and re.fullmatch(r"[A-Za-z_]\w*", current[-1]) and current[-2] != "::" \
                    and current[-1] not in BUILT_IN and current != ["const", current[-1]]:
                current = current[:-1]
            if current:
                out.append("".join(t + " " if t == "const" else t for t in current))
            current, skipping = [], False
            continue
        depth += (token in "<([") - (token in ">)]")
        skipping = skipping or (token == "=" and depth == 0)
        if not skipping:
            current.append(token)
    return tuple(out)


def declaration(head, with_body):
    """(kind, name, parameters) of a declaration at namespace scope; None for what declares nothing of its own."""
    if not head or head[0] in ("static_assert", "namespace", HELD) or head[0] == "template" and head[1:2] != ["<"]:
        return None
    alias = "using" in head[:1] or "using" in head[start_of(head):start_of(head) + 1]
    plain = without_attributes(head[start_of(head):])
    if not plain:
        return None
    if alias:
        return ("type", plain[1], ()) if len(plain) > 2 and plain[2] == "=" else None
    if plain[0] in CLASS_KEYS and "(" not in plain:
        rest = [t for t in plain if t not in CLASS_KEYS]
        return ("type", rest[0], ()) if with_body and rest and rest[1:2] not in (["<"], ["::"]) else None
    at = parameters_at(plain)
    if at:
        if not re.fullmatch(r"[A-Za-z_]\w*", plain[at - 1]) or at < 2 or plain[at - 2] == "::":
            return None
        return "function", plain[at - 1], types_of(plain[at + 1:behind(plain, at, "(", ")") - 1])
    for at, token in enumerate(plain):
        if token in ("=", HELD) and at > 1 and re.fullmatch(r"[A-Za-z_]\w*", plain[at - 1]) and "operator" not in plain:
            return "constant", plain[at - 1], ()
    return None
