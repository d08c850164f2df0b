#pragma once
// XmlScan: the elements of an XML text one after another, without building a tree. No entity is ever looked up: a text with a
// document type is refused.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kadr {

class XmlScan {
 public:
  enum class Event { opens, closes, ends, fault };

  explicit XmlScan(std::string_view text) : text_(text) {}
  /// The next begin or end of an element; an empty element has both.
  Event next();
  /// Of the element, as it is written.
  std::string_view name() const { return name_; }
  std::size_t depth() const { return open_.size(); }
  /// As it is written; nullptr: it has none.
  const std::string_view* attribute(std::string_view name) const;
  /// A sentence with line and column.
  std::string fault() const;
  std::string told_here() const;  // "line 3, column 5: " of the element

 private:
  Event failed(std::string what);
  bool skip_past(std::string_view mark);
  Event tag();
  bool attributes();
  void skip_blanks();
  std::string_view taken_name();

  std::string_view text_;
  std::size_t at_ = 0, element_ = 0;
  bool closes_next_ = false, had_root_ = false;
  std::string_view name_;
  std::vector<std::string_view> open_;
  std::vector<std::pair<std::string_view, std::string_view>> attributes_;
  std::string fault_;
};

}  // namespace kadr
