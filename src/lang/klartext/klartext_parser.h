#pragma once
// Reads the text of a conversational block into a KlartextBlock (spec/heidenhain 1 to 13).

#include <string_view>

#include "base/result.h"
#include "lang/klartext/klartext_block.h"

namespace kadr {

/// Reads the statement of a block.
///   text       of the block; it has several lines if the block goes on behind `~`
///   statement  without the block number
///   alarms     expression_syntax, bracket_not_closed, nesting_too_deep, index_range, name_unknown, address_twice
Result<KlartextBlock> read_klartext_block(std::string_view text, Span statement);

}  // namespace kadr
