// Answers the requests `digest`, `rename`, `copy`, `delete`, `restore`, `trash` and `empty_trash`, about files of the served folder. Used
// by view/page/page_session; tested by tests/serve_files.py.

#include "texts/page.h"
#include "view/page/page_inside.h"

namespace kadr {
namespace {

template <class T>
tl::unexpected<Refusal> refused_because(const tl::expected<T, ServedFolder::Refused>& failed) {
  return tl::unexpected(Refusal{failed.error().text, failed.error().changed});
}

}  // namespace

/// Answers with the digest of a file as it is on the disk now; null if it is not there any more.
PageSession::Inside::Answer PageSession::Inside::digest(const PageJson& question) {
  const auto found = server.folder.digest(value_in<std::string>(question, "file", ""), value_in<std::string>(question, "known", ""));
  return PageJson{{"digest", found ? PageJson(*found) : PageJson()}};
}

/// Returns why this page may not change the file; empty if it may.
std::string PageSession::Inside::fault_of_change(const std::string& file) const {
  if (!may_change) return translated(texts::page::may_not_save);
  if (is_machine_on(file)) return translated(texts::page::machine_is_on, file);
  return {};
}

PageSession::Inside::Answer PageSession::Inside::rename(const PageJson& question) {
  const std::string file = value_in<std::string>(question, "file", ""), to = value_in<std::string>(question, "to", "");
  if (std::string fault = fault_of_change(file); !fault.empty()) return refused(std::move(fault));
  if (const auto renamed = server.folder.rename(file, to); !renamed) return refused_because(renamed);
  if (opened_names.erase(file) > 0) opened_names.insert(to);
  if (server.last != nullptr && server.last->get() == file) server.last->set(to);
  return PageJson::object();
}

PageSession::Inside::Answer PageSession::Inside::copy(const PageJson& question) {
  const std::string file = value_in<std::string>(question, "file", ""), to = value_in<std::string>(question, "to", "");
  if (!may_change) return refused(translated(texts::page::may_not_save));
  const auto made = server.folder.duplicate(file, to);
  if (!made) return refused_because(made);
  opened_names.insert(to);
  return PageJson{{"digest", *made}};
}

PageSession::Inside::Answer PageSession::Inside::remove(const PageJson& question) {
  const std::string file = value_in<std::string>(question, "file", "");
  if (std::string fault = fault_of_change(file); !fault.empty()) return refused(std::move(fault));
  const auto removed = server.folder.remove(file);
  if (!removed) return refused_because(removed);
  if (server.last != nullptr && server.last->get() == file) server.last->set("");
  return PageJson{{"trash", *removed}};
}

PageSession::Inside::Answer PageSession::Inside::restore_file(const PageJson& question) {
  if (!may_change) return refused(translated(texts::page::may_not_save));
  const std::string trash = value_in<std::string>(question, "trash", ""), file = value_in<std::string>(question, "file", "");
  if (const auto restored = server.folder.restore(trash, file); !restored) return refused_because(restored);
  return PageJson::object();
}

PageSession::Inside::Answer PageSession::Inside::trash(const PageJson&) {
  const auto list = server.folder.trash();
  if (!list) return refused(list.error());
  PageJson entries = PageJson::array();
  for (const TrashEntry& one : list->entries)
    entries.push_back({{"trash", one.trash}, {"file", one.file}, {"size", one.size}, {"deleted", one.deleted}});
  PageJson json = {{"entries", std::move(entries)}};
  if (list->more) json["more"] = true;
  return json;
}

/// Deletes one file in the trash, or all, for good.
PageSession::Inside::Answer PageSession::Inside::empty_trash(const PageJson& question) {
  if (!may_change) return refused(translated(texts::page::may_not_save));
  const auto deleted = server.folder.empty_trash(value_in<std::string>(question, "trash", ""));
  if (!deleted) return refused_because(deleted);
  return PageJson{{"deleted", *deleted}};
}

}  // namespace kadr
