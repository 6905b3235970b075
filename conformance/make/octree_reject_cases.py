# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The suite octree-rejects: damaged and hostile streams, and what is whole of the truncated ones."""
import octree_encoder as encoder
import octree_fields as fields
from octree_cases import coarse_values, compact, values_of
from octree_fields import frame

START = encoder.START_CODE.to_bytes(4, "big")
GREATEST = 2**31 - 1


class Cases:
    """Adds cases to a suite."""

    def __init__(self, suite):
        self.suite = suite

    def reject(self, name, about, covers, data, code, bit=None, whole=None):
        """A stream that is not accepted; `whole`: what it holds all the same."""
        check = {"check": "reject", "code": code}
        if bit is not None:
            check["bit"] = bit
            covers += " 8.place"
        expect = [check]
        if whole is not None:
            expect.append({"check": "decode", "as": "octree", "partial": True,
                           **self.suite.put(name + ".json", compact(whole))})
        self.suite.case(name, about, "octree", data, expect, ["octree." + rule for rule in covers.split()])

    def cut(self, name, about, covers, stream, size):
        """A stream that is cut inside a frame: the place of the error is its end."""
        assert 0 <= size < len(stream.data), name
        covers = "6.truncated 6.truncated-place " + covers
        self.reject(name, about, covers, stream.data[:size], "truncated", 8 * size, stream.whole(size))


class Stream:
    """A stream as an encoder writes it, and where its frames and symbols are."""

    def __init__(self, resolution, textures, frames):
        self.resolution, self.textures, self.frames = resolution, textures, frames
        self.levels = fields.levels_of(resolution)
        self.coders = [encoder.encode_frame(f, self.levels, textures) for f in frames]
        head = encoder.header(resolution, textures)
        self.data = encoder.stream(head, [coder.bits for coder in self.coders])
        self.starts, at = [], len(encoder.pack(head))
        for coder in self.coders:
            self.starts.append(at + 4)
            at += 4 + len(encoder.pack(coder.bits))

    def whole(self, size):
        """What is whole of the first `size` bytes, which end inside a frame (sections 6 and 7)."""
        n = max(i for i, start in enumerate(self.starts) if start <= size)
        bits = 8 * (size - self.starts[n])
        assert bits < len(self.coders[n].bits)
        symbols = sum(16 + shifts <= bits for shifts in [0] + self.coders[n].shifts[:-1])
        if not self.coders[n].shifts:
            symbols = 0
        level, before = self.deepest(self.frames[n], symbols)
        values = values_of(self.resolution, self.textures, self.frames[:n])
        if level is None:
            return values
        assert n == 0, "a coarser model beside whole ones has no form"
        model = values_of(self.resolution, self.textures, self.frames)
        if level < self.levels:
            return coarse_values(model, level)
        octree, images = self.frames[n]["octree"], self.frames[n]["voxelImageIndex"]
        kept = symbols - len(octree)
        return values_of(self.resolution, self.textures,
                         [frame(octree, images[:kept] + [0] * (len(images) - kept))])

    def deepest(self, model, symbols):
        """The deepest level that is complete with so many whole symbols, and the symbols above it."""
        deepest, total = (None, 0), 0
        for level, (nodes, textures) in enumerate(fields.walk(model, self.levels, self.textures > 0)):
            if level > 0 and total <= symbols:
                deepest = (level, total)
            total += len(nodes) + sum(t is not None for t in textures)
        return deepest


def add_headers(cases):
    header = "8.truncated-header"
    cases.reject("empty", "no byte at all", header, b"", "truncated", 0)
    for name, bits, covers, place in [
            ("resolution-31-of-3", encoder.number(31, 5) + [1] * 3, "2.resolution-bits", 5),
            ("resolution-31-of-11", encoder.number(31, 5) + [1] * 11, "2.resolution-bits", 5),
            ("resolution-31-of-27", encoder.number(31, 5) + [0] * 27, "2.resolution", 5),
            ("resolution-4-of-3", encoder.number(4, 5) + [1] * 3, "2.resolution", 5),
            ("texture-bits-1-of-3", encoder.number(2, 5) + [1, 0] + [0], "2.texture-bits", 7),
            ("texture-bits-0-of-3", encoder.number(3, 5) + [1, 0, 1], "2.texture-bits", 8),
            ("texture-bits-2-of-3", encoder.number(9, 5) + [1] * 9 + [1, 1], "2.texture-bits", 14),
            ("textures-0-of-7", encoder.number(8, 5) + [1] * 8 + [1, 1, 1], "2.textures", 16),
            ("textures-1-of-7", encoder.number(7, 5) + [1] * 7 + [1, 1, 1] + [1], "2.textures", 15),
            ("textures-6-of-7", encoder.number(2, 5) + [1, 0] + [1, 1, 1] + [1] * 6, "2.textures", 10)]:
        assert len(bits) % 8 == 0
        cases.reject("header-" + name, "bits that are there of an element of the header", header + " " + covers,
                     encoder.pack(bits), "truncated", place)
    for name, bits, about in [
            ("width-0", encoder.number(0, 5) + [0] * 3, "in no bit"),
            ("width-0-alone", encoder.number(0, 5) + [0] * 3 + [0] * 8, "in no bit, with an align after it"),
            ("width-1", encoder.number(1, 5) + [0] + [0] * 10, "in one bit"),
            ("width-3", encoder.number(3, 5) + [0] * 3 + [0] * 8, "in three bits"),
            ("width-31", encoder.number(31, 5) + [0] * 31 + [0] * 4, "in 31 bits")]:
        data = encoder.pack(bits) + START + b"\x40"
        cases.reject("resolution-zero-" + name, "octreeResolution is 0, " + about, "8.resolution-zero", data,
                     "malformed", 5)
    cases.reject("resolution-zero-truncated", "octreeResolution is 0, and nothing follows", "8.resolution-zero",
                 encoder.pack(encoder.number(3, 5) + [0] * 3), "malformed", 5)


def add_start_codes(cases):
    head = encoder.pack(encoder.header(2, 0))
    bits = encoder.pack(encoder.encode_frame(frame([105]), 1, 0).bits)
    for size in range(4):
        cases.reject(f"start-code-{size}-of-4", "the data end in the first start code",
                     "8.truncated-start-code 2.one-frame", head + START[:size], "truncated", 16)
    cases.reject("start-code-3-wrong", "three bytes that begin no start code are too few for one",
                 "8.truncated-start-code", head + b"\xff\xff\xff", "truncated", 16)
    for name, code, about in [
            ("first-byte", b"\x01\x00\x01\xc8", "its first byte is wrong"),
            ("second-byte", b"\x00\x01\x01\xc8", "its second byte is wrong"),
            ("third-byte", b"\x00\x00\x00\xc8", "its third byte is wrong"),
            ("fourth-byte", b"\x00\x00\x01\xc9", "its fourth byte is wrong"),
            ("last-bit-high", b"\x00\x00\x01\x48", "a bit is wrong"),
            ("little-endian", b"\xc8\x01\x00\x00", "its bytes are turned round"),
            ("zeros", bytes(4), "there are zeros instead"), ("ones", b"\xff" * 4, "there are ones instead"),
            ("late", b"\x00" + START, "it comes a byte late: it is not searched for"),
            ("early", START[1:], "its first byte is not there"),
            ("late-by-four", bytes(4) + START, "it comes four bytes late"),
            ("none", b"", "the frame follows at once")]:
        cases.reject("start-code-" + name, "the first start code: " + about,
                     "8.missing-start-code 2.start-code" + (" 2.no-searching" if "late" in name else ""),
                     head + code + bits + b"\x5a" * 4, "malformed", 16)
    unaligned = encoder.pack(encoder.header(2, 0) + encoder.number(encoder.START_CODE, 32)) + bits
    cases.reject("start-code-unaligned", "the first start code is not aligned", "8.missing-start-code 2.align-before-frame",
                 unaligned, "malformed", 16)
    cases.reject("start-code-second-align", "a byte of align too many before the first start code",
                 "8.missing-start-code 1.align-to-byte", encoder.pack(encoder.header(200, 0)) + b"\0" + START + bits,
                 "malformed", 16)
    wide = encoder.pack(encoder.header(2, 0, 31, 7))
    cases.reject("start-code-after-wide", "a header with wide numbers and no start code", "8.missing-start-code",
                 wide + b"\x00\x00\x01\xb6" + bits, "malformed", 8 * len(wide))


def add_small_frames(cases):
    for name, resolution, textures, model, about in [
            ("two-bits", 1, 0, frame([]), "a frame without symbols"),
            ("voxel", 1, 127, frame([], [100]), "the texture symbol of a single voxel"),
            ("root", 2, 0, frame([105]), "the root's symbol"),
            ("root-textured", 2, 3, frame([105], [2]), "the root's symbols"),
            ("root-undefined", 2, 3, frame([105], [0, 1, 2, 3, 0]), "the voxels' symbols")]:
        stream = Stream(resolution, textures, [model])
        for size in range(stream.starts[0], len(stream.data)):
            cases.cut(f"cut-{name}-{size - stream.starts[0]}", f"the data end in {about}",
                      "7.truncated-root 6.whole-symbols" + (" 6.no-symbols" if name == "two-bits" else ""), stream, size)


def add_cuts(cases):
    walked = frame([129, 3, 192, 17, 34, 68, 136])
    stream = Stream(8, 0, [walked])
    for size in range(stream.starts[0], len(stream.data)):
        cases.cut(f"cut-nodes-{size - stream.starts[0]}", "the data end in a small octree",
                  "6.whole-symbols 7.truncated-level 7.complete-level", stream, size)
    octree = [131, 7, 3, 129, 1, 3, 5, 9, 17, 33, 65]
    stream = Stream(8, 3, [frame(octree, [0] + [2, 0, 0] + [0, 1, 0, 3] + [2, 3, 0, 1])])
    for size in range(stream.starts[0], len(stream.data)):
        cases.cut(f"cut-images-{size - stream.starts[0]}", "the data end in a small octree with images",
                  "6.whole-symbols 7.truncated-level 7.complete-level 7.truncated-voxels", stream, size)
    full = fields.tree(2, lambda level, n: 255)
    stream = Stream(4, 3, [frame(full, [0] * 9 + [1 + n * n % 3 for n in range(64)])])
    for back in range(1, 8, 2):
        cases.cut(f"cut-voxels-{back}", "the data end in the texture symbols of voxels",
                  "7.truncated-voxels 6.whole-symbols", stream, len(stream.data) - back)
    stream = Stream(GREATEST, 0, [frame([1 << n % 8 for n in range(31)])])
    for size in (8, 12, 16, 20):
        cases.cut(f"cut-deepest-{size}", "the data end in a chain of 31 levels",
                  "7.truncated-level 6.whole-symbols", stream, stream.starts[0] + size)
    stream = Stream(256, 3, [fields.textured(fields.random_tree(8, 9, 900), 8, 3, 10)])
    for part in (1, 3, 5, 7, 9):
        cases.cut(f"cut-stage-2-{part}", "the data end in stage 0, 1 or 2",
                  "7.truncated-level 7.complete-level", stream, len(stream.data) * part // 10)
    cases.cut("cut-last-bytes", "the last two bytes are missing", "6.frame-length", stream, len(stream.data) - 2)


def add_frames(cases):
    two = Stream(4, 2, [frame([129, 1, 128], [1]), frame([24, 7, 9], [0, 1, 2])])
    for more in (0, 1, 2):
        cases.cut(f"cut-second-{more}", "the first frame is whole, the second is not", "2.another-frame 7.truncated-root",
                  two, two.starts[1] + more)
    many = Stream(1, 0, [frame([])] * 6)
    cases.cut("cut-sixth", "five frames are whole, of the sixth there is the start code", "2.another-frame 6.no-symbols",
              many, many.starts[5])


def add_hostile(cases):
    start = encoder.pack(encoder.header(GREATEST, 0)) + START
    full = frame(fields.tree(5, lambda level, n: 255))
    zeros = encoder.encode_frame(full, 5, 0)
    for count in (1, 2, 40, 100):
        # Zeros are the symbol 255 again and again: a full tree.
        assert zeros.bits[:8 * count] == [0] * (8 * count)
        symbols = sum(16 + shifts <= 8 * count for shifts in [0] + zeros.shifts[:-1])
        level = max((k for k in range(1, 6) if (8**k - 1) // 7 <= symbols), default=None)
        whole = values_of(GREATEST, 0, []) if level is None else values_of(
            1 << level, 0, [frame([255] * ((8**level - 1) // 7))])
        cases.reject(f"full-tree-{count}", f"{count} bytes that promise all the nodes of 31 levels",
                     "6.truncated 6.truncated-when 8.no-endless-work 2.levels", start + bytes(count), "truncated",
                     8 * (len(start) + count), whole)
    cases.reject("full-tree-200", "a longer promise", "6.truncated 8.no-endless-work", start + bytes(200), "truncated",
                 8 * (len(start) + 200))
    heads = {0: start, 127: encoder.pack(encoder.header(GREATEST, 127)) + START}
    cases.reject("full-tree-textured", "a full tree whose root has the last image", "6.truncated 8.no-endless-work",
                 heads[127] + bytes(100), "truncated", 8 * (len(heads[127]) + 100))
    for seed in range(1, 9):
        random = fields.Random(seed)
        textures = 127 * (seed % 2)
        data = heads[textures] + bytes(1 + random.below(255) for _ in range(20 * seed))
        cases.reject(f"noise-{seed}", "noise instead of a frame, 31 levels", "6.truncated 8.no-endless-work", data,
                     "truncated", 8 * len(data))
    start_codes = start * 1 + START * 50
    cases.reject("start-codes", "nothing but start codes", "6.truncated 2.pattern-in-frame", start_codes, "truncated",
                 8 * len(start_codes))
    cases.reject("limit-nodes", "zeros that hold more than 2^28 nodes", "8.node-limit", start + bytes(300000),
                 "limit_exceeded")


def add_all(suite):
    cases = Cases(suite)
    for add in (add_headers, add_start_codes, add_small_frames, add_cuts, add_frames, add_hostile):
        add(cases)
