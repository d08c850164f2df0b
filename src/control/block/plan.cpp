// Makes the plan of a block: the functions that the block calls, as rows of the control's table in the order of execution. Used by the rest
// of control.

#include "control/block/plan.h"

#include <algorithm>
#include <bit>
#include <string>

namespace kadr {
namespace {

constexpr std::uint8_t sequence_length = static_cast<std::uint8_t>(FunctionOrder::last) + 1;

/// Collects the function calls of one block.
class BlockPlanner {
 public:
  BlockPlanner(const ControlDef& def, const LetterSets& letters, const Block& block, Plan& plan)
      : def_(def), letters_(letters), block_(block), plan_(plan) {}

  Status run(std::int16_t motion_row) {
    plan_.count = 0;
    plan_.taken = plan_.passed_over = 0;
    if (def_.grammar.has_statements() && macro_call()) return {};
    for (std::uint32_t i = 0; i < block_.word_count; ++i) {
      const Word& word = block_.words[i];
      if (word.address == 0) continue;
      const std::uint64_t bit = letter_bit(word.address);
      if ((letters_.codes & bit) != 0) {
        KADR_TRY(code(word, static_cast<std::uint8_t>(i)));
        if (calls_macro_) break;
      } else if ((letters_.acting & bit) != 0) {
        acting(word, static_cast<std::uint8_t>(i));
      }
    }
    if (axes_taker_ != nullptr && motion_word_ != nullptr &&
        (motion_is_cycle_ || !traits_of(axes_taker_function_).is(function_fact::leaves_mode)))
      return fail(
          alarm(AlarmId::not_together, motion_word_->where, block_.text_of(axes_taker_->where), block_.text_of(motion_word_->where)));
    KADR_TRY(motion_in_force(motion_row));
    if (code_count_ != 0 || (block_.letters & ~letters_.acting & ~plan_.taken) != 0) KADR_TRY(words_used());
    plan_.axes_taken = axes_taker_ != nullptr;
    note_kind();
    plan_.moves_only = code_count_ == 0 && (block_.letters & letters_.acting) == 0 && block_.assignments.empty();
    return {};
  }

 private:
  /// In a block with G65, G66 or G66.1 all words, also M words, are arguments of the macro, so nothing else is planned (nct 23.3).
  bool macro_call() {
    if ((block_.letters & letter_bit('G')) == 0) return false;
    for (std::uint32_t i = 0; i < block_.word_count; ++i) {
      const Word& word = block_.words[i];
      const std::int32_t index = word.address == 'G' && word.code >= 0 ? def_.row_of('G', word.code) : -1;
      if (index < 0) continue;
      const CodeRow& row = def_.codes[static_cast<std::size_t>(index)];
      if (row.function != Function::macro_call && row.function != Function::macro_modal) continue;
      add(row.phase, static_cast<std::uint8_t>(i), static_cast<std::int16_t>(index), 0);
      plan_.taken = ~std::uint64_t{0};
      plan_.axes_taken = plan_.moves_only = false;
      note_kind();
      return true;
    }
    return false;
  }

  Status code(const Word& word, std::uint8_t index) {
    const std::int32_t row_index = word.code < 0 ? -1 : def_.row_of(word.address, word.code);
    if (row_index < 0 && word.expression) return fail(alarm(AlarmId::code_unknown, word.where, by_value(word)));
    if (row_index < 0) {
      const bool listed = word.address == 'M' && def_.gives(AlarmId::machine_code_unknown);
      return fail(alarm(listed ? AlarmId::machine_code_unknown : AlarmId::code_unknown, word.where, block_.text_of(word.where)));
    }
    const CodeRow& row = def_.codes[static_cast<std::size_t>(row_index)];
    if (!row.works) return fail(alarm(AlarmId::not_available, word.where, row.code));
    if (row.group != 0) KADR_TRY(one_of_group(row, word));
    const FunctionTraits& traits = traits_of(row.function);
    if (traits.takes_axes()) KADR_TRY(axes_taken(row, word));
    if (row.own_block) own_block_ = &word, own_takes_ = row.takes;
    plan_.taken |= row.takes;
    ++code_count_;
    // nct 23.3: all other words of the block are arguments of the macro.
    if (row.function == Function::macro_call || row.function == Function::macro_modal) {
      calls_macro_ = true;
      plan_.taken = ~std::uint64_t{0};
      plan_.count = 0;
      axes_taker_ = motion_word_ = nullptr;
    }
    if (row.needs_axis && (block_.letters & letters_.axes) == 0) return fail(alarm(AlarmId::no_axis_word, word.where, row.code));
    if (const std::uint64_t missing = row.needs & ~block_.letters; missing != 0)
      return fail(alarm(AlarmId::word_missing, word.where, static_cast<char>('A' + std::countr_zero(missing)), row.code));
    add(row.phase, index, static_cast<std::int16_t>(row_index), 0);
    return {};
  }

  /// Returns the name of a code whose number was computed from an expression: `G77.3` for `G#1`.
  static std::string by_value(const Word& word) {
    std::string text = std::to_string(word.value);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return word.address + text;
  }

  Status one_of_group(const CodeRow& row, const Word& word) {
    const std::uint64_t bit = std::uint64_t{1} << row.group;
    if ((groups_seen_ & bit) != 0) {
      const PlanItem& other = plan_.items[first_of_group_[row.group]];
      const CodeRow& other_row = def_.codes[static_cast<std::size_t>(other.row)];
      const bool allowed = std::count(row.with.begin(), row.with.end(), other_row.tenth) +
                               std::count(other_row.with.begin(), other_row.with.end(), row.tenth) !=
                           0;
      if (!allowed) {
        const Word& first = block_.words[other.word];
        const AlarmId id = def_.machine_axes() && word.address == 'M' ? AlarmId::m_codes_contradict : AlarmId::group_conflict;
        return fail(alarm(id, word.where, block_.text_of(first.where), block_.text_of(word.where)));
      }
    }
    groups_seen_ |= bit;
    first_of_group_[row.group] = static_cast<std::uint8_t>(plan_.count);
    return {};
  }

  /// Records which code uses the axis words of the block, and fails if a second code uses them. A motion code next to G28 or a similar code
  /// does not use the axis words: the motion code only sets the mode.
  Status axes_taken(const CodeRow& row, const Word& word) {
    const bool is_mode = row.modal && (row.phase == Phase::motion || row.phase == Phase::positioning);
    if (is_mode) {
      motion_coded_ = true;
      motion_word_ = &word;
      motion_is_cycle_ = row.function == Function::drilling || row.function == Function::turning_simple;
      return {};
    }
    if (axes_taker_ != nullptr)
      return fail(alarm(AlarmId::not_together, word.where, block_.text_of(axes_taker_->where), block_.text_of(word.where)));
    axes_taker_ = &word;
    axes_taker_function_ = row.function;
    return {};
  }

  void acting(const Word& word, std::uint8_t index) {
    if ((plan_.taken & letter_bit(word.address)) != 0) return;
    const AddressRow& row = def_.address(word.address);
    if (row.function == Function::speed_of_spindle) plan_.taken |= letters_.spindles;
    add(row.phase, index, -1, word.address);
  }

  /// Plans the motion code in force for a block that has axis words but no motion code.
  Status motion_in_force(std::int16_t motion_row) {
    std::uint64_t starts = letters_.axes | letters_.centers;
    if (def_.address('L').function == Function::corrector_word) starts |= letter_bit('L');
    if (def_.behaviour.shifts_by_q()) starts |= letter_bit('R');
    if (def_.grammar.comma_words) starts |= letter_bit(comma_chamfer) | letter_bit(comma_rounding) | letter_bit(comma_angle);
    const std::uint64_t loose = block_.letters & starts & ~plan_.taken;
    if (loose == 0 || motion_coded_ || axes_taker_ != nullptr) {
      ignored_in_cycle(motion_row);
      return {};
    }
    if (motion_row == any_motion) {
      plan_.taken = ~std::uint64_t{0};
      return {};
    }
    if (motion_row < 0) {
      const Word& word = *first_of(loose);
      return fail(alarm(AlarmId::no_motion_mode, word.where, word.address));
    }
    const CodeRow& row = def_.codes[static_cast<std::size_t>(motion_row)];
    const bool by_level = def_.behaviour.shifts_by_q() && (block_.letters & letter_bit('R')) != 0;
    if (row.function == Function::drilling && (loose & letters_.axes) == 0 &&
        !by_level) {  // nct 18: without an axis word the cycle neither drills nor stores a word
      plan_.taken |= row.takes;
      return {};
    }
    if ((loose & row.takes) == 0) return {};  // the motion code in force does not use the word, so words_used() reports the word as unused
    plan_.taken |= row.takes;
    add(row.phase, no_word, motion_row, 0);
    return {};
  }

  /// Recognises blocks that change so little that Interpreter::keep_simple_state can undo them.
  void note_kind() {
    plan_.moves_and_feeds = plan_.calls_only = true;
    for (std::uint32_t i = 0; i < plan_.count; ++i) {
      const PlanItem& item = plan_.items[i];
      const Function f = item.row >= 0 ? def_.codes[static_cast<std::size_t>(item.row)].function : def_.address(item.address).function;
      const FunctionTraits& traits = traits_of(f);
      plan_.moves_and_feeds = plan_.moves_and_feeds && (traits.is(function_fact::plain_motion) || f == Function::feed_word);
      plan_.calls_only = plan_.calls_only && traits.is(function_fact::passes_control);
    }
  }

  /// Marks the words of the canned cycle in force (Q, E, P, …) as used in a block without an axis word. They have no effect in such a block
  /// (nct 18.2), but they are not an error.
  void ignored_in_cycle(std::int16_t motion_row) {
    if (motion_row < 0 || motion_coded_ || axes_taker_ != nullptr) return;
    const CodeRow& row = def_.codes[static_cast<std::size_t>(motion_row)];
    if (row.function == Function::drilling) plan_.taken |= row.takes;
    if (row.function == Function::turning_simple && (block_.letters & letters_.axes) == 0) plan_.taken |= row.takes;  // as above (nct 19.B)
  }

  const Word* first_of(std::uint64_t letters) const {
    for (std::uint32_t i = 0; i < block_.word_count; ++i)
      if (block_.words[i].address != 0 && (letters & letter_bit(block_.words[i].address)) != 0) return &block_.words[i];
    return &block_.words[0];
  }

  Status words_used() {
    const std::uint64_t loose = block_.letters & ~letters_.codes & ~letters_.acting & ~plan_.taken;
    if (def_.behaviour.words_passed_over) {
      plan_.passed_over = loose;
    } else if (loose != 0) {
      const Word& word = *first_of(loose);
      // The letter of an axis that the machine lacks, such as W without an axis Z, is an illegal address (nct 5.1).
      const bool no_axis = def_.address(word.address).function == Function::argument_only;
      return fail(alarm(no_axis ? AlarmId::illegal_address : AlarmId::word_unused, word.where, word.address));
    }
    const std::uint64_t own_words = own_block_ != nullptr ? letters_.codes | own_takes_ : 0;
    if (own_block_ != nullptr && (code_count_ > 1 || (block_.letters & ~own_words) != 0))
      return fail(alarm(AlarmId::own_block, own_block_->where, block_.text_of(own_block_->where)));
    return {};
  }

  void add(Phase phase, std::uint8_t word, std::int16_t row, char address) {
    Function function = Function::count;
    if (row >= 0) function = def_.codes[static_cast<std::size_t>(row)].function;
    else if (address != 0) function = def_.address(address).function;
    const auto rank = static_cast<std::uint8_t>(def_.order[static_cast<std::size_t>(phase)] * sequence_length +
                                                static_cast<std::size_t>(traits_of(function).order));
    std::uint32_t at = plan_.count++;
    for (; at > 0 && plan_.items[at - 1].rank > rank; --at) {
      plan_.items[at] = plan_.items[at - 1];
      for (std::uint8_t& first : first_of_group_)
        if (first == at - 1) first = static_cast<std::uint8_t>(at);
    }
    plan_.items[at] = {rank, word, row, address};
    if (row >= 0) {
      const std::uint8_t group = def_.codes[static_cast<std::size_t>(row)].group;
      if (group != 0) first_of_group_[group] = static_cast<std::uint8_t>(at);
    }
  }

  const ControlDef& def_;
  const LetterSets& letters_;
  const Block& block_;
  Plan& plan_;
  std::uint64_t groups_seen_ = 0;
  // By modal group: index of the group's first item in the plan; valid if groups_seen_ has the group's bit.
  std::array<std::uint8_t, most_groups> first_of_group_{};
  std::uint32_t code_count_ = 0;
  bool motion_coded_ = false;
  bool calls_macro_ = false;
  // Nct: the motion code is a canned cycle, which cannot be combined with another code that uses the axis words.
  bool motion_is_cycle_ = false;
  const Word* motion_word_ = nullptr;
  const Word* axes_taker_ = nullptr;
  Function axes_taker_function_ = Function::count;
  const Word* own_block_ = nullptr;
  std::uint64_t own_takes_ = 0;
};

}  // namespace

LetterSets::LetterSets(const ControlDef& def) {
  axis_of.fill(-1);
  for (std::size_t i = 0; i < max_addresses; ++i) {
    const AddressRow& row = def.addresses[i];
    const std::uint64_t bit = std::uint64_t{1} << i;
    switch (row.function) {
      case Function::count:
      case Function::block_number:
      case Function::label:
      case Function::formal_parameter:
      case Function::word_of_code: break;
      case Function::code: codes |= bit; break;
      case Function::axis:
        axes |= bit;
        axis_of[i] = static_cast<std::int8_t>(row.axis);
        axis_letter[row.axis] = row.letter;
        break;
      case Function::increment_axis:
        axes |= bit;
        axis_of[i] = static_cast<std::int8_t>(row.axis);
        break;
      case Function::machine_axis:
      case Function::argument_only: break;
      case Function::center:
        centers |= bit;
        axis_of[i] = static_cast<std::int8_t>(row.axis);
        center_letter[row.axis] = row.letter;
        break;
      case Function::corrector_word: break;
      case Function::speed_of_spindle:
        for (const AddressName& name : def.grammar.names)
          if (name.text == "$") spindles |= letter_bit(name.address);
        acting |= bit;
        break;
      case Function::spindle_word: spindles |= bit; [[fallthrough]];
      default: acting |= bit;
    }
  }
}

Status plan_block(const ControlDef& def, const LetterSets& letters, const Block& block, std::int16_t motion_row, Plan& plan) {
  return BlockPlanner(def, letters, block, plan).run(motion_row);
}

}  // namespace kadr
