#include "app/option_quantity.h"

#include <fmt/format.h>

#include "base/errors.h"

namespace knitmech::app {

std::optional<double> option_quantity(const char* option, const std::string& text, base::Dimension dimension) {
  if (text.empty()) return std::nullopt;
  try {
    return base::parse_quantity(text, dimension);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", option, error.what()));
  }
}

}  // namespace knitmech::app
