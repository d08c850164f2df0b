// Compares a controller with a program. Used by kadr drive, tested by tests/drive.py.

#include "drive/grbl/grbl_proof.h"

#include <fmt/core.h>

#include <cmath>

#include "config/texts.h"
#include "texts/drive.h"

namespace kadr::drive {
namespace {

constexpr double same = 0.0015;  // mm; positions are reported with three decimals
constexpr const char* axis_names[] = {"X", "Y", "Z"};

std::string number(double value) { return fmt::format("{:g}", std::round(value * 1000) / 1000 + 0.0); }
std::string range(double least, double most) { return number(least) + " … " + number(most); }

class Proof {
 public:
  Proof(const GrblSettings& settings, const JobNeeds& needs, const Setup& setup, bool homed)
      : s_(settings), needs_(needs), setup_(setup), homed_(homed) {}

  std::vector<ProofRow> rows() {
    version();
    unit();
    offsets();
    for (std::size_t a = 0; a < grbl_axes; ++a) travel(a);
    feed();
    spindle();
    laser();
    junction();
    probe();
    return std::move(rows_);
  }

 private:
  void add(std::string id, PlainText what, std::string controller, std::string program, Verdict verdict = Verdict::right,
           std::string why = {}) {
    rows_.push_back({std::move(id), plain_text(what), std::move(controller), std::move(program), verdict, std::move(why)});
  }

  void version() {
    const bool known = s_.version.starts_with("1.1");
    add("version", texts::drive::version, s_.version, "1.1", known ? Verdict::right : Verdict::note,
        known ? "" : translated(texts::drive::unknown_version));
  }

  void unit() {
    if (s_.value(13, 0) != 0)
      add("unit", texts::drive::report_unit, "$13=1", "$13=0", Verdict::note, translated(texts::drive::reports_in_inches));
    if ((static_cast<int>(s_.value(10, 1)) & 2) == 0)
      add("buffer", texts::drive::buffer_report, fmt::format("$10={:g}", s_.value(10, 1)), "$10=3", Verdict::note,
          translated(texts::drive::no_buffer_report));
  }

  /// A work offset that the set-up states must be the one that the controller has.
  void offsets() {
    for (const auto& [name, values] : setup_.work_offsets) {
      const auto found = s_.offsets.find(name);
      if (found == s_.offsets.end()) continue;
      std::string there, stated;
      bool equal = true;
      for (std::size_t a = 0; a < grbl_axes; ++a) {
        const auto value = values.find(axis_names[a]);
        if (value == values.end()) continue;
        equal = equal && std::fabs(value->second - found->second[a]) < same;
        there += fmt::format("{}{}{}", there.empty() ? "" : " ", axis_names[a], number(found->second[a]));
        stated += fmt::format("{}{}{}", stated.empty() ? "" : " ", axis_names[a], number(value->second));
      }
      std::string id = name;
      for (char& c : id) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c);
      rows_.push_back({id, translated(texts::drive::work_offset, name), there, stated, equal ? Verdict::right : Verdict::refused,
                       equal ? "" : translated(texts::drive::other_offset)});
    }
  }

  /// Grbl's travel lies between −$130 and 0 in machine coordinates, if it was homed (spec/grbl 8).
  void travel(std::size_t a) {
    const double most = s_.value(130 + static_cast<int>(a), 0);
    if (most <= 0 || !needs_.least) return;
    const double from = (*needs_.least)[a], to = (*needs_.most)[a];
    const bool known = homed_ || s_.value(20, 0) != 0;
    const bool fits = to - from <= most + same && (!known || (from >= -most - same && to <= same));
    const std::string id = fmt::format("travel-{}", static_cast<char>('x' + static_cast<int>(a)));
    const Verdict verdict = !fits ? Verdict::refused : known ? Verdict::right : Verdict::note;
    const std::string why = !fits ? translated(texts::drive::beyond_travel) : known ? "" : translated(texts::drive::not_homed);
    rows_.push_back(
        {id, translated(texts::drive::travel, axis_names[a]), known ? range(-most, 0) : number(most), range(from, to), verdict, why});
  }

  void feed() {
    double least = 0;
    for (int a = 0; a < static_cast<int>(grbl_axes); ++a)
      if (const double rate = s_.value(110 + a, 0); rate > 0 && (least == 0 || rate < least)) least = rate;
    if (needs_.feed <= 0 || least <= 0) return;
    const bool fits = needs_.feed <= least * (1 + 1e-9);
    add("feed", texts::drive::greatest_feed,
        fmt::format("{} / {} / {}", number(s_.value(110, 0)), number(s_.value(111, 0)), number(s_.value(112, 0))), number(needs_.feed),
        fits ? Verdict::right : Verdict::note, fits ? "" : translated(texts::drive::feed_is_limited));
  }

  /// gcode.c limits S to $30 without an error (spec/grbl 4.17).
  void spindle() {
    if (!needs_.turns_spindle) return;
    const double most = s_.value(30, 1000);
    const bool fits = needs_.speed <= most;
    add("speed", texts::drive::greatest_speed, number(most), number(needs_.speed), fits ? Verdict::right : Verdict::refused,
        fits ? "" : translated(texts::drive::speed_is_limited));
  }

  void laser() {
    if (s_.value(32, 0) == 0 || !needs_.turns_spindle) return;
    add("laser", texts::drive::laser_mode, "$32=1", "$32=0", Verdict::refused, translated(texts::drive::laser_is_on));
  }

  void junction() {
    add("junction", texts::drive::junction, fmt::format("$11={}, $12={}", number(s_.value(11, 0.01)), number(s_.value(12, 0.002))),
        translated(texts::drive::used_for_times));
  }

  void probe() {
    if (needs_.probes) add("probe", texts::drive::probe, "", "G38", Verdict::note, translated(texts::drive::check_probe));
  }

  const GrblSettings& s_;
  const JobNeeds& needs_;
  const Setup& setup_;
  const bool homed_;
  std::vector<ProofRow> rows_;
};

}  // namespace

std::vector<ProofRow> grbl_proof(const GrblSettings& settings, const JobNeeds& needs, const Setup& setup, bool homed) {
  return Proof(settings, needs, setup, homed).rows();
}

}  // namespace kadr::drive
