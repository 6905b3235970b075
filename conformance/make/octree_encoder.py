# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Encodes OctreeImage streams, with what a legal encoder must not do on request. The tables of
section 5 are those of ../octree_decoder.py; section numbers are those of the text."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from octree_decoder import (CHILDREN, CLASS, POSITIONS, Q1, Q2, Q3, START_CODE, SYMBOLS,  # noqa: E402
                            SYMMETRY)


def number(value, width):
    return [value >> k & 1 for k in range(width - 1, -1, -1)]


def pack(bits):
    """Bytes, filled up with zero bits."""
    bits = bits + [0] * (-len(bits) % 8)
    return bytes(int("".join(map(str, bits[i:i + 8])), 2) for i in range(0, len(bits), 8))


class Coder:
    """Section 6. `shifts` has S after each symbol, `longest` the most bits that were pending,
    `unresolved` those at the end, before finish."""

    def __init__(self):
        self.low, self.high, self.pending, self.bits = 0, 65535, 0, []
        self.shifts, self.longest, self.unresolved = [], 0, 0
        self.middles_at_quarter = 0  # middle steps of an interval that began at exactly Q1

    def put(self, bit):
        self.bits += [bit] + [1 - bit] * self.pending
        self.pending = 0

    def encode(self, table, symbol):
        f = table.frequencies
        total, below = sum(f), sum(f[symbol + 1:])
        length = self.high - self.low + 1
        self.high = self.low - 1 + length * (below + f[symbol]) // total
        self.low += length * below // total
        self.renormalise()
        self.shifts.append(len(self.bits) + self.pending)
        table.count(symbol)

    def renormalise(self):
        while True:
            drop = 0
            if self.high < Q2:
                self.put(0)
            elif self.low >= Q2:
                self.put(1)
                drop = Q2
            elif self.low >= Q1 and self.high < Q3:
                self.pending += 1
                self.longest = max(self.longest, self.pending)
                self.middles_at_quarter += self.low == Q1
                drop = Q1
            else:
                return
            self.low, self.high = 2 * (self.low - drop), 2 * (self.high - drop) + 1

    def finish(self):
        self.unresolved = self.pending
        self.pending += 1
        self.put(0 if self.low < Q1 else 1)

    def with_ending(self, first, second):
        """The bits with another code / 16384 after the last symbol."""
        pending = [1 - first] * self.unresolved
        return self.bits[:-2 - self.unresolved] + [first] + pending + [second]


class Table:
    def __init__(self, symbols, step, limit):
        self.frequencies, self.step, self.limit = [1] * symbols, step, limit

    def copy(self, step):
        table = Table(0, step, self.limit)
        table.frequencies = self.frequencies[:]
        return table

    def count(self, symbol):
        self.frequencies[symbol] += self.step
        if sum(self.frequencies) > self.limit:
            self.frequencies = [(f + 1) // 2 for f in self.frequencies]


class NodeTables:
    """Section 4.1."""

    def __init__(self):
        self.n, self.tables = 0, [Table(256, 2, 8192)]

    def encode(self, coder, symbol, parent, position):
        if self.n == 512:
            self.tables = [self.tables[0].copy(3) for _ in range(22)]
        if self.n == 2560:
            self.tables = [table.copy(4) for table in self.tables for _ in range(8)]
        self.n += 1
        t = SYMMETRY[parent]
        if self.n <= 512:
            coder.encode(self.tables[0], symbol)
        elif self.n <= 2560:
            coder.encode(self.tables[CLASS[parent]], SYMBOLS[t][symbol])
        else:
            coder.encode(self.tables[8 * CLASS[parent] + CHILDREN[t][position]], SYMBOLS[t][symbol])


def encode_frame(frame, levels, textures):
    """Section 3; the coder, whose `bits` are the frame."""
    coder, nodes, table = Coder(), NodeTables(), Table(textures + 1, 32, 512)
    symbols, images = iter(frame["octree"]), iter(frame["voxelImageIndex"])
    level = [(0, 0, textures > 0)]  # parent, position, whether its texture is undefined

    def texture():
        coder.encode(table, image := next(images))
        return image == 0

    for _ in range(levels):
        below = []
        for parent, position, undefined in level:
            nodes.encode(coder, symbol := next(symbols), parent, position)
            undefined = undefined and texture()
            below += [(symbol, child, undefined) for child in POSITIONS[symbol]]
        level = below
    for _, _, undefined in level:
        undefined and texture()
    assert next(symbols, None) is None and next(images, None) is None, "symbols are left over"
    coder.finish()
    return coder


def header(resolution, textures, resolution_bits=None, texture_bits=None):
    """The bits of the header, with widths that are not the least if they are given."""
    r = resolution.bit_length() if resolution_bits is None else resolution_bits
    t = textures.bit_length() if texture_bits is None else texture_bits
    return number(r, 5) + number(resolution, r) + number(t, 3) + number(textures, t)


def stream(head, frames):
    """The stream of a header and frames, which are lists of bits."""
    return pack(head) + b"".join(START_CODE.to_bytes(4, "big") + pack(bits) for bits in frames)
