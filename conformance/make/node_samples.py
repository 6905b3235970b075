# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Nodes to write: every one of the tables with values that are not its defaults, and parents to put it into."""
import itertools

import node_facts as facts
from node_facts import NODES, f32
from quantizer import number
from scene_values import Buffer, Image, Node
from command_writer import command
from scripts import Script


def children_of(data_type):
    return [n for v in facts.VERSIONS for n in facts.DATA_TYPES[data_type][str(v)]["codes"] if n in NODES]


def simplest(data_type):
    """A node of a data type with few fields, none of which matter."""
    return min((name for name in children_of(data_type) if name != "QuantizationParameter"),
               key=lambda name: (facts.VERSION_OF[name], len(NODES[name].mode("def")), name))


def _hosts():
    """For each data type: the parent node and field that it can stand in, nearest to SF3DNode."""
    hosts, queue = {"SF3DNode": None}, ["SF3DNode"]
    while queue:
        data_type = queue.pop(0)
        for name in children_of(data_type):
            for field in NODES[name].mode("def"):
                if field.data_type and field.data_type not in hosts:
                    hosts[field.data_type] = (name, field, data_type)
                    queue.append(field.data_type)
    return hosts


HOSTS = _hosts()


def hosted(node, data_type):
    """The node within parents, so that it can stand in SF3DNode."""
    while HOSTS[data_type] is not None:
        name, field, data_type = HOSTS[data_type]
        node = Node(name, **{field.name: [node] if field.multiple else node})
    return node


class Values:
    """Values in turn, never the default of a field, within its bounds."""

    def __init__(self):
        self.next = itertools.count(1)

    def of(self, field):
        for _ in range(20):
            value = self.multiple(field) if field.multiple else self.single(field)
            if not isinstance(value, (list, int, float, str, bool)) or value != field.default:
                return value
        raise ValueError(field.name)

    def multiple(self, field):
        count = {0: 2, 1: 1, 2: 9}[next(self.next) % 3]
        if field.element == "SFNode":
            count = 1
        return [self.single(field) for _ in range(count)]

    def single(self, field):
        kind, step = field.element, next(self.next)
        if kind == "SFNode":
            return Node(simplest(field.data_type))
        if kind == "SFBool":
            return not field.default if isinstance(field.default, bool) else bool(step % 2)
        if kind == "SFInt32":
            return self.integer(field, step)
        if kind == "SFTime":
            return step * 0.7
        if kind == "SFString":
            return f"text {step}"
        if kind == "SFURL":
            return {"od": step % 1023} if step % 2 else f"a{step}.mp4"
        if kind == "SFImage":
            return Image(2, 1, step % 4 + 1, range(2 * (step % 4 + 1)))
        if kind == "SFCommandBuffer":
            return Buffer(command("delete_node", 1))
        if kind == "SFScript":
            return Script()
        count = {"SFFloat": 1, "SFVec2f": 2, "SFVec3f": 3, "SFColor": 3, "SFRotation": 4, "SFVec4f": 4}[kind]
        values = [self.float(field, step + i) for i in range(count)]
        return values if count > 1 else values[0]

    def integer(self, field, step):
        low, high = (number(b) for b in field.bounds or (-1000, 1000))
        low, high = max(int(low), -(1 << 31)), min(int(high), (1 << 31) - 1)
        return low + step * 7 % (high - low + 1)

    def float(self, field, step):
        low, high = (number(b) for b in field.bounds or ("-inf", "+inf"))
        low, high = (max(low, -100.0), min(high, 100.0))
        if low >= high:
            return f32(low)
        return f32(low + (high - low) * (step * 37 % 101) / 101)


def full(name, values, form="mask"):
    """A node with every DEF field set."""
    node = Node(name, form=form)
    node.fields = {field.name: values.of(field) for field in NODES[name].mode("def")}
    if name == "BitWrapper":
        node.fields["buffer"] = b"\x00\xffbytes"  # a string by its type only
    return node
