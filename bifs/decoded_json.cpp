// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/decoded_json.h"

#include <charconv>
#include <cmath>
#include <span>
#include <utility>

#include "bifs/node_walk.h"
#include "bifs/script_syntax.h"
#include "nodes/definitions.h"

namespace afx::bifs {

namespace {

using nodes::FieldDefinition;
using nodes::FieldIndex;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::NodeDefinition;
using nodes::NodeId;
using nodes::Scene;

std::string quoted(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out.append({'\\', c});
    } else if (c == '\n') {
      out += "\\n";
    } else if (byte < 0x20) {
      out.append("\\u00").append({kHex[byte >> 4], kHex[byte & 15]});
    } else {
      out.push_back(c);
    }
  }
  return out + "\"";
}

std::string hex(const auto& bytes) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out = "\"";
  for (const auto b : bytes) {
    const auto byte = static_cast<unsigned char>(b);
    out.append({kHex[byte >> 4], kHex[byte & 15]});
  }
  return out + "\"";
}

template <class T>
std::string number(T value) {
  if constexpr (std::is_floating_point_v<T>) {
    if (std::isnan(value)) return "\"nan\"";
    if (std::isinf(value)) return value < 0 ? "\"-inf\"" : "\"inf\"";
  }
  char text[64];
  const auto [end, failure] = std::to_chars(text, text + sizeof text, value);
  return failure == std::errc{} ? std::string(text, end) : "null";
}

std::string truth(bool value) { return value ? "true" : "false"; }

/// `{"a": 1, "b": 2}`, member by member.
class Object {
 public:
  Object& add(std::string_view name, const std::string& json) {
    text_.append(text_.size() > 1 ? ", " : "").append(quoted(name)).append(": ").append(json);
    return *this;
  }
  [[nodiscard]] std::string done() const { return text_ + "}"; }

 private:
  std::string text_ = "{";
};

template <class List, class Write>
std::string array(const List& list, Write write) {
  std::string out = "[";
  for (const auto& element : list) {
    if (out.size() > 1) out += ", ";
    out += write(element);
  }
  return out + "]";
}

std::string floats(const float* values, size_t count) {
  return array(std::span(values, count), [](float v) { return number(v); });
}

/// "SFColor", "MF3DNode"; in interfaces nodes are "SFNode".
std::string type_text(const FieldDefinition& field) {
  const std::string type(to_string(field.type));
  if (!is_node(field.type) || field.data_type == nodes::kWorldNode) return type;
  return type.substr(0, 2) +
         std::string(nodes::definitions().data_type_name(field.data_type).substr(2));
}

}  // namespace

std::string config_json(const BifsConfig& config) {
  const std::string none = "null";
  return Object()
      .add("version", number(int{config.version}))
      .add("use3DMeshCoding", truth(config.use_3d_mesh_coding))
      .add("usePredictiveMFField", truth(config.use_predictive_field))
      .add("nodeIDbits", number(int{config.node_id_bits}))
      .add("routeIDbits", number(int{config.route_id_bits}))
      .add("protoIDbits", number(int{config.proto_id_bits}))
      .add("isCommandStream", truth(true))
      .add("pixelMetric", truth(config.pixel_metric))
      .add("width", config.size ? number(int{config.size->width}) : none)
      .add("height", config.size ? number(int{config.size->height}) : none)
      .done();
}

class CommandJsonWriter::State {
 public:
  std::string write(const Command& command, const Scene& scene) {
    scene_ = &scene;
    // Within a buffer what is fresh around it stays so, for it is written after it.
    NodeSet outer = std::exchange(fresh_, new_nodes(scene, command, known_));
    Object out;
    out.add("cmd", quoted(command_name(command)));
    std::visit([&](const auto& c) { members(out, c); }, command);
    fresh_ = std::move(outer);
    return out.done();
  }

 private:
  const NodeDefinition& definition(NodeId node) const { return *scene_->node(node).definition; }
  std::string id(NodeId node) const { return number(scene_->node(node).id); }

  static std::string position(const Position& p) {
    if (p.kind == Position::Kind::first) return "\"first\"";
    return p.kind == Position::Kind::last ? "\"last\"" : number(p.index);
  }
  std::string field_of(const FieldRef& ref) {
    return "[" + id(ref.node) + ", " + quoted(definition(ref.node).field(ref.field).name) + "]";
  }
  const FieldDefinition& field(const FieldRef& ref) const {
    return definition(ref.node).field(ref.field);
  }
  void target_of(Object& out, const FieldRef& ref) {
    out.add("target", id(ref.node))
        .add("field", quoted(field(ref).name))
        .add("type", quoted(type_text(field(ref))));
  }

  void members(Object& out, const NodeInsertion& c) {
    out.add("target", id(c.target))
        .add("position", position(c.position))
        .add("value", node(c.node));
  }
  void members(Object& out, const IndexedValueInsertion& c) {
    target_of(out, c.target);
    out.add("position", position(c.position)).add("value", value(field(c.target), c.value));
  }
  void members(Object& out, const RouteInsertion& c) { route_members(out, c.route); }
  void members(Object& out, const NodeDeletion& c) { out.add("target", id(c.target)); }
  void members(Object& out, const IndexedValueDeletion& c) {
    target_of(out, c.target);
    out.add("position", position(c.position));
  }
  void members(Object& out, const RouteDeletion& c) { out.add("route", number(c.route_id)); }
  void members(Object& out, const NodeReplacement& c) {
    out.add("target", id(c.target)).add("value", node(c.node));
  }
  void members(Object& out, const FieldReplacement& c) {
    target_of(out, c.target);
    out.add("value", value(field(c.target), c.value));
  }
  void members(Object& out, const IndexedValueReplacement& c) {
    target_of(out, c.target);
    out.add("position", position(c.position)).add("value", value(field(c.target), c.value));
  }
  void members(Object& out, const RouteReplacement& c) {
    out.add("route", number(c.route_id)).add("from", field_of(c.from)).add("to", field_of(c.to));
  }
  void members(Object& out, const SceneReplacement& c) {
    out.add("useNames", truth(c.use_names));
    if (!c.protos.empty()) out.add("protos", protos(c.protos));
    out.add("node", node(c.root));
    if (!c.routes.empty()) out.add("routes", routes(c.routes));
  }
  void members(Object& out, const ProtoInsertion& c) { out.add("protos", protos(c.protos)); }
  void members(Object& out, const ProtoDeletion& c) {
    out.add("protos", array(c.proto_ids, [](uint32_t proto) { return number(proto); }));
  }
  void members(Object&, const AllProtoDeletion&) {}
  void members(Object& out, const MultipleIndexedReplacement& c) {
    target_of(out, c.target);
    out.add("values", array(c.values, [&](const IndexedValue& v) {
              return "[" + number(v.index) + ", " + value(field(c.target), v.value) + "]";
            }));
  }
  void members(Object& out, const MultipleFieldReplacement& c) {
    Object fields;
    for (const nodes::FieldEntry& entry : c.values) {
      const FieldDefinition& f = definition(c.target).field(entry.field);
      fields.add(f.name, value(f, entry.value));
    }
    out.add("target", id(c.target)).add("fields", fields.done());
  }
  void members(Object& out, const GlobalQuantizer& c) { out.add("value", node(c.node)); }
  void members(Object& out, const XReplace& c) {
    target_of(out, c.target);
    if (c.position) out.add("position", position(*c.position));
    if (c.index_from) out.add("indexFrom", field_of(*c.index_from));
    const FieldDefinition* written = &field(c.target);
    if (c.child_field) {
      written = &field(*c.child_field);
      out.add("childField", quoted(written->name)).add("childType", quoted(type_text(*written)));
    }
    if (c.value_from) {
      out.add("from", field_of(*c.value_from));
    } else {
      out.add("value", value(*written, c.value));
    }
  }

  void route_members(Object& out, const nodes::Route& route) {
    if (route.id != 0) out.add("id", number(route.id));
    if (!route.name.empty()) out.add("name", quoted(route.name));
    out.add("from", field_of({route.from, route.from_field}));
    out.add("to", field_of({route.to, route.to_field}));
  }
  std::string routes(const std::vector<nodes::Route>& list) {
    return array(list, [&](const nodes::Route& route) {
      Object out;
      route_members(out, route);
      return out.done();
    });
  }

  std::string protos(const std::vector<nodes::ProtoId>& list) {
    return array(list, [&](nodes::ProtoId proto_id) { return proto(scene_->proto(proto_id)); });
  }
  std::string proto(const nodes::Proto& proto) {
    Object out;
    out.add("id", number(proto.id)).add("name", quoted(proto.interface.name));
    out.add("fields", array(proto.interface.fields(),
                            [&](const FieldDefinition& f) { return interface_field(f); }));
    if (proto.external) {
      out.add("extern", array(proto.urls, [&](const nodes::Url& url) { return one(url); }));
      return out.done();
    }
    const nodes::Scope& body = scene_->scope(proto.body);
    if (!body.protos.empty()) out.add("protos", protos(body.protos));
    out.add("code", array(body.roots, [&](NodeId root) { return node(root); }));
    if (!body.routes.empty()) out.add("routes", routes(body.routes));
    return out.done();
  }
  std::string interface_field(const FieldDefinition& f) {
    Object out;
    out.add("name", quoted(f.name)).add("event", quoted(to_string(f.kind)));
    out.add("type", quoted(type_text(f)));
    if (f.has_value()) out.add("default", value(f, f.default_value));
    if (f.quant_category != 0) {
      Object quant;
      quant.add("category", number(int{f.quant_category}));
      if (f.quant_bits != 0) quant.add("nbits", number(int{f.quant_bits}));
      if (f.bounds)
        quant.add("bounds", "[" + number(f.bounds->lower) + ", " + number(f.bounds->upper) + "]");
      out.add("quant", quant.done());
    }
    if (f.anim_category != 0) out.add("anim", number(int{f.anim_category}));
    return out.done();
  }

  std::string node(NodeId id_of) {
    if (!id_of.valid()) return "null";
    const nodes::Node& n = scene_->node(id_of);
    if (fresh_.erase(id_of.value) == 0) return Object().add("use", number(n.id)).done();
    Object out;
    out.add("node", quoted(n.definition->name));
    if (n.id != 0) out.add("id", number(n.id));
    if (!n.name.empty()) out.add("name", quoted(n.name));
    return out.add("fields", fields(id_of)).done();
  }
  std::string fields(NodeId id_of) {
    const nodes::Node& n = scene_->node(id_of);
    Object out;
    for (const nodes::FieldEntry& entry : n.values) {
      const FieldDefinition& f = n.definition->field(entry.field);
      if (!is_own_field(n, entry.field)) out.add(f.name, value(f, entry.value, id_of));
    }
    for (const nodes::IsLink& link : n.links) {
      if (is_own_field(n, link.field)) continue;
      const NodeDefinition& interface = scene_->proto(scene_->scope(n.scope).proto).interface;
      out.add(n.definition->field(link.field).name,
              Object().add("is", quoted(interface.field(link.interface_field).name)).done());
    }
    return out.done();
  }
  /// Fields that a Script declares are written with its text.
  static bool is_own_field(const nodes::Node& n, FieldIndex index) {
    if (n.own_definition == nullptr) return false;
    const NodeDefinition* standard = nodes::definitions().find(n.definition->name);
    return standard != nullptr && index.value >= standard->fields().size();
  }

  std::string value(const FieldDefinition& f, const FieldValue& v, NodeId holder = {}) {
    if (f.bytes) return Object().add("hex", hex(*std::get_if<std::string>(&v))).done();
    if (f.type == FieldType::mf_script) {
      NodeId declares = holder;  // the first text carries the declared fields
      if (const auto* list = std::get_if<std::vector<std::string>>(&v))
        return array(*list, [&](const std::string& text) {
          return script(std::exchange(declares, NodeId{}), text);
        });
      return script({}, *std::get_if<std::string>(&v));
    }
    return std::visit([&](const auto& any) { return one(any); }, v);
  }
  std::string script(NodeId holder, std::string_view text) {
    std::string interface = "[]";
    if (holder.valid() && scene_->node(holder).own_definition != nullptr)
      interface = script_interface(holder);
    if (text.starts_with(kScriptPrefix)) text.remove_prefix(kScriptPrefix.size());
    return Object().add("interface", interface).add("javascript", quoted(text)).done();
  }
  std::string script_interface(NodeId holder) {
    const nodes::Node& n = scene_->node(holder);
    std::vector<FieldIndex> own;
    for (size_t i = 0; i < n.definition->fields().size(); ++i)
      if (is_own_field(n, FieldIndex{i})) own.push_back(FieldIndex{i});
    return array(own, [&](FieldIndex index) {
      const FieldDefinition& f = n.definition->field(index);
      Object out;
      out.add("name", quoted(f.name)).add("event", quoted(to_string(f.kind)));
      out.add("type", quoted(type_text(f)));
      if (const FieldValue* given = scene_->given(holder, index))
        out.add("value", value(f, *given));
      return out.done();
    });
  }

  static std::string one(bool v) { return truth(v); }
  static std::string one(uint8_t v) { return truth(v != 0); }  // MFBool
  static std::string one(int32_t v) { return number(v); }
  static std::string one(float v) { return number(v); }
  static std::string one(double v) { return number(v); }
  static std::string one(const std::string& v) { return quoted(v); }
  static std::string one(const nodes::Url& v) {
    return v.is_descriptor() ? Object().add("od", number(v.object_descriptor)).done()
                             : quoted(v.text);
  }
  static std::string one(const glm::vec2& v) { return floats(&v.x, 2); }
  static std::string one(const glm::vec3& v) { return floats(&v.x, 3); }
  static std::string one(const glm::vec4& v) { return floats(&v.x, 4); }
  static std::string one(const nodes::Rotation& v) { return floats(&v.x, 4); }
  static std::string one(const nodes::Image& v) {
    return Object()
        .add("width", number(v.width))
        .add("height", number(v.height))
        .add("numComponents", number(v.components))
        .add("pixels", hex(v.samples))
        .done();
  }
  std::string one(NodeId v) { return node(v); }
  std::string one(const nodes::CommandBuffer& v) {
    const auto* buffer = dynamic_cast<const BufferedCommands*>(v.content.get());
    if (buffer == nullptr) return Object().add("commands", "[]").done();
    return Object()
        .add("commands",
             array(buffer->commands, [&](const Command& c) { return write(c, *scene_); }))
        .done();
  }
  template <class T>
  std::string one(const std::vector<T>& list) {
    return array(list, [&](const auto& v) { return one(v); });
  }

  const Scene* scene_ = nullptr;
  NodeSet known_;  ///< written, or in the command at work
  NodeSet fresh_;  ///< in the command at work and not written yet
};

CommandJsonWriter::CommandJsonWriter() : state_(std::make_unique<State>()) {}
CommandJsonWriter::CommandJsonWriter(CommandJsonWriter&&) noexcept = default;
CommandJsonWriter& CommandJsonWriter::operator=(CommandJsonWriter&&) noexcept = default;
CommandJsonWriter::~CommandJsonWriter() = default;

std::string CommandJsonWriter::write(const Command& command, const nodes::Scene& scene) {
  return state_->write(command, scene);
}

}  // namespace afx::bifs
