#pragma once
// DocumentNames: the places of a document at which a program names something: block numbers, programs, labels, variables, tools. The places
// are found in the text alone, line by line, so that after a change only the changed lines are read again.
//
//   N10 G0 X0          block 10 is defined
//   M98 P200           program 200 is referred to
//   #101 = #100 + 1    variable 101 is defined, variable 100 is referred to

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "config/control/control_def.h"
#include "lsp/text_document.h"

namespace kadr {

enum class NameKind : std::uint8_t {
  block,     // a block number: N10, GOTO 10, G71 P10 Q20
  program,   // a program or subprogram: O200, M98 P200; PROC PART, PART(5)
  label,     // a label of LinuxCNC: O<name>, O100
  variable,  // #100, #<name>
  tool,      // T3
  heading,   // a comment that is alone in its line
  opens,     // the first line of a loop, a condition or a subprogram; the name is equal in its first and last line
  closes     // its last line
};

struct NamedPlace {
  NameKind kind = NameKind::block;
  bool defines = false;  // true: the place gives the name its meaning or its value
  Span where;            // bytes of the line: for a reference, the number or name alone, without its address
  std::string name;      // in a form that is equal for all spellings: "10" for N010, "<depth>" for #<Depth>
};

class DocumentNames {
 public:
  explicit DocumentNames(std::shared_ptr<const ControlDef> def) : def_(std::move(def)) {}

  /// Reads all lines, or the changed ones.
  void read(const TextDocument& document);
  void update(const TextDocument& document, const TextDocument::ChangedLines& changed);

  std::size_t lines() const { return lines_.size(); }
  const std::vector<NamedPlace>& line(std::size_t number) const { return lines_[number]; }
  /// Returns the place at a byte of a line; nullptr if there is none.
  const NamedPlace* at(std::size_t line, std::size_t byte) const;
  /// Returns the first and the last line, from 0, in which a name of this kind means the same as in `line`: block numbers and the local
  /// variables of custom macros belong to one program of the file, other names to the whole file.
  std::pair<std::size_t, std::size_t> scope(std::size_t line, const NamedPlace& place) const;

  struct Found {
    std::size_t line = 0;
    const NamedPlace* place = nullptr;
  };
  /// Returns all places of the same name within its scope, in the order of the text.
  std::vector<Found> all_of(std::size_t line, const NamedPlace& place) const;

 private:
  std::vector<NamedPlace> names_of(std::string_view line) const;

  std::shared_ptr<const ControlDef> def_;
  std::vector<std::vector<NamedPlace>> lines_;
};

}  // namespace kadr
