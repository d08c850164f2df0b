// Maps the names of modal groups in [groups] to numbers. Used by control/linuxcnc; tested by tests/control/modal_groups_test.cpp.

#include "control/linuxcnc/modal_groups.h"

#include <charconv>
#include <string_view>

#include "config/control/control_def.h"

namespace kadr::linuxcnc {

ModalGroups::ModalGroups(const ControlDef& def) : numbers_(def.groups.size()) {
  for (std::size_t i = 1; i < def.groups.size(); ++i) {
    std::string_view name = def.groups[i].name;
    const bool is_m = name.starts_with('M');
    if (is_m) name.remove_prefix(1);
    std::uint8_t number = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (error != std::errc() || end != name.data() + name.size() || number >= (is_m ? m_groups : g_groups)) continue;
    numbers_[i] = number;
    if (!is_m) of_g_[number] = static_cast<std::uint8_t>(i);
  }
}

}  // namespace kadr::linuxcnc
