// Reads the blocks of a program from its lines. This is the entrance to the room `lang`. Used by control, lang; tested by
// tests/lang/block_reader_test.cpp.

#include "lang/block/block_reader.h"

#include <algorithm>
#include <utility>

#include "lang/block/lexer.h"
#include "lang/text/eia.h"
#include "lang/text/end_mark.h"
#include "lang/text/tape_orientation.h"

namespace kadr {
namespace {

bool has_high_bytes(std::string_view bytes) {
  return std::any_of(bytes.begin(), bytes.end(), [](char c) { return (static_cast<unsigned char>(c) & 0x80) != 0 || c == '\x0e'; });
}

}  // namespace

BlockReader::BlockReader(std::shared_ptr<ByteSource> source, const Grammar& grammar, std::optional<Encoding> encoding)
    : lines_(std::move(source)), grammar_(grammar), plain_(grammar), memory_{.encoding = encoding} {
  if (!memory_.encoding) {
    memory_.encoding = detect_encoding(lines_.sample());
    memory_.guessed = memory_.encoding.has_value();
  }
  if (!memory_.encoding || !is_tape(*memory_.encoding)) {
    if (grammar_.percent_frames) frame_ = frame_of(lines_.sample(), grammar_);
    return;
  }
  if (memory_.encoding == Encoding::eia) lines_.end_lines_with(static_cast<char>(eia_end_of_block));
  if (const auto look = inspect_tape(lines_.sample()); look) orientation_ = look->orientation;
}

std::string BlockReader::shown(std::string_view text, Span& place) const {
  if (is_text_ || (encoding() != Encoding::eia && !has_high_bytes(text))) return std::string(text);
  std::string all;
  Span there = {0, 0};
  std::size_t bytes = 1;
  for (std::size_t i = 0; i <= text.size(); i += bytes) {
    bytes = encoding() == Encoding::utf8 && i < text.size() ? std::max<std::size_t>(first_character(text.substr(i)).size, 1) : 1;
    if (i <= place.begin) there.begin = static_cast<std::uint32_t>(all.size());
    if (i <= place.end) there.end = static_cast<std::uint32_t>(all.size());
    if (i == text.size()) break;
    // The eighth bit of a tape row is a parity bit, so it is removed, also from a row with wrong parity.
    if (encoding() == Encoding::iso7) all += static_cast<char>(text[i] & 0x7F);
    // A row of blank tape becomes a space character, so that the offsets of later characters do not change.
    else if (text[i] == 0 && encoding() == Encoding::eia) all += ' ';
    else if (!append_utf8(text.substr(i, bytes), encoding(), all)) all += '?';
  }
  place = there;
  return all;
}

void BlockReader::seek(Position position) {
  lines_.seek(position.offset, position.line);
  in_line_ = false;
  position_ = position;
}

Result<BlockReader::Got> BlockReader::next(Block& block) {
  if (orientation_ != TapeOrientation::right) [[unlikely]]
    return reversed_tape(block);
  for (;;) {
    // A copy that stays in registers. Storing the members of position_ one by one would delay a load of the whole Position.
    Position here = position_;
    if (!in_line_) {
      if (!lines_.next(line_)) {
        position_ = {lines_.offset(), line_.number + 1, 0};
        return Got::end;
      }
      if (line_.offset < frame_.begin) continue;
      if (is_sign_of_end()) {
        lines_.seek(line_.offset, line_.number);
        position_ = {line_.offset, line_.number, 0};
        return Got::end;
      }
      here = {line_.offset, line_.number, here.offset == line_.offset ? here.nth : 0};
      KADR_TRY(begin_line(block, here.nth));
    }
    block.clear();
    block.position = here;
    const bool was_first = rest_ == 0;
    const Status status = lex_line(block);
    in_line_ = rest_ < text_.size();
    position_ = in_line_ ? Position{line_.offset, line_.number, here.nth + 1} : Position{lines_.offset(), line_.number + 1, 0};
    if (was_first && line_.too_long) return fail(alarm(AlarmId::line_too_long, {0, 1}, double{limits::line_bytes}));
    if (!status) return fail(status.error());
    if (frame_.begin != 0 && line_.offset == frame_.begin) block.warnings.push_back(warning(AlarmId::text_passed_over, block.where));
    if (!block.empty() || block.has_number || !block.comments.empty() || !block.warnings.empty()) return Got::block;
  }
}

/// Returns true for a line with % that is not the line with the first %, which starts the program (spec/fanuc 1.1).
bool BlockReader::is_sign_of_end() const {
  return grammar_.percent_frames && line_.offset != frame_.sign && has_sign(line_.bytes) &&
         !(memory_.encoding && is_tape(*memory_.encoding));
}

/// Handles a tape that was read in the wrong orientation. No block of such a tape is readable, so one alarm is returned, then the end of
/// the program.
Result<BlockReader::Got> BlockReader::reversed_tape(Block& block) {
  block.clear();
  block.text = {};
  block.where = {};
  if (std::exchange(memory_.orientation_reported, true)) return Got::end;
  return fail(alarm(AlarmId::tape_reversed, {}, name_of(orientation_)));
}

/// Starts a new line. After a jump into the middle of a line, skips the blocks before number `nth` of the line.
Status BlockReader::begin_line(Block& block, std::uint32_t nth) {
  text_ = {line_.bytes.data(), line_.bytes.size()};
  rest_ = 0;
  is_text_ = false;
  if ((memory_.encoding && is_tape(*memory_.encoding)) || memory_.expects_high_bytes) {
    const Status decoded = decode_line();
    // an undecodable byte on a tape is an alarm at once; in other encodings the byte may be in a comment, so lex_line decides
    if (!decoded && is_tape(encoding())) {
      block.clear();
      block.position = {line_.offset, line_.number, 0};
      block.text = text_;
      block.where = {0, static_cast<std::uint32_t>(text_.size())};
      in_line_ = false;
      position_ = {lines_.offset(), line_.number + 1, 0};
      return decoded;
    }
  }
  for (std::uint32_t i = 0; i < nth; ++i) {
    block.clear();
    (void)lex_line(block);
  }
  return {};
}

Status BlockReader::lex_line(Block& block) {
  if (memory_.first_mark == no_mark && plain_.read(text_, rest_, block)) [[likely]] {
    rest_ = text_.size();
    return {};
  }
  auto lexed = lex_block(text_, rest_, is_text_, grammar_, block);
  const bool unclear = lexed ? lexed->needs_utf8 : has_high_bytes(text_);
  if (unclear && !is_text_) {
    memory_.expects_high_bytes = true;
    const Status decoded = decode_line();
    if (!decoded) {
      rest_ = text_.size();
      return decoded;
    }
    if (rest_ != 0) {  // earlier blocks of the line were read undecoded, so their length is converted to the length of the decoded text
      std::string before;
      (void)append_utf8(line_.bytes.substr(0, rest_), *memory_.encoding, before);
      rest_ = before.size();
    }
    block.clear();
    lexed = lex_block(text_, rest_, true, grammar_, block);
  }
  // One block may contain several comments that continue in the next line.
  for (std::uint32_t joined = 0; lexed && lexed->open_comment; ++joined) {
    if (joined == limits::long_comments) {
      rest_ = text_.size();
      return fail(alarm(AlarmId::too_many_words, {0, 1}, double{limits::long_comments}));
    }
    KADR_TRY(join_comment(block, lexed->comment_at));
    lexed = lex_block(text_, rest_, is_text_, grammar_, block);
    if (lexed && lexed->needs_utf8) {
      const Status decoded = decode_line();
      if (!decoded) return decoded;
      block.clear();
      lexed = lex_block(text_, rest_, true, grammar_, block);
    }
  }
  while (lexed && lexed->continues) {
    const auto joined = join_line(block);
    if (!joined) return fail(joined.error());
    if (!*joined) break;  // the file ends
    lexed = lex_block(text_, rest_, is_text_, grammar_, block);
    if (lexed && lexed->needs_utf8) {
      KADR_TRY(decode_line());
      block.clear();
      lexed = lex_block(text_, rest_, true, grammar_, block);
    }
  }
  if (!lexed) {
    // The words after a faulty word are skipped, up to the next end of a block.
    const std::size_t mark = is_text_ ? text_.find(end_mark_in_text, lexed.error().where.end) : std::string_view::npos;
    rest_ = mark == std::string_view::npos ? text_.size() : mark + end_mark_in_text.size();
    return fail(lexed.error());
  }
  rest_ = lexed->next;
  if (lexed->marked) {
    memory_.first_mark = std::min(memory_.first_mark, line_.offset);
  } else if (line_.offset >= memory_.first_mark && grammar_.mark_everywhere && !block.empty()) {
    const std::uint32_t end = block.where.end;
    return fail(alarm(AlarmId::end_of_block_missing, {end > 0 ? end - 1 : 0, end}));
  }
  return {};
}

/// Appends the next lines of an open comment, up to the line in which the comment ends. Only the start of a long comment is stored.
Status BlockReader::join_comment(Block& block, std::size_t open) {
  const bool was_text = is_text_;
  joined_ = line_.bytes;
  const std::uint64_t offset = line_.offset;
  Line next;
  for (bool closed = false; !closed;) {
    if (!lines_.next(next)) {
      const Span where{static_cast<std::uint32_t>(open), static_cast<std::uint32_t>(open + 1)};
      line_.bytes = text_ = joined_;
      if (was_text) KADR_TRY(decode_line());
      block.text = text_;
      rest_ = text_.size();
      return fail(alarm(AlarmId::comment_not_closed, where));
    }
    const std::size_t end = next.bytes.find(')');
    closed = end != std::string_view::npos;
    if (joined_.size() + next.bytes.size() <= limits::comment_bytes) {
      joined_ += '\n';
      joined_ += next.bytes;
    } else {
      // The end of every line of a comment is stored, because locations after the comment are found by counting lines.
      if (joined_.size() < limits::line_bytes) joined_ += '\n';
      if (closed) joined_ += next.bytes.substr(end);
    }
  }
  line_.bytes = joined_;
  line_.number = next.number;
  line_.offset = offset;
  text_ = {line_.bytes.data(), line_.bytes.size()};
  is_text_ = false;
  block.clear();
  return was_text ? decode_line() : Status();
}

/// Appends the next line to a block that goes on behind `~`. Returns false if the file has no next line.
Result<bool> BlockReader::join_line(Block& block) {
  Line next;
  joined_ = line_.bytes;
  const std::uint64_t offset = line_.offset;
  if (!lines_.next(next)) {
    line_.bytes = joined_;
    if (!is_text_) text_ = joined_;
    block.text = text_;
    return false;
  }
  if (joined_.size() + next.bytes.size() >= limits::line_bytes) {
    rest_ = 0;
    text_ = {};
    return fail(alarm(AlarmId::line_too_long, {0, 1}, double{limits::line_bytes}));
  }
  joined_ += '\n';
  joined_ += next.bytes;
  line_.bytes = joined_;
  line_.number = next.number;
  line_.offset = offset;
  text_ = {line_.bytes.data(), line_.bytes.size()};
  const bool was_text = std::exchange(is_text_, false);
  block.clear();
  if (was_text) KADR_TRY(decode_line());
  return true;
}

/// Decodes the whole line to UTF-8.
Status BlockReader::decode_line() {
  if (!memory_.encoding) {
    memory_.encoding = detect_encoding(line_.bytes).value_or(Encoding::utf8);
    memory_.guessed = true;
  }
  decoded_.clear();
  Status status = append_utf8(line_.bytes, *memory_.encoding, decoded_);
  if (!status && status.error().id == AlarmId::parity_error) {
    Alarm named = status.error();
    // Offset of the row, counted from the start of the tape.
    named.args[0] = AlarmArg(static_cast<double>(line_.offset) + named.args[0].number());
    return fail(named);
  }
  if (!status) return status;
  text_ = decoded_;
  is_text_ = true;
  return {};
}

}  // namespace kadr
