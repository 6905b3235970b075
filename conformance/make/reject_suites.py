# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Writes suites/bifs-rejects and suites/mp4-rejects: what a decoder must refuse, and where."""
from itertools import chain

import bifs_reject_cases
import config_reject_cases
import mp4_reject_cases
import predictive_reject_cases
import proto_reject_cases
from mp4_boxes import bit_in_file, scene_file
from scene_rules import ORIGINS, origin_of
from suite_writer import Suite


def expected(code, place, reason):
    check = {"check": "reject", "code": code, **place, "reason": reason}
    return [check]


def add_fault(suite, name, about, fault):
    movie = scene_file(fault.stream)
    file, _ = movie.write()
    place = {} if fault.bit is None else {"bit": bit_in_file(movie, fault.unit, fault.bit)}
    covers = ["bifs." + rule for rule in fault.covers.split()]
    suite.case(name, about, "mp4", file, expected(fault.code, place, about), covers, origin_of(covers))


def add_files(suite, area, cases):
    for name, about, file, code, bit, covers in cases:
        place = {} if bit is None else {"bit": bit}
        suite.case(name, about, "mp4", file, expected(code, place, about),
            [f"{area}.{rule}" for rule in covers.split()])


def main():
    suite = Suite("bifs-rejects", "Scenes that are to be refused", ["../rules/bifs.json"], ORIGINS)
    for name, about, fault in chain(bifs_reject_cases.all_cases(), proto_reject_cases.all_cases(),
                                    predictive_reject_cases.all_cases()):
        add_fault(suite, name, about, fault)
    add_files(suite, "bifs", config_reject_cases.all_cases())
    suite.close()
    suite = Suite("mp4-rejects", "MP4 files that are to be refused", ["../rules/mp4.json"])
    add_files(suite, "mp4", mp4_reject_cases.all_cases())
    suite.close()


if __name__ == "__main__":
    main()
