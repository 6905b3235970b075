// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "codec/error.h"

namespace afx::conformance {

/// Reads the members of a JSON object by name and type. The first thing that is wrong sticks, with
/// its JSON pointer; what is read after it is empty.
class JsonFields {
 public:
  explicit JsonFields(const nlohmann::json& value);

  [[nodiscard]] bool has(const std::string& name) const;
  std::string text(const std::string& name);                ///< must be there
  std::string text_or(const std::string& name);             ///< "" where it is not there
  uint64_t number(const std::string& name, uint64_t most);  ///< an integer from 0; must be there
  bool flag(const std::string& name);                       ///< true or false; must be there
  double real(const std::string& name);                     ///< not negative; must be there
  /// Of an object; must be there.
  JsonFields object(const std::string& name);
  /// Of each element of a list of objects; nothing where it is not there.
  std::vector<JsonFields> objects(const std::string& name);
  std::vector<std::string> texts(const std::string& name);
  /// The names of the members.
  [[nodiscard]] std::vector<std::string> names() const;

  /// Says that a member is not what it must be: "'as' is octre (expected octree or commands)".
  void fail(const std::string& name, const std::string& what);
  /// Fails if there is a member that nobody asked for.
  void end();

  /// What the objects read from one document share.
  [[nodiscard]] const Status& status() const { return *status_; }

 private:
  JsonFields(const nlohmann::json& value, std::string path, std::shared_ptr<Status> status);
  const nlohmann::json* find(const std::string& name);
  const nlohmann::json* need(const std::string& name);

  const nlohmann::json* value_;
  std::string path_;
  std::set<std::string> asked_;
  std::shared_ptr<Status> status_;
};

}  // namespace afx::conformance
