#pragma once

#include <optional>
#include <string>

namespace knitmech::serve {

/// A change of one value in the text of a case, as a person types it.
struct DesignEdit {
  std::string key, typed;
};

struct DesignRequest {
  std::string text;  ///< of the case file
  std::optional<DesignEdit> edit;
  bool fabric = false;  ///< whether the centrelines of the fabric are wanted
};

/// Elements up to which the centrelines of a fabric are sent to be drawn [-]; a million make 20 MB.
inline constexpr int kMostElementsDrawn = 1'000'000;

/// What a case makes: `Design` of web/src/api/types.ts as a blob. The loop is drawn as soon as its own values are
/// right, whatever is wrong elsewhere.
/// @throws InputError if the edit cannot be done
[[nodiscard]] std::string design_blob(const DesignRequest& request);

}  // namespace knitmech::serve
