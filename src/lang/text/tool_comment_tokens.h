#pragma once
// The words, figures and signs of a comment, in order: "T2 1-1/4" ENDMILL" is T 2 1 - 1/4 " ENDMILL.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kadr {

struct CommentToken {
  enum class Is : std::uint8_t { word, figure, sign };
  Is is = Is::sign;
  std::string text;          // capitals, Russian ones too; of a sign one character
  double value = 0;          // of a figure
  bool joined = false;       // nothing stands between it and the token before
  bool underscored = false;  // nothing but `_` does
  // of a figure
  bool has_point = false;     // 6. 0.5 6,5
  std::uint8_t decimals = 0;  // digits behind it
  bool leads_point = false;   // .5
  bool is_fraction = false;   // 3/8: of an inch, with a denominator that rulers have
  bool is_broken = false;     // 3/7, 3/4/21, 1.2.3: no figure that is understood
};

/// `text`: UTF-8. Signs that mean the same are one: Ø and its likes are the word DIA, × is X, ° is DEG, dashes are `-`, inch marks `"`.
std::vector<CommentToken> comment_tokens(std::string_view text);

}  // namespace kadr
