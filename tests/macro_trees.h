#pragma once
// Random expressions of custom macros as trees. A tree is printed as text with random blanks, brackets and letters of both cases, and
// evaluated by a recursive reference evaluator that never sees the text (spec/nct/23 23.1.6, 23.2.2 – 23.2.7).

#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "base/alarm_ids.h"
#include "base/vec.h"
#include "choices.h"

namespace kadr::test {

inline double no_value() { return std::nan(""); }
inline bool is_empty(double x) { return std::isnan(x); }
inline bool same_value(double a, double b) { return a == b || (is_empty(a) && is_empty(b)); }

/// The value of a tree: a number, the empty value (NaN), or an alarm.
using TreeValue = std::variant<double, AlarmId>;
inline bool same_value(const TreeValue& a, const TreeValue& b) {
  if (a.index() != b.index()) return false;
  if (a.index() == 1) return std::get<1>(a) == std::get<1>(b);
  return same_value(std::get<0>(a), std::get<0>(b));
}
inline std::string value_text(const TreeValue& v) {
  if (v.index() == 1) return std::string(name_of(std::get<1>(v)));
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", std::get<0>(v));
  return is_empty(std::get<0>(v)) ? "empty" : text;
}

struct Tree {
  enum class Kind { number, variable, indirect, bracket, minus, function, pair } kind = Kind::number;
  std::string text;  // digits of the number; name of the function or of the operator
  int variable = 0;
  std::vector<Tree> parts;
};

/// Returns the value of #n to the reference evaluator.
using ReadNumber = std::function<TreeValue(double n)>;

// ---- the reference evaluator

inline TreeValue finite_or_alarm(double x) { return std::isfinite(x) ? TreeValue(x) : TreeValue(AlarmId::not_a_number); }

inline TreeValue bits(const std::string& op, double a, double b) {
  const auto fits = [](double v) { return v >= -4294967297.0 && v < 4294967296.0; };
  if (!fits(a) || !fits(b)) return AlarmId::bits_out_of_range;
  const auto whole = [](double v) {  // rounds to nearest, halves away from zero; the result must be in 0 … 2^32 - 1
    double n = v < 0 ? -std::floor(-v + 0.5) : std::floor(v + 0.5);
    while (n < 0) n += 4294967296.0;
    while (n >= 4294967296.0) n -= 4294967296.0;
    return n;
  };
  double x = whole(a), y = whole(b), result = 0;
  for (double bit = 2147483648.0; bit >= 1; bit /= 2) {
    const bool left = x >= bit, right = y >= bit;
    x -= left ? bit : 0;
    y -= right ? bit : 0;
    const bool on = op == "AND" ? left && right : op == "OR" ? left || right : op == "XOR" ? left != right : !left;
    if (on) result += bit == 2147483648.0 ? -bit : bit;
  }
  return result;
}

inline TreeValue of_pair(const std::string& op, double a, double b) {
  if (is_empty(a)) a = 0;
  if (is_empty(b)) b = 0;
  if (op == "+") return finite_or_alarm(a + b);
  if (op == "-") return finite_or_alarm(a - b);
  if (op == "*") return finite_or_alarm(a * b);
  if (op == "/" || op == "MOD") {
    if (b == 0) return AlarmId::division_by_zero;
    return op == "/" ? finite_or_alarm(a / b) : TreeValue(std::fmod(a, b));
  }
  return bits(op, a, b);
}

inline TreeValue of_function(const std::string& name, double x) {
  if (is_empty(x)) x = 0;
  if (name == "SQRT") return x < 0 ? TreeValue(AlarmId::root_of_negative) : TreeValue(std::sqrt(x));
  if (name == "SIN") return sincos_deg(x).sin;
  if (name == "COS") return sincos_deg(x).cos;
  if (name == "TAN")
    return std::fabs(std::fmod(x, 180)) == 90 ? TreeValue(AlarmId::tangent_of_right_angle)
                                              : TreeValue(sincos_deg(x).sin / sincos_deg(x).cos);
  if (name == "ASIN" || name == "ACOS") {
    if (std::fabs(x) > 1) return AlarmId::argument_above_one;
    return (name == "ASIN" ? std::asin(x) : std::acos(x)) / rad_per_deg;
  }
  if (name == "ATAN") return std::atan(x) / rad_per_deg;
  if (name == "EXP") return finite_or_alarm(std::exp(x));
  if (name == "LN") return x <= 0 ? TreeValue(AlarmId::argument_not_positive) : TreeValue(std::log(x));
  if (name == "ABS") return x < 0 ? -x : x;
  if (name == "FIX") return x < 0 ? std::ceil(x) : std::floor(x);
  if (name == "FUP") return x < 0 ? std::floor(x) : std::ceil(x);
  return bits("NOT", x, 0);
}

inline TreeValue value_of(const Tree& tree, const ReadNumber& read) {
  std::vector<double> parts;
  for (const Tree& part : tree.parts) {
    const TreeValue v = value_of(part, read);
    if (v.index() == 1) return v;
    parts.push_back(std::get<0>(v));
  }
  switch (tree.kind) {
    case Tree::Kind::number: return std::strtod(tree.text.c_str(), nullptr);
    case Tree::Kind::variable: return read(tree.variable);
    case Tree::Kind::indirect: return read(parts[0]);
    case Tree::Kind::bracket: return parts[0];  // brackets alone are not an operation: an empty value stays empty
    case Tree::Kind::minus: return is_empty(parts[0]) ? 0.0 : -parts[0];
    case Tree::Kind::function: return of_function(tree.text, parts[0]);
    default: return of_pair(tree.text, parts[0], parts[1]);
  }
}

/// IF[a op b]: the empty value is greater than every number and equal to itself (23.1.6).
inline bool holds(const std::string& relation, double a, double b) {
  const double infinity = HUGE_VAL;
  const double x = is_empty(a) ? infinity : a, y = is_empty(b) ? infinity : b;
  if (relation == "EQ") return x == y;
  if (relation == "NE") return x != y;
  if (relation == "GT") return x > y;
  if (relation == "LT") return x < y;
  if (relation == "GE") return x >= y;
  return x <= y;
}

// ---- random trees and their text

inline constexpr const char* tree_relations[] = {"EQ", "NE", "GT", "LT", "GE", "LE"};

inline Tree random_tree(Choices& choose, int depth, int variables) {
  static constexpr const char* numbers[] = {"1", "2", "0", "3.", ".5", "12.25", "100", "0.001", "90", "7", "4294967296", "45"};
  static constexpr const char* functions[] = {"ABS", "FIX", "FUP", "SQRT", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "EXP", "LN", "NOT"};
  static constexpr const char* operators[] = {"+", "-", "*", "/", "MOD", "AND", "OR", "XOR"};
  Tree tree;
  const std::size_t kind = depth == 0 ? choose.below(2) : choose.below(8);
  const auto part = [&] { tree.parts.push_back(random_tree(choose, depth - 1, variables)); };
  if (kind == 0) {
    tree.text = choose.of(numbers);
  } else if (kind == 1) {
    tree.kind = Tree::Kind::variable;
    tree.variable = choose.between(0, variables);
  } else if (kind == 2) {
    tree.kind = Tree::Kind::indirect, part();
  } else if (kind == 3) {
    tree.kind = Tree::Kind::bracket, part();
  } else if (kind == 4) {
    tree.kind = Tree::Kind::minus, part();
  } else if (kind == 5) {
    tree.kind = Tree::Kind::function, tree.text = choose.of(functions), part();
  } else {
    tree.kind = Tree::Kind::pair, tree.text = choose.of(operators), part(), part();
  }
  return tree;
}

/// Prints trees. `plain`: capitals only, no brackets but the necessary
/// ones, and a blank only where two words would otherwise become one.
class TreePrinter {
 public:
  TreePrinter(Choices& choose, bool plain) : choose_(choose), plain_(plain) {}

  std::string operator()(const Tree& tree) { return spelled(print(tree, 1)); }
  std::string blank() { return plain_ ? "" : std::string(choose_.below(3), ' '); }
  std::string spelled(std::string text) {
    for (char& c : text)
      if (!plain_ && c >= 'A' && c <= 'Z' && choose_.one_in(4)) c = static_cast<char>(c - 'A' + 'a');
    return text;
  }

 private:
  enum Place { sum = 1, product = 2, factor = 3, operand = 4 };

  static int binding(const Tree& tree) {
    switch (tree.kind) {
      case Tree::Kind::minus: return factor;
      case Tree::Kind::pair: return tree.text == "+" || tree.text == "-" || tree.text == "OR" || tree.text == "XOR" ? sum : product;
      default: return operand;
    }
  }

  /// Prints the tree for a position where an operator of at least rank
  /// `place` is required, with brackets if the tree binds less tightly.
  std::string print(const Tree& tree, int place) {
    if (binding(tree) < place || (!plain_ && choose_.one_in(6))) return "[" + blank() + print(tree, sum) + blank() + "]";
    switch (tree.kind) {
      case Tree::Kind::number: return tree.text;
      case Tree::Kind::variable: return "#" + blank() + std::to_string(tree.variable);
      case Tree::Kind::indirect: return "#" + blank() + "[" + print(tree.parts[0], sum) + blank() + "]";
      case Tree::Kind::bracket: return "[" + print(tree.parts[0], sum) + "]";
      case Tree::Kind::minus: return "-" + blank() + print(tree.parts[0], factor);
      case Tree::Kind::function: return tree.text + blank() + print(tree.parts[0], operand);
      default: {
        const int own = binding(tree);
        return print(tree.parts[0], own) + blank() + tree.text + blank() + print(tree.parts[1], own + 1);
      }
    }
  }

  Choices& choose_;
  bool plain_;
};

}  // namespace kadr::test
