// Describes a comparison in words. Used by view/page/page_compare; tested by tests/compare/comparison_text_test.cpp.

#include "compare/comparison_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "texts/comparison.h"

namespace kadr {
namespace {

struct KindText {
  const char* name;
  PlainText text;
};
constexpr std::array<KindText, 9> kinds = {{{"way", texts::comparison::another_way},
                                            {"move", texts::comparison::kind_of_motion},
                                            {"feed", texts::comparison::feed},
                                            {"tool", texts::comparison::tool},
                                            {"spindle", texts::comparison::spindle},
                                            {"coolant", texts::comparison::coolant},
                                            {"corners", texts::comparison::corners},
                                            {"act", texts::comparison::acts_between},
                                            {"end", texts::comparison::ending}}};

}  // namespace

const char* name_of(CourseDifference::Kind kind) { return kinds[std::size_t(kind)].name; }

std::string sentence_of(const CourseDifference& d, Lang lang) {
  const auto value = [&](const std::string& text) { return text.empty() ? translated_in(lang, texts::comparison::nothing) : text; };
  std::string text = translated_in(lang, kinds[std::size_t(d.kind)].text);
  if (d.kind != CourseDifference::Kind::path) return text + fmt::format(": {} — {}", value(d.a_value), value(d.b_value));
  text = translated_in(lang, texts::comparison::apart, text, d.distance);
  if (!d.a_value.empty() || !d.b_value.empty()) text += fmt::format("; {} — {}", value(d.a_value), value(d.b_value));
  return text;
}

std::string summary_of(const Comparison& c, Lang lang) {
  if (c.cancelled) return translated_in(lang, texts::comparison::interrupted);
  if (c.equal()) return translated_in(lang, texts::comparison::equal, c.moves_a, c.greatest);
  double most = 0;
  for (const CourseDifference& d : c.differences) most = std::max(most, d.distance);
  std::string text = translated_in(lang, texts::comparison::differences, c.differences.size() + c.more);
  if (most > 0) text = translated_in(lang, texts::comparison::apart, text, most);
  if (c.lost) text = translated_in(lang, texts::comparison::lost, text);
  return text;
}

}  // namespace kadr
