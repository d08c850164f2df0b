#include "config/json_text.h"

#include <nlohmann/json.hpp>

namespace kadr {

nlohmann::json json_of(std::string_view text) { return nlohmann::json::parse(text, nullptr, false); }

nlohmann::ordered_json ordered_json_of(std::string_view text) { return nlohmann::ordered_json::parse(text, nullptr, false); }

std::string json_text(const nlohmann::json& value, int indent) {
  return value.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_text(const nlohmann::ordered_json& value, int indent) {
  return value.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace kadr
