#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace knitmech::serve {

/// What is looked at before a request is answered.
struct RequestHead {
  std::string_view method, path;
  std::string_view host, origin, content_type;  ///< the fields of these names; empty where there is none
};

/// Why a request is refused.
struct GuardRefusal {
  int status;
  std::string sentence;
};

/// Lets only the page of this program in, see Server.
class RequestGuard {
 public:
  /// \param name of the computer in the server's address, besides those that every computer has for itself
  /// \param is_loopback whether the server can only be reached from this computer
  RequestGuard(std::string token, std::string name, int port, bool is_loopback);

  [[nodiscard]] const std::string& token() const { return token_; }

  /// Empty if the request may be answered.
  [[nodiscard]] std::optional<GuardRefusal> refusal(const RequestHead& request) const;

 private:
  [[nodiscard]] bool names_this_computer(std::string_view host) const;

  std::string token_, name_;
  int port_;
  bool is_loopback_;
};

/// 128 random bits in hexadecimal digits. @throws FileError if the system gives none
[[nodiscard]] std::string random_token();

}  // namespace knitmech::serve
