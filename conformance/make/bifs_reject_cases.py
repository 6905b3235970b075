# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The cases of suites/bifs-rejects: scenes with one fault each. With PROTOs and Scripts: proto_reject_cases.py."""
from bifs_cases import group, simple
from bits import BitWriter
from command_writer import SceneStream, command as c
from faults import Fault, changed, cut, raw, wrong
from node_facts import DATA_TYPES, Field, NODES
from quantizer_cases import quantizer
from scene_values import Buffer, Image, Node, Proto, Route, Use, Vector
from scripts import Script

SCENE = [(2, 3, "command"), (6, 0, "reserved"), (1, 0, "USENAMES"), (1, 0, "morePROTOs")]


def scene(*children, protos=(), routes=(), **settings):
    return SceneStream(**{"node_bits": 4, **settings}).unit(c("scene", group(*children), protos, routes))


def truncations():
    def shape(**fields):
        return Node("Shape", id=3, geometry=Node("IndexedFaceSet",
            coord=Node("Coordinate", point=Vector([[1, 2, 3]] * 9)),
                                                 coordIndex=[1, 2], **fields))
    yield "cut-empty", "an access unit of no bytes", Fault(raw(), 0, "truncated", "3.truncated")
    for element in ("USENAMES", "v1", "nodeID", "countBits", "count", "float", "int", "endFlag", "mask", "hasROUTEs"):
        yield f"cut-{element.lower()}", f"the data end inside the element {element}", cut(scene(shape()), element)
    strings = lambda: scene(Node("WorldInfo", title="a title of some length", info=["x"]),
        Node("Anchor", url=[{"od": 3}]))
    for element, nth in (("string", 0), ("length", 0), ("objectDescriptorID", 0)):
        yield f"cut-{element.lower()}", f"the data end inside the element {element}", cut(strings(), element, nth)
    image = lambda: scene(Node("Shape", appearance=Node("Appearance",
        texture=Node("PixelTexture", image=Image(2, 2, 3, range(12))))))
    for element in ("width", "height", "components"):
        yield f"cut-image-{element}", f"the data end inside the {element} of an image", cut(image(), element)
    yield "cut-time", "the data end inside a time", cut(scene(Node("TimeSensor", startTime=1.5)), "time")
    yield "cut-quantized", "the data end inside a quantized number", cut(scene(quantizer("position3D"), Node(
        "Transform", translation=[1, 2, 3])), "quantized", -1)
    yield "cut-direction", "the data end inside a quantized normal", cut(scene(quantizer("normal"), Node(
        "Shape", geometry=Node("IndexedFaceSet", normal=Node("Normal", vector=[[0, 1, 0]])))), "component")
    yield "cut-efficient", "the data end inside an efficient float", cut(scene(quantizer(useEfficientCoding=True), Node(
        "Transform", translation=[0.1, 0.2, 0.3])), "mantissa")
    for name, build in {
            "extended": ("extendedCommand", c("delete_node_ex", 9)),
                "position": ("position", c("delete_value", 7, "key", "first")),
            "index": ("index", c("insert_value", 7, "key", 300, 1)),
                "more-commands": ("moreCommands", c("replace_field", 2, "center", [1, 1, 1])),
            "xreplace": ("valueFromNode", c("xreplace", 2, "translation", source=(9, "color")))}.items():
        yield f"cut-{name}", f"a command ends before its {build[0]} is whole", cut(simple().unit(build[1]), build[0])
    proto = lambda: scene(Node(1), version=2, proto_bits=3, protos=[Proto(1, [
        Field("_field0", "exposedField", "SFVec3f", default=[1, 2, 3], category=1, bounds=[-1, 1])], [Node("Group")])])
    for element in ("protoID", "eventType", "fieldType", "isExtern", "moreNodes", "category", "hasBounds"):
        yield f"cut-proto-{element.lower()}", f"a PROTO ends before its {element} is whole", cut(proto(), element, 0)
    script = lambda: scene(Node("Script", url=[Script([Field("a", "eventIn", "SFBool")], [
        ("a", ["v"], [("do", ("=", ("id", "b"), ("number", "1.25"))), ("do", ("number", 70000))])])]))
    for element in ("event", "hasFunction", "statement", "expression", "digit", "integerValue"):
        yield f"cut-script-{element.lower()}", f"a script ends before its {element} is whole", cut(script(), element, 0)


def commands():
    yield "reserved-deletion", "a deletion of the reserved sub-type", wrong(
        raw((2, 1, "command"), (2, 1, "subCommand"), (8, 0, "rest")), "subCommand", covers="3.deletion-reserved")
    for kind in (8, 255):
        yield f"reserved-extended-{kind}", f"an extended command of type {kind}", wrong(
            raw((2, 0, "command"), (2, 1, "subCommand"), (8, kind, "extendedCommand"), (8, 0, "rest")),
                "extendedCommand", 0, "unsupported", "5.reserved")
    yield "reserved-position", "a position of the reserved kind", changed(simple().unit(c("delete_value", 7, "key",
        1)), "position", 2, 1,
                                                                       covers="3.position-reserved")
    unknown = {"insertion": c("insert_node", 2, "last", Node("Shape")), "deletion": c("delete_node", 2),
        "deletion-ex": c("delete_node_ex", 2),
               "replacement": c("replace_node", 2, None), "field": c("replace_field", 2, "translation", [1, 1, 1]),
               "value": c("insert_value", 7, "key", 0, 1), "many-values": c("replace_values", 7, "key", [(0, 1)]),
               "many-fields": c("replace_fields", 2, scale=[1, 1, 1]), "xreplace": c("xreplace", 2, "scale", [1, 1, 1])}
    for name, build in unknown.items():
        yield f"unknown-node-{name}", "a command for a node that is not there", changed(
            simple().unit(build), "nodeID", 4, 12, 0, covers="3.unknown-target")
    yield "unknown-node-from", "XReplace that copies from a node that is not there", changed(
        simple().unit(c("xreplace", 2, "translation", source=(2, "scale"))), "nodeID", 4, 12,
            covers="3.unknown-target 5.xreplace-from")
    yield "unknown-node-index", "XReplace with an index from a node that is not there", changed(
        simple().unit(c("xreplace", 7, "key", 1, index_from=(6, "whichChoice"))), "nodeID", 4, 12,
            covers="3.unknown-target 5.xreplace-dynamic")
    yield "dropped-node", "a command for a node of the scene before", wrong(_dropped(), "nodeID",
        covers="4.drops 3.unknown-target")
    yield "no-children", "a node inserted into a node without children", changed(
        simple().unit(c("insert_node", 1, "last", Node("Shape"))), "nodeID", 4, 2, 0, covers="3.insert-target")
    plain = scene(Node("DepthImage", id=1))
    plain.out = BitWriter()
    for part in ((2, 2, "command"), (2, 1, "subCommand"), (4, 0, "nodeID"), (8, 0, "rest")):
        plain.out.u(*part)
    plain.units.append((100, plain.out))
    yield "no-in-field", "a field of a node that has no IN fields", Fault(plain, plain.out.at("nodeID"),
        covers="3.no-in-field")
    many = _unused_index()
    yield "in-field-unknown", f"an IN index that a {many[0]} has no field for", changed(
        scene(Node(many[0], id=1)).unit(c("replace_field", 1, many[1], many[2])), "fieldRef", many[3],
            (1 << many[3]) - 1, covers="7.field-unknown")
    yield "not-indexable", "an element replaced in a field that has one value", changed(
        simple().unit(c("replace_value", 7, "key", "first", 1)), "fieldRef", NODES["ScalarInterpolator"].width("in"),
            0, covers="3.not-indexable")
    route = lambda: SceneStream(route_bits=3).unit(c("scene",
        group(Node("TouchSensor", id=1), Node("TimeSensor", id=2))))
    for end in ("out", "in"):
        yield f"route-unknown-{end}", f"a ROUTE whose {end} node is not there", changed(
            route().unit(c("insert_route", Route(1, "isActive", 2, "loop"))), f"{end}NodeID", 4, 9, covers="11.route")
    yield "global-other-node", "a global quantizer that is another node", Fault(_global_group(), None,
        covers="5.global-quantizer")
    deep = Node("Shape")
    for _ in range(3000):
        deep = Node("Group", children=[deep])
    yield "deep-nodes", "three thousand nodes below each other", Fault(_deep(3000), None, "limit_exceeded", "17.depth")


def _dropped():
    return simple().unit(c("scene", group(id=1))).unit(_delete_without_asking(5))


def _delete_without_asking(id):
    def write(writer):
        writer.kind(1, 0)
        writer.out.u(writer.node_bits, id - 1, "nodeID")
    return write


def _global_group():
    def write(writer):
        writer.kind(0, 1, 5)
        writer.node(Node("Group"), "SFWorldNode")
    return simple().unit(write)


def _unused_index():
    """A node, one of its IN fields, a value, the width: the largest index of which is no field."""
    name = "PointLight"
    return name, "color", [1, 1, 1], NODES[name].width("in")


def _deep(levels):
    stream = raw(*SCENE, (1, 0, "isReused"), (3, 1, "v1"))
    for _ in range(levels):
        for part in ((1, 0, "isUpdateable"), (1, 1, "isMask"), (1, 1, "mask"), (1, 0, "reserved"), (1, 1, "isList"),
            (1, 0, "endFlag"),
                     (1, 0, "isReused"), (6, DATA_TYPES["SF3DNode"]["1"]["codes"]["Group"], "code")):
            stream.out.u(*part)
    return stream


def nodes():
    yield "top-node-unknown", "a code that no top node has", wrong(raw(*SCENE, (1, 0, "isReused"), (3, 7, "v1"),
        (8, 0, "rest")), "v1",
                                                                covers="6.code-unknown")
    yield "code-unknown", "a code that no geometry of version 1 has", changed(
        scene(Node("Shape", geometry=Node("Box"))), "v1", 5, 31, covers="6.code-unknown")
    yield "code-unknown-5", "a code that no 3D node of version 5 has", changed(
        scene(Node("DepthImage")), "v5", 5, 31, covers="6.code-unknown 6.escape")
    escape = raw(*SCENE, (1, 0, "isReused"), (3, 1, "v1"), (1, 0, "isUpdateable"), (1, 1, "isMask"), (1, 1, "mask"),
        (1, 0, "reserved"), (1, 1, "isList"),
                 (1, 0, "endFlag"), (1, 0, "isReused"),
                     *[(DATA_TYPES["SF3DNode"][str(v)]["bits"], 0, f"v{v}") for v in range(1, 10)], (8, 0, "rest"))
    yield "code-end", "escapes beyond the last table", wrong(escape, "v9", code="unsupported", covers="6.code-end")
    yield "use-unknown", "the use of a node that is not there", wrong(scene(Use(3)), "nodeID", covers="6.use-behind")
    yield "use-before", "the use of a node that comes later", wrong(scene(Use(1), Node("Shape", id=1)), "nodeID", 0,
        covers="6.use-behind")
    yield "use-inside", "the use of a node inside itself", wrong(scene(Node("Group", id=1, children=[Use(1)])),
        "nodeID", covers="6.use-behind")
    yield "use-data-type", "a material used as a child", wrong(scene(Node("Shape", appearance=Node(
        "Appearance", material=Node("Material", id=1))), Use(1)), "nodeID", covers="6.use-data-type")
    yield "null-id", "a node with the ID that means no node", changed(scene(Node("Shape", id=1)), "nodeID", 4, 15,
        covers="1.null-id")
    width = NODES["TimeSensor"].width("def")
    yield "field-unknown", "a DEF index behind the last field", changed(
        scene(Node("TimeSensor", form="list", loop=True)), "fieldRef", width, (1 << width) - 1,
            covers="7.field-unknown 7.list-node")
    yield "proto-unknown", "an instance of a PROTO that is not there", changed(scene(
        Node(1), version=2, proto_bits=3, protos=[Proto(1, [], [Node("Group")])]), "protoID", 3, 5,
            covers="12.unknown-proto")
    yield "proto-in-version-1", "an instance in a configuration without PROTOs", Fault(*_instance_in_version_1(),
        covers="12.unknown-proto 2.config-1")


def _instance_in_version_1():
    stream = scene(Node("Shape"))
    bit = stream.out.at("v1", -1)
    stream.out.bits[bit:] = [0] * 6 + [0, 0, 1] + [0] * 40
    return stream, bit + 9


def values():
    long = scene(Node("WorldInfo", title="x"))
    bit = long.out.at("string")
    long.out.bits[bit:] = [1] * 5 + [1] * 31 + [0] * 64
    yield "string-huge", "a string of two thousand million bytes", Fault(long, None, "truncated", "8.huge-count")
    texture = scene(Node("Shape", appearance=Node("Appearance",
        texture=Node("PixelTexture", image=Image(1, 1, 1, b"a")))))
    yield "image-huge", "an image of 4095 x 4095 pixels without them", _huge(texture, "width", [1] * 26, "truncated")
    numbers = scene(Node("Shape", geometry=Node("IndexedFaceSet", coordIndex=Vector([1]))))
    yield "count-huge", "a count of a million numbers", _huge(numbers, "countBits", [1, 0, 1, 0, 0] + [1] * 20,
        "truncated", keep=100)
    children = scene(Node("Group", children=Vector([Node("Shape")])))
    yield "count-huge-nodes", "a count of a million nodes", _huge(children, "countBits", [1, 0, 1, 0, 0] + [1] * 20,
        "truncated", keep=0)
    nothing = scene(quantizer("position3D", position3DNbBits=0), Node("Shape", geometry=Node("PointSet", coord=Node(
        "Coordinate", point=Vector([[1, 2, 3]])))))
    yield "count-huge-no-bits", "a count of two thousand million numbers of no bits", _huge(
        nothing, "countBits", [1] * 5 + [1] * 31, "limit_exceeded", keep=40)
    orientation = scene(quantizer("normal"), Node("Shape",
        geometry=Node("IndexedFaceSet", normal=Node("Normal", vector=[[0, 1, 0]]))))
    yield "orientation", "a normal with the orientation 3", changed(orientation, "orientation", 2, 3,
        covers="9.orientation")
    yield "int-linear", "an integer field with a linear category that is switched on", _int_linear()
    yield "no-points", "an index without coordinates before it", _no_points()
    inside = scene(Node("Transform", id=1), Node("Conditional",
        buffer=Buffer(c("replace_field", 1, "scale", [2, 2, 2]))))
    yield "buffer-command", "a command buffer with a command for a node that is not there", changed(inside, "nodeID",
        4, 9, covers="8.command-buffer")
    short = scene(Node("Transform", id=1), Node("Conditional",
        buffer=Buffer(c("replace_field", 1, "scale", [2, 2, 2]))))
    yield "buffer-short", "a command buffer that ends inside its command", _short_buffer(short)
    far = scene(Node("Conditional", buffer=Buffer(c("scene", None))))
    yield "buffer-huge", "a command buffer longer than the data", _huge(far, "bufferSize", [1] * 5 + [1] * 31,
        "truncated")


def _huge(stream, element, bits, code, keep=64):
    bit = stream.out.at(element)
    stream.out.bits[bit:] = bits + [0] * keep
    return Fault(stream, None, code, "8.huge-count")


def _short_buffer(stream):
    bit = stream.out.at("bufferLength")
    count = stream.out.at("bufferBytes") - bit
    stream.out.bits[bit:bit + count] = [(5 >> i) & 1 for i in reversed(range(count))]
    return Fault(stream, None, "truncated", "8.command-buffer")


def _int_linear():
    """Written as if the category were off."""
    stream = SceneStream()
    field = NODES["ElevationGrid"].field("xDimension")
    category, field.category = field.category, 0
    stream.unit(c("scene", group(quantizer("size"), Node("Shape", geometry=Node("ElevationGrid", xDimension=3)))))
    field.category = category
    return Fault(stream, None, covers="9.int-linear")


def _no_points():
    field = NODES["IndexedFaceSet"].field("coordIndex")
    category, field.category = field.category, 0
    stream = scene(quantizer(), Node("Shape", geometry=Node("IndexedFaceSet", coordIndex=[5])))
    field.category = category
    return Fault(stream, None, covers="9.no-points")


def all_cases():
    for part in (truncations, commands, nodes, values):
        yield from part()
