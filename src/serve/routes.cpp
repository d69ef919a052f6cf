#include "serve/routes.h"

#include <atomic>
#include <charconv>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "run/export_case.h"
#include "run/load_case.h"
#include "serve/design.h"
#include "serve/export_file.h"
#include "serve/measured.h"
#include "serve/page_files.h"
#include "serve/parameters_json.h"
#include "serve/refusal.h"
#include "serve/run_file.h"

namespace knitmech::serve {
namespace {

using Json = nlohmann::ordered_json;
using Request = httplib::Request;
using Response = httplib::Response;

constexpr int kMostListeners = 16;  ///< pages that are told of events at a time
constexpr std::chrono::milliseconds kEventWait{500};
/// What pictures of the run folder and reports may do: show themselves. They come from files, so no script runs.
constexpr const char* kFilePolicy = "default-src 'none'; img-src 'self' data:; style-src 'unsafe-inline'; sandbox";

std::string dumped(const Json& document) {
  return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<std::string> text_or_nothing(const Json& value) {
  if (value.is_null()) return std::nullopt;
  return value.get<std::string>();
}

/// A part of the path, from 1, in the order of the brackets of the route's pattern.
std::string part(const Request& request, std::size_t number) {
  return request.matches[number].str();
}

std::size_t number_in(const std::string& text) {
  std::size_t number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || stop != text.data() + text.size()) {
    throw InputError("the address has something else where a number belongs");
  }
  return number;
}

Json body_of(const Request& request) {
  return Json::parse(request.body);
}

void add_page(httplib::Server& server, const std::string& prefix) {
  const auto send = [](const PageFile& file, Response& answer) {
    answer.set_header("Content-Encoding", "gzip");
    put(answer, std::string(file.packed.begin(), file.packed.end()), std::string(file.type));
  };
  for (const PageFile& file : page_files()) {
    const auto handler = answering([&file, send](const Request&, Response& answer) { send(file, answer); });
    const std::string name(file.name);
    server.Get(prefix + "/" + (name == "index.html" ? "" : name), handler);
  }
}

void add_program(httplib::Server& server, const std::string& api, const Served& served) {
  server.Get(api + "/program", answering([served](const Request&, Response& answer) {
               const ServerSettings& settings = served.settings;
               const Json opened{{"case", settings.opened_case ? Json(*settings.opened_case) : Json(nullptr)},
                                 {"run", settings.opened_run ? Json(*settings.opened_run) : Json(nullptr)}};
               put_json(answer, dumped({{"version", settings.version},
                                        {"folder", served.workspace.folder().string()},
                                        {"processors", std::thread::hardware_concurrency()},
                                        {"opened", opened}}));
             }));
  server.Get(api + "/parameters",
             answering([](const Request&, Response& answer) { put_json(answer, parameters_json()); }));
}

/// One design after the other: each may take as much memory as the fabric that it draws.
void add_design(httplib::Server& server, const std::string& api) {
  auto one_at_a_time = std::make_shared<std::mutex>();
  server.Post(api + "/design", answering([one_at_a_time](const Request& request, Response& answer) {
                const Json body = body_of(request);
                DesignRequest wanted{body.at("text").get<std::string>(), {}, body.value("fabric", false)};
                if (body.contains("edit")) {
                  const Json& edit = body.at("edit");
                  wanted.edit = {edit.at("key").get<std::string>(), edit.at("typed").get<std::string>()};
                }
                const std::scoped_lock lock(*one_at_a_time);
                put(answer, design_blob(wanted), "application/octet-stream");
              }));
}

void add_cases(httplib::Server& server, const std::string& api, const Served& served) {
  server.Get(api + "/cases", answering([served](const Request&, Response& answer) {
               put_json(answer, served.workspace.cases_json());
             }));
  server.Get(api + "/case", answering([served](const Request& request, Response& answer) {
               put_json(answer, served.workspace.case_json(request.get_param_value("path")));
             }));
  server.Get(api + "/example", answering([](const Request& request, Response& answer) {
               put_json(answer, Workspace::example_json(request.get_param_value("name")));
             }));
  server.Get(api + "/template",
             answering([](const Request&, Response& answer) { put_json(answer, Workspace::template_json()); }));
  server.Put(api + "/case", answering([served](const Request& request, Response& answer) {
               const Json body = body_of(request);
               put_json(answer,
                        served.workspace.save(body.at("path").get<std::string>(), body.at("text").get<std::string>(),
                                              text_or_nothing(body.at("stamp"))));
             }));
}

void add_exports(httplib::Server& server, const std::string& api) {
  server.Get(api + "/formats", answering([](const Request&, Response& answer) {
               Json formats = Json::array();
               for (const run::ExportFormat& each : run::export_formats()) {
                 formats.push_back({{"name", each.name},
                                    {"label", each.label},
                                    {"kind", each.kind == run::ExportKind::deck ? "deck" : "geometry"},
                                    {"endings", each.endings}});
               }
               put_json(answer, dumped(formats));
             }));
  server.Post(api + "/export", answering([](const Request& request, Response& answer) {
                const Json body = body_of(request);
                const auto loaded = run::load_case_text(body.at("text").get<std::string>(), "case");
                const run::ExportSource source{
                    .input = loaded.input, .model = loaded.model, .stem = body.at("stem").get<std::string>()};
                put(answer,
                    exported_file(source, body.at("format").get<std::string>(), body.at("ending").get<std::string>()),
                    "application/octet-stream");
              }));
  server.Post(api + "/measured", answering([](const Request& request, Response& answer) {
                const Json body = body_of(request);
                put_json(answer, measured_json(body.at("name").get<std::string>(), body.at("text").get<std::string>(),
                                               body.at("gauge_length").get<std::string>(),
                                               body.at("width").get<std::string>()));
              }));
}

void add_run_reading(httplib::Server& server, const std::string& api, Runs& runs) {
  const std::string run = api + "/runs/([^/]+)";
  server.Get(api + "/runs",
             answering([&runs](const Request&, Response& answer) { put_json(answer, runs.list_json()); }));
  server.Get(run, answering([&runs](const Request& request, Response& answer) {
               put_json(answer, runs.detail_json(part(request, 1)));
             }));
  server.Get(run + "/history", answering([&runs](const Request& request, Response& answer) {
               const std::string from = request.get_param_value("from");
               put_json(answer, runs.history_json(part(request, 1), from.empty() ? 0 : number_in(from)));
             }));
  server.Get(run + "/model", answering([&runs](const Request& request, Response& answer) {
               put(answer, runs.model_blob(part(request, 1)), "application/octet-stream");
             }));
  server.Get(run + "/frames/([0-9]{1,7})", answering([&runs](const Request& request, Response& answer) {
               const int index = static_cast<int>(number_in(part(request, 2)));
               put(answer, runs.frame_blob(part(request, 1), index), "application/octet-stream");
             }));
  server.Get(run + "/live", answering([&runs](const Request& request, Response& answer) {
               put(answer, runs.live_blob(part(request, 1)), "application/octet-stream");
             }));
  server.Get(run + "/geometry", answering([&runs](const Request& request, Response& answer) {
               const RequestWords words(request.params.begin(), request.params.end());
               put(answer, runs.geometry(part(request, 1), words), "application/octet-stream");
             }));
  server.Get(run + "/picture", answering([&runs](const Request& request, Response& answer) {
               const RequestWords words(request.params.begin(), request.params.end());
               put(answer, runs.picture_png(part(request, 1), words), "image/png");
             }));
}

void add_run_commands(httplib::Server& server, const std::string& api, Runs& runs) {
  const std::string run = api + "/runs/([^/]+)";
  server.Post(api + "/runs", answering([&runs](const Request& request, Response& answer) {
                const Json body = body_of(request);
                const std::string id =
                    runs.start(body.at("text").get<std::string>(), body.at("name").get<std::string>());
                put_json(answer, dumped({{"id", id}}));
              }));
  const auto add = [&](const char* name, void (Runs::*command)(const std::string&)) {
    server.Post(run + "/" + name, answering([&runs, command](const Request& request, Response& answer) {
                  (runs.*command)(part(request, 1));
                  put_json(answer, "{}");
                }));
  };
  add("pause", &Runs::pause);
  add("resume", &Runs::resume);
  add("stop", &Runs::stop);
  add("report", &Runs::write_report);
}

void add_run_files(httplib::Server& server, const std::string& prefix, Runs& runs) {
  server.Get(prefix + "/runs/([^/]+)/(.+)", answering([&runs](const Request& request, Response& answer) {
               RunFile file = read_run_file(runs.folder_of(part(request, 1)), part(request, 2));
               answer.set_header("Content-Security-Policy", kFilePolicy);
               put(answer, std::move(file.content), file.type);
             }));
}

std::string text_of(const std::vector<RunEvent>& events) {
  std::string text;
  for (const RunEvent& event : events) text += "event: " + event.name + "\ndata: " + event.data + "\n\n";
  return text.empty() ? ":\n\n" : text;  // a comment: shows whether the page is still there
}

void add_events(httplib::Server& server, const std::string& api, const Served& served) {
  auto n_listeners = std::make_shared<std::atomic<int>>(0);
  server.Get(api + "/events", answering([n_listeners, served](const Request&, Response& answer) {
               if (n_listeners->fetch_add(1) >= kMostListeners) {
                 n_listeners->fetch_sub(1);
                 throw Refusal(503, "too many pages are open; close some");
               }
               answer.set_chunked_content_provider(
                   "text/event-stream",
                   [served, seen = std::uint64_t{0}](std::size_t, httplib::DataSink& sink) mutable {
                     if (served.is_ending()) {
                       sink.done();
                       return true;
                     }
                     const std::string text = text_of(served.runs.wait_for_changes(seen, kEventWait));
                     return sink.write(text.data(), text.size());
                   },
                   [n_listeners](bool) { n_listeners->fetch_sub(1); });
             }));
}

}  // namespace

void add_routes(httplib::Server& server, const std::string& prefix, const Served& served) {
  const std::string api = prefix + "/api";
  add_page(server, prefix);
  add_program(server, api, served);
  add_design(server, api);
  add_cases(server, api, served);
  add_exports(server, api);
  add_run_reading(server, api, served.runs);
  add_run_commands(server, api, served.runs);
  add_events(server, api, served);
  add_run_files(server, prefix, served.runs);
}

}  // namespace knitmech::serve
