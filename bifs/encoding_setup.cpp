// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/encoding_setup.h"

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <utility>

#include "bifs/command_codes.h"
#include "bifs/config.h"
#include "bifs/id_assignment.h"
#include "bifs/node_codes.h"

namespace afx::bifs {

namespace {

using nodes::ProtoId;
using nodes::ScopeId;

constexpr uint32_t kMostNodePosition = (1U << kNodePositionBits) - 1;
constexpr unsigned kMostIdBits = 31;

/// The commands of the scene, those in command buffers left out.
template <class Visit>
void each_command(Presentation& presentation, Visit visit) {
  for (AccessUnit& unit : presentation.units)
    if (auto* commands = std::get_if<std::vector<Command>>(&unit.commands))
      for (Command& command : *commands) visit(command);
}

uint32_t greatest_node_id(const nodes::Scene& scene) {
  uint32_t greatest = 0;
  for (size_t i = 0; i < scene.node_count(); ++i)
    greatest = std::max(greatest, scene.node(nodes::NodeId{i}).id);
  return greatest;
}

uint32_t greatest_route_id(Presentation& presentation) {
  uint32_t greatest = 0;
  const auto note = [&](const nodes::Route& route) { greatest = std::max(greatest, route.id); };
  for (size_t i = 0; i < presentation.scene.scope_count(); ++i)
    for (const nodes::Route& route : presentation.scene.scope(ScopeId{i}).routes) note(route);
  each_command(presentation, [&](const Command& command) {
    if (const auto* insertion = std::get_if<RouteInsertion>(&command)) note(insertion->route);
    if (const auto* scene = std::get_if<SceneReplacement>(&command))
      for (const nodes::Route& route : scene->routes) note(route);
  });
  return greatest;
}

uint32_t greatest_proto_id(const nodes::Scene& scene) {
  uint32_t greatest = 0;
  for (size_t i = 0; i < scene.proto_count(); ++i)
    greatest = std::max(greatest, scene.proto(ProtoId{i}).id);
  return greatest;
}

/// From 1 in each scope, in as many bits as the ID that was given last takes. (PROTOs in bodies are
/// given theirs before those that follow.)
uint32_t number_protos_by_scope(Presentation& presentation) {
  nodes::Scene& scene = presentation.scene;
  std::map<ScopeId, uint32_t> last;
  std::map<uint32_t, uint32_t> renumbered;  // of the scene itself
  uint32_t last_given = 0;
  for (size_t i = 0; i < scene.proto_count(); ++i) {
    nodes::Proto& proto = scene.proto(ProtoId{i});
    last_given = ++last[proto.scope];
    if (proto.scope == nodes::Scene::kMain) renumbered[proto.id] = last_given;
    proto.id = last_given;
  }
  const uint32_t mask = (uint32_t{1} << bits_for(last_given)) - 1;
  for (size_t i = 0; i < scene.proto_count(); ++i) scene.proto(ProtoId{i}).id &= mask;
  each_command(presentation, [&](Command& command) {
    if (auto* deletion = std::get_if<ProtoDeletion>(&command))
      for (uint32_t& id : deletion->proto_ids) id = renumbered[id] & mask;
  });
  return last_given;
}

/// GPAC keeps the bounds of integers as floats and writes the bits of those (vector 21).
void cut_integer_bounds(nodes::Scene& scene) {
  const auto bits = [](double bound) {
    return static_cast<double>(std::bit_cast<int32_t>(static_cast<float>(bound)));
  };
  for (size_t i = 0; i < scene.proto_count(); ++i) {
    nodes::NodeDefinition& interface = scene.proto(ProtoId{i}).interface;
    nodes::NodeDefinition cut;
    cut.name = interface.name;
    cut.data_types = interface.data_types;
    for (nodes::FieldDefinition field : interface.fields()) {
      if (field.bounds && element_type(field.type) == nodes::FieldType::sf_int32)
        field.bounds = nodes::Bounds{bits(field.bounds->lower), bits(field.bounds->upper)};
      cut.add(std::move(field));
    }
    interface = std::move(cut);
  }
}

/// A node insertion has 8 bits for its position.
void settle_position(Command& command, const nodes::Scene& scene, bool like_gpac,
                     Diagnostics& diagnostics) {
  auto* insertion = std::get_if<NodeInsertion>(&command);
  if (insertion == nullptr || insertion->position.index <= kMostNodePosition) return;
  if (like_gpac) {
    const uint32_t index =
        std::exchange(insertion->position.index, insertion->position.index & kMostNodePosition);
    diagnostics.warn("position_cut", Place::none(),
                     "an insertion at " + std::to_string(index) + " is coded as one at " +
                         std::to_string(insertion->position.index) + ", as GPAC does");
    return;
  }
  const nodes::NodeDefinition& definition = *scene.node(insertion->target).definition;
  const nodes::FieldIndex children = definition.find("children");
  if (!children.valid()) return;
  command = IndexedValueInsertion{
      {insertion->target, children}, insertion->position, nodes::FieldValue(insertion->node)};
}

/// Whether a ROUTE has a name that its ID does not stand for.
bool has_own_name(const nodes::Route& route) {
  return !route.name.empty() && id_of_name('R', route.name) != route.id;
}

/// The name that the decoder makes for a PROTO.
std::string made_name(const nodes::Scene& scene, const nodes::Proto& proto) {
  const ProtoId outer = scene.scope(proto.scope).proto;
  const std::string prefix =
      outer.valid() ? scene.proto(outer).interface.name + "_" : std::string("Proto");
  return prefix + std::to_string(proto.id);
}

bool has_own_names(const nodes::Scene& scene, const nodes::Proto& proto) {
  const nodes::NodeDefinition& interface = proto.interface;
  for (size_t i = 0; i < interface.fields().size(); ++i)
    if (interface.fields()[i].name != "_field" + std::to_string(i)) return true;
  return interface.name != made_name(scene, proto);
}

/// Whether names would be lost if they were not coded: others than decoders make from IDs.
bool has_own_names(Presentation& presentation) {
  const nodes::Scene& scene = presentation.scene;
  for (size_t i = 0; i < scene.node_count(); ++i) {
    const nodes::Node& node = scene.node(nodes::NodeId{i});
    if (!node.name.empty() && id_of_name('N', node.name) != node.id) return true;
  }
  for (size_t i = 0; i < scene.proto_count(); ++i)
    if (has_own_names(scene, scene.proto(ProtoId{i}))) return true;
  bool found = false;
  const auto look = [&](const std::vector<nodes::Route>& routes) {
    found = found || std::any_of(routes.begin(), routes.end(), has_own_name);
  };
  for (size_t i = 0; i < scene.scope_count(); ++i) look(scene.scope(ScopeId{i}).routes);
  each_command(presentation, [&](const Command& command) {
    if (const auto* insertion = std::get_if<RouteInsertion>(&command)) look({insertion->route});
    if (const auto* replaced = std::get_if<SceneReplacement>(&command)) look(replaced->routes);
  });
  return found;
}

EsDescriptor& add_stream(InitialObjectDescriptor& initial, uint8_t stream_type, uint16_t es_id) {
  // In place: g++ 12 warns falsely of a variant that is moved as a temporary.
  EsDescriptor& es = initial.parts.emplace_back().body.emplace<EsDescriptor>();
  es.es_id = es_id;
  DecoderConfig& config = es.parts.emplace_back().body.emplace<DecoderConfig>();
  config.stream_type = stream_type;
  config.object_type = object_type::kObjectDescriptor;
  return es;
}

template <class T>
T& part_of(Descriptors& parts) {
  for (Descriptor& part : parts)
    if (T* found = std::get_if<T>(&part.body)) return *found;
  return parts.emplace_back().body.emplace<T>();
}

/// Calls `visit` for the streams in a list of descriptors, and in the objects there.
template <class Visit>
void each_stream(Descriptors& parts, Visit visit) {
  for (Descriptor& part : parts) {
    if (auto* es = std::get_if<EsDescriptor>(&part.body)) visit(*es);
    if (auto* object = std::get_if<ObjectDescriptor>(&part.body)) each_stream(object->parts, visit);
  }
}
template <class Visit>
void each_stream(Presentation& presentation, Visit visit) {
  each_stream(presentation.initial.parts, visit);
  for (AccessUnit& unit : presentation.units) {
    auto* commands = std::get_if<OdCommands>(&unit.commands);
    if (commands == nullptr) continue;
    for (OdCommand& command : *commands) {
      if (auto* update = std::get_if<OdUpdate>(&command.body)) each_stream(update->objects, visit);
      if (auto* streams = std::get_if<EsUpdate>(&command.body))
        each_stream(streams->streams, visit);
    }
  }
}

/// The least ES_ID that no stream has.
uint16_t free_es_id(Presentation& presentation) {
  std::set<uint16_t> taken;
  each_stream(presentation, [&](const EsDescriptor& es) { taken.insert(es.es_id); });
  uint16_t id = 1;
  while (taken.contains(id)) ++id;
  return id;
}

/// There is a scene stream, one for object descriptors if there are any, and all have an ES_ID.
void complete_streams(Presentation& presentation) {
  InitialObjectDescriptor& initial = presentation.initial;
  initial.in_file = false;
  if (scene_stream(initial) == nullptr)
    add_stream(initial, stream_type::kScene, free_es_id(presentation));
  const bool has_descriptors = std::any_of(
      presentation.units.begin(), presentation.units.end(),
      [](const AccessUnit& unit) { return std::holds_alternative<OdCommands>(unit.commands); });
  if (has_descriptors && object_descriptor_stream(initial) == nullptr)
    add_stream(initial, stream_type::kObjectDescriptor, free_es_id(presentation));
  each_stream(presentation, [&](EsDescriptor& es) {
    if (es.es_id == 0) es.es_id = free_es_id(presentation);
  });
}

Result<BifsConfig> wanted_config(const EsDescriptor& es, Diagnostics& diagnostics) {
  const std::vector<uint8_t> info = decoder_specific_info(es);
  BifsConfig config;
  if (info.empty()) return config;
  const auto* decoder = find_part<DecoderConfig>(es.parts);
  return read_config(info, decoder->object_type, diagnostics);
}

Status put_config(EsDescriptor& es, const BifsConfig& config) {
  const auto bytes = write_config(config);
  if (!bytes.ok()) return bytes.error();
  DecoderConfig& decoder = part_of<DecoderConfig>(es.parts);
  decoder.object_type = config.version;
  part_of<DecoderSpecificInfo>(decoder.parts).bytes = bytes.value();
  return {};
}

uint8_t at_least(uint8_t wanted, uint32_t greatest_id) {
  return std::max(wanted, static_cast<uint8_t>(bits_for(greatest_id)));
}

}  // namespace

Status set_up_encoding(Presentation& presentation, const EncodingChoices& choices,
                       Diagnostics& diagnostics) {
  complete_streams(presentation);
  const bool use_names = choices.names == EncodingChoices::Names::always ||
                         (choices.names == EncodingChoices::Names::automatic &&
                          !choices.like_gpac && has_own_names(presentation));
  each_command(presentation, [&](Command& command) {
    if (auto* scene = std::get_if<SceneReplacement>(&command)) scene->use_names = use_names;
    settle_position(command, presentation.scene, choices.like_gpac, diagnostics);
  });
  const uint32_t greatest_proto = choices.like_gpac ? number_protos_by_scope(presentation)
                                                    : greatest_proto_id(presentation.scene);
  if (choices.like_gpac) cut_integer_bounds(presentation.scene);
  auto* es = const_cast<EsDescriptor*>(scene_stream(presentation.initial));
  Result<BifsConfig> wanted = wanted_config(*es, diagnostics);
  if (!wanted.ok()) return wanted.error();
  BifsConfig& config = wanted.value();
  config.use_predictive_field = config.use_predictive_field || choices.predictive;
  config.node_id_bits =
      std::max<uint8_t>(1, at_least(config.node_id_bits, greatest_node_id(presentation.scene)));
  config.route_id_bits = at_least(config.route_id_bits, greatest_route_id(presentation));
  config.proto_id_bits = at_least(config.proto_id_bits, greatest_proto);
  const bool wants_version_2 = presentation.scene.proto_count() > 0 || config.proto_id_bits > 0 ||
                               config.use_predictive_field || config.use_3d_mesh_coding;
  config.version = wants_version_2 ? kOtiBifsV2 : kOtiBifs;
  if (std::max({config.node_id_bits, config.route_id_bits, config.proto_id_bits}) > kMostIdBits)
    return Error{Errc::limit_exceeded, Place::none(), "IDs of more than 31 bits"};
  return put_config(*es, config);
}

EncodeOptions encode_options(const EncodingChoices& choices) {
  EncodeOptions options;
  options.always_write_images = choices.like_gpac;
  options.predictive = choices.predictive;
  options.short_integers = !choices.like_gpac;
  return options;
}

}  // namespace afx::bifs
