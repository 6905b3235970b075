# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Writes suites/bifs-rejects: what a decoder must refuse, and where."""
import bifs_reject_cases
import config_reject_cases
from mp4_boxes import bit_in_file, scene_file
from suite_writer import Suite


def expected(code, place, reason):
    check = {"check": "reject", "code": code, **place, "reason": reason}
    return [check]


def add_fault(suite, name, about, fault):
    movie = scene_file(fault.stream)
    file, _ = movie.write()
    place = {} if fault.bit is None else {"bit": bit_in_file(movie, fault.unit, fault.bit)}
    covers = ["bifs." + rule for rule in fault.covers.split()]
    suite.case(name, about, "mp4", file, expected(fault.code, place, about), covers)


def main():
    suite = Suite("bifs-rejects", "Scenes that are to be refused", ["../rules/bifs.json"])
    for name, about, fault in bifs_reject_cases.all_cases():
        add_fault(suite, name, about, fault)
    for name, about, file, code, bit, covers in config_reject_cases.all_cases():
        place = {} if bit is None else {"bit": bit}
        suite.case(name, about, "mp4", file, expected(code, place, about), ["bifs." + rule for rule in covers.split()])
    suite.close()


if __name__ == "__main__":
    main()
