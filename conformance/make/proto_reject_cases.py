# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The cases of suites/bifs-rejects with PROTOs and Scripts."""
from bifs_cases import group
from bifs_reject_cases import scene
from command_writer import SceneStream, command as c
from faults import Fault, changed, wrong
from node_facts import Field, NODES
from scene_values import Node, Proto, Route, Use
from scripts import Script


def protos():
    settings = {"version": 2, "proto_bits": 3}
    f = Field

    def one(*fields, code=None, **more):
        return scene(protos=[Proto(1, fields, code or [Node("Group")], **more)], **settings)
    for kind in (31, 63):
        yield f"proto-type-{kind}", f"an interface field of the type {kind}", changed(
            one(f("_field0", "eventIn", "SFBool")), "fieldType", 6, kind, code="unsupported", covers="12.interface")
    yield "proto-itself", "a PROTO that holds itself", wrong(_recursive(settings), "protoID", covers="12.unknown-proto")
    linked = lambda kind: one(f("_field0", "exposedField", kind, default=1 if kind == "SFFloat" else [1, 1, 1]), f(
        "_field1", "eventIn", "SFBool"), f("_field2", "eventIn", "SFBool"),
            code=[Node("Transform", links={"scale": "_field0"})])
    yield "is-unknown", "a connection to an interface field that is not there", changed(linked("SFVec3f"),
        "interfaceField", 2, 3, covers="12.is")
    yield "is-type", "a connection between fields of different types", wrong(linked("SFFloat"), "interfaceField",
        covers="12.is")
    yield "event-value", "a value for an event", _event_value(settings)
    light = one(f("_field0", "exposedField", "SFColor", default=[1, 1, 1]),
        code=[Node("PointLight", form="list", links={"color": "_field0"})])
    width = NODES["PointLight"].width("all")
    yield "list-field-unknown", "an ALL index behind the last field", changed(
        light, "fieldRef", width, (1 << width) - 1, covers="7.list-proto 7.field-unknown")
    yield "proto-outer-node", "a body that uses a node of the scene", wrong(_outer_node(settings), "nodeID",
        covers="12.scope")
    yield "proto-route", "a ROUTE of a body between nodes of which one is not there", changed(one(
        code=[Node("TimeSensor", id=1), Node("ScalarInterpolator", id=2)],
            routes=[Route(1, "fraction_changed", 2, "set_fraction")]),
        "inNodeID", 4, 7, covers="12.body 11.route")
    yield "proto-deleted", "an instance of a PROTO that was deleted", wrong(_deleted(settings), "protoID",
        covers="12.unknown-proto")
    yield "proto-inner", "an instance of a PROTO that is within another", wrong(_inner(settings), "protoID",
        covers="12.scope 12.lookup")


def _recursive(settings):
    stream = SceneStream(**settings)

    def write(writer):
        writer.kind(3)
        for width, value, name in ((6, 0, "reserved"), (1, 0, "USENAMES"), (1, 1, "morePROTOs"), (3, 2, "protoID"),
            (1, 0, "moreFields"), (1, 0, "isExtern"),
                                   (1, 0, "morePROTOs"), (1, 0, "isReused"), (7, 0, "v1"), (4, 1, "v2"),
                                       (3, 2, "protoID"), (20, 0, "rest")):
            writer.out.u(width, value, name)
    return stream.unit(write)


def _event_value(settings):
    transform = Node("Transform", links={"addChildren": "_field0"})
    stream = scene(protos=[Proto(1, [Field("_field0", "eventIn", "MFNode")], [transform])], **settings)
    bit = stream.out.at("isIS")
    stream.out.bits[bit] = 0
    return Fault(stream, None, covers="7.mask-proto")


def _outer_node(settings):
    stream = SceneStream(node_bits=4, **settings).unit(c("scene", group(Node("Shape", id=1), id=2)))
    return stream.unit(c("insert_protos", [Proto(1, [], [Use(1)])]))


def _deleted(settings):
    stream = SceneStream(**settings).unit(c("scene", group(id=1), [Proto(1, [], [Node("Group")])]))
    return stream.unit(c("delete_protos", [1]), c("insert_node", 1, "last", Node(1)))


def _inner(settings):
    inner = Proto(2, [], [Node("Shape")])
    stream = SceneStream(**settings).unit(c("scene", group(id=1),
        [Proto(1, [], [Node("Group")], [inner]), Proto(3, [], [Node("Group")])]))
    stream.unit(c("insert_node", 1, "last", Node(3)))
    bit = stream.out.at("protoID")
    stream.out.bits[bit:bit + 3] = [0, 1, 0]
    return stream


def scripts():
    def one(*statements, fields=()):
        return scene(Node("Script", url=[Script(list(fields) or [Field("a", "eventIn", "SFBool"),
            Field("b", "field", "SFBool"), Field(
            "d", "field", "SFBool")], [("a", ["v"], list(statements))])]))
    plain = lambda: one(("do", ("=", ("id", "b"), ("number", "1.5"))), ("do", ("id", "v")))
    yield "script-event", "a script that declares an exposedField", changed(plain(), "event", 2, 3, covers="13.fields")
    yield "script-type", "a script that declares a field of an unknown type", changed(plain(), "fieldType", 6, 63,
        code="unsupported", covers="13.fields")
    yield "script-identifier", "an identifier behind the last that is known", _identifier()
    yield "script-expression", "an expression of an unknown type", changed(plain(), "expression", 6, 63,
        covers="13.expressions")
    yield "script-number", "a number with an unknown character", changed(plain(), "digit", 4, 14, 0,
        covers="13.numbers")
    stream = scene(Node("Script", url=[Script([], [("f", [], [("do", ("id", "f"))])])]))
    bit = stream.out.at("expression")
    stream.out.bits[bit:] = [0, 0, 0, 0, 0, 1] * 40000
    yield "script-deep", "forty thousand minus signs", Fault(stream, None, "limit_exceeded", "17.depth")
    name = scene(Node("Script", url=[Script([Field("abc", "eventIn", "SFBool")])]))
    bit = name.out.at("name")
    name.out.bits[bit:] = ([0, 1, 1, 0, 0, 0, 0, 1] * 40)
    yield "name-endless", "a name that never ends", Fault(name, None, "truncated", "1.name")


def _identifier():
    """Five names are known: indices of 3 bits, 7 is none of them."""
    stream = scene(Node("Script", url=[Script([Field(n, "field", "SFBool") for n in "abc"],
        [("f", ["v"], [("do", ("id", "v"))])])]))
    return changed(stream, "identifier", 3, 7, covers="13.identifiers")


def all_cases():
    yield from protos()
    yield from scripts()
