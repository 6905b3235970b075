# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The cases of suites/mp4-syntax: files and object descriptors. Each is (name, about, movie, covers); the movie's tracks
are what a reader must find."""
import struct

from bifs_cases import simple
from bits import BitWriter
from command_writer import command as c
from mp4_boxes import Box, Movie, Track, descriptor, initial_object, scene_track, u16, u32, u64, u8

JPEG = bytes.fromhex("ffd8ffe000104a46494600010100000100010000ffd9")
PNG = b"\x89PNG\r\n\x1a\n" + bytes(20)


def scene(id=1, units=3):
    stream = simple()
    for i in range(units - 1):
        stream.unit(c("replace_field", 2, "translation", [i, 0.5, -i]))
    track = scene_track(stream, id)
    track.stream = stream
    return track


def movie(*tracks, **how):
    return Movie(list(tracks) or [scene()], **how)


def od_command(tag, *parts):
    return descriptor(tag, *parts)


def object_descriptor(id, *parts, tag=0x11, url=None):
    out = BitWriter()
    out.u(10, id)
    out.u(1, int(url is not None))
    out.u(5, 31)
    body = u8(len(url)) + url if url is not None else b""
    return descriptor(tag, out.bytes(), body, *parts)


def es_ref(index):
    return descriptor(0x0F, u16(index))


def with_media(commands=None, refs=None):
    """A scene, an object descriptor track and two pictures."""
    commands = commands or [od_command(1, object_descriptor(10, es_ref(1)), object_descriptor(11, es_ref(2)))]
    od = Track(2, commands, handler="odsm", stream_type=1, refs=refs or {"mpod": [10, 11]})
    jpeg = Track(10, [JPEG], [0], "vide", "mp4v", 0x6C, 4)
    png = Track(11, [PNG, PNG + b"x"], [0, 40], "vide", "mp4v", 0x6D, 4, config=None)
    return movie(scene(), od, jpeg, png)


def changed(made, change):
    made.change = change
    return made


def stbl(moov, track=0):
    return moov.child(("trak", track), "mdia", "minf", "stbl")


def replaced(box, kind, new):
    box.parts = [new if isinstance(part, Box) and part.kind == kind else part for part in box.parts]


def layout():
    yield "minimal", "one scene track", movie(
        ), "1.box 1.scene 1.sample 1.times 1.stsz 1.stco 3.iods 5.object-type 2.es 2.config"
    yield "movie-last", "the movie behind the data", movie(order=("ftyp", "mdat", "moov")), "1.order"
    large = movie()
    large.large_mdat = True
    yield "data-large", "data in a box with a size of 64 bits", large, "1.large-size"
    large = movie()
    large.change = lambda moov: setattr(moov, "large", True) or moov
    yield "movie-large", "a movie in a box with a size of 64 bits", large, "1.large-size"
    end = movie()
    end.open_data = True
    yield "data-to-end", "data to the end of the file", end, "1.to-end"
    junk = [Box("free", bytes(3)), Box("skip"), Box("uuid", bytes(range(16)), b"x"), Box("ab\xa9d", b"anything")]

    def strew(box):
        if box.kind in ("moov", "trak", "mdia", "minf", "stbl", "dinf"):
            for part in box.parts:
                if isinstance(part, Box):
                    strew(part)
            box.parts = [junk[0], *box.parts, *junk[1:], Box("udta", Box("name", b"me"))]
        return box
    made = movie(order=("free", "ftyp", "skip", "moov", "uuid", "mdat", "ab\xa9d"), extra=junk)
    yield "unknown-boxes", "free space, user data and unknown boxes everywhere", changed(made,
        strew), "1.unknown-box 1.metadata"
    gap = movie()
    gap.gap = 7
    yield "data-gap", "data that begin with bytes of nobody", gap, "1.stco"
    yield "extra-data", "a second box of data", movie(order=("ftyp", "moov", "mdat", "mdau"),
        extra=[Box("mdau", b"abc")]), "1.unknown-box"

    def mirrored(moov):
        for box in (moov, moov.child("trak"), moov.child("trak", "mdia", "minf"), stbl(moov)):
            box.parts.reverse()
        return moov
    yield "box-order", "boxes in the opposite order", changed(movie(), mirrored), "1.order"


def tables():
    big = changed(movie(), lambda moov: moov)
    big.tracks[0].large_offsets = True
    yield "co64", "chunk offsets of 64 bits", big, "1.co64"
    many = scene(units=9)
    many.chunks = [1, 1, 2, 3, 2]
    yield "chunks", "chunks of one, two and three samples", movie(many), "1.chunks"
    one = scene(units=7)
    one.chunks = [7]
    yield "chunk-one", "all samples in one chunk", movie(one), "1.chunks"
    equal = scene(units=5)
    size = max(map(len, equal.samples))
    equal.samples = [sample + bytes(size - len(sample)) for sample in equal.samples]

    def constant(moov):
        replaced(stbl(moov), "stsz", Box("stsz", u32(0, size, 5)))
        return moov
    made = changed(movie(equal), constant)
    made.padded = True
    yield "sizes-equal", "one size for all samples", made, "1.stsz"
    for bits in (4, 8, 16):
        small = with_media()
        small.tracks[3].samples = [bytes(range(n)) for n in (3, 15, 1)]
        small.tracks[3].times, small.tracks[3].chunks = [0, 1, 5], [1, 2]
        packed = {4: b"\x3f\x10", 8: bytes([3, 15, 1]), 16: u16(3) + u16(15) + u16(1)}[bits]

        def compact(moov, packed=packed, bits=bits):
            replaced(stbl(moov, 3), "stsz", Box("stz2", u32(0, bits, 3), packed))
            return moov
        yield f"sizes-{bits}-bits", f"sizes of {bits} bits", changed(small, compact), "1.stz2"
    for version, offsets in ((0, [0, 200, 50]), (1, [10, -100, 0])):
        late = scene()
        late.offsets = offsets

        def versioned(moov, version=version):
            stbl(moov).child("ctts").parts[0] = u32(version << 24)
            return moov
        made = changed(movie(late), versioned)
        made.no_commands = True
        yield f"composition-offsets-{version}", f"composition offsets, version {version}", made, "1.ctts"
    for name, sync in (("some", [1, 3]), ("none", [])):
        track = scene()
        track.sync = sync
        yield f"sync-{name}", f"a table of random access points with {name}", movie(track), "1.stss"
    times = scene(units=6)
    times.times = [0, 0, 1, 1000, 1000, 70000]
    times.timescale = 90000
    yield "times", "samples at the same time and far apart, in a timescale of 90000", movie(times), "1.times"
    empty = with_media()
    empty.tracks[2].samples, empty.tracks[2].times, empty.tracks[2].chunks = [], [], []
    yield "track-empty", "a track without samples", empty, "1.tables-agree"


def headers():
    def version_1(moov):
        longer = u32(1 << 24) + u64(1) + u64(2)
        moov.parts[0] = Box("mvhd", longer, u32(600), u64(0), u32(0x10000), u16(0x100) + bytes(10),
            moov.parts[0].parts[-3], bytes(24), u32(2))
        head = moov.child("trak", "tkhd")
        head.parts = [u32(0x01000001), u64(1), u64(2), u32(1), u32(0), u64(0), *head.parts[2:]]
        head.parts[6:7] = [u32(0, 0, 0, 0)]
        media = moov.child("trak", "mdia", "mdhd")
        media.parts = [longer, u32(1000), u64(200), media.parts[-1]]
        return moov
    yield "headers-1", "headers of version 1", changed(movie(), version_1), "1.version-1"
    edits = {"shift": [u32(0, 1, 100, 100), u16(1) + u16(0)],
        "empty": [u32(0, 2, 300, -1), u16(1) + u16(0), u32(0, 0), u16(1) + u16(0)],
             "64": [u32(1 << 24, 1), u64(100), struct.pack(">q", 50), u16(1) + u16(0)]}
    for name, parts in edits.items():
        track = scene()
        track.edits = Box("edts", Box("elst", *parts))
        made = movie(track)
        made.no_commands = True
        yield f"edits-{name}", "an edit list: " + {"shift": "from a later time", "empty": "an empty edit first",
            "64": "of 64 bits"}[name], made, "1.edits"
    for id in (7, 65541, 0x7FFFFFFF):
        yield f"track-id-{id}", f"a scene track with the ID {id}", movie(scene(id)), "1.es-id 1.track-ids"

    def second(moov):
        entry = stbl(moov).child("stsd", "mp4s")
        entry.parts[0] = ("head", bytes(6) + u16(2))
        moov.child("trak", "mdia", "minf", "dinf", "dref").parts = [u32(0, 2), Box("url ", u32(0), b"other.mp4\0"),
            Box("url ", u32(1))]
        return moov
    yield "data-reference", "samples of the second data reference, which is this file", changed(movie(),
        second), "1.data-reference"


def tracks():
    yield "media", "object descriptors and two pictures", with_media(), "1.od 1.media 1.references 4.update 4.reference"
    afx = Track(20, [b"\x14\x00\x00\x00\x01\xc8\xfe\x40"], [0], object_type=5, config=b"\x06", refs={"dpnd": [1]})
    od = Track(2, [od_command(1, object_descriptor(12, es_ref(1)))], handler="odsm", stream_type=1, refs={"mpod": [20]})
    yield "afx-stream", "an AFX stream beside the scene", movie(scene(), od, afx), "1.afx"
    many = with_media()
    many.tracks[2].refs = {"dpnd": [1, 2], "sync": [1], "ipir": [11]}
    yield "references", "references of every kind", many, "1.references"
    turned = with_media()
    turned.tracks = turned.tracks[::-1]
    turned.iods = initial_object(1, 2)
    turned.no_commands = True
    yield "tracks-reversed", "the scene as the last of the tracks", turned, "1.scene"
    mixed = scene(units=4)
    sound = Track(3, [b"aa", b"bbb"], [0, 10], "soun", "mp4a", 0x40, 5, config=b"\x12\x10")
    made = movie(mixed, sound)

    def audio(moov):
        entry = stbl(moov, 1).child("stsd", "mp4a")
        entry.parts.insert(1, bytes(8) + u16(2) + u16(16) + u32(0, 44100 << 16))
        return moov
    yield "sound", "a sound track beside the scene", changed(made, audio), "1.media"


class Fragmented(Movie):
    """The first samples of the scene in the movie, the others in fragments."""

    def __init__(self, track, runs, flags, trex=(0, 0, 0), tfdt=True, base=True):
        super().__init__([track])
        self.runs, self.flags, self.trex, self.tfdt, self.base = runs, flags, trex, tfdt, base

    def write(self):
        track = self.tracks[0]
        all_samples, all_times = track.samples, track.times
        durations = [b - a for a, b in zip(all_times, all_times[1:])] + [100]
        first = len(all_samples) - sum(self.runs)
        track.samples, track.times, track.chunks = all_samples[:first], all_times[:first], [1] * first
        track.duration = durations[first - 1] if first else 0
        self.in_movie = [Box("mvex", Box("trex", u32(0, track.id, 1, *self.trex)))]
        file, places = super().write()
        file, at = bytearray(file), first
        for number, count in enumerate(self.runs):
            self.fragment(file, number, all_samples[at:at + count], all_times[at:at + count], durations[at:at + count])
            at += count
        track.samples, track.times = all_samples, all_times
        return bytes(file), places

    def fragment(self, file, number, samples, times, durations):
        track, size = self.tracks[0], 0
        for _ in range(2):  # once to know its size
            entries = []
            for sample, duration in zip(samples, durations):
                parts = [(0x100, duration), (0x200, len(sample)), (0x400, 0x02000000), (0x800, 0)]
                entries.append(u32(*[value for flag, value in parts if self.flags & flag]))
            head = u32(self.flags | 1, len(samples), size + 8) + (u32(0x02000000) if self.flags & 4 else b"")
            begin = [u32(0x000001, track.id), u64(len(file))] if self.base else [u32(0x020000, track.id)]
            parts = [Box("tfhd", *begin)] + ([Box("tfdt", u32(1 << 24),
                u64(times[0]))] if self.tfdt else []) + [Box("trun", head, *entries)]
            moof = Box("moof", Box("mfhd", u32(0, number + 1)), Box("traf", *parts))
            size = moof.length()
        moof.write(file, {})
        Box("mdat", *samples).write(file, {})


def fragments():
    yield "fragments", "two fragments behind a movie with samples", Fragmented(scene(units=7), [3, 2],
        0x300), "1.fragments"
    even = scene(units=5)
    yield "fragments-defaults", "durations from the defaults, places from the fragment", Fragmented(even, [4], 0x200,
        (100, 0, 0), base=False), "1.fragments"
    yield "fragments-no-time", "fragments that go on where the last ended", Fragmented(scene(units=6), [2, 2], 0x300,
        tfdt=False), "1.fragments"
    yield "fragments-flags", "flags and composition offsets for each sample", Fragmented(scene(units=4), [3],
        0xF00), "1.fragments 1.stss"
    yield "fragments-only", "no sample in the movie", Fragmented(scene(units=3), [2, 1], 0x300), "1.fragments"


def all_cases():
    for part in (layout, tables, headers, tracks, fragments):
        yield from part()
