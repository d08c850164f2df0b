// The set-up sheet. For view/page_session; tested by tests/serve.py.

#include "view/page_inside.h"

namespace kadr {

PageSession::Inside::Answer PageSession::Inside::sheet(const PageJson&) { return not_served("sheet"); }

}  // namespace kadr
