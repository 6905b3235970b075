# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Writes a suite: suite.json of the form in suites/suite.schema.json, and its files."""
import hashlib
import json
import os
import shutil

SUITES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "suites")
AFX = {"afx": {"text": "Made for this project by the scripts of conformance/make, from the texts alone.",
               "licence": "BSD-2-Clause"}}


def sha256(data):
    return hashlib.sha256(data).hexdigest()


def compact(value, level=0):
    """JSON with one line for each access unit, command, track or case."""
    return json.dumps(value, ensure_ascii=False, separators=(", ", ": "))


class Suite:
    def __init__(self, name, title, rules, origins=AFX, fresh=True):
        self.name, self.title, self.rules, self.origins = name, title, rules, origins
        self.folder = os.path.join(SUITES, name)
        self.cases = []
        if fresh:
            shutil.rmtree(self.folder, ignore_errors=True)
        os.makedirs(self.folder, exist_ok=True)

    def put(self, name, data):
        data = data.encode() if isinstance(data, str) else data
        with open(os.path.join(self.folder, name), "wb") as file:
            file.write(data)
        return {"file": name, "sha256": sha256(data)}

    def put_json(self, name, value):
        return self.put(name, compact(value) + "\n")

    def case(self, name, about, kind, stream, expect, covers=(), origin="afx", beside=()):
        """`stream`: bytes, or the name of a file that is there already."""
        if isinstance(stream, str) and os.path.exists(os.path.join(self.folder, stream)):
            with open(os.path.join(self.folder, stream), "rb") as file:
                made = {"file": stream, "sha256": sha256(file.read())}
        else:
            made = self.put(f"{name}.{kind}", stream)
        case = {"name": name, "about": about, "kind": kind, "stream": made["file"], "sha256": made["sha256"],
                "origin": origin}
        if beside:
            case["beside"] = list(beside)
        if covers:
            case["covers"] = sorted(set(covers))
        self.cases.append({**case, "expect": expect})

    def close(self):
        head = {"$schema": "../suite.schema.json", "suite": self.name, "title": self.title, "rules": self.rules,
                "origins": self.origins}
        text = json.dumps(head, ensure_ascii=False)[:-1] + ', "cases": [\n'
        text += ",\n".join(json.dumps(case, ensure_ascii=False) for case in self.cases) + "\n]}\n"
        with open(os.path.join(self.folder, "suite.json"), "w", encoding="utf-8") as file:
            file.write(text)
        print(f"{self.name}: {len(self.cases)} cases")
