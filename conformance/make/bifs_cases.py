# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The cases of suites/bifs-syntax but for its nodes and quantizers: configurations, commands, values and node descriptions. protos, scripts: proto_cases.py."""
from command_writer import SceneStream, command as c
from node_facts import Field, NODES
from scene_values import Buffer, Image, Listed, Node, Proto, Route, Text, Use, Vector


def group(*children, id=None, **more):
    return Node("Group", id=id, children=list(children), **more)


def simple(**settings):
    """A stream whose first unit is a small scene with IDs."""
    stream = SceneStream(**{"node_bits": 4, **settings})
    return stream.unit(c("scene", group(
        Node("Transform", id=2, translation=[1, 2, 3]),
        Node("Shape", id=3, geometry=Node("IndexedFaceSet", id=4, coord=Node(
            "Coordinate", id=5, point=[[0, 0, 0], [1, 0, 0], [0, 1, 0]]), coordIndex=[0, 1, 2, -1])),
        Node("Switch", id=6, choice=[Node("Group"), Node("Shape")], whichChoice=1),
        Node("ScalarInterpolator", id=7, key=[0, 0.5, 1], keyValue=[1, 2, 3]),
        group(Node("Shape"), id=8), Node("PointLight", id=9, color=[0.25, 0.5, 0.75]), id=1)))


def configurations():
    top = lambda: group(Node("Transform", id=1, translation=[1, 2, 3]))
    yield "config-1", "the shortest configuration of version 1", SceneStream(node_bits=1).unit(
        c("scene", top())), "2.config-1 2.no-size 1.bit-order 3.padding 7.defaults"
    yield "config-1-size", "a configuration with a size", SceneStream(node_bits=1, size=(320, 240)).unit(
        c("scene", top())), "2.size 2.pixel-metric"
    yield "config-1-metres", "coordinates in metres, a size of the largest numbers", SceneStream(
        node_bits=2, pixels=False, size=(65535, 1)).unit(c("scene", top())), "2.size 2.pixel-metric"
    yield "config-1-no-ids", "a scene without IDs in a configuration without room for them", SceneStream(
        node_bits=0).unit(c("scene", group(Node("Shape", geometry=Node("Box"))))), "2.id-widths"
    yield "config-2", "a configuration of version 2 with 3 bits for PROTO IDs", SceneStream(
        version=2, node_bits=3, route_bits=2, proto_bits=3).unit(c("scene", top())), "2.config-2"
    yield "config-2-size", "version 2 with a size, in metres", SceneStream(
        version=2, node_bits=3, pixels=False, size=(1, 2)).unit(c("scene", top())), "2.config-2 2.size"
    yield "config-2-predictive-flag", "version 2 where each multiple field says that it is not predictive", SceneStream(
        version=2, predictive=True, proto_bits=1).unit(
            c("scene", group(Node("Shape", geometry=Node(
                "IndexedFaceSet", coord=Node("Coordinate", point=Vector([[1, 2, 3]])), coordIndex=[0, -1])),
                Node("Anchor", url=["a"])), [Proto(1, [Field("_field0", "field", "MFFloat", default=[1, 2])],
                    [Node("Group")]),
                                             Proto(0, [], extern=["b.mp4"])])), "2.predictive-flag"
    wide = SceneStream(version=2, node_bits=31, route_bits=31, proto_bits=31)
    far = (1 << 31) - 2
    wide.unit(c("scene", group(Node("Transform", id=far), Node(far, id=far - 1, _field0=2.5), Use(far), None),
                [Proto(far, [Field("_field0", "exposedField", "SFFloat", default=1)], [Node("Group")])],
                [Route(far, "translation", far, "scale", id=far)]),
              c("delete_node", far - 1), c("delete_route", far))
    yield "config-wide-ids", "IDs of 31 bits", wide, "2.id-widths 1.ids"
    yield "config-later-nodes", "a version 1 stream with nodes of versions 2 to 9", SceneStream().unit(c("scene", group(
        Node("AcousticScene"), Node("TemporalTransform"), Node("InputSensor"), Node("DepthImage"),
        Node("TransformMatrix2D"), Node("DepthImageV2"),
        Node("Shape", geometry=Node("FootPrintSetNode"))))), "2.later-nodes"


def frames():
    yield "frame-many", "eight commands in one access unit", simple().unit(
        *[c("replace_field", 2, "translation", [i, i, i]) for i in range(8)]), "3.frame"
    yield "frame-two-scenes", "two scene replacements in one access unit, IDs used again for other nodes", SceneStream(
        ).unit(
        c("scene", group(Node("Shape", id=1), id=2)), c("scene", group(Node("Transform", id=1)), names=False),
        c("replace_field", 1, "translation", [1, 1, 1])), "3.frame 4.drops"
    yield "frame-trailing", "bytes behind the frame", simple().unit(
        c("delete_node", 3), tail=b"\xff\x00\xaa"), "3.trailing"
    yield "frame-times", "units at the same time and far apart", simple().unit(
        c("delete_node", 3), time=0).unit(c("delete_node", 4), time=1000000), "3.frame"


def scenes():
    yield "scene-null", "a scene without a top node", SceneStream().unit(c("scene", None)), "4.top-node 6.null"
    for top in ("Group", "OrderedGroup", "Layer2D", "Layer3D"):
        yield f"scene-top-{top.lower()}", f"{top} as the top node", SceneStream().unit(
            c("scene", Node(top, id=1))), "4.top-node 4.scene"
    names = SceneStream(version=2, route_bits=2, proto_bits=2).unit(c(
        "scene", group(Node("Transform", id=1, label="a"), Node("Shape", id=2, label="ünï"),
            Node(1, id=3, label="p", amount=3)),
        [Proto(1, [Field("amount", "exposedField", "SFFloat", default=2), Field("go", "eventIn", "SFBool")],
               [Node("Group", id=1, label="inner")], label="Thing")],
        [Route(1, "translation", 1, "scale", id=1, label="r")], names=True))
    names.unit(c("insert_value", 1, "children", "last", Node("Group", id=4, label="late")),
        c("insert_route", Route(1, "scale", 1, "translation", id=2, label="s")))
    yield "scene-names", "USENAMES: nodes, ROUTEs, PROTOs and fields with names, later ones too", names, "4.usenames 1.name"
    yield "scene-names-end", "a scene replacement without USENAMES after one with it", SceneStream().unit(
        c("scene", group(id=1, label="x"), names=True)).unit(c("scene", group(id=1))), "4.usenames 4.drops"
    sensor = lambda: group(Node("TouchSensor", id=1), Node("TimeSensor", id=2), Node("Transform", id=3))
    routes = [Route(1, "touchTime", 2, "startTime"), Route(1, "touchTime", 2, "stopTime", id=3),
              Route(3, "translation", 3, "scale")]
    yield "routes-list", "ROUTEs as a list, one with an ID", SceneStream(route_bits=2).unit(
        c("scene", sensor(), routes=routes)), "4.routes-list 11.route 11.route-id"
    yield "routes-one", "a list of one ROUTE", SceneStream(route_bits=1).unit(
        c("scene", sensor(), routes=routes[:1])), "4.routes-list"
    yield "routes-vector", "ROUTEs with their count", SceneStream(route_bits=2).unit(
        c("scene", sensor(), routes=routes, vector_routes=True)), "4.routes-vector"


def commands():
    insert = simple()
    insert.unit(*[c("insert_node", 1, position, Node("Shape", id=10 + i))
                  for i, position in enumerate(("first", "last", 0, 3))])
    insert.unit(c("insert_node", 8, 1, Node("Transform", children=[Node("Shape")])),
        c("insert_node", 8, "last", Use(2)))
    yield "node-insertion", "nodes inserted first, last and between", insert, "3.position 3.insert-data-type"
    layer = SceneStream().unit(c("scene", Node("Layer2D", id=1)))
    layer.unit(c("insert_node", 1, "first", Node("Transform2D", id=2)), c("insert_node", 2, "last", Node("Shape")))
    yield "node-insertion-2d", "a 2D node is inserted with 2D codes", layer, "3.insert-data-type"
    value = simple()
    value.unit(c("insert_value", 7, "key", "first", -1), c("insert_value", 7, "key", 2, 0.25),
               c("insert_value", 7, "key", "last", 2), c("insert_value", 5, "point", 3, [7, 8, 9]),
               c("insert_value", 6, "choice", "last", Node("Transform", id=10)),
                   c("insert_value", 6, "choice", 0, None),
               c("insert_value", 5, "point", "last", [0.1, -0.1, 1e30]))
    yield "value-insertion", "values and nodes of lists inserted", value, "3.one-element 3.position 3.field-ref-in"
    yield "value-insertion-far", "an index of 16 bits beyond the end", simple().unit(
        c("insert_value", 7, "keyValue", 65535, 5)), "3.position"
    delete = simple().unit(c("delete_value", 7, "key", "first"), c("delete_value", 7, "key", 1),
                           c("delete_value", 6, "choice", "last"), c("delete_value", 1, "children", 0))
    yield "value-deletion", "values and nodes of lists deleted", delete, "3.position"
    yield "value-replacement", "values and nodes of lists replaced", simple().unit(
        c("replace_value", 7, "key", "first", -5), c("replace_value", 7, "key", 1, -4),
        c("replace_value", 7, "key", "last", -3), c("replace_value", 6, "choice", 1, Node("Transform")),
        c("replace_value", 6, "choice", "first", Use(3))), "3.position 3.one-element"
    yield "node-deletion", "nodes deleted, one with what is below it", simple().unit(
        c("delete_node", 9), c("delete_node", 4)), ""
    yield "node-deletion-ex", "nodes deleted by the extended command", simple().unit(c("delete_node_ex", 9)), ""
    yield "node-replacement", "a node replaced by a new one, by one that is there, by NULL", simple().unit(
        c("replace_node", 9, Node("SpotLight", id=10)), c("replace_node", 8, Use(2)),
            c("replace_node", 3, None)), "3.null-replacement"
    fields = simple().unit(
        c("replace_field", 2, "translation", [-1, 0, 1]), c("replace_field", 2, "addChildren", [Node("Shape", id=10)]),
        c("replace_field", 2, "rotation", [0, 1, 0, 0.5]), c("replace_field", 3, "geometry", None),
        c("replace_field", 7, "key", []), c("replace_field", 7, "set_fraction", 0.25),
        c("replace_field", 6, "choice", Vector([Node("Group"), Use(2)])),
            c("replace_field", 3, "geometry", Node("Sphere", radius=3)))
    yield "field-replacement", "fields of one value, of many, events, nodes and NULL", fields, "3.field-ref-in 3.null-field"
    routes = SceneStream(route_bits=3).unit(c("scene", group(Node("TouchSensor", id=1), Node("TimeSensor", id=2))))
    routes.unit(c("insert_route", Route(1, "touchTime", 2, "startTime", id=1)),
                c("insert_route", Route(1, "isActive", 2, "loop", id=8)),
                    c("insert_route", Route(1, "isOver", 2, "loop")))
    routes.unit(c("replace_route", 8, Route(1, "isOver", 2, "loop")), c("delete_route", 1))
    yield "routes", "ROUTEs inserted, replaced and deleted", routes, "11.route 11.route-id"


def extended():
    proto = lambda id: Proto(id, [Field(f"_field0", "exposedField", "SFFloat", default=id)], [Node("Group")])
    protos = simple(version=2, proto_bits=3)
    protos.unit(c("insert_protos", [proto(1), proto(2), proto(3), proto(7)]))
    protos.unit(c("insert_node", 1, "last", Node(2, id=10, _field0=0.5)), c("delete_protos", [1, 3]))
    protos.unit(c("delete_protos", Vector([7], 1)), c("delete_all_protos"), c("insert_protos", []))
    yield "proto-commands", "PROTOs inserted, deleted by list and by count, and all", protos, \
        "5.proto-deletion-list 5.proto-deletion-vector"
    yield "proto-deletion-none", "an empty list of PROTOs to delete", simple(version=2, proto_bits=1).unit(
        c("delete_protos", [])), "5.proto-deletion-list"
    many = simple().unit(c("replace_values", 7, "key", [(0, -1), (2, 9)]),
                         c("replace_values", 5, "point", [(1, [4, 5, 6])], 3),
                         c("replace_values", 6, "choice", [(1, Node("Transform", id=10)), (0, None)]),
                         c("replace_values", 7, "keyValue", [(i, 3.5 - i) for i in (2, 1, 0)]))
    yield "multiple-indexed-replacement", "several elements of numbers and nodes replaced", many, "5.multiple-indexed"
    some = simple().unit(
        c("replace_fields", 2, rotation=[0, 1, 0, 0.5], scale=[2, 2, 2]),
        c("replace_fields", 7, "list", key=[5, 6], keyValue=Vector([7.5, 8, 9])),
        c("replace_fields", 2, "list", [("scale", [1, 1, 1]), ("scale", [3, 3, 3]),
            ("children", [Node("Shape", id=10)])],
          scale=[3, 3, 3], children=[]), c("replace_fields", 9))
    some.unit(c("replace_fields", 4, coordIndex=[2, 1, 0, -1], ccw=False, creaseAngle=0.5))
    yield "multiple-field-replacement", "fields, plain ones too, as a mask and as a list", some, "5.multiple-fields 7.list-order"
    x = simple()
    x.unit(c("xreplace", 2, "translation", [9, 8, 7]), c("xreplace", 3, "geometry", Node("Cone", id=10)),
           c("xreplace", 7, "key", [1, 2, 3, 4]), c("xreplace", 5, "point", [4, 5, 6], position=1),
           c("xreplace", 6, "choice", Node("Group"), position="last"),
           c("xreplace", 1, "children", [3, 3, 3], position="first", child="translation",
               child_definition=NODES["Transform"]))
    yield "xreplace-values", "XReplace of fields, elements and fields of children", x, "5.xreplace-value"
    y = simple()
    y.unit(c("xreplace", 2, "translation", source=(2, "scale")), c("xreplace", 7, "keyValue", source=(7, "key")),
           c("xreplace", 5, "point", source=(2, "scale"), position=2),
           c("xreplace", 1, "children", source=(2, "scale"), position=0, child="translation",
               child_definition=NODES["Transform"]))
    yield "xreplace-from", "XReplace that copies from another field", y, "5.xreplace-from"
    z = simple()
    z.unit(c("xreplace", 7, "key", 0.125, index_from=(6, "whichChoice")),
           c("xreplace", 5, "point", source=(2, "translation"), index_from=(6, "whichChoice")),
           c("xreplace", 6, "choice", Node("Transform"), index_from=(6, "whichChoice")))
    yield "xreplace-dynamic", "XReplace with an index from a field", z, "5.xreplace-dynamic"


def values():
    def one(name, about, node, covers, **settings):
        stream = SceneStream(**settings).unit(c("scene", group(Node("Shape", id=1), node)))
        return name, about, stream, covers
    floats = [0, -0.0, 1, -1, 0.1, 1e-45, 1.17549435e-38, 3.4028235e38, -3.4028235e38, "inf", "-inf", "nan", 16777217,
        1 / 3]
    yield one("value-floats", "floats at their ends, denormal, infinite and not a number",
              Node("ScalarInterpolator", key=floats, keyValue=Listed(floats)), "8.float")
    yield one("value-times", "times: fractions, negative, large", Node(
        "TimeSensor", startTime=-1.5, stopTime=1e300, cycleInterval=0.1), "8.time")
    yield one("value-integers", "integers at their ends", Node("Shape", geometry=Node(
        "IndexedFaceSet", coordIndex=[0, -1, 2147483647, -2147483648, 65536])), "")
    strings = ["", "a", "quote \" and \\", "line\nend\ttab", "äöü € 漢字 😀", "x" * 300]
    yield one("value-strings", "strings: none, quotes, control characters, Unicode, long",
        Node("WorldInfo", info=strings, title="t"), "8.string")
    loose = Text("loose")
    loose.more = 20
    yield one("value-string-wide-length", "a length in more bits than it needs", Node("WorldInfo", title=loose),
        "8.length-width")
    yield one("value-urls", "URLs: strings and object descriptors", Node("Anchor", url=[
        {"od": 0}, {"od": 1}, {"od": 1023}, "", "http://example.org/a#b", "od:10"]), "8.url")
    for components in (1, 2, 3, 4):
        texture = Node("PixelTexture", image=Image(3, 2, components, range(40, 40 + 6 * components)))
        yield one(f"value-image-{components}", f"an image with {components} components", Node(
            "Shape", appearance=Node("Appearance", texture=texture)), "8.image")
    yield one("value-image-none", "an image of no pixels, and one that is wide", Node(
        "Shape", appearance=Node("Appearance", texture=Node("PixelTexture", image=Image(4095, 1, 1, bytes(4095))))),
            "8.image")
    yield one("value-bytes", "a buffer of all bytes, NUL too", Node("BitWrapper", buffer=bytes(range(256)), type=3),
        "8.buffer-bytes")
    for count in (0, 1, 6, 7, 31, 32, 255, 256):
        numbers = [i % 7 for i in range(count)]
        yield one(f"value-list-{count}", f"lists and counts of {count} elements", Node(
            "Shape", geometry=Node("IndexedFaceSet", coordIndex=Listed(numbers), colorIndex=Vector(numbers),
                                   normalIndex=Vector(numbers, 3))),
                                       "8.list 8.vector 8.reserved 8.length-width" + (" 8.empty" if not count else ""))
    buffers = SceneStream()
    buffers.unit(c("scene", group(
        Node("Conditional", id=1, buffer=Buffer(c("replace_field", 3, "translation", [1, 2, 3]), c(
            "insert_node", 4, "last", Node("Shape")), c("delete_node", 2))),
        Node("Conditional", id=2, buffer=Buffer()), Node("Transform", id=3), group(id=4),
        Node("InputSensor", id=5, buffer=Buffer(c("delete_value", 4, "children", "first"))))))
    buffers.unit(c("replace_field", 2, "buffer", Buffer(c("delete_node", 3))))
    yield "value-command-buffers", "command buffers: of several commands, empty, for nodes that come later", buffers, \
        "8.command-buffer 8.buffer-later"
    yield one("value-vec4f", "vectors of four", Node("CoordinateInterpolator4D", key=[0, 1],
        keyValue=[[1, 2, 3, 4], [5, 6, 7, 8.5]]), "")


def node_forms():
    def one(name, about, *children, covers="", **settings):
        return name, about, SceneStream(**settings).unit(c("scene", group(*children))), covers
    move = {"translation": [1, 2, 3], "scale": [2, 2, 2]}
    yield one("node-mask", "a mask description", Node("Transform", **move), covers="7.mask-node 7.defaults")
    yield one("node-mask-empty", "masks of zeros", Node("Transform"), Node("Shape"), covers="7.mask-node")
    yield one("node-list", "a list description", Node("Transform", form="list", **move), covers="7.list-node")
    yield one("node-list-order", "a list backwards, with a field twice: the last holds", Node(
        "Transform", form="list", order=[("translation", [9, 9, 9]), ("scale", [1, 2, 3]), ("translation", [4, 5, 6])],
        translation=[4, 5, 6], scale=[1, 2, 3]), covers="7.list-order")
    yield one("node-list-empty", "lists without fields", Node("Transform", form="list"), Node("Shape", form="list"),
        covers="7.list-node")
    yield one("node-one-field", "an index of one field has no bits", Node(
        "Shape", geometry=Node("Sphere", form="list", radius=2)), covers="7.index-width")
    yield one("node-use", "nodes used again, and NULL", Node("Transform", id=1, children=[Node("Shape", id=2)]),
        Use(2), None, Use(1),
              covers="6.reused 6.null 6.updateable 1.null-id")
    yield one("node-largest-id", "the largest ID that a width has", Node("Transform", id=15), Use(15),
        covers="1.null-id 1.ids", node_bits=4)
    yield one("node-depth-texture", "data types without nodes in some versions",
        Node("DepthImage", diTexture=Node("SimpleTexture")),
              Node("OctreeImage", images=[Node("DepthImage"), Node("DepthImageV2")], octree=[255, 1],
                  voxelImageIndex=[1, 2]),
              Node("DepthImageV2", diTexture=Node("PointTextureV2")), covers="6.no-table 6.escape")
    deep = Node("Shape")
    for _ in range(30):
        deep = group(deep)
    yield one("node-depth", "thirty nodes below each other", deep, covers="6.reused")


def all_cases():
    for part in (configurations, frames, scenes, commands, extended, values, node_forms):
        yield from part()
