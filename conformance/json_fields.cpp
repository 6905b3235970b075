// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/json_fields.h"

#include <memory>
#include <utility>

namespace afx::conformance {

using nlohmann::json;

JsonFields::JsonFields(const json& value) : JsonFields(value, "", std::make_shared<Status>()) {}

JsonFields::JsonFields(const json& value, std::string path, std::shared_ptr<Status> status)
    : value_(&value), path_(std::move(path)), status_(std::move(status)) {
  if (status_->ok() && !value_->is_object())
    *status_ = Error{Errc::malformed, Place::none(),
                     (path_.empty() ? "the document" : path_) + " is not an object"};
}

void JsonFields::fail(const std::string& name, const std::string& what) {
  if (!status_->ok()) return;
  *status_ = Error{Errc::malformed, Place::none(), path_ + "/" + name + " " + what};
}

bool JsonFields::has(const std::string& name) const {
  return value_->is_object() && value_->contains(name);
}

const json* JsonFields::find(const std::string& name) {
  asked_.insert(name);
  return has(name) && status_->ok() ? &(*value_)[name] : nullptr;
}

const json* JsonFields::need(const std::string& name) {
  const json* member = find(name);
  if (member == nullptr) fail(name, "is not there");
  return member;
}

std::string JsonFields::text(const std::string& name) {
  const json* member = need(name);
  if (member == nullptr) return {};
  if (!member->is_string()) {
    fail(name, "is not a text");
    return {};
  }
  return member->get<std::string>();
}

std::string JsonFields::text_or(const std::string& name) {
  return has(name) ? text(name) : (asked_.insert(name), "");
}

uint64_t JsonFields::number(const std::string& name, uint64_t most) {
  const json* member = need(name);
  if (member == nullptr) return 0;
  if (!member->is_number_unsigned() || member->get<uint64_t>() > most) {
    fail(name,
         "is " + member->dump() + " (expected an integer from 0 to " + std::to_string(most) + ")");
    return 0;
  }
  return member->get<uint64_t>();
}

bool JsonFields::flag(const std::string& name) {
  const json* member = need(name);
  if (member == nullptr) return false;
  if (!member->is_boolean()) fail(name, "is " + member->dump() + " (expected true or false)");
  return member->is_boolean() && member->get<bool>();
}

double JsonFields::real(const std::string& name) {
  const json* member = need(name);
  if (member == nullptr) return 0;
  if (!member->is_number() || member->get<double>() < 0) {
    fail(name, "is " + member->dump() + " (expected a number that is not negative)");
    return 0;
  }
  return member->get<double>();
}

JsonFields JsonFields::object(const std::string& name) {
  static const json kNothing = json::object();
  const json* member = need(name);
  return {member == nullptr ? kNothing : *member, path_ + "/" + name, status_};
}

std::vector<JsonFields> JsonFields::objects(const std::string& name) {
  std::vector<JsonFields> all;
  const json* member = find(name);
  if (member == nullptr) return all;
  if (!member->is_array()) fail(name, "is not a list");
  for (size_t i = 0; member->is_array() && i < member->size(); ++i)
    all.push_back({(*member)[i], path_ + "/" + name + "/" + std::to_string(i), status_});
  return all;
}

std::vector<std::string> JsonFields::texts(const std::string& name) {
  std::vector<std::string> all;
  const json* member = find(name);
  if (member == nullptr) return all;
  if (!member->is_array()) fail(name, "is not a list");
  for (const json& element : *member) {
    if (element.is_string())
      all.push_back(element.get<std::string>());
    else
      fail(name, "holds " + element.dump() + " (expected texts)");
  }
  return all;
}

std::vector<std::string> JsonFields::names() const {
  std::vector<std::string> all;
  if (value_->is_object())
    for (const auto& [name, member] : value_->items()) all.push_back(name);
  return all;
}

void JsonFields::end() {
  for (const std::string& name : names())
    if (!asked_.contains(name)) fail(name, "is not known here");
}

}  // namespace afx::conformance
