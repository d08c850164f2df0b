// Packs TOML tables as bytes. A node is one byte for its type, followed by, for a text: its length, its bytes; a whole number: the value in
// two's complement; a real number: its 8 bytes; a list: the number of nodes, the nodes; a table: the number of pairs, the pairs, each a key
// (length, bytes) and a node. Lengths, counts and whole numbers are stored with 7 bits per byte, low bits first.

#include "config/packed_toml.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <stdexcept>
#include <type_traits>

namespace kadr {
namespace {

enum class Kind : char { text, whole, real, no, yes, list, table };

class Packer {
 public:
  void pairs(const toml::table& table) {
    number(table.size());
    for (const auto& [key, value] : table) {
      text(key.str());
      node(value);
    }
  }

  std::string bytes;

 private:
  void number(std::uint64_t n) {
    for (; n >= 128; n >>= 7) bytes += static_cast<char>((n & 127) | 128);
    bytes += static_cast<char>(n);
  }
  void kind(Kind k) { bytes += static_cast<char>(k); }
  void text(std::string_view t) {
    number(t.size());
    bytes += t;
  }

  void node(const toml::node& n) {
    if (const auto* const table = n.as_table()) {
      kind(Kind::table);
      pairs(*table);
    } else if (const auto* const list = n.as_array()) {
      kind(Kind::list);
      number(list->size());
      for (const toml::node& item : *list) node(item);
    } else if (const auto* const words = n.as_string()) {
      kind(Kind::text);
      text(words->get());
    } else if (const auto* const whole = n.as_integer()) {
      kind(Kind::whole);
      number(static_cast<std::uint64_t>(whole->get()));
    } else if (const auto* const real = n.as_floating_point()) {
      kind(Kind::real);
      const auto image = std::bit_cast<std::uint64_t>(real->get());
      for (int i = 0; i < 8; ++i) bytes += static_cast<char>((image >> (8 * i)) & 255);
    } else if (const auto* const truth = n.as_boolean()) {
      kind(truth->get() ? Kind::yes : Kind::no);
    } else {
      throw std::invalid_argument("a date or a time");
    }
  }
};

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  toml::table pairs() {
    toml::table table;
    for (std::uint64_t left = number(); left != 0; --left) {
      const std::string_view key = text();
      node([&](auto&& value) { table.emplace_hint(table.cend(), key, std::forward<decltype(value)>(value)); });
    }
    return table;
  }

  toml::table pairs_of(std::initializer_list<std::string_view> keys) {
    toml::table table;
    for (std::uint64_t left = number(); left != 0; --left) {
      const std::string_view key = text();
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) pass();
      else node([&](auto&& value) { table.emplace_hint(table.cend(), key, std::forward<decltype(value)>(value)); });
    }
    return table;
  }

  std::vector<std::string> list_of(std::string_view key) {
    std::vector<std::string> texts;
    for (std::uint64_t left = number(); left != 0; --left) {
      if (text() != key) {
        pass();
        continue;
      }
      node([&](auto&& value) {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, toml::array>)
          for (const toml::node& item : value) texts.push_back(item.value_or(std::string()));
      });
    }
    return texts;
  }

  template <class Take>
  void texts(const Take& take) {
    for (std::uint64_t tables = number(); tables != 0; --tables) {
      const std::string_view name = text();
      if (static_cast<Kind>(byte()) != Kind::table) throw std::invalid_argument("no table");
      for (std::uint64_t left = number(); left != 0; --left) {
        const std::string_view key = text();
        node([&](auto&& value) {
          if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string_view>) take(name, key, value);
        });
      }
    }
  }

 private:
  std::uint64_t byte() { return static_cast<unsigned char>(bytes_[at_++]); }
  std::uint64_t number() {
    std::uint64_t n = 0;
    for (int shift = 0;; shift += 7) {
      const std::uint64_t b = byte();
      n |= (b & 127) << shift;
      if (b < 128) return n;
    }
  }
  std::string_view text() {
    const std::uint64_t size = number();
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

  /// Skips the next node and everything that it contains.
  void pass() {
    switch (static_cast<Kind>(byte())) {
      case Kind::text: text(); return;
      case Kind::whole: number(); return;
      case Kind::real: at_ += 8; return;
      case Kind::no:
      case Kind::yes: return;
      case Kind::list:
        for (std::uint64_t left = number(); left != 0; --left) pass();
        return;
      case Kind::table:
        for (std::uint64_t left = number(); left != 0; --left) {
          text();
          pass();
        }
        return;
    }
  }

  /// Calls `take` with the value of the next node, in the type of this value.
  template <class Take>
  void node(const Take& take) {
    switch (static_cast<Kind>(byte())) {
      case Kind::text: return take(text());
      case Kind::whole: return take(static_cast<std::int64_t>(number()));
      case Kind::real: {
        std::uint64_t image = 0;
        for (int i = 0; i < 8; ++i) image |= byte() << (8 * i);
        return take(std::bit_cast<double>(image));
      }
      case Kind::no: return take(false);
      case Kind::yes: return take(true);
      case Kind::list: return take(items());
      case Kind::table: return take(pairs());
    }
  }

  toml::array items() {
    toml::array list;
    std::uint64_t left = number();
    list.reserve(left);
    for (; left != 0; --left) node([&](auto&& value) { list.push_back(std::forward<decltype(value)>(value)); });
    return list;
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace

std::string packed(const toml::table& table) {
  Packer packer;
  packer.pairs(table);
  return std::move(packer.bytes);
}

toml::table unpacked(std::string_view bytes) { return Unpacker(bytes).pairs(); }

toml::table unpacked(std::string_view bytes, std::initializer_list<std::string_view> keys) { return Unpacker(bytes).pairs_of(keys); }

std::vector<std::string> texts_of_list(std::string_view bytes, std::string_view key) { return Unpacker(bytes).list_of(key); }

void each_text(std::string_view bytes,
               const std::function<void(std::string_view table, std::string_view key, std::string_view text)>& take) {
  Unpacker(bytes).texts(take);
}

}  // namespace kadr
