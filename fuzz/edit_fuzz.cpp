// Fuzz target for `kadr edit`. The first byte selects the control, the second the edits, the rest is the program. The edit must end, must
// not change the program, and must keep two laws: new numbers, and one space between words, do not change a text that already has them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "edit/editing.h"
#include "run_program.h"
#include "session/session.h"

namespace {

using namespace kadr;
using fuzz::require;

constexpr std::array names = {"s2c42", "mach3", "correctors", "gost", "nct", "linuxcnc", "fanuc", "haas", "grbl", "fanuc-t"};

std::shared_ptr<const ControlDef> control_of(std::size_t number) {
  static const auto controls = [] {
    std::array<std::shared_ptr<const ControlDef>, names.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::make_shared<const ControlDef>(std::move(*load_control(names[i])));
    return all;
  }();
  return controls[number];
}

/// Returns one edit of positions: the first byte of the program's text selects it.
Edits map_of(std::uint8_t byte) {
  constexpr unsigned kinds = 8;
  Edits edits;
  switch (byte % kinds) {
    case 0: edits.plane = PlaneMap::mirror_x(2.5); break;
    case 1: edits.plane = PlaneMap::mirror_y(0); break;
    case 2: edits.plane = PlaneMap::turn(90, {1, 2}); break;
    case 3: edits.plane = PlaneMap::turn(270, {}); break;
    case 4: edits.plane = PlaneMap::turn(30, {5, 0}); break;
    case 5: edits.copies = true, edits.places = {PlaneMap::shift({10, 0}), PlaneMap::turn(180, {})}; break;
    case 6: edits.copies = true, edits.copied = EditLines{2, 4}, edits.places = {PlaneMap::shift({0, 5})}; break;
    default: edits.reverses = EditLines{2, 5}; break;
  }
  return edits;
}

/// Returns the edits that a byte selects, one bit each; 0: an edit of positions.
Edits edits_of(std::uint8_t bits, std::uint8_t next) {
  Edits edits;
  if (bits == 0) return map_of(next);
  if ((bits & 1U) != 0) edits.numbering = Numbering{10, 10};
  edits.no_comments = (bits & 2U) != 0;
  edits.spaces = (bits & 4U) != 0;
  edits.no_numbers = (bits & 8U) != 0 && !edits.numbering;
  if ((bits & 16U) != 0) edits.feeds = {{std::nullopt, 0.5}, {1U, 0.75}};
  if ((bits & 32U) != 0) edits.speeds = {{std::nullopt, 0.8}};
  if ((bits & 64U) != 0) edits.work_systems = {{SystemCode{540, {}}, SystemCode{550, {}}}};
  if ((bits & 128U) != 0) edits.shift = {{"X", 2.5}};
  return edits;
}

std::string text_of(const EditedSource& program, const Edits& edits) {
  std::string text;
  const auto made = edit_program(program, edits, {}, [&text](std::string_view piece) { text += piece; });
  return made ? text : std::string();
}

void check_laws(const std::shared_ptr<const ControlDef>& def, const std::shared_ptr<const std::string>& text) {
  const auto source = [](const std::shared_ptr<const std::string>& of) { return std::shared_ptr<ByteSource>(shared_text_source(of)); };
  Edits edits;
  edits.numbering = Numbering{1, 1};
  const auto once = std::make_shared<const std::string>(text_of({source(text), Encoding::utf8, def.get()}, edits));
  if (!once->empty())
    require(text_of({source(once), Encoding::utf8, def.get()}, edits) == *once, "new numbers do not change numbers that are new already");
  Edits spaced;
  spaced.spaces = true;
  Edits mirror;
  mirror.plane = PlaneMap::mirror_x(0);
  // A word that the mirror image changes, such as -0 or X+5, has another form afterwards; from then on the form stays
  const auto mirrored = [&](const std::string& of) {
    return text_of({source(std::make_shared<const std::string>(of)), Encoding::utf8, def.get()}, mirror);
  };
  if (const std::string image = mirrored(*text); !image.empty() && image.find('[') == std::string::npos)
    if (const std::string back = mirrored(image); !back.empty())
      require(mirrored(mirrored(back)) == back, "two more mirror images do not change a text");
  const auto apart = std::make_shared<const std::string>(text_of({source(text), Encoding::utf8, def.get()}, spaced));
  if (!apart->empty()) require(text_of({source(apart), Encoding::utf8, def.get()}, spaced) == *apart, "one space between words stays one");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const auto def = control_of(data[0] % names.size());
  const auto text = std::make_shared<const std::string>(reinterpret_cast<const char*>(data) + 2, size - 2);
  const std::string before = *text;
  static const MachineProfile profile = std::move(*load_machine("generic"));
  const auto open = [&](std::shared_ptr<ByteSource> of, const Setup& setup) -> tl::expected<std::unique_ptr<Session>, std::string> {
    auto session = Session::open({def, profile, setup, {"fuzz.nc", shared_source(std::move(of)), Encoding::utf8}, fuzz::few_passes});
    if (!session) return tl::unexpected(session.error().fault.key + ": " + session.error().fault.en);
    return std::move(*session);
  };
  EditSpec spec;
  spec.source_text = shared_text_source(text);
  spec.old_program = [&](const Setup& setup) { return open(shared_text_source(text), setup); };
  spec.new_program = open;
  spec.edits = edits_of(data[1], size > 2 ? data[2] : 0);
  const auto made = edited(spec, {shared_text_source(text), Encoding::utf8, def.get()});
  require(made || !made.error().why.empty(), "a refused edit has its reason");
  require(*text == before, "the program is not changed");
  check_laws(def, text);
  return 0;
}
