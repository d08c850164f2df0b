// Finds the labels and corner elements of a file. Used by control/heidenhain.

#include "control/heidenhain/program_index.h"

#include <string_view>

#include "base/ascii.h"
#include "control/flow/program_file.h"
#include "lang/text/line_reader.h"

namespace kadr::heidenhain {
namespace {

constexpr std::size_t most_labels = 100'000;

bool begins(std::string_view text, std::string_view what) {
  if (text.size() < what.size()) return false;
  for (std::size_t i = 0; i < what.size(); ++i)
    if (to_upper(text[i]) != what[i]) return false;
  return true;
}

/// Returns the statement of a line, without skip mark and block number.
std::string_view statement_of(std::string_view line) {
  std::size_t at = 0;
  const auto blanks = [&] {
    while (at < line.size() && (static_cast<unsigned char>(line[at]) <= ' ' || line[at] == '/')) ++at;
  };
  blanks();
  while (at < line.size() && is_digit(line[at])) ++at;
  blanks();
  return line.substr(at);
}

/// Returns true for a block that moves in a contour: L, LP, C, CP, CR, CT, CTP, APPR, DEP.
bool is_motion(std::string_view text) {
  for (const std::string_view name : {"LP", "L", "CP", "CR", "CTP", "CT", "C", "APPR", "DEP"})
    if (begins(text, name) && text.size() > name.size() && static_cast<unsigned char>(text[name.size()]) <= ' ') return true;
  return false;
}

std::string label_of(std::string_view text) {
  std::size_t at = 3;
  while (at < text.size() && static_cast<unsigned char>(text[at]) <= ' ') ++at;
  if (at < text.size() && text[at] == '"') {
    const std::size_t end = text.find('"', at + 1);
    return std::string(text.substr(at, end == std::string_view::npos ? end : end - at));
  }
  std::uint32_t number = 0;
  const std::size_t begin = at;
  for (; at < text.size() && is_digit(text[at]) && number < 1'000'000; ++at)
    number = number * 10 + static_cast<std::uint32_t>(text[at] - '0');
  return at == begin ? std::string() : std::to_string(number);
}

}  // namespace

ProgramIndex::ProgramIndex(const ProgramFile& file) {
  LineReader lines(file.source());
  Line line;
  bool continues = false;
  std::optional<std::uint64_t> motion;
  bool ended = false, is_arc = false;
  Corner* open = nullptr;  // the corner whose second element comes next
  const auto note_motion = [&](bool arc) {
    motion = line.offset;
    is_arc = arc;
    if (open != nullptr) open->beside_arc = open->beside_arc || arc;
    open = nullptr;
  };
  const auto note_corner = [&] {
    if (motion) open = &corners_.emplace(*motion, Corner{{line.offset, line.number, 0}, is_arc}).first->second;
  };
  while (!ended && lines.next(line)) {
    end_ = lines.offset();
    std::string_view bytes = line.bytes;
    while (!bytes.empty() && static_cast<unsigned char>(bytes.back()) <= ' ') bytes.remove_suffix(1);
    const bool inside = continues;
    continues = !bytes.empty() && bytes.back() == '~';
    if (inside) continue;
    const std::string_view text = statement_of(bytes);
    if (text.size() < 2) continue;
    switch (to_upper(text[0])) {
      case 'B':
        if (begins(text, "BEGIN PGM")) has_begin_ = true;
        break;
      case 'E': ended = begins(text, "END PGM") && has_begin_; break;
      case 'R':
        if (begins(text, "RND")) note_corner();
        break;
      case 'C':
        if (is_motion(text)) note_motion(true);
        else if (begins(text, "CHF")) note_corner();
        break;
      case 'A':
      case 'D':
        if (is_motion(text)) note_motion(false);
        break;
      case 'L':
        if (is_motion(text)) {
          note_motion(false);
        } else if (begins(text, "LBL") && labels_.size() < most_labels) {
          const std::string name = label_of(text);
          if (name.empty() || name == "0") break;
          const auto [row, is_new] = labels_.emplace(name, Label{{line.offset, line.number, 0}, false});
          if (!is_new) row->second.twice = true;
          if (!is_new && twice_.empty()) twice_ = name;
        }
        break;
      default: break;
    }
  }
}

const ProgramIndex::Label* ProgramIndex::label(const std::string& name) const {
  const auto found = labels_.find(name);
  return found == labels_.end() ? nullptr : &found->second;
}

std::optional<ProgramIndex::Corner> ProgramIndex::corner_after(std::uint64_t offset) const {
  const auto found = corners_.find(offset);
  return found == corners_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace kadr::heidenhain
