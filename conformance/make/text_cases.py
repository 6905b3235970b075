# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The cases of suites/scene-text-syntax: a text, and the commands that it stands for. (name, about, kind, text, stream, covers)"""
from bifs_cases import group
from command_writer import SceneStream, command as c
from node_facts import Field
from scene_values import Image, Node, Proto, Route, Use

VRML = "#VRML V2.0 utf8\n"
XMT = ('<?xml version="1.0" encoding="UTF-8"?>\n<XMT-A xmlns="urn:mpeg:mpeg4:xmta:schema:2002">\n<Header/>\n<Body>\n'
       '<Replace>\n<Scene>\n%s\n</Scene>\n</Replace>\n%s</Body>\n</XMT-A>\n')


def scene(*children, **more):
    return SceneStream(**more).unit(c("scene", group(*children)))


def wrl():
    shape = "Shape { geometry Sphere { radius 2 } }"
    ball = lambda: Node("Shape", geometry=Node("Sphere", radius=2))
    yield "header", "with the line of VRML", "wrl", VRML + "Group { children [ " + shape + " ] }", scene(
        ball()), "1.header 2.node"
    yield "comments", "comments, commas and line ends between everything", "wrl", \
        VRML + "# first\nGroup{children[,Shape#x\n{geometry,Sphere{radius\r\n2}}#last\r]}", scene(
            ball()), "1.comment 1.separators"
    yield "field-order", "fields in any order", "wrl", "Group { children Transform { scale 2 2 2 translation 1 2 3 } }", \
        scene(Node("Transform", translation=[1, 2, 3], scale=[2, 2, 2])), "2.node 3.multiple"
    yield "numbers", "numbers in every form", "wrl", \
        "Group { children [ Transform { translation +1 -.5 2.5e3 scale 1E-2 10. 0x10 } Switch { whichChoice 0x1F } Switch { whichChoice -1 } ] }" \
        .replace(" 0x10 }", " 16 }"), scene(Node("Transform", translation=[1, -0.5, 2500], scale=[0.01, 10, 16]),
            Node("Switch", whichChoice=31),
                                            Node("Switch")), "3.number"
    yield "strings", "quotes, backslashes, line ends and Unicode in strings", "wrl", \
        'Group { children WorldInfo { title "a \\" b \\\\ c" info [ "", "zwei\nZeilen" "äöü 漢字" ] } }', \
        scene(Node("WorldInfo", title='a " b \\ c', info=["", "zwei\nZeilen", "äöü 漢字"])), "3.string"
    yield "booleans", "TRUE and FALSE", "wrl", "Group { children TimeSensor { loop TRUE enabled FALSE } }", \
        scene(Node("TimeSensor", loop=True, enabled=False)), "3.bool"
    yield "multiple", "lists, one value without brackets, an empty list", "wrl", \
        "Group { children [ ScalarInterpolator { key [ 0, 1 ] keyValue 5 } Anchor { parameter [ ] url \"a\" } ] }", \
        scene(Node("ScalarInterpolator", key=[0, 1], keyValue=[5]), Node("Anchor", url=["a"])), "3.multiple"
    yield "image", "an image of each number of components", "wrl", \
        "Group { children [ " + " ".join(
            f"Shape {{ appearance Appearance {{ texture PixelTexture {{ image 2 1 {n} {a} {b} }} }} }}" for n, a, b in (
            (1, "0x10", "255"), (2, "0x1020", "0"), (3, "0x102030", "0xFFFFFF"),
                (4, "0x10203040", "0xFFFFFFFF"))) + " ] }", \
        scene(*[Node("Shape", appearance=Node("Appearance",
            texture=Node("PixelTexture", image=Image(2, 1, n, data)))) for n, data in (
            (1, b"\x10\xff"), (2, b"\x10\x20\0\0"), (3, b"\x10\x20\x30\xff\xff\xff"),
                (4, b"\x10\x20\x30\x40\xff\xff\xff\xff"))]), "3.image"
    yield "def-use", "DEF, USE and NULL", "wrl", "Group { children [ DEF A Shape { geometry NULL } USE A DEF A Transform { } USE A ] }", \
        scene(Node("Shape", id=1), Use(1), Node("Transform", id=2), Use(2)), "2.def-use 2.null"
    yield "routes", "ROUTEs behind the scene and inside it", "wrl", \
        "DEF G Group { children [ DEF T TouchSensor { } DEF M TimeSensor { } ] ROUTE T.touchTime TO M.startTime }\nROUTE T.isActive TO M.loop", \
        SceneStream().unit(c("scene", group(Node("TouchSensor", id=2), Node("TimeSensor", id=3), id=1), routes=[
            Route(2, "touchTime", 3, "startTime"), Route(2, "isActive", 3, "loop")])), "4.route"
    proto = Proto(1, [Field("_field0", "exposedField", "SFFloat", default=1),
        Field("_field1", "field", "SFNode", default=None),
                      Field("_field2", "eventIn", "SFBool")],
                          [Node("Shape", geometry=Node("Sphere", links={"radius": "_field0"}))])
    yield "proto", "a PROTO, its interface, body and instance", "wrl", \
        "PROTO Ball [ exposedField SFFloat size 1 field SFNode n NULL eventIn SFBool go ] { Shape { geometry Sphere { radius IS size } } }\n" \
        "Group { children Ball { size 3 } }", SceneStream(version=2,
            proto_bits=1).unit(c("scene", group(Node(1, _field0=3)), [proto])), "5.proto 5.is"
    yield "externproto", "an EXTERNPROTO", "wrl", \
        'EXTERNPROTO Far [ field SFInt32 n eventOut SFBool done ] [ "a.wrl#Far" "b.wrl" ]\nGroup { children Far { n 4 } }', \
        SceneStream(version=2, proto_bits=1).unit(c("scene", group(Node(1, _field0=4)),
            [Proto(1, [Field("_field0", "field", "SFInt32", default=0), Field(
            "_field1", "eventOut", "SFBool")], extern=["a.wrl#Far", "b.wrl"])])), "5.proto"


def bt():
    yield "buffers", "buffers as data URL, hexadecimal and base64", "bt", \
        'Group { children [ BitWrapper { buffer "data:application/octet-string,0B30ff" } BitWrapper { buffer "data:application/octet-string;base64,AAEC" } ] }', \
        scene(Node("BitWrapper", buffer=b"\x0b\x30\xff"), Node("BitWrapper", buffer=b"\0\1\2")), "3.buffer"
    yield "urls", "strings and object descriptors", "bt", 'Group { children Anchor { url [ "od:10" "a#b" ] } }', \
        scene(Node("Anchor", url=[{"od": 10}, "a#b"])), "3.url"
    stream = SceneStream().unit(c("scene", group(Node("Transform", id=1),
        Node("ScalarInterpolator", id=2, key=[1, 2]))), time=0)
    stream.unit(c("replace_field", 1, "translation", [1, 2, 3]), c("replace_value", 2, "key", 1, 5), time=1000)
    stream.unit(c("insert_value", 2, "key", "last", 7), c("delete_value", 2, "key", "last"), time=1500)
    stream.unit(c("delete_node", 1), time=3000)
    yield "commands", "commands at absolute and relative times", "bt", \
        "Group { children [ DEF T Transform { } DEF S ScalarInterpolator { key [ 1 2 ] } ] }\nAT 1000 { REPLACE T.translation BY 1 2 3 REPLACE S.key[1] BY 5 }\n" \
        "AT D500 { APPEND TO S.key 7 DELETE S.key[-1] }\nRAP AT 3000 { DELETE T }\n", stream, "6.commands 6.at"
    sized = SceneStream().unit(c("scene", group(Node("Shape"))))
    yield "descriptors", "an initial object descriptor before the scene", "bt", \
        "InitialObjectDescriptor { objectDescriptorID 1 esDescr [ ES_Descriptor { ES_ID 1 decConfigDescr DecoderConfigDescriptor { streamType 3\n" \
        "decSpecificInfo BIFSConfig { nodeIDbits 10 pixelMetric true pixelWidth 320 pixelHeight 240 } } } ] }\nGroup { children Shape { } }", sized, "6.descriptors"


def xmt():
    yield "xmt-scene", "nodes and their fields", "xmt", XMT % (
        '<Group><children><Transform translation="1 2 3"><children><Shape><geometry><Box size="1 1 2"/></geometry></Shape></children></Transform>'
        '<Shape DEF="A"/><Shape USE="A"/></children></Group>',
            ""), scene(Node("Transform", children=[Node("Shape", geometry=Node(
            "Box", size=[1, 1, 2]))], translation=[1, 2, 3]), Node("Shape", id=1), Use(1)), "7.xml"
    yield "xmt-entities", "entities, numbers of characters and single quotes", "xmt", XMT % (
        "<Group><children><WorldInfo title='&lt;a&gt; &amp; &#228;&#x6f22;'/></children></Group>",
            ""), scene(Node("WorldInfo", title="<a> & ä漢")), "7.entities"
    yield "xmt-comments", "comments, white space and an unused namespace", "xmt", (XMT % (
        "<!-- a --><Group>\n<children>\t<Shape><!-- < & > --></Shape></children></Group>",
            "")), scene(Node("Shape")), "7.xml"
    yield "xmt-commands", "a command of a later time", "xmt", XMT % (
        '<Group><children><Transform DEF="T"/></children></Group>',
        '<par begin="1"><Replace atNode="T" atField="translation" value="4 5 6"/></par>\n'), SceneStream().unit(
            c("scene", group(Node("Transform", id=1))), time=0).unit(c("replace_field", 1, "translation", [4, 5, 6]),
                time=1000), "7.xml 6.commands"


def all_cases():
    for part in (wrl, bt, xmt):
        yield from part()
