// Answers the request `sheet`: the set-up sheet of the open program. Used by view/page/page_session; tested by tests/serve.py.

#include "view/page/page_inside.h"
#include "view/sheet.h"

namespace kadr {

PageSession::Inside::Answer PageSession::Inside::sheet(const PageJson&) {
  return sheet_json(sheet_of(*run, *source, server.folder.shown(run->opened().path), lang), run->statistics());
}

}  // namespace kadr
