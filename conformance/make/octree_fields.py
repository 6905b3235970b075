# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Fields of OctreeImages by formula, and coarser ones of them."""


class Random:
    """The numbers of a linear congruential generator: the same on every machine."""

    def __init__(self, seed):
        self.state = seed * 2654435761 % 2**64

    def below(self, n):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return (self.state >> 33) % n

    def of(self, values):
        return values[self.below(len(values))]


def levels_of(resolution):
    return (resolution - 1).bit_length()


def children(symbols):
    return sum(bin(symbol).count("1") for symbol in symbols)


def walk(frame, levels, textured):
    """For each level, that of the voxels too, its node symbols ([] for voxels) and for each of its
    nodes the texture symbol, None where it has none."""
    nodes, images = iter(frame["octree"]), iter(frame["voxelImageIndex"])
    undefined = [textured]
    for level in range(levels + 1):
        symbols = [next(nodes) for _ in undefined] if level < levels else []
        textures = [next(images) if u else None for u in undefined]
        yield symbols, textures
        undefined = [t == 0 for s, t in zip(symbols, textures) for _ in range(children([s]))]


def coarse(frame, levels, textured, level):
    """Section 7: the model of `level` levels."""
    octree, images = [], []
    for n, (symbols, textures) in enumerate(walk(frame, levels, textured)):
        known = [t for t in textures if t is not None]
        if n == level:
            return {"octree": octree, "voxelImageIndex": images + [0] * len(known)}
        octree += symbols
        images += known
    raise ValueError(level)


def octree_of(voxels, levels):
    """The octree of voxels (x, y, z)."""
    result = []
    for _ in range(levels):
        parents = {}
        for x, y, z in voxels:
            at = (x >> 1, y >> 1, z >> 1)
            parents[at] = parents.get(at, 0) | 1 << ((x & 1) + 2 * (y & 1) + 4 * (z & 1))
        result.append(parents)
        voxels = parents
    octree, level = [], [(0, 0, 0)]
    for parents in reversed(result):
        octree += [parents[at] for at in level]
        level = [(2 * x + (i & 1), 2 * y + (i >> 1 & 1), 2 * z + (i >> 2))
                 for x, y, z in level for i in range(8) if parents[(x, y, z)] >> i & 1]
    return octree


def shell(size):
    """The voxels of a sphere's surface in a cube of that size."""
    def inside(x, y, z):
        return sum((2 * c + 1 - size) ** 2 for c in (x, y, z)) < size * size
    cube = range(size)
    steps = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    return [(x, y, z) for x in cube for y in cube for z in cube if inside(x, y, z)
            and not all(inside(x + a, y + b, z + c) for a, b, c in steps)]


def tree(levels, symbol):
    """An octree whose node symbols are symbol(level, number in the level)."""
    octree, count = [], 1
    for level in range(levels):
        nodes = [symbol(level, n) for n in range(count)]
        octree += nodes
        count = children(nodes)
    return octree


def random_tree(levels, seed, most):
    """Any symbols but 0, with few children from where a level would get more than `most` nodes."""
    random, octree, count = Random(seed), [], 1
    for _ in range(levels):
        nodes, count_below = [], 0
        for left in range(count, 0, -1):
            symbol = 1 + random.below(255)
            if count_below + children([symbol]) + left - 1 > most:
                symbol = 1 << random.below(8)
            nodes.append(symbol)
            count_below += children([symbol])
        octree += nodes
        count = count_below
    return octree


def random_images(octree, levels, textures, seed, of_ten=7):
    """Texture symbols for an octree; a node is left undefined `of_ten` times in ten."""
    random, images, at, undefined = Random(seed), [], 0, [True]
    for level in range(levels + 1):
        symbols = octree[at:at + len(undefined)] if level < levels else [0] * len(undefined)
        at += len(undefined)
        own = [(0 if random.below(10) < of_ten else 1 + random.below(textures)) if u else None
               for u in undefined]
        images += [k for k in own if k is not None]
        undefined = [k == 0 for s, k in zip(symbols, own) for _ in range(children([s]))]
    return images


def frame(octree, images=()):
    return {"octree": list(octree), "voxelImageIndex": list(images)}


def textured(octree, levels, textures, seed, of_ten=7):
    return frame(octree, random_images(octree, levels, textures, seed, of_ten))
