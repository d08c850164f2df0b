#pragma once
// Defines the values of options: their names in the help, and their checks. The error message for a wrong value suggests the most similar
// correct value.

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class Option;
}

namespace kadr::cli {

/// Sets the name of the option's value in the help: `--trace FILE`, in Russian `--trace ФАЙЛ`. In this function and those below, the caller
/// passes `name` in the language of the help (texts::values).
CLI::Option* takes(CLI::Option* option, const std::string& name);
CLI::Option* takes_file(CLI::Option* option);

/// Makes the option accept the name of an output file; "-" means standard output. Words that mean "none" (`off`, `no`, `none`, `false`) and
/// values that look like an option (`--help`, `-q`) are refused with a hint, since a user who types `--trace off` wants no file.
CLI::Option* writes_file(CLI::Option* option);

/// Makes the option accept only the words of the list, in small or capital letters. The help shows the words as `text|json|sarif`.
CLI::Option* one_of(CLI::Option* option, const std::vector<std::string>& words);

/// Makes the option accept the words for which the function `knows` returns true. The error message for any other word lists `words`.
CLI::Option* known_by(CLI::Option* option, const std::string& name, bool (*knows)(std::string_view), const std::vector<std::string>& words);

/// True if the option is a flag, which has no value.
bool takes_nothing(const CLI::Option& option);

/// Makes the option accept a number (or only a whole number) within limits.
constexpr double any_number = std::numeric_limits<double>::infinity();
CLI::Option* number(CLI::Option* option, const std::string& name, double least = -any_number, double most = any_number);
CLI::Option* whole_number(CLI::Option* option, double least, double most);

CLI::Option* control_id(CLI::Option* option);
CLI::Option* machine_id(CLI::Option* option);

/// Makes the option accept the name of a text encoding, which may have several names (lang/text/encoding.h).
CLI::Option* encoding(CLI::Option* option);

/// Makes the option accept a name for the characters that a written program may contain: "ascii", or an encoding
/// (lang/text/written_letters.h).
CLI::Option* written_letters(CLI::Option* option);

/// Returns the main name of each supported encoding.
const std::vector<std::string>& encodings();

}  // namespace kadr::cli
