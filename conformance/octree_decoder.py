# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Decodes OctreeImage streams to JSON, written from the text of the bitstream alone.

    python3 octree_decoder.py IN OUT [--levels K] [--max-nodes N]

OUT gets octreeResolution, numOfTextures, frames, warnings and, after bad input, error; "bit" is
the offset in the file of the syntax element that is meant. Of a truncated frame comes what is whole.
Section numbers are those of the text.
Exit code: 0 decoded (with or without warnings), 1 files, 2 usage, 3 bad input.
"""
import argparse
import json
import sys
from bisect import bisect_left
from itertools import accumulate

START_CODE = 0x000001C8
Q1, Q2, Q3 = 16384, 32768, 49152


class Fault(Exception):
    """Bad input: truncated, malformed or limit_exceeded, at a bit of the file."""

    def __init__(self, code, bit, text):
        super().__init__(text)
        self.code, self.bit, self.text = code, bit, text


class EndOfData(Exception):
    """The frame is truncated at the symbol just decoded (section 6)."""


# Section 5: the table of symmetries. It is the part that ISO's own numbering may replace.

PERMUTATIONS = [(0, 1, 2), (1, 0, 2), (0, 2, 1), (2, 0, 1), (1, 2, 0), (2, 1, 0)]


def moved_child(child, flips, permutation):
    """T(child) for one symmetry."""
    return sum((child >> axis & 1) << k for k, axis in enumerate(permutation)) ^ flips


def moved_symbol(symbol, children):
    """T(symbol): bit T(i) of it is bit i of the symbol."""
    return sum(1 << children[i] for i in range(8) if symbol >> i & 1)


CHILDREN = [[moved_child(i, flips, p) for i in range(8)] for flips in range(8) for p in PERMUTATIONS]
SYMBOLS = [[moved_symbol(s, children) for s in range(256)] for children in CHILDREN]
INVERSES = [sorted(range(256), key=moved.__getitem__) for moved in SYMBOLS]
BASE = [min(moved[s] for moved in SYMBOLS) for s in range(256)]
BASES = sorted(set(BASE))
CLASS = [BASES.index(base) for base in BASE]
SYMMETRY = [next(t for t in range(48) if SYMBOLS[t][s] == BASE[s]) for s in range(256)]
POSITIONS = [[i for i in range(8) if s >> i & 1] for s in range(256)]  # the children of a node


class ArithmeticDecoder:
    """Section 6. `shifts` is S; `before` is S as it was before the last symbol."""

    def __init__(self, data, start):
        self.data = data + bytes(8)  # bits past the end read as 0; fewer than 31 of them are read
        self.start, self.bits_left = start, 8 * len(data) - start
        self.low, self.high = 0, 65535
        self.code = int.from_bytes(self.data[start // 8:start // 8 + 2], "big")  # starts are aligned
        self.shifts = self.before = self.count = 0
        self.whole = 0  # symbols that were decoded from bits within the data alone

    def symbol(self, frequencies, step, limit):
        """Decodes one symbol with a table and adapts the table."""
        sums = list(accumulate(frequencies))  # cum[s + 1] = total - sums[s]
        total = sums[-1]
        length = self.high - self.low + 1
        t = ((self.code - self.low + 1) * total - 1) // length
        s = bisect_left(sums, total - t)
        above = total - sums[s]
        self.high = self.low - 1 + length * (above + frequencies[s]) // total
        self.low += length * above // total
        self.renormalise()
        self.count += 1
        self.whole += 16 + self.before <= self.bits_left
        if self.shifts + 2 > self.bits_left:
            raise EndOfData
        frequencies[s] += step
        if total + step > limit:
            frequencies[:] = [(f + 1) // 2 for f in frequencies]
        return s

    def renormalise(self):
        low, high, code, data = self.low, self.high, self.code, self.data
        self.before = self.shifts
        first = bit = self.start + 16 + self.shifts
        while True:
            if high < Q2:
                drop = 0
            elif low >= Q2:
                drop = Q2
            elif low >= Q1 and high < Q3:
                drop = Q1
            else:
                break
            low = 2 * (low - drop)
            high = 2 * (high - drop) + 1
            code = 2 * (code - drop) + (data[bit >> 3] >> (~bit & 7) & 1)
            bit += 1
        self.low, self.high, self.code = low, high, code
        self.shifts += bit - first

    def surely_whole(self):
        """All 16 bits the last symbol was decoded from lie within the data."""
        return self.count == 0 or 16 + self.before <= self.bits_left

    def ended_well(self):
        return self.code // Q1 == (1 if self.low < Q1 else 2)


class NodeModel:
    """Section 4.1: the three stages of tables for node symbols; `count` is N."""

    def __init__(self):
        self.count, self.tables = 0, [[1] * 256]

    def decode(self, coder, parent, position):
        n = self.count
        self.count += 1
        if n < 512:
            return coder.symbol(self.tables[0], 2, 8192)
        if n == 512:
            self.tables = [self.tables[0][:] for _ in BASES]
        if n == 2560:
            self.tables = [table[:] for table in self.tables for _ in range(8)]
        t, c = SYMMETRY[parent], CLASS[parent]
        if n < 2560:
            return INVERSES[t][coder.symbol(self.tables[c], 3, 8192)]
        return INVERSES[t][coder.symbol(self.tables[8 * c + CHILDREN[t][position]], 4, 8192)]


class Frame:
    """Section 3: one frame, walked breadth first. The nodes of a level are the children of `parents`,
    the symbols of the level above; `defined` says for each parent whether its texture is defined.
    The root is child 0 of a made-up parent; its context is never looked at."""

    def __init__(self, stream, start):
        self.stream, self.start = stream, start
        self.coder, self.nodes = ArithmeticDecoder(stream.data, start), NodeModel()
        self.textures = [1] * (stream.num_of_textures + 1)  # section 4.2
        self.octree, self.images = bytearray(), []
        self.parents, self.defined = b"\1", bytes([stream.num_of_textures == 0])
        self.node_count = 1  # nodes known, voxels too
        self.childless = False
        self.complete = []  # per level: symbols so far, octree, images, children without an image

    def decode(self):
        """Returns the fields, at the levels that were asked for (section 7)."""
        known = 0  # node symbols of the levels whose size is known
        coarse = None
        try:
            for level in range(self.stream.levels):
                if level == self.stream.wanted:
                    coarse = self.fields([0] * self.undefined_children())
                    if self.coder.surely_whole():
                        return coarse
                known = self.node_count
                self.decode_level()
            for _ in range(self.undefined_children()):
                self.images.append(self.decode_texture())
        except EndOfData:
            self.keep_complete_levels()
            size, symbols = len(self.stream.data), self.coder.count
            known += symbols - self.nodes.count
            raise Fault("truncated", 8 * size,
                        f"frame truncated at symbol {symbols} of {known} known, byte {size}") from None
        return coarse or self.fields([])

    def keep_complete_levels(self):
        """Of a truncated frame the deepest complete level goes to the result (section 7)."""
        complete = [level for level in self.complete if level[0] <= self.coder.whole]
        if not complete:
            return
        level = len(complete)
        _, nodes, images, undefined = complete[-1]
        end = images + undefined
        if level == self.stream.levels:
            images = max(images, min(self.coder.whole - nodes, end))  # the voxels' own that are whole
        else:
            self.stream.result["octreeResolution"] = 1 << level
        self.octree, self.images = self.octree[:nodes], self.images[:images]
        self.stream.result["frames"].append(self.fields([0] * (end - images)))

    def decode_level(self):
        symbols, defined = bytearray(), bytearray()
        for parent, inherited in zip(self.parents, self.defined):
            for position in POSITIONS[parent]:
                symbols.append(self.decode_node(parent, position))
                if not inherited:
                    self.images.append(self.decode_texture())
                defined.append(inherited or self.images[-1] > 0)
        self.octree += symbols
        self.parents, self.defined = symbols, defined
        self.complete.append((self.coder.count, len(self.octree), len(self.images),
                              self.undefined_children()))

    def decode_node(self, parent, position):
        symbol = self.nodes.decode(self.coder, parent, position)
        self.node_count += len(POSITIONS[symbol])
        if self.node_count > self.stream.max_nodes:
            raise Fault("limit_exceeded", self.start + self.coder.before,
                        f"more than {self.stream.max_nodes} nodes")
        if symbol == 0 and self.nodes.count > 1:
            if not self.childless:  # one warning a frame, at the first of them
                self.stream.warn("octree_childless_node", self.start + self.coder.before)
            self.childless = True
        return symbol

    def decode_texture(self):
        return self.coder.symbol(self.textures, 32, 512)

    def undefined_children(self):
        return sum(len(POSITIONS[p]) for p, defined in zip(self.parents, self.defined) if not defined)

    def fields(self, voxels):
        return {"octree": list(self.octree), "voxelImageIndex": self.images + voxels}

    def end(self):
        """The bit after the frame's S + 2 bits."""
        end = self.start + self.coder.shifts + 2
        if end > 8 * len(self.stream.data):  # only a frame without any symbol
            raise Fault("truncated", 8 * len(self.stream.data), "frame truncated before its two bits")
        if not self.coder.ended_well():
            self.stream.warn("octree_bad_ending", end - 2)
        return end


class Stream:
    """Section 2. What has been decoded stands in `result`, also after a Fault."""

    def __init__(self, data, wanted, max_nodes):
        self.data, self.wanted, self.max_nodes, self.bit = data, wanted, max_nodes, 0
        self.result = {"octreeResolution": None, "numOfTextures": None, "frames": [], "warnings": []}

    def warn(self, code, bit):
        self.result["warnings"].append({"code": code, "bit": bit})

    def bits(self, first, count):
        window = int.from_bytes(self.data[first // 8:(first + count + 7) // 8], "big")
        return window >> (-(first + count) % 8) & ((1 << count) - 1)

    def read(self, count, name):
        if self.bit + count > 8 * len(self.data):
            raise Fault("truncated", self.bit, f"data ends within {name}")
        self.bit += count
        return self.bits(self.bit - count, count)

    def align(self):
        if self.bits(self.bit, -self.bit % 8):
            self.warn("align_bits", self.bit)
        self.bit += -self.bit % 8

    def read_sized(self, width_bits, name):
        """A number after its width."""
        at = self.bit
        width = self.read(width_bits, f"the width of {name}")
        value = self.read(width, name)
        if width != value.bit_length():
            self.warn("non_minimal_width", at)
        if value == 0 and name == "octreeResolution":
            raise Fault("malformed", at + width_bits, "octreeResolution is 0")
        self.result[name] = value
        return value

    def decode(self):
        resolution = self.read_sized(5, "octreeResolution")
        self.num_of_textures = self.read_sized(3, "numOfTextures")
        self.levels = (resolution - 1).bit_length()
        self.align()
        if self.read(32, "octree_frame_start_code") != START_CODE:
            raise Fault("malformed", self.bit - 32, "no octree_frame_start_code")
        while True:
            frame = Frame(self, self.bit)
            fields = frame.decode()
            if self.wanted is not None and self.wanted < self.levels:  # ends the reading, section 7
                self.result["octreeResolution"] = 1 << self.wanted
                self.result["frames"].append(fields)
                return
            self.bit = frame.end()
            self.result["frames"].append(fields)
            self.align()
            if self.data[self.bit // 8:self.bit // 8 + 4] != START_CODE.to_bytes(4, "big"):
                break
            self.bit += 32
        if self.bit < 8 * len(self.data):
            self.warn("trailing_bytes", self.bit)


def natural(text):
    if not text.isdecimal():
        raise ValueError  # argparse makes it a usage error
    return int(text)


def main():
    parser = argparse.ArgumentParser(description="Decodes an OctreeImage stream to JSON.")
    parser.add_argument("input", metavar="IN")
    parser.add_argument("output", metavar="OUT")
    parser.add_argument("--levels", type=natural, metavar="K", help="stop after K levels")
    parser.add_argument("--max-nodes", type=natural, default=1 << 28, metavar="N")
    arguments = parser.parse_args()
    status = 0
    try:
        with open(arguments.input, "rb") as file:
            stream = Stream(file.read(), arguments.levels, arguments.max_nodes)
        try:
            stream.decode()
        except Fault as fault:
            stream.result["error"] = {"code": fault.code, "bit": fault.bit, "text": fault.text}
            print(f"{arguments.input}: {fault.code} at bit {fault.bit}: {fault.text}", file=sys.stderr)
            status = 3
        with open(arguments.output, "w", encoding="ascii") as file:
            json.dump(stream.result, file)
            file.write("\n")
    except OSError as error:
        print(error, file=sys.stderr)
        status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
