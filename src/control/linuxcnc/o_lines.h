#pragma once
// OLines: one O line carried out (spec/linuxcnc 6; interp_o_word.cc of the source). Subprograms: flow.cpp; loops and branches: loops.cpp.

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
  /// Calls by a label that no O line says.
  Status call_labelled(const std::string& label);

 private:
  tl::unexpected<Alarm> wrong(std::string text) const { return control_.fault(AlarmId::rs274_flow, s_.where, std::move(text)); }
  std::uint32_t line() const { return m_.block->position.line; }
  /// The subprogram that runs.
  Label where() const { return flow_.calls.empty() ? no_label : flow_.calls.back(); }
  const std::string& text() const { return flow_.text_of(label_); }
  /// Of a label that belongs to a subprogram, as the source keeps it.
  std::string local_name() const { return (where() == no_label ? std::string() : flow_.text_of(where())) + "#" + text(); }
  std::string_view line_text() const;

  Result<Label> label();

  Result<double> value_of(Expression e) { return evaluate(*m_.block, e, Reading{m_}); }

  // ---- where lines are

  std::int32_t index_of(const Position& at) const;

  OLine& row(std::int32_t index) { return file_->lines[static_cast<std::size_t>(index)]; }

  Label label_of(const OLine& row) const;

  /// The next line after this one with the same label, of the same subprogram, that is one of `words`; -1: none.
  std::int32_t next_of(std::initializer_list<OWord> words);

  /// What was looked for does not come, and the file is over (2.1; read_text and read of the source). `sought`: a subprogram, by a call;
  /// else lines were passed over on the way to an O line.
  tl::unexpected<Alarm> end_of_file_seeking(bool sought = false, bool of_all = false) const;

  Status jump_to(const Position& at);

  // ---- labels

  /// What the label stands for in the subprogram that runs.
  Mark& place();
  Mark* mark() { return place().used ? &place() : nullptr; }
  void forget_mark() { place() = {}; }

  /// The label begins something here: it may do so again, but nowhere else.
  Result<Mark*> take_mark(OWord word, bool of_branch = false);

  tl::unexpected<Alarm> undefined() const { return wrong(fmt::format("{}: undefined O-word label: '{}'", line(), line_text())); }
  std::string found(const Mark& other) const { return fmt::format("(found '{}' in line {})", name_of(other.word), other.at.line); }

  // ---- subprograms

  /// On the way over a definition only its end counts, and no other may begin.
  Status define();

  /// Passed over; its label is known from now on.
  Status begin_sub();

  Status end_sub();

  struct Place {
    std::uint16_t reader = 0;
    Position start;
    bool fanuc = false;
  };

  /// 6.2: passed already, then a file of that name, then further on in this file.
  Result<Place> find_sub();

  /// It is known from now on.
  Place found_at(std::uint16_t reader, const OLine& line);

  Result<Place> place_of(std::uint16_t reader, Position at);

  Status call();
  Status enter(Level made);

  // ---- loops
  Status begin_do();
  Status while_loop();
  Status repeat();
  /// Behind the line that ends it.
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
  OFile* file_ = nullptr;   // being read
  std::int32_t here_ = -1;  // the line among its O lines
  Label label_ = no_label;  //
};

}  // namespace kadr::linuxcnc
