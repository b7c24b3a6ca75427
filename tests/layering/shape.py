#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The shape of a checkout in figures: rooms, floors and circles, the main window, names, units, lines.

  tests/layering/shape.py [FOLDER]

FOLDER is a checkout (this one, unless another is named), so that two can be compared. A room is a folder with
sources; it includes another room where one of its files includes one of that room's headers. A floor is the length of
the longest road down; rooms in a circle share one.
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parents[2])
include = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)
sources = sorted(p for top in ("renderer", "widgets", "app", "shaders", "tests") for p in (root / top).rglob("*")
                 if p.suffix in (".h", ".cpp", ".glsl") and p.name != "PresetWords.cpp")  # which is not compiled
product = [p for p in sources if p.relative_to(root).parts[0] != "tests"]
text = {p: p.read_text(encoding="utf-8") for p in sources}


def headers_of(path):
    """The files of the checkout that a source includes."""
    for name in include.findall(text[path]):
        for below in (root / "renderer", root, root / "tests"):
            if (below / name).is_file():
                yield below / name
                break


def graph_of(top):
    """The rooms below a top folder, by those of its rooms that each includes."""
    rooms = defaultdict(set)
    for path in product:
        if path.relative_to(root).parts[0] != top:
            continue
        here = path.parent.relative_to(root)
        rooms[here]
        for header in headers_of(path):
            there = header.parent.relative_to(root)
            if there != here and there.parts[0] == top:
                rooms[here].add(there)
    for there in set().union(*rooms.values()):
        rooms[there]
    return rooms


def circles_of(rooms):
    """Strongly connected components, by Tarjan's algorithm."""
    index, low, stack, found = {}, {}, [], []

    def visit(room):
        index[room] = low[room] = len(index)
        stack.append(room)
        for other in rooms[room]:
            if other not in index:
                visit(other)
                low[room] = min(low[room], low[other])
            elif other in stack:
                low[room] = min(low[room], index[other])
        if low[room] == index[room]:
            at = stack.index(room)
            found.append(frozenset(stack[at:]))
            del stack[at:]

    for room in list(rooms):
        if room not in index:
            visit(room)
    return found


def floors_of(rooms, circles):
    of = {room: circle for circle in circles for room in circle}
    height = {}
    for circle in circles:  # whatever is included was found before
        below = {of[other] for room in circle for other in rooms[room]} - {circle}
        height[circle] = 1 + max((height[other] for other in below), default=0)
    return max(height.values(), default=0)


def code_lines(paths):
    return sum(text[p].count("\n") for p in paths)


for top in ("widgets", "app"):
    rooms = graph_of(top)
    circles = circles_of(rooms)
    knots = sorted(sorted(str(room.relative_to(top)) for room in circle) for circle in circles if len(circle) > 1)
    print(f"rooms of {top}: {len(rooms)} on {floors_of(rooms, circles)} floors, {len(knots)} circles", *map(" ".join, knots),
          sep="\n  ")

window = [p for p in product if p.stem == "MainWindow"]
header = next(text[p] for p in window if p.suffix == ".h")
print("MainWindow:", len(re.findall(r"^  \w[\w:<>, ]*[&*]? m_\w+[^;()]*(?:\([^;]*\))?;", header, re.M)), "members,",
      sum(len(re.findall(r"\b(?:connect|run)\(", text[p])) for p in window), "connections,",
      len(include.findall(header)), "includes of its header,", code_lines(window), "lines")

words = r"enum class (EngineSetting|PictureEngine|RaysBy|ViewEngine|PointRenderer|Engine)\b[^;]*\{"
print("enums for who draws:", len({name for p in product for name in re.findall(words, text[p])}))
named = {name for p in product for name in re.findall(r"^class (\w+Desk)\b[^;]*\{", text[p], re.M)}
print("names ending in Desk:", len(named))
for word in ("Parts", "Partners"):
    print(f"structs called {word}:", sum(len(re.findall(rf"struct {word} \{{", text[p])) for p in product))

users = defaultdict(set)
for path in product:
    for header in headers_of(path):
        if header.with_suffix("") != path.with_suffix(""):
            users[header].add(path)
headers = [p for p in product if p.suffix == ".h"]
units = defaultdict(list)
for path in product:
    units[path.with_suffix("")].append(path)
print("headers:", len(headers), "of which have one user:", sum(len(users[p]) == 1 for p in headers))
print("units:", len(units), "of which are shorter than 60 lines:",
      sum(code_lines(paths) < 60 for paths in units.values()))
print("C++ and GLSL lines of the product:", code_lines(product), "in", len(product), "files")
print("C++ lines of the tests:", code_lines(set(sources) - set(product)))
