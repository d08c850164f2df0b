// Encodings of program text: detects the encoding of a file, and converts its lines to UTF-8 (iconv). Used by cli, config, control,
// lang; tested by tests/lang/encoding_test.cpp.

#include "lang/text/encoding.h"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "base/ascii.h"
#include "lang/text/eia.h"
#include "lang/text/tape_orientation.h"

namespace kadr {
namespace {

// ---- one-byte encodings: iconv converts all bytes above 127 once, and the results are stored in a table

struct Utf8 {
  std::array<char, 4> bytes{};
  std::uint8_t size = 0;
};
using HighHalf = std::array<Utf8, 128>;

HighHalf load_high_half(const char* iconv_name) {
  HighHalf half;
  const iconv_t converter = iconv_open("UTF-8", iconv_name);
  // if iconv does not have the encoding, all bytes above 127 count as bytes without a meaning
  if (converter == reinterpret_cast<iconv_t>(-1)) return half;
  for (std::size_t i = 0; i < half.size(); ++i) {
    char byte = static_cast<char>(128 + i);
    char* from = &byte;
    char* to = half[i].bytes.data();
    std::size_t from_left = 1;
    std::size_t to_left = half[i].bytes.size();
    iconv(converter, nullptr, nullptr, nullptr, nullptr);
    if (iconv(converter, &from, &from_left, &to, &to_left) != static_cast<std::size_t>(-1))
      half[i].size = static_cast<std::uint8_t>(half[i].bytes.size() - to_left);
  }
  iconv_close(converter);
  return half;
}

const HighHalf& high_half(Encoding encoding) {
  static const HighHalf cp1251 = load_high_half("CP1251");
  static const HighHalf koi8r = load_high_half("KOI8-R");
  static const HighHalf cp866 = load_high_half("CP866");
  return encoding == Encoding::cp1251 ? cp1251 : encoding == Encoding::koi8r ? koi8r : cp866;
}

/// Returns the number of ASCII bytes at the start of `bytes`. The function checks eight bytes at a time.
std::size_t ascii_run(std::string_view bytes) {
  std::size_t i = 0;
  for (std::uint64_t eight = 0; i + sizeof eight <= bytes.size(); i += sizeof eight) {
    std::memcpy(&eight, bytes.data() + i, sizeof eight);
    if ((eight & 0x8080808080808080u) != 0) break;
  }
  while (i < bytes.size() && !is_high(bytes[i])) ++i;
  return i;
}

Span byte_at(std::size_t i) { return {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + 1)}; }

Status append_rows(std::string_view rows, std::string& text) {
  TapeLetters letters;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = static_cast<std::uint8_t>(rows[i]);
    if (!has_even_parity(row)) return fail(alarm(AlarmId::parity_error, byte_at(i), static_cast<double>(i + 1)));
    letters.append(row & 0x7F, text);
  }
  return {};
}

/// Appends the characters of rows in EIA code.
Status append_eia_rows(std::string_view rows, std::string& text) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = static_cast<std::uint8_t>(rows[i]);
    const auto character = eia_character(row);
    if (row != 0 && !character) return fail(alarm(AlarmId::parity_error, byte_at(i), static_cast<double>(i + 1)));
    if (character && *character != 0) text += *character;
  }
  return {};
}

// ---- detection: how probable the Russian words of the sample are in each encoding

/// The cost of a letter after another letter, in half bits: 'a' is 0, 'z' is 12.5 bits and more. Table rows are the first letter of the
/// pair; columns are the second: а..я and the start or end of a word. The pairs were counted in the words of the controls' manuals (spec/)
/// and of the workshop (СВЕРЛО, ФРЕЗА, …). Each word is weighted by the square root of its count. ПС, which ends every block, has the
/// weight of a frequent word.
constexpr std::size_t word_edge = 32;
constexpr std::array<std::string_view, 33> pair_cost = {
    "zlinjinjtqkiigwkkkhyznnkrlzzzvkjg",  // а
    "izzzzhrzhzkivlfzfkrislopzkqhrzznm",  // б
    "eyozrgztizjiqjgpklmkzrzzsuzgwzypi",  // в
    "hzzzklztjzvgondzfzzjzzzuzzzzzzzzj",  // г
    "fzkotfzzgzmkwjhminsizpxwrxsmtzpnj",  // д
    "wqmmjonltkliifppgjhttopnpnzzzztvf",  // е
    "gyyyhdyyfykysfyyyyykyyyyyyyyyyyym",  // ж
    "drjomjpzjzmmighzmzzkzznzzzwjnzzpk",  // з
    "ooknnhokkllmihopjihpqmlkqwzzzzmhg",  // и
    "zzzzqzzzzzlnnkzzzhozzzztnvzvzzzzb",  // й
    "ezozzkrzhzvizqezhnkjzzkzwyzyzzzzj",  // к
    "hrztzfovgzmozkgxwqzkuzyzwzzofzjik",  // л
    "gvptzezzgyrvinipzqvjzzzzyzzkzzzpe",  // м
    "fzwulizufzlzzhfzzmjkrqpszzzhozzlm",  // н
    "zjgiiklmoiliijnkihisvptlptzzzvzoh",  // о
    "jzzzzhzzjzrlzsepefyjzzuyzzzruzzqn",  // п
    "ezoqnfoyhzqomlfnnppispqzpxzlszzmk",  // р
    "kvlsrlzzjziimmikqnemrpvmqyznnzwgg",  // с
    "gwizqhzzizmprkguhhxlzsypzzzlgzzrg",  // т
    "ompikjkozxlijkvjkgkzqpzivlzzzzgsf",  // у
    "gxxxxgxxhxxlnxfxexxgnxxxxxxxxxxxr",  // ф
    "mzmzzpzqqztmpjezimzuzzzzzzzzzzzuc",  // х
    "iyyyyfyybyyyyymyyrynyyyyyyykyyyyi",  // ц
    "fzzzzdzzezitvgrlzsknzzzztzzzrzzzr",  // ч
    "fxxxxexxexjqxkmgsxjnxxxxxxxxpxxxp",  // ш
    "fzzzzczzeuzzzuzzzzzjzzzzzzzsozzzu",  // щ
    "nnnnnbnnnnnnnnnnnnnnnnnnnnnnnnnhn",  // ъ
    "zmgzjgzjwhllgtwkokmzzgznmqzwzzzzf",  // ы
    "zntzzpzjtzlzzezzzinzzzwwktzzzzlrc",  // ь
    "ttmtjttttlggittttoctktttttttttttt",  // э
    "znzznzzzzmzuozzzunftzzzgsezzzzzzd",  // ю
    "xznrniqmzxrtjlzvmojzznnrzmzzzzkqb",  // я
    "nlhmjpsjjzinkihejhkkmpnmotzyyozrz",  // start of a word
};
// cost of a capital after a small letter, or of a small letter after two capitals; such letters mean that the encoding is probably wrong
constexpr int mixed_case_cost = 24;
constexpr int typography_cost = 20;  // cost of №, quotes, dashes and degree signs, which are rare but occur in text
constexpr int other_sign_cost = 48;  // cost of box-drawing characters, fractions and letters of other languages

struct Sign {
  std::size_t letter = word_edge;  // index of the letter in the table: а..я are 0..31
  bool capital = false;
  int cost = 0;  // cost of the character if it is not a Russian letter
};

Sign sign_of(Encoding encoding, char byte) {
  if (!is_high(byte)) return {};
  const char32_t code = first_character(utf8_of(encoding, static_cast<std::uint8_t>(byte))).code;
  if (code >= U'А' && code <= U'я') return {(code - U'А') % 32, code < U'а', 0};
  if (code == U'Ё' || code == U'ё') return {5, code == U'Ё', 0};
  constexpr std::u32string_view typography = U"№«»–—°±";
  return {word_edge, false, typography.find(code) != std::u32string_view::npos ? typography_cost : other_sign_cost};
}

/// Returns the cost of the sample as text in `encoding`, which is the sum of the costs of its characters. An improbable pair of letters
/// costs more.
std::uint64_t cost_of(std::string_view sample, Encoding encoding) {
  std::array<Sign, 256> signs;
  for (std::size_t i = 0; i < signs.size(); ++i) signs[i] = sign_of(encoding, static_cast<char>(i));
  std::uint64_t cost = 0;
  Sign last;
  std::size_t length = 0;  // number of letters of the word that were read so far
  const auto add = [&](const Sign& sign) {
    const bool in_word = sign.letter != word_edge;
    if (in_word || length > 0) cost += static_cast<std::uint64_t>(pair_cost[last.letter][sign.letter] - 'a');
    const bool rises = length > 0 && sign.capital && !last.capital;
    const bool falls = length > 1 && in_word && !sign.capital && last.capital;
    cost += static_cast<std::uint64_t>(sign.cost + (rises || falls ? mixed_case_cost : 0));
    length = in_word ? length + 1 : 0;
    last = sign;
  };
  for (const char byte : sample) add(signs[static_cast<unsigned char>(byte)]);
  add(Sign{});
  return cost;
}

/// Returns true if the sample is valid UTF-8. The last character of the sample may be incomplete.
bool is_utf8(std::string_view sample) {
  bool any = false;
  while (!sample.empty()) {
    sample.remove_prefix(ascii_run(sample));
    if (sample.empty()) break;
    const std::size_t size = first_character(sample).size;
    if (size == 0) {
      const auto wanted = static_cast<std::size_t>(std::countl_one(static_cast<unsigned char>(sample[0])));
      const bool cut =
          sample.size() < wanted && wanted <= 4 && std::all_of(sample.begin() + 1, sample.end(), [](char c) { return (c & 0xC0) == 0x80; });
      return any && cut;
    }
    any = true;
    sample.remove_prefix(size);
  }
  return any;
}

/// Returns true if valid UTF-8 more probably is text in small letters of CP866. The words ход, шаг, раз in CP866 happen to be valid UTF-8,
/// with rare Asian letters.
bool is_small_cp866(std::string_view sample) {
  return std::all_of(sample.begin(), sample.end(), [](char c) {
    const int row = static_cast<unsigned char>(c) >> 4;
    return row < 8 || row == 0xA || row == 0xE;
  });
}

}  // namespace

Character first_character(std::string_view text) {
  if (text.empty()) return {};
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return {lead, 1};
  const auto size = static_cast<std::size_t>(std::countl_one(lead));
  if (size < 2 || size > 4 || text.size() < size) return {};
  char32_t code = lead & (0x7Fu >> size);
  for (std::size_t i = 1; i < size; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0) != 0x80) return {};
    code = code << 6 | (next & 0x3Fu);
  }
  // By length of a UTF-8 character in bytes: the least character code. A smaller code is invalid, since it has a shorter form.
  constexpr std::array<char32_t, 5> smallest = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < smallest[size] || code > 0x10FFFF || surrogate) return {};
  return {code, size};
}

std::string_view utf8_of(Encoding encoding, std::uint8_t byte) {
  const Utf8& character = high_half(encoding)[byte & 0x7F];
  return {character.bytes.data(), character.size};
}

std::string_view name_of(Encoding encoding) {
  switch (encoding) {
    case Encoding::utf8: return "utf-8";
    case Encoding::cp1251: return "cp1251";
    case Encoding::koi8r: return "koi8-r";
    case Encoding::cp866: return "cp866";
    case Encoding::eia: return "eia";
    case Encoding::iso7: return "iso-7";
  }
  return {};
}

std::optional<Encoding> encoding_named(std::string_view name) {
  std::string plain;  // name in small letters, without separators: "Windows-1251" equals "windows1251"
  for (const char c : name)
    if (c != '-' && c != '_' && c != ' ') plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  struct Name {
    std::string_view name;
    Encoding encoding;
  };
  constexpr Name names[] = {{"utf8", Encoding::utf8},          {"ascii", Encoding::utf8},   {"cp1251", Encoding::cp1251},
                            {"windows1251", Encoding::cp1251}, {"koi8r", Encoding::koi8r},  {"koi8", Encoding::koi8r},
                            {"cp866", Encoding::cp866},        {"ibm866", Encoding::cp866}, {"iso7", Encoding::iso7},
                            {"tape", Encoding::iso7},          {"eia", Encoding::eia},      {"rs244", Encoding::eia}};
  for (const Name& row : names)
    if (row.name == plain) return row.encoding;
  return std::nullopt;
}

std::optional<Encoding> detect_encoding(std::string_view sample) {
  if (ascii_run(sample) == sample.size()) return std::nullopt;
  if (const auto tape = inspect_tape(sample)) return tape->code == TapeCode::eia ? Encoding::eia : Encoding::iso7;
  if (is_utf8(sample) && !is_small_cp866(sample)) return Encoding::utf8;
  auto best = Encoding::cp1251;  // the more frequent encoding comes first and wins if two encodings have the same cost
  std::uint64_t least = cost_of(sample, best);
  for (const Encoding encoding : {Encoding::cp866, Encoding::koi8r}) {
    const std::uint64_t cost = cost_of(sample, encoding);
    if (cost >= least) continue;
    least = cost;
    best = encoding;
  }
  return best;
}

Status append_utf8(std::string_view bytes, Encoding encoding, std::string& text) {
  if (encoding == Encoding::iso7) return append_rows(bytes, text);
  if (encoding == Encoding::eia) return append_eia_rows(bytes, text);
  std::size_t i = 0;
  while (true) {
    const std::size_t run = ascii_run(bytes.substr(i));
    text.append(bytes, i, run);
    i += run;
    if (i == bytes.size()) return {};
    const auto byte = static_cast<std::uint8_t>(bytes[i]);
    const std::size_t size = encoding == Encoding::utf8 ? first_character(bytes.substr(i)).size : 1;
    const std::string_view character = encoding == Encoding::utf8 ? bytes.substr(i, size) : utf8_of(encoding, byte);
    if (character.empty()) return fail(alarm(AlarmId::bad_encoding, byte_at(i), static_cast<double>(byte)));
    text.append(character);
    i += size;
  }
}

char look_alike(char32_t letter) {
  constexpr std::u32string_view cyrillic = U"АВЕКМНОРСТУХІЈЅавекмнорстухіјѕ";
  constexpr std::string_view latin = "ABEKMHOPCTYXIJSABEKMHOPCTYXIJS";
  static_assert(cyrillic.size() == latin.size());
  const std::size_t at = cyrillic.find(letter);
  return at == std::u32string_view::npos ? '\0' : latin[at];
}

}  // namespace kadr
