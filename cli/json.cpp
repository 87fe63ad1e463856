// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/json.hpp"

#include <nlohmann/json.hpp>

namespace crest::cli {
namespace {

using Library = nlohmann::ordered_json;

Library converted(const Json& json);

struct Converter {
  Library operator()(const Json::Items& items) const {
    Library result = Library::array();
    for (const Json& item : items) result.push_back(converted(item));
    return result;
  }
  Library operator()(const Json::Members& members) const {
    Library result = Library::object();
    for (const auto& [name, value] : members) result[name] = converted(value);
    return result;
  }
  Library operator()(const auto& x) const { return x; }
};

Library converted(const Json& json) {
  return std::visit(Converter{}, json.value());
}

}  // namespace

Json::Json(std::initializer_list<Member> members) : value_(Members(members)) {}

Json Json::array() {
  Json result;
  result.value_ = Items();
  return result;
}

Json Json::object() {
  Json result;
  result.value_ = Members();
  return result;
}

Json& Json::operator[](const std::string& name) {
  if (std::holds_alternative<std::nullptr_t>(value_)) value_ = Members();
  Members& members = std::get<Members>(value_);
  for (Member& member : members)
    if (member.first == name) return member.second;
  return members.emplace_back(name, Json()).second;
}

void Json::push_back(Json item) {
  std::get<Items>(value_).push_back(std::move(item));
}

std::string Json::text() const {
  return converted(*this).dump(2, ' ', false, Library::error_handler_t::replace) + "\n";
}

}  // namespace crest::cli
