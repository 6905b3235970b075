# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Cases of OctreeImage streams that decode, and the values that are expected."""
import json

import octree_encoder as encoder
import octree_fields as fields


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
