# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The cases of suites/scene-text-rejects. A ¦ in a text marks where it is wrong: (name, about, kind, text, code, covers)"""
from text_cases import VRML, XMT

BAD = "malformed"


def wrl():
    def one(name, about, text, covers, code=BAD):
        return name, about, "wrl", VRML + text, code, covers

    def field(name, about, node, covers, code=BAD):
        return one(name, about, "Group { children [\n  " + node + "\n] }\n", covers, code)
    yield field("unknown-node", "a node that does not exist", "¦Sphear { }", "2.unknown-node")
    yield one("lower-case-node", "a node in lower case", "¦group { }", "2.unknown-node")
    yield field("unknown-field", "a field that the node does not have", "Transform { ¦tranlation 1 2 3 }",
        "2.unknown-field")
    yield field("field-twice", "a field given twice", "Transform { scale 1 1 1 ¦scale 2 2 2 }", "2.node")
    yield field("event-value", "a value for an event", "ScalarInterpolator { set_fraction ¦0.5 }", "2.event-value")
    yield field("use-unknown", "the use of a name that was not defined", "USE ¦A", "2.use-unknown")
    yield field("use-later", "the use of a name that is defined later", "USE ¦A DEF A Shape { }", "2.use-unknown")
    yield field("use-inside", "the use of a node inside itself", "DEF A Group { children USE ¦A }", "2.use-unknown")
    yield field("def-nothing", "a DEF without a node", "DEF A ¦]", "2.node")
    yield field("def-no-name", "a DEF without a name", "DEF ¦{ }", "2.node")
    yield field("use-no-name", "a USE without a name", "USE ¦] ", "2.node")
    yield field("data-type-child", "a material as a child", "¦Material { }", "2.data-type")
    yield field("data-type-geometry", "a light as geometry", "Shape { geometry ¦PointLight { } }", "2.data-type")
    yield field("data-type-use", "a used material as a child",
        "Shape { appearance Appearance { material DEF M Material { } } } ¦USE M", "2.data-type")
    yield field("no-brace", "a node without an opening brace", "Shape ¦geometry Box { }", "2.braces")
    yield one("brace-open", "a node that is never closed", "Group { children [ ]\n¦", "2.braces", "truncated")
    yield one("bracket-open", "a list that is never closed", "Group { children [ Shape { }\n¦", "2.braces", "truncated")
    yield one("brace-wrong", "a list closed by a brace", "Group { children [ Shape { } ¦} }", "2.braces")
    yield one("brace-extra", "a brace too many", "Group { }\n¦}", "2.braces")
    yield one("bracket-extra", "a bracket too many", "Group { children [ ] ¦] }", "2.braces")
    yield field("count-few", "two numbers where three are needed", "Transform { translation 1 2 ¦}", "3.count")
    yield field("count-many", "four numbers where three are needed", "Transform { translation 1 2 3 ¦4 }", "3.count")
    yield field("count-list", "a list of points that ends inside one",
        "Shape { geometry PointSet { coord Coordinate { point [ 1 2 3, 4 ¦] } } }", "3.count 3.multiple")
    yield field("no-value", "a field without a value", "Transform { translation ¦}", "3.count")
    yield field("number-word", "a word where a number is needed", "Shape { geometry Sphere { radius ¦big } }",
        "3.number")
    yield field("number-string", "a string where a number is needed", "Shape { geometry Sphere { radius ¦\"2\" } }",
        "3.number")
    yield field("number-list", "a list for a field of one number", "Shape { geometry Sphere { radius ¦[ 2 ] } }",
        "3.number")
    yield field("number-dots", "a number with two points", "Shape { geometry Sphere { radius ¦1.2.3 } }", "3.number")
    yield field("number-signs", "a number with two signs", "Transform { translation ¦--1 0 0 }", "3.number")
    yield field("number-exponent", "a number whose exponent has no digits", "Shape { geometry Sphere { radius ¦1e } }",
        "3.number")
    yield field("number-hex", "a hexadecimal number without digits", "Switch { whichChoice ¦0x }", "3.number")
    yield field("integer-fraction", "a fraction for an integer", "Switch { whichChoice ¦1.5 }", "3.number")
    yield field("integer-range", "an integer of more than 32 bits", "Switch { whichChoice ¦3000000000 }",
        "3.number-range")
    yield field("bool-word", "a word that is neither TRUE nor FALSE", "TimeSensor { loop ¦YES }", "3.bool")
    yield field("string-bare", "a string without quotes", "WorldInfo { title ¦hello }", "3.string")
    yield one("string-open", "a string that is never closed", "WorldInfo { title ¦\"hello }\n", "3.string-end",
        "truncated")
    yield one("string-open-escape", "a text that ends behind a backslash", "WorldInfo { title ¦\"hello\\",
        "3.string-end", "truncated")
    texture = "Shape { appearance Appearance { texture PixelTexture { image %s} } }"
    yield field("image-few", "an image without its last pixel", texture % "2 1 1 7 ¦", "3.image-size")
    yield field("image-components", "an image of five components", texture % "1 1 5 0 ", "3.image")
    yield field("image-negative", "an image of negative width", texture % "¦-1 1 1 ", "3.image")
    yield field("image-huge", "an image of more pixels than the text has", texture % "4000 4000 3 0 ", "3.image-size",
        "truncated")
    yield field("null-child", "a word for NULL", "Shape { geometry ¦Null }", "2.null 2.unknown-node")
    yield one("character", "a character that begins nothing", "Group { ¦@ }", "2.node")
    deep = "Group { children " * 3000
    yield one("deep", "three thousand groups within each other", deep, "2.depth", "limit_exceeded")
    yield one("deep-lists", "brackets within brackets", "Group { children [ ¦[ ] ] }", "2.data-type")


def routes():
    def one(name, about, route, covers="4.route", code=BAD):
        return name, about, "wrl", VRML + "Group { children [ DEF T TouchSensor { } DEF M TimeSensor { } ] }\n" + route, code, covers
    yield one("route-node", "a ROUTE from a node that is not there", "ROUTE ¦X.isActive TO M.loop", "4.route-unknown")
    yield one("route-target", "a ROUTE to a node that is not there", "ROUTE T.isActive TO ¦X.loop", "4.route-unknown")
    yield one("route-field", "a ROUTE from a field that is not there", "ROUTE T.¦nothing TO M.loop", "4.route-unknown")
    yield one("route-into-output", "a ROUTE to an output", "ROUTE T.isActive TO M.¦isActive")
    yield one("route-from-input", "a ROUTE from a field that is no output", "ROUTE M.¦set_loop TO M.loop",
        "4.route-unknown")
    yield one("route-types", "a ROUTE between different types", "ROUTE T.isActive TO ¦M.startTime")
    yield one("route-no-to", "a ROUTE without TO", "ROUTE T.isActive ¦M.loop")
    yield one("route-cut", "a ROUTE that ends behind TO", "ROUTE T.isActive TO\n¦", "4.route", "truncated")


def protos():
    def one(name, about, text, covers="5.proto-damaged", code=BAD):
        return name, about, "wrl", VRML + text, code, covers
    yield one("proto-type", "an interface field of an unknown type", "PROTO P [ field ¦SFFlaot a 1 ] { Group { } }")
    yield one("proto-event", "an interface field of an unknown kind", "PROTO P [ ¦constant SFFloat a 1 ] { Group { } }")
    yield one("proto-twice", "two PROTOs of one name", "PROTO P [ ] { Group { } }\nPROTO ¦P [ ] { Group { } }")
    yield one("proto-field-twice", "two interface fields of one name",
        "PROTO P [ field SFBool a TRUE ¦field SFBool a TRUE ] { Group { } }")
    yield one("proto-no-default", "an interface field without a default", "PROTO P [ field SFFloat a ¦] { Group { } }")
    yield one("proto-open", "a body that is never closed", "PROTO P [ ] { Group { }\n¦", code="truncated")
    yield one("proto-itself", "a PROTO that holds itself", "PROTO P [ ] { ¦P { } }\nP { }")
    yield one("proto-later", "an instance before its PROTO", "¦P { }\nPROTO P [ ] { Group { } }", "2.unknown-node")
    yield one("is-unknown", "a connection to a field that is not there",
        "PROTO P [ ] { Transform { scale IS ¦size } }", "5.is")
    yield one("is-type", "a connection between different types",
        "PROTO P [ field SFFloat size 1 ] { Transform { scale IS ¦size } }", "5.is")
    yield one("is-outside", "a connection outside of any PROTO", "Transform { scale ¦IS size }", "5.is")
    yield one("extern-no-url", "an EXTERNPROTO without its URLs", "EXTERNPROTO P [ field SFBool a ] ¦Group { }")


def bt():
    def one(name, about, text, covers="6.command-unknown", code=BAD):
        return name, about, "bt", "Group { children [ DEF T Transform { } DEF S ScalarInterpolator { key [ 1 2 ] } DEF D DepthImage { } ] }\n" + text, code, covers
    yield one("command-word", "a command that does not exist", "AT 100 { ¦FROB T }")
    yield one("command-node", "a command for a node that is not there", "AT 100 { DELETE ¦X }")
    yield one("command-field", "a command for a field that is not there", "AT 100 { REPLACE T.¦position BY 1 2 3 }")
    yield one("command-plain-field", "a command for a field that cannot be changed",
        "AT 100 { REPLACE D.¦position BY 1 2 3 }")
    yield one("command-value", "a command with too few numbers", "AT 100 { REPLACE T.translation BY 1 2 ¦}")
    yield one("command-no-by", "a replacement without BY", "AT 100 { REPLACE T.translation ¦1 2 3 }")
    yield one("command-route", "a ROUTE deleted that is not there", "AT 100 { DELETE ROUTE ¦R }")
    yield one("command-not-list", "an element of a field of one value", "AT 100 { REPLACE T.translation¦[0] BY 1 2 3 }")
    yield one("at-no-time", "a block without a time", "AT ¦{ DELETE T }", "6.at")
    yield one("at-open", "a block that is never closed", "AT 100 { DELETE T\n¦", "6.at 2.braces", "truncated")
    yield "descriptor-unknown", "a descriptor that does not exist", "bt", "InitialObjectDescriptor { esDescr [ ¦EX_Descriptor { } ] }\nGroup { }\n", BAD, "6.descriptors"
    yield "descriptor-field", "a field that a descriptor does not have", "bt", "InitialObjectDescriptor { ¦nothing 1 }\nGroup { }\n", BAD, "6.descriptors"
    yield "descriptor-open", "a descriptor that is never closed", "bt", "InitialObjectDescriptor { objectDescriptorID 1\n¦", "truncated", "6.descriptors 2.braces"
    yield "buffer-hex", "a buffer with a character that is no digit", "bt", 'Group { children BitWrapper { buffer ¦"data:application/octet-string,0B3G" } }\n', BAD, "3.buffer"


def xmt():
    def one(name, about, text, covers="7.xml-damaged", code=BAD):
        return name, about, "xmt", text, code, covers

    def body(name, about, text, covers, code=BAD):
        return one(name, about, XMT % (text, ""), covers, code)
    yield one("xml-none", "a text that is no XML", "Group { }\n")
    yield one("xml-other", "XML of something else", "<¦html></html>\n", "7.xml-unknown")
    yield body("xml-unclosed", "an element that is never closed", "<Group><children></¦Group>", "7.xml-damaged")
    yield one("xml-cut", "a text that ends inside a tag", (XMT % ("<Group/>", ""))[:120], "7.xml-damaged")
    yield body("xml-attribute-bare", "an attribute without quotes", '<Transform translation=¦1/>', "7.xml-damaged")
    yield body("xml-attribute-twice", "an attribute given twice", '<Transform scale="1 1 1" ¦scale="2 2 2"/>',
        "7.xml-damaged")
    yield body("xml-entity", "an entity that does not exist", '<WorldInfo title="a ¦&nothing; b"/>',
        "7.xml-damaged 7.entities")
    yield body("xml-character", "the number of no character", '<WorldInfo title="¦&#0;"/>', "7.xml-damaged 7.entities")
    yield one("xml-comment", "a comment that is never closed",
        (XMT % ("<Group/>", "")).replace("<Body>", "<Body>\n<!-- "), "7.xml-damaged")
    yield body("xmt-node", "a node that does not exist", "<Group><children><¦Sphear/></children></Group>",
        "7.xml-unknown 2.unknown-node")
    yield body("xmt-field", "an attribute that the node does not have",
        '<Group><children><Transform ¦position="1 2 3"/></children></Group>', "7.xml-unknown 2.unknown-field")
    yield body("xmt-number", "a word where a number is needed",
        '<Group><children><Transform translation="1 ¦x 3"/></children></Group>', "3.number")
    yield body("xmt-count", "two numbers where three are needed",
        '<Group><children><Transform translation="1 2¦"/></children></Group>', "3.count")
    yield body("xmt-data-type", "a material as a child", "<Group><children><¦Material/></children></Group>",
        "2.data-type")
    yield body("xmt-use", "the use of a name that was not defined",
        '<Group><children><Shape USE="¦A"/></children></Group>', "2.use-unknown")
    yield body("xmt-deep", "three thousand groups within each other",
        "<Group><children>" * 3000 + "</children></Group>" * 3000, "2.depth", "limit_exceeded")


def all_cases():
    for part in (wrl, routes, protos, bt, xmt):
        yield from part()
