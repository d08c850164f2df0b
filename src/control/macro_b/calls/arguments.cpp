// Converts the words of a block into the macro arguments #1 … #33 (spec/nct/23 23.3). Argument assignments of types 1 and 2 may be mixed;
// the words are assigned in the order in which they are written.

#include <string_view>

#include "control/block_context.h"
#include "control/macro_b/calls/calls.h"

namespace kadr::macro_b {
namespace {

/// The number of the variable to which each letter A to Z assigns its value, by argument assignment of type 1.
constexpr std::array<std::uint8_t, 26> variable_of_letter = {1,  2,  3,  7,  8,  9,  10, 11, 4,  5,  6,  12, 13,
                                                             14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
constexpr std::size_t type_2_step = 3;

class Assigner {
 public:
  Assigner(Locals& to, bool later_counts) : locals_(to), later_counts_(later_counts) { locals_.fill(vacant); }

  Status take(const Word& w) {
    const char letter = w.written;
    if (letter < 'A' || letter > 'Z' || w.incremental || w.bare) return illegal(w);
    std::size_t number = variable_of_letter[static_cast<std::size_t>(letter - 'A')];
    if (letter >= 'I' && letter <= 'K') {  // type 2: each further I, J or K assigns its value to the next variable of this letter
      std::size_t& written = written_[static_cast<std::size_t>(letter - 'I')];
      if (later_counts_) number += type_2_step * written++;
      else
        while (number <= max_locals && occupied_[number]) number += type_2_step;
      if (number > max_locals) return illegal(w);
    } else if (occupied_[number] && !later_counts_) {
      return illegal(w);
    }
    occupied_[number] = true;
    locals_[number] = w.address == 0 ? vacant : w.value;  // an empty variable in the call gives an empty argument
    return {};
  }

 private:
  static Status illegal(const Word& w) { return fail(alarm(AlarmId::illegal_address, w.where, w.written)); }

  Locals& locals_;
  bool later_counts_;
  std::array<bool, max_locals + 1> occupied_{};
  std::array<std::size_t, 3> written_{};  // number of words I, J and K read so far
};

}  // namespace

Status arguments_of(const BlockContext& m, std::uint32_t caller, Locals& to) {
  // spec/fanuc 9.3: the words G, L, N, O, P are not arguments
  const bool later_counts = m.def.behaviour.later_word_counts != LaterWord::nowhere;
  Assigner assigner(to, later_counts);
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (i == caller && w.written != 'G') continue;  // a G code that calls is an argument too, so that #10 = 65; an M code that calls is not
    if (later_counts && std::string_view("GLNOP").find(w.written) != std::string_view::npos) continue;
    KADR_TRY(assigner.take(w));
  }
  return {};
}

}  // namespace kadr::macro_b
