// Build tool: writes the texts of texts/*.toml as C++: a header for each section, with a constant for each id, and one table of all
// languages. Tested by tests/texts.py.
//
//   kadr_embed_texts OUT texts/en.toml texts/OTHER.toml...
//
// Writes OUT/texts/SECTION.h for each section of the first file, and OUT/texts.cpp for config/texts. A header that would not change is not
// touched, so that a new text rebuilds only the files that use its section.

#include <fmt/args.h>
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// One text of one language: a single form, or one form for each grammatical number (singular, plurals).
struct Entry {
  std::vector<std::string> forms;
  bool plural = false;
};

using Section = std::map<std::string, Entry>;

struct Language {
  std::string id, name, plurals;
  std::map<std::string, Section> sections;
};

[[noreturn]] void fail(const std::string& where, const std::string& what) { throw std::runtime_error(where + ": " + what); }

bool is_identifier(const std::string& name) {
  static const std::set<std::string> keywords = {
      "and",     "auto",    "bool",     "break",  "case",     "catch",    "char",      "class",    "const",     "continue",
      "default", "delete",  "do",       "double", "else",     "enum",     "export",    "extern",   "false",     "float",
      "for",     "friend",  "goto",     "if",     "inline",   "int",      "long",      "mutable",  "namespace", "new",
      "not",     "or",      "private",  "public", "register", "return",   "short",     "signed",   "sizeof",    "static",
      "struct",  "switch",  "template", "this",   "throw",    "true",     "try",       "typedef",  "union",     "unsigned",
      "using",   "virtual", "void",     "while",  "xor",      "operator", "protected", "requires", "concept"};
  return !name.empty() && name.front() >= 'a' && name.front() <= 'z' && !keywords.contains(name) &&
         std::all_of(name.begin(), name.end(), [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

/// Returns the placeholders of a text, such as "{}" or "{0:.3f}". As in {fmt}, "{{" is an escaped brace and no placeholder.
std::vector<std::string> placeholders(const std::string& text) {
  std::vector<std::string> found;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '{') continue;
    if (text.compare(i, 2, "{{") == 0) {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    if (end < text.size() && text[end] == ':') end = text.find('}', end);
    if (end < text.size() && text[end] == '}') found.push_back(text.substr(i, end - i + 1));
  }
  return found;
}

/// Returns true if {fmt} can format the text. As argument i it gets `number` if is_number[i] is true, else a string.
template <typename Number>
bool is_understood(const std::string& text, const std::vector<bool>& is_number, Number number) try {
  fmt::dynamic_format_arg_store<fmt::format_context> arguments;
  for (const bool one : is_number) one ? arguments.push_back(number) : arguments.push_back("a");
  (void)fmt::vformat(text, arguments);
  return true;
} catch (const fmt::format_error&) {
  return false;
}

/// Returns the number of arguments that a text needs. A text without placeholders is never formatted, so its braces are printed as they
/// are.
std::size_t holes_of(const std::string& text, const std::string& where) {
  std::size_t next = 0, holes = 0;
  const std::vector<std::string> found = placeholders(text);
  for (const std::string& hole : found) {
    const bool numbered = hole[1] >= '0' && hole[1] <= '9';
    if (numbered && next > 0) fail(where, "numbered and unnumbered placeholders together");
    holes = std::max(holes, numbered ? std::stoul(hole.substr(1)) + 1 : ++next);
  }
  if (holes == 0) return 0;
  // Checks with {fmt} itself that the text can be formatted. A placeholder such as "{:.3f}" gets a number as argument, others get a string.
  std::vector<bool> wants_number(holes);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::size_t nth = next > 0 ? i : std::stoul(found[i].substr(1));
    const std::size_t colon = found[i].find(':');
    if (colon != std::string::npos && !is_understood("{" + found[i].substr(colon), {false}, 0)) wants_number[nth] = true;
  }
  if (!is_understood(text, wants_number, 15) && !is_understood(text, wants_number, 1.5))
    fail(where, "{fmt} does not understand its braces; one that is no placeholder is doubled");
  return holes;
}

std::size_t holes_of(const Entry& entry, const std::string& where) {
  std::size_t holes = 0;
  for (const std::string& form : entry.forms) holes = std::max(holes, holes_of(form, where));
  return entry.plural ? std::max<std::size_t>(holes, 1) - 1 : holes;  // the first argument of a plural selects the form
}

Language read_language(const fs::path& file) {
  Language language{file.stem().string(), "", "", {}};
  const toml::table root = toml::parse_file(file.string());
  for (const auto& [key, node] : root) {
    const std::string section(key.str());
    const toml::table* const table = node.as_table();
    if (table == nullptr || !is_identifier(section)) fail(file.string(), section + ": not a section");
    if (section == "language") {
      language.name = (*table)["name"].value_or("");
      language.plurals = (*table)["plurals"].value_or("");
      continue;
    }
    for (const auto& [id, value] : *table) {
      const std::string where = fmt::format("{}:{}: {}", file.string(), value.source().begin.line, id.str());
      if (!is_identifier(std::string(id.str()))) fail(where, "an id has small letters, digits and _, and is no word of C++");
      Entry entry;
      if (const auto* const list = value.as_array()) {
        entry.plural = true;
        for (const auto& form : *list) entry.forms.push_back(form.value_or(std::string()));
      } else {
        entry.forms.push_back(value.value_or(std::string()));
      }
      for (const std::string& form : entry.forms)
        if (form.empty()) fail(where, "a text is missing");
      language.sections[section].emplace(id.str(), entry);
    }
  }
  return language;
}

std::size_t forms_of(const Language& language) {
  if (language.plurals == "one_other") return 2;
  if (language.plurals == "slavic") return 3;
  if (language.plurals == "none") return 1;
  fail(language.id, "[language] plurals: one_other, slavic or none");
}

/// Compares a translation with the original text: placeholders and number of forms.
void check(const Language& language, const std::string& id, const Entry& own, const Entry& original) {
  const std::string where = fmt::format("texts/{}.toml: {}", language.id, id);
  if (own.plural != original.plural) fail(where, "one language has forms for numbers, the other has none");
  if (own.plural && own.forms.size() != forms_of(language)) fail(where, fmt::format("{} forms are wanted", forms_of(language)));
  if (holes_of(own, where) != holes_of(original, where)) fail(where, "its placeholders are not those of the original");
}

std::string literal(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '\n') out += "\\n";
    else if (c == '"' || c == '\\') out += std::string("\\") + c;
    else out += c;
  }
  return out + "\"";
}

std::string literal(const Entry& entry) {
  std::string out;
  for (const std::string& form : entry.forms) out += (out.empty() ? "" : " \"\\0\" ") + literal(form);
  return out;
}

void write_if_changed(const fs::path& file, const std::string& content) {
  std::ostringstream before;
  if (std::ifstream in(file, std::ios::binary); in) before << in.rdbuf();
  if (before.str() == content && fs::exists(file)) return;
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << content;
}

std::string header_of(const std::string& section, std::size_t number, const Section& entries) {
  std::string text = fmt::format(
      "#pragma once\n// Made by dev/embed_texts.cpp from texts/*.toml.\n\n#include \"config/texts.h\"\n\nnamespace kadr::texts::{} {{\n\n",
      section);
  std::size_t row = 0;
  for (const auto& [id, entry] : entries) {
    const std::string where = section + "." + id;
    text += fmt::format("inline constexpr {}<{}> {}{{{}, {}}};\n", entry.plural ? "PluralId" : "TextId", holes_of(entry, where), id, number,
                        row++);
  }
  return text + fmt::format("\n}}  // namespace kadr::texts::{}\n", section);
}

std::string table_of(const std::vector<Language>& languages) {
  const Language& original = languages.front();
  std::string text = "// Made by dev/embed_texts.cpp from texts/*.toml.\n#include \"config/texts.h\"\n\nnamespace kadr {\nnamespace {\n\n";
  for (const Language& language : languages) {
    std::string sections;
    for (const auto& [section, entries] : original.sections) {
      text += fmt::format("constexpr const char* {}_{}[] = {{\n", language.id, section);
      for (const auto& [id, entry] : entries) {
        const auto own_section = language.sections.find(section);
        const Entry* own = nullptr;
        if (own_section != language.sections.end())
          if (const auto at = own_section->second.find(id); at != own_section->second.end()) own = &at->second;
        if (own != nullptr) check(language, section + "." + id, *own, entry);
        text += "    " + literal(own != nullptr ? *own : entry) + ",\n";
      }
      text += "};\n";
      sections += fmt::format("    {}_{},\n", language.id, section);
    }
    text += fmt::format("constexpr const char* const* {}_sections[] = {{\n{}}};\n\n", language.id, sections);
  }
  text += "constexpr TextLanguage table[] = {\n";
  for (const Language& language : languages)
    text += fmt::format("    {{{}, {}, PluralRule::{}, {}_sections}},\n", literal(language.id), literal(language.name), language.plurals,
                        language.id);
  return text + "};\n\n}  // namespace\n\nstd::span<const TextLanguage> text_languages() { return table; }\n\n}  // namespace kadr\n";
}

void check_ids(const std::vector<Language>& languages) {
  for (const Language& language : languages) {
    (void)forms_of(language);
    if (language.name.empty()) fail(language.id, "[language] name is missing");
    for (const auto& [section, entries] : language.sections)
      for (const auto& [id, entry] : entries) {
        const auto at = languages.front().sections.find(section);
        if (at == languages.front().sections.end() || !at->second.contains(id))
          fail(fmt::format("texts/{}.toml", language.id), fmt::format("{}.{} is not in texts/{}.toml", section, id, languages.front().id));
      }
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 3) return std::cerr << "usage: kadr_embed_texts OUT texts/en.toml texts/OTHER.toml...\n", 2;
  const fs::path out = argv[1];
  std::vector<Language> languages;
  for (int i = 2; i < argc; ++i) languages.push_back(read_language(argv[i]));
  check_ids(languages);
  std::size_t number = 0;
  for (const auto& [section, entries] : languages.front().sections)
    write_if_changed(out / "texts" / (section + ".h"), header_of(section, number++, entries));
  write_if_changed(out / "texts.cpp", table_of(languages));
  return 0;
} catch (const toml::parse_error& error) {
  std::cerr << *error.source().path << ":" << error.source().begin.line << ": " << error.description() << '\n';
  return 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
