// The parameters of the control. The set-up gives their values, PRM reads them (nct 24.2), G10 L52 writes them (24.1). Used by
// control/macro_b/macro_b; tested by tests/control/macro_b/parameters_test.cpp.

#include "control/macro_b/variables/parameters.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/ascii.h"

namespace kadr::macro_b {
namespace {

constexpr double max_number = 9999;  // 24
constexpr int bits_with_number = 8;  // Q0 to Q7 (24.1)
constexpr int whole_value = -1;      // number in place of a bit number: the parameter as a whole is meant, not one of its bits

/// Returns the number of values that a parameter has, by its scope: one value, or one value per channel, axis or spindle (24.0).
int count_of(ParameterScope scope) {
  switch (scope) {
    case ParameterScope::global: return 1;
    case ParameterScope::channel: return 8;
    case ParameterScope::axis: return 32;
    case ParameterScope::spindle: return 16;
  }
  return 1;
}

bool needs_index(ParameterScope scope) { return scope == ParameterScope::axis || scope == ParameterScope::spindle; }

bool is_whole(double value) { return value == std::floor(value); }

bool is_name_character(char c) { return is_capital(c) || is_digit(c); }

/// Returns the value as an int; nullopt if the value has a fraction or is out of range.
std::optional<int> whole_within(double value, double least, double most) {
  if (!(value >= least && value <= most) || !is_whole(value)) return std::nullopt;
  return static_cast<int>(value);
}

std::optional<int> digits(std::string_view text) {
  if (text.empty() || text.size() > 4 || text.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  return std::stoi(std::string(text));
}

/// Returns true if the value is valid for the parameter of the row, or for one bit of it.
bool fits(const ParameterRow& row, int bit, double value) {
  if (!std::isfinite(value)) return false;
  if (bit != whole_value) return value == 0 || value == 1;
  const bool in_range = value >= row.least && value <= row.most;
  switch (row.type) {
    case ParameterType::bits:
      return is_whole(value) && value >= 0 && value < std::exp2(std::max<double>(bits_with_number, static_cast<double>(row.bits.size())));
    case ParameterType::whole: return is_whole(value) && in_range;
    case ParameterType::real: return in_range;
    case ParameterType::text:
      return value == 0 || (is_whole(value) && value > 0 && value < 128 && is_name_character(static_cast<char>(value)));
  }
  return false;
}

/// Returns a parameter name as the manual and the set-up write it: "N0107" for "0107".
std::string spelled(const std::string& name) { return (name.empty() || name[0] < '0' || name[0] > '9' ? "" : "N") + name; }

std::string spelled(const ParameterKey& key) {
  return spelled(key.name) + (key.index.empty() ? "" : "." + key.index) + (key.bit.empty() ? "" : "#" + key.bit);
}

std::uint64_t bits_of(double value) { return static_cast<std::uint64_t>(value); }

}  // namespace

ParameterStore::ParameterStore(std::span<const ParameterRow> rows, const Parameters& given, Context context)
    : rows_(rows), context_(std::move(context)) {
  assert(context_.channel >= 1 && context_.channel <= count_of(ParameterScope::channel));
  first_.reserve(rows_.size());
  for (const ParameterRow& row : rows_) {
    first_.push_back(now_.values.size());
    now_.values.resize(now_.values.size() + static_cast<std::size_t>(count_of(row.scope)), row.initial);
  }
  for (const auto& [key, value] : given) give(key, value);
  std::vector<const Given*> in_order;
  for (const auto& [key, one] : given_) in_order.push_back(&one);
  const auto general_first = [](const Given* a, const Given* b) { return a->place < b->place; };
  std::stable_sort(in_order.begin(), in_order.end(), general_first);
  for (const Given* const one : in_order) assign(*one);
}

void ParameterStore::take(const ParameterStore& from) {
  assert(now_.values.size() == from.now_.values.size());
  if (now_.values == from.now_.values && now_.texts == from.now_.texts) return;
  now_.values = from.now_.values;
  now_.texts = from.now_.texts;
  now_.written = from.now_.written;
  ++now_.version;
}

/// Records a value of the set-up if key and value are valid; otherwise adds a description of the error to error().
void ParameterStore::give(const ParameterKey& key, const ParameterValue& value) {
  const auto wrong = [&](const std::string& sentence) {
    error_ += (error_.empty() ? "" : "; ") + ("setup key 'parameters." + spelled(key) + "': " + sentence);
  };
  const ParameterId id = named(key.name);
  if (id == ParameterId::none) return wrong("no such parameter");
  const ParameterRow& of = row(id);
  const auto index = index_of(of, key.index);
  if (!index) return wrong("no such channel, axis or spindle '" + key.index + "'");
  const auto bit = key.bit.empty() ? std::optional(whole_value) : bit_of(id, key.bit);
  if (!bit) return wrong("no such bit '" + key.bit + "'");
  if (const auto* const text = std::get_if<std::string>(&value)) {
    if (of.type != ParameterType::text) return wrong("must be a number");
    if (!std::all_of(text->begin(), text->end(), is_name_character)) return wrong("must be letters A to Z and digits");
  } else if (!fits(of, *bit, std::get<double>(value))) {
    return wrong("the value is out of its limits");
  }
  given_[key] = {{static_cast<int>(id), *index, *bit}, value};
}

void ParameterStore::assign(const Given& given) {
  const ParameterRow& of = rows_[static_cast<std::size_t>(given.place.row)];
  const bool all = given.place.index == 0;
  const int from = all ? 1 : given.place.index;
  const int to = all ? count_of(of.scope) : given.place.index;
  for (int index = from; index <= to; ++index) {
    const std::size_t at = slot(static_cast<ParameterId>(given.place.row), index);
    const auto* const text = std::get_if<std::string>(&given.value);
    assign(at, given.place.bit, text == nullptr ? std::get<double>(given.value) : text->empty() ? 0 : text->front());
    if (text != nullptr && text->size() > 1) now_.texts[at] = *text;
  }
}

void ParameterStore::assign(std::size_t at, int bit, double value) {
  now_.texts.erase(at);
  if (bit == whole_value) {
    now_.values[at] = value == 0 ? 0 : value;  // -0 is stored as 0
    return;
  }
  const std::uint64_t one = std::uint64_t{1} << bit;
  const std::uint64_t others = bits_of(now_.values[at]) & ~one;
  now_.values[at] = static_cast<double>(value != 0 ? others | one : others);
}

/// Converts an index of a set-up key to a number: an axis name "X" or a number "4". Returns 0 for "", which means all channels, axes or
/// spindles.
std::optional<int> ParameterStore::index_of(const ParameterRow& of, const std::string& index) const {
  if (index.empty()) return 0;
  if (of.scope == ParameterScope::axis) {
    const auto found = std::find(context_.axes.begin(), context_.axes.end(), index);
    if (found != context_.axes.end()) return static_cast<int>(found - context_.axes.begin()) + 1;
  }
  const auto number = digits(index);
  if (of.scope == ParameterScope::global || !number || *number < 1 || *number > count_of(of.scope)) return std::nullopt;
  return number;
}

std::optional<int> ParameterStore::bit_of(ParameterId id, const std::string& bit) const {
  if (row(id).type != ParameterType::bits) return std::nullopt;
  if (const auto number = digits(bit)) return *number < bits_with_number ? number : std::nullopt;
  const int named_bit = bit_named(id, bit);
  return named_bit < 0 ? std::nullopt : std::optional(named_bit);
}

ParameterId ParameterStore::find(int number) const {
  if (number < 0) return ParameterId::none;
  const auto before = [](const ParameterRow& row, int n) { return row.number >= 0 && row.number < n; };
  const auto found = std::lower_bound(rows_.begin(), rows_.end(), number, before);
  return found == rows_.end() || found->number != number ? ParameterId::none : static_cast<ParameterId>(found - rows_.begin());
}

ParameterId ParameterStore::named(std::string_view name) const {
  if (const auto number = digits(name)) return find(*number);
  const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const ParameterRow& row) { return row.name == name; });
  return found == rows_.end() ? ParameterId::none : static_cast<ParameterId>(found - rows_.begin());
}

ParameterStore::Meaning ParameterStore::meaning(std::string_view name) const {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    for (std::size_t k = 0; k < rows_[i].means.size(); ++k)
      if (rows_[i].means[k] == name) return {static_cast<ParameterId>(i), rows_[i].type == ParameterType::bits ? static_cast<int>(k) : -1};
  return {};
}

int ParameterStore::bit_named(ParameterId id, std::string_view name) const {
  if (id == ParameterId::none || name.empty()) return -1;
  const auto& names = row(id).bits;
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

std::size_t ParameterStore::slot(ParameterId id, int index) const {
  const ParameterScope scope = row(id).scope;
  const int own = scope == ParameterScope::channel ? context_.channel : 1;
  const int nth = scope == ParameterScope::global || index == 0 ? own : index;
  assert(nth >= 1 && nth <= count_of(scope));
  return first_[static_cast<std::size_t>(id)] + static_cast<std::size_t>(nth - 1);
}

double ParameterStore::value(ParameterId id, int index) const { return id == ParameterId::none ? 0 : now_.values[slot(id, index)]; }

bool ParameterStore::bit(ParameterId id, int bit, int index) const {
  return id != ParameterId::none && bit >= 0 && (bits_of(now_.values[slot(id, index)]) >> bit & 1u) != 0;
}

std::string ParameterStore::text(ParameterId id, int index) const {
  if (id == ParameterId::none) return {};
  const auto name = now_.texts.find(slot(id, index));
  if (name != now_.texts.end()) return name->second;
  const double code = value(id, index);
  return code == 0 ? std::string() : std::string(1, static_cast<char>(code));
}

Result<double> ParameterStore::read(double number, std::optional<double> bit, std::optional<double> index, Span where) const {
  const auto out_of_range = [&](char letter, double value) { return fail(alarm(AlarmId::value_out_of_range, where, letter, value)); };
  const auto whole = whole_within(number, 0, max_number);
  const ParameterId id = whole ? find(*whole) : ParameterId::none;
  // 24.2, inferred: PRM raises an alarm if no parameter has this number
  if (id == ParameterId::none) return fail(alarm(AlarmId::parameter_unknown, where, number));
  const ParameterRow& of = row(id);
  const bool of_bits = of.type == ParameterType::bits;
  if (of_bits && !bit) return fail(alarm(AlarmId::parameter_argument, where, 2.0));
  // 24.2, inferred: PRM raises an alarm if the number of the axis or spindle is missing
  if (needs_index(of.scope) && !index) return fail(alarm(AlarmId::parameter_argument, where, 3.0));
  const auto nth_bit = whole_within(bit.value_or(0), 0, of_bits ? bits_with_number - 1 : -1);
  // our choice: PRM raises an alarm for a bit that the parameter lacks; the manual does not describe this
  if (bit && !nth_bit) return out_of_range('Q', *bit);
  const auto nth = whole_within(index.value_or(1), 1, count_of(of.scope));
  const bool there = nth && (of.scope != ParameterScope::axis || has_axis(*nth));
  // our choice: PRM raises an alarm for a channel, axis or spindle that does not exist, or for a global parameter; the manual does not
  // describe this
  if (index && (!there || of.scope == ParameterScope::global)) return out_of_range('P', *index);
  const int at = index ? *nth : 0;
  return of_bits ? static_cast<double>(this->bit(id, *nth_bit, at)) : value(id, at);
}

namespace {

using Write = ParameterStore::Write;

Alarm missing(const Write& w, char letter) { return alarm(AlarmId::word_missing, w.block, letter, "G10 L52"); }
Alarm beyond(char letter, const ParameterStore::Word& word) { return alarm(AlarmId::value_out_of_range, word.where, letter, word.value); }

/// Returns the word P of the block as the index of a channel, axis or spindle; 0 if the parameter is global.
Result<int> index_of(const Write& w, ParameterScope scope, int own_channel) {
  if (!w.p) {
    // 24.1, inferred: a block that writes a parameter of an axis or spindle raises an alarm if P is missing
    if (needs_index(scope)) return fail(missing(w, 'P'));
    return scope == ParameterScope::channel ? own_channel : 0;
  }
  const auto index = whole_within(w.p->value, 1, count_of(scope));
  // Our choice: P is an error if the parameter is global; the manual does not describe this case.
  if (!index || scope == ParameterScope::global) return fail(beyond('P', *w.p));
  return *index;
}

/// Returns the word Q of the block as a bit number. For a parameter without bits, returns whole_value.
Result<int> bit_of(const Write& w, ParameterType type) {
  if (type != ParameterType::bits) {
    // our choice: Q is an error if the parameter has no bits; the manual does not describe this case
    if (w.q) return fail(beyond('Q', *w.q));
    return whole_value;
  }
  if (!w.q) return fail(missing(w, 'Q'));
  const auto bit = whole_within(w.q->value, 0, bits_with_number - 1);
  if (!bit) return fail(beyond('Q', *w.q));
  return *bit;
}

}  // namespace

Status ParameterStore::write(const Write& w) {
  if (!w.n) return fail(missing(w, 'N'));
  const auto number = whole_within(w.n->value, 0, max_number);
  const ParameterId id = number ? find(*number) : ParameterId::none;
  if (id == ParameterId::none) return fail(alarm(AlarmId::parameter_unknown, w.n->where, w.n->value));
  const ParameterRow& of = row(id);
  if (of.when != ParameterClass::run_time) return fail(alarm(AlarmId::parameter_not_writable, w.n->where, std::string_view(of.name)));
  const auto index = macro_b::index_of(w, of.scope, context_.channel);
  if (!index) return fail(index.error());
  if (of.scope == ParameterScope::axis && !has_axis(*index)) return fail(beyond('P', *w.p));
  const auto bit = macro_b::bit_of(w, of.type);
  if (!bit) return fail(bit.error());
  if (!w.r) return fail(missing(w, 'R'));
  const std::size_t at = slot(id, *index);
  const double present = *bit == whole_value ? now_.values[at] : static_cast<double>(this->bit(id, *bit, *index));
  const double value = w.r->value + (w.increment ? present : 0);
  if (!fits(of, *bit, value)) return fail(beyond('R', *w.r));
  const Place place = {static_cast<int>(id), *index, *bit};
  const auto name = now_.texts.find(at);
  Undo old = {at, now_.values[at], name == now_.texts.end() ? std::string() : name->second, std::nullopt};
  if (now_.written.insert(place).second) old.place = place;
  journal_.on_undo([this, old = std::move(old)] { undo_block(old); });
  assign(at, *bit, value);
  ++now_.version;
  return {};
}

void ParameterStore::undo_block(const Undo& write) {
  now_.values[write.slot] = write.value;
  now_.texts.erase(write.slot);
  if (!write.text.empty()) now_.texts[write.slot] = write.text;
  if (write.place) now_.written.erase(*write.place);
  ++now_.version;
}

/// Returns true if a program has overwritten, for its own channel, a value that the set-up gave for all channels.
bool ParameterStore::own_written(const Given& given) const {
  const Place& of = given.place;
  return std::any_of(now_.written.begin(), now_.written.end(), [&](const Place& place) {
    return place.row == of.row && place.index == context_.channel && (of.bit == whole_value || of.bit == place.bit);
  });
}

ParameterValue ParameterStore::in_force(const Place& place, bool as_text) const {
  const auto id = static_cast<ParameterId>(place.row);
  if (as_text) return text(id, place.index);
  return place.bit == whole_value ? value(id, place.index) : static_cast<double>(bit(id, place.bit, place.index));
}

ParameterKey ParameterStore::key_of(const Place& place) const {
  const std::string index = place.index == 0 ? std::string() : std::to_string(place.index);
  const std::string& name = rows_[static_cast<std::size_t>(place.row)].name;
  if (place.bit < bits_with_number) return {name, index, place.bit == whole_value ? std::string() : std::to_string(place.bit)};
  return {name, index, rows_[static_cast<std::size_t>(place.row)].bits[static_cast<std::size_t>(place.bit)]};
}

Parameters ParameterStore::written() const {
  Parameters all;
  std::set<Place> given_places;
  for (const auto& [key, given] : given_) {
    const bool as_text = std::holds_alternative<std::string>(given.value);
    const ParameterScope scope = rows_[static_cast<std::size_t>(given.place.row)].scope;
    const bool of_all = given.place.index == 0 && scope != ParameterScope::global;
    if (!of_all) {
      all[key] = in_force(given.place, as_text);
      given_places.insert(given.place);
    } else if (scope == ParameterScope::channel && own_written(given)) {
      all[key] = in_force(given.place, as_text);
      for (int channel = 1; channel <= count_of(scope); ++channel) {
        const Place place = {given.place.row, channel, given.place.bit};
        all.emplace(key_of(place), in_force(place, as_text));
        given_places.insert(place);
      }
    } else {
      all[key] = given.value;
    }
  }
  for (const Place& place : now_.written)
    if (!given_places.contains(place) && !given_places.contains({place.row, place.index, whole_value}))
      all[key_of(place)] = in_force(place, false);
  return all;
}

}  // namespace kadr::macro_b
