# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Writes suites/bifs-syntax: scenes of this project's own, written from the texts and the tables alone.
What a decoder must find is what was put in."""
import bifs_cases
import predictive_cases
import proto_cases
import quantizer_cases
from bifs_cases import group
from command_writer import SceneStream, command as c
from mp4_boxes import scene_file
from node_facts import DATA_TYPES, NODES, VERSION_OF, code_path
from node_samples import HOSTS, Values, full, hosted
from scene_rules import ORIGINS, elements_of, origin_of
from scene_values import Node
from suite_writer import Suite

RULES = ["../rules/bifs.json", "../rules/mp4.json"]


def node_cases():
    """Every node with every field, by the data type that it is at home in."""
    homes = {}
    for name in NODES:
        if name != "Script":
            home = next((d for d in NODES[name].data_types if d != "SFWorldNode" and d in HOSTS), "SFWorldNode")
            homes.setdefault(home, []).append(name)
    few = sorted((home, names) for home, names in homes.items() if len(names) < 6)
    batches = [(home, names[i:i + 9]) for home, names in sorted(homes.items()) if len(names) >= 6
               for i in range(0, len(names), 9)]
    batches = [[(home, name) for name in names] for home, names in batches]
    flat = [(home, name) for home, names in few for name in names]
    batches += [flat[i:i + 9] for i in range(0, len(flat), 9)]
    for number, batch in enumerate(batches):
        values = Values()
        nodes = [hosted(full(name, values, ("mask", "list")[i % 2]), home) for i, (home, name) in enumerate(batch)]
        stream = SceneStream().unit(c("scene", group(Node("Shape", id=1), *nodes)))
        covers = [f"bifs.node/{name}" for _, name in batch] + [f"bifs.version/{VERSION_OF[name]}" for _, name in batch]
        yield f"nodes-{number + 1:02}", "every field of " + ", ".join(name for _, name in batch), stream, covers


def code_cases():
    """The code of every node in every data type: fieldless nodes."""
    for data_type in DATA_TYPES:
        names = [name for name in NODES if code_path(data_type, name)]
        if data_type in ("SFWorldNode", "SFTopNode") or data_type not in HOSTS:
            continue
        stream = SceneStream().unit(c("scene", group(*[hosted(Node(name),
            data_type) for name in names if name != "QuantizationParameter"])))
        yield f"codes-{data_type.lower()}", f"the code of every node of {data_type}", stream, [
            f"bifs.data-type/{data_type}"]
    names = list(NODES)
    stream = SceneStream(node_bits=9).unit(c("scene", group(*[Node("Shape", id=i + 1) for i in range(len(names))])))
    stream.unit(*[c("replace_node", i + 1, Node(name)) for i, name in enumerate(names)])
    yield "codes-sfworldnode", "the code of every node in SFWorldNode", stream, ["bifs.data-type/SFWorldNode"]


def says_defaults(value):
    """Whether a node has a field that is its default: encoders leave it out."""
    if isinstance(value, list):
        return any(says_defaults(inner) for inner in value)
    if not isinstance(value, dict):
        return False
    definition = NODES.get(value["node"]) if isinstance(value.get("node"), str) else None
    for name, inner in value["fields"].items() if definition else ():
        field = next((f for f in definition.fields if f.name == name), None)
        if field and field.event != "eventIn" and (inner == field.default or inner in ([], {"commands": []})):
            return True
    return any(says_defaults(inner) for inner in value.values())


def add(suite, name, about, stream, covers, tolerances=(), reencode=True):
    file, _ = scene_file(stream).write()
    commands = stream.commands()
    check = {"check": "decode", "as": "commands", **suite.put_json(name + ".json", commands)}
    if tolerances:
        check["tolerances"] = list(tolerances)
    if isinstance(covers, str):
        covers = ["bifs." + rule for rule in covers.split()]
    expect = [check]
    if reencode and not tolerances and not says_defaults(commands):
        expect.append({"check": "reencode", "equal": "commands"})
    suite.case(name, about, "mp4", file, expect, set(covers) | stream.used | elements_of(commands), origin_of(covers))


def main():
    suite = Suite("bifs-syntax", "Scenes of every node, field type, command and quantization", RULES, ORIGINS)
    for part in (bifs_cases.all_cases, proto_cases.all_cases, quantizer_cases.all_cases, predictive_cases.all_cases,
                 node_cases, code_cases):
        for case in part():
            try:
                add(suite, *case)
            except Exception:
                print(case[0])
                raise
    suite.close()


if __name__ == "__main__":
    main()
