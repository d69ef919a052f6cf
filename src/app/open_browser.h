#pragma once

#include <filesystem>
#include <string>

namespace knitmech::app {

/// Opens an address in the user's browser, as far as the computer has one and a screen to show it on.
///
/// Other users of the computer may see the arguments of programs, and the address holds a secret; so the browser is
/// given a file that only this user can read and that leads to the address. It goes with this object.
class OpenedBrowser {
 public:
  /// Tries; opened() tells whether it went.
  explicit OpenedBrowser(const std::string& address);
  ~OpenedBrowser();
  OpenedBrowser(const OpenedBrowser&) = delete;
  OpenedBrowser& operator=(const OpenedBrowser&) = delete;

  [[nodiscard]] bool opened() const { return opened_; }

 private:
  std::filesystem::path folder_;
  bool opened_ = false;
};

}  // namespace knitmech::app
