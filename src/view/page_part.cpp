// Questions about the part: cut, part, proposals. For view/page_session; tested by tests/serve.py.

#include "view/page_inside.h"

namespace kadr {

PageSession::Inside::Answer PageSession::Inside::cut(const PageJson&) { return not_served("cut"); }
PageSession::Inside::Answer PageSession::Inside::part(const PageJson&) { return not_served("part"); }
PageSession::Inside::Answer PageSession::Inside::proposals(const PageJson&) { return not_served("proposals"); }

}  // namespace kadr
