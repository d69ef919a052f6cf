#pragma once

#include <string>

namespace knitmech::base {

/// "35 s", "2 min 10 s", "1 h 5 min". @param seconds [s]
[[nodiscard]] std::string duration_text(double seconds);

/// "9.6 %". @param ratio [-]
[[nodiscard]] std::string percent_text(double ratio);

/// "1.23 N", below 0.1 N "12.3 mN". @param force [N]
[[nodiscard]] std::string force_text(double force);

/// "1.23 N/mm", below 0.1 N/mm "12.3 mN/mm". @param force over width [N/mm]
[[nodiscard]] std::string per_width_text(double force);

}  // namespace knitmech::base
