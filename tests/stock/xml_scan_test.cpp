// stock/mesh/xml_scan: returns elements in order; and what it refuses.

#include "stock/mesh/xml_scan.h"

#include <gtest/gtest.h>

namespace kadr::xml_scan_test {
namespace {

/// Returns elements such as "+a(x=1) -a", then the fault if there is one.
std::string described_elements(std::string_view text) {
  XmlScan scan(text);
  std::string out;
  while (true) {
    switch (scan.next()) {
      case XmlScan::Event::opens:
        out += "+" + std::string(scan.name());
        if (const std::string* const x = scan.attribute("x"); x != nullptr) out += "(" + *x + ")";
        out += std::to_string(scan.depth());
        break;
      case XmlScan::Event::closes: out += "-" + std::string(scan.name()); break;
      case XmlScan::Event::ends: return out;
      case XmlScan::Event::fault: return out + "!" + scan.fault();
    }
  }
}

TEST(xml_scan, elements_in_their_order) {
  const struct {
    const char* text;
    const char* described;
  } rows[] = {
      {"<a/>", "+a1-a"},
      {"<?xml version='1.0'?><!-- <x> --><a><b x='1'/>text<b x=\"2\"></b></a>", "+a1+b(1)2-b+b(2)2-b-a"},
      {"<a x='&lt;&amp;&#65;'/>", "+a(<&A)1-a"},
      {"<m:a x='1'><![CDATA[<z>]]></m:a>\n", "+m:a(1)1-m:a"},
      {"<a>\n <b></c></a>", "+a1+b2!line 2, column 7: a tag closes what is not open"},
      {"<a><b/>", "+a1+b2-b!line 1, column 8: an element is not closed, or there is none"},
      {"", "!line 1, column 1: an element is not closed, or there is none"},
      {"<a x='1' x='2'/>", "!line 1, column 10: an attribute stands twice"},
      {"<a/><b/>", "+a1-a!line 1, column 5: a second root"},
      {"<a", "!line 1, column 1: a tag or a comment is not whole"},
      {"<a>&huge;</a>", "+a1!line 1, column 4: this is no XML"},
      {"solid thing", "!line 1, column 1: this is no XML"},
      {"<!DOCTYPE a [<!ENTITY e SYSTEM 'file:///etc/passwd'>]><a>&e;</a>",
       "!line 1, column 13: a document type is not taken: it could name other files"},
  };
  for (const auto& row : rows) EXPECT_EQ(described_elements(row.text), row.described) << row.text;
}

TEST(xml_scan, depth_and_length_are_bounded) {
  std::string deep;
  for (int i = 0; i < 100; ++i) deep += "<a>";
  EXPECT_EQ(described_elements(deep).substr(64 * 2 + 9 + 2 * 55), "!line 1, column 193: elements too deep in each other");
  const std::string much = "<a x='" + std::string(50'000'000, '1');
  EXPECT_EQ(described_elements(much + "'/>"), "!line 1, column 1: a tag or a comment is too long");
  std::string wide = "<a>";
  for (int i = 0; i < 200'000; ++i) wide += "<b x='1'/>\n";
  XmlScan scan(wide += "</a>");
  int count = 0;
  for (auto event = scan.next(); event != XmlScan::Event::ends; event = scan.next()) {
    ASSERT_NE(event, XmlScan::Event::fault) << scan.fault();
    count += event == XmlScan::Event::opens;
  }
  EXPECT_EQ(count, 200'001);
}

}  // namespace
}  // namespace kadr::xml_scan_test
