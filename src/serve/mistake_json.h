#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stdexcept>

namespace knitmech::serve {

/// `Mistake` of web/src/api/types.ts: the sentence of an error and, of a mistake in a case, where it is.
[[nodiscard]] nlohmann::ordered_json mistake_json(const std::exception& error);

}  // namespace knitmech::serve
