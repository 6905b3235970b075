# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Faults in scene streams, at places that are known because they were written there."""
from bits import BitWriter
from command_writer import SceneStream


class Fault:
    """A stream and where its last access unit (or, unit None, its configuration) is wrong. `bit` is of that."""

    def __init__(self, stream, bit, code="malformed", covers=""):
        self.stream, self.bit, self.code, self.covers = stream, bit, code, covers

    @property
    def unit(self):
        return len(self.stream.units) - 1


def wrong(stream, element, nth=-1, code="malformed", covers=""):
    """The element is wrong as it was written."""
    return Fault(stream, stream.out.at(element, nth), code, covers)


def changed(stream, element, width, value, nth=-1, code="malformed", covers="", shift=0):
    """The element is overwritten."""
    bit = stream.out.at(element, nth)
    stream.out.bits[bit:bit + width] = [(value >> i) & 1 for i in reversed(range(width))]
    return Fault(stream, bit + shift, code, covers)


def cut(stream, element, nth=-1, covers="3.truncated"):
    """The access unit ends inside that element or before it, but behind all earlier ones where bytes allow it."""
    out = stream.out
    starts = sorted({bit for _, bit in out.places} | {len(out)})
    begin = out.at(element, nth)
    end = next(bit for bit in starts if bit > begin)
    size = (begin + 7) // 8 if (begin + 7) // 8 * 8 < end else (end - 1) // 8
    first = next(start for start, stop in zip(starts, starts[1:]) if stop > 8 * size)
    out.bits = out.bits[:8 * size]
    return Fault(stream, first, "truncated", covers)


def raw(*parts, **settings):
    """A stream whose unit is written by hand: (width, value, name)."""
    stream = SceneStream(**{"node_bits": 4, **settings})
    stream.out = BitWriter()
    for width, value, name in parts:
        stream.out.u(width, value, name)
    stream.units.append((0, stream.out))
    return stream
