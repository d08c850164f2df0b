#pragma once
// What stands after an option: its name in the help, and whether it is one. A wrong one is refused in words, with the nearest right one.

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class Option;
}

namespace kadr::cli {

/// Named in the help: `--trace FILE`, in Russian `--trace ФАЙЛ`.
CLI::Option* takes(CLI::Option* option, const char* en, const char* ru);
CLI::Option* takes_file(CLI::Option* option);

/// A file that the program writes. A word that says "none" (`off`, `no`, `none`, `false`) and a name like an option's (`--help`, `-q`) are
/// refused with a hint: whoever types `--trace off` wants no file. "-" stands for standard output and passes.
CLI::Option* writes_file(CLI::Option* option);

/// One of these words, in small letters or capitals; named in the help `text|json|sarif`.
CLI::Option* one_of(CLI::Option* option, const std::vector<std::string>& words);

/// A word that `knows` knows; `words` are its names, to be listed where it does not.
CLI::Option* known_by(CLI::Option* option, const char* en, const char* ru, bool (*knows)(std::string_view),
                      const std::vector<std::string>& words);

/// A flag.
bool takes_nothing(const CLI::Option& option);

/// A number, a whole one, within its limits.
constexpr double any_number = std::numeric_limits<double>::infinity();
CLI::Option* number(CLI::Option* option, const char* en, const char* ru, double least = -any_number, double most = any_number);
CLI::Option* whole_number(CLI::Option* option, double least, double most);

CLI::Option* control_id(CLI::Option* option);
CLI::Option* machine_id(CLI::Option* option);

/// An encoding of text, by any of its names (lang/text/encoding.h).
CLI::Option* encoding(CLI::Option* option);

/// What a program is written in (lang/text/written_letters.h).
CLI::Option* written_letters(CLI::Option* option);

/// The first names of the encodings.
const std::vector<std::string>& encodings();

}  // namespace kadr::cli
