#include "exchange/abaqus_number.h"

#include <fmt/format.h>

#include "exchange/constants.h"

namespace knitmech::exchange {

namespace {

std::string with_point(std::string text) {
  if (text.find_first_of(".e") == std::string::npos) text += '.';
  return text;
}

}  // namespace

std::string abaqus_number(double value) {
  std::string text = with_point(fmt::format("{}", value));
  for (int digits = 16; text.size() > kAbaqusNumberWidth; --digits) {
    text = with_point(fmt::format("{:.{}g}", value, digits));
  }
  return text;
}

std::string abaqus_text(const std::string& text) {
  std::string result = text;
  for (char& letter : result) {
    if (letter < ' ' || letter > '~') letter = '?';
  }
  return result;
}

}  // namespace knitmech::exchange
