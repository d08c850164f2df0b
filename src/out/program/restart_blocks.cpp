// What must be set before a program goes on, as blocks. For session/restart's users; tested by tests/session/restart_test.cpp.

#include "out/program/restart_blocks.h"

#include <algorithm>

#include "out/program/words.h"

namespace kadr {
namespace {

using Kind = InForce::Kind;

/// The first code of the table with that function, and with `arg` where it is given.
const CodeRow* row_of(const ControlDef& def, Function function) {
  const auto found = std::find_if(def.codes.begin(), def.codes.end(), [&](const CodeRow& row) { return row.function == function; });
  return found == def.codes.end() ? nullptr : &*found;
}

class Writer {
 public:
  explicit Writer(const ControlDef& def) : def_(def) {}

  Status tool(const InForce& one) {
    const CodeRow* const change = row_of(def_, Function::tool_call);
    if (one.value == 0) return by_hand(one);
    KADR_TRY(word('T', one.value));
    if (change != nullptr) add(change->code);
    end();
    return {};
  }
  Status code(const InForce& one) {
    const auto row = std::find_if(def_.codes.begin(), def_.codes.end(), [&](const CodeRow& r) { return r.code == one.code; });
    const bool is_motion = row != def_.codes.end() && (row->function == Function::linear || row->function == Function::rapid ||
                                                       row->function == Function::arc_cw || row->function == Function::arc_ccw || row->function == Function::cycle || row->function == Function::drilling);
    if (is_motion || row == def_.codes.end() || row->needs != 0) return {};  // the program's blocks name it, or it wants words
    add(one.code);
    return {};
  }
  Status way(const BlockWay& to) {
    const CodeRow* const row = row_of(def_, to.rapid ? Function::rapid : Function::linear);
    if (row != nullptr) add(row->code);
    for (const auto& [letter, value] : to.to) KADR_TRY(word(letter, value));
    if (!to.rapid) KADR_TRY(word('F', to.feed));
    end();
    return {};
  }
  Status word(char letter, double value) {
    const auto text = Words(def_, letter).word(value);
    if (!text) return fail(text.error());
    add(*text);
    return {};
  }
  void add(const std::string& word) { line_ += (line_.empty() ? "" : " ") + word; }
  void end() {
    if (!line_.empty()) made_.blocks.push_back(std::move(line_));
    line_.clear();
  }
  Status by_hand(const InForce& one) {
    made_.by_hand.push_back(one);
    return {};
  }
  RestartBlocks& made() { return made_; }
  bool knows(char letter) const { return Words(def_, letter).known(); }

 private:
  const ControlDef& def_;
  std::string line_;
  RestartBlocks made_;
};

}  // namespace

Result<RestartBlocks> restart_blocks(const ControlDef& def, const std::vector<InForce>& wanted, const std::vector<BlockWay>& way) {
  Writer writer(def);
  const auto each = [&](std::initializer_list<Kind> kinds, const auto& write) -> Status {
    for (const InForce& one : wanted)
      if (std::find(kinds.begin(), kinds.end(), one.kind) != kinds.end()) KADR_TRY(write(one));
    return {};
  };
  KADR_TRY(each({Kind::tool}, [&](const InForce& one) { return writer.tool(one); }));
  KADR_TRY(each({Kind::code}, [&](const InForce& one) { return writer.code(one); }));
  writer.end();
  KADR_TRY(each({Kind::offset, Kind::length_offset}, [&](const InForce& one) {
    const char letter = one.kind == Kind::offset ? 'D' : 'H';
    return writer.knows(letter) ? writer.word(letter, one.value) : writer.by_hand(one);
  }));
  writer.end();
  KADR_TRY(each({Kind::speed}, [&](const InForce& one) { return one.value > 0 ? writer.word('S', one.value) : Status(); }));
  KADR_TRY(each({Kind::spindle, Kind::coolant}, [&](const InForce& one) {
    writer.add(one.code);
    return Status();
  }));
  writer.end();
  for (const BlockWay& to : way) KADR_TRY(writer.way(to));
  KADR_TRY(each({Kind::feed}, [&](const InForce& one) { return writer.word('F', one.value); }));
  writer.end();
  KADR_TRY(each({Kind::variable}, [&](const InForce& one) {
    if (!one.name.starts_with('#') || !def.grammar.expressions) return writer.by_hand(one);
    writer.add(fmt::format("{}={:.9g}", one.name, one.value));
    writer.end();
    return Status();
  }));
  KADR_TRY(each({Kind::origin, Kind::length, Kind::rotation, Kind::scale, Kind::selected},
                [&](const InForce& one) { return writer.by_hand(one); }));
  return std::move(writer.made());
}

}  // namespace kadr
