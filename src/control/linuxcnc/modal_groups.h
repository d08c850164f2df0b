#pragma once
// ModalGroups: maps the modal groups of the control file to their numbers. The names of the groups are read once, when the control is
// created.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kadr {
struct ControlDef;
}

namespace kadr::linuxcnc {

// how many modal groups there are: of G codes 0 to 16, of M codes 0 to 10 (spec/linuxcnc 3)
inline constexpr std::size_t g_groups = 17, m_groups = 11;

class ModalGroups {
 public:
  explicit ModalGroups(const ControlDef& def);

  /// Returns the number of a modal group from its index in ControlDef::groups: 12 for the name "12", 7 for "M7". Other names, which only a
  /// user's own control file can have, have the number 0.
  std::size_t number(std::size_t index) const { return numbers_[index]; }
  /// Returns the index in ControlDef::groups of the group of G codes with this number. If the control lacks the group, returns 0, which is
  /// not the index of any group.
  std::size_t index_of_g(std::size_t number) const { return of_g_[number]; }

 private:
  std::vector<std::uint8_t> numbers_;
  std::array<std::uint8_t, g_groups> of_g_{};
};

}  // namespace kadr::linuxcnc
