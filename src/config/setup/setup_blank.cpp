// Reads the keys `stock` and `fixtures` of a set-up. Used by cli/cut and view/page/page_part; tested by tests/config/setup_blank_test.cpp.

#include "config/setup/setup_blank.h"

#include <nlohmann/json.hpp>

#include "config/json_text.h"

namespace kadr {

SetupBlank setup_blank(std::string_view json) {
  SetupBlank blank;
  const auto setup = json_of(json);
  if (!setup.is_object()) return blank;
  if (const auto stock = setup.find("stock"); stock != setup.end() && stock->is_string()) blank.stock = stock->get<std::string>();
  if (const auto list = setup.find("fixtures"); list != setup.end() && list->is_array())
    for (const auto& one : *list)
      if (one.is_string()) blank.fixtures.push_back(one.get<std::string>());
  return blank;
}

}  // namespace kadr
