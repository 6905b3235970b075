# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Writes the commands of bifs.md 3, 4 and 5, and whole access units."""
import quantizer as q
from bifs_writer import Scope
from bits import BitWriter, bits_for
from proto_writer import ProtoWriter
from scene_values import Node, Vector

POSITIONS = {"first": 2, "last": 3}


class CommandWriter(ProtoWriter):
    # Parts of commands

    def kind(self, kind, sub=None, extended=None):
        self.out.u(2, kind, "command")
        if sub is not None:
            self.out.u(2, sub, "subCommand")
        if extended is not None:
            self.out.u(8, extended, "extendedCommand")

    def position(self, width, position):
        self.out.u(2, POSITIONS.get(position, 0), "position")
        if position not in POSITIONS:
            self.out.u(width, position, "index")
        return position

    def target(self, name, id, field_name, mode="in"):
        field = self.field_ref(self.node_id(id), mode, field_name)
        return field, {"cmd": name, "target": id, "field": field_name, "type": field.type_text}

    def insert_node(self, id, position, node):
        self.kind(0, 0)
        definition = self.node_id(id)
        found = {"cmd": "NodeInsertion", "target": id, "position": self.position(8, position)}
        return {**found, "value": self.node(node, definition.insert)}

    def insert_value(self, id, name, position, value):
        self.kind(0, 2)
        return self.indexed("IndexedValueInsertion", id, name, position, value)

    def replace_value(self, id, name, position, value):
        self.kind(2, 2)
        return self.indexed("IndexedValueReplacement", id, name, position, value)

    def indexed(self, command, id, name, position, value):
        field, found = self.target(command, id, name)
        found["position"] = self.position(16, position)
        return {**found, "value": self.single(field, value)}

    def delete_value(self, id, name, position):
        self.kind(1, 2)
        _, found = self.target("IndexedValueDeletion", id, name)
        return {**found, "position": self.position(16, position)}

    def delete_node(self, id):
        self.kind(1, 0)
        self.node_id(id)
        return {"cmd": "NodeDeletion", "target": id}

    def replace_node(self, id, node):
        self.kind(2, 0)
        self.node_id(id)
        return {"cmd": "NodeReplacement", "target": id, "value": self.node(node, "SFWorldNode")}

    def replace_field(self, id, name, value):
        self.kind(2, 1)
        field, found = self.target("FieldReplacement", id, name)
        return {**found, "value": self.value(field, value)}

    def insert_route(self, route):
        self.kind(0, 3)
        return {"cmd": "ROUTEInsertion", **self.route(route)}

    def delete_route(self, id):
        self.kind(1, 3)
        self.out.u(self.route_bits, id - 1, "routeID")
        return {"cmd": "ROUTEDeletion", "route": id}

    def replace_route(self, id, route):
        self.kind(2, 3)
        self.out.u(self.route_bits, id - 1, "routeID")
        return {"cmd": "ROUTEReplacement", "route": id, **self.route_ends(route)}

    def scene(self, node, protos=(), routes=(), names=False, vector_routes=False):
        self.kind(3)
        self.out.u(6, 0, "reserved")
        self.out.u(1, int(names), "USENAMES")
        self.names = names
        self.scope = Scope()
        found = {"cmd": "SceneReplacement", "useNames": names}
        listed = self.protos(protos)
        if listed:
            found["protos"] = listed
        self.know_below(node)
        found["node"] = self.node(node, "SFTopNode")
        listed = self.routes(routes, vector_routes)
        if listed:
            found["routes"] = listed
        return found

    # Extended commands

    def insert_protos(self, protos):
        self.kind(0, 1, 0)
        return {"cmd": "PROTOListInsertion", "protos": self.protos(protos)}

    def delete_protos(self, ids):
        self.kind(0, 1, 1)
        vector = isinstance(ids, Vector)
        self.out.u(1, int(not vector), "isList")
        if vector:
            self.out.u(5, bits_for(len(ids)) + ids.more, "countBits")
            self.out.u(bits_for(len(ids)) + ids.more, len(ids), "count")
        for id in ids:
            if not vector:
                self.out.u(1, 1, "morePROTOs")
            self.out.u(self.proto_bits, id, "protoID")
        if not vector:
            self.out.u(1, 0, "morePROTOs")
        return {"cmd": "PROTODeletion", "protos": list(ids)}

    def delete_all_protos(self):
        self.kind(0, 1, 2)
        return {"cmd": "AllPROTODeletion"}

    def replace_values(self, id, name, values, more=0):
        self.kind(0, 1, 3)
        field, found = self.target("MultipleIndexedReplacement", id, name)
        width = max(bits_for(index) for index, _ in values) + more
        self.out.u(5, width, "positionBits")
        self.out.u(5, bits_for(len(values)), "countBits")
        self.out.u(bits_for(len(values)), len(values), "count")
        pairs = []
        for index, value in values:
            self.out.u(width, index, "index")
            pairs.append([index, self.single(field, value)])
        return {**found, "values": pairs}

    def replace_fields(self, id, form="mask", order=None, **fields):
        self.kind(0, 1, 4)
        definition = self.node_id(id)
        node = Node(definition.name, form=form, order=order, **fields)
        return {"cmd": "MultipleFieldReplacement", "target": id, "fields": self.fields(node, definition)}

    def quantize(self, node):
        self.kind(0, 1, 5)
        found = {"cmd": "GlobalQuantizer", "value": self.node(node, "SFWorldNode")}
        self.global_quantizer = self.quantizer = q.Quantizer(node.fields) if node else None
        return found

    def delete_node_ex(self, id):
        self.kind(0, 1, 6)
        self.node_id(id)
        return {"cmd": "NodeDeletionEx", "target": id}

    def xreplace(self, id, name, value=None, source=None, position=None, index_from=None, child=None,
                 child_definition=None):
        self.kind(0, 1, 7)
        field, found = self.target("XReplace", id, name)
        single = position is not None or index_from is not None
        if field.multiple:
            self.out.u(1, int(single), "isIndexed")
        if single:
            self.xreplace_index(found, position, index_from)
            if field.element == "SFNode":
                self.out.u(1, int(child is not None), "hasChildField")
            if child is not None:
                field = self.field_ref(child_definition, "in", child)
                single = False
                found.update(childField=child, childType=field.type_text)
        self.out.u(1, int(source is not None), "valueFromNode")
        if source is not None:
            self.field_ref(self.node_id(source[0]), "def", source[1])
            return {**found, "from": list(source)}
        return {**found, "value": self.single(field, value) if single else self.value(field, value)}

    def xreplace_index(self, found, position, index_from):
        self.out.u(1, int(index_from is not None), "dynamicIndex")
        if index_from is not None:
            self.field_ref(self.node_id(index_from[0]), "def", index_from[1])
            found["indexFrom"] = list(index_from)
        else:
            found["position"] = self.position(16, position)


class SceneStream(CommandWriter):
    """A scene stream: its configuration and access units, each of commands that `unit` is given."""

    def __init__(self, size=None, pixels=True, mesh=False, object_type=None, **settings):
        super().__init__(**settings)
        self.size, self.pixels, self.mesh = size, pixels, mesh
        self.object_type = object_type or self.version
        self.units = []  # (time, BitWriter)
        self.found = []

    def config_bits(self):
        out = BitWriter()
        if self.version != 1:
            out.u(1, int(self.mesh), "use3DMeshCoding")
            out.u(1, int(self.predictive), "usePredictiveMFField")
        out.u(5, self.node_bits, "nodeIDbits")
        out.u(5, self.route_bits, "routeIDbits")
        if self.version != 1:
            out.u(5, self.proto_bits, "protoIDbits")
        out.u(1, 1, "isCommandStream")
        out.u(1, int(self.pixels), "pixelMetric")
        out.u(1, int(self.size is not None), "hasSize")
        for name, number in zip(("pixelWidth", "pixelHeight"), self.size or ()):
            out.u(16, number, name)
        return out

    def unit(self, *commands, time=None, tail=b""):
        self.out = BitWriter()
        self.quantizer = self.global_quantizer
        found = []
        for i, command in enumerate(commands):
            if i:
                self.out.u(1, 1, "moreCommands")
            found.append(command(self))
        self.out.u(1, 0, "moreCommands")
        used = len(self.out)
        self.out.align()
        self.out.data(tail)
        time = 100 * len(self.units) if time is None else time
        self.found.append({"time": time, "commands": found, "bitsUsed": used, "bytes": len(self.out) // 8})
        self.units.append((time, self.out))
        return self

    def commands(self):
        width, height = self.size or (None, None)
        config = {"version": self.version, "use3DMeshCoding": self.mesh, "usePredictiveMFField": self.predictive,
                  "nodeIDbits": self.node_bits, "routeIDbits": self.route_bits, "protoIDbits": self.proto_bits,
                  "isCommandStream": True, "pixelMetric": self.pixels, "width": width, "height": height}
        return {"config": config, "accessUnits": self.found}


def command(name, *arguments, **named):
    """A command to be written later: command("delete_node", 1)."""
    return lambda writer: getattr(writer, name)(*arguments, **named)
