#pragma once
// ProgramIndex: the labels, control structures and programs of one file (spec/sinumerik 1, 8). A file is read once, when the first jump,
// structure or call needs it.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/span.h"
#include "lang/block/block.h"

namespace kadr {
class ProgramFile;
}

namespace kadr::sinumerik {

enum class Keyword : std::uint8_t { if_, else_, endif, while_, endwhile, for_, endfor, loop, endloop, repeat, until, none };
/// Returns the keyword of the block's structure; `none` if the block begins, divides and ends no structure.
Keyword structure_of(std::string_view statement);

inline constexpr std::int32_t deepest_structure = 16;

/// A block that begins, divides or ends a structure.
struct StructureRow {
  Keyword keyword = Keyword::none;
  Position at, after;         // position of the block, and of the next one
  std::int32_t partner = -1;  // IF: ELSE, or ENDIF; ELSE: ENDIF; ENDIF: IF; loops: the other end; -1: missing
  std::int32_t around = -1;   // index of the structure that contains this one; -1: none
  std::int32_t depth = 0;
  bool misplaced = false;  // an end or ELSE that belongs to no open structure
};

struct LabelRow {
  std::string name;  // in upper case; N10 for a block number
  Position at, after;
  std::int32_t inside = -1;  // innermost structure around the block
};

/// A program of the file: from `begin` to `end`, the position after its last block.
struct ProgramRow {
  std::string name;  // without _N_ and _MPF, in upper case; empty: the file has no % line, so its name is the program's
  Position begin, end;
};

/// A program with this name among the files of the run.
struct FoundProgram {
  std::uint16_t reader = 0;
  Position begin;
};

class ProgramIndex {
 public:
  explicit ProgramIndex(const ProgramFile& file);

  const StructureRow* structure_at(const Position& at) const;
  /// Returns true if an end of a structure that does not fit stands behind the row: the structure is closed wrongly, not left open.
  bool misplaced_after(const StructureRow& row) const;
  const StructureRow& row(std::int32_t index) const { return rows_[static_cast<std::size_t>(index)]; }
  /// Returns the program that contains the block.
  const ProgramRow& program_at(const Position& at) const;
  const std::vector<ProgramRow>& programs() const { return programs_; }
  /// Returns the nearest label behind the block (forward), or before it; only in the same program, and not inside a structure that does not
  /// contain the block.
  const LabelRow* label(const std::string& name, const Position& from, bool forward) const;
  /// Returns the label, whatever contains it: first before the block, then behind it.
  const LabelRow* section_label(const std::string& name, const Position& from) const;
  /// Returns the first ENDLABEL behind a block.
  const LabelRow* end_label(const Position& from) const;

 private:
  std::int32_t structure_around(const Position& at) const;
  bool contains(std::int32_t outer, std::int32_t inner) const;

  std::vector<StructureRow> rows_;
  std::unordered_map<std::uint64_t, std::int32_t> by_offset_;
  std::vector<LabelRow> labels_;
  std::map<std::string, std::vector<std::size_t>> by_name_;
  std::vector<ProgramRow> programs_;
};

/// Returns where a jump goes: GOTOF forward, GOTOB backward, GOTO and GOTOC forward, else backward; nullptr if the label is missing there.
///   label  in upper case; N010 is the block number N10
const LabelRow* jump_target(const ProgramIndex& index, std::string_view jump, std::string label, const Position& from);

/// Returns the text in capitals.
std::string in_capitals(std::string_view text);

/// Returns the name of a program as calls and % lines write it, in upper case: without %, _N_, a path, and _MPF, _SPF, .MPF, .SPF.
std::string plain_program_name(std::string_view written);

}  // namespace kadr::sinumerik
