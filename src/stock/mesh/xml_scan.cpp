// Tags, attributes, and whether they fit into each other. For stock/mesh/threemf_read.

#include "stock/mesh/xml_scan.h"

#include "config/read_file.h"
#include "config/told.h"
#include "stock/mesh/word_reader.h"

namespace kadr {
namespace {

constexpr std::size_t deepest = 64;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
bool ends_name(char c) { return is_space(c) || c == '/' || c == '>' || c == '=' || c == '<' || c == '"' || c == '\''; }

}  // namespace

XmlScan::Event XmlScan::failed(std::string what) {
  fault_ = std::move(what);
  return Event::fault;
}

std::string XmlScan::told_here() const { return told_place("", text_, element_); }

std::string XmlScan::fault() const { return told_here() + fault_; }

const std::string_view* XmlScan::attribute(std::string_view name) const {
  for (const auto& [key, value] : attributes_)
    if (key == name) return &value;
  return nullptr;
}

bool XmlScan::skip_past(std::string_view mark) {
  const std::size_t found = text_.find(mark, at_);
  at_ = found == std::string_view::npos ? text_.size() : found + mark.size();
  return found != std::string_view::npos;
}

void XmlScan::skip_blanks() {
  while (at_ < text_.size() && is_space(text_[at_])) ++at_;
}

std::string_view XmlScan::taken_name() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && !ends_name(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

/// Up to the end of the tag.
bool XmlScan::attributes() {
  attributes_.clear();
  while (true) {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] == '>' || text_[at_] == '/') return at_ < text_.size();
    const std::string_view key = taken_name();
    skip_blanks();
    if (key.empty() || at_ >= text_.size() || text_[at_] != '=') return false;
    ++at_;
    skip_blanks();
    if (at_ >= text_.size() || (text_[at_] != '"' && text_[at_] != '\'')) return false;
    const char quote = text_[at_++];
    const std::size_t end = text_.find(quote, at_);
    if (end == std::string_view::npos) return false;
    const std::string_view value = text_.substr(at_, end - at_);
    if (value.find('<') != std::string_view::npos) return false;
    attributes_.emplace_back(key, value);
    at_ = end + 1;
  }
}

/// After its `<`.
XmlScan::Event XmlScan::tag() {
  const bool closing = at_ < text_.size() && text_[at_] == '/';
  if (closing) ++at_;
  name_ = taken_name();
  const auto tag = [&] { return "<" + std::string(closing ? "/" : "") + shown(name_) + ">"; };
  const auto not_whole = [&] { return failed(told("the tag " + tag() + " is not whole", "тег " + tag() + " не закончен")); };
  if (name_.empty() || !attributes()) return not_whole();
  const bool empty = text_[at_] == '/';
  if (empty) ++at_;
  if (at_ >= text_.size() || text_[at_] != '>') return not_whole();
  ++at_;
  if (closing) {
    if (open_.empty() || open_.back() != name_)
      return failed(told(tag() + " closes what is not open", tag() + " закрывает то, что не открыто"));
    open_.pop_back();
    return Event::closes;
  }
  if (open_.empty() && had_root_) return failed(told("a second root " + tag(), "второй корень " + tag()));
  if (open_.size() >= deepest) return failed(told("elements too deep in each other", "слишком глубокая вложенность"));
  had_root_ = true;
  open_.push_back(name_);
  closes_next_ = empty;
  return Event::opens;
}

XmlScan::Event XmlScan::next() {
  if (closes_next_) {
    closes_next_ = false;
    open_.pop_back();
    return Event::closes;
  }
  while (true) {
    const std::size_t found = text_.find('<', at_);
    if (found == std::string_view::npos) {
      element_ = text_.size();
      if (!open_.empty()) return failed(told("<" + shown(open_.back()) + "> is not closed", "<" + shown(open_.back()) + "> не закрыт"));
      return had_root_ ? Event::ends : failed(told("there is no element in it", "в нём нет ни одного элемента"));
    }
    element_ = found;
    at_ = found + 1;
    const std::string_view rest = text_.substr(at_);
    const auto cut = [] { return told("a comment or an instruction is not closed", "примечание или указание не закрыто"); };
    if (rest.starts_with("?")) {
      if (!skip_past("?>")) return failed(cut());
    } else if (rest.starts_with("!--")) {
      if (!skip_past("-->")) return failed(cut());
    } else if (rest.starts_with("![CDATA[")) {
      if (!skip_past("]]>")) return failed(cut());
    } else if (rest.starts_with("!")) {
      return failed(told("a document type is not taken: it could name other files",
                         "тип документа не принимается: он может ссылаться на другие файлы"));
    } else {
      return tag();
    }
  }
}

}  // namespace kadr
