// Two versions of a program. For view/page_session; tested by tests/serve.py.

#include "view/page_inside.h"

namespace kadr {

PageSession::Inside::Answer PageSession::Inside::compare(const PageJson&) { return not_served("compare"); }

}  // namespace kadr
