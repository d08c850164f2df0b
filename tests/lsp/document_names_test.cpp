// The names that DocumentNames finds, and that it finds the same after changes as in the whole text.

#include "lsp/document_names.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "config/control/control_file.h"

namespace kadr::document_names_test {

std::shared_ptr<const ControlDef> control(const std::string& id) { return std::make_shared<const ControlDef>(*load_control(id)); }

/// Returns the names of a text: "line kind name", with an asterisk where the name is defined.
std::string names_of(const std::string& id, const std::string& text) {
  const TextDocument document(text, ColumnUnit::utf8);
  DocumentNames names(control(id));
  names.read(document);
  constexpr std::array kinds = {"N",      "O",       "label", "#",        "T",      "heading", "opens",
                                "closes", "section", "cycle", "no_cycle", "remark", "change",  "mark"};
  std::string all;
  for (std::size_t n = 0; n < names.lines(); ++n)
    for (const NamedPlace& place : names.line(n))
      all += fmt::format("{} {} {}{}\n", n, kinds[std::size_t(place.kind)], place.name, place.defines ? "*" : "");
  return all;
}

TEST(DocumentNames, FindsBlocksProgramsAndVariables) {
  EXPECT_EQ(names_of("fanuc", "O0200\nN010 T3 M6\nM98 P300\n#101=#7+1\nIF[#101GT5]GOTO 10\nM99 P010\nWHILE[#1LT2]DO1\nEND1\n(TOP SIDE)"),
            "0 O 200*\n1 N 10*\n1 change \n1 T 3\n2 O 300\n3 # 101*\n3 # 7\n4 N 10\n4 # 101\n5 N 10\n6 opens do1\n6 # 1\n7 closes do1\n8 "
            "heading TOP "
            "SIDE\n");
}

TEST(DocumentNames, FindsLabelsAndNamedVariablesOfLinuxCnc) {
  EXPECT_EQ(names_of("linuxcnc", "o<Pocket> sub\n#<_deep> = [#<_Deep> - 1]\no<pocket> endsub\no<pocket> call [1]"),
            "0 opens <pocket>\n0 label <pocket>*\n1 # <_deep>*\n1 # <_deep>\n2 closes <pocket>\n2 label <pocket>\n3 label <pocket>\n");
}

TEST(DocumentNames, FindsProgramsOfSinumerik) {
  EXPECT_EQ(
      names_of("sinumerik", "%_N_MAIN_MPF\nPART(5)\nSTOPRE\nN10 MCALL Part\nL10 P2\nEXTCALL \"part\"\nX1=5\nPROC PART(REAL A)\nG1 X1\n"),
      "0 O main*\n1 O part\n3 N 10*\n3 O part\n3 no_cycle \n4 O l10\n5 O part\n7 O part*\n");
}

TEST(DocumentNames, FindsNamesOfConversationalBlocks) {
  EXPECT_EQ(
      names_of("heidenhain",
               "0 BEGIN PGM PLATE MM\n1 TOOL CALL 5 Z S2000\n2 LBL 07\n3 Q1 = Q1 + QL2 ; Q9\n4 CALL LBL 7 REP 2\n5 FN 9: IF +Q1 EQU +3 "
               "GOTO LBL \"End\"\n6 CALL PGM TNC:\\PARTS\\Hole.H\n7 LBL 0\n* - Outline\n"),
      "0 N 0*\n0 O plate*\n1 N 1*\n1 T 5\n2 N 2*\n2 label 7*\n3 N 3*\n3 remark Q9\n3 # q1*\n3 # q1\n3 # ql2\n4 N 4*\n4 label 7\n5 N 5*\n5 "
      "label End\n5 "
      "# q1\n6 N 6*\n6 "
      "O hole\n7 N 7*\n8 section Outline\n");
}

TEST(DocumentNames, KeepsBlockNumbersOfProgramsApart) {
  const TextDocument document("O1\nN10 G0\nGOTO10\nO2\nN10 G0\n", ColumnUnit::utf8);
  DocumentNames names(control("fanuc"));
  names.read(document);
  const NamedPlace* const jump = names.at(2, 5);
  ASSERT_NE(jump, nullptr);
  const auto all = names.all_of(2, *jump);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].line, 1u);
  EXPECT_EQ(all[1].line, 2u);
}

RC_GTEST_PROP(DocumentNames, FindsTheSameAfterChanges, ()) {
  const auto def = control("fanuc");
  const auto text = [] {
    std::string made;
    for (const char* part : *rc::gen::container<std::vector<const char*>>(
             rc::gen::element("N10", "\n", "\n", " X1.", "#101=", "#7", "GOTO10", "(T)", "(", "M98P2", "O5", "\r\n", "IF[")))
      made += part;
    return made;
  };
  TextDocument document(text(), ColumnUnit::utf8);
  DocumentNames names(def);
  names.read(document);
  for (int n = 0; n < 4; ++n) {
    const auto line = [&] { return *rc::gen::inRange(0u, std::uint32_t(document.lines())); };
    const std::uint32_t a = line(), b = line();
    names.update(document, document.change({{std::min(a, b), 0}, {std::max(a, b), 2}}, text()));
    DocumentNames fresh(def);
    fresh.read(document);
    RC_ASSERT(names.lines() == fresh.lines());
    for (std::size_t at = 0; at < names.lines(); ++at) {
      RC_ASSERT(names.line(at).size() == fresh.line(at).size());
      for (std::size_t i = 0; i < names.line(at).size(); ++i) RC_ASSERT(names.line(at)[i].name == fresh.line(at)[i].name);
    }
  }
}

}  // namespace kadr::document_names_test
