// Labels, repeats, jumps, calls of programs (spec/heidenhain 9, 10.3). Used by control/heidenhain.

#include <cmath>
#include <utility>

#include "base/ascii.h"
#include "config/read_file.h"
#include "control/heidenhain/heidenhain.h"

namespace kadr::heidenhain {
namespace {

/// Removes TNC:\ and the quotation of a path, and turns \ into /.
std::string plain_path(std::string_view written) {
  std::string path;
  for (const char c : written)
    if (c != '"') path += c == '\\' ? '/' : c;
  while (!path.empty() && static_cast<unsigned char>(path.back()) <= ' ') path.pop_back();
  const std::size_t colon = path.find(':');
  if (colon != std::string::npos) path.erase(0, colon + 1);
  while (!path.empty() && path[0] == '/') path.erase(0, 1);
  return path;
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

std::string changed(std::string text, char (*how)(char)) {
  for (char& c : text) c = how(c);
  return text;
}
char to_lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c; }

/// Returns the names under which a file may be: as written, or its last part, from the folder of the calling program, of the main program
/// and from the root, in all cases of its letters. `ending` is added to a name that has none.
std::vector<std::string> names_of(const BlockContext& m, const std::string& path, const std::string& ending) {
  const std::string plain = plain_path(path);
  const std::size_t slash = plain.find_last_of('/');
  const std::string last = slash == std::string::npos ? plain : plain.substr(slash + 1);
  const bool has_ending = last.find('.') != std::string::npos;
  std::vector<std::string> all;
  for (const std::string& folder : {folder_of(m.program().file()), folder_of(m.program().main_file()), std::string()})
    for (const std::string& name : {plain, last})
      for (const std::string& cased : {name, changed(name, to_upper), changed(name, to_lower)}) {
        all.push_back(folder + cased + (has_ending ? "" : ending));
        if (!has_ending) all.push_back(folder + cased + changed(ending, to_lower));
      }
  return all;
}

}  // namespace

/// Returns the text of a table of datums or points (spec/heidenhain 11.2, 12.7).
///   alarms  file_missing
Result<std::string> Heidenhain::read_table(const BlockContext& m, const std::string& path, Span where) const {
  const RunLimits& limits = m.program().limits();
  constexpr std::size_t most_bytes = 4U << 20U;
  if (!limits.files.empty() && !plain_path(path).empty())
    for (const std::string& name : names_of(m, path, ".D"))
      if (auto text = read_file(limits.files + "/" + name, most_bytes, limits.door)) return *std::move(text);
  return fail(alarm(AlarmId::file_missing, where, std::string_view(path)));
}

const ProgramIndex& Heidenhain::index(const BlockContext& m, std::uint16_t reader) {
  if (indices_.size() <= reader) indices_.resize(reader + 1U);
  if (!indices_[reader] || m.program().in_entered()) indices_[reader] = std::make_unique<ProgramIndex>(m.program().file(reader));
  return *indices_[reader];
}

/// CALL LBL n, and CALL LBL n REP k: k more passes of the section (spec/heidenhain 9.1, 9.2).
Status Heidenhain::call_label(Interpreter& m, const KlartextBlock& block) {
  std::string name = block.name;
  if (name.empty()) {
    if (block.target.family == ParameterFamily::qs) {
      name = '"' + memory.texts[block.target.index];
    } else {
      const auto number = parameter(m, block.target.family, block.target.index, block.where);
      if (!number) return fail(number.error());
      name = std::to_string(static_cast<long>(std::lround(*number)));
    }
  }
  if (block.part < 0) return call_subprogram(m, name, block.where);
  const auto* const label = index(m).label(name);
  if (label == nullptr) return fail(alarm(AlarmId::label_missing, block.where, std::string_view(name)));
  if (label->twice) return fail(alarm(AlarmId::label_twice, block.where, std::string_view(name)));
  loops_ = true;
  const auto key = std::pair(m.program().reader(), m.block->position.offset);
  const auto open = memory.repeats.find(key);
  double left = 0;
  if (open != memory.repeats.end()) {
    left = open->second;
  } else {
    const auto times = evaluate(m, block, block.value);
    if (!times) return fail(times.error());
    left = std::round(*times);
    if (!(left >= 0 && left <= 65'534)) return fail(alarm(AlarmId::value_out_of_range, block.where, "REP", left));
  }
  if (left < 1) {
    if (open != memory.repeats.end()) memory.repeats.erase(open);
    return {};
  }
  memory.repeats[key] = left - 1;
  m.flow.jump(label->at);
  return {};
}

Status Heidenhain::call_subprogram(Interpreter& m, const std::string& name, Span where) {
  const auto* const label = index(m).label(name);
  if (label == nullptr) return fail(alarm(AlarmId::label_missing, where, std::string_view(name)));
  if (label->twice) return fail(alarm(AlarmId::label_twice, where, std::string_view(name)));
  loops_ = true;
  CallFrame frame;
  frame.kind = CallFrame::Kind::subprogram;
  frame.left = 1;
  frame.caller = m.origin;
  KADR_TRY(m.flow.call_at(m.program().reader(), label->at, frame, where));
  memory.calls.emplace_back();
  return {};
}

/// FN 9 to FN 12: a jump to a label of the program if the comparison holds.
Status Heidenhain::jump(Interpreter& m, const KlartextBlock& block) {
  const auto first = evaluate(m, block, block.value);
  if (!first) return fail(first.error());
  bool on = false;
  if (!block.second) {
    on = (*first != 0) == (block.part == 1);
  } else {
    const double a = *first;
    const auto second = evaluate(m, block, block.second);
    if (!second) return fail(second.error());
    constexpr double equal = 1e-9;  // spec/heidenhain 10.3, INFERRED
    const bool same = std::fabs(a - *second) <= equal;
    switch (block.number) {
      case 9: on = same; break;
      case 10: on = !same; break;
      case 11: on = a > *second && !same; break;
      default: on = a < *second && !same; break;
    }
  }
  if (!on) return {};
  std::string name = block.name;
  if (name.empty()) name = block.target.family == ParameterFamily::qs ? '"' + memory.texts[block.target.index] : std::string();
  const auto* const label = index(m).label(name);
  if (label == nullptr) return fail(alarm(AlarmId::label_missing, block.where, std::string_view(name)));
  loops_ = true;
  m.flow.jump(label->at);
  return {};
}

/// CALL PGM: the program is looked for as written from the root of the program memory, then in the folders of the calling and of the main
/// program; upper and lower case are the same (spec/heidenhain 9.4).
Status Heidenhain::call_program(Interpreter& m, const std::string& path, Span where) {
  if (plain_path(path).empty()) return fail(alarm(AlarmId::program_name_missing, where, "CALL PGM"));
  std::optional<std::uint16_t> found;
  for (const std::string& name : names_of(m, path, ".H"))
    if (!found) found = m.flow.open_program(name);
  if (!found) return fail(alarm(AlarmId::program_missing, where, std::string_view(path)));
  CallFrame frame;
  frame.kind = CallFrame::Kind::subprogram;
  frame.left = 1;
  frame.caller = m.origin;
  KADR_TRY(m.flow.call_at(*found, {}, frame, where));
  OpenCall call;
  call.of_program = true;
  call.inch = m.modal.inch;
  call.locals = std::exchange(memory.ql, std::vector<double>(local_count));
  memory.calls.push_back(std::move(call));
  memory.begun = false;
  return {};
}

/// LBL 0, or the end of a called program.
Status Heidenhain::leave(Interpreter& m, Span where) {
  const auto left = m.flow.end_subprogram(where);
  if (!left) return fail(left.error());
  OpenCall call = std::move(memory.calls.back());
  memory.calls.pop_back();
  if (!call.of_program) return {};
  memory.ql = std::move(call.locals);
  m.run_modes({call.inch ? Function::inch : Function::millimetre});
  return {};
}

/// END PGM: the way back from a called program, or the end of the run, as M2.
Status Heidenhain::end_of_program(Interpreter& m, Span where) {
  while (!memory.calls.empty()) {
    const bool of_program = memory.calls.back().of_program;
    KADR_TRY(leave(m, where));
    if (of_program) return {};
  }
  const std::int32_t row = m.def.row_of('M', 20);
  if (row < 0) return {};
  const CodeRow& end = m.def.codes[static_cast<std::size_t>(row)];
  return handler_of(end.function)(m, {&end, nullptr, where});
}

/// A called program without END PGM ends with its file.
Result<bool> Heidenhain::finish(Interpreter& m) {
  if (memory.probing) {
    KADR_TRY(continue_probing(m));
    return true;
  }
  const std::uint16_t reader = m.program().reader();
  if (m.program().in_entered()) return false;
  if (m.program().depth() == 0 || m.program().position().offset < m.program().file(reader).reader().size())
    return loops_ && memory.begun && m.runs_unseen() && loop_lines_.run(m);
  while (!memory.calls.empty()) {
    const bool of_program = memory.calls.back().of_program;
    KADR_TRY(leave(m, {}));
    if (of_program) return true;
  }
  return true;
}

Result<bool> Heidenhain::end_of_file(BlockContext&) { return true; }

}  // namespace kadr::heidenhain
