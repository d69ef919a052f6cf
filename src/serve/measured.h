#pragma once

#include <string>
#include <string_view>

namespace knitmech::serve {

/// Measured of web/src/api/types.ts: the curves in a text as compare::read_measured_curve() takes them from a file, in
/// force per width. A curve with many points is thinned; every point that is left is one of the file.
/// \param name of the file, for messages and curves \param gauge_length, width of the specimens, typed: "100 mm"
/// Throws Refusal with 413 for a text that is too large, InputError for one that is no table of curves.
[[nodiscard]] std::string measured_json(const std::string& name, std::string_view text, const std::string& gauge_length,
                                        const std::string& width);

}  // namespace knitmech::serve
