#pragma once
// Splits a comment into words, numbers (in the code: figures) and signs, in their order: "T2 1-1/4" ENDMILL" becomes T 2 1 - 1/4 " ENDMILL.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kadr {

struct CommentToken {
  enum class Is : std::uint8_t { word, figure, sign };
  Is is = Is::sign;
  std::string text;          // text in capitals, also Russian letters; the text of a sign is one character
  double value = 0;          // value of the token if it is a number
  bool joined = false;       // no character is between this token and the previous one
  bool underscored = false;  // only `_` is between this token and the previous one
  // ---- properties of a figure
  bool has_point = false;     // the number has a decimal point or comma: 6. 0.5 6,5
  std::uint8_t decimals = 0;  // number of digits after the decimal point
  bool leads_point = false;   // the number starts with the decimal point: .5
  bool is_fraction = false;   // the number is a fraction of an inch with a denominator as on rulers: 3/8
  bool is_broken = false;     // the digits are not a valid number: 3/7, 3/4/21, 1.2.3
};

/// Splits a comment in UTF-8. Signs with the same meaning are unified: Ø and similar signs become the word DIA, × becomes X, ° becomes
/// DEG, dashes become `-`, inch marks become `"`.
std::vector<CommentToken> comment_tokens(std::string_view text);

}  // namespace kadr
