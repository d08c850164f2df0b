// Describes a comparison in words. Used by view/page/page_compare; tested by tests/compare/comparison_text_test.cpp.

#include "compare/comparison_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace kadr {
namespace {

struct KindText {
  const char *name, *en, *ru;
};
constexpr std::array<KindText, 9> kinds = {{{"way", "another way", "другой путь"},
                                            {"move", "kind of motion", "вид движения"},
                                            {"feed", "feed", "подача"},
                                            {"tool", "tool", "инструмент"},
                                            {"spindle", "spindle", "шпиндель"},
                                            {"coolant", "coolant", "охлаждение"},
                                            {"corners", "how corners are gone round", "как проходятся углы"},
                                            {"act", "what is done between", "что делается между движениями"},
                                            {"end", "how it ends", "чем кончается"}}};

}  // namespace

const char* name_of(CourseDifference::Kind kind) { return kinds[std::size_t(kind)].name; }

std::string sentence_of(const CourseDifference& d, Lang lang) {
  const bool ru = lang == Lang::ru;
  const KindText& kind = kinds[std::size_t(d.kind)];
  const auto value = [&](const std::string& says) { return says.empty() ? std::string(ru ? "ничего" : "nothing") : says; };
  std::string text = ru ? kind.ru : kind.en;
  if (d.kind != CourseDifference::Kind::way) return text + fmt::format(": {} — {}", value(d.a_value), value(d.b_value));
  text += ru ? fmt::format(", расходятся до {:.4g} мм", d.distance) : fmt::format(", up to {:.4g} mm apart", d.distance);
  if (!d.a_value.empty() || !d.b_value.empty()) text += fmt::format("; {} — {}", value(d.a_value), value(d.b_value));
  return text;
}

std::string summary_of(const Comparison& c, Lang lang) {
  const bool ru = lang == Lang::ru;
  if (c.cancelled) return ru ? "сравнение прервано" : "interrupted";
  if (c.equal())
    return ru ? fmt::format("одинаковы: движений {}, наибольшее расстояние {:.4f} мм", c.moves_a, c.greatest)
              : fmt::format("equal: {} motions, greatest distance {:.4f} mm", c.moves_a, c.greatest);
  double most = 0;
  for (const CourseDifference& d : c.differences) most = std::max(most, d.distance);
  std::string text =
      ru ? fmt::format("различий: {}", c.differences.size() + c.more) : fmt::format("{} differences", c.differences.size() + c.more);
  if (most > 0) text += ru ? fmt::format(", расходятся до {:.4g} мм", most) : fmt::format(", up to {:.4g} mm apart", most);
  if (c.lost) text += ru ? "; после последнего общего места не найдено" : "; after the last one no place in common was found";
  return text;
}

}  // namespace kadr
