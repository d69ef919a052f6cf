#include "serve/request_guard.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/errors.h"

namespace knitmech::serve {
namespace {

/// The first part of a path, "abc" of "/abc/api/runs".
std::string_view first_part(std::string_view path) {
  if (!path.starts_with('/')) return {};
  path.remove_prefix(1);
  return path.substr(0, path.find('/'));
}

/// In a time that does not tell how much of them is equal.
bool are_equal(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned>(a[i] ^ b[i]);
  return difference == 0;
}

bool changes_something(std::string_view method) {
  return method != "GET" && method != "HEAD";
}

}  // namespace

RequestGuard::RequestGuard(std::string token, std::string name, int port, bool is_loopback)
    : token_(std::move(token)), name_(std::move(name)), port_(port), is_loopback_(is_loopback) {}

bool RequestGuard::names_this_computer(std::string_view host) const {
  const std::array names{fmt::format("127.0.0.1:{}", port_), fmt::format("localhost:{}", port_),
                         fmt::format("[::1]:{}", port_), fmt::format("{}:{}", name_, port_)};
  return std::ranges::find(names, host) != names.end();
}

std::optional<GuardRefusal> RequestGuard::refusal(const RequestHead& request) const {
  if (is_loopback_ && !names_this_computer(request.host)) {
    return GuardRefusal{403, "this program answers only to 127.0.0.1 and localhost"};
  }
  if (!request.origin.empty() && request.origin != fmt::format("http://{}", request.host)) {
    return GuardRefusal{403, "this program answers only to its own page"};
  }
  if (!are_equal(first_part(request.path), token_)) {
    return GuardRefusal{403,
                        "this address is not complete, or of an earlier start; open the one that knitmech ui prints"};
  }
  if (changes_something(request.method) && !request.content_type.starts_with("application/json")) {
    return GuardRefusal{415, "the request must be application/json"};
  }
  return std::nullopt;
}

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw FileError("the system gives no random numbers");
  }
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

}  // namespace knitmech::serve
