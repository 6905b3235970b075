# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Writes suites/scene-text-syntax and suites/scene-text-rejects."""
import text_cases
import text_reject_cases
from suite_writer import Suite

RULES = ["../rules/scene-text.json"]
MARK = "¦"


def marked(text):
    """The text without its mark, and the line and column where that was (counted from 1); nothing if there is none."""
    before, mark, after = text.partition(MARK)
    if not mark:
        return text, {}
    return before + after, {"line": before.count("\n") + 1, "column": len(before) - before.rfind("\n")}


def main():
    suite = Suite("scene-text-syntax", "Scenes as VRML, BT and XMT-A", RULES)
    for name, about, kind, text, stream, covers in text_cases.all_cases():
        check = {"check": "decode", "as": "commands", **suite.put_json(name + ".json", stream.commands())}
        suite.case(name, about, kind, text, [check], ["scene-text." + rule for rule in covers.split()])
    suite.close()
    suite = Suite("scene-text-rejects", "Texts that are to be refused", RULES)
    for name, about, kind, text, code, covers in text_reject_cases.all_cases():
        text, place = marked(text)
        suite.case(name, about, kind, text, [{"check": "reject", "code": code, **place, "reason": about}],
                   ["scene-text." + rule for rule in covers.split()])
    suite.close()


if __name__ == "__main__":
    main()
