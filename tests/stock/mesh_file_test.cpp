// stock/mesh: writes STL and 3MF files and reads them back; the fault of a file is reported with its position.

#include "stock/mesh/mesh_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>

#include "config/language.h"
#include "stock/mesh/mesh_edges.h"
#include "stock/mesh/stl.h"
#include "stock/mesh/threemf.h"
#include "stock/mesh/zip.h"
#include "stock/some_meshes.h"
#include "stock/some_tools.h"

namespace kadr::mesh_file_test {
namespace {

using namespace test;

ByteSink into(std::string& bytes) {
  return [&bytes](std::string_view more) {
    bytes += more;
    return true;
  };
}

std::string stl_of(const Mesh& mesh) {
  std::string bytes;
  EXPECT_TRUE(write_stl(mesh, into(bytes)));
  return bytes;
}

std::string threemf_of(const Mesh& mesh) {
  std::string bytes;
  EXPECT_EQ(write_3mf(mesh, into(bytes)), "");
  return bytes;
}

/// Returns an archive with this model.
std::string archive_of(const std::string& model) {
  std::string bytes;
  const ByteSink sink = into(bytes);
  ZipWriter zip(sink);
  EXPECT_EQ(zip.add("3D/3dmodel.model", [&](const ByteSink& to) { return to(model); }), "");
  EXPECT_EQ(zip.finish(), "");
  return bytes;
}

const std::string cube_object =
    "<object id='1'><mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/><vertex x='0' y='1' z='0'/><vertex x='0' y='0' "
    "z='1'/>"
    "</vertices><triangles><triangle v1='0' v2='2' v3='1'/><triangle v1='0' v2='1' v3='3'/><triangle v1='1' v2='2' v3='3'/>"
    "<triangle v1='0' v2='3' v3='2'/></triangles></mesh></object>";  // the corner of a cube: a volume of 1/6

std::string model_of(const std::string& objects, const std::string& build, const std::string& attributes = "") {
  return "<?xml version='1.0'?><model " + attributes + "><resources>" + objects + "</resources><build>" + build + "</build></model>";
}

std::string fault_of_mesh(const std::string& bytes, const MeshRules& rules = {}) {
  const auto read = read_mesh(bytes, rules);
  return read ? "none" : read.error();
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(mesh_file, written_and_read_back) {
  const Mesh torus = torus_mesh(20, 10, 4.123456f);
  const auto stl = read_mesh(stl_of(torus), {}), threemf = read_mesh(threemf_of(torus), {});
  ASSERT_TRUE(stl && threemf);
  EXPECT_TRUE(stl->notes.empty() && threemf->notes.empty());
  EXPECT_EQ(threemf->mesh.points, torus.points);
  EXPECT_EQ(threemf->mesh.triangles, torus.triangles);
  EXPECT_EQ(stl->mesh.point_count(), torus.point_count());
  EXPECT_EQ(volume_of(stl->mesh), volume_of(solid_of(stl->mesh, {})->mesh));
  EXPECT_EQ(stl_of(stl->mesh), stl_of(torus));
}

TEST(mesh_file, a_text_stl) {
  std::string text = "solid corner of a cube\n";
  const Mesh mesh = box_mesh({0, 0, 0}, {1, 2, 3});
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    text += " facet normal nan nan nan\r\n  outer loop\r\n";
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = mesh.corner(t, k);
      text += "   VERTEX " + std::to_string(p.x) + " +" + std::to_string(p.y) + " " + std::to_string(p.z) + "e0\r\n";
    }
    text += "  endloop\n endfacet\n";
  }
  const auto read = read_mesh(text + "endsolid corner of a cube\n", {});
  ASSERT_TRUE(read) << read.error();
  EXPECT_NEAR(volume_of(read->mesh), 6, 1e-5);
  EXPECT_TRUE(has(fault_of_mesh(text), "'facet' or 'endsolid' is expected here, there is the end of the file"));
  text.replace(text.find("+0.00"), 5, "fifty");
  EXPECT_EQ(fault_of_mesh(text).substr(0, 65), "line 4, column 20: a coordinate is expected here, there is 'fifty");
}

TEST(mesh_file, a_binary_header_is_not_believed) {
  std::string bytes = stl_of(box_mesh({0, 0, 0}, {1, 1, 1}));
  bytes[80] = bytes[81] = bytes[82] = bytes[83] = char(0xff);
  const auto read = read_mesh(bytes, {});
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->notes, std::vector<std::string>{"its header says 4294967295 triangles, it has 12"});
  EXPECT_TRUE(has(fault_of_mesh(bytes.substr(0, bytes.size() - 20)), "it ends within triangle 12"));
  EXPECT_EQ(fault_of_mesh(""), "it is no STL file");
  EXPECT_EQ(fault_of_mesh("hello"), "it is no STL file");
}

TEST(mesh_file, what_is_open_is_told_with_its_place) {
  Mesh mesh = box_mesh({1, 2, 3}, {4, 5, 6});
  mesh.triangles.erase(mesh.triangles.begin() + 12, mesh.triangles.begin() + 15);  // the fifth; the second shares an edge
  EXPECT_EQ(fault_of_mesh(stl_of(mesh)), "not closed: 3 edges are open, the first at triangle 2, X1 Y2 Z3");
  set_process_language(Lang::ru);
  EXPECT_EQ(fault_of_mesh(stl_of(mesh)), "не замкнуто: открытых рёбер 3, первое у треугольника 2, X1 Y2 Z3");
  set_process_language(Lang::en);
}

TEST(mesh_file, places_that_are_none) {
  for (const float bad : {std::nanf(""), INFINITY, 1e9f}) {
    Mesh mesh = box_mesh({1, 2, 3}, {4, 5, 6});
    mesh.points[3 * 7 + 1] = bad;
    EXPECT_TRUE(has(fault_of_mesh(stl_of(mesh)), "triangle 3: ")) << fault_of_mesh(stl_of(mesh));
  }
  Mesh flat = box_mesh({0, 0, 0}, {1, 1, 0});
  EXPECT_EQ(fault_of_mesh(stl_of(flat)), "it encloses nothing");
  EXPECT_EQ(fault_of_mesh(stl_of(Mesh{})), "there is no triangle in it");
}

TEST(mesh_file, what_can_be_repaired_is_and_is_told) {
  const Mesh outer = box_mesh({0, 0, 0}, {9, 9, 9}), inner = box_mesh({2, 2, 2}, {4, 4, 4}), apart = box_mesh({20, 0, 0}, {21, 1, 1});
  struct Case {
    Mesh mesh;
    double volume;
    std::string note;
  };
  Mesh mixed = outer;
  std::swap(mixed.triangles[4], mixed.triangles[5]);
  Mesh torn = outer;  // one corner of a triangle is off by 2 µm
  for (const double v : {0.0, 0.002, 0.0}) torn.points.push_back(float(v));
  torn.triangles[0] = 8;
  for (const auto& [mesh, volume, note] : {Case{outer, 729, ""},
                                           {inside_out(outer), 729, "it was inside out: turned"},
                                           {together(outer, inside_out(inner)), 729 - 8, ""},
                                           {inside_out(together(outer, inside_out(inner))), 729 - 8, "it was inside out: turned"},
                                           {together(outer, inside_out(apart)), 730, "1 of its bodies was inside out: turned"},
                                           {mixed, 729, "1 triangle went round against its neighbours: turned"},
                                           {torn, 729, "1 point at open edges lay within 0.005 mm of another: joined"}}) {
    const auto read = read_mesh(stl_of(mesh), {});
    ASSERT_TRUE(read) << read.error();
    EXPECT_NEAR(volume_of(read->mesh), volume, 0.1) << note;
    EXPECT_EQ(read->notes.empty() ? "" : read->notes.front(), note);
    EXPECT_EQ(edges_of(read->mesh).open, 0U);
  }
}

TEST(mesh_file, units_parts_and_mirrors_of_a_3mf) {
  const auto volume = [](const std::string& model) {
    const auto read = read_mesh(archive_of(model), {});
    EXPECT_TRUE(read) << read.error();
    return read ? volume_of(read->mesh) : 0;
  };
  EXPECT_NEAR(volume(model_of(cube_object, "<item objectid='1'/>")), 1 / 6.0, 1e-6);
  EXPECT_NEAR(volume(model_of(cube_object, "<item objectid='1'/>", "unit=\"inch\"")), 25.4 * 25.4 * 25.4 / 6, 1e-2);
  EXPECT_NEAR(volume(model_of(cube_object, "<item objectid='1' transform='-2 0 0 0 1 0 0 0 1 50 0 0'/>")), 2 / 6.0, 1e-4);
  const std::string twice =
      "<object id='2'><components><component objectid='1'/><component objectid='1' transform='1 0 0 0 1 0 0 0 1 5 0 0'/>"
      "</components></object><object id='3' type='support'><components/></object>";
  EXPECT_NEAR(volume(model_of(cube_object + twice, "<item objectid='2'/><item objectid='3'/>")), 2 / 6.0, 1e-5);
}

TEST(mesh_file, a_3mf_that_is_refused) {
  const auto fault = [](const std::string& model, const MeshRules& rules = {}) { return fault_of_mesh(archive_of(model), rules); };
  const std::string item = "<item objectid='1'/>";
  EXPECT_TRUE(has(fault("<!DOCTYPE model [<!ENTITY x SYSTEM 'file:///etc/passwd'>]>" + model_of(cube_object, item)),
                  "a document type is not taken"));
  EXPECT_TRUE(has(fault(model_of(cube_object, "<item objectid='7'/>")), "there is no object 7"));
  EXPECT_TRUE(has(fault(model_of("<object id='1'><components><component objectid='1'/></components></object>", item)), "too deep"));
  EXPECT_TRUE(has(fault(model_of(cube_object, item, "requiredextensions='p'")), "needs an extension that is not known: p"));
  std::string wrong = cube_object;
  wrong.replace(wrong.find("v1='0'"), 6, "v1='9'");
  EXPECT_TRUE(has(fault(model_of(wrong, item)), "there is no vertex 9"));
  wrong = cube_object;
  wrong.replace(wrong.find("x='1'"), 5, "x='z'");
  EXPECT_TRUE(has(fault(model_of(wrong, item)), "line 1, column ")) << fault(model_of(wrong, item));
  EXPECT_TRUE(has(fault(model_of(cube_object, item).substr(0, 300)), "not "));
  EXPECT_TRUE(has(fault(model_of("", "")), "there is no triangle"));
  const std::string long_one = model_of(cube_object, item) + std::string(3'000'000, ' ');  // compresses to a thousandth of its size
  EXPECT_LT(archive_of(long_one).size(), 20'000U);
  EXPECT_TRUE(has(fault(long_one, {2'000'000, 0.005, 1e5}), "longer than the memory allowed"));
  std::string laughs = cube_object;  // each object holds ten of the previous one
  for (int i = 2; i < 9; ++i) {
    laughs += "<object id='" + std::to_string(i) + "'><components>";
    for (int k = 0; k < 10; ++k) laughs += "<component objectid='" + std::to_string(i - 1) + "'/>";
    laughs += "</components></object>";
  }
  EXPECT_TRUE(has(fault(model_of(laughs, "<item objectid='8'/>"), {100'000'000, 0.005, 1e5}), "do not fit into the memory allowed"));
}

TEST(mesh_file, too_many_triangles_for_the_memory) {
  EXPECT_TRUE(has(fault_of_mesh(stl_of(torus_mesh(20, 10, 4)), {100'000, 0.005, 1e5}), "do not fit into the memory allowed"));
}

TEST(mesh_file, a_sink_that_is_full_ends_it) {
  const ByteSink full = [](std::string_view) { return false; };
  EXPECT_FALSE(write_stl(torus_mesh(20, 10, 4), full));
  EXPECT_EQ(write_3mf(torus_mesh(20, 10, 4), full), "it cannot be written");
}

RC_GTEST_PROP(mesh_file, damaged_bytes_are_refused_or_give_a_solid, (unsigned seed)) {
  Chance chance(seed);
  const Mesh mesh = torus_mesh(5, 10, 4);
  std::string bytes = chance.below(2) == 0 ? stl_of(mesh) : threemf_of(mesh);
  for (int i = chance.below(6); i >= 0; --i) bytes[std::size_t(chance.below(int(bytes.size())))] = char(chance.below(256));
  if (chance.below(4) == 0) bytes.resize(std::size_t(chance.below(int(bytes.size()))));
  const auto read = read_mesh(bytes, {std::size_t(1) << 24, 0.005, 1e5});
  if (!read) {
    RC_ASSERT(!read.error().empty());
    return;
  }
  RC_ASSERT(edges_of(read->mesh).open == 0U);
  RC_ASSERT(volume_of(read->mesh) > 0);
}

}  // namespace
}  // namespace kadr::mesh_file_test
