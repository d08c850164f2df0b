#pragma once
// PlaneEditor: maps the words of blocks by a PlaneMap: positions, increments, centres of arcs, and the codes whose sense the map reverses
// (G2 and G3, G41 and G42). It follows the modes of the text; the proof finds the cases in which the run has others.

#include <cstdint>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "config/control/control_def.h"
#include "edit/line_changes.h"
#include "edit/plane_map.h"
#include "edit/renumbering.h"

namespace kadr {

class PlaneEditor {
 public:
  PlaneEditor(const ControlDef& def, const PlaneMap& map) : def_(def), map_(map) {}

  /// Adds the changes of the block's words. Must be called for each block in order.
  tl::expected<void, EditFault> change(const Block& block, LineChanges& to);
  /// The next position in work coordinates that states X or Y gets both words: the tool may stand elsewhere than the text says. Refused
  /// where the other one is not known.
  void state_both() { states_both_ = true; }
  /// True if that position has not come yet.
  bool will_state_both() const { return states_both_; }
  /// Returns the number of words that were changed since the last call.
  std::size_t take_changed() { return std::exchange(changed_, 0); }

 private:
  enum class Plane : std::uint8_t { xy, zx, yz };
  enum class Cycle : std::uint8_t { none, plain, shifts };  // plain: I J K of the cycle are no distances in the plane

  /// How the words X and Y, or I and J, of a block change.
  enum class Places : std::uint8_t { points, vectors, names, kept };
  struct Codes {
    Places places = Places::points;
    bool is_new_position = false;  // the words set the position instead of moving to it
    bool loses_position = false;   // the position afterwards is not that of the words
    bool keeps_centres = false;
    bool has_direction = false;  // I J are a direction, whether centres are absolute or not
    bool scales = false;
  };

  tl::expected<Codes, EditFault> look(const Block& block);
  void note_mode(const CodeRow& row);
  void set_unit(bool inch);
  EditStatus swap_code(const Block& block, const Word& word, const CodeRow& row, LineChanges& to);
  EditStatus plane_code(const Block& block, const Word& word, const CodeRow& row, LineChanges& to);
  EditStatus axis_words(const Block& block, const Codes& codes, LineChanges& to);
  EditStatus centre_words(const Block& block, const Codes& codes, LineChanges& to);
  EditStatus angle_word(const Block& block, LineChanges& to);

  /// The words of the two directions of the plane in one block.
  struct Pair {
    const Word* words[2] = {nullptr, nullptr};
    char letters[2] = {'X', 'Y'};
  };
  EditStatus map_pair(const Block& block, const Pair& pair, Places places, std::optional<Vec2> missing, LineChanges& to);
  EditStatus map_quarter(const Block& block, const Pair& pair, Places places, LineChanges& to);
  EditStatus write(const Block& block, const Word& at, const Word& value, char letter, double factor, double by, LineChanges& to);
  std::optional<std::string> text_of(const Block& block, const Word& word, char letter, double value) const;
  double rounded(const Word& like, char letter, bool is_increment, double value);
  Vec2 program_units(Vec2 mm) const;
  bool reverses(Plane plane) const;
  void note_position(const Block& block, const Pair& pair, const Codes& codes);

  const ControlDef& def_;
  const PlaneMap map_;
  std::size_t changed_ = 0;
  Plane plane_ = Plane::xy;
  Cycle cycle_ = Cycle::none;
  bool incremental_ = false, inch_ = false, centres_absolute_ = false, arc_ = false;
  bool states_both_ = false;     // see state_both()
  double lost_[2] = {0, 0};      // how far the position is from the exact one because of rounded words
  std::optional<double> at_[2];  // position in the words of the program, if it is known
};

}  // namespace kadr
