# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The suite octree-model: the streams and fields that stand in its folder, described; they come from
another program and are never made again. What is made are coarser models of some."""
import json
import os
import zlib

from octree_cases import coarse_values, compact, covered_by_levels

ORIGINS = {
    "model": {"text": "A slow, literal model of the coder that shares no code with this project.",
              "licence": "BSD-2-Clause"},
    "model-spot": {"text": "The same model, from 'Spot' by Keenan Crane.", "licence": "LicenseRef-public-domain"},
    "model-nefertiti": {"text": "The same model, from a scan by Nora Al-Badri and Jan Nikolai Nelles.",
                        "licence": "LicenseRef-public-domain"},
    "model-waterbottle": {"text": "The same model, from the water bottle by Microsoft.", "licence": "CC0-1.0"}}

STAGES = "4.1.stage1-tables 4.1.stage2-class 4.1.stage2-position 4.1.stage2-step 5.symbols 5.base"
TEXTURES = "3.texture-zero 3.texture-inherited 4.2.step"
CASES = [  # name, about, covers, levels that are asked for
    ("empty-2", "root symbol 0", "3.empty-object", (0,)),
    ("empty-256-textured", "empty object, one texture symbol", "3.empty-object 2.root-texture", (0, 3)),
    ("one-voxel-1", "resolution 1: no node symbol at all", "2.levels 6.no-symbols", ()),
    ("one-voxel-1-textured", "one texture symbol and nothing else", "2.voxel-texture", (0,)),
    ("corner-2", "x half set: child 1, byte 2", "3.child-index 3.child-bits 3.larger-half", ()),
    ("corner-4-y", "y half set", "3.child-index 3.child-bits", (1,)),
    ("corner-8-z", "z half set", "3.child-index 3.child-bits", (2,)),
    ("finish-at-quarter", "the coder ends with low exactly at the first quarter: finish writes 1, not 0", "6.finish", ()),
    ("full-16", "every symbol 255; crosses symbol 512", "4.1.stage1-start", (3,)),
    ("resolution-100", "not a power of two: 7 levels", "2.levels 2.outside-voxels", (5, 7)),
    ("resolution-257", "9 levels", "2.levels", (8, 9)),
    ("zero-symbol-inside", "a childless inner node: decoded with a warning",
     "3.childless-accepted 3.childless-warning 7.childless-coarser", (1,)),
    ("texture-uniform", "one texture symbol at the root", "3.texture-inherited", (2,)),
    ("texture-127", "127 images", TEXTURES + " 2.most-textures 4.2.limit", (3,)),
    ("surface-64-textured", "a surface with six images", TEXTURES + " " + STAGES, (2, 5)),
    ("surface-64-undefined-voxels", "some voxels keep texture 0", TEXTURES + " 3.undefined-voxel", (5,)),
    ("frames-3", "three independent frames", "2.frames-independent 2.frames-independent-textures 2.another-frame", ()),
    ("random-dense", "many children", "4.1.stage0-table", ()),
    ("random-sparse", "few children", "4.1.stage0-table", (4,)),
    ("random-half", "any symbols", "4.1.stage0-table", ()),
    ("deep-chain", "20 levels, one voxel", "2.levels", (10,)),
    ("deepest", "31 levels, the widest resolution", "2.levels 2.resolution-bits", (21, 30)),
    ("nefertiti-256", "real model, geometry only", STAGES, (3,)),
    ("nefertiti-256-textured", "real model, six images", STAGES + " " + TEXTURES, (3,)),
    ("spot-256", "real model, geometry only", STAGES + " 4.1.halving", (4,)),
    ("spot-256-textured", "real model, six images", STAGES + " " + TEXTURES, (4,)),
    ("waterbottle-512", "real model, geometry only", STAGES + " 4.1.halving", (4,))]


def add_all(suite):
    for name, about, covers, levels in CASES:
        packed = os.path.exists(os.path.join(suite.folder, name + ".json.z"))
        file = name + (".json.z" if packed else ".json")
        text = read(suite, file)
        values = json.loads(zlib.decompress(text) if packed else text)
        warnings = [{"code": "octree_childless_node"}] if name == "zero-symbol-inside" else []
        expect = [{"check": "decode", "as": "octree", **suite.put(file, text), "warnings": warnings},
                  {"check": "reencode"}]
        expect += [{"check": "decode", "as": "octree", "levels": level,
                    **suite.put(f"{name}.{level}.json", compact(coarse_values(values, level)))}
                   for level in levels]
        origin = "model-" + name.split("-")[0]
        covers = covers.split() + covered_by_levels(values, levels)
        suite.case(name, about, "octree", name + ".afx", expect, ["octree." + rule for rule in covers],
                   origin if origin in ORIGINS else "model")


def read(suite, name):
    with open(os.path.join(suite.folder, name), "rb") as file:
        return file.read()
