# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The cases of suites/bifs-syntax with PROTOs and Scripts."""
from bifs_cases import group
from command_writer import SceneStream, command as c
from node_facts import Field
from scene_values import Image, Node, Proto, Route, Use
from scripts import Script


def protos():
    settings = {"version": 2, "proto_bits": 3, "node_bits": 4, "route_bits": 2}
    f = Field
    defaults = [("SFBool", True), ("SFFloat", 1.5), ("SFTime", 2.5), ("SFInt32", -7), ("SFString", "s"),
        ("SFVec3f", [1, 2, 3]),
                ("SFVec2f", [1, 2]), ("SFColor", [0.5, 0.25, 1]), ("SFRotation", [0, 1, 0, 2]),
                    ("SFImage", Image(1, 1, 3, b"abc")),
                ("SFNode", Node("Shape"))]
    fields = [f(f"_field{i}", "exposedField", kind, default=value) for i, (kind, value) in enumerate(defaults)]
    yield "proto-single-types", "an interface of all single types", SceneStream(**settings).unit(
        c("scene", group(Node(1, _field0=False, _field3=4, _field9=Image(1, 2, 1, b"xy"), _field10=Node("Group"))),
          [Proto(1, fields, [Node("Group")])])), "12.interface 6.proto-code"
    lists = [f(f"_field{i}", "field", "MF" + kind[2:], default=[value, value]) for i,
        (kind, value) in enumerate(defaults)]
    yield "proto-multiple-types", "an interface of all multiple types", SceneStream(**settings).unit(
        c("scene", group(Node(1, form="list", _field0=[], _field1=[1, 2, 3], _field4=["a"],
            _field9=[Image(1, 1, 1, b"q")],
                              _field10=[None, Node("Shape")])), [Proto(1, lists, [Node("Group")])])), "12.interface"
    events = [f("_field0", "eventIn", "SFVec3f"), f("_field1", "eventOut", "SFBool"),
        f("_field2", "exposedField", "MFNode", default=[]),
              f("_field3", "field", "SFFloat", default=2), f("_field4", "exposedField", "SFVec3f", default=[0, 0, 0])]
    body = Node("Transform", id=1, links={"translation": "_field4"}, children=[
        Node("TouchSensor", links={"isOver": "_field1"}), Node("Transform", links={"scale": "_field0"}),
        Node("Group", links={"children": "_field2"}),
        Node("Shape", geometry=Node("Sphere", form="list", links={"radius": "_field3"})),
        Node("Transform", form="list", rotation=[0, 1, 0, 1], scale=[1, 2, 1])])
    yield "proto-is", "fields and events of nodes in a body connected to the interface, in masks and lists", SceneStream(**settings).unit(
        c("scene", group(Node(3, id=1, _field2=[Node("Shape")], _field4=[1, 2, 3]), Node("TimeSensor", id=2)),
          [Proto(3, events, [body])], [Route(1, "_field1", 2, "loop")])), "12.is 7.mask-proto 7.list-proto"
    yield "proto-is-twice", "one field of the interface in two nodes", SceneStream(**settings).unit(
        c("scene", group(Node(1)), [Proto(1, [f("_field0", "exposedField", "SFVec3f", default=[1, 1, 1])], [
            Node("Transform", links={"scale": "_field0", "translation": "_field0"}),
            Node("Transform", form="list", links={"scale": "_field0"})])])), "12.is"
    yield "proto-routes", "a body of several nodes with ROUTEs", SceneStream(**settings).unit(
        c("scene", group(Node(1)), [Proto(1, [], [Node("TimeSensor", id=1), Node("ScalarInterpolator", id=2)], routes=[
            Route(1, "fraction_changed", 2, "set_fraction"),
                Route(2, "value_changed", 2, "set_fraction", id=1)])])), "12.body"
    yield "proto-own-ids", "the same IDs in scene and bodies", SceneStream(**settings).unit(
        c("scene", group(Node("Shape", id=1), Node(1, id=2), Use(1)), [
            Proto(1, [], [Node("Transform", id=1, children=[Node("Shape", id=2), Use(2)])]),
            Proto(2, [], [Node("Group", id=1), Use(1)])])), "12.scope"
    inner = Proto(2, [f("_field0", "field", "SFFloat", default=1)],
        [Node("Shape", geometry=Node("Sphere", links={"radius": "_field0"}))])
    yield "proto-nested", "a PROTO within a PROTO, and an outer one used in the body", SceneStream(**settings).unit(
        c("scene", group(Node(3, _field0=4)), [Proto(1, [], [Node("Shape")]), Proto(
            3, [f("_field0", "field", "SFFloat", default=2)],
                [group(Node(2, links={"_field0": "_field0"}), Node(1), Node(2))], [inner])])), \
        "12.lookup 12.body 12.scope"
    yield "proto-inner-hides", "an inner PROTO with the ID of an outer one", SceneStream(**settings).unit(
        c("scene", group(Node(1)), [Proto(2, [], [Node("Shape")]),
            Proto(1, [], [group(Node(2, _field0=4))], [inner])])), "12.lookup"
    yield "proto-null-body", "a body of the NULL node", SceneStream(**settings).unit(
        c("scene", group(), [Proto(1, [], [None])])), "12.body"
    yield "proto-extern", "EXTERNPROTOs with strings and object descriptors", SceneStream(**settings).unit(
        c("scene", group(Node(1, _field0=[1, 0, 0]), Node(2, id=1)), [
            Proto(1, [f("_field0", "exposedField", "SFColor", default=[1, 1, 1]), f("_field1", "eventIn", "SFBool")],
                  extern=["lib.mp4#Lamp", {"od": 5}]), Proto(2, [], extern=[])])), "12.extern"
    contexts = Proto(1, [], [Node("Material")]), Proto(2, [], [Node("Sphere")]), Proto(4, [], [Node("PixelTexture")])
    yield "proto-contexts", "instances as material, geometry and texture", SceneStream(**settings).unit(
        c("scene", group(Node("Shape", appearance=Node("Appearance", material=Node(1), texture=Node(4, id=1)),
            geometry=Node(2))),
          contexts)), "12.context 6.proto-code"
    animated = [f("_field0", "exposedField", "SFVec3f", default=[0, 0, 0], anim=1),
        f("_field1", "eventIn", "SFFloat", anim=7),
                f("_field2", "exposedField", "SFBool", default=True), f("_field3", "field", "SFInt32", default=1)]
    yield "proto-animation", "an interface with animation categories", SceneStream(**settings).unit(
        c("scene", group(Node(1)), [Proto(1, animated, [Node("Group")])])), "12.animation"
    coded = [f("_field0", "exposedField", "SFColor", default=[1, 0, 0], category=4, bounds=[0, 1]),
             f("_field1", "exposedField", "MFInt32", default=[3, 1], category=13, width=5, bounds=[0, 31]),
             f("_field2", "field", "SFVec3f", default=[0, 0, 0], category=1, bounds=[-50, 50]),
             f("_field3", "field", "SFInt32", default=5, category=13, width=7, bounds=[-10, 100]),
             f("_field4", "eventIn", "SFFloat"), f("_field5", "field", "SFFloat", default=0.3)]
    quantized = SceneStream(**settings).unit(c("scene", group(
        Node(1, id=1, _field0=[0.2, 0.3, 0.4], _field1=[1, 2, 3]),
        Node("QuantizationParameter", position3DQuant=True, position3DMin=[-20, -20, -20], position3DMax=[20, 20, 20],
            position3DNbBits=11),
        Node(1, _field0=[0.2, 0.5, 0.8], _field1=[2, 0, 31], _field2=[4, 5, -6], _field3=-10, _field5=0.4),
        Node(1, form="list", _field2=[100, -100, 0])), [Proto(1, coded, [Node("Group")])]))
    yield "proto-quantized", "an interface with categories, instances inside and outside a quantizer", quantized, "12.quantization 12.default"
    commands = SceneStream(**settings).unit(c("scene", group(Node(1, id=1)), [Proto(1, fields[:9] + [
        f("_field9", "eventIn", "SFBool"), f("_field10", "exposedField", "MFNode", default=[])], [Node("Group")])]))
    commands.unit(c("replace_field", 1, "_field1", 9), c("replace_field", 1, "_field9", True),
                  c("insert_value", 1, "_field10", "last", Node("Shape")),
                      c("replace_fields", 1, _field4="x", _field3=3))
    yield "proto-commands-to-instances", "commands that change fields of an instance", commands, "12.interface"


def scripts():
    f = Field
    fields = [f("clicked", "eventIn", "SFBool"), f("where", "eventOut", "SFVec3f"),
        f("count", "field", "SFInt32", default=5),
              f("table", "field", "MFFloat", default=[1, 2.5, -3]),
                  f("target", "field", "SFNode", "SFWorldNode", default=Use(1)),
              f("note", "field", "SFString"), f("tick", "eventIn", "SFTime"),
                  f("nodes", "field", "MFNode", "SFWorldNode", default=[Use(1)])]

    def stream(script, node_fields=None, routes=()):
        return SceneStream().unit(c("scene", group(Node("Transform", id=1), Node("TouchSensor", id=2), Node(
            "Script", id=3, url=[script], **(node_fields or {}))), routes=routes))
    yield "script-fields-list", "declared fields as a list, with values and ROUTEs", stream(
        Script(fields), {"directOutput": True, "mustEvaluate": True},
        [Route(2, "isActive", 3, "clicked"), Route(3, "where", 1, "translation"),
            Route(2, "touchTime", 3, "tick")]), "13.fields 13.values 13.routes node/Script"
    yield "script-fields-vector", "declared fields with their count", stream(Script(fields, vector=True)), "13.fields"
    yield "script-empty", "a script of nothing", stream(Script()), "13.fields"
    n, i = lambda v: ("number", v), lambda v: ("id", v)
    statements = [
        ("do", ("var", "k", "m")), ("if", ("<", i("k"), n(3)), [("do", ("=", i("k"), n(1)))],
            ("do", ("=", i("k"), n(2)))),
        ("if", i("k"), ("break",)), ("for", ("=", i("k"), n(0)), ("<", i("k"), n(9)), ("x++", i("k")),
            [("continue",), ("break",)]),
        ("for", None, None, None, [("break",)]), ("while", (">", i("k"), n(0)), ("do", ("x--", i("k")))),
        ("switch", i("k"), [(0, [("break",)]), (5, [("do", n(1)), ("break",)])], [("return",)]),
        ("return", ("+", i("k"), n(1)))]
    yield "script-statements", "every statement", stream(Script([],
        [("run", ["a", "b"], statements), ("other", [], [("return",)])])), \
        "13.statements 13.functions"
    binary = "+ - * / % == != < <= > >= && || & | ^ << >> >>>".split()
    assign = "= += -= *= /= %= &= |= ^= <<= >>= >>>=".split()
    expressions = [(o, i("a"), i("b")) for o in binary + assign] + [(o, i("a")) for o in ("-x", "!x", "~x", "++x",
        "--x", "x++", "x--")]
    expressions += [("()", [i("a"), i("b")]), ("?", i("a"), i("b"), n(1)), ("string", "text"),
        ("call", "f", i("a"), n(2)), ("call", "f"),
                    ("new", "SFVec3f", n(1), n(2), n(3)), (".", i("a"), "x"), ("method", i("a"), "go", n(1)),
                        ("index", i("a"), n(0)),
                    ("bool", True), ("bool", False)]
    yield "script-expressions", "every expression", stream(Script([],
        [("run", ["a", "b"], [("do", e) for e in expressions])])), "13.expressions"
    inner = [("do", ("=", i("a"), ("function", ["q"], [("return", i("q"))]))), ("switch", i("a"), [(7, ("break",))])]
    yield "script-inner-function", "a function as an expression, a case of one statement", stream(Script([],
        [("run", ["a"], inner)])), \
        "13.expressions", (), False
    numbers = [n(0), n(1), n(255), n(2147483647), n("1.5"), n("0.25"), n("1E10"), n("2.5E-3")]
    yield "script-numbers", "integers and numbers of characters", stream(Script([],
        [("run", [], [("do", e) for e in numbers])])), "13.numbers"
    many = [("do", ("=", i(f"v{k}"), i(f"v{k // 2}"))) for k in range(20)]
    yield "script-identifiers", "identifiers known already: fields, functions, arguments", stream(
        Script(fields[:3], [("clicked", ["value", "time"], [("do", ("=", i("count"), i("value"))), *many]),
                            ("tick", ["value"], [("do", ("call", "clicked", i("value")))])])), "13.identifiers"
    replaced = stream(Script(fields[:3])).unit(c("replace_field", 3, "url",
        [Script([], [("clicked", ["v"], [("return",)])])]))
    yield "script-url-replaced", "a field replacement of the text", replaced, "13.fields"
    inside = Proto(1, [f("_field0", "exposedField", "SFBool", default=True), f("_field1", "eventIn", "SFTime"),
        f("_field2", "eventOut", "SFBool")], [
        Node("Script", url=[Script([f("in", "eventIn", "SFTime"), f("flag", "field", "SFBool"),
            f("own", "field", "SFInt32", default=4)],
                                   links={"in": "_field1", "flag": "_field0"})])])
    yield "script-in-proto", "declared fields connected to an interface", SceneStream(version=2, proto_bits=1).unit(
        c("scene", group(Node(1)), [inside])), "13.proto"


def all_cases():
    yield from protos()
    yield from scripts()
