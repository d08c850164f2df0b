// Translates the errors of lang/block/format. Used by control_loader_words; tested by tests/config/control_file_test.cpp.

#include "config/control/control_loader.h"
#include "texts/control_file_grammar.h"

namespace kadr {
namespace {

/// The reasons for which lang/block/format rejects a format string. The room `lang` states them in English, because it must not include the
/// texts of `config`.
constexpr PlainText format_faults[] = {
    texts::control_file_grammar::nothing_after_end_of_block,
    texts::control_file_grammar::count_one_to_nine,
    texts::control_file_grammar::address_is_letter,
    texts::control_file_grammar::address_twice,
    texts::control_file_grammar::block_number_has_no_fraction,
    texts::control_file_grammar::sign_is_plus,
    texts::control_file_grammar::one_or_two_digits,
    texts::control_file_grammar::only_digits,
    texts::control_file_grammar::one_digit_before_point,
};

std::string translated_reason(std::string_view reason) {
  for (const PlainText fault : format_faults)
    if (plain_text(fault, Lang::en) == reason) return plain_text(fault);
  return std::string(reason);
}

}  // namespace

std::string format_fault_message(const std::string& fault) {
  constexpr std::string_view begin = "format \"", middle = "\" is not understood: ";
  const std::size_t at = fault.rfind(middle);
  if (!fault.starts_with(begin) || at == std::string::npos) return translated_reason(fault);
  return translated(texts::control_file_grammar::format_not_understood, fault.substr(begin.size(), at - begin.size()),
                    translated_reason(std::string_view(fault).substr(at + middle.size())));
}

}  // namespace kadr
