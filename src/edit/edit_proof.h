#pragma once
// EditProof: compares an edited program with the old one, of which exactly the edits are expected to be different. The old program runs
// with the set-up in which its work offsets, tools and zeros are those that the new program uses, and the feeds, speeds and tool numbers of
// its course are changed as the edits say (CompareRules::expected_of_a). Everything else must be equal.

#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "compare/comparison.h"
#include "convert/conversion.h"
#include "edit/edits.h"

namespace kadr {

struct EditSpec {
  ConversionSpec::Opens old_program;        // opens the program, with a given set-up
  ConversionSpec::OpensText new_program;    // opens a text under the same control, with a given set-up
  std::shared_ptr<ByteSource> source_text;  // text of the program, UTF-8
  Setup setup;                              // the set-up with which the program begins
  Edits edits;
  double tolerance = 0;  // permitted distance of the paths, mm; 0: what the rounding of the changed words may do
  StopToken stop{};
};

struct EditProof {
  Comparison comparison;   // of the last state in which both were run: the first in which they differ, or the last of all
  std::size_t states = 0;  // number of set-ups from which both did the same
  bool is_proven() const { return comparison.equal() && !comparison.stopped_a && !comparison.stopped_b; }
};

/// Compares from the given set-up and from others, with values for the offsets that the set-up does not state (convert/open_states).
///   returns  an error sentence if a session could not be opened
tl::expected<EditProof, std::string> prove_edit(const EditSpec& spec, const std::shared_ptr<ByteSource>& text);

}  // namespace kadr
