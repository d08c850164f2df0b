#pragma once
// The parameters of the control. The set-up gives their values, a program reads them by PRM (nct 24.2) and writes them by G10 L52 (24.1). A
// value is identified by a row of the control's parameter table and an index (channel, axis or spindle). Rows are searched once, when the
// control is loaded; later reads are array accesses.

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "config/control/control_def.h"
#include "config/setup/setup.h"
#include "control/state/journal.h"

namespace kadr::macro_b {

/// A row of the control's parameter table. The row `none` reads as 0, as a bit that is off, or as an empty text.
enum class ParameterId : std::int16_t { none = -1 };

class ParameterStore {
 public:
  struct Context {
    std::vector<std::string> axes;  // names of the axes of all channels, starting with axis number 1
    int channel = 1;                // number of the channel to which this store belongs
  };

  /// Reads the default values from the parameter table, then the values of the set-up. A set-up value without an index applies to all
  /// channels, axes or spindles; a set-up value with an index overrides it for that channel, axis or spindle.
  ///   rows   sorted by number (ControlDef::parameters); the rows must live as long as the store
  ///   given  the values of the set-up
  ParameterStore(std::span<const ParameterRow> rows, const Parameters& given, Context context);

  /// Returns a description of the invalid parameter keys and values of the set-up; empty if all are valid.
  const std::string& error() const { return error_; }

  /// Returns the row with a parameter number, or ParameterId::none.
  ParameterId find(int number) const;
  /// Returns the row with a parameter name: "0107", "107", "CLRG".
  ParameterId named(std::string_view name) const;
  /// A parameter whose meaning Kadr knows by a name: the row of the parameter, and the bit or -1. In the tables of controls other than the
  /// NCT, the key `as` of the row gives the name.
  struct Meaning {
    ParameterId row = ParameterId::none;
    int bit = -1;
  };
  Meaning meaning(std::string_view name) const;
  /// Returns the number of the bit with this name, or -1. Bits with numbers are 0 to 7; bits that the manual names without a number count
  /// from 8 on.
  int bit_named(ParameterId id, std::string_view name) const;

  /// Returns the value in force. For a parameter of bits, returns all bits as a whole number; for a text, the code of its first character.
  ///   index  number of the channel, axis or spindle, from 1; 0: the store's own channel, or the only value of a global parameter
  double value(ParameterId id, int index = 0) const;
  bool bit(ParameterId id, int bit, int index = 0) const;
  /// Returns the characters that a text parameter contains; empty if the parameter is 0.
  std::string text(ParameterId id, int index = 0) const;

  /// Reads PRM[number,bit]/[index]; an argument that is an empty variable counts as missing.
  ///   alarms  parameter_unknown: no such parameter; value_out_of_range Q: no such bit, P: no such channel, axis, spindle (inferred);
  ///           parameter_argument (number of the argument): 2, the bit is missing; 3, the axis or spindle is missing
  ///   manual  NCT 24.2
  Result<double> read(double number, std::optional<double> bit, std::optional<double> index, Span where) const;

  /// A word of a block between G10 L52 and G11, which writes parameters.
  struct Word {
    double value = 0;
    Span where;
  };
  /// The words N P Q R of a block that writes a parameter. If `increment` is set (`RI`), R is added to the present value.
  struct Write {
    std::optional<Word> n, p, q, r;
    bool increment = false;
    Span block;  // location of the whole block, which an alarm about a missing word reports
  };
  /// Executes one block between G10 L52 and G11. A block that raises an alarm changes nothing.
  ///   alarms  word_missing: N, R; Q of bits; P of an axis or spindle (inferred)
  ///           parameter_unknown: N, no such parameter
  ///           value_out_of_range: P exceeds 8 channels, 32 axes, 16 spindles, or the parameter is global;
  ///           Q is not 0 to 7, or the parameter has no bits; R is outside the range of the row
  ///           parameter_not_writable: the parameter takes effect after a restart, or needs the emergency state
  ///   manual  NCT 24.1
  Status write(const Write& w);

  /// Returns a number that increases with each change of a parameter. Values derived from parameters must then be computed again.
  std::uint64_t version() const { return now_.version; }

  /// Copies the parameter values of another channel's store, because all channels share one indexed set (24.1). Called between two blocks.
  void take(const ParameterStore& from);

  /// Identifies a parameter value, or one bit of the value. Index 0 means all channels, axes or spindles; bit -1 means the whole value.
  struct Place {
    int row = 0;
    int index = 0;
    int bit = -1;
    friend auto operator<=>(const Place&, const Place&) = default;  // NOLINT(modernize-use-nullptr): none here
  };
  /// The part of a snapshot that belongs to the parameters: the values in force, and a record of the values that were written.
  struct Memory {
    std::vector<double> values;                // values of all parameters, indexed by slot, which slot() computes from row and index
    std::map<std::size_t, std::string> texts;  // texts of the text parameters that have more than one character, by slot
    std::set<Place> written;
    std::uint64_t version = 0;
  };
  const Memory& memory() const { return now_; }
  void resume_from(const Memory& memory) { now_ = memory; }
  /// Connects the store to the journal, which undoes writes after an alarm. After this call the store must not be moved in memory.
  void keep_in(Journal& journal) { journal_.relink(journal); }

  /// Returns the parameters in the form of a set-up: those of the present set-up under their keys, and all others that were written under
  /// their numbers.
  ///   law  a store made from the result has the same values
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
    std::optional<Place> place;  // entry that this write added to Memory::written; nullopt if the entry existed before
  };

  /// Returns true if an axis with this number exists in any channel.
  bool has_axis(int number) const {
    const auto n = static_cast<std::size_t>(number);
    return n >= 1 && n <= context_.axes.size() && !context_.axes[n - 1].empty();
  }
  const ParameterRow& row(ParameterId id) const { return rows_[static_cast<std::size_t>(id)]; }
  void undo_block(const Undo& write);
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
  std::vector<std::size_t> first_;  // for each row of the parameter table, the slot in Memory::values of the row's first value
  std::map<ParameterKey, Given> given_;
  Memory now_;
  JournalLink journal_;
  std::string error_;
};

}  // namespace kadr::macro_b
