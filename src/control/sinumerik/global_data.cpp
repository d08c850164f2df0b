// Definition files: global data (GUD) and macros (spec/sinumerik 6.1). Used by control/sinumerik.

#include "base/ascii.h"
#include "control/sinumerik/sinumerik.h"
#include "lang/block/block_reader.h"
#include "lang/named/named_parser.h"
#include "lang/text/utf16.h"

namespace kadr::sinumerik {

/// Reads the files of global data and of macros that are near the program: those of the machine's builder and user, and of the user's
/// cycles. INFERRED: a block of such a file that Kadr cannot read defines nothing; a program that uses the name gets an alarm.
void Sinumerik::load_globals(BlockContext& m) {
  if (std::exchange(memory.globals_loaded, true)) return;
  constexpr const char* names[] = {"SMAC", "MMAC", "UMAC", "PMAC", "SGUD", "MGUD", "UGUD",
                                   "PGUD", "GUD4", "GUD5", "GUD6", "GUD7", "GUD8", "GUD9"};
  for (const std::string& folder : folders_near(m.program().main_file(), {"DEF.DIR"}))
    for (const char* const name : names) load_definitions(m, folder + name + ".DEF");
}

void Sinumerik::load_definitions(BlockContext& m, const std::string& path) {
  auto text = open_text(path, {}, door_);
  if (!text.source) return;
  BlockReader reader(std::move(text.source), m.def.grammar, text.encoding);
  auto block = std::make_unique<Block>();
  constexpr std::size_t most_names = 20'000;
  while (memory.globals.size() + memory.macros.size() < most_names) {
    const auto got = reader.next(*block);
    if (!got) continue;
    if (*got == BlockReader::Got::end) return;
    if (block->statement.kind != StatementKind::named) continue;
    const auto read = read_named_block(block->text, block->statement.text);
    if (!read) continue;
    if (read->kind == NamedKind::macro) memory.macros.emplace(read->name, read->text);
    if (read->kind != NamedKind::definition) continue;
    for (const NamedDefinition& row : read->definitions)
      if (auto made = made_variable(m, *read, row)) memory.globals.emplace(row.name, std::move(*made));
  }
}

}  // namespace kadr::sinumerik
