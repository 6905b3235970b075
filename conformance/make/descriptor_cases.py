# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The cases of suites/mp4-syntax about descriptors and object descriptor streams."""
from bits import BitWriter
from mp4_boxes import descriptor, es_descriptor, initial_object, u16, u32, u8
from mp4_cases import es_ref, movie, object_descriptor, od_command, scene, with_media


def descriptors():
    for count in (2, 3, 4):
        track = scene()
        track.es = es_descriptor(1, 3, track.config, length_bytes=count)
        yield f"length-{count}", f"lengths of descriptors in {count} bytes", movie(track,
            iods=initial_object(1, length_bytes=count)), \
            "2.length 2.length-long"
    long = scene()
    long.es = es_descriptor(1, 3, long.config, after=descriptor(0x80, bytes(300), length_bytes=2), length_bytes=2)
    yield "length-200", "a descriptor of three hundred bytes", movie(long), "2.length 2.unknown"
    none = with_media()
    for track, config in ((none.tracks[2], None), (none.tracks[3], b"")):
        track.config, track.es = config, es_descriptor(track.object_type, 4, config)
    yield "no-info", "configurations without specific info, and with an empty one", none, "2.no-info"
    options = {"depends": (0x80, u16(7)), "url": (0x40, u8(5) + b"a.mp4"), "clock": (0x20, u16(9)),
        "all": (0xFF, u16(7) + u8(1) + b"u" + u16(9))}
    for name, (flags, more) in options.items():
        made = with_media()
        track = made.tracks[2]
        track.es = es_descriptor(0x6C, 4, b"", flags=flags, more=more)
        yield f"es-{name}", f"an ES_Descriptor with options: {name}", made, "2.es-options"
    tags = [0x07, 0x08, 0x09, 0x0A, 0x0B, 0x0C, 0x0D, 0x12, 0x13, 0x14, 0x40, 0x43, 0x69, 0x7F, 0x80, 0xC0, 0xFE]
    track = scene()
    track.es = es_descriptor(1, 3, track.config, after=b"".join(descriptor(tag,
        b"\0" * 12) for tag in tags if tag >= 0x80 or tag in (0x13, 0x14)))
    yield "unknown-descriptors", "descriptors of unknown tags in an ES_Descriptor", movie(track), "2.unknown 2.tags"
    full = u8(0) + u8(4) + u32(1000, 0) + u8(32) + u8(0) + u8(0) + u8(0) + u16(0)
    explicit = scene()
    explicit.es = es_descriptor(1, 3, explicit.config, sl=descriptor(6, full))
    yield "sl-config", "an SL configuration that is spelled out", movie(explicit), "2.es"
    yield "iods-url", "an initial object descriptor with a URL", movie(iods=descriptor(0x10, b"\x00\x6f",
        u8(5) + b"a.mp4")), "3.iods-url"
    absent = movie()
    absent.change = lambda moov: moov.remove("iods")
    absent.iods = None
    yield "iods-absent", "no initial object descriptor", absent, "3.iods-absent"
    turned = with_media()
    ids = [descriptor(0x0E, u32(id)) for id in (2, 1)]
    turned.iods = descriptor(0x10, b"\x00\x4f\xff\xfe\xff\xfe\xfe", *ids)
    yield "iods-reversed", "the object descriptor track before the scene in the initial object descriptor", turned, "3.iods"
    inline = movie(iods=initial_object(1, head=b"\x04\x1f", profiles=b"\1\2\3\4\5"))
    yield "iods-profiles", "other ID, inline profiles and levels", inline, "3.iods"


def object_descriptors():
    update = od_command(1, object_descriptor(10, es_ref(1)))
    removed = BitWriter()
    for id in (10, 11, 1022):
        removed.u(10, id)
    remove_es = u16(10 << 6) + u16(1)
    cases = {
        "update": ("object descriptors with references, in one command and in two",
            [update + od_command(1, object_descriptor(11, es_ref(2), es_ref(1)))],
                   "4.update 4.reference"),
        "remove": ("object descriptors removed, three IDs in 30 bits", [update, od_command(2, removed.bytes())],
            "4.remove"),
        "url": ("an object descriptor somewhere else", [od_command(1,
            object_descriptor(12, url=b"http://example.org/b.mp4"))], "4.url"),
        "es-remove": ("streams removed by reference", [update, od_command(7, remove_es)], "4.es-remove"),
        "es-remove-id": ("streams removed by ES_ID", [update, od_command(4, remove_es)], "4.es-remove"),
        "ipmp": ("commands that are not about streams", [update + od_command(5, b"\0") + od_command(6, b"\0\1")],
            "4.update"),
        "empty": ("a command without descriptors", [od_command(1) + od_command(2)], "4.update 4.remove"),
        "user": ("a command of an unknown tag", [update + od_command(0xC5, b"anything")], "2.unknown"),
        "whole-es": ("a whole ES_Descriptor in the command",
            [od_command(1, object_descriptor(10, es_descriptor(0x6C, 4, b"", es_id=10), tag=1))], "2.tags 4.update"),
        "extensions": ("an object descriptor with further descriptors", [od_command(1, object_descriptor(
            10, es_ref(1), descriptor(0x40, b"\0" * 9), descriptor(0xD0, b"xyz")))], "2.unknown"),
        "long": ("a command of two hundred descriptors",
            [od_command(1)[:0] + descriptor(1, *[object_descriptor(i, es_ref(1)) for i in range(1, 201)],
                                                                                 length_bytes=2)], "4.update 2.length"),
    }
    for name, (about, commands, covers) in cases.items():
        yield f"od-{name}", about, with_media(commands), covers
    for name, align in (("aligned", True), ("unaligned", False)):
        out = BitWriter()
        out.u(10, 10)
        if align:
            out.u(6, 0)
        out.data(es_ref(2))
        if not align:
            yield f"od-es-update-{name}", "streams of one object, directly behind its 10 bits", with_media([update,
                od_command(3, out.bytes())]), "4.es-update"


def all_cases():
    yield from descriptors()
    yield from object_descriptors()
