// A page without a server has no machine to operate: its clock runs in real time in a thread. This file stands for view/page/page_panel,
// page_drive, page_restart and page_tables, and refuses their requests. Used by the preset `web`; tested by web/e2e/alone.mjs.

#include "view/page/page_inside.h"

namespace kadr {

bool PageSession::Inside::is_machine_on(const std::string&) const { return false; }
void PageSession::Inside::leave_machine() {}
void PageSession::Inside::stop_machine() {}

PageAnswer PageSession::Inside::machines(const PageJson&) { return PageJson{{"machines", PageJson::array()}}; }
PageAnswer PageSession::Inside::machine(const PageJson&) { return not_served("machine"); }
PageAnswer PageSession::Inside::panel(const PageJson&) { return not_served("panel"); }
PageAnswer PageSession::Inside::machine_source(const PageJson&) { return not_served("machine_source"); }
PageAnswer PageSession::Inside::ports(const PageJson&) { return not_served("ports"); }
PageAnswer PageSession::Inside::prove_machine(const PageJson&) { return not_served("prove"); }
PageAnswer PageSession::Inside::probe(const PageJson&) { return not_served("probe"); }
PageAnswer PageSession::Inside::press(const PageJson&) { return not_served("press"); }
PageAnswer PageSession::Inside::switches(const PageJson&) { return not_served("switches"); }
PageAnswer PageSession::Inside::enter(const PageJson&) { return not_served("enter"); }
PageAnswer PageSession::Inside::undo(const PageJson&) { return not_served("undo"); }
PageAnswer PageSession::Inside::jog(const PageJson&) { return not_served("jog"); }
PageAnswer PageSession::Inside::jogging(const PageJson&) { return not_served("jogging"); }
PageAnswer PageSession::Inside::stops_at(const PageJson&) { return not_served("stops"); }
PageAnswer PageSession::Inside::answer_to_machine(const PageJson&) { return not_served("answer"); }
PageAnswer PageSession::Inside::watch(const PageJson&) { return not_served("watch"); }
PageAnswer PageSession::Inside::tables(const PageJson&) { return not_served("tables"); }
PageAnswer PageSession::Inside::edit(const PageJson&) { return not_served("edit"); }
PageAnswer PageSession::Inside::keep_tables(const PageJson&) { return not_served("keep_tables"); }
PageAnswer PageSession::Inside::shift(const PageJson&) { return not_served("shift"); }
PageAnswer PageSession::Inside::restart(const PageJson&) { return not_served("restart"); }
PageAnswer PageSession::Inside::go_there(const PageJson&) { return not_served("go_there"); }
PageAnswer PageSession::Inside::move_along_path(const PageJson&) { return not_served("lead"); }

}  // namespace kadr
