# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Writes suites/mp4-syntax: MP4 files and object descriptors."""
from itertools import chain

import descriptor_cases
import mp4_cases
from suite_writer import Suite, sha256


def tracks_of(movie):
    tracks = [track.facts() for track in movie.tracks]
    for track in tracks:
        track["samples"] = [sha256(sample) for sample in track["samples"]]
    return {"iodsDescriptor": movie.iods.hex() if movie.iods else None, "tracks": tracks}


def commands_of(movie):
    track = movie.tracks[0]
    commands = track.stream.commands()
    for unit, time, sample in zip(commands["accessUnits"], track.times, track.samples):
        unit.update(time=time, bytes=len(sample))
    return commands


def main():
    suite = Suite("mp4-syntax", "MP4 files and object descriptors", ["../rules/mp4.json", "../rules/bifs.json"])
    for name, about, movie, covers in chain(mp4_cases.all_cases(), descriptor_cases.all_cases()):
        file, _ = movie.write()
        expect = [{"check": "decode", "as": "tracks", **suite.put_json(name + ".tracks.json", tracks_of(movie))}]
        if hasattr(movie.tracks[0], "stream") and not hasattr(movie, "no_commands"):
            expect.append({"check": "decode", "as": "commands", **suite.put_json(name + ".json", commands_of(movie))})
        suite.case(name, about, "mp4", file, expect, ["mp4." + rule for rule in covers.split()])
    suite.close()


if __name__ == "__main__":
    main()
