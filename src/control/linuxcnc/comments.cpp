// Executes comments that have an effect: messages, the log, the file of probed points (spec/linuxcnc 2.4; convert_comment of LinuxCNC's
// source).

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "base/ascii.h"
#include "control/emitter.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {
namespace {

constexpr double shown_as_zero = 1e-4;

/// Returns the last comment of the block that is in parentheses; nullopt if the block has none. A comment after `;` never has an effect.
std::optional<std::string_view> last_comment(const Block& block) {
  std::optional<std::string_view> last;
  for (const Span comment : block.comments)
    if (comment.begin > 0 && block.text[comment.begin - 1] == '(') last = block.text_of(comment);
  return last;
}

/// Returns true if the comment starts with `word`, in any letter case and after any blanks. `rest` receives the text after the word.
bool takes(std::string_view text, std::string_view word, std::string_view& rest) {
  const std::size_t from = std::min(text.find_first_not_of(" \t"), text.size());
  text.remove_prefix(from);
  if (text.size() < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (to_upper(text[i]) != word[i]) return false;
  rest = text.substr(word.size());
  return true;
}

/// Replaces each parameter in the text of a comment by its value (convert_param_comment of LinuxCNC's source).
class Filled {
 public:
  Filled(Emitter& m, std::string_view text) : m_(m), text_(text) {}

  Result<std::string> run() {
    while (at_ < text_.size()) {
      if (text_[at_] == '%' && format()) continue;
      if (text_[at_] == '#') {
        const auto status = parameter();
        if (!status) return fail(status.error());
        continue;
      }
      out_ += text_[at_++];
    }
    return out_;
  }

 private:
  /// Reads a format %d, %f or %.2f. The format applies to all parameters that follow in the comment.
  bool format() {
    const std::string_view rest = text_.substr(at_ + 1);
    if (rest.starts_with('d')) {
      decimals_ = 0;
      at_ += 2;
      return true;
    }
    if (rest.starts_with('f')) {
      decimals_ = 4;
      at_ += 2;
      return true;
    }
    if (rest.size() >= 3 && rest[0] == '.' && is_digit(rest[1]) && rest[2] == 'f') {
      decimals_ = rest[1] - '0';
      at_ += 4;
      return true;
    }
    return false;
  }

  /// Under cutter compensation, returns the number of #<_x> for the number of #5420, and so on for the other axes. An expression with #5420
  /// … is an alarm under compensation, but a comment shows the values of #<_x> … (LinuxCNC's source reads the parameter table directly).
  double without_compensation(double number) const {
    constexpr std::string_view letters = "xyzabcuvw";
    constexpr double first = 5420;
    const double axis = number - first;
    if (m_.modal.radius_side == 0 || !(axis >= 0 && axis < static_cast<double>(letters.size()))) return number;
    const std::string name{'_', letters[static_cast<std::size_t>(axis)]};
    return m_.def.grammar.named_variables->number_of(name).value_or(number);
  }

  Status parameter() {
    const std::size_t hash = at_++;
    const auto open = [&] { return linuxcnc_of(m_).fault(AlarmId::rs274_parameter, m_.block->where, "Named parameter not terminated"); };
    if (at_ >= text_.size()) return open();
    std::optional<double> value;
    if (text_[at_] == '<') {
      const std::size_t close = text_.find('>', at_);
      if (close == std::string_view::npos) return open();
      if (const auto number = m_.def.grammar.named_variables->number_of(text_.substr(at_ + 1, close - at_ - 1)))
        if (const auto read = linuxcnc_of(m_).read_variable(m_, *number, {})) value = *read;
      at_ = close + 1;
    } else if (is_digit(text_[at_])) {
      double number = 0;
      for (; at_ < text_.size() && is_digit(text_[at_]); ++at_) number = number * 10 + (text_[at_] - '0');
      if (const auto read = linuxcnc_of(m_).read_variable(m_, without_compensation(number), {})) value = *read;
    } else {
      out_ += text_.substr(hash, 1);
      return {};
    }
    if (!value) out_ += "######";
    else out_ += fmt::format("{:.{}f}", std::fabs(*value) < shown_as_zero ? 0.0 : *value, decimals_);
    return {};
  }

  Emitter& m_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::string out_;
  int decimals_ = 6;
};

/// Replaces the location of an alarm that the file writer has raised by the location of the block.
Status placed_at(const Status& status, Span where) {
  if (status) return {};
  Alarm alarm = status.error();
  alarm.where = where;
  return fail(alarm);
}

std::string_view without_front(std::string_view text) { return text.substr(std::min(text.find_first_not_of(" \t"), text.size())); }

/// Returns the running program's path relative to the program memory.
std::string running_program(const BlockContext& m) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path program = fs::absolute(m.program().file(), error).lexically_normal();
  const fs::path root = fs::absolute(m.program().limits().files + "/", error).lexically_normal().parent_path();
  return program.lexically_relative(root).generic_string();
}

Status open_file(BlockContext& m, ProgramFiles::Which which, std::string_view name, bool appends) {
  Span all;
  return placed_at(linuxcnc_of(m).outputs.open(which, m.program().shown(name, all), appends, running_program(m)), m.block->where);
}

}  // namespace

Status LinuxCnc::comments(Emitter& m) {
  const auto text = last_comment(*m.block);
  if (!text) return {};
  std::string_view rest;
  Span all;
  if (takes(*text, "MSG,", rest)) {
    m.emit(Message{m.program().shown(rest, all)});
    return {};
  }
  if (takes(*text, "LOGOPEN,", rest)) return open_file(m, ProgramFiles::Which::log, rest, false);
  if (takes(*text, "LOGAPPEND,", rest)) return open_file(m, ProgramFiles::Which::log, rest, true);
  if (takes(*text, "LOGCLOSE", rest) && rest.empty()) return outputs.close(ProgramFiles::Which::log);
  if (takes(*text, "PROBEOPEN", rest)) return open_file(m, ProgramFiles::Which::probe, without_front(rest), false);
  if (takes(*text, "PROBECLOSE", rest)) return outputs.close(ProgramFiles::Which::probe);
  const bool logs = takes(*text, "LOG,", rest);
  const bool is_debug = !logs && takes(*text, "DEBUG,", rest);
  if (is_debug && m.variables.raw(5599) <= 0) return {};
  const bool aborts = !logs && !is_debug && takes(*text, "ABORT,", rest);
  if (!logs && !is_debug && !aborts && !takes(*text, "PRINT,", rest)) {
    for (const std::string_view word : {"PYRUN,", "PYRELOAD", "PY,"})
      if (takes(*text, word, rest)) m.warn(warning(AlarmId::comment_not_carried_out, m.block->where, word));
    return {};
  }
  const auto filled = Filled(m, rest).run();
  if (!filled) return fail(filled.error());
  if (logs) return placed_at(outputs.write(ProgramFiles::Which::log, *filled), m.block->where);
  if (aborts) return fault(AlarmId::rs274_abort, m.block->where, m.program().shown(*filled, all));
  m.emit(Message{m.program().shown(*filled, all)});
  return {};
}

}  // namespace kadr::linuxcnc
