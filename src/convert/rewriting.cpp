// Rewrites a program line by line for the target control. Used by convert/word_by_word; tested by tests/convert.

#include "convert/rewriting.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "convert/source_setup.h"
#include "lang/text/line_reader.h"
#include "texts/conversion.h"

namespace kadr {
namespace {

constexpr std::size_t max_reported = 60;  // greatest number of bytes of a block that a comment quotes
// Number of lines that are read after the last line that cannot be expressed. Most lines that cannot be expressed are close together, near
// the beginning.
constexpr std::uint32_t early_end = 1000;

/// Returns the beginning of a text, in the length that a comment may quote. A UTF-8 character is not cut in two.
std::string_view beginning_of(std::string_view text) {
  constexpr unsigned char follows = 0x80, mask = 0xc0;
  if (text.size() <= max_reported) return text;
  std::size_t end = max_reported;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & mask) == follows) --end;
  return text.substr(0, end);
}

/// Returns the comment of a line without blocks, in any comment form of the control.
std::string comment_of(std::string_view line, const Grammar& grammar) {
  std::size_t begin = line.find_first_of(grammar.semicolon_comments || grammar.semicolon_ends ? "(;" : "(");
  if (begin == std::string_view::npos) return {};
  const bool in_brackets = line[begin] == '(';
  std::string_view text = line.substr(begin + 1);
  if (in_brackets) text = text.substr(0, text.rfind(')'));
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.remove_suffix(1);
  return std::string(text);
}

class Rewriter {
 public:
  Rewriter(const RewriteSpec& spec, const std::function<bool(std::string_view)>& put)
      : spec_(spec),
        put_(put),
        blocks_(*spec.to, [this](std::string_view line) { return write_line(line); }),
        words_(*spec.from, *spec.to),
        reader_(spec.source, spec.from->grammar, Encoding::utf8),
        raw_(spec.source) {}

  Result<Rewritten> write() {
    words_.set_used(spec_.used_variables);
    words_.set_macros(spec_.macros);
    blocks_.begin();
    bool has_begun = false;
    while (!spec_.stop.requested()) {
      const auto got = reader_.next(block_);
      if (got && *got == BlockReader::Got::end) break;
      const std::uint32_t line = block_.position.line;
      lines_before(line);
      source_line_ = line;
      if (spec_.ends_early && !made_.unsaid.empty() && line > made_.unsaid.back().line + early_end) return std::move(made_);
      if (is_over_ && is_all_after_end()) {
        last_block_ = line;
        continue;  // the control reads nothing after the end of the program, so the line is not rewritten
      }
      if (!got) {
        unsaid(got.error());
        continue;
      }
      if (!has_begun && block_.marker == Marker::none) {
        if (spec_.to->grammar.percent_frames && !is_labelled_) number_program();
        has_begun = true, begin_modes();
      }
      is_labelled_ = is_labelled_ || block_.marker == Marker::label;
      if (got)
        words_.set_in_section(in_section_ = block_.marker == Marker::section || (in_section_ && block_.marker != Marker::program_start));
      is_over_ = is_over_ || (!in_section_ && is_end());
      if (!has_begun && block_.marker == Marker::label && !spec_.to->grammar.programs_by_label)
        comment(std::string("O" + std::to_string(block_.label)));
      else if (in_section_) section_block(line);
      else if (!is_left_out(line)) block_or_subprogram(line);
    }
    lines_before(~std::uint32_t{0});
    leave_subprogram();
    if (!is_over_) end_program();
    if (spec_.to->grammar.section_address != 0) write_head();
    else write_tail();
    blocks_.close();
    if (is_full_) return fail(too_long());
    return std::move(made_);
  }

 private:
  /// Writes the number under which the target control stores the program.
  void number_program() {
    blocks_.text(blocks_.program_label(1));
    if (const Status status = blocks_.end(); !status) unsaid(status.error());
  }
  /// Appends text to the output; returns false if the output is full.
  bool write_line(std::string_view text) {
    if (is_full_) return false;
    // Blocks of subprograms are collected; they are written after the program end, or before the main program
    // on a control with a section of subprograms (2С42)
    if (in_section_ || in_subprogram_) {
      tail_ += text, tail_lines_.push_back(source_line_);
    } else {
      made_.lines.add(source_line_);
      is_full_ = !put_(text);
    }
    return !is_full_;
  }
  /// Writes the block, or collects it as part of a subprogram. Subprograms of O lines are moved to after the program end; on a control with
  /// a section of subprograms (2С42), all subprograms are moved to before the program.
  void block_or_subprogram(std::uint32_t line) {
    const bool is_label = spec_.to->grammar.section_address != 0 && block_.marker == Marker::label;
    if (is_label) leave_subprogram();
    if (is_label || (!spec_.to->grammar.o_words && FlowRewriter::begins_subprogram(block_))) in_subprogram_ = true;
    block(line);
    if (FlowRewriter::ends_subprogram(block_)) leave_subprogram();
  }
  void leave_subprogram() {
    if (std::exchange(in_subprogram_, false)) last_in_section_ = blocks_.end_section();
  }
  /// Writes the lines before the main program: `L` alone in a line, the subprograms, M2 (spec/s2c42 3).
  void write_head() {
    if (tail_.empty()) return;
    const LineOrigins of_program = std::exchange(made_.lines, {});
    const auto end = code_of(*spec_.to, {{Function::program_end, any_argument}, {Function::tape_end, any_argument}});
    made_.head = fmt::format("{}\n{}N{:05} {}\n", spec_.to->grammar.section_address, tail_, last_in_section_ + 1, end.value_or(""));
    made_.lines.add(tail_lines_.front());
    for (const std::uint32_t line : tail_lines_) made_.lines.add(line);
    made_.lines.add(tail_lines_.back());
    made_.lines.add(of_program);
  }
  void write_tail() {
    in_section_ = in_subprogram_ = false;
    is_full_ = !put_(tail_) || is_full_;
    for (const std::uint32_t line : tail_lines_) made_.lines.add(line);
  }

  /// Rewrites a subprogram of the 2С42 (spec/s2c42 6). N02001 begins subprogram 2, which is written with the label O2.
  void section_block(std::uint32_t line) {
    constexpr std::uint32_t blocks_a_subprogram = 1000;
    last_block_ = line;
    if (is_left_out(line) || block_.marker == Marker::section || !block_.has_number) return;
    const std::uint32_t label = block_.number / blocks_a_subprogram;
    if (label != std::exchange(label_, label)) {
      if (const Status status = words_.write_label(label, blocks_); !status) return unsaid(status.error());
      (void)blocks_.end();
    }
    block(line);
  }

  /// Writes the modes that most controls have at power-on, because the target control may have other modes at power-on.
  void begin_modes() {
    if (is_lathe(*spec_.to)) blocks_.code_if_there({{Function::plane_zx, any_argument}, {Function::select_plane, 18}});
    else blocks_.code_if_there({{Function::plane_xy, any_argument}, {Function::select_plane, 17}});
    blocks_.code_if_there({{Function::absolute, any_argument}});
    (void)blocks_.end();
    blocks_.code_if_there({{Function::millimetre, any_argument}});
    if (spec_.to->behaviour.arc_centers == ArcCenters::by_code) blocks_.code_if_there({{Function::centers_incremental, any_argument}});
    (void)blocks_.end();
  }
  void end_program() {
    blocks_.code_if_there({{Function::program_end, any_argument}, {Function::tape_end, any_argument}});
    (void)blocks_.end();
  }

  /// Copies the lines between the last block and this line that have no blocks: comments and empty lines.
  void lines_before(std::uint32_t line) {
    // all lines so far have blocks, so there is nothing to copy; the reader raw_ is opened only at the first line without a block
    if (line == next_raw_) {
      next_raw_ = line + 1;
      passed_ = block_.position;
      return;
    }
    if (next_raw_ > line) return;
    Line raw;
    if (passed_.line != 0) {
      raw_.seek(passed_.offset, passed_.line);
      raw_.next(raw);
      passed_.line = 0;
    }
    while (next_raw_ <= line && raw_.next(raw)) {
      next_raw_ = raw.number + 1;
      if (raw.number >= line) return;
      if (raw.number == last_block_ || is_in_place(raw.number) || is_left_out(raw.number)) continue;
      source_line_ = raw.number;
      const std::string text = comment_of(raw.bytes, spec_.from->grammar);
      if (!text.empty()) comment(text);
      else if (raw.bytes.find_first_not_of(" \t\r") == std::string_view::npos) (void)write_line("\n");
    }
  }

  void comment(const std::string& text) {
    blocks_.comment(text);
    (void)blocks_.end();
  }

  /// True if the source control reads nothing after the program end, so that no subprogram can follow.
  bool is_all_after_end() const {
    const Grammar& grammar = spec_.from->grammar;
    return spec_.from->behaviour.ends_reading && (grammar.label_address == 0 || spec_.from->behaviour.label_is_number) &&
           grammar.section_address == 0 && !grammar.programs_by_label;
  }

  bool is_left_out(std::uint32_t line) const {
    return std::any_of(spec_.left_out->begin(), spec_.left_out->end(), [&](const TextLines& range) { return range.holds(line); });
  }
  const FlatRange* place_at(std::uint32_t line) const {
    const auto after = std::upper_bound(spec_.places->begin(), spec_.places->end(), line,
                                        [](std::uint32_t at, const FlatRange& place) { return at < place.lines.first; });
    if (after == spec_.places->begin() || !std::prev(after)->lines.holds(line)) return nullptr;
    return &*std::prev(after);
  }
  bool is_in_place(std::uint32_t line) const { return place_at(line) != nullptr; }

  bool is_end() const {
    for (std::uint32_t i = 0; i < block_.word_count; ++i) {
      const Word& word = block_.words[i];
      if (word.code < 0) continue;
      const std::int32_t row = spec_.from->row_of(word.address, word.code);
      if (row >= 0 && traits_of(spec_.from->codes[static_cast<std::size_t>(row)].function).is(function_fact::ends)) return true;
    }
    return false;
  }

  void block(std::uint32_t line) {
    last_block_ = line;
    if (const FlatRange* const place = place_at(line)) {
      words_.pass(block_);
      if (place != last_place_) written_out(*place);
      last_place_ = place;
      if (is_end() && !in_section_) end_program();
      return;
    }
    if (const Status status = words_.write(block_, blocks_); !status) unsaid(status.error());
    for (const Span one : block_.comments)
      if (block_.statement.kind != StatementKind::message) blocks_.comment(block_.text_of(one));
    if (const Status status = blocks_.end(); !status) unsaid(status.error());
    if (const Status status = words_.end(blocks_); !status) unsaid(status.error());
  }

  void written_out(const FlatRange& place) {
    const bool is_long = place.motions > 1 || place.lines.first != place.lines.last;
    if (is_long) {
      std::string_view text = block_.text_of(block_.where);
      comment(translated_in(spec_.lang, texts::conversion::comment_written_out, beginning_of(text)));
    } else if (block_.statement.kind != StatementKind::message) {
      for (const Span one : block_.comments) comment(std::string(block_.text_of(one)));
    }
    std::string_view rest = place.text;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
      if (in_subprogram_ && spec_.to->grammar.section_address != 0) write_in_section(rest.substr(0, end));
      else (void)write_line(rest.substr(0, end));
      rest.remove_prefix(end);
    }
    words_.repeat_modes();
  }

  /// Writes a block of a subprogram. On a control with a section of subprograms (2С42), the block gets a number that belongs to this
  /// section, in place of its own number.
  void write_in_section(std::string_view line) {
    if (line.starts_with('N')) line.remove_prefix(std::min(line.find(' '), line.size() - 1) + 1);
    blocks_.text(line.substr(0, line.find('\n')));
    if (const Status status = blocks_.end(); !status) unsaid(status.error());
  }

  void unsaid(const Alarm& why) {
    blocks_.drop();
    made_.unsaid.push_back({block_.position.line, why});
  }

  const RewriteSpec& spec_;
  const std::function<bool(std::string_view)>& put_;
  Rewritten made_;
  BlockMaker blocks_;
  BlockRewriter words_;
  BlockReader reader_;
  LineReader raw_;
  Block block_;
  const FlatRange* last_place_ = nullptr;
  std::uint32_t source_line_ = 0, last_block_ = 0, next_raw_ = 1;
  // position of a line that the line reader raw_ has not read yet; line number 0: there is no such line
  Position passed_{0, 0, 0};
  std::uint32_t label_ = 0;            // label of the subprogram in the section that is being written
  std::uint32_t last_in_section_ = 0;  // last block number in the section of subprograms of the target control
  std::string tail_;
  std::vector<std::uint32_t> tail_lines_;
  bool is_over_ = false, in_section_ = false, in_subprogram_ = false, is_full_ = false, is_labelled_ = false;
};

}  // namespace

std::uint32_t LineOrigins::of(std::uint32_t line) const {
  if (line == 0 || line > count_) return 0;
  const auto after = std::partition_point(runs_.begin(), runs_.end(), [line](const LineRun& one) { return one.made < line; });
  return std::prev(after)->source + (line - 1 - std::prev(after)->made);
}

Result<Rewritten> rewrite(const RewriteSpec& spec, const std::function<bool(std::string_view)>& put) { return Rewriter(spec, put).write(); }

}  // namespace kadr
