# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The suite octree-rules: streams that decode, with warnings or without."""
import json

import octree_encoder as encoder
import octree_fields as fields
from octree_decoder import ArithmeticDecoder, NodeModel, POSITIONS
from octree_fields import frame

ONE_VOXEL = frame([])

# Chains of nodes, found by trial; what is said of each is asserted where it is used.
FINISH_LOW = [1]
FINISH_HIGH = [128, 128, 128, 57]
FINISH_QUARTER = [4, 4, 32, 32, 186]
MIDDLE_QUARTER = [2, 191]
PENDING_LOW = [8, 128, 1, 2, 64, 16, 32, 98]
PENDING_HIGH = [64, 128, 1, 2, 45]


class Cases:
    """Adds cases to a suite."""

    def __init__(self, suite):
        self.suite = suite

    def stream(self, name, about, covers, data, values, levels=(), warnings=(), reencode=True):
        """A stream that decodes to `values`, and for each of `levels` to the coarser model."""
        put = self.suite.put
        expect = [{"check": "decode", "as": "octree", **put(name + ".json", compact(values)),
                   "warnings": [w if isinstance(w, dict) else {"code": w} for w in warnings]}]
        for level in levels:
            coarse = compact(coarse_values(values, level))
            expect.append({"check": "decode", "as": "octree", "levels": level,
                           **put(f"{name}.{level}.json", coarse)})
        if reencode:
            expect.append({"check": "reencode"})
        covers = covers.split() + covered_by_levels(values, levels)
        self.suite.case(name, about, "octree", data, expect, ["octree." + rule for rule in covers])

    def model(self, name, about, covers, resolution, textures, frames, levels=(), warnings=()):
        """The stream of these fields as an encoder writes it."""
        coded = [encoder.encode_frame(f, fields.levels_of(resolution), textures).bits for f in frames]
        data = encoder.stream(encoder.header(resolution, textures), coded)
        self.stream(name, about, covers, data, values_of(resolution, textures, frames), levels,
                    warnings)


def values_of(resolution, textures, frames):
    return {"octreeResolution": resolution, "numOfTextures": textures, "frames": frames}


def coarse_values(values, level):
    """Section 7, of a stream of one frame."""
    levels = fields.levels_of(values["octreeResolution"])
    if level >= levels:
        return values
    textures = values["numOfTextures"]
    coarse = fields.coarse(values["frames"][0], levels, textures > 0, level)
    return values_of(1 << level, textures, [coarse])


def compact(values):
    return json.dumps(values, separators=(",", ":"))


def covered_by_levels(values, levels):
    """The rules of section 7 that a question for coarser models touches."""
    covers = []
    if any(fields.levels_of(values["octreeResolution"]) > level for level in levels):
        covers += ["7.levels-resolution", "7.levels-nodes"]
        if values["numOfTextures"] > 0:
            covers += ["7.levels-textures", "7.levels-undefined"]
    if any(fields.levels_of(values["octreeResolution"]) <= level for level in levels):
        covers.append("7.levels-all")
    return covers + ["7.levels-none"] * (0 in levels)


def at(code, bit):
    return {"code": code, "bit": bit}


def add_headers(cases):
    chain = [1, 2, 4, 8, 16, 32, 64, 128]
    for resolution, octree, covers, about in [
            (1, [], "2.levels 3.voxels-have-no-byte 6.no-symbols", "one voxel, no symbol"),
            (2, [105], "2.levels 2.resolution-least-width 2.no-textures-width 1.unsigned", "one node symbol"),
            (3, [128, 128], "2.levels 2.outside-voxels", "the voxel (3,3,3) is beyond the resolution"),
            (5, [129, 128, 1, 128, 1], "2.levels 2.outside-voxels", "the voxel (7,7,7), too"),
            (256, chain, "2.levels", "8 levels"),
            (257, chain + [3], "2.levels", "9 levels"),
            (2**30, chain * 3 + chain[:6], "2.levels 2.resolution-bits", "30 levels"),
            (2**30 + 1, chain * 3 + chain[:7], "2.levels 2.resolution-bits", "31 levels"),
            (2**31 - 1, chain * 3 + chain[:7], "2.resolution 2.resolution-bits 1.msb-first",
             "the greatest resolution")]:
        cases.model(f"resolution-{resolution}", about, covers, resolution, 0, [frame(octree)])
    cases.model("header-two-bytes", "the header ends at a byte boundary: no align", "1.align-to-byte 2.align-before-frame",
                200, 0, [frame(chain)])
    cases.model("header-nearly-two-bytes", "an align of 7 bits after the header", "1.align-to-byte 1.align-zeros",
                2, 0, [frame([7])])
    for textures in (1, 2, 3, 7, 8, 64, 126, 127):
        cases.model(f"textures-{textures}", "a single voxel with the last image",
                    "2.texture-bits 2.textures 2.textures-least-width 2.voxel-texture 4.2.texture-symbols"
                    + (" 2.most-textures" if textures == 127 else ""),
                    1, textures, [frame([], [textures])])
    cases.model("textures-127-undefined", "a single voxel without an image", "3.undefined-voxel 2.voxel-texture",
                1, 127, [frame([], [0])], levels=(0,))


def add_widths(cases):
    for name, resolution, textures, r, t, warnings, about in [
            ("wide-resolution", 2, 0, 31, None, [at("non_minimal_width", 0)], "31 bits for 2"),
            ("wide-resolution-by-one", 256, 0, 10, None, [at("non_minimal_width", 0)], "10 bits for 256"),
            ("wide-textures", 2, 1, None, 7, [at("non_minimal_width", 7)], "7 bits for 1"),
            ("wide-no-textures", 2, 0, None, 1, [at("non_minimal_width", 7)], "a bit for 0"),
            ("wide-both", 1, 2, 4, 3, [at("non_minimal_width", 0), at("non_minimal_width", 9)], "both")]:
        levels = fields.levels_of(resolution)
        octree = [1 << n % 8 for n in range(levels)]
        model = frame(octree, [textures] if textures else [])
        bits = encoder.encode_frame(model, levels, textures).bits
        data = encoder.stream(encoder.header(resolution, textures, r, t), [bits])
        cases.stream(name, "widths that are not the least: " + about,
                     "2.wide-widths-accepted 2.wide-widths-warning" + (" 2.no-textures-width" if t == 1 else ""),
                     data, values_of(resolution, textures, [model]), warnings=warnings, reencode=False)


def flipped(data, bit):
    changed = bytearray(data)
    changed[bit // 8] ^= 128 >> bit % 8
    return bytes(changed)


def add_ends(cases):
    data = encoder.stream(encoder.header(1, 0), [[0, 1]])
    two = encoder.stream(encoder.header(1, 0), [[0, 1]] * 2)
    one = values_of(1, 0, [ONE_VOXEL])
    for name, data_in, values, place, about in [
            ("align-bits-header", flipped(data, 15), one, 9, "after the header"),
            ("align-bits-first", flipped(data, 9), one, 9, "the first bit of the align"),
            ("align-bits-end", flipped(data, 55), one, 50, "after the last frame"),
            ("align-bits-between", flipped(two, 53), values_of(1, 0, [ONE_VOXEL] * 2), 50, "between frames")]:
        cases.stream(name, "a bit of an align is 1: " + about, "2.align-warning 2.align-accepted", data_in,
                     values, warnings=[at("align_bits", place)], reencode=False)
    start = encoder.START_CODE.to_bytes(4, "big")
    for name, tail, about in [
            ("trailing-zero", b"\0", "a zero byte"),
            ("trailing-start-3", start[:3], "three bytes of a start code"),
            ("trailing-other-code", b"\0\0\1\xb6" + b"\x40", "another start code"),
            ("trailing-frame-late", b"\0" + start + b"\x40", "a frame a byte late: start codes are not searched for"),
            ("trailing-frame-unaligned", encoder.pack([0] * 4 + encoder.number(encoder.START_CODE, 32) + [0, 1]),
             "a frame half a byte late"),
            ("trailing-far-frame", b"\xaa" * 9 + start + b"\x40", "a frame behind other bytes")]:
        cases.stream(name, "bytes are left after the last frame: " + about,
                     "2.trailing-accepted 2.trailing-warning" + (" 2.no-searching" if "frame" in name else " 2.end"),
                     data + tail, one, warnings=[at("trailing_bytes", 56)], reencode=False)
    model = frame([3, 1, 2])
    whole = encoder.stream(encoder.header(4, 0), [encoder.encode_frame(model, 2, 0).bits])
    cases.stream("levels-trailing", "a coarser model of a stream with a byte left over", "7.stopping", whole + b"\7",
                 values_of(4, 0, [model]), levels=(1,), warnings=[at("trailing_bytes", 8 * len(whole))], reencode=False)


def add_frames(cases):
    cases.model("frames-2", "two frames", "2.another-frame 2.start-code 2.end 6.frame-length", 4, 0,
                [frame([129, 1, 128]), frame([24, 7, 9])])
    chain = whole_bytes_chain()
    cases.model("frames-no-align", "frames that end at byte boundaries", "2.another-frame 1.align-to-byte 6.frame-length",
                1 << len(chain), 0, [frame(chain)] * 3)
    cases.model("frames-one-bit-more", "frames of 1, 2 .. symbols: their ends are at every bit of a byte",
                "6.frame-length 2.align-before-frame 2.another-frame", 128, 3,
                [frame([1 << n] + [16] * 6, [0] * n + [3]) for n in range(8)])
    cases.model("frames-40-empty", "forty empty objects", "2.another-frame 3.empty-object", 8, 0, [frame([0])] * 40)
    cases.model("frames-single-voxels", "frames of two bits", "6.no-symbols 2.another-frame", 1, 0, [ONE_VOXEL] * 5)
    octree = fields.random_tree(6, 77, 250)
    images = fields.random_images(octree, 6, 5, 78)
    cases.model("frames-alike", "the same frame three times has the same bits",
                "2.frames-independent 2.frames-independent-textures 6.initial-interval", 64, 5, [frame(octree, images)] * 3)


def whole_bytes_chain():
    """A chain of nodes whose frame ends at a byte boundary."""
    return next(chain for n in range(1, 32) for chain in [[1] * n]
                if len(encoder.encode_frame(frame(chain), n, 0).bits) % 8 == 0)


def fields_of_data(data, levels, textures):
    """The fields that a frame of any bytes decodes to, by the independent decoder's coder."""
    coder, nodes, table = ArithmeticDecoder(data + bytes(4000), 0), NodeModel(), [1] * (textures + 1)
    octree, images, level = [], [], [(0, 0, textures > 0)]
    for _ in range(levels):
        below = []
        for parent, position, undefined in level:
            octree.append(nodes.decode(coder, parent, position))
            if undefined:
                images.append(coder.symbol(table, 32, 512))
                undefined = images[-1] == 0
            below += [(octree[-1], child, undefined) for child in POSITIONS[octree[-1]]]
        level = below
    images += [coder.symbol(table, 32, 512) for _, _, undefined in level if undefined]
    return frame(octree, images)


def add_patterns(cases):
    pattern = encoder.START_CODE.to_bytes(4, "big")
    for name, before, textures in [("pattern-first", b"", 0), ("pattern-inside", b"\x6e\xd1\x35", 0),
                                   ("pattern-twice", b"\x9b\x17\x66\x01" + pattern + b"\x5c\xa3", 127)]:
        model = fields_of_data(before + pattern + b"\x6b\x3d\x91\x7a\xc5\x5e\x12\x39" * 4, 3, textures)
        bits = encoder.encode_frame(model, 3, textures).bits
        data = encoder.pack(bits)
        assert data.count(pattern) == (before + pattern).count(pattern), name
        assert data.index(pattern) + 5 < len(data), name
        cases.model(name, "the frame's own data hold the bytes of a start code", "2.pattern-in-frame 2.no-searching",
                    8, textures, [model, model])


def add_structure(cases):
    cases.model("walk-order", "all nodes of a level differ",
                "3.breadth-first 3.byte-per-node", 8, 0,
                [frame([0b10000001, 3, 192, 17, 34, 68, 136])], levels=(0, 1, 2, 3, 5))
    cases.model("textures-at-levels", "images named at the root's children, at nodes and at voxels",
                "3.texture-zero 3.texture-inherited 3.texture-after-node 3.voxel-textures 3.field-index", 8, 3,
                [frame([131, 7, 3, 129, 1, 3, 5, 9, 17, 33, 65], [0] + [2, 0, 0] + [0, 1, 0, 3] + [2, 3, 0, 1])],
                levels=(0, 1, 2, 3))
    octree = fields.tree(3, lambda level, n: 255 if level == 0 else 129 + 2 * n % 64)
    for name, images, covers in [
            ("texture-at-root", [4], "3.texture-inherited 2.root-texture 3.texture-names-image"),
            ("texture-at-voxels", None, "3.voxel-textures 3.undefined-voxel 4.2.one-table"),
            ("texture-mixed", fields.random_images(octree, 3, 4, 5, 6), "3.texture-zero 3.texture-after-node 4.1.count")]:
        if images is None:
            nodes = len(octree)
            images = [0] * nodes + [n % 5 for n in range(fields.children(octree) + 1 - nodes)]
        cases.model(name, "where the images are named", covers, 8, 4, [frame(octree, images)], levels=(0, 1, 2, 3))
    cases.model("no-textures", "no texture symbol at all", "3.no-textures", 8, 0, [frame(octree)], levels=(1, 2))
    octree = fields.tree(4, lambda level, n: 255 if level == 0 else (n * 37 + level * 11) % 255 + 1)
    cases.model("texture-order", "node and texture symbols take turns",
                "3.texture-after-node 4.1.count", 16, 2, [textured(octree, 4, 2, 12, 9)])


def add_childless(cases):
    cases.model("empty-object", "the root has no children: no warning", "3.empty-object 3.childless-warning", 16, 0,
                [frame([0])], levels=(0, 1, 4))
    cases.model("empty-object-textured", "an empty object with an image", "3.empty-object 2.root-texture", 16, 2,
                [frame([0], [2])], levels=(0, 1))
    cases.model("empty-object-undefined", "an empty object without an image", "3.empty-object 2.root-texture", 16, 2,
                [frame([0], [0])], levels=(0, 1))
    covers = "3.childless-accepted 3.childless-warning 7.childless-coarser"
    warning = ["octree_childless_node"]
    cases.model("childless-last", "a childless node in the last level", covers, 4, 0, [frame([129, 0, 7])],
                levels=(1, 2), warnings=warning)
    cases.model("childless-early", "a childless node above the last level", covers, 16, 0,
                [frame([7, 0, 3, 0, 0, 128, 5])], levels=(1, 2, 3), warnings=warning)
    cases.model("childless-all", "every child of the root is childless", covers, 16, 0, [frame([255] + [0] * 8)],
                levels=(1, 2), warnings=warning)
    cases.model("childless-textured", "childless nodes whose images are undefined have no voxels", covers, 8, 3,
                [frame([15, 0, 3, 0, 1, 0, 129, 2], [0] + [0, 0, 0, 2] + [0, 0] + [3, 0])], levels=(0, 1, 2),
                warnings=warning)
    cases.model("childless-frames", "a warning for each frame", covers, 4, 0,
                [frame([3, 0, 0]), frame([3, 1, 1]), frame([3, 1, 0])], warnings=warning * 2)


def add_stages(cases):
    stage1 = "4.1.stage1-start 4.1.counted-symbol 3.field-octree 4.1.stage1-copies 4.1.stage1-symbol 4.1.stage1-step 4.1.stage0-symbol 4.1.stage0-step 4.1.inverse"
    stage2 = "4.1.stage2-start 4.1.stage2-copies 4.1.stage2-symbol 4.1.stage2-step 4.1.stage2-position 4.1.stage2-class"
    for nodes in (512, 513, 514):
        cases.model(f"nodes-{nodes}", "so many node symbols", "4.1.stage1-start", 4096, 0, [frame(exactly(nodes))])
    cases.model("stage-0", "symbols of stage 0 alone", "4.1.stage0-table 4.1.stage0-symbol 4.1.stage0-step 4.1.start-at-one "
                "4.1.node-symbols 6.cumulative 6.target 6.narrow-high 6.narrow-low 6.length 1.division",
                256, 0, [frame(fields.random_tree(8, 3, 75))])
    cases.model("stage-1", "symbols of any kind into stage 1", stage1, 256, 0, [frame(reaching(700, fields.random_tree(8, 21, 200)))])
    cases.model("stage-2", "symbols of any kind into stage 2", stage1 + " " + stage2, 1024, 0,
                [frame(reaching(2700, fields.random_tree(10, 4, 560)))])
    cases.model("stage-2-textured", "N counts node symbols alone", "4.1.count " + stage2, 256, 3,
                [textured(reaching(2700, fields.random_tree(8, 9, 900)), 8, 3, 10)])
    cases.model("shell-32", "a sphere's surface", stage1, 32, 0, [frame(fields.octree_of(fields.shell(32), 5))],
                levels=(3, 4))
    cases.model("shell-64", "a finer one", stage2, 64, 0, [frame(fields.octree_of(fields.shell(64), 6))], levels=(2, 5))
    octree = every_parent()
    cases.model("every-parent", "every symbol is a parent in stage 1 and in stage 2",
                "4.1.stage1-tables 4.1.stage2-class 4.1.stage2-position-transformed 3.order-of-parents 4.1.symmetry-of-parent 3.parents-own-byte "
                "3.child-bits 3.child-index 3.larger-half 3.order-of-siblings 5.numbering 5.permutation 5.permutations "
                "5.flips-after 5.flip-bits 5.symbols 5.classes 5.base 5.class-numbers 5.smallest-symmetry", 64, 0,
                [frame(octree)])


def reaching(nodes, octree):
    assert len(octree) >= nodes, len(octree)
    return octree


def exactly(nodes):
    """An octree of 12 levels with so many nodes, any symbols."""
    counts = [1, 4, 10, 20, 30, 40, 50, 50, 50, 50, 50]
    counts.append(nodes - sum(counts))
    random, octree = fields.Random(nodes), []
    for count, below in zip(counts, counts[1:]):
        octree += split(random, count, below)
    return octree + [1 + random.below(255) for _ in range(counts[-1])]


def split(random, nodes, below):
    """Symbols of that many nodes that have `below` children together, each at least one."""
    counts = [1] * nodes
    while sum(counts) < below:
        n = random.below(nodes)
        counts[n] += counts[n] < 8
    symbols = []
    for count in counts:
        symbol = 0
        while bin(symbol).count("1") < count:
            symbol |= 1 << random.below(8)
        symbols.append(symbol)
    return symbols


def textured(octree, levels, textures, seed, of_ten=7):
    return frame(octree, fields.random_images(octree, levels, textures, seed, of_ten))


def every_parent():
    """Three full levels; then all symbols but 0 twice; then all, and single children; then any."""
    random = fields.Random(8)
    symbols = [1 + n * 101 % 255 for n in range(510)] + [255, 254]

    def symbol(level, n):
        if level < 3:
            return 255
        if level == 3:
            return symbols[n]
        if level == 4:
            return 1 + n * 59 % 255 if n % 4 == 0 else 1 << random.below(8)
        return 1 + random.below(255)
    return fields.tree(6, symbol)


def add_halving(cases):
    random = fields.Random(31)
    few = [3, 5, 17, 80, 160, 204]
    cases.model("halving-classes", "tables of the class 255 reach exactly 8192, and pass it",
                "4.1.limit 4.1.limit-exceeded 4.1.halving", 32, 0,
                [frame(fields.tree(5, lambda level, n: 255 if level < 4 else random.of(few)))])
    single = [1 << n for n in range(8)]
    cases.model("halving-again", "one table is halved three times", "4.1.limit 4.1.halving 4.1.stage2-step", 4096, 0,
                [frame(fields.tree(12, lambda level, n: 255 if level < 3 else random.of(single)))])
    for textures, count in ((31, 120), (3, 150), (1, 200), (127, 60)):
        levels = 4
        octree = fields.tree(levels, lambda level, n: [255, 255, 0b01011010, 17][level])
        nodes, voxels = len(octree), fields.children(octree) + 1 - len(octree)
        images = [0] * nodes + [random.below(textures + 1) if n > voxels // 3 else 1 for n in range(voxels)]
        cases.model(f"halving-textures-{textures}", "the table of texture symbols is halved",
                    "4.2.step 4.2.limit 4.2.halving 4.2.start-at-one 4.2.texture-symbols 4.2.one-table"
                    + (" 4.2.limit-exceeded" if textures in (31, 127) else ""), 16, textures, [frame(octree, images)])


def add_coder(cases):
    for name, octree, covers, about, holds in [
            ("pending-chain-low", PENDING_LOW, "6.pending 6.pending-spent 6.middle", "many pending bits end as 0111..",
             lambda coder: coder.longest >= 10),
            ("pending-chain-high", PENDING_HIGH, "6.pending 6.pending-spent 6.middle", "many pending bits end as 1000..",
             lambda coder: coder.longest >= 10),
            ("finish-low", FINISH_LOW, "6.finish 6.finish-pending 6.lower-half", "low < Q1 at the end",
             lambda coder: coder.low < encoder.Q1),
            ("finish-high", FINISH_HIGH, "6.finish 6.finish-pending 6.upper-half", "low > Q1 at the end",
             lambda coder: coder.low > encoder.Q1),
            ("finish-quarter", FINISH_QUARTER, "6.finish", "low = Q1 at the end",
             lambda coder: coder.low == encoder.Q1),
            ("middle-quarter", MIDDLE_QUARTER, "6.middle-from-quarter", "an interval from exactly Q1 is doubled",
             lambda coder: coder.middles_at_quarter > 0)]:
        levels = len(octree)
        assert holds(encoder.encode_frame(frame(octree), levels, 0)), name
        cases.model(name, about, covers, 1 << levels, 0, [frame(octree)])
    cases.model("target-rounding", "many symbols near the ends of their intervals", "6.target 6.narrow-high 6.narrow-low",
                64, 6, [textured(fields.random_tree(6, 61, 300), 6, 6, 62, 8)])
    # Frame 01010101: t = ((0x5500 + 1) * 3 - 1) / 65536 = 0, symbol 2; ones after it would make t 1.
    data = encoder.stream(encoder.header(1, 2), [[0, 1, 0, 1, 0, 1, 0, 1]])
    cases.stream("zeros-past-end", "the symbol depends on bits past the end of the data",
                 "6.zeros-past-end 6.decoder-start 6.ending-low 6.ending-accepted", data, values_of(1, 2, [frame([], [2])]),
                 warnings=[{"code": "octree_bad_ending"}, at("align_bits", 51)], reencode=False)
    for name, octree, ending, rule in [
            ("ending-low-0", FINISH_LOW, [0, 0], "low"), ("ending-low-2", FINISH_LOW, [1, 0], "low"),
            ("ending-low-3", FINISH_LOW, [1, 1], "low"), ("ending-high-1", FINISH_QUARTER, [0, 1], "high"),
            ("ending-high-3", FINISH_HIGH, [1, 1], "high")]:
        levels = len(octree)
        coder = encoder.encode_frame(frame(octree), levels, 0)
        code = (2 * ending[0] + ending[1]) << 14  # the 16 bits after the shifts: these and zeros
        assert coder.low <= code <= coder.high, "it decodes to the same symbols"
        assert (coder.low < encoder.Q1) == (rule == "low"), name
        data = encoder.stream(encoder.header(1 << levels, 0), [coder.with_ending(*ending)])
        cases.stream(name, f"a frame that ends with {ending[0]}{ending[1]}, though low is {coder.low}",
                     f"6.ending-{rule} 6.ending-accepted", data, values_of(1 << levels, 0, [frame(octree)]),
                     warnings=["octree_bad_ending"], reencode=False)


def add_all(suite):
    cases = Cases(suite)
    for add in (add_headers, add_widths, add_ends, add_frames, add_patterns, add_structure, add_childless,
                add_stages, add_halving, add_coder):
        add(cases)
