#pragma once
// KlartextWords: reads the words behind the first one of a conversational block (spec/heidenhain 1.2, 1.3). Base of the parser.

#include <string_view>

#include "lang/klartext/klartext_expression.h"

namespace kadr {

class KlartextWords : public KlartextText {
 public:
  using KlartextText::KlartextText;

 protected:
  /// The sets of names that the words of a statement may have.
  enum class Names : std::uint8_t { motion, tool, plane, form, pattern, table, free };

  /// Reads words up to the end of the text, or up to `)` in a pattern.
  Status words(Names names, std::vector<KlartextWord>& to);
  /// Returns the longest name of the set at the place of reading; empty if there is none.
  std::string_view name_here(Names names) const;
  tl::unexpected<Alarm> unknown() const;

 private:
  Status word(Names names, std::vector<KlartextWord>& to);
  Status feed(std::vector<KlartextWord>& to, bool of_function);
  Status function_words(std::vector<KlartextWord>& to);
  Status signed_word(KlartextWord& word, std::vector<KlartextWord>& to);
  Status add(KlartextWord word, std::size_t begin, std::vector<KlartextWord>& to);
};

}  // namespace kadr
