#pragma once
// OLines: executes one O line, which is a block of flow control (spec/linuxcnc 6; interp_o_word.cc of LinuxCNC's source). o_line_flow.cpp
// has the subprograms, o_line_loops.cpp the loops and branches.

#include <fmt/format.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "control/interpreter.h"
#include "control/linuxcnc/linuxcnc.h"
#include "control/variable_reader.h"
#include "lang/expression/expression.h"

namespace kadr::linuxcnc {

class OLines {
 public:
  explicit OLines(Interpreter& m) : m_(m), control_(linuxcnc_of(m)), flow_(control_.flow), s_(m.block->statement) {}

  Status run();
  /// Calls a subprogram by its label; used by codes that are not O lines.
  Status call_labelled(const std::string& label);

 private:
  tl::unexpected<Alarm> wrong(std::string text) const { return control_.fault(AlarmId::rs274_flow, s_.where, std::move(text)); }
  std::uint32_t line() const { return m_.block->position.line; }
  /// Returns the label of the subprogram being executed; no_label in the main program.
  Label where() const { return flow_.calls.empty() ? no_label : flow_.calls.back(); }
  const std::string& text() const { return flow_.text_of(label_); }
  /// Returns the full name of the label, "subprogram#label", under which LinuxCNC's source stores a label of a subprogram.
  std::string local_name() const { return (where() == no_label ? std::string() : flow_.text_of(where())) + "#" + text(); }
  std::string_view line_text() const;

  Result<Label> label();

  Result<double> value_of(Expression e) { return evaluate(*m_.block, e, VariableReader{m_}); }

  // ---- positions of O lines

  std::int32_t index_of(const Position& at) const;

  OLine& row(std::int32_t index) { return file_->lines[static_cast<std::size_t>(index)]; }

  Label label_of(const OLine& row) const;

  /// Returns the index of the next O line that has the same label, is in the same subprogram, and has one of the O words `words`; -1 if
  /// there is no such line.
  std::int32_t next_of(std::initializer_list<OWord> words);

  /// Returns the fault that the file ends before the line that is searched (spec/linuxcnc 2.1; read_text and read of LinuxCNC's source).
  ///   sought  true: a call searches its subprogram; false: lines are skipped up to an O line
  ///   of_all  the text names the label without its subprogram
  tl::unexpected<Alarm> end_of_file_seeking(bool sought = false, bool of_all = false) const;

  Status jump_to(const Position& at);

  // ---- labels

  /// Returns the Mark (state of a loop or branch) that belongs to this line's label in the subprogram being executed.
  Mark& place();
  Mark* mark() { return place().used ? &place() : nullptr; }
  void forget_mark() { place() = {}; }

  /// Marks the label as the start of a loop or branch at this line. While the Mark exists, no loop or branch with the same label may start
  /// at another line.
  Result<Mark*> take_mark(OWord word, bool of_branch = false);

  tl::unexpected<Alarm> undefined() const { return wrong(fmt::format("{}: undefined O-word label: '{}'", line(), line_text())); }
  std::string found(const Mark& other) const { return fmt::format("(found '{}' in line {})", name_of(other.word), other.at.line); }

  // ---- subprograms

  /// Handles an O line inside a definition of a subprogram that is skipped. Only the end of the definition has an effect. A definition
  /// inside a definition is a fault.
  Status define();

  /// Starts skipping the definition of a subprogram, and records where the subprogram is defined.
  Status begin_sub();

  Status end_sub();

  struct Place {
    std::uint16_t reader = 0;
    Position start;
    bool fanuc = false;
  };

  /// Finds the subprogram of a call (spec/linuxcnc 6.2). The search has this order: a definition that the run has passed, a file with the
  /// name of the label, a later definition in this file.
  Result<Place> find_sub();

  /// Records the definition of a subprogram, and returns the location of its first block.
  Place found_at(std::uint16_t reader, const OLine& line);

  Result<Place> place_of(std::uint16_t reader, Position at);

  Status call();
  Status enter(Level made);

  // ---- loops
  Status begin_do();
  Status while_loop();
  Status repeat();
  /// Jumps to the line after the end of the loop or branch. `ends`: the O words by which it may end.
  Status after_end(std::initializer_list<OWord> ends);
  Position position_after(const Mark& of);
  Status end_loop(OWord of);
  Status leave_loop(bool again);
  void warn_once(bool& reported, AlarmId id);

  // ---- branches
  Status branch();
  Status on_to_other();
  Status other_branch();
  Status end_branch();

  Interpreter& m_;
  LinuxCnc& control_;
  FlowTable& flow_;
  const Statement& s_;
  OFile* file_ = nullptr;   // O lines of the file being read
  std::int32_t here_ = -1;  // index of the current line among the O lines of the file
  Label label_ = no_label;
};

}  // namespace kadr::linuxcnc
