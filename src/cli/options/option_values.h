#pragma once
// The values of options: their names in the help, and checks. The error for a wrong value suggests the nearest right one.

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class Option;
}

namespace kadr::cli {

/// Sets the name of the option's value in the help: `--trace FILE`, in Russian `--trace ФАЙЛ`. The caller passes `name` in the language of
/// the help (texts::values), here and in the functions below.
CLI::Option* takes(CLI::Option* option, const std::string& name);
CLI::Option* takes_file(CLI::Option* option);

/// The value is the name of an output file. Words that mean "none" (`off`, `no`, `none`, `false`) and values that look like an option
/// (`--help`, `-q`) are refused with a hint: a user who types `--trace off` wants no file. "-" means standard output.
CLI::Option* writes_file(CLI::Option* option);

/// The value is one of these words, in small or capital letters; the help shows them: `text|json|sarif`.
CLI::Option* one_of(CLI::Option* option, const std::vector<std::string>& words);

/// The value is a word for which `knows` returns true; the error message lists `words`.
CLI::Option* known_by(CLI::Option* option, const std::string& name, bool (*knows)(std::string_view), const std::vector<std::string>& words);

/// Returns true if the option is a flag, that is, has no value.
bool takes_nothing(const CLI::Option& option);

/// The value is a number (or a whole number) within limits.
constexpr double any_number = std::numeric_limits<double>::infinity();
CLI::Option* number(CLI::Option* option, const std::string& name, double least = -any_number, double most = any_number);
CLI::Option* whole_number(CLI::Option* option, double least, double most);

CLI::Option* control_id(CLI::Option* option);
CLI::Option* machine_id(CLI::Option* option);

/// The value is an encoding of text, by any of its names (lang/text/encoding.h).
CLI::Option* encoding(CLI::Option* option);

/// The value names the letters in which a program is written (lang/text/written_letters.h).
CLI::Option* written_letters(CLI::Option* option);

/// Returns the main name of each encoding.
const std::vector<std::string>& encodings();

}  // namespace kadr::cli
