// Fuzz target for lang: reads bytes as blocks. The first byte selects the control's grammar and the encoding, the rest is the program.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "config/control/control_file.h"
#include "lang/block/block_reader.h"
#include "lang/text/utf16.h"
#include "require.h"

namespace {

using kadr::fuzz::require;

constexpr const char* controls[] = {"s2c42", "mach3", "gost", "correctors"};
constexpr std::size_t most_sought = 300;  // greatest number of blocks that the test jumps to

const kadr::Grammar& grammar_of(std::size_t index) {
  static const std::vector<kadr::ControlDef> defs = [] {
    std::vector<kadr::ControlDef> loaded;
    for (const char* const id : controls) loaded.push_back(std::move(*kadr::load_control(id)));
    return loaded;
  }();
  return defs[index].grammar;
}

std::optional<kadr::Encoding> encoding_of(std::size_t index) {
  using kadr::Encoding;
  constexpr Encoding all[] = {Encoding::utf8, Encoding::cp1251, Encoding::koi8r, Encoding::cp866, Encoding::iso7};
  if (index >= std::size(all)) return std::nullopt;
  return all[index];
}

constexpr unsigned as_utf16le = 32, as_utf16be = 64;  // bits of the first byte; else the encoding is detected

kadr::OpenedText opened(std::string text, unsigned switches) {
  kadr::GivenEncoding given;
  if ((switches & as_utf16le) != 0) given.utf16 = kadr::Utf16::little;
  else if ((switches & as_utf16be) != 0) given.utf16 = kadr::Utf16::big;
  else given.encoding = encoding_of(switches >> 2 & 7U);
  return kadr::as_text(kadr::text_source(std::move(text)), given);
}

/// A copy of the data of a block, for comparison after the next one has been read.
struct Read {
  kadr::Position position;
  bool good = false;
  kadr::AlarmId alarm = kadr::no_alarm;
  kadr::Span where;  // position in the displayed text; a line with comments only may be read undecoded
  std::vector<kadr::Word> words;
  std::uint32_t number = 0;
  std::size_t assignments = 0;
  std::size_t instructions = 0;
};

bool inside(kadr::Span span, std::string_view text) { return span.begin <= span.end && span.end <= text.size(); }

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void check_block(const kadr::BlockReader& reader, const kadr::Block& block, bool good) {
  using kadr::limits::block_assignments, kadr::limits::block_words, kadr::limits::expression_steps;
  require(inside(block.where, block.text), "the block lies in its text");
  require(block.word_count <= block_words, "not too many words");
  require(block.assignments.size() <= block_assignments, "not too many assignments");
  require(block.code.size() <= expression_steps + block_words, "not too many instructions");
  kadr::Span place = block.where;
  const std::string shown = reader.shown(block.text, place);
  require(kadr::fuzz::is_utf8(shown) && inside(place, shown), "a block can be shown, and its place in it");
  if (!good) return;
  for (std::uint32_t i = 0; i < block.word_count; ++i) {
    const kadr::Word& word = block.words[i];
    require(inside(word.where, block.text) && word.where.begin < word.where.end, "the word lies in its text");
    require(word.address >= 'A' && word.address <= 'Z' && block.has(word.address), "the word has an address");
    require(word.expression.end <= block.code.size(), "the expression lies in the block");
    if (!word.expression) require(std::isfinite(word.value), "the value is a number");
  }
  for (const kadr::Span comment : block.comments) require(inside(comment, block.text), "the comment lies in its text");
  for (const kadr::Alarm& warning : block.warnings) require(inside(warning.where, block.text), "the warning lies in its text");
}

Read read_one(kadr::BlockReader& reader, kadr::Block& block, bool& at_end) {
  const auto got = reader.next(block);
  Read read;
  read.good = got.has_value();
  at_end = got && *got == kadr::BlockReader::Got::end;
  if (at_end) return read;
  check_block(reader, block, read.good);
  read.position = block.position;
  read.where = block.where;
  (void)reader.shown(block.text, read.where);
  read.number = block.number;
  if (!got) {
    read.alarm = got.error().id;
    require(inside(got.error().where, block.text), "the alarm lies in the text");
    return read;
  }
  read.words.assign(block.words.begin(), block.words.begin() + block.word_count);
  for (kadr::Word& word : read.words) (void)reader.shown(block.text, word.where);
  read.assignments = block.assignments.size();
  read.instructions = block.code.size();
  return read;
}

bool same_words(const Read& a, const Read& b) {
  if (a.words.size() != b.words.size()) return false;
  for (std::size_t i = 0; i < a.words.size(); ++i) {
    const kadr::Word &x = a.words[i], &y = b.words[i];
    if (x.address != y.address || x.code != y.code || !(x.where == y.where)) return false;
    if (!x.expression && !same(x.value, y.value)) return false;
  }
  return true;
}

bool comes_later(kadr::Position a, kadr::Position b) { return b.offset > a.offset || (b.offset == a.offset && b.nth > a.nth); }

/// Checks that a jump to a block reads the same block again. Exception: a missing end-of-block mark may be noticed only in the second
/// reading.
void check_jump(kadr::BlockReader& reader, kadr::Block& block, const Read& first) {
  bool at_end = false;
  reader.seek(first.position);
  const Read again = read_one(reader, block, at_end);
  if (!again.good && again.alarm == kadr::AlarmId::end_of_block_missing) return;
  require(!at_end, "a jump to a block does not end the program");
  require(again.position.offset == first.position.offset && again.position.nth == first.position.nth, "a jump leads to the block");
  require(again.good == first.good && again.alarm == first.alarm, "read again, the block is as good as before");
  require(again.where == first.where && again.number == first.number && same_words(first, again), "read again, the block is the same");
  require(again.assignments == first.assignments && again.instructions == first.instructions, "read again, the expressions are the same");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  kadr::OpenedText program = opened(std::move(text), data[0]);
  const std::size_t length = program.source->size();
  kadr::BlockReader reader(std::move(program.source), grammar_of(data[0] & 3U), program.encoding);
  const auto block = std::make_unique<kadr::Block>();
  std::vector<Read> all;
  for (bool at_end = false; !at_end;) {
    Read read = read_one(reader, *block, at_end);
    if (at_end) break;
    require(all.empty() || comes_later(all.back().position, read.position), "reading goes on");
    require(read.position.offset <= length, "the block lies in the file");
    all.push_back(std::move(read));
  }
  require(all.size() <= length, "no more blocks than bytes");
  const std::size_t step = 1 + all.size() / most_sought;
  for (std::size_t i = 0; i < all.size(); i += step) check_jump(reader, *block, all[all.size() - 1 - i]);
  return 0;
}
