// One file of the program memory: its reader, the blocks kept in memory for loops, the positions of block numbers and loops (spec/nct/14,
// 23 23.2.8, 23.2.11). Used by control/flow/file_end, control/flow/flow; tested by tests/control/program_file_test.cpp.

#include "control/flow/program_file.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/ascii.h"
#include "lang/text/eia.h"

namespace kadr {
namespace {

/// Finds DO, END or WHILE in a line that cannot be read. Then the END or DO that matches it is not reported as a second fault.
std::pair<StatementKind, std::uint8_t> damaged_loop(std::string_view text) {
  std::string capitals(text.substr(0, text.find('(')));
  for (char& c : capitals) c = to_upper(c);
  const auto number_after = [&](std::string_view word) -> std::uint8_t {
    for (std::size_t at = capitals.find(word); at != std::string::npos; at = capitals.find(word, at + 1)) {
      const std::size_t digit = capitals.find_first_not_of(' ', at + word.size());
      if (digit != std::string::npos && capitals[digit] >= '1' && capitals[digit] <= '3')
        return static_cast<std::uint8_t>(capitals[digit] - '0');
    }
    return 0;
  };
  if (const std::uint8_t m = number_after("DO"); m != 0) return {StatementKind::loop, m};
  if (const std::uint8_t m = number_after("END"); m != 0) return {StatementKind::loop_end, m};
  return {capitals.find("WHILE") == std::string::npos ? StatementKind::none : StatementKind::loop, 0};
}

}  // namespace

ProgramFile::ProgramFile(std::string path, std::shared_ptr<ByteSource> source, const Grammar& grammar, std::optional<Encoding> encoding,
                         StopToken stop)
    : path_(std::move(path)), source_(std::move(source)), grammar_(grammar), reader_(source_, grammar, encoding), stop_(stop) {}

Result<BlockReader::Got> ProgramFile::next(Block*& block) {
  if (memory_.keeps) {
    if (KeptBlock* const kept = kept_at(position()); kept != nullptr) [[likely]] {
      last_ = kept;
      seek(kept->next);
      block = &kept->block;
      return BlockReader::Got::block;
    }
  }
  if (moved_ && reader_.position() != elsewhere_) reader_.seek(elsewhere_);
  moved_ = false;
  const Position at = memory_.keeps ? reader_.position() : Position();
  block = &in_hand_;
  auto got = reader_.next(in_hand_);
  if (memory_.keeps && got && *got == BlockReader::Got::block && kept_.size() < max_kept) block = keep(at);
  else last_ = nullptr;
  return got;
}

KeptBlock* ProgramFile::kept_at(Position place) {
  const bool follows = last_ != nullptr && last_->next == place;
  if (follows && last_->following != nullptr) return last_->following;
  if (last_ != nullptr && last_->jumped != nullptr && last_->jumped_to == key_of(place)) return last_->jumped;
  const auto found = kept_.find(key_of(place));
  if (found == kept_.end()) return nullptr;
  if (follows) {
    last_->following = found->second.get();
  } else if (last_ != nullptr) {
    last_->jumped = found->second.get();
    last_->jumped_to = key_of(place);
  }
  return found->second.get();
}

/// Stores the block in memory. The text of the block is copied, because the next line overwrites the buffer of the text.
Block* ProgramFile::keep(Position at) {
  auto entry = std::make_unique<KeptBlock>();
  entry->block = in_hand_;
  entry->text = in_hand_.text;
  entry->block.text = entry->text;
  entry->block.repeated = true;
  if (memory_.reported.contains(place_of(entry->block.position))) entry->block.warnings.clear();
  entry->next = reader_.position();
  Block* const block = &entry->block;
  last_ = entry.get();
  kept_.emplace(key_of(at), std::move(entry));
  return block;
}

BlockReader& ProgramFile::scanner() {
  if (!scanner_) scanner_ = std::make_unique<BlockReader>(source_, grammar_, reader_.encoding());
  return *scanner_;
}

std::optional<Position> ProgramFile::find_number(std::uint32_t number, Position from) {
  if (index_) return in_index(number, from, extent_of(from));
  const std::pair key{key_of(from), number};
  if (const auto known = numbers_.find(key); known != numbers_.end()) return known->second;
  const Extent in = extent_of(from);
  const auto found = search(number, from, in);
  if (found && !index_ && numbers_.size() < max_loops) numbers_.emplace(key, *found);
  return found;
}

/// Searches a block number by reading the blocks. When max_searched blocks have been read, an index of the file is used instead.
std::optional<Position> ProgramFile::search(std::uint32_t number, Position from, const Extent& in) {
  auto found = scan(number, from, in.end);
  if (!found) found = scan(number, in.begin, from);
  if (found || !index_possible_ || searched_ < max_searched || stop_.requested()) return found;
  index_.emplace();
  index_possible_ = index_->make(scanner(), stop_);
  if (index_possible_) {
    numbers_.clear();
    return in_index(number, from, in);
  }
  index_.reset();
  return search(number, from, in);
}

std::optional<Position> ProgramFile::in_index(std::uint32_t number, Position from, const Extent& in) const {
  const auto inside = [&](const std::optional<Position>& place) {
    return place && place->offset >= in.begin.offset && (place->offset < in.end.offset);
  };
  if (const auto found = index_->find(number, from); inside(found)) return found;
  if (const auto found = index_->find(number, in.begin); inside(found)) return found;
  return std::nullopt;
}

/// Returns the extent of the program that contains the block before `place`. If the control does not distinguish programs in a file, the
/// extent is the whole file.
ProgramFile::Extent ProgramFile::extent_of(Position place) {
  Extent extent{{}, {~std::uint64_t{0}, 0, 0}};
  if (!grammar_.programs_by_label) return extent;
  if (!programs_) find_programs();
  const auto before = [](const NumberedProgram& program, const Position& at) {
    return std::tie(program.begin.offset, program.begin.nth) < std::tie(at.offset, at.nth);
  };
  auto next = std::lower_bound(programs_->begin(), programs_->end(), place, before);
  const bool at_first = next == programs_->begin() && next != programs_->end() && next->begin == place;
  if (at_first && first_block().offset == place.offset) ++next;  // the first program starts at `place`, in the first block of the file
  if (next != programs_->end()) extent.end = next->begin;
  if (next != programs_->begin()) extent.begin = std::prev(next)->begin;
  return extent;
}

Position ProgramFile::first_block() {
  if (first_block_) return *first_block_;
  BlockReader& reader = scanner();
  reader.seek({});
  auto block = std::make_unique<Block>();
  for (;;) {
    const auto got = reader.next(*block);
    const bool content = !got || block->marker == Marker::label || !block->empty();
    if (stop_.requested() || (got && *got == BlockReader::Got::end) || (content && block->marker != Marker::program_start)) break;
  }
  first_block_ = block->position;
  return *first_block_;
}

std::vector<Position> ProgramFile::programs_numbered(std::uint32_t number) {
  if (!programs_) find_programs();
  std::vector<Position> places;
  for (const NumberedProgram& program : *programs_)
    if (program.number == number) places.push_back(program.begin);
  return places;
}

void ProgramFile::find_programs() {
  programs_.emplace();
  BlockReader& reader = scanner();
  reader.seek({});
  auto block = std::make_unique<Block>();
  for (;;) {
    const auto got = reader.next(*block);
    if ((got && *got == BlockReader::Got::end) || programs_->size() >= max_loops || stop_.requested()) return;
    if (block->marker == Marker::label) programs_->push_back({block->position, block->label});
  }
}

std::optional<Position> ProgramFile::scan(std::uint32_t number, Position from, Position to) {
  BlockReader& reader = scanner();
  reader.seek(from);
  auto block = std::make_unique<Block>();
  bool in_data = false;
  for (;;) {
    const Position at = reader.position();
    if (std::tie(at.offset, at.nth) >= std::tie(to.offset, to.nth) || stop_.requested() || (index_possible_ && searched_ >= max_searched))
      return std::nullopt;
    const auto got = reader.next(*block);
    ++searched_;
    if (got && *got == BlockReader::Got::end) return std::nullopt;
    if (!in_data && block->has_number && block->number == number) return block->position;
    if (const auto step = DataLines::step_of(*block); step != DataLines::Step::none) in_data = step == DataLines::Step::begins;
  }
}

const Loop* ProgramFile::loop_from(Position position) {
  if (!loops_found_) find_loops();
  if (last_loop_ != nullptr && key_of(last_loop_->begin) == key_of(position)) return last_loop_;
  const auto found = loops_by_begin_.find(key_of(position));
  return found == loops_by_begin_.end() ? nullptr : &loops_[found->second];
}

const Loop* ProgramFile::loop_to(Position position) {
  if (!loops_found_) find_loops();
  if (last_loop_ != nullptr && key_of(last_loop_->end) == key_of(position)) return last_loop_;
  const auto found = loops_by_end_.find(key_of(position));
  return last_loop_ = found == loops_by_end_.end() ? nullptr : &loops_[found->second];
}

/// Pairs DOm and ENDm by their order in the text. The order of execution cannot be used, because a jump may enter a loop (nct 23.2.11).
void ProgramFile::find_loops() {
  loops_found_ = true;
  BlockReader& reader = scanner();
  reader.seek({});
  auto block = std::make_unique<Block>();
  std::vector<std::size_t> open;
  for (;;) {
    const auto got = reader.next(*block);
    if (got && *got == BlockReader::Got::end) break;
    StatementKind kind = block->statement.kind;
    std::uint8_t m = block->statement.loop;
    if (!got) std::tie(kind, m) = damaged_loop(block->text);
    if ((kind != StatementKind::loop && kind != StatementKind::loop_end) || loops_.size() >= max_loops) continue;
    const auto same = [&](std::size_t i) { return loops_[i].number == m || loops_[i].number == 0; };
    const auto nearest = std::find_if(open.rbegin(), open.rend(), same);
    if (kind == StatementKind::loop) {
      if (nearest != open.rend()) loops_[*nearest].fault = AlarmId::do_without_end;  // in DO1 DO1 the first DO1 has no END
      Loop loop;
      loop.number = m;
      loop.begin = block->position;
      loop.body = reader.position();
      loop.damaged = !got;
      loops_by_begin_.emplace(key_of(loop.begin), loops_.size());
      open.push_back(loops_.size());
      loops_.push_back(loop);
      continue;
    }
    if (nearest == open.rend()) continue;  // for an END without DO no loop is stored, so loop_to() finds none
    const bool overlaps = nearest != open.rbegin();
    for (auto i = open.rbegin(); i != nearest; ++i) loops_[*i].fault = AlarmId::loops_overlap;
    Loop& loop = loops_[*nearest];
    loop.end = block->position;
    loop.after_end = reader.position();
    loop.damaged = loop.damaged || !got;
    if (overlaps) loop.fault = AlarmId::loops_overlap;
    loops_by_end_.emplace(key_of(loop.end), *nearest);
    open.erase(std::next(nearest).base());
  }
  for (const std::size_t i : open)
    if (loops_[i].fault == no_alarm) loops_[i].fault = AlarmId::do_without_end;
}

std::map<std::uint32_t, std::string> ProgramFile::texts_of(const std::set<std::uint32_t>& lines) const {
  std::map<std::uint32_t, std::string> texts;
  const BlockReader decoder(source_, grammar_, reader_.encoding());
  LineReader reader(source_);
  if (reader_.encoding() == Encoding::eia) reader.end_lines_with(static_cast<char>(eia_end_of_block));
  Line line;
  for (auto wanted = lines.begin(); wanted != lines.end() && reader.next(line);) {
    if (line.number != *wanted) continue;
    Span all;
    texts[*wanted++] = decoder.shown(line.bytes, all);
  }
  return texts;
}

std::string ProgramFile::text_of(std::uint32_t number) const {
  LineReader reader(source_);
  Line line;
  if (line_marks_.empty()) {
    while (reader.next(line))
      if ((line.number - 1) % marked_line == 0) line_marks_.push_back(line.offset);
  }
  const std::size_t mark = (std::max(number, 1U) - 1) / marked_line;
  if (mark >= line_marks_.size()) return {};
  reader.seek(line_marks_[mark], static_cast<std::uint32_t>(mark) * marked_line + 1);
  while (reader.next(line) && line.number < number) {
  }
  Span all;
  return line.number == number ? BlockReader(source_, grammar_, reader_.encoding()).shown(line.bytes, all) : std::string();
}

}  // namespace kadr
