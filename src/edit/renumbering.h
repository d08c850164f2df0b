#pragma once
// Renumbering: gives the blocks of a program new numbers, and finds the words that name a block: GOTO 100, M99 P100, G71 P10 Q20.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tl/expected.hpp>

#include "base/stop_token.h"
#include "edit/edits.h"
#include "edit/line_changes.h"
#include "lang/block/block_reader.h"

namespace kadr {

struct ControlDef;

/// Why a program cannot be edited in the way that is asked for, and the line that prevents it.
struct EditFault {
  std::uint32_t line = 0;  // 0: the fault belongs to no line
  std::string why;
};

using EditStatus = tl::expected<void, EditFault>;

class Renumbering {
 public:
  /// Reads the program once or twice. Memory grows with the number of references, not with the length of the program.
  ///   def     must outlive this object
  ///   returns a fault if a block is named by an expression, or if a number has too many digits for the control
  static tl::expected<Renumbering, EditFault> of(const std::shared_ptr<ByteSource>& source, std::optional<Encoding> encoding,
                                                 const ControlDef& def, const Numbering& numbering, const StopToken& stop);

  /// Adds the changes of one block: its number, and the numbers of the blocks that it names. Must be called for each block in order.
  tl::expected<void, EditFault> change(const Block& block, LineChanges& to);

 private:
  struct Reference {
    std::uint32_t number = 0;
    std::string_view written;  // the number as the block states it
    Span where;
    bool may_be_elsewhere = false;  // the block may be in another program of the file: that of the caller
  };
  Renumbering(const ControlDef& def, const Numbering& numbering) : def_(&def), numbering_(numbering) {}
  void begin() { program_ = 0, next_ = numbering_.first, in_section_ = false; }
  void note_program(const Block& block);
  bool gets_number(const Block& block) const;
  std::string number_word(const Block& block, std::uint32_t number) const;
  tl::expected<std::vector<Reference>, EditFault> references(const Block& block) const;
  std::optional<std::uint32_t> new_number(const Reference& reference) const;

  const ControlDef* def_;
  Numbering numbering_;
  std::set<std::uint32_t> named_;                                           // numbers that some block names
  std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> new_of_;  // program → old number → new number, for numbers in named_
  std::uint32_t program_ = 0;                                               // count of the programs of the file so far
  std::uint32_t next_ = 0;
  bool in_section_ = false;
};

}  // namespace kadr
