#pragma once
// OLines executes one O line (spec/linuxcnc 6; interp_o_word.cc of the source). Subprograms: flow.cpp; loops and branches: loops.cpp.

#include <fmt/format.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "control/interpreter.h"
#include "control/linuxcnc/linuxcnc.h"
#include "control/reading.h"
#include "lang/expression/expression.h"

namespace kadr::linuxcnc {

class OLines {
 public:
  explicit OLines(Interpreter& m) : m_(m), control_(linuxcnc_of(m)), flow_(control_.flow), s_(m.block->statement) {}

  Status run();
  /// Calls a subprogram by its label, without an O line.
  Status call_labelled(const std::string& label);

 private:
  tl::unexpected<Alarm> wrong(std::string text) const { return control_.fault(AlarmId::rs274_flow, s_.where, std::move(text)); }
  std::uint32_t line() const { return m_.block->position.line; }
  /// The label of the subprogram that runs; no_label in the main program.
  Label where() const { return flow_.calls.empty() ? no_label : flow_.calls.back(); }
  const std::string& text() const { return flow_.text_of(label_); }
  /// The name under which the source keeps a label that belongs to a subprogram.
  std::string local_name() const { return (where() == no_label ? std::string() : flow_.text_of(where())) + "#" + text(); }
  std::string_view line_text() const;

  Result<Label> label();

  Result<double> value_of(Expression e) { return evaluate(*m_.block, e, Reading{m_}); }

  // ---- where O lines are

  std::int32_t index_of(const Position& at) const;

  OLine& row(std::int32_t index) { return file_->lines[static_cast<std::size_t>(index)]; }

  Label label_of(const OLine& row) const;

  /// The next line after this one with the same label, in the same subprogram, whose word is one of `words`; -1 if there is none.
  std::int32_t next_of(std::initializer_list<OWord> words);

  /// The fault if the file ends before the line looked for (2.1; read_text and read of the source). `sought`: a call looks for a
  /// subprogram; else lines are skipped on the way to an O line. `of_all`: the text names the label without its subprogram.
  tl::unexpected<Alarm> end_of_file_seeking(bool sought = false, bool of_all = false) const;

  Status jump_to(const Position& at);

  // ---- labels

  /// What the label stands for in the subprogram that runs.
  Mark& place();
  Mark* mark() { return place().used ? &place() : nullptr; }
  void forget_mark() { place() = {}; }

  /// Marks the label as starting something at this line. It may start again here, but nowhere else.
  Result<Mark*> take_mark(OWord word, bool of_branch = false);

  tl::unexpected<Alarm> undefined() const { return wrong(fmt::format("{}: undefined O-word label: '{}'", line(), line_text())); }
  std::string found(const Mark& other) const { return fmt::format("(found '{}' in line {})", name_of(other.word), other.at.line); }

  // ---- subprograms

  /// Executes a line while a definition is skipped: only its end counts, and no other definition may start.
  Status define();

  /// Skips the definition of a subprogram, and records its label.
  Status begin_sub();

  Status end_sub();

  struct Place {
    std::uint16_t reader = 0;
    Position start;
    bool fanuc = false;
  };

  /// Finds the subprogram of a call (6.2): one already passed, then a file of that name, then a definition further on in this file.
  Result<Place> find_sub();

  /// Records the definition, and returns the location of its body.
  Place found_at(std::uint16_t reader, const OLine& line);

  Result<Place> place_of(std::uint16_t reader, Position at);

  Status call();
  Status enter(Level made);

  // ---- loops
  Status begin_do();
  Status while_loop();
  Status repeat();
  /// Jumps to the line after the end of the loop or branch.
  Status behind_end(std::initializer_list<OWord> ends);
  Position behind(const Mark& of);
  Status end_loop(OWord of);
  Status leave_loop(bool again);
  void tell(bool& told, AlarmId id);

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
  std::int32_t here_ = -1;  // index of the line among them
  Label label_ = no_label;
};

}  // namespace kadr::linuxcnc
