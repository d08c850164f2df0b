// Reads `encoding` of a control file, and [convert]: the M functions of other controls that correspond to the M functions of this control
// (config/machine/machine_codes).

#include <algorithm>

#include "config/control/control_loader.h"
#include "config/machine/machine_codes.h"
#include "texts/control_file.h"

namespace kadr {

using toml_tools::place;

namespace {

/// Converts "M27" to 27; returns nullopt if the text is not an M code.
std::optional<std::uint32_t> m_code(std::string_view text) {
  constexpr std::size_t max_digits = 8;
  if (text.size() < 2 || text.size() > max_digits + 1 || text[0] != 'M' ||
      text.find_first_not_of("0123456789", 1) != std::string_view::npos)
    return std::nullopt;
  std::uint32_t code = 0;
  for (const char digit : text.substr(1)) code = 10 * code + static_cast<std::uint32_t>(digit - '0');
  return code;
}

}  // namespace

/// Reads the encoding in which programs for the control are written.
Done ControlLoader::encoding() {
  const toml::node* const node = file_.get("encoding");
  if (node == nullptr) return {};
  const auto letters = written_letters_named(text(file_, "encoding"));
  if (!letters) return Failed(place(name_, *node) + translated(texts::control_file::unknown_encoding));
  def_.letters = *letters;
  return {};
}

/// Reads a row of [convert]: M27 = "M8", or M27 = { fanuc = "M51", "*" = "M8" }.
Done ControlLoader::machine_codes() {
  const toml::table* const t = section("convert");
  if (t == nullptr) return {};
  for (const auto& [key, node] : *t) {
    const auto code = m_code(key.str());
    const CodeRow* const row = code ? machine_row(def_, *code) : nullptr;
    if (row == nullptr || row->function != Function::machine_function)
      return Failed(place(name_, node) + translated(texts::control_file::convert_no_machine_function, key.str()));
    if (const toml::table* const by_control = node.as_table()) {
      for (const auto& [control, there] : *by_control) KADR_LOAD(machine_code(*code, std::string(control.str()), there));
    } else {
      KADR_LOAD(machine_code(*code, "*", node));
    }
  }
  return {};
}

Done ControlLoader::machine_code(std::uint32_t code, const std::string& control, const toml::node& node) {
  const auto there = m_code(node.value_exact<std::string>().value_or(std::string()));
  if (!there) return Failed(place(name_, node) + translated(texts::control_file::convert_other_code, code));
  if (control == def_.id) return Failed(place(name_, node) + translated(texts::control_file::convert_to_itself, code, control));
  const auto twice = std::find_if(def_.machine_codes.begin(), def_.machine_codes.end(),
                                  [&](const MachineCodeRow& one) { return one.control == control && one.there == *there; });
  if (twice != def_.machine_codes.end())
    return Failed(place(name_, node) + translated(texts::control_file::convert_ambiguous, twice->code, code, *there, control));
  def_.machine_codes.push_back({code, control, *there});
  return {};
}

}  // namespace kadr
