# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Cases of the suite octree-rules: contexts, tables, symmetries and the arithmetic coder."""
import octree_encoder as encoder
import octree_fields as fields
from octree_cases import at, values_of
from octree_fields import frame

# Chains of nodes, found by trial; what is said of each is asserted where it is used.
FINISH_LOW = [1]
FINISH_HIGH = [128, 128, 128, 57]
FINISH_QUARTER = [4, 4, 32, 32, 186]
MIDDLE_QUARTER = [2, 191]
PENDING_LOW = [8, 128, 1, 2, 64, 16, 32, 98]
PENDING_HIGH = [64, 128, 1, 2, 45]


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
                [fields.textured(reaching(2700, fields.random_tree(8, 9, 900)), 8, 3, 10)])
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
                64, 6, [fields.textured(fields.random_tree(6, 61, 300), 6, 6, 62, 8)])
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


def add_all(cases):
    for add in (add_stages, add_halving, add_coder):
        add(cases)
