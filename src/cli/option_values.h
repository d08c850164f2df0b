#pragma once
// The values of options: their names in the help, and checks. A wrong value is refused in words, with the nearest right one.

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class Option;
}

namespace kadr::cli {

/// Sets the name of the value in the help: `--trace FILE`, in Russian `--trace ФАЙЛ`.
CLI::Option* takes(CLI::Option* option, const char* en, const char* ru);
CLI::Option* takes_file(CLI::Option* option);

/// The value is a file that is written. A word that means "none" (`off`, `no`, `none`, `false`) or a name like an option's (`--help`, `-q`)
/// is refused with a hint: a user who types `--trace off` wants no file. "-" means standard output and is accepted.
CLI::Option* writes_file(CLI::Option* option);

/// The value is one of these words, in small or capital letters; the help shows `text|json|sarif`.
CLI::Option* one_of(CLI::Option* option, const std::vector<std::string>& words);

/// The value is a word that `knows` accepts; `words` are listed if it does not.
CLI::Option* known_by(CLI::Option* option, const char* en, const char* ru, bool (*knows)(std::string_view),
                      const std::vector<std::string>& words);

/// Returns true if the option is a flag.
bool takes_nothing(const CLI::Option& option);

/// The value is a number, or a whole number, within limits.
constexpr double any_number = std::numeric_limits<double>::infinity();
CLI::Option* number(CLI::Option* option, const char* en, const char* ru, double least = -any_number, double most = any_number);
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
