#pragma once

#include <map>
#include <optional>
#include <string>

namespace knitmech::serve {

/// What stands behind the ? of an address.
using RequestWords = std::map<std::string, std::string>;

/// A word; none if it is not there or empty.
[[nodiscard]] std::optional<std::string> word(const RequestWords& words, const char* name);

/// A word that is a whole number from 0 to `largest`; none if it is not there. Throws InputError if it is no such
/// number.
[[nodiscard]] std::optional<int> whole_number(const RequestWords& words, const char* name, int largest);

}  // namespace knitmech::serve
