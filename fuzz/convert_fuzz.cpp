// Fuzz target for `kadr convert`. The first byte selects the two controls, the rest is the program. The conversion must end. An accepted
// conversion must compare equal when both programs are run once more; a refused one must state its reasons; the source program must not
// change.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "convert/conversion_text.h"
#include "lang/text/text_spool.h"
#include "run_program.h"
#include "session/session.h"

namespace {

using namespace kadr;
using fuzz::require;

constexpr std::array names = {"s2c42", "mach3", "correctors", "gost", "nct", "linuxcnc", "fanuc", "haas", "grbl"};

/// A control with its alarm texts.
struct Side {
  explicit Side(const char* name)
      : def(std::make_shared<const ControlDef>(std::move(*load_control(name)))), texts(std::move(*AlarmTexts::load(def.get()))) {}
  std::shared_ptr<const ControlDef> def;
  AlarmTexts texts;
};

const Side& side_of(std::size_t number) {
  static const auto sides = [] {
    std::array<std::unique_ptr<Side>, names.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::make_unique<Side>(names[i]);
    return all;
  }();
  return *sides[number];
}

class Conversion {
 public:
  Conversion(const Side& from, const Side& to, std::string text)
      : from_(from), to_(to), before_(std::move(text)), text_(std::make_shared<const std::string>(before_)) {}

  void make() {
    const auto has_source = open(from_, shared_text_source(text_), setup_);
    if (!has_source) setup_ = {};
    ConversionSpec spec;
    spec.to = to_.def.get();
    spec.source_text = shared_text_source(text_);
    spec.source = [this](const Setup& setup) { return open(from_, shared_text_source(text_), setup); };
    spec.setup = setup_;
    spec.target = [this](std::shared_ptr<ByteSource> made, const Setup& setup) {
      auto session = open(to_, std::move(made), setup);
      if (session) (*session)->control().set_waiting(Control::Waiting::pass);
      return session;
    };
    const auto made = converted(spec);
    if (!made) std::fprintf(stderr, "%s\n", made.error().c_str());
    require(made.has_value(), "the set-up that corresponds is one of the other control");
    require(*text_ == before_, "the program is not changed");
    look_at(spec, *made);
  }

 private:
  using Opened = tl::expected<std::unique_ptr<Session>, std::string>;

  static Opened open(const Side& side, std::shared_ptr<ByteSource> text, const Setup& setup) {
    static const MachineProfile profile = std::move(*load_machine("generic"));
    auto session = Session::open({side.def, profile, setup, {"fuzz.nc", shared_source(std::move(text)), Encoding::utf8}, fuzz::few_passes});
    if (!session) return tl::unexpected(session.error().fault.key + ": " + session.error().fault.en);
    return std::move(*session);
  }

  void look_at(const ConversionSpec& spec, const Converted& made) const {
    require(!made.tries.empty(), "a way is tried");
    for (std::size_t i = 0; i < made.tries.size(); ++i) {
      require(!made.tries[i].is_proven() || made.taken == i, "what is proven is taken");
      require(made.taken == i || !refusal_of(made.tries[i], {*from_.def, from_.texts, to_.texts}).text.empty(),
              "what is refused has its reason");
    }
    if (!made.taken) return;
    const ConversionTry& one = made.tries[*made.taken];
    require(one.is_proven() && *made.taken + 1 == made.tries.size(), "what is taken is proven, and the last that is tried");
    CompareRules rules;
    rules.tolerance = made.tolerance;
    rules.tools_by_hand = made.tools_by_hand;
    rules.feeds_at_speed = true;
    rules.messages = one.transliterated == 0 && shows_same_messages(*from_.def, *to_.def);
    const auto again =
        compare_sessions(std::move(*spec.source(spec.setup)), std::move(*spec.target(one.text, made.setup_of(one.as))), rules);
    require(again.equal() && !again.stopped_a && !again.stopped_b, "what is taken is equal, run once more");
  }

  const Side& from_;
  const Side& to_;
  const std::string before_;
  const std::shared_ptr<const std::string> text_;
  Setup setup_ = fuzz::some_setup(0);
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::size_t from = data[0] % names.size();
  std::size_t to = data[0] / names.size() % (names.size() - 1);
  if (to >= from) ++to;
  Conversion(side_of(from), side_of(to), std::string(reinterpret_cast<const char*>(data) + 1, size - 1)).make();
  return 0;
}
