#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace knitmech::serve {

/// What the page is served from, and where.
struct ServerSettings {
  std::filesystem::path folder;                        ///< of the cases
  std::filesystem::path runs_folder;                   ///< of the run folders
  std::optional<std::string> opened_case, opened_run;  ///< that the page begins with: a path in folder, the id of a run
  std::string host = "127.0.0.1";  ///< address to listen at; another one than loopback lets others in
  std::optional<int> port;         ///< empty: kUsualPort, or any free one
  std::string version;             ///< of the program
};

inline constexpr int kUsualPort = 8642;

/// The program's side of the page: files of the page, requests of web/src/api/types.ts, files of the runs.
///
/// Every address begins with a secret of 128 random bits, made anew at each start, so that other pages of the same
/// browser can neither read nor do anything here; in addition a request must be addressed to this server by the name
/// of this computer (against names that are made to point here) and must not come from another page (Origin).
/// Answers that are files of the user may not run scripts. Requests are at most kLargestRequest long.
class Server {
 public:
  /// Listens from here on. @throws InputError if the port is taken, FileError if the folder cannot be read
  explicit Server(ServerSettings settings);

  /// Ends the connections, interrupts the runs (they can go on later), and waits for all.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// "http://127.0.0.1:8642/0123.../", for the browser.
  [[nodiscard]] std::string address() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace knitmech::serve
