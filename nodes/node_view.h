// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "nodes/scene.h"

namespace afx::nodes {

/// A PROTO instance that one is inside of.
struct Instance {
  NodeId node;                            ///< the instance
  std::shared_ptr<const Instance> outer;  ///< the one around it
  uint32_t depth = 1;                     ///< how many there are, this one included
};

/// A node as it is seen from where it stands: PROTO instances are looked through (one sees the
/// first node of the body), and fields connected by IS have the values of the instance. Cheap to
/// copy; the scene must outlive it. A view may be of nothing: the NULL node, an EXTERNPROTO
/// instance, an empty PROTO, PROTOs nested deeper than kMaxInstances.
class NodeView {
 public:
  static constexpr uint32_t kMaxInstances = 256;

  NodeView() = default;
  NodeView(const Scene& scene, NodeId node, std::shared_ptr<const Instance> inside = nullptr);

  [[nodiscard]] bool valid() const { return id_.valid(); }
  [[nodiscard]] NodeId id() const { return id_; }
  [[nodiscard]] const Scene& scene() const { return *scene_; }
  [[nodiscard]] const Node& node() const { return scene_->node(id_); }
  /// The type's name, "NULL" for a view of nothing.
  [[nodiscard]] std::string_view type() const;
  /// For messages: the type, and the DEF name if there is one: `DepthImage "FRONT"`.
  [[nodiscard]] std::string label() const;

  /// The number of the node, then of the PROTO instances that it is seen inside of, the inner ones
  /// first. In one scene, views with the same path see the same values. Of nothing: empty.
  [[nodiscard]] std::vector<uint32_t> path() const;

  /// The value of a field; nullptr if there is no such field, or its type is not stored as T.
  template <class T>
  [[nodiscard]] const T* find(std::string_view field) const;
  /// The same for a field that the node certainly has.
  template <class T>
  [[nodiscard]] const T& get(std::string_view field) const;
  /// The node in an SFNode field; a view of nothing for NULL and for a field that is not there.
  [[nodiscard]] NodeView child(std::string_view field) const;
  /// The nodes in an MFNode field, in order; views of nothing stay in their places.
  [[nodiscard]] std::vector<NodeView> children(std::string_view field) const;
  /// How many they are, and one of them alone (a view of nothing where there is none at `index`).
  [[nodiscard]] size_t child_count(std::string_view field) const;
  [[nodiscard]] NodeView child_at(std::string_view field, size_t index) const;

 private:
  struct Resolved {
    const FieldValue* value = nullptr;
    const std::shared_ptr<const Instance>* inside = nullptr;  ///< where the nodes in it stand
  };
  [[nodiscard]] Resolved resolve(FieldIndex field) const;
  /// The value of an MFNode field and where it stands; nullptr if there is no such field.
  struct Nodes {
    const std::vector<NodeId>* ids = nullptr;
    const std::shared_ptr<const Instance>* inside = nullptr;
  };
  [[nodiscard]] Nodes nodes_in(std::string_view field) const;
  [[nodiscard]] bool is_linked(NodeId id, FieldIndex field) const;

  const Scene* scene_ = nullptr;
  NodeId id_;
  std::shared_ptr<const Instance> inside_;
};

template <class T>
const T* NodeView::find(std::string_view field) const {
  if (!valid()) return nullptr;
  const FieldIndex index = node().definition->find(field);
  return index.valid() ? std::get_if<T>(resolve(index).value) : nullptr;
}

template <class T>
const T& NodeView::get(std::string_view field) const {
  static const T kZero{};
  const T* found = find<T>(field);
  assert(found != nullptr);
  return found != nullptr ? *found : kZero;
}

}  // namespace afx::nodes
