// Build tool: writes OUT, a C++ file that contains the text of each FILE. For a TOML file, OUT also contains its table in the form that
// packed_toml reads.
//
//   kadr_embed OUT ROOT FILE...     the names of the embedded files are relative to ROOT
//   kadr_embed --tables OUT ROOT FILE...  the same, but of the files in ROOT/controls only the tables: the page loads them over a network
//   kadr_embed --page OUT FOLDER    embeds all files of a folder, which may be missing, for server/page_files
//   kadr_embed --report OUT FOLDER  embeds all files of a folder, which may be missing, for cli/report_files

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <vector>

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

/// Writes `static const unsigned char NAME[]`, terminated by a 0. It is a list of numbers, because compilers limit the length of a string.
void array(std::ostream& out, const std::string& name, std::string_view bytes) {
  fmt::print(out, "static const unsigned char {}[] = {{", name);
  for (std::size_t i = 0; i < bytes.size(); ++i) fmt::print(out, "{}{},", i % 64 == 0 ? "\n" : "", static_cast<unsigned char>(bytes[i]));
  fmt::print(out, "0}};\n");
}

/// The target of the files: the header to include, and the function that returns them.
struct Target {
  const char *header, *function;
};

void embed(std::ostream& out, const Target& target, const fs::path& root, const std::vector<fs::path>& files, bool only_tables = false) {
  fmt::print(out, "// Made by dev/embed.cpp.\n#include \"{}\"\n\nnamespace kadr {{\n\n", target.header);
  std::string rows;
  for (std::size_t n = 0; n < files.size(); ++n) {
    const fs::path file = files[n];
    try {
      const std::string text = text_of(file);
      const std::string table = file.extension() == ".toml" ? kadr::packed(toml::parse(text, file.string())) : "";
      const bool only_table = only_tables && file.extension() == ".toml" && file.parent_path() == root / "controls";
      array(out, fmt::format("text_{}", n), only_table ? "" : text);
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
             "[[maybe_unused]] static EmbeddedFile row(std::string_view name, const unsigned char (&text)[T], const unsigned char "
             "(&table)[P]) {{\n"
             "  return {{name, {{reinterpret_cast<const char*>(text), T - 1}}, {{reinterpret_cast<const char*>(table), P - 1}}}};\n"
             "}}\n\n"
             "std::span<const EmbeddedFile> {}() {{\n  static const std::initializer_list<EmbeddedFile> table = {{\n{}  }};\n  return "
             "{{table.begin(), table.size()}};\n}}\n\n"
             "}}  // namespace kadr\n",
             target.function, rows);
}

/// Returns all files of a folder, sorted by name; none if the folder is missing.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  const bool page = argc == 4 && std::string_view(argv[1]) == "--page", report = argc == 4 && std::string_view(argv[1]) == "--report";
  const bool only_tables = argc > 3 && std::string_view(argv[1]) == "--tables";
  if (argc < 3) {
    std::cerr << "kadr_embed [--tables] OUT ROOT FILE... | --page OUT FOLDER | --report OUT FOLDER\n";
    return 2;
  }
  const int first = page || report || only_tables ? 2 : 1;
  const char* const name = argv[first];
  try {
    std::ofstream out(name, std::ios::binary);
    if (page) embed(out, {"server/page_files.h", "page_files"}, argv[3], files_in(argv[3]));
    else if (report) embed(out, {"cli/report_files.h", "report_files"}, argv[3], files_in(argv[3]));
    else embed(out, {"config/embedded.h", "embedded_files"}, argv[first + 1], {argv + first + 2, argv + argc}, only_tables);
    out.close();
    if (!out) throw std::runtime_error(std::string(name) + ": cannot be written");
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    fs::remove(name);  // an incomplete OUT would look complete to the build
    return 1;
  }
}
