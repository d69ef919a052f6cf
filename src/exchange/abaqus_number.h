#pragma once

#include <string>

namespace knitmech::exchange {

/// A real number as text for an Abaqus data line: always with a point or an exponent, so that it is never taken for an
/// integer, and never longer than kAbaqusNumberWidth.
///
/// The shortest text that gives back the same bits, wherever that fits into the width: always for 0.1 <= |value| <
/// 1e16. Other numbers of 16 or 17 digits lose their last ones: the text then differs by less than 1e-17 for |value| <
/// 0.1, and by less than a share of 1e-12 of the value at worst.
/// @param value finite
[[nodiscard]] std::string abaqus_number(double value);

/// Text that Abaqus takes on a data line: one line of 7-bit ASCII, anything else replaced by "?".
[[nodiscard]] std::string abaqus_text(const std::string& text);

}  // namespace knitmech::exchange
