# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The cases of suites/mp4-rejects: files with one fault each. (name, about, file, code, bit or None, covers)"""
import mp4_cases as good
from mp4_boxes import Box, Movie, Track, descriptor, es_descriptor, initial_object, u16, u32, u64, u8

STBL = "moov/trak/mdia/minf/stbl"


def made(movie=None, change=None):
    movie = movie or good.movie()
    if change:
        movie.change = change
    return movie.write()


def patched(place, data, delta=0, movie=None, change=None):
    """A good file with bytes overwritten; and the bit of the place."""
    file, places = made(movie, change)
    at = places[place] + delta
    return file[:at] + data + file[at + len(data):], 8 * places[place]


def files():
    file, places = made()
    yield "empty", "a file of no bytes", b"", "malformed", 0, "1.box"
    yield "not-a-box", "three bytes", file[:3], "truncated", 0, "1.box"
    yield "cut-moov", "a file that ends inside the movie", file[:places[STBL]], "truncated", 8 * places[
        "moov"], "1.box-lies"
    late, at = made(good.movie(order=("ftyp", "mdat", "moov")))
    yield "cut-last-byte", "a file without its last byte, inside the movie", late[:-1], "truncated", 8 * at[
        "moov"], "1.box-lies"
    yield "cut-data", "a file that ends inside its data", file[:-200], "truncated", None, "1.samples-inside"
    yield "no-movie", "a file of data alone", made(good.movie(order=("ftyp", "mdat")))[0], "malformed", None, "1.moov"
    first = good.movie()
    second, _ = first.write()
    moov = second[places["moov"]:places["mdat"]]
    yield "two-movies", "two movies in a file", second + moov, "malformed", 8 * len(second), "1.moov"
    for name, size, about in (("7", 7, "of seven bytes"), ("2", 2, "of two bytes")):
        broken, bit = patched("moov/mvhd", u32(size))
        yield f"box-size-{name}", f"a box {about}", broken, "malformed", bit, "1.box"
    large = good.movie()
    large.large_mdat = True
    broken, bit = patched("mdat", u64(15), 8, large)
    yield "box-large-size-15", "a box with a size of 64 bits of fifteen bytes", broken, "malformed", bit, "1.large-size"
    broken, bit = patched("mdat", u64((1 << 64) - 1), 8, large)
    yield "box-large-size-huge", "a box of all bytes that 64 bits can say", broken, "truncated", bit, "1.large-size 1.box-lies"
    for box in ("moov/trak", "moov/trak/mdia", STBL, STBL + "/stsz", STBL + "/stsd", STBL + "/stsd/mp4s",
        STBL + "/stsd/mp4s/esds"):
        broken, bit = patched(box, u32(0x00FFFFFF))
        yield "lies-" + box.rsplit("/",
            1)[-1], f"the box {box.rsplit('/', 1)[-1]} ends behind the one it is in", broken, "truncated", bit, "1.box-lies"
    yield "compressed-movie", "a movie in compressed form", made(
        change=lambda moov: Box("moov", Box("cmov", bytes(8))))[0], "unsupported", None, "1.moov"
    yield "entry-short", "a sample entry of four bytes", made(change=_short_entry)[0], "truncated", None, "1.data-reference"
    yield "moov-cut-by-size", "a movie that ends in the middle of a track", *_shrunk(), "1.box-lies"


def _short_entry(moov):
    moov.child("trak", "mdia", "minf", "stbl", "stsd").parts[1:] = [Box("mp4s", bytes(4))]
    return moov


def _shrunk():
    file, places = made()
    size = places[STBL] - places["moov"]
    file = file[:places["moov"]] + u32(size) + file[places["moov"] + 4:]
    return file, "truncated", 8 * places["moov/trak"]


def without(*path):
    def change(moov):
        moov.child(*path[:-1]).remove(path[-1]) if len(path) > 1 else moov.remove(path[0])
        return moov
    return change


def missing():
    base = ("trak", "mdia", "minf", "stbl")
    for path in (("mvhd",), ("trak", "tkhd"), ("trak", "mdia"), ("trak", "mdia", "mdhd"), ("trak", "mdia", "hdlr"),
        ("trak", "mdia", "minf"),
                 ("trak", "mdia", "minf", "stbl"), (*base, "stsd"), (*base, "stsz"), (*base, "stsc"), (*base, "stco"),
                     (*base, "stts")):
        file, places = made(change=without(*path))
        parent = "/".join(("moov", *path[:-1]))
        yield "no-" + path[-1], f"no box {path[-1]} in {path[-2] if len(path) > 1 else 'moov'}", file, "malformed", 8 * places[parent] + 64, "1.tables-agree"  # where the parent's content begins
    yield "no-tracks", "a movie without tracks", made(change=without("trak"))[0], "malformed", None, "1.scene"
    od = good.with_media()
    od.tracks = od.tracks[1:]
    od.iods = initial_object(2, None)
    yield "no-scene", "a movie without a scene", made(od)[0], "malformed", None, "1.scene"
    plain = Track(1, [b"x"], [0], config=b"", es=b"")
    yield "no-descriptor", "a scene without an ES_Descriptor", made(Movie([plain]))[0], "truncated", None, "2.es"


def tables():
    def count(box, value, width=4):
        file, places = made()
        at = places[f"{STBL}/{box}.count"]
        return file[:at] + u32(value) + file[at + 4:], 8 * at
    for box in ("stts", "stsc", "stsz", "stco"):
        file, bit = count(box, 0x10000000)
        yield f"count-huge-{box}", f"a count in {box} that the box does not hold", file, "truncated", bit, "1.tables-agree"
    file, bit = count("stsd", 2)
    yield "count-stsd", "a count of two sample entries where there is one", file, "truncated", None, "1.tables-agree"
    file, bit = count("stts", 0)
    yield "times-none", "no times for the samples", file, "malformed", None, "1.tables-agree"
    file, bit = count("stco", 2)
    yield "chunks-fewer", "fewer chunks than the samples need", file, "malformed", None, "1.chunks"
    file, bit = patched(f"{STBL}/stsc.run0", u32(0))
    yield "first-chunk-0", "a first run that begins at chunk 0", file, "malformed", bit, "1.chunks"
    file, bit = patched(f"{STBL}/stsc.run0", u32(2))
    yield "first-chunk-2", "a first run that begins at chunk 2", file, "malformed", bit, "1.chunks"
    file, bit = patched(f"{STBL}/stsc.run0", u32(5), 8)
    yield "sample-entry-5", "samples of the fifth of one sample entries", file, "malformed", bit + 64, "1.chunks"
    many = good.scene(units=5)
    many.chunks = [1, 2, 2]
    file, bit = patched(f"{STBL}/stsc.run1", u32(1), 0, Movie([many]))
    yield "chunks-back", "runs of chunks that go back", file, "malformed", bit, "1.chunks"
    for name, offset in (("behind", 0x7FFFFFFF), ("last", None)):
        file, places = made()
        at = places[f"{STBL}/stco.offsets"]
        value = len(file) - 4 if offset is None else offset
        yield f"offset-{name}", "a chunk that lies " + ("behind the file" if offset else "half behind the file"), \
            file[:at] + u32(value) + file[at + 4:], "truncated", None, "1.samples-inside"
    far = good.movie()
    far.tracks[0].large_offsets = True
    file, bit = patched(f"{STBL}/co64.offsets", u64((1 << 64) - 2), 0, far)
    yield "offset-huge", "a chunk at the end of 64 bits", file, "truncated", None, "1.samples-inside 1.co64"
    file, bit = patched(f"{STBL}/stsz.sizes", u32(0xFFFFFFFF))
    yield "sample-huge", "a sample of four thousand million bytes", file, "truncated", None, "1.samples-inside"
    file, bit = patched("moov/trak/tkhd.id", u32(0))
    yield "track-id-0", "a track with the ID 0", file, "malformed", bit, "1.track-ids"
    twice = good.with_media()
    twice.tracks[3].id = 10
    yield "track-id-twice", "two tracks with one ID", made(twice)[0], "malformed", None, "1.track-ids"
    for path, name in (("moov/trak/mdia/mdhd.timescale", "media"), ("moov/mvhd.timescale", "movie")):
        file, bit = patched(path, u32(0))
        yield f"timescale-0-{name}", f"a timescale of 0 of the {name}", file, "malformed", bit, "1.timescale"
    sync = good.scene()
    sync.sync = [1, 9]
    file, places = made(Movie([sync]))
    yield "sync-behind", "a random access point behind the last sample", file, "malformed", 8 * places[
        f"{STBL}/stss.samples"] + 32, "1.stss"
    sync.sync = [0]
    file, places = made(Movie([sync]))
    yield "sync-0", "a random access point before the first sample", file, "malformed", 8 * places[
        f"{STBL}/stss.samples"], "1.stss"

    def odd(moov):
        good.replaced(good.stbl(moov), "stsz", Box("stz2", ("bits", u32(0, 12, 3)), bytes(6)))
        return moov
    file, places = made(change=odd)
    yield "sizes-12-bits", "sizes of twelve bits", file, "malformed", 8 * places[f"{STBL}/stz2.bits"] + 56, "1.stz2"
    file, bit = patched(f"{STBL}/stsd/mp4s.head", u16(0), 6)
    yield "data-reference-0", "the data reference 0", file, "malformed", bit + 48, "1.data-reference"
    file, bit = patched(f"{STBL}/stsd/mp4s.head", u16(9), 6)
    yield "data-reference-9", "the ninth of one data references", file, "malformed", bit + 48, "1.data-reference"

    def elsewhere(moov):
        moov.child("trak", "mdia", "minf", "dinf", "dref").parts[1:] = [Box("url ", u32(0), b"other.mp4\0")]
        return moov
    yield "data-elsewhere", "samples that lie in another file", made(change=elsewhere)[
        0], "unsupported", None, "1.data-reference"


def fragments():
    for name, field, about in (("track", 12, "a track that is not there"),
        ("samples", None, "more samples than the fragment holds")):
        movie = good.Fragmented(good.scene(units=5), [3], 0x300)
        file, _ = movie.write()
        tfhd, trun = file.index(b"tfhd") - 4, file.index(b"trun") - 4
        if field:
            at, value = tfhd + 12, 99
        else:
            at, value = trun + 12, 0x10000000
        code = "malformed" if field else "truncated"
        yield f"fragment-{name}", f"a fragment of {about}", file[:at] + u32(value) + file[
            at + 4:], code, 8 * at, "1.fragments"
    movie = good.Fragmented(good.scene(units=5), [3], 0x300)
    file, _ = movie.write()
    yield "fragment-cut", "a file that ends inside a fragment", file[:file.index(b"trun") + 8], "truncated", 8 * (
        file.index(b"moof") - 4), "1.fragments 1.box-lies"
    trex, tfdt, trun = file.index(b"trex") - 4, file.rindex(b"tfdt") - 4, file.index(b"trun") - 4

    def with_bytes(at, data):
        return file[:at] + data + file[at + len(data):]
    yield "fragment-entry", "fragments with the ninth of one sample entries", with_bytes(
        trex + 16, u32(9)), "malformed", None, "1.fragments 1.tables-agree"
    yield "fragment-time-back", "a fragment that begins before the sample in front of it", with_bytes(
        tfdt + 12, u64(0)), "malformed", 8 * (tfdt + 12), "1.fragments 1.times"
    yield "fragment-offset", "a fragment whose samples begin before the file", with_bytes(
        trun + 16, u32(1 << 31)), "malformed", 8 * (trun + 16), "1.fragments 1.samples-inside"
    unsized, _ = good.Fragmented(good.scene(units=5), [3], 0, (100, 1000, 0)).write()
    trun = unsized.index(b"trun") - 4
    yield "fragment-defaults", "more samples of the default size than the file has bytes for", unsized[:trun + 12] + u32(
        1 << 20) + unsized[trun + 16:], "truncated", 8 * (trun + 12), "1.fragments 1.samples-inside"


def descriptors():
    def with_es(es, code, delta, covers, about, name):
        track = good.scene()
        track.es = es(track)
        file, places = made(Movie([track]))
        # The seven bits of the length: behind the tag and the bit that says whether more follow.
        place = 8 * (places[f"{STBL}/stsd/mp4s/esds.descriptor"] + delta) + 9 if delta is not None else None
        return name, about, file, code, place, covers
    yield with_es(lambda t: b"\x03\xff\xff\xff\xff\xff\x01" + es_descriptor(1, 3, t.config)[2:], "malformed", None,
        "2.length-endless",
                  "a length of six bytes", "length-endless")
    yield with_es(lambda t: descriptor(3, es_descriptor(1, 3, t.config)[2:], size=100), "truncated", 0, "2.ends-inside",
                  "an ES_Descriptor that ends behind its box", "es-long")
    yield with_es(lambda t: descriptor(3, u16(0) + u8(0), descriptor(4, bytes(13), size=99)), "truncated", 5,
        "2.ends-inside",
                  "a configuration that ends behind its ES_Descriptor", "config-long")
    yield with_es(lambda t: descriptor(3, u16(0) + u8(0),
        descriptor(4, u8(1) + u8(0x0D) + bytes(11), descriptor(5, b"\0", size=50))), "truncated", 20,
                  "2.ends-inside", "specific info that ends behind its configuration", "info-long")
    yield with_es(lambda t: descriptor(3, u16(0)), "truncated", None, "2.es", "an ES_Descriptor of two bytes",
        "es-short")
    yield with_es(lambda t: descriptor(3, u16(0) + u8(0x40) + u8(200) + b"a"), "truncated", None, "2.es-options",
        "a URL longer than its descriptor", "es-url")
    yield with_es(lambda t: descriptor(3, u16(0) + u8(0), descriptor(4, b"\1\r\0")), "truncated", None, "2.config",
        "a configuration of three bytes", "config-short")
    yield with_es(lambda t: descriptor(3, u16(0) + u8(0), descriptor(6, b"\2")), "malformed", None, "2.es",
        "an ES_Descriptor without a configuration", "no-config")
    nested = b""
    for _ in range(120):
        nested = descriptor(4, u8(1) + u8(0x0D) + bytes(11), nested, length_bytes=3)
    yield with_es(lambda t: descriptor(3, u16(0) + u8(0), nested, length_bytes=3), "limit_exceeded", None,
        "2.ends-inside",
                  "a hundred and twenty configurations within each other", "descriptors-deep")
    file, places = made(Movie([good.scene()], iods=initial_object(1)[:-3]))
    yield "iods-cut", "an initial object descriptor that ends behind its box", file, "truncated", 8 * places[
        "moov/iods.descriptor"] + 9, "2.ends-inside 3.iods"


def all_cases():
    for part in (files, missing, tables, fragments, descriptors):
        yield from part()
