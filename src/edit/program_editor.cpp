// ProgramEditor: writes a program with edits. Used by edit/editing; tested by tests/edit.py.

#include "edit/program_editor.h"

#include <algorithm>

#include "config/control/control_def.h"
#include "edit/block_editor.h"
#include "lang/block/block_reader.h"
#include "lang/text/executed_comment.h"
#include "lang/text/written_letters.h"
#include "texts/edit.h"

namespace kadr {
namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

class ProgramWriter {
 public:
  ProgramWriter(const EditedSource& program, const Edits& edits, const StopToken& stop, const std::function<void(std::string_view)>& put)
      : program_(program),
        edits_(edits),
        stop_(stop),
        put_(put),
        grammar_(program.control->grammar),
        raw_(program.source),
        reader_(program.source, grammar_, program.encoding),
        words_(*program.control, edits, program.use) {
    const std::string_view sample = raw_.sample();
    ends_with_cr_ = sample.find('\n') == std::string_view::npos && sample.find('\r') != std::string_view::npos;
  }

  tl::expected<EditedText, EditFault> write() {
    if (edits_.numbering) {
      auto numbers = Renumbering::of(program_.source, program_.encoding, *program_.control, *edits_.numbering, stop_);
      if (!numbers) return tl::unexpected(numbers.error());
      numbers_ = std::move(*numbers);
    }
    while (!stop_.requested()) {
      const auto got = reader_.next(block_);
      const bool is_end = got && *got == BlockReader::Got::end;
      if (auto status = lines_before(is_end ? ~std::uint32_t{0} : block_.position.line); !status) return tl::unexpected(status.error());
      if (is_end) break;
      line_text_ = std::string(block_.text);
      has_block_ = true;
      if (!got) continue;  // the control does not read the block, so nothing is known about its words
      if (auto status = change_block(); !status) return tl::unexpected(status.error());
    }
    made_.not_executed = words_.not_executed();
    return made_;
  }

 private:
  tl::expected<void, EditFault> change_block() {
    if (auto status = words_.change(block_, changes_); !status) return status;
    if (numbers_)
      if (auto status = numbers_->change(block_, changes_); !status) return status;
    if (edits_.no_comments && block_.statement.kind != StatementKind::message)
      for (const Span comment : block_.comments) remove_comment(comment);
    return {};
  }

  /// Removes a comment with its brackets, or with its semicolon, and the blanks before it.
  void remove_comment(Span inside) {
    const std::string_view text = block_.text;
    if (is_executed_comment(block_.text_of(inside)) || inside.begin == 0) return;
    Span where{inside.begin - 1, inside.end};
    if (text[where.begin] == '(' && where.end < text.size() && text[where.end] == ')') ++where.end;
    else if (text[where.begin] == '/' && where.begin > 0) --where.begin;
    else if (text[where.begin] != ';') return;
    while (where.begin > 0 && text[where.begin - 1] == ' ') --where.begin;
    changes_.remove(where);
  }

  /// Writes the lines that come before this one and have not been written yet.
  tl::expected<void, EditFault> lines_before(std::uint32_t number) {
    for (;;) {
      if (has_line_ && line_.number >= number) return {};
      if (has_line_) {
        if (auto status = write_line(); !status) return status;
        has_line_ = false;
      }
      Line next;
      const bool is_there = raw_.next(next);
      if (auto status = end_line(is_there ? next.offset : raw_.size()); !status) return status;
      if (!is_there) return {};
      if (next.number == 1 && next.offset == utf8_mark.size()) put_(utf8_mark);
      line_ = next, bytes_ = std::string(next.bytes), has_line_ = true;
    }
  }

  /// Writes the end of the line that was written last: as many characters as the program has there; and the lines that follow it.
  tl::expected<void, EditFault> end_line(std::uint64_t next_offset) {
    if (!open_line_) return {};
    open_line_ = false;
    const std::uint64_t count = next_offset - open_end_;
    const std::string end =
        ends_with_cr_ ? "\r" : std::string(static_cast<std::size_t>(std::max<std::uint64_t>(count, 1) - 1), '\r') + '\n';
    if (count != 0 && !line_removed_) put_(end);
    if (program_.patches == nullptr) return {};
    const auto after = program_.patches->after.find(line_.number);
    if (after == program_.patches->after.end()) return {};
    if (count == 0) put_(end);
    for (const std::string& line : after->second) {
      if (auto status = put_encoded(line); !status) return status;
      put_(end);
      ++made_.lines;
    }
    return {};
  }

  tl::expected<void, EditFault> put_encoded(const std::string& text) {
    const WrittenLetters letters{reader_.encoding(), false};
    const auto bytes = is_written_so(text, letters) ? Result<std::string>(text) : bytes_of(text, letters);
    if (!bytes) return tl::unexpected(EditFault{line_.number, translated(texts::edit::not_in_encoding)});
    put_(*bytes);
    return {};
  }

  bool is_plain_comment(std::string_view text) const {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return false;
    const std::size_t end = text.find_last_not_of(" \t\r");
    if (text[begin] == ';') return (grammar_.semicolon_comments || grammar_.semicolon_ends) && !is_executed_comment(text.substr(begin + 1));
    return text[begin] == '(' && text[end] == ')' && text.find(')') == end && !is_executed_comment(text.substr(begin + 1, end - begin - 1));
  }

  /// Writes the present line, with its changes.
  tl::expected<void, EditFault> write_line() {
    open_line_ = true, line_removed_ = false;
    open_end_ = line_.offset + bytes_.size();
    const bool is_empty = bytes_.find_first_not_of(" \t\r") == std::string::npos;
    if (!has_block_) {
      line_removed_ = (is_empty && edits_.no_empty_lines) || (edits_.no_comments && is_plain_comment(bytes_));
      if (line_removed_) ++made_.lines;
      else put_(bytes_);
      return {};
    }
    std::string text = std::exchange(line_text_, {});
    has_block_ = false;
    if (program_.patches != nullptr) {
      const auto instead = program_.patches->instead.find(line_.number);
      if (instead != program_.patches->instead.end()) {
        changes_.clear();
        made_.lines += instead->second != text ? 1 : 0;
        line_removed_ = instead->second.empty();
        return put_encoded(instead->second);
      }
    }
    // A comment that goes on in the next lines is a part of the block's text. It stays as it is.
    if (text.size() > bytes_.size() && text.starts_with(bytes_)) text.resize(bytes_.size());
    if (changes_.empty()) {
      put_(bytes_);
      return {};
    }
    if (line_.too_long) return tl::unexpected(EditFault{line_.number, translated(texts::edit::line_too_long)});
    const std::string made = changes_.applied(text);
    changes_.clear();
    if (made == text) {
      put_(bytes_);
      return {};
    }
    ++made_.lines;
    line_removed_ = made.find_first_not_of(" \t") == std::string::npos && (edits_.no_comments || edits_.no_numbers);
    if (line_removed_) return {};
    return put_encoded(made);
  }

  const EditedSource& program_;
  const Edits& edits_;
  const StopToken& stop_;
  const std::function<void(std::string_view)>& put_;
  const Grammar& grammar_;
  LineReader raw_;
  BlockReader reader_;
  BlockEditor words_;
  std::optional<Renumbering> numbers_;
  Block block_;
  LineChanges changes_;
  EditedText made_;
  Line line_;                   // the line that is read and not written yet; its bytes are in bytes_
  std::string bytes_;           // bytes of that line
  std::string line_text_;       // the line in UTF-8, if it has a block
  std::uint64_t open_end_ = 0;  // offset behind the last byte of the line whose end is not written yet
  bool has_line_ = false, has_block_ = false, open_line_ = false, line_removed_ = false, ends_with_cr_ = false;
};

}  // namespace

bool needs_use(const Edits& edits) {
  return !edits.feeds.empty() || !edits.speeds.empty() || !edits.tools.empty() || !edits.work_systems.empty() || !edits.shift.empty() ||
         edits.plane || !edits.places.empty() || edits.reverses;
}

tl::expected<EditedText, EditFault> edit_program(const EditedSource& program, const Edits& edits, const StopToken& stop,
                                                 const std::function<void(std::string_view)>& put) {
  return ProgramWriter(program, edits, stop, put).write();
}

}  // namespace kadr
