// Fuzz target: complete runs of NCT programs (run_program.h), with macros, calls, codes bound to macros, tool tables and the interrupt
// macro. The called files are in a temporary folder and are the same in every run. Nothing is written, and nothing outside the folder is
// read.

#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "run_program.h"

namespace {

namespace fs = std::filesystem;
using kadr::fuzz::require;

// five_axes: a machine with two rotary axes. With calls_inside both are in the head, with stops one in the head and one in the table,
// else both in the table (fuzz/nct_seeds).
enum : unsigned { five_axes = 1, calls_inside = 2, stops = 4, narrow = 8, letters_bound = 128 };

/// The program memory: a temporary folder of this process, deleted at its end.
class Memory {
 public:
  Memory() {
    char name[] = "/tmp/kadr_fuzz_XXXXXX";
    require(mkdtemp(name) != nullptr, "there is a folder for temporary files");
    folder_ = name;
    fs::create_directories(folder_ / "SystemMacros/Channel1");
    fs::create_directories(folder_ / "sub");
    write("O0100.nct", "#100=#1+#24\nIF[#1EQ#0]GOTO9\nG1X#24Y#25Z#26F100\nN9M99\n");
    write("O0101.nct", "G91G1X1F100\nG90M99\n");
    write("sub/drill.nct", "WHILE[#4GT0]DO1\nG0X[#4*2]\n#4=#4-1\nEND1\nM98<..\\O0101.nct>\nM99\n");
    write("SystemMacros/Channel1/O9000.nct", "#101=#4113\nM600\nM99\n");
    write("SystemMacros/Channel1/O9010.nct", "IF[#24NE#0]THEN#102=#24\nG#10X#24\nG65P100A1X2\nM99\n");
    write("SystemMacros/Channel1/O9011.nct", "#103=#103+1\nM99\n");
    write("SystemMacros/Channel1/O9020.nct", "M500\nG91G0Z1\nG90M99\n");
    write("SystemMacros/Channel1/O9033.nct", "S#198M3\nM99\n");
    write("SystemMacros/Channel1/O9034.nct", "T#199\nM6\nM99\n");
    write("SystemMacros/Channel1/O9100.nct", "#104=#191\nM99\n");
    write("SystemMacros/Channel1/O9200.nct", "#105=#5041\nG91X1\nM99\n");
  }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  ~Memory() {
    std::error_code error;
    fs::remove_all(folder_, error);
  }
  const fs::path& folder() const { return folder_; }

 private:
  void write(const char* name, const char* text) const { std::ofstream(folder_ / name) << text; }
  fs::path folder_;
};

kadr::ParameterKey key(const char* text) { return *kadr::parameter_key(text); }

void add_tools(kadr::Setup& s) {
  const auto tool = [&](int row, double type, double life, double counter, double offset) {
    kadr::ToolRow& r = s.tool_table[row];
    r.type = type, r.life = life, r.counter = counter, r.h = r.d = offset, r.info = 17, r.status = 1;  // letters SENCV, tool not used
  };
  tool(1, 5, 3, 2, 1);
  tool(2, 5, 100, 0, 2);
  tool(3, 81501070, 0, 0, 9);
  s.place_table = {{{1, 1}, 1}, {{1, 2}, 2}, {{1, 3}, 3}, {{10, 1}, 0}};
  s.form_table[1] = {1, 1, 0, 0, 0};
}

void add_parameters(kadr::Setup& s, unsigned switches) {
  s.parameters[key("N1704")] = 2000.0;   // G2000 → O9010
  s.parameters[key("N1705")] = -2001.0;  // G2001, modal → O9011
  s.parameters[key("N1714")] = 2100.0;   // G2100 … → O9010, O9011
  s.parameters[key("N1715")] = 9010.0;
  s.parameters[key("N1716")] = 2.0;
  s.parameters[key("N1717")] = 310.5;  // G310.5 … → O9010, O9011
  s.parameters[key("N1718")] = 9010.0;
  s.parameters[key("N1719")] = 2.0;
  s.parameters[key("N1720")] = 600.0;  // M600: subprogram O9000
  s.parameters[key("N1733")] = 500.0;  // M500: macro O9020
  s.parameters[key("N1747")] = std::string("Q");
  s.parameters[key("N1751")] = 9100.0;
  s.parameters[key("N1758#0")] = 1.0;
  s.parameters[key("N1702")] = 530.0;
  s.parameters[key("N1703")] = 540.0;
  s.parameters[key("N0107.C#0")] = 1.0;
  s.parameters[key("N1333")] = std::string("B");
  for (const char* const bit : {"N1755#0", "N1755#1", "N1758#1", "N1758#3", "N1337#1"})
    s.parameters[key(bit)] = (switches & calls_inside) != 0 ? 1.0 : 0.0;
  for (const char* const bit : {"N1746#3", "N1746#4", "N1757#0"}) s.parameters[key(bit)] = (switches & letters_bound) != 0 ? 1.0 : 0.0;
}

/// Sets the kinematics as parameters, since no set-up text is read here (spec/nct/25a). A is axis 4, C is axis 5.
void add_kinematics(kadr::Setup& s, unsigned switches) {
  if ((switches & five_axes) == 0) return;
  const auto set = [&](const char* const name, double value) { s.parameters[key(name)] = value; };
  const bool heads = (switches & calls_inside) != 0, mixed = !heads && (switches & stops) != 0;
  const double a[] = {4, 1}, c[] = {5, 3};  // axis number, letter
  set("N3200", heads ? 1 : mixed ? 3 : 2);
  set("N3201", 3);
  set("N3204", heads ? c[0] : a[0]);
  set("N3205", heads ? c[1] : a[1]);
  set("N3208", heads ? a[0] : c[0]);
  set("N3209", heads ? a[1] : c[1]);
  set("N3212#RD2", mixed ? 1 : 0);
  set("N3212#4", (switches & letters_bound) != 0 ? 1 : 0);                       // BSE
  set("N3212#7", (switches & narrow) != 0 ? 1 : 0);                              // FOS
  const double offsets[] = {300, -200, -450, 0, 4, -60, 5, -3, 200, 20, 8, 50};  // offsets T1, T2, E, D
  for (std::size_t i = 0; i < std::size(offsets); ++i) set(("N" + std::to_string(3213 + i)).c_str(), offsets[i]);
}

kadr::Setup nct_setup(unsigned switches) {
  kadr::Setup s;
  s.axes = {"X", "Y", "Z", "A", "C", "XDE"};
  s.start = {{"X", 10}, {"Y", -20}, {"Z", 100}, {"C", 350}};
  s.offsets[1] = {50, 5};
  s.offsets[2] = {-12.5, 0};
  s.offsets[9] = {33.3, 0};
  s.work_offsets = {
      {"G54", {{"X", 100}, {"Y", 50}}}, {"G55", {{"Z", -25}, {"G17", 30}}}, {"common", {{"X", 1}}}, {"G54.1 P2", {{"C", 90}}}};
  s.variables = {{"#100", 3.5}, {"#500", -2}, {"#1", std::nullopt}};
  s.reference_points = {{1, {{"X", 500}, {"Y", 400}, {"Z", 300}}}, {2, {{"Z", 200}}}};
  s.probe[1] = kadr::AxisValues{{"X", 60}, {"Z", -5}};
  s.spindles[1].name = "S";
  s.spindles[1].rpm = 500;
  s.spindles[2].name = "S2";
  s.watch = {"#100", "#5041", "#4001", "#4119", "#8402", "#_OFSHG[1]"};
  s.points = {0.25, 0.5};
  add_tools(s);
  add_parameters(s, switches);
  add_kinematics(s, switches);
  s.single_block = s.optional_stop = (switches & stops) != 0;
  if ((switches & stops) != 0) s.skip = {1, 3};
  if ((switches & narrow) != 0) s.machine["*"].limits = {-300, 300};
  return s;
}

/// The logic of the machine: calls the interrupt macro now and then.
void logic(kadr::Control& control, const kadr::Origin& origin, bool at_end) {
  control.set_signal("CP_MINT", origin.line % 3 == 0 ? 1 : 0);
  if (at_end) control.set_time(origin.line * 10.0, origin.line * 5.0);
  if (at_end) control.set_answer(origin.line % 4);
}

/// Returns the number of open files of this process outside the folder. /proc does not count, because the sanitizers read it.
std::size_t files_elsewhere(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator("/proc/self/fd")) {
    std::error_code error;
    const std::string target = fs::read_symlink(entry.path(), error).string();
    const bool file = !error && target.starts_with("/") && !target.starts_with("/proc/") && !target.starts_with("/dev/");
    if (file && !target.starts_with(folder.string())) ++count;
  }
  return count;
}

/// True if the program contains calls by name that may leave the program folder (14.4.2); such programs are not run.
bool climbs(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  return text.find("..") != std::string_view::npos;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Memory memory;
  static const kadr::fuzz::Shop shop = [] {
    kadr::fuzz::Shop s = kadr::fuzz::Shop::open("nct");
    s.file = (memory.folder() / "main.nct").string();
    s.limits.files = memory.folder().string();  // limits.writes_files stays false
    s.setup = nct_setup;
    s.plain_frames = false;  // because of basic rotations and polar interpolation
    s.logic = logic;
    s.second_channel = "G1 U5 F100\nM530 P12\n#500=#500+1\nG0 V#500\nM531 P12\nM98 P101\nM99\n";
    return s;
  }();
  static const std::size_t open_before = files_elsewhere(memory.folder());
  if (size == 0 || climbs(data, size)) return 0;
  kadr::fuzz::run_text(shop, std::string(reinterpret_cast<const char*>(data) + 1, size - 1), data[0],
                       [] { require(files_elsewhere(memory.folder()) <= open_before, "no file outside the program memory is open"); });
  return 0;
}
