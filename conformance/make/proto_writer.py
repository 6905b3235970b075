# SPDX-License-Identifier: BSD-2-Clause
# SPDX-FileCopyrightText: 2026 the afx authors
"""Writes ROUTEs and PROTOs as bifs.md 11 and 12 have them."""
import scripts
from bifs_writer import Scope, ValueWriter
from bits import bits_for
from node_facts import EVENTS, INTERFACE_TYPES, NODES, Definition, Field
from scene_values import nodes_below


class ProtoWriter(ValueWriter):
    def node_id(self, id, name="nodeID"):
        self.out.u(self.node_bits, id - 1, name)
        return self.scope.nodes[id]

    def field_ref(self, definition, mode, name, element="fieldRef"):
        self.out.u(definition.width(mode), definition.index(mode, name), element)
        return definition.field(name)

    def know_below(self, value):
        """What a command buffer may refer to although it is coded later."""
        for node in nodes_below(value):
            if node.id is not None and isinstance(node.name, str):
                self.scope.nodes[node.id] = scripts.definition_of(node) if node.name == "Script" else NODES[node.name]
            elif node.id is not None:
                self.scope.nodes[node.id] = self.scope.proto(node.name)[0]

    # Commands

    def routes(self, routes, vector=False):
        self.out.u(1, int(bool(routes)), "hasROUTEs")
        found = []
        if not routes:
            return found
        self.out.u(1, int(not vector), "isList")
        if vector:
            self.out.u(5, bits_for(len(routes)), "countBits")
            self.out.u(bits_for(len(routes)), len(routes), "count")
        for i, route in enumerate(routes):
            if i and not vector:
                self.out.u(1, 1, "moreROUTEs")
            found.append(self.route(route))
        if not vector:
            self.out.u(1, 0, "moreROUTEs")
        return found

    def route(self, route):
        found = {}
        self.out.u(1, int(route.id is not None), "isDEFed")
        if route.id is not None:
            self.out.u(self.route_bits, route.id - 1, "routeID")
            found["id"] = route.id
            if self.names:
                self.name(route.label)
                found["name"] = route.label
        return {**found, **self.route_ends(route)}

    def route_ends(self, route):
        self.field_ref(self.node_id(route.source, "outNodeID"), "out", route.out, "outField")
        self.field_ref(self.node_id(route.target, "inNodeID"), "in", route.into, "inField")
        return {"from": [route.source, route.out], "to": [route.target, route.into]}

    def protos(self, protos):
        found = []
        for proto in protos:
            self.out.u(1, 1, "morePROTOs")
            found.append(self.proto(proto))
        self.out.u(1, 0, "morePROTOs")
        return found

    def proto(self, proto):
        self.out.u(self.proto_bits, proto.id, "protoID")
        outer = self.scope.interface
        label = proto.label if self.names else f"{outer.name + '_' if outer else 'Proto'}{proto.id}"
        if self.names:
            self.name(label)
        found = {"id": proto.id, "name": label, "fields": []}
        definition = Definition(label, proto.fields)
        for field in proto.fields:
            self.out.u(1, 1, "moreFields")
            found["fields"].append(self.interface_field(field))
        self.out.u(1, 0, "moreFields")
        self.out.u(1, int(proto.extern is not None), "isExtern")
        if proto.extern is not None:
            found["extern"] = self.interface_value(Field("url", "field", "MFURL", default=proto.extern))
        else:
            found.update(self.body(proto, definition))
        self.coding(proto.fields, found["fields"])
        self.scope.protos[proto.id] = (definition, None)
        return found

    def interface_field(self, field):
        self.out.u(2, EVENTS.index(field.event), "eventType")
        self.out.u(6, INTERFACE_TYPES[field.kind], "fieldType")
        if self.names:
            self.name(field.name)
        field.data_type = "SFWorldNode" if field.element == "SFNode" else None
        found = {"name": field.name, "event": field.event, "type": field.type_text}
        if field.event in EVENTS[:2]:
            found["default"] = self.interface_value(field)
        return found

    def interface_value(self, field):
        """Never quantized, never predictive."""
        kept, predictive = self.quantizer, self.predictive
        if kept and not kept["useEfficientCoding"]:
            self.quantizer = None
        self.predictive = False
        found = self.value(Field(field.name, field.event, field.kind, field.data_type), field.default)
        self.quantizer, self.predictive = kept, predictive
        return found

    def body(self, proto, definition):
        self.scope = Scope(self.scope, definition)
        found = {}
        inner = self.protos(proto.protos)
        if inner:
            found["protos"] = inner
        self.know_below(list(proto.code))
        found["code"] = []
        for i, node in enumerate(proto.code):
            if i:
                self.out.u(1, 1, "moreNodes")
            found["code"].append(self.node(node, "SFWorldNode"))
        self.out.u(1, 0, "moreNodes")
        routes = self.routes(proto.routes)
        if routes:
            found["routes"] = routes
        self.scope = self.scope.outer
        return found

    def coding(self, fields, found):
        quantized = any(field.category for field in fields)
        animated = any(field.anim for field in fields)
        self.out.u(1, int(quantized), "hasQuantization")
        self.out.u(1, int(animated), "hasAnimation")
        for field, one in zip(fields, found):
            if quantized and field.event in EVENTS[:2]:
                self.quantization(field, one)
            if animated and field.event in ("eventIn", "exposedField"):
                self.out.u(1, int(field.anim != 0), "isAnimated")
                if field.anim:
                    self.out.u(4, field.anim, "animationCategory")
                    one["anim"] = field.anim

    def quantization(self, field, found):
        self.out.u(4, field.category, "category")
        quant = {"category": field.category}
        if field.category == 13:
            self.out.u(5, field.width, "nbBits")
            quant["nbits"] = field.width
        self.out.u(1, int(field.bounds is not None), "hasBounds")
        if field.bounds is not None:
            kind = field.element if field.element in ("SFInt32", "SFTime") else "SFFloat"
            quant["bounds"] = [self.interface_value(Field("bound", "field", kind, default=b)) for b in field.bounds]
        if field.category:
            found["quant"] = quant
