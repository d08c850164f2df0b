#pragma once
// The parameters of the control: the set-up gives them, PRM reads them (nct 24.2), G10 L52 writes them (24.1).
// A value is identified by a row and an index. Rows are looked up once, at load; a read is then an array access.

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "config/control_def.h"
#include "config/setup.h"
#include "control/state/journal.h"

namespace kadr::macro_b {

/// A row of the control's parameter table. `none` reads as 0, as a bit that is off, or as an empty text.
enum class ParameterId : std::int16_t { none = -1 };

class ParameterStore {
 public:
  struct Context {
    std::vector<std::string> axes;  // names by control-wide number, starting with number 1
    int channel = 1;                // the channel of this store
  };

  /// Takes all values from the table, then those of the set-up. A value of the set-up without an index applies to all channels, axes or
  /// spindles; a value with an index overrides it.
  ///   rows  sorted by number (ControlDef::parameters); they must live as long as the store
  ParameterStore(std::span<const ParameterRow> rows, const Parameters& given, Context context);

  /// Describes the invalid keys and values of the set-up; empty if there are none.
  const std::string& error() const { return error_; }

  /// The row of a number, or none.
  ParameterId find(int number) const;
  /// The row of a name: "0107", "107", "CLRG".
  ParameterId named(std::string_view name) const;
  /// The row, and its bit or -1, that the table of a control other than the NCT assigns to a name of the engine (`as` of the row).
  struct Meaning {
    ParameterId row = ParameterId::none;
    int bit = -1;
  };
  Meaning meaning(std::string_view name) const;
  /// The number of a bit by its name, or -1. It is 0 to 7, or from 8 on where the manual gives only the name.
  int bit_named(ParameterId id, std::string_view name) const;

  /// The value in force; for bits all of them as a whole number, for a text the code of its first character.
  ///   index  channel, axis or spindle, from 1; 0: the own channel, or the only value of a global parameter
  double value(ParameterId id, int index = 0) const;
  bool bit(ParameterId id, int bit, int index = 0) const;
  /// The character or name of a text parameter; empty if it is 0.
  std::string text(ParameterId id, int index = 0) const;

  /// Reads PRM[number,bit]/[index]; a vacant argument counts as missing.
  ///   alarms  parameter_unknown: no such parameter; value_out_of_range Q: no such bit, P: no such channel, axis, spindle (inferred);
  ///           parameter_argument 2: the bit is missing, 3: the axis or spindle is missing
  ///   manual  NCT 24.2
  Result<double> read(double number, std::optional<double> bit, std::optional<double> index, Span where) const;

  /// A word of a block of parameters.
  struct Word {
    double value = 0;
    Span where;
  };
  /// The words N P Q R; with `increment` R is added to the present value (`RI`).
  struct Write {
    std::optional<Word> n, p, q, r;
    bool increment = false;
    Span block;  // location reported for a missing word
  };
  /// Executes one block between G10 L52 and G11; an alarm changes nothing.
  ///   alarms  word_missing: N, R; Q of bits; P of an axis or spindle (inferred)
  ///           parameter_unknown: N, no such parameter
  ///           value_out_of_range: P beyond 8 channels, 32 axes, 16 spindles or of a global parameter;
  ///           Q beyond 0 to 7 or of a parameter without bits; R beyond the row's range
  ///           parameter_not_writable: takes effect after a restart, or needs the emergency state
  ///   manual  NCT 24.1
  Status write(const Write& w);

  /// Rises with each change; values derived from them must then be computed again.
  std::uint64_t version() const { return now_.version; }

  /// Takes over the values of another channel's store (24.1: one indexed set for all channels). Called between two blocks.
  void take(const ParameterStore& from);

  /// Identifies a value or a bit of it: index 0 means all channels, axes or spindles; bit -1 the whole value.
  struct Place {
    int row = 0;
    int index = 0;
    int bit = -1;
    friend auto operator<=>(const Place&, const Place&) = default;  // NOLINT(modernize-use-nullptr): none here
  };
  /// What a snapshot holds: the values in force, and which of them were written.
  struct Memory {
    std::vector<double> values;                // by slot
    std::map<std::size_t, std::string> texts;  // by slot: names of more than one character
    std::set<Place> written;
    std::uint64_t version = 0;
  };
  const Memory& memory() const { return now_; }
  void remember(const Memory& memory) { now_ = memory; }
  /// Lets the journal take writes back. This object must not move from here on.
  void keep_in(Journal& journal) { journal_.lead_to(journal); }

  /// What the set-up gave, under its keys, and everything else that was written, by number: the parameters of a next set-up.
  ///   law  a store made from it reads the same
  Parameters written() const;

 private:
  struct Given {
    Place place;
    ParameterValue value;
  };
  struct Undo {
    std::size_t slot = 0;
    double value = 0;
    std::string text;
    std::optional<Place> place;  // if it was new in Memory::written
  };

  /// True if an axis of any channel has that number.
  bool has_axis(int number) const {
    const auto n = static_cast<std::size_t>(number);
    return n >= 1 && n <= context_.axes.size() && !context_.axes[n - 1].empty();
  }
  const ParameterRow& row(ParameterId id) const { return rows_[static_cast<std::size_t>(id)]; }
  void take_back(const Undo& write);
  std::size_t slot(ParameterId id, int index) const;
  void give(const ParameterKey& key, const ParameterValue& value);
  std::optional<int> index_of(const ParameterRow& of, const std::string& index) const;
  std::optional<int> bit_of(ParameterId id, const std::string& bit) const;
  void assign(const Given& given);
  void assign(std::size_t at, int bit, double value);
  bool own_written(const Given& given) const;
  ParameterValue in_force(const Place& place, bool as_text) const;
  ParameterKey key_of(const Place& place) const;

  std::span<const ParameterRow> rows_;
  Context context_;
  std::vector<std::size_t> first_;  // slot of each row's first index
  std::map<ParameterKey, Given> given_;
  Memory now_;
  JournalLink journal_;
  std::string error_;
};

}  // namespace kadr::macro_b
