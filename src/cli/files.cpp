// Whole files in, for commands whose input is small. For the rest of cli.

#include "cli/files.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>

#include "cli/options.h"
#include "config/read_file.h"
#include "config/told.h"

namespace kadr::cli {

std::optional<std::string> read_all(const std::string& name, std::size_t most) {
  std::string text;
  std::ifstream file;
  if (name != "-") file.open(name, std::ios::binary);
  std::istream& in = name == "-" ? std::cin : file;
  char piece[1 << 16];
  while (in.read(piece, sizeof piece) || in.gcount() > 0) {
    text.append(piece, static_cast<std::size_t>(in.gcount()));
    if (text.size() > most) {
      complain(told(fmt::format("{}: longer than {} MiB", name, most >> 20), fmt::format("{}: длиннее {} МиБ", name, most >> 20)));
      return std::nullopt;
    }
  }
  if (name != "-" && (!file.is_open() || file.bad())) {
    complain(fmt::format("{}: {}", name, told_errno(errno)));
    return std::nullopt;
  }
  return text;
}

std::optional<std::string> read_small(const std::string& name, std::size_t most) {
  if (name == "-") return read_all(name, most);
  auto text = read_file(name, most);
  if (!text) {
    complain(text.error());
    return std::nullopt;
  }
  return std::move(*text);
}

}  // namespace kadr::cli
