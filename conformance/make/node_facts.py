# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The node tables of conformance/facts/mpeg4-nodes.json, as a writer of BIFS needs them."""
import json
import os
import struct

from bits import bits_for

FACTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "facts", "mpeg4-nodes.json")
EVENTS = ("field", "exposedField", "eventIn", "eventOut")
MODES = {"all": EVENTS, "def": EVENTS[:2], "in": ("exposedField", "eventIn"),
         "out": ("exposedField", "eventOut")}
# What an interface can have (bifs.md 12) and how it is coded.
INTERFACE_TYPES = {"SFBool": 0, "SFFloat": 1, "SFTime": 2, "SFInt32": 3, "SFString": 4, "SFVec3f": 5,
                   "SFVec2f": 6, "SFColor": 7, "SFRotation": 8, "SFImage": 9, "SFNode": 10}
INTERFACE_TYPES.update({"MF" + name[2:]: code + 32 for name, code in list(INTERFACE_TYPES.items())})


class Field:
    def __init__(self, name, event, kind, data_type=None, default=None, bounds=None, category=0, width=0,
                 anim=0):
        self.name, self.event, self.kind, self.data_type = name, event, kind, data_type
        self.default, self.bounds, self.category, self.width = default, bounds, category, width
        self.anim = anim

    @property
    def element(self):
        return "SF" + self.kind[2:]

    @property
    def multiple(self):
        return self.kind.startswith("MF")

    @property
    def type_text(self):
        """As the form `commands` names it: with the data type of nodes, where that is not the widest."""
        if self.element == "SFNode" and self.data_type != "SFWorldNode":
            return self.kind[:2] + self.data_type[2:]
        return self.kind


class Definition:
    """A node or a PROTO: its fields, numbered in each mode."""

    def __init__(self, name, fields, insert=None, data_types=()):
        self.name, self.fields, self.insert, self.data_types = name, fields, insert, data_types

    def mode(self, mode):
        return [field for field in self.fields if field.event in MODES[mode]]

    def width(self, mode):
        return bits_for(len(self.mode(mode)) - 1) if self.mode(mode) else 0

    def index(self, mode, name):
        return [field.name for field in self.mode(mode)].index(name)

    def field(self, name):
        return next(field for field in self.fields if field.name == name)


def _field(fact):
    quant = fact["quant"] or {}
    return Field(fact["name"], fact["event"], fact["baseType"], fact["ndt"], fact.get("default"),
                 fact["bounds"], quant.get("category", 0), quant.get("nbits", 0))


with open(FACTS, encoding="utf-8") as _file:
    _facts = json.load(_file)

NODES = {node["name"]: Definition(node["name"], [_field(f) for f in node["fields"]], node["insertNdt"],
                                  node["ndt"])
         for node in _facts["nodes"] if not node["private"]}
VERSION_OF = {node["name"]: node["version"] for node in _facts["nodes"]}
DATA_TYPES = _facts["ndt"]
VERSIONS = range(1, 10)


def code_path(data_type, name):
    """The widths and codes that lead to a node: escapes, then its own; None where it may not stand."""
    path = []
    for version in VERSIONS:
        table = DATA_TYPES[data_type][str(version)]
        code = table["codes"].get(name, 0)
        path.append((table["bits"], code, version))
        if code:
            return path
    return None


def f32(value):
    """Rounded to binary32; beyond its range infinite."""
    try:
        return struct.unpack(">f", struct.pack(">f", value))[0]
    except OverflowError:
        return float("inf") if value > 0 else float("-inf")


LARGEST = f32(3.4028234663852886e38)


def plain(value):
    """A binary32 as JSON: the shortest decimal that reads back."""
    value = f32(value)
    if value != value:
        return "nan"
    if value in (float("inf"), float("-inf")):
        return "inf" if value > 0 else "-inf"
    for digits in range(1, 10):
        short = float(f"{value:.{digits}g}")
        if f32(short) == value:
            return int(short) if short == int(short) and abs(short) < 1e9 else short
    raise ValueError(value)


# Those that a field has, or the scene: no other code is ever written.
CODED_DATA_TYPES = [name for name in DATA_TYPES if name == "SFTopNode" or any(
    field.data_type == name and field.event in MODES["def"] for node in NODES.values() for field in node.fields)]
