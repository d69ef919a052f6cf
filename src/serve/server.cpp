#include "serve/server.h"

#include <fmt/format.h>

#include <atomic>
#include <thread>
#include <utility>

#include "base/errors.h"
#include "serve/request_guard.h"
#include "serve/routes.h"

namespace knitmech::serve {
namespace {

/// Each connection that is open holds one, and a browser opens six and one for events.
constexpr std::size_t kThreads = 64;
constexpr int kKeepAlive = 5;                 ///< [s]
constexpr int kReadTimeout = 5;               ///< [s]
constexpr std::size_t kMostRequests = 10000;  ///< over one connection
constexpr std::size_t kLongestPath = 2000;    ///< [bytes]

constexpr const char* kPagePolicy =
    "default-src 'self'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' blob: data:; "
    "object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

bool is_loopback(const std::string& host) {
  return host == "localhost" || host == "::1" || host.starts_with("127.");
}

/// The name of this computer in an address, for one that it listens at.
std::string name_of(const std::string& host) {
  if (host == "0.0.0.0" || host == "::") return "127.0.0.1";
  return host.find(':') == std::string::npos ? host : "[" + host + "]";
}

int bound_port(httplib::Server& server, const ServerSettings& settings) {
  const int wanted = settings.port.value_or(kUsualPort);
  if (wanted != 0 && server.bind_to_port(settings.host, wanted)) return wanted;
  if (settings.port && wanted != 0) {
    throw InputError(fmt::format("cannot listen at port {} of {}; another program may do so, take another --port",
                                 wanted, settings.host));
  }
  const int any = server.bind_to_any_port(settings.host);
  if (any <= 0)
    throw InputError(fmt::format("cannot listen at {}; is that an address of this computer?", settings.host));
  return any;
}

/// Another program that listens at the same port would take turns with this one; the library's own choice allows it.
void keep_the_port(socket_t socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
}

}  // namespace

class Server::State {
 public:
  explicit State(ServerSettings settings)
      : settings_(std::move(settings)), workspace_(settings_.folder), runs_(settings_.runs_folder) {
    server_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server_.set_keep_alive_timeout(kKeepAlive);
    server_.set_keep_alive_max_count(kMostRequests);
    server_.set_read_timeout(kReadTimeout);
    server_.set_payload_max_length(kLargestRequest);
    server_.set_tcp_nodelay(true);
    server_.set_socket_options(keep_the_port);
    port_ = bound_port(server_, settings_);
    guard_.emplace(random_token(), name_of(settings_.host), port_, is_loopback(settings_.host));
    add_answers();
    thread_ = std::jthread([this] {
      server_.listen_after_bind();
      has_ended_ = true;
    });
    // The library cannot be told to stop before it runs.
    while (!server_.is_running() && !has_ended_) std::this_thread::yield();
  }

  ~State() {
    is_ending_ = true;
    server_.stop();
    thread_.join();
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  [[nodiscard]] std::string address() const {
    return fmt::format("http://{}:{}/{}/", name_of(settings_.host), port_, guard_->token());
  }

 private:
  void add_answers() {
    server_.set_default_headers({{"X-Content-Type-Options", "nosniff"},
                                 {"Referrer-Policy", "no-referrer"},
                                 {"X-Frame-Options", "DENY"},
                                 {"Cross-Origin-Resource-Policy", "same-origin"},
                                 {"Cache-Control", "no-store"}});
    server_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& answer) {
      return is_refused(request, answer) ? httplib::Server::HandlerResponse::Handled
                                         : httplib::Server::HandlerResponse::Unhandled;
    });
    server_.set_post_routing_handler([](const httplib::Request&, httplib::Response& answer) {
      if (!answer.has_header("Content-Security-Policy")) answer.set_header("Content-Security-Policy", kPagePolicy);
    });
    server_.set_error_handler([](const httplib::Request&, httplib::Response& answer) {
      if (!answer.body.empty() || answer.has_header("Content-Type")) return;
      const char* sentence = answer.status == 413   ? "the request is too large"
                             : answer.status == 404 ? "there is nothing at this address"
                                                    : "the request cannot be understood";
      put_mistake(answer, answer.status, InputError(sentence));
    });
    add_routes(server_, "/" + guard_->token(), {settings_, workspace_, runs_, [this] { return is_ending_.load(); }});
  }

  bool is_refused(const httplib::Request& request, httplib::Response& answer) const {
    if (request.path.size() > kLongestPath) {
      put_mistake(answer, 414, InputError("the address is too long"));
      return true;
    }
    const std::string host = request.get_header_value("Host");
    const std::string origin = request.get_header_value("Origin");
    const std::string content_type = request.get_header_value("Content-Type");
    const auto refusal = guard_->refusal({request.method, request.path, host, origin, content_type});
    if (refusal) put_mistake(answer, refusal->status, InputError(refusal->sentence));
    return refusal.has_value();
  }

  ServerSettings settings_;
  Workspace workspace_;
  Runs runs_;
  std::atomic<bool> is_ending_ = false, has_ended_ = false;
  int port_ = 0;
  std::optional<RequestGuard> guard_;
  httplib::Server server_;
  std::jthread thread_;
};

Server::Server(ServerSettings settings) : state_(std::make_unique<State>(std::move(settings))) {}
Server::~Server() = default;

std::string Server::address() const {
  return state_->address();
}

}  // namespace knitmech::serve
