// The engine of a page that has no server: a session of view in a Web Worker, of which the page has one for each view.
// web/src/engine/worker.ts calls these functions; tested by tests/alone/traces.py and web/e2e/alone.mjs.
//
//   kadr_begin(folder, html, licences) once: the folder, in the memory of the worker, whose files the page shows; the viewer of reports and
//                                      the licences of its components
//   kadr_open() → session              a session, as a connection of the server is one
//   kadr_take(session, text, size)     a message of the page; answers, events and frames go out before it returns. Meanwhile the module's
//                                      function kadr_stops is asked some twenty times a second whether the work is to stop

#include <emscripten.h>

#include <map>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/stop_token.h"
#include "view/page/page_session.h"
#include "view/served_folder.h"

// What goes out: kadr_out is a function that the worker has put into the module. A frame is copied, so that its bytes can be handed over.
EM_JS(void, kadr_out_text, (int session, const char* text, std::size_t size), { Module.kadr_out(session, UTF8ToString(text, size)); });
EM_JS(void, kadr_out_frame, (int session, const char* bytes, std::size_t size),
      { Module.kadr_out(session, HEAPU8.slice(bytes, bytes + size).buffer); });

// Whether the page wants the message that is being answered to stop.
EM_JS(bool, kadr_stops, (), { return Module.kadr_stops(); });

namespace kadr::web {
namespace {

/// The line to one view of the page.
class WorkerLine : public PageLine {
 public:
  explicit WorkerLine(int session) : session_(session) {}
  bool text(std::string message) override {
    kadr_out_text(session_, message.data(), message.size());
    return true;
  }
  bool frame(std::string bytes) override {
    kadr_out_frame(session_, bytes.data(), bytes.size());
    return true;
  }

 private:
  int session_;
};

struct View {
  View(const PageServer& server, int session) : line(session), page(server, line) {}
  WorkerLine line;
  PageSession page;
};

struct Engine {
  Engine(ServedFolder opened, std::string viewer, std::string of_viewer)
      : folder(std::move(opened)), html(std::move(viewer)), licences(std::move(of_viewer)) {}
  ServedFolder folder;
  std::string html, licences;
  LastOpened last;
  PageServer server{folder, "", false, Lang::en, KADR_VERSION, &last, nullptr, nullptr, nullptr, {html, licences}};
  std::map<int, std::unique_ptr<View>> views;
  int count = 0;
};

std::unique_ptr<Engine> engine;
PageSession* working = nullptr;  // the session that answers a message

/// The poll of every stop token: looks at the clock each eighth time, and asks the page each 50 ms, as asking it takes up to 1 ms.
void look_whether_to_stop() {
  constexpr unsigned rare = 8;
  constexpr double every = 50;  // ms
  static unsigned polls = 0;
  static double asked = 0;
  if (working == nullptr || ++polls % rare != 0) return;
  const double now = emscripten_get_now();
  if (now - asked < every) return;
  if (kadr_stops()) working->stop();
  asked = emscripten_get_now();
}

}  // namespace
}  // namespace kadr::web

extern "C" {

/// Returns false if the folder cannot be read.
EMSCRIPTEN_KEEPALIVE bool kadr_begin(const char* folder, const char* html, const char* licences) {
  using namespace kadr;
  auto opened = ServedFolder::open(folder);
  look_for_stop = web::look_whether_to_stop;
  if (opened) web::engine = std::make_unique<web::Engine>(std::move(*opened), html, licences);
  return opened.has_value();
}

EMSCRIPTEN_KEEPALIVE int kadr_open() {
  using namespace kadr::web;
  const int session = ++engine->count;
  engine->views[session] = std::make_unique<View>(engine->server, session);
  return session;
}

/// Returns 0 if the session goes on, 1 if it has ended, 2 if the memory is not sufficient for what was asked: then this engine should be
/// replaced by a new one.
EMSCRIPTEN_KEEPALIVE int kadr_take(int session, const char* text, std::size_t size, bool stopped) {
  using namespace kadr::web;
  const auto view = engine->views.find(session);
  if (view == engine->views.end()) return 1;
  try {
    working = &view->second->page;
    working->begin(stopped);
    const bool goes_on = working->take({text, size});
    working = nullptr;
    if (goes_on) return 0;
  } catch (const std::bad_alloc&) {
    return 2;
  } catch (const std::length_error&) {
    return 2;
  }
  engine->views.erase(view);
  return 1;
}

}  // extern "C"
