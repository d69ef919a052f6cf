#pragma once

#include "serve/http.h"
#include "serve/runs.h"
#include "serve/server.h"
#include "serve/workspace.h"

namespace knitmech::serve {

/// Largest request [bytes]: a measured curve of some ten hours.
inline constexpr std::size_t kLargestRequest = 24U << 20U;

/// What the answers stand on; outlives the server.
struct Served {
  const ServerSettings& settings;
  const Workspace& workspace;
  Runs& runs;
  const std::function<bool()> is_ending;  ///< whether long answers must end
};

/// Tells the server what to answer, all under the prefix "/TOKEN".
void add_routes(httplib::Server& server, const std::string& prefix, const Served& served);

}  // namespace knitmech::serve
