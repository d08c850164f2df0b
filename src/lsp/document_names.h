#pragma once
// DocumentNames: the places of a document at which a program names something (view/structure/line_names.h). After a change only the changed
// lines are read again.

#include <memory>
#include <utility>
#include <vector>

#include "config/control/control_def.h"
#include "lsp/text_document.h"
#include "view/structure/line_names.h"

namespace kadr {

class DocumentNames {
 public:
  explicit DocumentNames(std::shared_ptr<const ControlDef> def) : def_(std::move(def)) {}

  /// Reads all lines, or the changed ones.
  void read(const TextDocument& document);
  void update(const TextDocument& document, const TextDocument::ChangedLines& changed);

  const ControlDef& control() const { return *def_; }
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
  std::shared_ptr<const ControlDef> def_;
  std::vector<std::vector<NamedPlace>> lines_;
};

}  // namespace kadr
