// Analyses a tape with several programs: where each program starts, and which sections of subprograms belong to it (spec/gost 1, 2С42 6.2,
// 6.3.5). Used by cli/job/open_program.

#include "lang/text/several_programs.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/code_literals.h"
#include "lang/text/eia.h"

namespace kadr {
namespace {

constexpr std::size_t max_entries = 10'000;
constexpr std::size_t search_bytes = 64 * 1024;

/// A source with the bytes of a file in which some ranges are replaced by blanks. The ends of lines in these ranges remain.
class BlankedSource final : public ByteSource {
 public:
  BlankedSource(std::shared_ptr<ByteSource> source, std::vector<ByteRange> blank, bool tape)
      : source_(std::move(source)), blank_(std::move(blank)), tape_(tape) {}

  std::size_t read(std::uint64_t offset, char* to, std::size_t size) override {
    const std::size_t got = source_->read(offset, to, size);
    for (const ByteRange& range : blank_) {
      const std::uint64_t begin = std::max(range.begin, offset), end = std::min(range.end, offset + got);
      for (std::uint64_t at = begin; at < end; ++at) blank(to[at - offset]);
    }
    return got;
  }
  std::uint64_t size() const override { return source_->size(); }

 private:
  void blank(char& byte) const {
    const bool ends_line = byte == '\n' || byte == '\r' || (tape_ && byte == static_cast<char>(eia_end_of_block));
    if (!ends_line) byte = tape_ ? '\0' : ' ';
  }

  std::shared_ptr<ByteSource> source_;
  std::vector<ByteRange> blank_;
  bool tape_;
};

/// Reads a file block by block and records where programs and subprograms start and end.
class Contents {
 public:
  Contents(const std::shared_ptr<ByteSource>& source, const Grammar& grammar, std::optional<Encoding> encoding)
      : reader_(source, grammar, encoding),
        sections_(grammar.section_address != 0),
        labels_(grammar.label_address != 0),
        may_begin_(!grammar.program_start_required) {}

  TapeContents run() {
    auto block = std::make_unique<Block>();
    while (contents_.programs.size() + contents_.subprograms.size() < max_entries) {
      const auto got = reader_.next(*block);
      if (got && *got == BlockReader::Got::end) break;
      take(*block);
    }
    end_at(reader_.size());
    std::size_t kept = 0;  // programs without words are removed: a sign % at the end of the file starts no program
    for (std::size_t i = 0; i < contents_.programs.size(); ++i)
      if (has_words_[i]) contents_.programs[kept++] = contents_.programs[i];
    contents_.programs.resize(kept);
    return std::move(contents_);
  }

 private:
  enum class In : std::uint8_t { nothing, section, program };

  void take(const Block& block) {
    const std::uint64_t at = block.position.offset;
    const bool after_start = std::exchange(after_start_, block.marker == Marker::program_start);
    if (block.marker == Marker::program_start) return begin_program(at, block.label);
    if (block.marker == Marker::label && labels_ && after_start && contents_.programs.back().number == 0)
      contents_.programs.back().number = block.label;
    if (block.marker == Marker::section && sections_) {
      end_at(at);
      in_ = In::section;
      return;
    }
    // On a control that needs no % before a program, the first block starts the program.
    if (in_ == In::nothing && !block.empty() && may_begin_ && contents_.programs.empty()) begin_program(at, 0);
    if (in_ == In::program && block.word_count > 0) has_words_.back() = true;
    if (in_ == In::section) subprogram_block(block);
  }

  void begin_program(std::uint64_t at, std::uint32_t number) {
    end_at(at);
    in_ = In::program;
    contents_.programs.push_back({{at, at}, number});
    has_words_.push_back(false);
  }

  /// Handles a block such as N02001: subprogram 02, block 001 (2С42 6.3.5). M2 ends the section of subprograms.
  void subprogram_block(const Block& block) {
    constexpr std::uint8_t digits_of_label = 5;
    constexpr std::uint32_t blocks_a_subprogram = 1000;
    constexpr std::int32_t program_end = 2_m;
    const std::uint32_t number = block.number / blocks_a_subprogram;
    if (block.has_number && block.number_digits == digits_of_label && (!open_ || contents_.subprograms.back().number != number)) {
      end_subprogram(block.position.offset);
      contents_.subprograms.push_back({{block.position.offset, block.position.offset}, number});
      open_ = true;
    }
    for (std::uint32_t i = 0; i < block.word_count; ++i)
      if (block.words[i].address == 'M' && block.words[i].code == program_end) {
        end_subprogram(reader_.position().offset);
        in_ = In::nothing;
      }
  }

  void end_subprogram(std::uint64_t at) {
    if (std::exchange(open_, false)) contents_.subprograms.back().bytes.end = at;
  }
  void end_at(std::uint64_t at) {
    end_subprogram(at);
    if (in_ == In::program) contents_.programs.back().bytes.end = at;
  }

  BlockReader reader_;
  const bool sections_, labels_, may_begin_;
  TapeContents contents_;
  std::vector<bool> has_words_;  // by program: true if the program has a block with words
  In in_ = In::nothing;
  bool open_ = false;         // true: the end of the present subprogram has not been reached yet
  bool after_start_ = false;  // true: the block processed last had the sign %
};

}  // namespace

std::size_t count_program_signs(ByteSource& source, std::optional<Encoding> encoding) {
  const char sign = encoding == Encoding::eia    ? static_cast<char>(*eia_row(U'%'))
                    : encoding == Encoding::iso7 ? static_cast<char>(with_even_parity('%'))
                                                 : '%';
  std::string window(search_bytes, '\0');
  std::size_t count = 0;
  for (std::uint64_t at = 0;;) {
    const std::size_t got = source.read(at, window.data(), window.size());
    if (got == 0) return count;
    count += static_cast<std::size_t>(std::count(window.begin(), window.begin() + static_cast<std::ptrdiff_t>(got), sign));
    at += got;
  }
}

TapeContents contents_of(const std::shared_ptr<ByteSource>& source, const Grammar& grammar, std::optional<Encoding> encoding) {
  return Contents(source, grammar, encoding).run();
}

std::unique_ptr<ByteSource> whole_file(std::shared_ptr<ByteSource> source) {
  return std::make_unique<BlankedSource>(std::move(source), std::vector<ByteRange>(), false);
}

std::optional<std::size_t> program_numbered(const TapeContents& contents, std::uint32_t number) {
  const auto& programs = contents.programs;
  for (std::size_t i = 0; i < programs.size(); ++i)
    if (programs[i].number == number && number != 0) return i;
  const bool unnumbered = std::all_of(programs.begin(), programs.end(), [](const TapeProgram& p) { return p.number == 0; });
  if (unnumbered && number >= 1 && number <= programs.size()) return number - std::size_t{1};
  return std::nullopt;
}

std::unique_ptr<ByteSource> only_program(std::shared_ptr<ByteSource> source, const TapeContents& contents, std::size_t index,
                                         std::optional<Encoding> encoding) {
  std::vector<ByteRange> blank;
  for (std::size_t i = 0; i < contents.programs.size(); ++i)
    if (i != index) blank.push_back(contents.programs[i].bytes);
  const std::uint64_t begin = contents.programs[index].bytes.begin;
  std::map<std::uint32_t, const TapeSubprogram*> in_memory;
  for (const TapeSubprogram& s : contents.subprograms) {
    const auto [entry, added] = in_memory.try_emplace(s.number, &s);
    if (added || s.bytes.begin > begin) continue;
    blank.push_back(entry->second->bytes);
    entry->second = &s;
  }
  for (const TapeSubprogram& s : contents.subprograms)
    if (in_memory[s.number] != &s && s.bytes.begin > begin) blank.push_back(s.bytes);
  return std::make_unique<BlankedSource>(std::move(source), std::move(blank), encoding && is_tape(*encoding));
}

}  // namespace kadr
