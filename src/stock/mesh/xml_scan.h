#pragma once
// XmlScan: reads the elements of an XML text one at a time with expat, without storing a tree. It refuses a text with a document type
// declaration, so that entities are never expanded.

#include <memory>
#include <string>
#include <string_view>

namespace kadr {

class XmlScan {
 public:
  enum class Event { opens, closes, ends, fault };

  /// `text` must remain valid as long as this object is used.
  explicit XmlScan(std::string_view text);
  ~XmlScan();
  XmlScan(const XmlScan&) = delete;
  XmlScan& operator=(const XmlScan&) = delete;

  /// Moves to the next begin or end of an element; an empty element has both a begin and an end.
  Event next();
  /// Returns the element's name as it is in the text, including its prefix.
  std::string_view name() const;
  std::size_t depth() const;
  /// Returns nullptr if the element has no attribute of that name. At the end of an element there are no attributes.
  const std::string* attribute(std::string_view name) const;
  /// Returns an error message with line and column.
  std::string fault() const;
  std::string location_here() const;  // "line 3, column 5: ", the position of the element

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace kadr
