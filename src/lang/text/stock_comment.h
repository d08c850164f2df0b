#pragma once
// Reads the size of a turned blank from a comment: "(STOCK DIA 50 LENGTH 80)", "MATERIAL: 4.5OD X 2.75 ID X .53L", «ЗАГОТОВКА D50 L80». It
// is used by session/cutting/turning. A person must check the result.

#include <optional>
#include <string>
#include <string_view>

namespace kadr {

/// The sizes that the comment states, mm.
struct StockComment {
  std::optional<double> diameter, bore, length;
  bool empty() const { return !diameter && !bore && !length; }
};

/// Returns the sizes of the blank that the comment states with certainty; nothing if the comment is not about a blank.
///   text  UTF-8, without its brackets
///   inch  true: numbers without a unit are in inches; fractions are always in inches
StockComment read_stock_comment(std::string_view text, bool inch);

/// Returns the text of a line that describes a blank to a Denford lathe or its simulator, "BILLET X50.8 Z70" without its bracket `[`, with
/// X as the diameter and Z as the length; empty if the line is not such a line.
std::string billet_of(std::string_view line);

}  // namespace kadr
