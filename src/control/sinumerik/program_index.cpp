// Reads the labels, structures and programs of a file. Used by control/sinumerik.

#include "control/sinumerik/program_index.h"

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "base/ascii.h"
#include "control/flow/program_file.h"
#include "lang/named/named_parser.h"

namespace kadr::sinumerik {
namespace {

constexpr std::size_t most_rows = 500'000;

bool begins(Keyword k) {
  return k == Keyword::if_ || k == Keyword::while_ || k == Keyword::for_ || k == Keyword::loop || k == Keyword::repeat;
}

Keyword beginning_of(Keyword k) {
  switch (k) {
    case Keyword::else_:
    case Keyword::endif: return Keyword::if_;
    case Keyword::endwhile: return Keyword::while_;
    case Keyword::endfor: return Keyword::for_;
    case Keyword::endloop: return Keyword::loop;
    default: return Keyword::repeat;
  }
}

}  // namespace

std::string in_capitals(std::string_view text) {
  std::string all(text);
  for (char& c : all) c = to_upper(c);
  return all;
}

Keyword structure_of(std::string_view statement) {
  constexpr std::pair<std::string_view, Keyword> keywords[] = {
      {"IF", Keyword::if_},        {"ELSE", Keyword::else_},        {"ENDIF", Keyword::endif},
      {"WHILE", Keyword::while_},  {"ENDWHILE", Keyword::endwhile}, {"FOR", Keyword::for_},
      {"ENDFOR", Keyword::endfor}, {"LOOP", Keyword::loop},         {"ENDLOOP", Keyword::endloop},
      {"REPEAT", Keyword::repeat}, {"UNTIL", Keyword::until}};
  const std::string name = leading_name(statement);
  for (const auto& [text, keyword] : keywords) {
    if (name != text) continue;
    if (keyword == Keyword::if_)  // IF … GOTOF is a jump, not a structure
      for (const std::string_view jump : {"GOTOF", "GOTOB", "GOTO", "GOTOC", "GOTOS"})
        if (has_name(statement, jump)) return Keyword::none;
    if (keyword == Keyword::repeat) {  // REPEAT alone begins a loop; REPEAT LABEL repeats a part
      const std::size_t after = statement.find_first_of("tT", 0) + 1;
      const std::string_view rest = statement.substr(std::min(after, statement.size()));
      if (std::any_of(rest.begin(), rest.end(), [](char c) { return static_cast<unsigned char>(c) > ' '; })) return Keyword::none;
    }
    return keyword;
  }
  return Keyword::none;
}

std::string plain_program_name(std::string_view written) {
  std::string name = in_capitals(written);
  if (const std::size_t slash = name.find_last_of("/\\"); slash != std::string::npos) name.erase(0, slash + 1);
  if (!name.empty() && name[0] == '%') name.erase(0, 1);
  while (!name.empty() && static_cast<unsigned char>(name.back()) <= ' ') name.pop_back();
  if (name.starts_with("_N_")) name.erase(0, 3);
  for (const std::string_view ending : {"_MPF", "_SPF", ".MPF", ".SPF", "_CYC", ".CYC"})
    if (name.size() > ending.size() && name.ends_with(ending)) {
      name.erase(name.size() - ending.size());
      break;
    }
  return name;
}

ProgramIndex::ProgramIndex(const ProgramFile& file) {
  BlockReader reader(file.source(), file.grammar(), file.reader().encoding());
  auto block = std::make_unique<Block>();
  std::vector<std::int32_t> open;
  programs_.push_back({});
  bool first = true;
  for (;;) {
    const auto got = reader.next(*block);
    if (got && *got == BlockReader::Got::end) break;
    const Position at = block->position, after = reader.position();
    const std::string_view text =
        block->statement.kind == StatementKind::named ? block->text_of(block->statement.text) : std::string_view();
    if (!text.empty() && text[0] == '%') {
      if (!first) {
        programs_.push_back({{}, after, after});
        open.clear();
      }
      programs_.back().name = plain_program_name(text);
    }
    first = false;
    programs_.back().end = after;
    if (rows_.size() + labels_.size() > most_rows) continue;
    const std::int32_t inside = open.empty() ? -1 : open.back();
    const auto note = [&](std::string name) {
      by_name_[name].push_back(labels_.size());
      labels_.push_back({std::move(name), at, after, inside});
    };
    if (block->has_number) note("N" + std::to_string(block->number));
    if (block->statement.kind != StatementKind::named) continue;
    if (block->statement.label_where.end > 0) note(in_capitals(block->text_of(block->statement.label_where)));
    const Keyword keyword = structure_of(text);
    if (keyword == Keyword::none) continue;
    const auto index = static_cast<std::int32_t>(rows_.size());
    StructureRow row{keyword, at, after, -1, inside, static_cast<std::int32_t>(open.size()), false};
    if (begins(keyword)) {
      open.push_back(index);
    } else {
      const std::int32_t top = inside;
      StructureRow* const begin = top < 0 ? nullptr : &rows_[static_cast<std::size_t>(top)];
      if (begin == nullptr || begin->keyword != beginning_of(keyword)) {
        row.misplaced = true;
      } else {
        row.around = begin->around;
        row.depth = begin->depth;
        if (keyword == Keyword::else_) {
          begin->partner = index;
          row.partner = -1;
        } else {
          if (begin->partner >= 0) rows_[static_cast<std::size_t>(begin->partner)].partner = index;  // ELSE
          else begin->partner = index;
          row.partner = top;
          open.pop_back();
        }
      }
    }
    by_offset_.emplace(at.offset, index);
    rows_.push_back(row);
  }
}

bool ProgramIndex::misplaced_after(const StructureRow& row) const {
  return std::any_of(rows_.begin(), rows_.end(), [&](const StructureRow& each) {
    return each.misplaced && each.at.offset > row.at.offset && &program_at(each.at) == &program_at(row.at);
  });
}

const StructureRow* ProgramIndex::structure_at(const Position& at) const {
  const auto found = by_offset_.find(at.offset);
  return found == by_offset_.end() ? nullptr : &rows_[static_cast<std::size_t>(found->second)];
}

const ProgramRow& ProgramIndex::program_at(const Position& at) const {
  const ProgramRow* found = &programs_.front();
  for (const ProgramRow& program : programs_)
    if (program.begin.offset <= at.offset) found = &program;
  return *found;
}

/// Returns the innermost structure around a block. The rows are in the order of the file.
std::int32_t ProgramIndex::structure_around(const Position& at) const {
  std::int32_t around = -1;
  for (auto it = std::upper_bound(rows_.begin(), rows_.end(), at.offset,
                                  [](std::uint64_t offset, const StructureRow&row) { return offset < row.at.offset; });
       it != rows_.begin();) {
    --it;
    const auto index = static_cast<std::int32_t>(it - rows_.begin());
    if (it->misplaced) continue;
    if (begins(it->keyword)) around = it->at.offset == at.offset ? it->around : index;
    else if (it->keyword == Keyword::else_) {
      around = -1;
      for (std::int32_t i = index - 1; i >= 0; --i)
        if (rows_[static_cast<std::size_t>(i)].partner == index) around = i;
    } else around = it->at.offset == at.offset ? it->partner : it->around;
    break;
  }
  return around;
}

bool ProgramIndex::contains(std::int32_t outer, std::int32_t inner) const {
  if (outer < 0) return true;
  for (std::int32_t i = inner; i >= 0; i = rows_[static_cast<std::size_t>(i)].around)
    if (i == outer) return true;
  return false;
}

const LabelRow* ProgramIndex::label(const std::string& name, const Position& from, bool forward) const {
  const auto found = by_name_.find(name);
  if (found == by_name_.end()) return nullptr;
  const ProgramRow& own = program_at(from);
  const std::int32_t around = structure_around(from);
  const LabelRow* best = nullptr;
  for (const std::size_t index : found->second) {
    const LabelRow& row = labels_[index];
    if (&program_at(row.at) != &own || !contains(row.inside, around)) continue;
    const bool behind = row.at.offset > from.offset;
    if (behind != forward) continue;
    if (forward && best != nullptr) continue;
    best = &row;
  }
  return best;
}

const LabelRow* jump_target(const ProgramIndex& index, std::string_view jump, std::string label, const Position& from) {
  if (label.size() > 1 && label[0] == 'N' && is_digit(label[1])) label = "N" + std::to_string(std::strtoul(label.c_str() + 1, nullptr, 10));
  const LabelRow* target = nullptr;
  if (jump != "GOTOB") target = index.label(label, from, true);
  if (target == nullptr && jump != "GOTOF") target = index.label(label, from, false);
  return target;
}

const LabelRow* ProgramIndex::section_label(const std::string& name, const Position& from) const {
  const auto found = by_name_.find(name);
  if (found == by_name_.end()) return nullptr;
  const ProgramRow& own = program_at(from);
  const LabelRow *before = nullptr, *behind = nullptr;
  for (const std::size_t index : found->second) {
    const LabelRow& row = labels_[index];
    if (&program_at(row.at) != &own) continue;
    if (row.at.offset <= from.offset) before = &row;
    else if (behind == nullptr) behind = &row;
  }
  return before != nullptr ? before : behind;
}

const LabelRow* ProgramIndex::end_label(const Position& from) const {
  const auto found = by_name_.find("ENDLABEL");
  if (found == by_name_.end()) return nullptr;
  for (const std::size_t index : found->second)
    if (labels_[index].at.offset >= from.offset && &program_at(labels_[index].at) == &program_at(from)) return &labels_[index];
  return nullptr;
}

}  // namespace kadr::sinumerik
