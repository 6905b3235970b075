# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Writes suite.json and the tracks.json of suites/bifs-gpac, whose streams and decodes are there (its README)."""
import json
import os

from scene_rules import elements_of
from suite_writer import Suite, sha256

ORIGIN = {"gpac": {"text": "Written for this project, encoded with GPAC's MP4Box 26.08-DEV (commit d34570e3d).",
                   "licence": "BSD-2-Clause"}}
# Texts that do not say what the stream has (README): left out.
OTHER_TEXT = {
    "11": "GPAC gives ROUTEs the IDs that a later DEF leaves", "19": "the angles of the stream are wrong",
    "21": "the bounds of the stream are bits of floats", "22": "the PROTO IDs of the stream are cut",
    "24": "a position of the stream is cut", "27": "a backslash is doubled in the stream",
    "28": "an image of nothing has four components in the stream", "30": "the stream has names",
    "33": "the stream cannot be decoded"}
OTHER_XMT = {
    "18": "six digits are too few for efficient floats", "28": "six digits are too few for the largest floats",
    "19": "negative components are wrong", "21": "all PROTOs have one name", "22": "all PROTOs have one name",
    "23": "all PROTOs have one name", "27": "it is no well-formed XML", "29": "it has a command more",
    "30": "the stream has names", "33": "all PROTOs have one name"}
SIX_DIGITS = {"path": "/accessUnits", "abs": 4e-6, "reason": "GPAC writes six digits in XMT-A"}
XMT_TOLERANCES = {
    "02": SIX_DIGITS, "03": SIX_DIGITS, "05": SIX_DIGITS, "09": SIX_DIGITS}
DENORMAL = {"path": "/accessUnits", "abs": 1e-45, "reason": "decoded.json has more digits of denormals than they have"}


class Folder:
    def __init__(self, suite, vector):
        self.suite, self.vector, self.name = suite, vector, vector["name"]
        self.number = self.name[:2]
        self.path = os.path.join(suite.folder, self.name)

    def file(self, name):
        with open(os.path.join(self.path, name), "rb") as file:
            return file.read()

    def has(self, name):
        return os.path.exists(os.path.join(self.path, name))

    def expected(self, name):
        return {"file": f"{self.name}/{name}", "sha256": sha256(self.file(name))}

    def tracks(self):
        tracks = []
        for facts in self.vector["tracks"]:
            files = facts.get("files") or media_files(self, facts)
            config = [name for name in files if name.endswith("cfg.bin")]
            track = {key: facts[key] for key in ("id", "handler", "sampleEntry", "objectTypeIndication", "streamType",
                                                 "timescale", "times")}
            track["refs"] = facts.get("refs", {})
            track["config"] = self.file(config[0]).hex() if config else facts.get("config", "")
            track["samples"] = [sha256(self.file(name)) for name in files if name not in config]
            tracks.append(track)
        return {"iodsDescriptor": self.vector["iodsDescriptor"], "tracks": tracks}


def media_files(folder, facts):
    """Pictures are samples as they are, in the order of the tracks."""
    names = {10: "color32.jpg", 11: "depth32.png", 12: "color16.jpg", 20: "still.jpg", 31: "still.png"}
    return [names[facts["id"]]]


JPEG_CONFIG = "00140001000103"  # the peer's, of seven bytes


def scene_case(suite, folder):
    for track in folder.vector["tracks"]:
        if track["objectTypeIndication"] == 0x6C:
            track["config"] = JPEG_CONFIG
    with open(os.path.join(folder.path, "tracks.json"), "w", encoding="utf-8") as file:
        file.write(json.dumps(folder.tracks()) + "\n")
    tracks = {"check": "decode", "as": "tracks", **folder.expected("tracks.json")}
    about = folder.vector["about"]
    if folder.number == "33":
        place = 8 * file_offset(folder, "au0.bifs") + 263
        expect = [tracks, {"check": "reject", "code": "truncated", "bit": place,
                           "reason": "GPAC numbers PROTOs from 1 in every scope: another body is read for this one"}]
        suite.case(folder.name, about, "mp4", f"{folder.name}/scene.mp4", expect, ["bifs.12.lookup"], "gpac")
        return
    commands = {"check": "decode", "as": "commands", **folder.expected("decoded.json")}
    if folder.number == "28":
        commands["tolerances"] = [DENORMAL]
    expect = [commands, tracks, {"check": "reencode", "equal": "commands"}]
    covers = elements_of(json.loads(folder.file("decoded.json")))
    suite.case(folder.name, about, "mp4", f"{folder.name}/scene.mp4", expect, covers, "gpac")


def file_offset(folder, name):
    data = folder.file("scene.mp4")
    return data.index(folder.file(name))


def text_cases(suite, folder):
    about, commands = folder.vector["about"], {"check": "decode", "as": "commands", **folder.expected("decoded.json")}
    media = [folder.expected(name) for name in sorted(os.listdir(folder.path))
             if name.endswith((".jpg", ".png", ".s3d")) or name == "payload.bin"]
    if folder.number not in OTHER_TEXT:
        suite.case(folder.name + "-bt", "as BT: " + about, "bt", f"{folder.name}/scene.bt", [commands],
                   ["scene-text.6.commands"] if len(folder.vector["tracks"][0]["times"]) > 1 else [], "gpac", media)
    if folder.has("gpac.xmt") and folder.number not in OTHER_XMT:
        if folder.number in XMT_TOLERANCES:
            commands = {**commands, "tolerances": [XMT_TOLERANCES[folder.number]]}
        suite.case(folder.name + "-xmt", "as XMT-A: " + about, "xmt", f"{folder.name}/gpac.xmt", [commands],
                   ["scene-text.7.xml"], "gpac")


def main():
    rules = [f"../rules/{area}.json" for area in ("bifs", "mp4", "scene-text")]
    suite = Suite("bifs-gpac", "Scenes of another encoder: GPAC's MP4Box", rules, ORIGIN, False)
    with open(os.path.join(suite.folder, "manifest.json"), encoding="utf-8") as file:
        vectors = json.load(file)["vectors"]
    for vector in vectors:
        folder = Folder(suite, vector)
        scene_case(suite, folder)
        text_cases(suite, folder)
    suite.close()


if __name__ == "__main__":
    main()
