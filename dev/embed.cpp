// Writes OUT, a C++ file that holds each FILE: its text, and the table of a TOML file as packed_toml has it. A part of the build.
//
//   kadr_embed OUT ROOT FILE...     names are relative to ROOT

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>
#include <sstream>

#include "config/packed_toml.h"

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot be read");
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

/// `static const unsigned char NAME[]` with a 0 after: no compiler limits the length of a list.
void array(std::ostream& out, const std::string& name, std::string_view bytes) {
  fmt::print(out, "static const unsigned char {}[] = {{", name);
  for (std::size_t i = 0; i < bytes.size(); ++i) fmt::print(out, "{}{},", i % 64 == 0 ? "\n" : "", static_cast<unsigned char>(bytes[i]));
  fmt::print(out, "0}};\n");
}

void embed(std::ostream& out, const fs::path& root, std::span<char*> files) {
  fmt::print(out, "// Made by dev/embed.cpp.\n#include \"config/embedded.h\"\n\nnamespace kadr {{\n\n");
  std::string rows;
  for (std::size_t n = 0; n < files.size(); ++n) {
    const fs::path file = files[n];
    try {
      const std::string text = text_of(file);
      const std::string table = file.extension() == ".toml" ? kadr::packed(toml::parse(text, file.string())) : "";
      array(out, fmt::format("text_{}", n), text);
      array(out, fmt::format("table_{}", n), table);
      rows += fmt::format("    row(\"{}\", text_{}, table_{}),\n", file.lexically_relative(root).generic_string(), n, n);
    } catch (const toml::parse_error& error) {
      throw std::runtime_error(fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
    }
  }
  fmt::print(out,
             "\ntemplate <std::size_t T, std::size_t P>\n"
             "static EmbeddedFile row(std::string_view name, const unsigned char (&text)[T], const unsigned char (&table)[P]) {{\n"
             "  return {{name, {{reinterpret_cast<const char*>(text), T - 1}}, {{reinterpret_cast<const char*>(table), P - 1}}}};\n"
             "}}\n\n"
             "std::span<const EmbeddedFile> embedded_files() {{\n  static const EmbeddedFile table[] = {{\n{}  }};\n  return table;\n}}\n\n"
             "}}  // namespace kadr\n",
             rows);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "kadr_embed OUT ROOT FILE...\n";
    return 2;
  }
  try {
    std::ofstream out(argv[1], std::ios::binary);
    embed(out, argv[2], std::span(argv + 3, argv + argc));
    out.close();
    if (!out) throw std::runtime_error(std::string(argv[1]) + ": cannot be written");
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    fs::remove(argv[1]);  // half of it would pass for made
    return 1;
  }
}
