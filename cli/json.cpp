// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace crest::cli {
namespace {

using Library = nlohmann::ordered_json;

Library converted(const Json& json, const std::string& name);

struct Converter {
  const std::string& name;  ///< where the value stands

  Library operator()(double x) const {
    if (!std::isfinite(x)) throw std::runtime_error("the report's " + name + " is not finite");
    return x;
  }
  Library operator()(const Json::Items& items) const {
    Library result = Library::array();
    for (const Json& item : items) result.push_back(converted(item, name));
    return result;
  }
  Library operator()(const Json::Members& members) const {
    Library result = Library::object();
    for (const auto& [key, value] : members)
      result[key] = converted(value, name.empty() ? key : name + "." + key);
    return result;
  }
  Library operator()(const auto& x) const { return x; }
};

Library converted(const Json& json, const std::string& name) {
  return std::visit(Converter{name}, json.value());
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
  return converted(*this, "").dump(2, ' ', false, Library::error_handler_t::replace) + "\n";
}

}  // namespace crest::cli
