# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""A small writer of MP4 files and object descriptors that knows where everything is."""
import struct


def u8(value):
    return struct.pack(">B", value)


def u16(value):
    return struct.pack(">H", value & 0xFFFF)


def u32(*values):
    return b"".join(struct.pack(">I", value & 0xFFFFFFFF) for value in values)


def u64(value):
    return struct.pack(">Q", value)


MATRIX = u32(0x10000, 0, 0, 0, 0x10000, 0, 0, 0, 0x40000000)


class Box:
    """Parts are bytes, boxes, or (name, bytes). `size`: what the header says, where that is not the truth;
    `large`: 64-bit size; `open_end`: size 0."""

    def __init__(self, kind, *parts, size=None, large=False, open_end=False):
        self.kind, self.parts = kind, list(parts)
        self.size, self.large, self.open_end = size, large, open_end

    def child(self, *path):
        """The first box below with each of these types in turn; (type, n) is the nth."""
        box = self
        for step in path:
            kind, nth = step if isinstance(step, tuple) else (step, 0)
            box = [part for part in box.parts if isinstance(part, Box) and part.kind == kind][nth]
        return box

    def remove(self, kind):
        self.parts = [part for part in self.parts if not (isinstance(part, Box) and part.kind == kind)]
        return self

    def length(self):
        return (16 if self.large else 8) + sum(len_of(part) for part in self.parts)

    def write(self, out, places, path=""):
        path = f"{path}/{self.kind}" if path else self.kind
        places.setdefault(path, len(out))
        size = self.length() if self.size is None else self.size
        if self.large:
            out += u32(1) + self.kind.encode("latin-1") + u64(size)
        else:
            out += u32(0 if self.open_end else size) + self.kind.encode("latin-1")
        for part in self.parts:
            if isinstance(part, Box):
                part.write(out, places, path)
            else:
                name, data = part if isinstance(part, tuple) else (None, part)
                if name:
                    places.setdefault(f"{path}.{name}", len(out))
                out += data


def len_of(part):
    return part.length() if isinstance(part, Box) else len(part[1] if isinstance(part, tuple) else part)


def descriptor(tag, *parts, size=None, length_bytes=1):
    """Tag, length in so many bytes, payload."""
    payload = b"".join(parts)
    size = len(payload) if size is None else size
    length = bytearray()
    for i in reversed(range(length_bytes)):
        length.append((size >> 7 * i & 0x7F) | (0x80 if i else 0))
    return u8(tag) + bytes(length) + payload


def decoder_config(object_type, stream_type, info, **how):
    inner = b"" if info is None else descriptor(5, info, **how)
    head = u8(object_type) + u8(stream_type << 2 | 1) + b"\0\0\0" + u32(0, 0)
    return descriptor(4, head, inner, **how)


def es_descriptor(object_type, stream_type, info, es_id=0, flags=0, more=b"", after=b"", sl=None, **how):
    return descriptor(3, u16(es_id) + u8(flags), more, decoder_config(object_type, stream_type, info, **how),
                      descriptor(6, b"\2", **how) if sl is None else sl, after, **how)


class Track:
    """A track and its tables. `samples` are bytes; each other list has one value for each sample."""

    def __init__(self, id, samples, times=None, handler="sdsm", entry="mp4s", object_type=1, stream_type=3,
                 config=b"", timescale=1000, refs=None, offsets=None, sync=None, duration=None, es=None):
        self.id, self.samples, self.handler, self.entry = id, samples, handler, entry
        self.times = list(times) if times is not None else [100 * i for i in range(len(samples))]
        self.object_type, self.stream_type, self.config, self.timescale = object_type, stream_type, config, timescale
        self.refs, self.offsets, self.sync = refs or {}, offsets, sync
        self.es = es_descriptor(object_type, stream_type, config) if es is None else es
        self.duration = duration
        self.chunks = [1] * len(samples)  # samples in each chunk
        self.places = []  # of the chunks in the file
        self.large_offsets = False
        self.edits = None  # a box
        self.language, self.more = 0x55C4, []

    def durations(self):
        ends = self.times[1:] + [self.times[-1] + (self.duration or 0)] if self.times else []
        return [end - begin for begin, end in zip(self.times, ends)]

    def total(self):
        return sum(self.durations())

    def tables(self):
        runs = []
        for duration in self.durations():
            if runs and runs[-1][1] == duration:
                runs[-1][0] += 1
            else:
                runs.append([1, duration])
        boxes = [Box("stts", u32(0), ("count", u32(len(runs))), *(u32(*run) for run in runs))]
        if self.offsets:
            boxes.append(Box("ctts", u32(0), ("count", u32(len(self.offsets))), *(u32(1, o) for o in self.offsets)))
        boxes.append(self.chunk_map())
        boxes.append(Box("stsz", u32(0), ("size", u32(0)), ("count", u32(len(self.samples))),
                         ("sizes", u32(*map(len, self.samples)))))
        offsets = b"".join(map(u64, self.places)) if self.large_offsets else u32(*self.places)
        boxes.append(Box("co64" if self.large_offsets else "stco", u32(0), ("count", u32(len(self.places))),
                         ("offsets", offsets)))
        if self.sync is not None:
            boxes.append(Box("stss", u32(0), ("count", u32(len(self.sync))), ("samples", u32(*self.sync))))
        return boxes

    def chunk_map(self):
        runs = [(i + 1, count) for i, count in enumerate(self.chunks) if i == 0 or self.chunks[i - 1] != count]
        return Box("stsc", u32(0), ("count", u32(len(runs))),
                   *((f"run{i}", u32(first, count, 1)) for i, (first, count) in enumerate(runs)))

    def box(self):
        media = {"vide": Box("vmhd", u32(1), u64(0)), "soun": Box("smhd", u32(0, 0))}.get(
            self.handler, Box("nmhd", u32(0)))
        head = bytes(6) + ("dataReference", u16(1))[1]
        visual = bytes(16) + u16(0) * 2 + u32(0x480000, 0x480000, 0) + u16(1) + bytes(32) + u16(24) + u16(0xFFFF)
        extra = visual if self.entry == "mp4v" else b""
        entry = Box(self.entry, ("head", head), extra, Box("esds", u32(0), ("descriptor", self.es)))
        tables = Box("stbl", Box("stsd", u32(0), ("count", u32(1)), entry), *self.tables())
        data = Box("dinf", Box("dref", u32(0, 1), Box("url ", u32(1))))
        minf = Box("minf", media, data, tables)
        mdia = Box("mdia", Box("mdhd", u32(0, 0, 0), ("timescale", u32(self.timescale)), u32(self.total()),
                               u16(self.language) + u16(0)),
                   Box("hdlr", u32(0, 0), ("type", self.handler.encode()), u32(0, 0, 0), b"\0"), minf)
        head = Box("tkhd", u32(1, 0, 0), ("id", u32(self.id)), u32(0, self.total(), 0, 0, 0, 0), MATRIX, u32(0, 0))
        refs = [Box("tref", *(Box(kind, u32(*ids)) for kind, ids in self.refs.items()))] if self.refs else []
        return Box("trak", head, *([self.edits] if self.edits else []), *refs, mdia, *self.more)

    def facts(self):
        """In the form `tracks`."""
        return {"id": self.id, "handler": self.handler, "sampleEntry": self.entry,
                "objectTypeIndication": self.object_type, "streamType": self.stream_type,
                "timescale": self.timescale, "times": self.times, "refs": self.refs,
                "config": (self.config or b"").hex(), "samples": self.samples}


def initial_object(scene=1, od=None, head=b"\x00\x4f", profiles=b"\xff\xfe\xff\xfe\xfe", tag=0x10, **how):
    ids = [descriptor(0x0E, u32(id), **how) for id in (scene, od) if id is not None]
    return descriptor(tag, head + profiles, *ids, **how)


class Movie:
    """A file: brands, movie, data. `order` is of its boxes."""

    def __init__(self, tracks, iods=None, order=("ftyp", "moov", "mdat"), extra=(), timescale=600):
        self.tracks, self.order, self.extra, self.timescale = tracks, order, list(extra), timescale
        od = next((track.id for track in tracks if track.handler == "odsm"), None)
        self.iods = initial_object(tracks[0].id if tracks else 1, od) if iods is None else iods
        self.large_mdat = False
        self.in_movie = []  # further boxes of moov
        self.gap = 0  # bytes before the data
        self.open_data = False  # a size of 0
        self.change = lambda moov: moov

    def moov(self):
        longest = max((t.total() * self.timescale // t.timescale for t in self.tracks), default=0)
        mvhd = Box("mvhd", u32(0, 0, 0), ("timescale", u32(self.timescale)), u32(longest, 0x10000),
                   u16(0x100) + bytes(10), MATRIX, bytes(24), u32(max([t.id for t in self.tracks] + [0]) + 1))
        iods = [Box("iods", u32(0), ("descriptor", self.iods))] if self.iods else []
        return self.change(Box("moov", mvhd, *iods, *(t.box() for t in self.tracks), *self.in_movie))

    def data(self):
        return [sample for track in self.tracks for sample in track.samples]

    def place_chunks(self, begin):
        for track in self.tracks:
            track.places, at = [], 0
            for count in track.chunks:
                track.places.append(begin)
                begin += sum(map(len, track.samples[at:at + count]))
                at += count

    def boxes(self):
        made = {"ftyp": Box("ftyp", b"mp42", u32(1), b"isom", b"mp42"), "moov": self.moov(),
                "mdat": Box("mdat", bytes(self.gap), *self.data(), large=self.large_mdat, open_end=self.open_data)}
        made.update((box.kind, box) for box in self.extra)
        return [made[kind] for kind in self.order]

    def write(self):
        """The file, and where its boxes and fields are (bytes)."""
        self.place_chunks(0)
        begin = 0
        for box in self.boxes():
            if box.kind == "mdat":
                begin += (16 if box.large else 8) + self.gap
                break
            begin += box.length()
        self.place_chunks(begin)
        out, places = bytearray(), {}
        for box in self.boxes():
            box.write(out, places)
        self.begin = begin
        return bytes(out), places


def scene_track(stream, id=1):
    """The track of a command_writer.SceneStream."""
    return Track(id, [unit.bytes() for _, unit in stream.units], [time for time, _ in stream.units],
                 object_type=stream.object_type, config=stream.config_bits().bytes())


def scene_file(stream):
    return Movie([scene_track(stream)])


def bit_in_file(movie, unit, bit):
    """The bit of the file, for one of an access unit of the first track; after write()."""
    track = movie.tracks[0]
    return 8 * (movie.begin + sum(map(len, track.samples[:unit]))) + bit
