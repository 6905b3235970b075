# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Cases of the suite octree-rules: the stream, the structure of frames, their fields."""
import octree_encoder as encoder
import octree_fields as fields
from octree_decoder import ArithmeticDecoder, NodeModel, POSITIONS
from octree_cases import at, values_of
from octree_fields import frame

ONE_VOXEL = frame([])



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
                "3.texture-after-node 4.1.count", 16, 2, [fields.textured(octree, 4, 2, 12, 9)])


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


def add_all(cases):
    for add in (add_headers, add_widths, add_ends, add_frames, add_patterns, add_structure, add_childless):
        add(cases)
