#pragma once
// XmlScan: reads the elements of an XML text one at a time with expat, without storing a tree. XmlScan refuses a text with a document type
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
  /// Returns the element's name exactly as the text has it, including the prefix.
  std::string_view name() const;
  std::size_t depth() const;
  /// Returns the value of an attribute; nullptr if the element has no attribute of that name. The end of an element has no attributes.
  const std::string* attribute(std::string_view name) const;
  /// Returns an error message with line and column.
  std::string fault() const;
  std::string location_here() const;  // position of the element for a message, such as "line 3, column 5: "

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace kadr
