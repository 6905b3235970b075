# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Writes BIFS from bifs.md and the node tables alone. Each function writes something and gives back, in the
form `commands` (suites/bifs-gpac/README.md), what a decoder must find there."""
import struct

import predictive_writer
import quantizer as q
import scripts
from bits import BitWriter, bits_for
from node_facts import DATA_TYPES, NODES, code_path, f32, plain
from scene_values import Listed, Node, Predicted, Use, Vector

FLOAT_COUNT = {**q.FLOATS, "SFRotation": 4, "SFVec4f": 4}
POINTS = ("Coordinate", "Coordinate2D")


class Scope:
    """A name scope: the scene, or the body of a PROTO."""

    def __init__(self, outer=None, interface=None):
        self.outer, self.interface = outer, interface
        self.nodes = {}  # ID -> definition
        self.points = {}  # ID of a Coordinate -> how many
        self.protos = {}  # ID -> (definition, data type of the first node)

    def proto(self, id):
        scope = self
        while id not in scope.protos:
            scope = scope.outer
        return scope.protos[id]


class ValueWriter:
    def __init__(self, node_bits=4, route_bits=0, proto_bits=0, version=1, predictive=False):
        self.node_bits, self.route_bits, self.proto_bits = node_bits, route_bits, proto_bits
        self.version, self.predictive = version, predictive
        self.names = False
        self.out = BitWriter()
        self.scope = Scope()
        self.quantizer = None
        self.global_quantizer = None
        self.used = set()  # elements of the tables, as rules
        self.points = []  # of the nodes around: how many points their coordinates have

    # Single values

    def floats(self, values, name="float"):
        return [self.one_float(value, name) for value in values]

    def one_float(self, value, name="float"):
        value = float("nan") if value == "nan" else float(str(value)) if isinstance(value, str) else value
        if self.quantizer and self.quantizer["useEfficientCoding"]:
            parts, found = q.efficient(f32(value))
            for part, width, bits in parts:
                self.out.u(width, bits, part)
            return plain(found)
        self.out.data(struct.pack(">f", f32(value)), name)
        return plain(value)

    def string(self, text, name="string"):
        data = text if isinstance(text, bytes) else text.encode()
        width = bits_for(len(data)) + getattr(text, "more", 0)
        self.out.u(5, width, name)
        self.out.u(width, len(data), "length")
        self.out.data(data, "characters")
        return str(text) if isinstance(text, str) else {"hex": data.hex()}

    def url(self, url):
        self.out.u(1, int(isinstance(url, dict)), "isOD")
        if isinstance(url, dict):
            self.out.u(10, url["od"], "objectDescriptorID")
            return url
        return self.string(url)

    def image(self, image):
        self.out.u(12, image.width, "width")
        self.out.u(12, image.height, "height")
        self.out.u(2, image.components - 1, "components")
        self.out.data(image.samples, "samples")
        return {"width": image.width, "height": image.height, "numComponents": image.components,
                "pixels": image.samples.hex()}

    def buffer(self, buffer):
        inner, kept, quantizer = self.out, self.out, self.quantizer
        self.out, self.quantizer = BitWriter(), None
        commands = []
        for i, command in enumerate(buffer.commands):
            if i:
                self.out.u(1, 1, "moreCommands")
            commands.append(command(self))
        if commands:
            self.out.u(1, 0, "moreCommands")
            self.out.align()
        inner, self.out, self.quantizer = self.out, kept, quantizer
        size = len(inner) // 8
        self.out.u(5, bits_for(size), "bufferSize")
        self.out.u(bits_for(size), size, "bufferLength")
        self.out.mark("bufferBytes")
        self.out.append(inner)
        return {"commands": commands}

    def points_here(self):
        return self.points[-1] if self.points else None

    def code_of(self, field, value):
        """Of a value that is quantized now."""
        self.used.add(f"bifs.field-type/{field.kind}")
        category = self.quantizer.category(field) if self.quantizer else 0
        if not category:
            return None
        self.used.add(f"bifs.quantization/{category}")
        return self.quantizer.code_of(field, category, value, self.points_here())

    def quantized(self, code):
        if code.negative is not None:
            self.out.u(1, int(code.negative), "direction")
        if code.orientation is not None:
            self.out.u(2, code.orientation, "orientation")
        for number in code.numbers:
            self.out.u(code.width, number, "quantized" if code.orientation is None else "component")
        return code.found

    def single(self, field, value):
        kind = field.element
        if kind == "SFNode":
            self.used.add(f"bifs.field-type/{field.kind}")
            return self.node(value, field.data_type)
        code = self.code_of(field, value)
        if code:
            return self.quantized(code)
        if kind == "SFBool":
            self.out.u(1, int(value), "bool")
            return value
        if kind == "SFInt32":
            self.out.u(32, value & 0xFFFFFFFF, "int")
            return value
        if kind == "SFFloat":
            return self.one_float(value)
        if kind == "SFTime":
            self.out.data(struct.pack(">d", value), "time")
            return value
        if kind in FLOAT_COUNT:
            return self.floats(value)
        return {"SFString": self.string, "SFURL": self.url, "SFImage": self.image,
                "SFCommandBuffer": self.buffer, "SFScript": self.script}[kind](value)

    # Multiple values

    def value(self, field, value):
        return self.multiple(field, value) if field.multiple else self.single(field, value)

    def multiple(self, field, values):
        if self.predictive:
            self.out.u(1, int(isinstance(values, Predicted)), "usePredictive")
        if isinstance(values, Predicted):
            return predictive_writer.write(self, field, values)
        self.out.u(1, 0, "reserved")
        vector = isinstance(values, Vector) or (not isinstance(values, Listed) and len(values) > 6)
        self.out.u(1, int(not vector), "isList")
        outside, outside_list, found = self.quantizer, self.quantizer, []
        local = False
        if vector:
            width = bits_for(len(values)) + getattr(values, "more", 0)
            self.out.u(5, width, "countBits")
            self.out.u(width, len(values), "count")
        for value in values:
            if not vector:
                self.out.u(1, 0, "endFlag")
            found.append(self.single(field, value))
            if field.element == "SFNode":
                if local:
                    self.quantizer, local = outside_list, False
                if isinstance(value, Node) and value.name == "QuantizationParameter":
                    self.quantizer = q.Quantizer(value.fields)
                    local = bool(self.quantizer["isLocal"])
        if not vector:
            self.out.u(1, 1, "endFlag")
        self.quantizer = outside
        return found

    # Nodes

    def node(self, node, data_type):
        self.out.u(1, int(not isinstance(node, Node)), "isReused")
        if node is None:
            self.out.u(self.node_bits, (1 << self.node_bits) - 1, "nodeID")
            return None
        if isinstance(node, Use):
            self.out.u(self.node_bits, node.id - 1, "nodeID")
            return {"use": node.id}
        definition = self.node_code(node.name, data_type)
        if node.name == "Script":
            definition = scripts.definition_of(node)
        found = {"node": definition.name}
        self.out.u(1, int(node.id is not None), "isUpdateable")
        if node.id is not None:
            self.out.u(self.node_bits, node.id - 1, "nodeID")
            found["id"] = node.id
            if self.names:
                self.name(node.label)
                found["name"] = node.label
        self.points.append(None)
        found["fields"] = self.fields(node, definition)
        self.points.pop()
        if node.id is not None:
            self.know(node, definition)
        self.note_points(node)
        return found

    def know(self, node, definition):
        self.scope.nodes[node.id] = definition
        if node.name in POINTS:
            self.scope.points[node.id] = len(node.fields.get("point", ()))

    def note_points(self, node):
        if self.points and node.name in POINTS:
            self.points[-1] = len(node.fields.get("point", ()))

    def node_code(self, name, data_type):
        """`name` is that of a node or the ID of a PROTO."""
        if isinstance(name, int):
            definition, _ = self.scope.proto(name)
            self.out.u(DATA_TYPES[data_type]["1"]["bits"], 0, "v1")
            self.out.u(DATA_TYPES[data_type]["2"]["bits"], 1, "v2")
            self.out.u(self.proto_bits, name, "protoID")
            return definition
        for width, code, version in code_path(data_type, name):
            self.out.u(width, code, f"v{version}")
        self.used |= {f"bifs.data-type/{data_type}", f"bifs.version/{version}"}
        return NODES[name]

    def name(self, text):
        for i, byte in enumerate(text.encode() + b"\0"):
            self.out.u(8, byte, "character" if i else "name")

    def fields(self, node, definition):
        self.out.u(1, int(node.form == "mask"), "isMask")
        return (self.masked if node.form == "mask" else self.listed)(node, definition)

    def masked(self, node, definition):
        found = {}
        for field in definition.mode("def" if self.scope.interface is None else "all"):
            if field.name in scripts.own_names(node):
                continue
            present = field.name in node.fields or field.name in node.links
            self.out.u(1, int(present), "mask")
            if not present:
                continue
            if self.scope.interface is not None:
                self.out.u(1, int(field.name in node.links), "isIS")
            if field.name in node.links:
                found[field.name] = self.link(node, field.name)
            else:
                found[field.name] = self.field_value(node, field, node.fields[field.name])
        return found

    def listed(self, node, definition):
        found = {}
        order = node.order or [(name, node.fields[name]) for name in node.fields]
        if self.scope.interface is not None:
            for name in node.links:
                self.out.u(1, 0, "endFlag")
                self.out.u(1, 1, "isIS")
                self.out.u(definition.width("all"), definition.index("all", name), "fieldRef")
                found[name] = self.link(node, name)
        for name, value in order:
            self.out.u(1, 0, "endFlag")
            if self.scope.interface is not None:
                self.out.u(1, 0, "isIS")
            # Those that a Script declares are coded within it: three fields are left.
            plain_definition = NODES.get(node.name, definition) if isinstance(node.name, str) else definition
            self.out.u(plain_definition.width("def"), plain_definition.index("def", name), "fieldRef")
            found[name] = self.field_value(node, definition.field(name), value)
        self.out.u(1, 1, "endFlag")
        return found

    def link(self, node, name):
        interface = self.scope.interface
        self.out.u(bits_for(len(interface.fields) - 1), interface.index("all", node.links[name]), "interfaceField")
        return {"is": node.links[name]}

    def field_value(self, node, field, value):
        if isinstance(value, Use) and self.points and value.id in self.scope.points:
            self.points[-1] = self.scope.points[value.id]
        return self.value(field, value)

    def script(self, script):
        return scripts.write(self, script)
