// What the machine's logic and its operator tell the NCT (spec/nct 11.7, 11.8, 12.3, 20.2, 23.1.9, 23.4).

#include <utility>

#include "control/nct/axes/coupling.h"
#include "control/nct/axes/drives.h"
#include "control/nct/nct.h"
#include "control/nct/waiting.h"
#include "control/state/search_rules.h"

namespace kadr::nct {

void Nct::set_signal(const std::string& name, double value) {
  double& signal = signals[name];
  if (name == interrupt_signal && signal == 0 && value != 0) signal_rose = true;
  signal = value;
}

void Nct::synchronise(int slave, int master) {
  for (int n = 1; n <= static_cast<int>(most_spindles); ++n) {
    if (slave != n && slave != 0) continue;
    SpindleState& s = spindle(n);
    s.master = master;
    if (master < 1 || master > static_cast<int>(most_spindles)) continue;
    SpindleState& leads = spindle(master);  // both loops are closed, the slave has the master's speed (11.7.4)
    s.rpm = leads.rpm;
    s.dir = leads.dir;
    s.loop_closed = leads.loop_closed = true;
  }
}

void Nct::couple_axis(Interpreter& m, const std::string& name, AxisLink link, bool on) {
  if (link == AxisLink::follows) nct::couple_axis(m, name, on);
  else ask_of_axis(m, name, link, on);
}

void Nct::convert_spindle(int number, bool to_axis) {
  if (number < 1 || number > static_cast<int>(most_spindles)) return;
  SpindleState& s = spindle(number);
  s.dir = SpindleDir::stop;
  s.master = 0;
  s.loop_closed = to_axis;
  s.referenced = false;
}

/// A group that N1341 to N1372 leave 0 is none.
SearchRules Nct::search_rules() const {
  SearchRules rules{{}, settings.change_on_m6};
  for (const auto& group : settings.m_groups)
    if (group.second > 0) rules.groups.push_back(group);
  return rules;
}

void Nct::set_time(double at_ms, double cut_ms) {
  now_ms = at_ms;
  cutting_ms += cut_ms;  // the program may have set it
  constexpr double ms_per_s = 1000;
  const SpindleState& leads = spindle(state.main_spindle);
  const bool turns = leads.dir == SpindleDir::cw || leads.dir == SpindleDir::ccw;
  const bool turned_then = std::exchange(turned, turns);
  if (counts_time && (turns || turned_then)) tools.add_time(cut_ms / ms_per_s, spindle_magazine());
  counts_time = tools.counts_time();
}

bool Nct::waiting_suspended() const { return nct::waiting_suspended(*this); }

}  // namespace kadr::nct
