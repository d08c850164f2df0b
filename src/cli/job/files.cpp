// Reads whole files, for commands with small input files. This file is used by the rest of cli.

#include "cli/job/files.h"

#include <fmt/core.h>

#include <cerrno>

#include "cli/options/options.h"
#include "config/read_file.h"
#include "lang/text/text_spool.h"
#include "texts/job.h"

namespace kadr::cli {

std::optional<std::string> read_all(const std::string& name, std::size_t most) {
  const auto source = open_file(name);
  if (!source) {
    complain(fmt::format("{}: {}", name, errno_message(errno)));
    return std::nullopt;
  }
  std::string text;
  const bool is_whole = each_piece(*source, [&](std::string_view piece) {
    text += piece;
    return text.size() <= most;
  });
  if (is_whole) return text;
  complain(translated(texts::job::longer_than_mib, name, most >> 20));
  return std::nullopt;
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
