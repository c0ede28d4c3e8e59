#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the ctypes declarations of libdomino, read from its headers after the preprocessor.

header.py SONAME 'COMPILER AND FLAGS' HEADER... > _api.py

The headers are the only description of structures and functions, so that a change in them cannot be forgotten here.
The program ends with an error if it cannot read a declaration.
"""

import re
import shlex
import subprocess
import sys

BASIC = {
    "dom_real": "c_double", "double": "c_double", "int": "c_int", "_Bool": "c_bool", "size_t": "c_size_t",
    "unsigned_int": "c_uint", "unsigned_long": "c_ulong", "sig_atomic_t": "c_int",
}  # fmt: skip


def declarations(compiler, headers):
    """Returns the text of the project's own headers after the preprocessor, without bodies of functions."""
    folder = headers[0].rsplit("/", 1)[0]
    before = [word for header in headers[:-1] for word in ("-include", header.rsplit("/", 1)[-1])]
    command = [*shlex.split(compiler), "-E", f"-I{folder}", *before, headers[-1]]
    kept, own = [], False
    for line in subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines():
        if line.startswith("# "):
            own = f'"{folder}/' in line
        elif own:
            kept.append(line)
    text = re.sub(r"__attribute__\s*\(\(.*?\)\)", "", " ".join(kept))
    text = re.sub(r"static inline [^{]*\{[^}]*\}", "", text)
    text = re.sub(r"\bunsigned long\b", "unsigned_long", re.sub(r"\s+", " ", text))
    return re.sub(r"\bunsigned\b", "unsigned_int", text)


def effects(headers):
    """Returns the members of struct dom_train and struct dom_row that hold effects, by the names of the effects."""
    with open(headers[0].rsplit("/", 1)[0] + "/domino_common.h") as header:
        return dict(re.findall(r"X\((\w+), (\w+), DOM_BAD_\w+\)", header.read()))


def ctype(text, callbacks):
    """Returns the ctypes name of a C type such as "const struct dom_train *"."""
    text = re.sub(r"\b(const|volatile)\b", "", text).strip()
    stars = text.count("*")
    name = re.sub(r"\s+", " ", text.replace("*", " ")).strip()
    if name == "void":
        return "c_void_p" if stars else "None"
    if name == "char" and stars:
        return "POINTER(" * (stars - 1) + "c_char_p" + ")" * (stars - 1)
    if name in callbacks and stars <= 1:
        return name
    if name.startswith("enum "):
        basic = "c_int"
    elif name.startswith("struct "):
        basic = name.removeprefix("struct ")
    else:
        basic = BASIC[name]
    for _ in range(stars):
        basic = f"POINTER({basic})"
    return basic


def members(body, callbacks, sizes):
    """Yields the name and the ctypes name of each member of a structure."""
    for statement in filter(None, map(str.strip, body.split(";"))):
        kind, names = re.fullmatch(r"((?:(?:const|volatile|enum|struct) )*\w+)\s*(.*)", statement).groups()
        for declarator in re.sub(r"\bconst\b", "", names).split(","):
            stars, name, size = re.fullmatch(r"\s*([* ]*)(\w+)\s*(?:\[([\w -]+)\])?\s*", declarator).groups()
            one = ctype(kind + stars, callbacks)
            size = size and re.sub("[A-Z]\\w*", lambda known: str(sizes[known[0]]), size)  # as "DOM_LATER - 1"
            yield name, f"{one} * ({size})" if size else one


def arguments(text, callbacks):
    """Returns the ctypes names of the parameters of a function. An array is a pointer."""
    parameters = [] if text.strip() in ("", "void") else re.sub(r"(\w+)\s*\[\w*\]", r"*\1", text).split(",")
    return [kind for parameter in parameters for _, kind in members(parameter, callbacks, {})]


def main(soname, compiler, *headers):
    text = declarations(compiler, headers)
    print('"""The structures and functions of libdomino, generated from its headers by header.py."""\n')
    print("from ctypes import (CFUNCTYPE, POINTER, Structure, c_bool, c_char_p, c_double, c_int, c_size_t, c_uint,")
    print("                    c_ulong, c_void_p)")
    print(f'from enum import IntEnum\n\nSONAME = "{soname}"\nEFFECTS = {effects(headers)}\n')
    sizes, callbacks, functions = {}, set(), []
    pattern = re.compile(
        r"enum (?P<enum>\w*) ?\{(?P<values>[^}]*)\};|struct (?P<struct>\w+) \{(?P<body>[^}]*)\};"
        r"|typedef (?P<returned>[\w ]+?[ *]+)(?P<callback>\w+)\((?P<taken>[^)]*)\);"
        r"|(?P<result>(?:const )?(?:enum |struct )?\w+[ *]+)(?P<function>dom_\w+)\((?P<given>[^;]*)\);"
        r"|typedef double dom_real;|struct \w+;|extern const [^;]*;|extern \"C\" \{|\}|;"
    )
    declared = []  # structures and callbacks, in the order of the header
    at = 0
    while at < len(text):
        if text[at] == " ":
            at += 1
            continue
        m = pattern.match(text, at)
        if not m:
            sys.exit(f"header.py: cannot read {text[at:at + 80]!r}")
        at = m.end()
        if m["values"] is not None:
            value, lines = -1, []
            for item in filter(None, map(str.strip, m["values"].split(","))):
                name, _, given = map(str.strip, item.partition("="))
                value = eval(given, {}, dict(sizes)) if given else value + 1  # noqa: S307 - constants of the header
                sizes[name] = value
                lines.append(f"    {name} = {value}")
            if m["enum"]:
                print(f"\nclass {m['enum']}(IntEnum):", *lines, "", sep="\n")
            else:
                print(*map(str.strip, lines), sep="\n")
        elif m["struct"]:
            print(f"\nclass {m['struct']}(Structure):\n    pass\n")
            declared.append((m["struct"], m["body"], None))
        elif m["callback"]:
            callbacks.add(m["callback"])
            declared.append((m["callback"], m["taken"], m["returned"]))
        elif m["function"]:
            functions.append((m["function"], m["result"], m["given"]))
    lines = []
    for name, body, returned in declared:
        if returned is not None:
            lines.append(f"{name} = CFUNCTYPE({', '.join([ctype(returned, callbacks), *arguments(body, callbacks)])})")
        else:
            fields = [f'    ("{member}", {kind}),' for member, kind in members(body, callbacks, sizes)]
            lines += [f"{name}._fields_ = [", *fields, "]"]
    print("\n" + "\n".join(lines))
    print("\n# For each function the type of its result, and those of its parameters.\nFUNCTIONS = {")
    for name, result, given in functions:
        print(f'    "{name}": ({ctype(result, callbacks)}, [{", ".join(arguments(given, callbacks))}]),')
    print("}")


main(*sys.argv[1:])
