// Reads XML elements with expat. Used by stock/mesh/threemf_read.

#include "stock/mesh/xml_scan.h"

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

#include "config/read_file.h"
#include "stock/mesh/expat_library.h"
#include "stock/mesh/mesh_word_reader.h"
#include "texts/mesh_xml.h"

namespace kadr {
namespace {

constexpr std::size_t deepest = 64;
constexpr std::size_t piece = 1 << 16;  // number of bytes passed to expat at once; expat keeps a copy of these bytes
// Greatest length of a tag or comment in bytes; expat reads an unfinished tag again with each new portion of bytes.
constexpr std::size_t longest = 1 << 20;

std::string xml_error_message(XML_Error error) {
  switch (error) {
    case XML_ERROR_TAG_MISMATCH: return translated(texts::mesh_xml::tag_mismatch);
    case XML_ERROR_NO_ELEMENTS: return translated(texts::mesh_xml::not_closed);
    case XML_ERROR_UNCLOSED_TOKEN:
    case XML_ERROR_UNCLOSED_CDATA_SECTION: return translated(texts::mesh_xml::tag_not_whole);
    case XML_ERROR_DUPLICATE_ATTRIBUTE: return translated(texts::mesh_xml::attribute_twice);
    case XML_ERROR_JUNK_AFTER_DOC_ELEMENT: return translated(texts::mesh_xml::second_root);
    case XML_ERROR_NO_MEMORY: return translated(texts::mesh_xml::no_memory);
    default: return translated(texts::mesh_xml::not_xml);
  }
}

}  // namespace

/// Calls expat, which reports elements by callbacks. Each callback suspends the parser, and the next call of next() resumes it.
struct XmlScan::Parser {
  struct Element {
    Event event = Event::fault;
    std::string name;
    std::vector<std::pair<std::string, std::string>> attributes;
    std::size_t at = 0, depth = 0;
  };

  explicit Parser(std::string_view from) : text(from) {
    if (expat == nullptr || (parser = expat->XML_ParserCreate(nullptr)) == nullptr) return;
    expat->XML_SetUserData(parser, this);
    expat->XML_SetElementHandler(parser, &opens, &closes);
    expat->XML_SetStartDoctypeDeclHandler(parser, &has_type);
  }
  ~Parser() {
    if (parser != nullptr) expat->XML_ParserFree(parser);
  }
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  std::size_t place() const { return std::size_t(std::max<XML_Index>(expat->XML_GetCurrentByteIndex(parser), 0)); }

  static void opens(void* self, const XML_Char* name, const XML_Char** attributes) {
    Parser& p = *static_cast<Parser*>(self);
    if (p.open >= deepest) return p.refuse(translated(texts::mesh_xml::too_deep));
    Element& e = p.waiting.emplace_back(Element{Event::opens, name, {}, p.place(), ++p.open});
    for (; *attributes != nullptr; attributes += 2) e.attributes.emplace_back(attributes[0], attributes[1]);
    p.expat->XML_StopParser(p.parser, XML_TRUE);
  }
  static void closes(void* self, const XML_Char* name) {
    Parser& p = *static_cast<Parser*>(self);
    p.waiting.push_back({Event::closes, name, {}, p.place(), --p.open});
    p.expat->XML_StopParser(p.parser, XML_TRUE);
  }
  static void has_type(void* self, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    static_cast<Parser*>(self)->refuse(translated(texts::mesh_xml::document_type));
  }
  void refuse(std::string why) {
    fault = std::move(why), refused_at = place();
    expat->XML_StopParser(parser, XML_FALSE);
  }

  XML_Status go_on() {
    XML_ParsingStatus status;
    expat->XML_GetParsingStatus(parser, &status);
    if (status.parsing == XML_SUSPENDED) return expat->XML_ResumeParser(parser);
    const std::string_view part = text.substr(handed, piece);
    handed += part.size();
    const XML_Status done = expat->XML_Parse(parser, part.data(), int(part.size()), handed == text.size());
    if (done == XML_STATUS_OK && handed - std::min(place(), handed) > longest) {
      refuse(translated(texts::mesh_xml::tag_too_long));
      return XML_STATUS_ERROR;
    }
    return done;
  }
  bool is_done() const {
    XML_ParsingStatus status;
    expat->XML_GetParsingStatus(parser, &status);
    return status.parsing == XML_FINISHED;
  }

  /// Moves to the next begin or end of an element, and stores it in `now`.
  Event next() {
    while (waiting.empty()) {
      if (parser == nullptr) return failed(0, translated(texts::mesh_xml::no_library));
      if (is_done()) return Event::ends;
      if (go_on() == XML_STATUS_ERROR) {
        if (fault.empty()) return failed(place(), xml_error_message(expat->XML_GetErrorCode(parser)));
        return failed(refused_at, fault);
      }
    }
    now = std::move(waiting.front());
    waiting.pop_front();
    return now.event;
  }
  Event failed(std::size_t at, std::string why) {
    fault = std::move(why);
    now = {Event::fault, {}, {}, at, open};
    return Event::fault;
  }

  const Expat* const expat = expat_library();
  XML_Parser parser = nullptr;
  std::string_view text;
  std::size_t handed = 0, open = 0, refused_at = 0;
  std::deque<Element> waiting;  // elements that wait for next(): the begin and the end of an empty element arrive together
  Element now;
  std::string fault;
};

XmlScan::XmlScan(std::string_view text) : parser_(std::make_unique<Parser>(text)) {}
XmlScan::~XmlScan() = default;

XmlScan::Event XmlScan::next() { return parser_->next(); }
std::string_view XmlScan::name() const { return parser_->now.name; }
std::size_t XmlScan::depth() const { return parser_->now.depth; }

const std::string* XmlScan::attribute(std::string_view name) const {
  for (const auto& [key, value] : parser_->now.attributes)
    if (key == name) return &value;
  return nullptr;
}

std::string XmlScan::location_here() const { return location_prefix("", parser_->text, std::min(parser_->now.at, parser_->text.size())); }

std::string XmlScan::fault() const { return location_here() + parser_->fault; }

}  // namespace kadr
