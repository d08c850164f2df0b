// Checks the limits of TOML text before it is parsed. Used by config/tools/toml_tools; tested by tests/config/toml_scan_test.cpp.

#include "config/toml_scan.h"

#include <algorithm>

#include "config/read_file.h"
#include "texts/toml_faults.h"

namespace kadr {
namespace {

class TomlScan {
 public:
  TomlScan(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::string run() {
    while (at_ < text_.size() && fault_.empty()) {
      const char c = text_[at_];
      if (c == '#') at_ = std::min(text_.find('\n', at_), text_.size());
      else if (c == '"' || c == '\'') string(c);
      else {
        sign(c);
        ++at_;
      }
    }
    return fault_;
  }

 private:
  void sign(char c) {
    if (c == '\n' && depth_ == 0) begins_ = true, parts_ = 1;
    if (c == '[' || c == '{') open(c);
    if ((c == ']' || c == '}') && depth_ > 0) --depth_, parts_ = 1;
    if (c == '.') part();
    if (c == '=' || c == ',') parts_ = 1, value();
    if (c != ' ' && c != '\t' && c != '\n' && c != '\r') begins_ = false;
  }

  /// Counts an opening bracket. A bracket at the start of a line, outside of a value, opens a heading, [a] or [[a]], which ends with the
  /// line.
  void open(char c) {
    value();
    if (begins_ && c == '[') {
      parts_ = 1;
      if (at_ + 1 < text_.size() && text_[at_ + 1] == '[') ++at_, ++depth_;
    }
    if (++depth_ > limits::toml_depth) fault(counted(texts::toml_faults::too_deep, limits::toml_depth));
  }

  /// Counts one part of a dotted key. Decimal points in numbers are counted too; this does no harm, because the limits are high.
  void part() {
    value();
    if (++parts_ > limits::toml_key_parts) fault(translated(texts::toml_faults::too_many_key_parts, limits::toml_key_parts));
  }

  void value() {
    if (++values_ > limits::toml_values) fault(translated(texts::toml_faults::too_many_values, limits::toml_values));
  }

  /// Skips a string of one or several lines. A single-line string without an end in its line is not reported here, because the parser
  /// rejects it.
  void string(char quote) {
    begins_ = false;
    const std::string three(3, quote);
    const bool lines = text_.substr(at_, 3) == three;
    at_ += lines ? 3 : 1;
    for (; at_ < text_.size(); ++at_) {
      if (quote == '"' && text_[at_] == '\\') {
        ++at_;
        continue;
      }
      if (!lines && text_[at_] == '\n') return;
      if (text_[at_] != quote) continue;
      if (lines && text_.substr(at_, 3) != three) continue;
      at_ += lines ? 3 : 1;
      // The last string of """a"""" contains a quote: up to two quotes before the closing three belong to the string.
      for (int more = 0; lines && more < 2 && at_ < text_.size() && text_[at_] == quote; ++more) ++at_;
      return;
    }
  }

  void fault(const std::string& sentence) { fault_ = location_prefix(file_, text_, at_) + sentence; }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0, depth_ = 0, parts_ = 1, values_ = 0;
  bool begins_ = true;  // true while the scan has met nothing but blanks since the start of the line
  std::string fault_;
};

}  // namespace

std::string toml_limit_message(std::string_view text, const std::string& file) { return TomlScan(text, file).run(); }

}  // namespace kadr
