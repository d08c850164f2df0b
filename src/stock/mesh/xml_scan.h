#pragma once
// XmlScan: the elements of an XML text one after another, without building a tree: expat, asked for one at a time. No entity is ever
// looked up: a text with a document type is refused.

#include <memory>
#include <string>
#include <string_view>

namespace kadr {

class XmlScan {
 public:
  enum class Event { opens, closes, ends, fault };

  /// `text`: outlives the scan.
  explicit XmlScan(std::string_view text);
  ~XmlScan();
  XmlScan(const XmlScan&) = delete;
  XmlScan& operator=(const XmlScan&) = delete;

  /// The next begin or end of an element; an empty element has both.
  Event next();
  /// Of the element, as it is written.
  std::string_view name() const;
  std::size_t depth() const;
  /// nullptr: the element has none of that name. When it has closed, those of its begin may still be there.
  const std::string* attribute(std::string_view name) const;
  /// A sentence with line and column.
  std::string fault() const;
  std::string told_here() const;  // "line 3, column 5: " of the element

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace kadr
