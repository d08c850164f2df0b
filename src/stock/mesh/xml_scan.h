#pragma once
// XmlScan: reads the elements of an XML text one at a time with expat, without building a tree. A text with a document type is
// refused, so no entity is ever resolved.

#include <memory>
#include <string>
#include <string_view>

namespace kadr {

class XmlScan {
 public:
  enum class Event { opens, closes, ends, fault };

  /// `text` must outlive the scan.
  explicit XmlScan(std::string_view text);
  ~XmlScan();
  XmlScan(const XmlScan&) = delete;
  XmlScan& operator=(const XmlScan&) = delete;

  /// Moves to the next begin or end of an element; an empty element has both.
  Event next();
  /// The element's name as written, with its prefix.
  std::string_view name() const;
  std::size_t depth() const;
  /// Returns nullptr if the element has no attribute of that name. At the end of an element this is always so.
  const std::string* attribute(std::string_view name) const;
  /// Returns a message with line and column.
  std::string fault() const;
  std::string told_here() const;  // "line 3, column 5: " of the element

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace kadr
