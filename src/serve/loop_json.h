#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace knitmech::serve {

/// The drawing of the loop of a case text, `LoopDrawing` of web/src/api/types.ts; null while its values make no loop.
[[nodiscard]] nlohmann::ordered_json loop_json(std::string_view case_text);

}  // namespace knitmech::serve
