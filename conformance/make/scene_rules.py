# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""The rules that the suites of scenes cover, each one sentence, with the section of the text it was taken from;
and one for each element of the tables. Writes suites/rules/{bifs,mp4,scene-text}.json."""
import json
import os

import node_facts as facts
from suite_writer import AFX, SUITES

BIFS = """
1.bit-order|1|Bits are written most significant first, without alignment inside an access unit.
1.name|1|A name is a sequence of bytes ended by a zero byte.
1.ids|1|A node ID or ROUTE ID is stored minus 1, a PROTO ID as it is.
1.null-id|1|The node ID with all bits set means no node.
2.config-1|2|A configuration of object type 1 has nodeIDbits, routeIDbits and no protoIDbits.
2.config-2|2|A configuration of object type 2 has use3DMeshCoding, usePredictiveMFField and protoIDbits too.
2.size|2|The size, if there is one, is two numbers of 16 bits.
2.no-size|2|A configuration without a size ends behind hasSize, with zero bits up to the next byte.
2.pixel-metric|2|pixelMetric says whether coordinates are pixels or metres.
2.id-widths|2|IDs take the width that the configuration says, up to 31 bits, also 0.
2.later-nodes|2|A stream of object type 1 can carry nodes of every version.
2.truncated|2|A configuration that ends too early is truncated.
2.mesh|2|3D mesh coding is not supported by everybody, and a scene with it is refused.
2.predictive-flag|2|With usePredictiveMFField each multiple field begins with a flag.
2.extended|2|Object type 4 announces BIFSConfigEx, which the text does not describe.
2.anim|2|A configuration that is no command stream announces BIFS-Anim.
3.frame|3|An access unit is a sequence of commands, each followed by moreCommands.
3.padding|3|Zero bits fill the last byte of an access unit.
3.trailing|3|Bytes behind the frame are ignored.
3.position|3|A position is first, last, or an index of 8 bits for node insertion and 16 for values.
3.position-reserved|3|The value 1 of a position is reserved.
3.deletion-reserved|3|The sub-type 1 of the deletions is reserved.
3.field-ref-in|3|Commands address fields by their IN index.
3.insert-data-type|3|A node is inserted in the data type that its parent's table says.
3.insert-target|3|A node can be inserted only into a node with children.
3.one-element|3|The value of an indexed command is one element, coded as the single type.
3.not-indexable|3|An indexed command needs a multiple field.
3.no-in-field|3|A plain field has no IN index and cannot be changed by these commands.
3.null-replacement|3|Replacing a node by NULL removes it.
3.null-field|3|A field that holds a node is emptied by the NULL node as its value.
3.unknown-target|3|A command addresses a node that is known.
3.truncated|3|An access unit that ends inside a command is truncated.
4.scene|4|A scene replacement is 6 reserved bits, USENAMES, PROTOs, a top node and ROUTEs.
4.drops|4|A scene replacement drops all nodes, IDs, PROTOs and ROUTEs that were there.
4.usenames|4|With USENAMES nodes, ROUTEs, PROTOs and their fields carry names, in later access units too.
4.top-node|4|The top node is one of the data type SFTopNode, or NULL.
4.routes-list|4|ROUTEs may be listed, each followed by moreROUTEs.
4.routes-vector|4|ROUTEs may be written with their count.
5.proto-deletion-list|5|PROTO IDs to delete may be listed.
5.proto-deletion-vector|5|PROTO IDs to delete may be written with their count.
5.multiple-indexed|5|Multiple indexed replacement gives several elements of one field, each with its index.
5.multiple-fields|5|Multiple field replacement gives fields by DEF index, as a mask or a list.
5.global-quantizer|5|The global quantizer is a QuantizationParameter or NULL.
5.xreplace-value|5|XReplace gives a value to a field, to an element of it, or to a field of a child.
5.xreplace-from|5|XReplace copies a value from a field of another node.
5.xreplace-dynamic|5|XReplace can take the index from a field.
5.reserved|5|Extended commands above 7 are not known.
6.reused|6.1|A node is new, or the use of one that is known by its ID.
6.null|6.1|No node is written as the reuse of the ID with all bits set.
6.updateable|6.1|A node with an ID says so by isUpdateable.
6.use-behind|6.1|A node can be used only behind its end in the order of the stream.
6.use-data-type|6.1|A node can be used only where its data type is allowed.
6.escape|6.2|Code 0 leads to the table of the next version.
6.code-unknown|6.2|A code that no node has is an error.
6.code-end|6.2|Escapes beyond the last table are an error.
6.no-table|6.2|A data type without nodes in a version takes no bit there, and one bit in version 2.
6.proto-code|6.2|Code 1 in version 2 is a PROTO instance, in every data type.
7.index-width|7|An index of n fields takes the bits of n - 1, none for one field.
7.mask-node|7.1|A mask has one bit for each DEF field, followed by the value where it is 1.
7.mask-proto|7.1|Inside a PROTO a mask runs over all fields, and each one present has isIS.
7.list-node|7.2|A list gives fields by DEF index, each behind an end flag of 0.
7.list-proto|7.2|Inside a PROTO the elements of a list have isIS behind the end flag.
7.list-order|7.2|The fields of a list may come in any order, and the last of a repeated field holds.
7.field-unknown|7.2|An index behind the last field is an error.
7.defaults|7.2|Fields that are not there have their defaults.
8.float|8.1|A float is 32 bits of IEEE 754, infinities and NaN too.
8.time|8.1|A time is a binary64 and never quantized.
8.string|8.1|A string is the width of its length, the length in bytes, the bytes.
8.length-width|8.1|The width of a length or count may be larger than needed.
8.url|8.1|A URL is an object descriptor's ID of 10 bits, or a string.
8.image|8.1|An image has width, height, components and its samples.
8.buffer-bytes|8.1|The buffer of a BitWrapper holds any bytes.
8.command-buffer|8.1|A command buffer holds a complete command frame, or nothing.
8.buffer-later|8.1|A command buffer can refer to nodes that are defined later in the access unit.
8.list|8.2|A multiple value may be a list with end flags.
8.vector|8.2|A multiple value may be written with its count.
8.empty|8.2|An empty value is an empty list or a count of 0.
8.reserved|8.2|The reserved bit of a multiple value is 0.
8.huge-count|8.2|A count that the data cannot hold is refused without allocating for it.
9.scope-list|9.1|A quantizer in a list of nodes is active from its end to the end of the list, for what is below too.
9.scope-before|9.1|Behind the list the quantizer that was active before is active again.
9.second|9.1|A second quantizer in a list replaces the first as a whole.
9.local|9.1|A local quantizer is active for the next sibling alone.
9.itself|9.1|A quantizer is coded under the one active before it.
9.global|9.1|The global quantizer is active from its command on, in later access units too.
9.global-null|9.1|NULL ends the global quantizer.
9.defaults|9.2|A quantizer without fields quantizes colours, texture coordinates, angles, keys, normals and rotations.
9.linear|9.3|A linear code stands for lower bound + range * code / largest code, in binary32.
9.bounds|9.3|The bounds are the narrower ones of the field's table and the quantizer.
9.saturate|9.3|Values outside the bounds become the bounds.
9.int-linear|9.3|An integer field with a linear category cannot be coded when that is switched on.
9.int-13|9.4|Category 13 is the value minus the lower bound in the bits of the table.
9.index-14|9.4|Category 14 takes the bits of the number of points of the geometry, with -1 as 0.
9.index-used|9.4|The points may be those of a Coordinate that is used again.
9.no-points|9.4|Without coordinates before it an index cannot be coded.
9.efficient|9.5|An efficient float has mantissa and exponent of given lengths, signs before each.
9.efficient-all|9.5|Under efficient coding every float that is not quantized is efficient.
9.normal|9.6|A normal is direction, orientation and two components.
9.rotation|9.6|A rotation is orientation and three components of its unit quaternion.
9.orientation|9.6|The orientation of a normal is at most 2.
10.header|10|A predictive field is its count, intraMode, the period in mode 1, parameters and values.
10.intra-modes|10|Intra is the first value, each of a period, or each that a flag in the arithmetic code says.
10.reserved-mode|10|The intraMode 3 is reserved.
10.period|10|A period is 1 or more.
10.empty|10|A count of 0 is followed by the rest of the header and nothing else.
10.parameters|10|Parameters are compNbBits and a compMin of NbBits + 1 bits: 3 in category 1, 2 in category 2, else 1.
10.width|10|compNbBits is at most 13: the frequencies of more residuals exceed the largest total.
10.new-parameters|10|In modes 1 and 2 each intra value but the first may bring new parameters, with new models.
10.residuals|10|A predicted component is the one before + compMin + a symbol of an adaptive arithmetic code.
10.frequencies|10|Frequencies begin with 1 and are halved, rounded up, when their total is 16383.
10.no-bits|10|Residuals of 0 bits are symbols too.
10.ends|10|A code ends before an intra value and at the end of the field, with the two bits that settle it.
10.stuffing|10|A 1 is stuffed in before the bit behind 22 zeros of a code, and none at its end.
10.range|10|A predicted component is within the range of the quantizer.
10.categories|10|Values of every category can be predicted.
10.normals|10|A predicted normal begins with a symbol, 1 where the direction flips.
10.rotations|10|A predicted rotation is the residuals of its three components.
10.orientation|10|A residual may lead over the edge of one component, whose axis becomes the orientation.
10.quantized|10|Only a field that is quantized can be predictive.
11.route|11|A ROUTE is an optional ID, node and OUT field, node and IN field.
11.route-id|11|A ROUTE with an ID has it minus 1.
12.interface|12|A PROTO has an ID and fields, each of an event type, a field type and a default.
12.default|12|Defaults are never quantized.
12.extern|12|An EXTERNPROTO has URLs in place of a body.
12.body|12|A body has PROTOs of its own, at least one node, and ROUTEs.
12.is|12|A field of a node in a body may be connected to one of the interface.
12.scope|12|Bodies have their own node IDs and PROTO IDs.
12.lookup|12|A PROTO is looked for in the innermost scope first, then outside.
12.unknown-proto|12|An instance names a PROTO that is known.
12.quantization|12|Fields of an interface may have a category and bounds, with which instances are quantized.
12.animation|12|Fields of an interface may have an animation category.
12.context|12|A PROTO can stand wherever its first node can.
13.fields|13|A Script declares fields as a list or with their count.
13.values|13|A plain field of a Script may have a value.
13.functions|13|The functions of a Script are token trees.
13.statements|13|Statements are if, for, while, return, compound, break, continue and switch.
13.expressions|13|Expressions have 51 types.
13.numbers|13|Numbers are integers of given width or characters of 4 bits.
13.identifiers|13|An identifier that was received is an index into those known.
13.routes|13|Fields that a Script declares come behind its own three in every mode.
13.proto|13|A field that a Script declares in a PROTO may be connected to the interface.
17.depth|-|Nesting that would overflow a decoder's stack is refused.
"""

MP4 = """
1.box|15.1|A box has a size of 32 bits, a type, and so many bytes with this header.
1.large-size|15.1|A size of 1 is followed by one of 64 bits.
1.to-end|15.1|A size of 0 means to the end of the file.
1.box-lies|15.1|A box that ends behind what holds it is an error.
1.unknown-box|15.1|Unknown boxes are passed over.
1.order|15.1|The movie may stand before or behind the data.
1.moov|15.1|A file has one movie.
1.scene|15.1|The scene is a track of handler sdsm with stream type 3 and a BIFS object type.
1.od|15.1|Object descriptors are a track of handler odsm with stream type 1.
1.media|15.1|Images are tracks of handler vide, a whole file in each sample.
1.afx|15.1|AFX streams are tracks of handler sdsm with object type 5; their configuration begins with the object code.
1.sample|15.1|A sample is an access unit.
1.times|15.1|Times are in the media timescale, sums of the durations of stts.
1.ctts|15.1|Composition offsets move the presentation of samples, not their decoding times.
1.stss|15.1|stss lists the random access points; without it all samples are.
1.chunks|15.1|Samples lie one behind the other in chunks, whose sizes stsc says in runs.
1.stco|15.1|Chunks begin at the offsets of stco.
1.co64|15.1|Offsets may have 64 bits, in co64.
1.stsz|15.1|Sample sizes are one for all or one each.
1.stz2|15.1|Sample sizes may have 4, 8 or 16 bits, in stz2.
1.edits|15.1|An edit list moves the media in the presentation.
1.references|15.1|mpod, dpnd, sync and ipir name tracks by their IDs.
1.data-reference|15.1|Samples lie in this file when their data reference says so.
1.fragments|15.1|Samples may follow in movie fragments.
1.es-id|15.1|The ES_ID inside esds is 0; that of a track is the low 16 bits of its ID.
1.version-1|15.1|Version 1 of a header has times of 64 bits.
1.tables-agree|15.1|The tables of a track agree with one another.
1.samples-inside|15.1|Samples lie inside the file.
1.track-ids|15.1|Track IDs are unique and not 0.
1.timescale|15.1|A timescale is not 0.
1.metadata|15.1|User data and free space may stand anywhere.
2.length|15.2|The length of a descriptor has 7 bits in each byte; the top bit says that more follow.
2.length-long|15.2|A length may be written in more bytes than it needs.
2.length-endless|15.2|A length of more than four bytes is an error.
2.es|15.2|An ES_Descriptor has ID, flags, what they announce, a configuration and an SL configuration.
2.es-options|15.2|An ES_Descriptor may depend on another, have a URL and a clock reference.
2.config|15.2|A decoder configuration has object type, stream type, buffer size, rates and specific info.
2.no-info|15.2|Specific info may be absent or empty.
2.unknown|15.2|Descriptors of unknown tags are passed over.
2.ends-inside|15.2|A descriptor that ends behind what holds it is an error.
2.tags|15.2|Each descriptor has its tag.
3.iods|15.3|The initial object descriptor has an ID, flags, profiles and the tracks of scene and object descriptors.
3.iods-url|15.3|An initial object descriptor with a URL has no profiles.
3.iods-absent|15.3|Without an initial object descriptor the scene track is found by its stream type.
4.update|15.4|ObjectDescriptorUpdate gives object descriptors.
4.remove|15.4|ObjectDescriptorRemove gives IDs of 10 bits, padded to a byte.
4.es-update|15.4|ES_DescriptorUpdate gives elementary streams of one object.
4.es-remove|15.4|ES_DescriptorRemove names streams of one object, in files by references.
4.reference|15.4|ES_ID_Ref counts the tracks of mpod from 1.
4.url|15.4|An object descriptor with a URL has no streams.
5.object-type|15.5|BIFS has the object types 1 and 2.
"""

TEXT = """
1.header|17|A text may begin with the line of VRML.
1.comment|17|A comment runs from # to the end of the line.
1.separators|17|Blanks, commas and line ends separate.
2.node|17|A node is its type, an opening brace, fields in any order and a closing brace.
2.unknown-node|17|A type must be one of the tables or a PROTO before it.
2.unknown-field|17|A field must be one of the node.
2.event-value|17|An event has no value.
2.def-use|17|USE means the node that the last DEF of that name made.
2.use-unknown|17|A name that is used was defined before.
2.null|17|NULL is no node.
2.data-type|17|A node stands only where its data type is allowed.
2.braces|17|Braces and brackets are closed.
2.depth|17|Nesting that would overflow a reader's stack is refused.
3.number|17|A number is decimal, with an optional exponent; integers may be hexadecimal.
3.number-range|17|A number fits its type.
3.bool|17|A truth value is TRUE or FALSE.
3.string|17|A string stands between quotes; a backslash takes the next quote or backslash as it is.
3.string-end|17|A string is closed before the text ends.
3.count|17|A value has as many numbers as its type needs.
3.multiple|17|A multiple value stands in brackets, or is one value without.
3.image|17|An image is width, height, components and a number for each pixel.
3.image-size|17|An image has all its pixels.
3.buffer|17|The buffer of a BitWrapper is a data URL, hexadecimal or a file.
3.url|17|A URL is a string, or the ID of an object descriptor.
4.route|17|A ROUTE connects an output to an input of the same type.
4.route-unknown|17|The nodes and fields of a ROUTE are known.
5.proto|17|A PROTO has an interface and a body; EXTERNPROTO has URLs.
5.is|17|IS connects a field to one of the interface of the same type.
5.proto-damaged|17|A damaged PROTO is an error.
6.commands|17|Commands stand in blocks of a time.
6.at|17|AT says the time of a block, RAP AT one that decoding can begin with, AT D one behind the last.
6.command-unknown|17|A command names nodes and fields that are known.
6.descriptors|17|Object descriptors stand before the scene and in UPDATE commands.
7.xml|17|XMT-A says the same in XML.
7.xml-damaged|17|XML that is not well-formed is an error.
7.xml-unknown|17|An element or attribute must be one that is known there.
7.entities|17|Entities of XML stand for their characters.
"""


# Of cases. What rests on bifs.md 10 has one of its own: that is a summary, and no other program has confirmed it.
ORIGINS = {**AFX, "predictive": {
    "text": "Made for this project by conformance/make/predictive_writer.py, from a summary of the standard and the "
            "choices of bifs/predictive_model.h: verified against no other program.", "licence": "BSD-2-Clause"}}


def origin_of(covers):
    return "predictive" if any(rule.startswith("bifs.10.") for rule in covers) else "afx"


def rules_of(area, text):
    rules = []
    for line in text.strip().splitlines():
        id, section, sentence = line.split("|")
        rules.append({"id": f"{area}.{id}", "section": section, "text": sentence})
    return rules


def element_rules():
    def rule(kind, name, section, text):
        return {"id": f"bifs.{kind}/{name}", "section": section, "text": text}
    for name, node in facts.NODES.items():
        yield rule("node", name, "6", f"{name} is coded with all its {len(node.mode('def'))} DEF fields.")
    for name in COMMANDS:
        yield rule("command", name, "3" if name in COMMANDS[:11] else "5",
            f"The command {name} is coded as its table says.")
    for name in FIELD_TYPES:
        yield rule("field-type", name, "8", f"Values of the type {name}.")
    for category in CATEGORIES:
        yield rule("quantization", category, "9", f"Quantization of category {category}.")
    for name in facts.CODED_DATA_TYPES:
        yield rule("data-type", name, "6.2", f"The code tables of {name}.")
    for version in facts.VERSIONS:
        yield rule("version", version, "6.2", f"Nodes of version {version}.")


COMMANDS = ("NodeInsertion", "IndexedValueInsertion", "ROUTEInsertion", "NodeDeletion", "IndexedValueDeletion",
            "ROUTEDeletion", "NodeReplacement", "FieldReplacement", "IndexedValueReplacement", "ROUTEReplacement",
            "SceneReplacement", "PROTOListInsertion", "PROTODeletion", "AllPROTODeletion",
            "MultipleIndexedReplacement", "MultipleFieldReplacement", "GlobalQuantizer", "NodeDeletionEx", "XReplace")
FIELD_TYPES = ("SFBool", "SFInt32", "SFFloat", "SFTime", "SFVec2f", "SFVec3f", "SFVec4f", "SFColor", "SFRotation",
               "SFString", "SFURL", "SFImage", "SFNode", "SFCommandBuffer", "MFBool", "MFInt32", "MFFloat", "MFTime",
               "MFVec2f", "MFVec3f", "MFVec4f", "MFColor", "MFRotation", "MFString", "MFURL", "MFImage", "MFNode",
               "MFScript")
CATEGORIES = (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14)


def elements_of(commands):
    """The elements that commands (of the form `commands`) show, as far as these say."""
    found = set()

    def node(value):
        definition = facts.NODES.get(value["node"])
        if definition:
            found.add(f"bifs.version/{facts.VERSION_OF[value['node']]}")
            for name in value["fields"]:
                field = next((f for f in definition.fields if f.name == name), None)
                if field:
                    found.add(f"bifs.field-type/{field.kind}")
                    if field.data_type:
                        found.add(f"bifs.data-type/{field.data_type}")

    def walk(value):
        if isinstance(value, dict):
            if "cmd" in value:
                found.add(f"bifs.command/{value['cmd']}")
            if "node" in value and "fields" in value:
                node(value)
            for inner in value.values():
                walk(inner)
        elif isinstance(value, list):
            for inner in value:
                walk(inner)
    walk(commands["accessUnits"])
    return found


def main():
    folder = os.path.join(SUITES, "rules")
    os.makedirs(folder, exist_ok=True)
    bifs = rules_of("bifs", BIFS) + list(element_rules())
    for area, source, rules in (("bifs", "spec/bifs.md 1 to 14 and facts/mpeg4-nodes.json", bifs),
                                ("mp4", "spec/bifs.md 15", rules_of("mp4", MP4)),
                                ("scene-text", "spec/bifs.md 17, and VRML97 that it builds on",
                                    rules_of("scene-text", TEXT))):
        text = json.dumps({"$schema": "../rules.schema.json", "area": area, "source": source, "rules": []})[:-3]
        text += "[\n" + ",\n".join(json.dumps(rule) for rule in rules) + "\n]}\n"
        with open(os.path.join(folder, area + ".json"), "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main()
