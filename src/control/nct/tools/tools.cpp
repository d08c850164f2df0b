// Tool management (nct 12): the tables of tools, pockets and forms, tool call and change, tool life, data input by G10. Used by
// control/nct/memory; tested by tests/control/nct/tools_test.cpp.

#include "control/nct/tools/tools.h"

#include <cmath>
#include <limits>
#include <string>
#include <tuple>

namespace kadr::nct {
namespace {

// Bits of the column "tool info" in the manual's order (12.3.1). For a bit that is 0 the manual writes I, C, N, E, U; for a bit that is 1,
// V, T, L, D, S.
constexpr std::uint32_t valid = 1, by_time = 2, large = 4, searchable = 16;
constexpr int info_digits = 5, user_digits = 8;

constexpr std::uint32_t not_performed = 0, not_used = 1, used = 2, expired = 3;

constexpr int pockets_in_place_call = 10'000;  // a T word that names a pocket is Tiiiikkkk: magazine iiii, pocket kkkk
constexpr int max_forms = 20;
constexpr double max_dword = 99'999'999;

bool in_life(const ToolRow& row) { return row.status == not_used || row.status == used; }
bool has_one_pocket(int magazine) { return magazine >= 10 && magazine % 10 <= 1; }
bool is_spindle(int magazine) { return magazine >= 10 && magazine % 10 == 0; }
bool is_multi(int magazine) { return magazine >= 1 && magazine <= 4; }

/// Converts a number of the set-up, which may have any value, to a whole number between 0 and 1e9.
int whole_of(double number) { return static_cast<int>(std::clamp(number, 0.0, 1e9)); }
std::uint32_t type_of(const ToolRow& row) { return static_cast<std::uint32_t>(whole_of(row.type)); }

}  // namespace

ToolManagement::ToolManagement(const Setup& setup, ToolLimits limits)
    : limits_(limits), rows_(setup.tool_table), places_(setup.place_table), forms_(setup.form_table) {
  if (setup.tool <= 0) return;
  spindles_ = JournaledTable<int, InSpindle>({{main_spindle, {std::nullopt, static_cast<std::uint32_t>(setup.tool), {}}}});
}

int ToolManagement::search(std::uint32_t type) const {
  int best = 0;
  double counter = -std::numeric_limits<double>::infinity();
  for (const auto& [data, row] : rows()) {
    const bool candidate = in_life(row) || (row.status == not_performed && (row.info & searchable) != 0);
    if ((row.info & valid) == 0 || row.type != static_cast<double>(type) || !candidate || row.counter <= counter) continue;
    best = data;
    counter = row.counter;
  }
  return best;
}

std::optional<Pocket> ToolManagement::place_of(int data) const {
  if (data == 0) return std::nullopt;
  for (const auto& [pocket, there] : places())
    if (there == data) return pocket;
  return std::nullopt;
}

Pocket ToolManagement::only_pocket(int magazine) const {
  const auto found = places().lower_bound({magazine, std::numeric_limits<int>::min()});
  return found != places().end() && found->first.first == magazine ? found->first : Pocket{magazine, 1};
}

int ToolManagement::spindle_row(int magazine) const {
  const int* data = places_.find(only_pocket(magazine));
  return data != nullptr ? *data : 0;
}

Result<ToolCall> ToolManagement::call(std::uint32_t tool, CallBy by, int spindle) {
  ToolCall found{tool};
  if (by == CallBy::place) {
    found.magazine = static_cast<int>(tool / pockets_in_place_call);
    found.pocket = static_cast<int>(tool % pockets_in_place_call);
    const int* data = places_.find({found.magazine, found.pocket});
    const bool magazines_listed = std::any_of(places().begin(), places().end(), [](const auto& p) { return is_multi(p.first.first); });
    if (data == nullptr && magazines_listed) return fail(alarm(AlarmId::tool_not_found, {}, static_cast<double>(tool)));
    if (data != nullptr) found.data = *data;
  } else if (enabled() && tool != 0) {
    found.data = search(tool);
    if (found.data == 0) return fail(alarm(AlarmId::tool_not_found, {}, static_cast<double>(tool)));
    if (const auto place = place_of(found.data)) std::tie(found.magazine, found.pocket) = *place;
  }
  spindles_.edit(spindle).prepared = found;
  return found;
}

ToolCall ToolManagement::change(int spindle, CountUse count) {
  const InSpindle* before = spindles_.find(spindle);
  if (before == nullptr || !before->prepared) {
    const Pocket own = only_pocket(spindle);
    const int data = spindle_row(spindle);
    const ToolRow* there = row(data);
    const std::uint32_t known = before != nullptr ? before->tool : 0;
    return {there != nullptr ? type_of(*there) : known, data, own.first, own.second};
  }
  InSpindle& state = spindles_.edit(spindle);
  ToolCall now = *state.prepared;
  state.prepared.reset();
  // false: no table listed the tool when T was executed, so the table of pockets does not change
  const bool resolved = now.data != 0 || now.magazine != 0 || now.tool == 0;
  if (enabled() && resolved) exchange(state, now, spindle);
  state.tool = now.tool;
  const ToolRow* there = row(now.data);
  if (count == CountUse::yes && there != nullptr && (there->info & by_time) == 0) use(now.data, 1);
  return now;
}

/// Exchanges the tools in the table of pockets, and sets the pocket in `now` from which the new tool comes.
void ToolManagement::exchange(InSpindle& state, ToolCall& now, int spindle) {
  std::optional<Pocket> from;
  if (now.data != 0) from = place_of(now.data);  // searched again, because the tool may have been moved since T was executed
  else if (now.magazine != 0) from = Pocket{now.magazine, now.pocket};  // the T word has named a pocket that is empty
  std::tie(now.magazine, now.pocket) = from.value_or(Pocket{});
  const ToolRow* loaded = row(now.data);
  if (loaded != nullptr && loaded->type != 0) now.tool = type_of(*loaded);

  const int old = spindle_row(spindle);
  if (old == now.data) return;  // there is nothing to exchange: the tool is in the spindle already, or no tool is involved
  if (now.data != 0 && from) places_.edit(*from) = 0;
  places_.edit(only_pocket(spindle)) = now.data;
  if (old != 0) put_away(old, from, state.home);
  state.home = now.data != 0 ? from.value_or(Pocket{}) : Pocket{};
}

void ToolManagement::put_away(int data, const std::optional<Pocket>& first, Pocket second) {
  const auto is_free = [&](Pocket pocket) {
    const int* there = places_.find(pocket);
    return there != nullptr && *there == 0 && !is_spindle(pocket.first);
  };
  if (first && is_free(*first)) return set_place(*first, data);
  if (is_free(second)) return set_place(second, data);
  for (const auto& [pocket, there] : places())
    if (is_multi(pocket.first) && is_free(pocket)) return set_place(pocket, data);
}

void ToolManagement::use(int data, double amount) {
  const ToolRow* now = row(data);
  if (now == nullptr || (now->info & valid) == 0 || !in_life(*now)) return;
  ToolRow& tool = rows_.edit(data);
  tool.counter += amount;
  tool.status = tool.counter >= tool.life ? expired : used;
}

bool ToolManagement::counts_time() const {
  return std::any_of(rows().begin(), rows().end(), [](const auto& row) { return (row.second.info & by_time) != 0; });
}

void ToolManagement::add_time(double seconds, int spindle) {
  const int data = spindle_row(spindle);
  const ToolRow* tool = row(data);
  if (tool != nullptr && (tool->info & by_time) != 0 && seconds > 0) use(data, seconds);
}

bool ToolManagement::warning(int data) const {
  const ToolRow* tool = row(data);
  return tool != nullptr && (in_life(*tool) || tool->status == expired) && tool->life - tool->counter <= tool->warn;
}

std::optional<double> ToolManagement::spindle_data(int magazine, int variable) const {
  const int data = spindle_row(magazine);
  if (variable == 8401) return data;
  const ToolRow* tool = row(data);
  if (data == 0 || tool == nullptr) return std::nullopt;
  switch (variable) {
    case 8402: return tool->type;
    case 8403: return std::floor(tool->counter);
    case 8404: return tool->life;
    case 8405: return tool->warn;
    case 8406: return tool->status;
    case 8407: return tool->user_bits;
    case 8408: return tool->info;
    case 8409: return tool->h;
    case 8410: return tool->d;
    case 8411: return tool->s;
    case 8412: return tool->f;
    case 8413: return tool->g;
    case 8414: return tool->w;
    default: break;
  }
  const int user = variable - 8431;
  if (user < 0 || user >= std::min(limits_.user_data, static_cast<int>(tool->user.size()))) return std::nullopt;
  return tool->user[static_cast<std::size_t>(user)];
}

Status ToolManagement::check_magazine(double number) {
  const bool whole = number == std::floor(number) && number > 0 && number < pockets_in_place_call;
  if (!whole || !has_one_pocket(static_cast<int>(number))) return fail(alarm(AlarmId::magazine_number, {}, number));
  return {};
}

OffsetNumbers ToolManagement::offset_numbers(int spindle) const {
  const ToolRow* tool = row(spindle_row(spindle));
  if (tool == nullptr) return {};
  return {whole_of(tool->h), whole_of(tool->d), whole_of(tool->g), whole_of(tool->w)};
}

ToolForm ToolManagement::form_of(int data) const {
  const ToolRow* tool = row(data);
  if (tool == nullptr || (tool->info & large) == 0) return {};
  const ToolForm* form = forms_.find(static_cast<int>(tool->form));
  return form != nullptr ? *form : ToolForm{};
}

bool fits_next_to(int pocket_a, const ToolForm& a, int pocket_b, const ToolForm& b) {
  if (pocket_a == pocket_b) return false;
  if (pocket_a > pocket_b) return fits_next_to(pocket_b, b, pocket_a, a);
  return a.right + b.left <= 2.0 * (static_cast<double>(pocket_b) - pocket_a - 1);
}

std::optional<DataKind> data_kind(double l, double p) {
  if (l == 75 && p == 1) return DataKind::register_rows;
  if (l == 75 && p == 2) return DataKind::modify_rows;
  if (l == 75 && p == 3) return DataKind::delete_rows;
  if (l == 76 && p == 1) return DataKind::places;
  if (l == 77 && p == 6) return DataKind::forms;
  return std::nullopt;
}

namespace {

const DataWord* find(const DataBlock& block, char letter) {
  const auto found = std::find_if(block.words.begin(), block.words.end(), [&](const DataWord& w) { return w.letter == letter; });
  return found == block.words.end() ? nullptr : &*found;
}

Status only(const DataBlock& block, std::string_view letters) {
  for (const DataWord& word : block.words)
    if (letters.find(word.letter) == std::string_view::npos || find(block, word.letter) != &word)
      return fail(alarm(AlarmId::data_block, word.where, word.letter));
  return {};
}

tl::unexpected<Alarm> out_of_range(const DataWord& word) {
  return fail(alarm(AlarmId::value_out_of_range, word.where, word.letter, word.value));
}

/// Returns the value of the word; raises an alarm if the value is not a whole number from `least` to `most`.
Result<int> whole(const DataWord& word, double least, double most) {
  if (!(word.value >= least && word.value <= most) || word.value != std::floor(word.value)) return out_of_range(word);
  return static_cast<int>(word.value);
}

/// Returns the word with this letter; raises the alarm word_missing if the block has no word with this letter.
Result<const DataWord*> needed(const DataBlock& block, char letter, std::string_view code) {
  const DataWord* word = find(block, letter);
  if (word == nullptr) return fail(alarm(AlarmId::word_missing, block.where, letter, code));
  return word;
}
Result<int> needed_whole(const DataBlock& block, char letter, std::string_view code, double most) {
  return needed(block, letter, code).and_then([&](const DataWord* word) { return whole(*word, 0, most); });
}

/// Reads the decimal digits of a word as binary digits, so that Q10001 is 17. Leading zeros may be missing.
Result<std::uint32_t> bits(const DataWord& word, int max_bits) {
  std::string digits(word.digits);
  if (digits.empty()) {
    if (!(word.value >= 0 && word.value <= max_dword) || word.value != std::floor(word.value)) return out_of_range(word);
    digits = std::to_string(static_cast<int>(word.value));
  }
  std::uint32_t value = 0;
  for (const char digit : digits) {
    if (digit != '0' && digit != '1') return out_of_range(word);
    value = value * 2 + static_cast<std::uint32_t>(digit - '0');
    if (value >> max_bits != 0) return out_of_range(word);
  }
  return value;
}

/// A column of the tool table that has whole numbers (12.4.1). The type of column L is DWORD: 12.4.1 does not give it, but 12.3.1 does.
struct Item {
  char letter;
  double most;  // greatest permitted value of the column; 0: the greatest offset number N1400 is the limit
  double ToolRow::*number;
  std::uint32_t ToolRow::*code;
};
constexpr Item row_items[] = {
    {'T', max_dword, &ToolRow::type, nullptr},
    {'A', max_forms, nullptr, &ToolRow::form},
    {'B', 4, nullptr, &ToolRow::status},
    {'C', max_dword, &ToolRow::counter, nullptr},
    {'L', max_dword, &ToolRow::life, nullptr},
    {'I', max_dword, &ToolRow::warn, nullptr},
    {'H', 0, &ToolRow::h, nullptr},
    {'J', 0, &ToolRow::g, nullptr},
    {'D', 0, &ToolRow::d, nullptr},
    {'K', 0, &ToolRow::w, nullptr},
    {'S', max_dword, &ToolRow::s, nullptr},
};

Status place_block(const DataBlock& block, ToolManagement& tools) {
  constexpr std::string_view code = "G10 L76";
  KADR_TRY(only(block, "NPR"));
  const auto magazine = needed_whole(block, 'N', code, pockets_in_place_call - 1);
  KADR_TRY(magazine);
  if (!is_multi(*magazine) && !has_one_pocket(*magazine)) return out_of_range(*find(block, 'N'));
  Pocket pocket = tools.only_pocket(*magazine);  // word P (the pocket) has no effect in a magazine with one pocket
  if (is_multi(*magazine)) {
    const auto number = needed_whole(block, 'P', code, pockets_in_place_call - 1);
    KADR_TRY(number);
    pocket.second = *number;
  }
  const auto data = needed_whole(block, 'R', code, tools.limits().rows);
  KADR_TRY(data);
  tools.set_place(pocket, *data);
  return {};
}

Status form_block(const DataBlock& block, ToolManagement& tools) {
  KADR_TRY(only(block, "NPQRST"));
  const auto number = needed_whole(block, 'N', "G10 L77", max_forms);
  KADR_TRY(number);
  if (*number == 0) return out_of_range(*find(block, 'N'));
  ToolForm form;
  const std::pair<char, double ToolForm::*> items[] = {
      {'P', &ToolForm::left}, {'Q', &ToolForm::right}, {'R', &ToolForm::up}, {'S', &ToolForm::down}, {'T', &ToolForm::geometry}};
  for (const auto& [letter, column] : items) {
    const DataWord* word = find(block, letter);
    if (word == nullptr) continue;
    const auto value = whole(*word, 0, letter == 'T' ? 1 : max_dword);
    KADR_TRY(value);
    form.*column = *value;
  }
  tools.set_form(*number, form);
  return {};
}

}  // namespace

Status DataInput::block(const DataBlock& block, ToolManagement& tools) {
  if (block.words.empty()) return {};
  switch (kind_) {
    case DataKind::places: return place_block(block, tools);
    case DataKind::forms: return form_block(block, tools);
    default: return row_block(block, tools);
  }
}

Status DataInput::row_block(const DataBlock& block, ToolManagement& tools) {
  const DataWord* n = find(block, 'N');
  if (n != nullptr || kind_ == DataKind::delete_rows) {
    KADR_TRY(only(block, "N"));
    const auto number = whole(*n, 1, tools.limits().rows);
    KADR_TRY(number);
    if (kind_ != DataKind::modify_rows) tools.clear_row(*number);
    row_ = *number;
    return {};
  }
  const bool user = find(block, 'P') != nullptr || find(block, 'R') != nullptr;
  KADR_TRY(only(block, user ? "PR" : "TQABCLIHJDKSF"));
  if (row_ == 0) return fail(alarm(AlarmId::word_missing, block.where, 'N', "G10 L75"));
  return user ? user_item(block, tools) : items(block, tools);
}

Status DataInput::items(const DataBlock& block, ToolManagement& tools) const {
  const ToolRow* old = tools.row(row_);
  ToolRow row = old != nullptr ? *old : ToolRow{};
  for (const DataWord& word : block.words) {
    if (word.letter == 'Q') {
      const auto info = bits(word, info_digits);
      KADR_TRY(info);
      row.info = *info;
    } else if (word.letter == 'F') {
      if (!std::isfinite(word.value)) return out_of_range(word);
      row.f = word.value;
    } else {
      const Item& item = *std::find_if(std::begin(row_items), std::end(row_items), [&](const Item& i) { return i.letter == word.letter; });
      const auto value = whole(word, 0, item.most > 0 ? item.most : tools.limits().offsets);
      KADR_TRY(value);
      if (item.number != nullptr) row.*item.number = *value;
      if (item.code != nullptr) row.*item.code = static_cast<std::uint32_t>(*value);
    }
  }
  tools.edit_row(row_) = row;
  return {};
}

Status DataInput::user_item(const DataBlock& block, ToolManagement& tools) const {
  const int most = std::min(tools.limits().user_data, static_cast<int>(ToolRow{}.user.size()));
  const auto number = needed_whole(block, 'P', "G10 L75", most);
  KADR_TRY(number);
  const auto r = needed(block, 'R', "G10 L75");
  KADR_TRY(r);
  if (*number == 0) {
    const auto value = bits(**r, user_digits);
    KADR_TRY(value);
    tools.edit_row(row_).user_bits = *value;
    return {};
  }
  if (!std::isfinite((*r)->value)) return out_of_range(**r);
  tools.edit_row(row_).user[static_cast<std::size_t>(*number - 1)] = (*r)->value;
  return {};
}

}  // namespace kadr::nct
