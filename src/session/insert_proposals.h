#pragma once
// InsertProposals: finds turning tools in the comments of a program. It is used by view/proposals. A person must check the proposals.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/setup/setup.h"
#include "config/tools/tool_geometry.h"
#include "lang/text/insert_comment.h"
#include "session/tool_proposals.h"

namespace kadr {

struct InsertProposal {
  InsertComment insert;
  std::optional<std::uint32_t> tool;  // that the comment names
  std::uint32_t line = 0;
  std::string text;
};

class InsertProposals {
 public:
  /// Reads the comments. `inch`: lengths without a unit are in inches. T0101 in a comment is tool 1.
  InsertProposals(const ProgramLines& lines, bool inch);

  /// Returns the proposal for a tool: of comments that name the tool, and then of those next to the block that calls it, the one that tells
  /// most.
  ///   called_at  line of the block that calls the tool; 0: the block is in another file
  std::optional<InsertProposal> of(std::uint32_t tool, std::uint32_t called_at) const;

 private:
  std::vector<InsertProposal> read_;
};

/// Returns the turning tool that a comment describes. What it does not tell is assumed: an insert of 80° with edges 10 mm long for turning
/// and boring, the usual entering angle of its shape, a nose of 0.4 mm, a groove 10 mm deep.
///   row  the row of the offset table that the program uses with the tool: its nose radius and its tip come first; nullptr: no row
///   returns  nullopt for a grooving tool of unknown width
std::optional<ToolGeometry> insert_of_comment(const InsertComment& comment, std::uint32_t tool, const ToolOffset* row);

}  // namespace kadr
