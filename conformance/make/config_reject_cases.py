# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Configurations that are to be refused."""
from bifs_cases import group
from command_writer import SceneStream, command as c
from mp4_boxes import Movie, Track, scene_track
from scene_values import Node

CONFIG = 22  # bytes of an ES_Descriptor before the specific info


def file_with(config, object_type=1, scene=None):
    """A file whose scene track has this configuration; and the bit at which it begins."""
    stream = scene or SceneStream().unit(c("scene", group(Node("Shape"))))
    track = scene_track(stream)
    file, places = Movie([Track(1, track.samples, track.times, object_type=object_type, config=config)]).write()
    return file, 8 * (places["moov/trak/mdia/minf/stbl/stsd/mp4s/esds.descriptor"] + CONFIG)


def all_cases():
    def one(name, about, config, code, bit, covers, **how):
        file, begin = file_with(config, **how)
        return name, about, file, code, None if bit is None else begin + bit, covers
    full = SceneStream(size=(320, 240)).config_bits()
    # nodeIDbits 4, routeIDbits 0, commands, metric, size: 5 + 5 + 3 bits, then 16 and 16.
    for size, element in ((1, "routeIDbits"), (2, "pixelWidth"), (4, "pixelHeight")):
        yield one(f"config-cut-{element.lower()}", f"a configuration that ends inside {element}", full.bytes()[:size],
            "truncated", None, "2.truncated")
    yield one("config-animation", "the configuration of an animation", b"\x20\x00", "unsupported", None, "2.anim")
    yield one("config-extended", "a configuration of object type 4", b"\x20\x1c\x00", "unsupported", None,
        "2.extended", object_type=4)
    mesh = SceneStream(version=2, mesh=True).unit(c("scene", group(Node("Shape", geometry=Node("IndexedFaceSet")))))
    yield one("config-mesh", "a scene with an IndexedFaceSet as 3D mesh bitstream", mesh.config_bits().bytes(),
        "unsupported", None, "2.mesh",
              object_type=2, scene=mesh)
