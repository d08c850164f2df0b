// Writes blocks that bring a control into a given state (modes, tool, offsets, variables) before a program continues in mid-program. This
// file is used together with session/restart and tested by tests/session/restart_test.cpp.

#include "out/program/restart_blocks.h"

#include <algorithm>
#include <utility>

#include "base/code_literals.h"
#include "base/units.h"
#include "lang/block/block.h"
#include "out/program/words.h"

namespace kadr {
namespace {

using Kind = InForce::Kind;

/// Returns the first code in the table that has this function; nullptr if there is none.
const CodeRow* row_of(const ControlDef& def, Function function) {
  const auto found = std::find_if(def.codes.begin(), def.codes.end(), [&](const CodeRow& row) { return row.function == function; });
  return found == def.codes.end() ? nullptr : &*found;
}

const CodeRow* row_of(const ControlDef& def, const InForce& one) {
  const auto found = std::find_if(def.codes.begin(), def.codes.end(), [&](const CodeRow& row) { return row.code == one.code; });
  return found == def.codes.end() ? nullptr : &*found;
}

/// True for the codes of linear and rapid motion. They are written after the motions to the position, since those motions change them.
bool is_line(const CodeRow& row) { return row.function == Function::linear || row.function == Function::rapid; }

/// True for G90 and G91 (absolute, incremental). They are written in separate blocks after the motions to the position, since those motions
/// are absolute.
bool is_distance(const CodeRow& row) { return row.function == Function::absolute || row.function == Function::incremental; }

/// True if a code cannot be written alone: it acts at once, or it needs words whose values are unknown here (data of a canned cycle, centre
/// of a rotation).
bool wants_words(const CodeRow& row) {
  return row.needs != 0 || row.needs_axis || row.phase == Phase::motion || row.phase == Phase::transform ||
         row.phase == Phase::compensation || row.function == Function::tool_lead;
}

/// Returns the letter of the word that selects this type of offset; '\0' for any other state.
char letter_of(Kind kind) { return kind == Kind::offset ? 'D' : kind == Kind::length_offset ? 'H' : '\0'; }

class RestartWriter {
 public:
  RestartWriter(const ControlDef& def, bool inch, bool has_motion) : def_(def), inch_(inch), has_motion_(has_motion) {}

  void by_hand(const InForce& one) { made_.by_hand.push_back(one); }
  void add(const std::string& word) { line_ += (line_.empty() ? "" : " ") + word; }
  void end() {
    if (!line_.empty()) made_.blocks.push_back(std::move(line_));
    line_.clear();
  }
  void line(const std::string& block) {
    end();
    made_.blocks.push_back(block);
  }
  bool knows(char letter) const { return Words(def_, letter).known(); }
  Status word(char letter, double value) {
    const auto text = Words(def_, letter).word(inch_ && is_length(letter) ? value / mm_per_inch : value);
    if (!text) return fail(text.error());
    add(*text);
    return {};
  }
  Status tool(const InForce& one) {
    const std::int32_t change = def_.row_of('M', 6_m);
    if (one.value == 0 || change < 0) {
      by_hand(one);
      return {};
    }
    KADR_TRY(word('T', one.value));
    add(def_.codes[static_cast<std::size_t>(change)].code);
    end();
    return {};
  }
  /// Writes the code together with the number of the offset that the code uses, e.g. `G43 H5`.
  Status code(const InForce& one, const std::vector<InForce>& in_force) {
    const CodeRow* const row = row_of(def_, one);
    if (row == nullptr || is_line(*row) || is_distance(*row)) return {};
    // A code that is in force at power-on switches its mode off, so it needs no words.
    const bool usual = row->group != 0 && def_.groups[row->group].power_on >= 0 &&
                       &def_.codes[static_cast<std::size_t>(def_.groups[row->group].power_on)] == row;
    if (wants_words(*row) && !usual) {
      by_hand(one);
      return {};
    }
    end();
    add(one.code);
    for (const InForce& offset : in_force) {
      const char letter = letter_of(offset.kind);
      const bool takes = letter != 0 && ((row->takes & letter_bit(letter)) != 0 || (letter == 'H' && row->phase == Phase::length));
      if (!takes || offset.value == 0 || !knows(letter)) continue;
      KADR_TRY(word(letter, offset.value));
      written_letters_ |= letter_bit(letter);
    }
    // Some controls accept a tool length offset only in a block that moves the tool axis. Therefore the code and its words are written in
    // the first such block.
    if (row->phase == Phase::length && has_motion_) with_motion_ = std::exchange(line_, {});
    end();
    return {};
  }
  bool is_unit(const InForce& one) const {
    const CodeRow* const row = one.kind == Kind::code ? row_of(def_, one) : nullptr;
    return row != nullptr && (row->function == Function::inch || row->function == Function::millimetre);
  }
  /// True if a word with this letter has been written in the block of the code that uses the letter.
  bool has_written(char letter) const { return (written_letters_ & letter_bit(letter)) != 0; }
  Status motion(const BlockMove& to) {
    if (to.along_tool && !with_motion_.empty()) add(std::exchange(with_motion_, {}));
    if (const CodeRow* const row = row_of(def_, to.rapid ? Function::rapid : Function::linear)) add(row->code);
    for (const auto& [letter, value] : to.to) KADR_TRY(word(letter, value));
    if (!to.rapid) KADR_TRY(word('F', to.feed));
    end();
    return {};
  }
  RestartBlocks& made() { return made_; }

 private:
  bool is_length(char letter) const { return letter == 'F' || def_.address(letter).unit == WordUnit::length; }

  const ControlDef& def_;
  bool inch_, has_motion_;
  std::string with_motion_;            // words for the first block that moves along the tool axis
  std::uint64_t written_letters_ = 0;  // bit set of the address letters already written
  std::string line_;
  RestartBlocks made_;
};

bool is_set(const std::vector<InForce>& required, const ControlDef& def, Function function) {
  return std::any_of(required.begin(), required.end(), [&](const InForce& one) {
    const CodeRow* const row = one.kind == Kind::code ? row_of(def, one) : nullptr;
    return row != nullptr && row->function == function;
  });
}

/// True if the modal code of some group already states the spindle rotation or the coolant. Then that code is written instead of a separate
/// M code for the spindle or the coolant.
bool is_written_by_group(const InForce& one, const std::vector<InForce>& in_force, const ControlDef& def) {
  return std::any_of(in_force.begin(), in_force.end(), [&](const InForce& other) {
    const CodeRow* const row = other.kind == Kind::code ? row_of(def, other) : nullptr;
    if (row == nullptr || row->letter != 'M') return false;
    const bool both = row->tenth == 13_m || row->tenth == 14_m;  // M13 and M14 each switch on spindle and coolant
    if (one.kind == Kind::spindle) return both || row->phase == Phase::spindle || row->phase == Phase::spindle_stop;
    return other.code == one.code || (both && one.code == "M8");
  });
}

/// True if code `a` is written before code `b`. Coolant codes come before spindle codes, because M13 switches on both.
bool comes_before(const ControlDef& def, const InForce& a, const InForce& b) {
  const auto rank = [&](const InForce& one) {
    const CodeRow* const row = one.kind == Kind::code ? row_of(def, one) : nullptr;
    return row != nullptr && (row->phase == Phase::coolant || row->phase == Phase::coolant_off) ? 0 : 1;
  };
  return rank(a) < rank(b);
}

bool is_in_spindle(const InForce& selected, const std::vector<InForce>& in_force) {
  return std::any_of(in_force.begin(), in_force.end(),
                     [&](const InForce& other) { return other.kind == Kind::tool && other.value == selected.value; });
}

Status write_technology(RestartWriter& writer, const InForce& one, const std::vector<InForce>& in_force) {
  switch (one.kind) {
    case Kind::tool: return writer.tool(one);
    case Kind::code: return writer.code(one, in_force);
    case Kind::offset:
    case Kind::length_offset: {
      const char letter = letter_of(one.kind);
      if (writer.has_written(letter)) return {};
      if (!writer.knows(letter)) {
        writer.by_hand(one);
        return {};
      }
      KADR_TRY(writer.word(letter, one.value));
      writer.end();
      return {};
    }
    case Kind::speed:
      if (one.value > 0) KADR_TRY(writer.word('S', one.value));
      writer.end();
      return {};
    case Kind::spindle:
    case Kind::coolant: writer.line(one.code); return {};
    default: return {};
  }
}

}  // namespace

Result<RestartBlocks> restart_blocks(const ControlDef& def, const std::vector<InForce>& required, const std::vector<InForce>& in_force,
                                     const std::vector<BlockMove>& path) {
  RestartWriter writer(def, is_set(in_force, def, Function::inch), !path.empty());
  for (const InForce& one : required)
    if (writer.is_unit(one)) writer.line(one.code);
  for (const InForce& one : required) {
    if (one.kind != Kind::variable) continue;
    // Variables are set before the motions, since some of them may be work offsets.
    if (one.name.starts_with('#') && def.grammar.expressions) writer.line(fmt::format("{}={:.9g}", one.name, one.value));
    else writer.by_hand(one);
  }
  std::vector<InForce> sorted = required;
  std::stable_sort(sorted.begin(), sorted.end(), [&](const InForce& a, const InForce& b) { return comes_before(def, a, b); });
  for (const Kind kind : {Kind::tool, Kind::speed, Kind::code, Kind::offset, Kind::length_offset, Kind::spindle, Kind::coolant})
    for (const InForce& one : sorted) {
      if (one.kind != kind || writer.is_unit(one)) continue;
      if ((kind == Kind::spindle || kind == Kind::coolant) && is_written_by_group(one, in_force, def)) continue;
      KADR_TRY(write_technology(writer, one, in_force));
    }
  if (!path.empty())
    if (const CodeRow* const absolute = row_of(def, Function::absolute)) writer.line(absolute->code);
  for (const BlockMove& to : path) KADR_TRY(writer.motion(to));
  // the motions to the position may have changed the motion code, G90 or G91 and the feed, so these are written again
  for (const InForce& one : in_force) {
    const CodeRow* const row = one.kind == Kind::code ? row_of(def, one) : nullptr;
    if (row != nullptr && (is_line(*row) || is_distance(*row))) writer.line(one.code);
    if (one.kind == Kind::feed && one.value > 0) {
      KADR_TRY(writer.word('F', one.value));
      writer.end();
    }
  }
  for (const InForce& one : required) {
    // false: the tool length is in force already, since a block contains the word H
    const bool of_tables = one.kind == Kind::origin || (one.kind == Kind::length && !writer.has_written('H'));
    const bool next_tool = one.kind == Kind::selected && !is_in_spindle(one, in_force);
    if (of_tables || next_tool || one.kind == Kind::rotation || one.kind == Kind::scale) writer.by_hand(one);
  }
  return std::move(writer.made());
}

}  // namespace kadr
