#pragma once
// ModalGroups: the modal groups of the control file by their numbers. Their names are read once, when the control is made.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kadr {
struct ControlDef;
}

namespace kadr::linuxcnc {

inline constexpr std::size_t g_groups = 17, m_groups = 11;  // 0 to 16, 0 to 10 (spec/linuxcnc 3)

class ModalGroups {
 public:
  explicit ModalGroups(const ControlDef& def);

  /// Of an index in ControlDef::groups: "12" is 12, "M7" is 7. A group that a user's own file adds under another name is 0.
  std::size_t number(std::size_t index) const { return numbers_[index]; }
  /// Index in ControlDef::groups of the group of G codes with that number; 0: the control has none, as no row is of group 0 there.
  std::size_t index_of_g(std::size_t number) const { return of_g_[number]; }

 private:
  std::vector<std::uint8_t> numbers_;
  std::array<std::uint8_t, g_groups> of_g_{};
};

}  // namespace kadr::linuxcnc
