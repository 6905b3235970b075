# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""What the writer of BIFS is given: nodes, PROTOs and values whose coding leaves a choice."""


class Node:
    """`form` is mask or list; a list may name its fields in any order, also twice: `order`. `links` go from a field to that of the interface."""

    def __init__(self, name, /, id=None, label=None, form="mask", order=None, links=None, **fields):
        self.name, self.id, self.label, self.form, self.order = name, id, label, form, order
        self.links, self.fields = links or {}, fields


class Use:
    def __init__(self, id):
        self.id = id


class Listed(list):
    """A multiple value written as a list with end flags."""


class Vector(list):
    """A multiple value written with its count, in so many bits more than it needs."""

    def __init__(self, values, more=0):
        super().__init__(values)
        self.more = more


class Predicted(list):
    """A multiple value coded predictively (bifs.md 10) in intraMode `mode`, 1 with a `period`. `intra`: the values of
    mode 2 that are intra beside the first; `renewed`: the intra values with new parameters; `width`, `minimum`:
    compNbBits and every compMin, where they are not to be the least."""

    def __init__(self, values, mode=0, period=None, intra=(), renewed=(), width=None, minimum=None):
        super().__init__(values)
        self.mode, self.period, self.intra, self.renewed = mode, period, intra, renewed
        self.width, self.minimum = width, minimum


class Text(str):
    """A string whose length is written in more bits than it needs."""
    more = 0


class Image:
    def __init__(self, width, height, components, samples):
        self.width, self.height, self.components, self.samples = width, height, components, bytes(samples)


class Buffer:
    """A command buffer: a list of functions that each write a command."""

    def __init__(self, *commands):
        self.commands = commands


class Route:
    def __init__(self, source, out, target, into, id=None, label=None):
        self.source, self.out, self.target, self.into, self.id, self.label = source, out, target, into, id, label


class Proto:
    """`fields` are node_facts.Field; `extern` its URLs, or the definition is `code`, `protos`, `routes`."""

    def __init__(self, id, fields=(), code=(), protos=(), routes=(), extern=None, label=None):
        self.id, self.fields, self.code, self.protos = id, list(fields), code, protos
        self.routes, self.extern, self.label = routes, extern, label


def nodes_below(value):
    """All nodes in a value, of one name scope."""
    if isinstance(value, Node):
        yield value
        for inner in value.fields.values():
            yield from nodes_below(inner)
    elif isinstance(value, (list, tuple)):
        for inner in value:
            yield from nodes_below(inner)
