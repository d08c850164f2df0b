// OpenStates: makes further set-ups for the proof of a conversion, with values for work offsets, tool lengths, radii and reference points
// that the given set-up does not state. Used by convert/conversion and convert/word_by_word; tested by tests/convert_open.py.

#include "convert/open_states.h"

#include <map>
#include <random>
#include <string>

#include "config/setup/setup_names.h"
#include "convert/source_setup.h"

namespace kadr {
namespace {

constexpr std::size_t max_systems = 64;
constexpr int max_offsets = 99, max_zeros = 16;
constexpr std::uint32_t first_seed = 20999;

/// Generates random values. They are multiples of steps that the words of every control can express.
class Values {
 public:
  explicit Values(std::uint32_t seed) : random_(seed) {}
  double zero(const std::string& axis) { return axis == "Z" ? -between(1000, 3000) / 10 : -between(500, 4500) / 10; }
  double length() { return between(400, 1600) / 10; }
  double radius() { return between(10, 60) / 100; }
  double wear() { return between(-30, 30) / 100; }
  double tip() { return between(1, 9); }
  double reference() { return between(-200, 200) / 10; }

 private:
  double between(int least, int most) {  // never returns 0
    const int value = least + int(random_() % std::uint32_t(most - least + 1));
    return value == 0 ? most : value;
  }
  std::mt19937 random_;
};

class Filler {
 public:
  Filler(const Setup& given, const ControlDef& def, const ControlDef& to, const std::vector<std::string>& axes, const ProgramNames& names,
         std::uint32_t seed)
      : def_(def), known_(&def, axes, axes), names_(names), turns_(turns(def, to)), wears_(wears_alike(def, to)), values_(seed) {
    state_.setup = given;
    for (const std::string& axis : axes)
      if (axis == "X" || axis == "Y" || axis == "Z") axes_.push_back(axis);
  }

  OpenState fill() {
    zeros();
    offsets();
    references();
    return std::move(state_);
  }

 private:
  void zeros() {
    Setup& setup = state_.setup;
    if (allows_key(def_, "zeros")) {
      for (int number = 1; number <= max_zeros; ++number)
        if (known_.allows(SetupNames::zero, std::to_string(number))) fill_zero(setup.zeros[number], number);
      return;
    }
    if (!allows_key(def_, "work_offsets")) return;
    // Names by number of the work system, because two names may mean the same one: G110 and G154 P1 of the Haas.
    std::map<std::uint32_t, std::string> name_of;
    for (const WorkSystem& system : work_systems(def_))
      if (system.works && system.row != 0 && (name_of.size() < max_systems || setup.work_offsets.contains(system.name)))
        if (const auto [at, is_new] = name_of.try_emplace(system.row, system.name); !is_new && setup.work_offsets.contains(system.name))
          at->second = system.name;
    for (const auto& [row, name] : name_of) fill_zero(setup.work_offsets[name], int(row));
  }
  void fill_zero(AxisValues& values, int number) {
    for (const std::string& axis : axes_)
      if (const auto [at, is_open] = values.try_emplace(axis, 0.0); is_open) state_.zeros[number][axis] = at->second = values_.zero(axis);
  }

  void offsets() {
    if (!allows_key(def_, "offsets")) return;
    std::vector<int> numbers;
    // M6 looks the tool up in a tool table (spec/linuxcnc 5), so the numbers of the rows must be the tool numbers of the program.
    if (def_.has_parameter_file()) numbers.assign(names_.tools.begin(), names_.tools.end());
    else
      for (int number = 1; number <= max_offsets; ++number) numbers.push_back(number);
    for (const int number : numbers) {
      if (number == 0 || !known_.allows(SetupNames::offset, std::to_string(number))) continue;
      if (state_.setup.correctors.contains(number)) continue;  // the set-up states this row already, as a corrector
      const auto [at, is_open] = state_.setup.offsets.try_emplace(number);
      if (is_open) at->second.length = values_.length(), at->second.radius = values_.radius();
      if (is_open && turns_) fill_turning(at->second);
    }
  }

  /// Fills in what only turning tools have. The wear stays as the set-up states it unless both controls put it into force in the same way.
  void fill_turning(ToolOffset& offset) {
    offset.length_x = -values_.length();
    offset.tip_position = values_.tip();
    if (wears_) offset.length_x_wear = values_.wear(), offset.length_wear = values_.wear(), offset.radius_wear = values_.wear() / 10;
  }

  void references() {
    if (!allows_key(def_, "reference_points")) return;
    for (const int point : {1, 2}) {
      if (!known_.allows(SetupNames::reference_point, std::to_string(point))) continue;
      AxisValues& values = state_.setup.reference_points[point];
      for (const std::string& axis : axes_)
        if (const auto [at, is_open] = values.try_emplace(axis, 0.0); is_open) at->second = values_.reference();
    }
  }

  const ControlDef& def_;
  const SetupNamesOf known_;
  const ProgramNames& names_;
  std::vector<std::string> axes_;
  // turns_: one of the two controls is that of a lathe; wears_: both put the wear of a tool into force in the same way
  const bool turns_, wears_;
  Values values_;
  OpenState state_;
};

}  // namespace

std::vector<OpenState> open_states(const Setup& given, const ControlDef& def, const ControlDef& to, const std::vector<std::string>& axes,
                                   const ProgramNames& names, int count) {
  std::vector<OpenState> states;
  for (int i = 0; i < count; ++i) states.push_back(Filler(given, def, to, axes, names, first_seed + std::uint32_t(i)).fill());
  return states;
}

}  // namespace kadr
