#include "serve/mistake_json.h"

#include <nlohmann/json.hpp>

#include "model/case_file.h"

namespace knitmech::serve {

nlohmann::ordered_json mistake_json(const std::exception& error) {
  nlohmann::ordered_json mistake{{"message", error.what()}, {"key", nullptr}, {"line", nullptr}};
  const auto* of_case = dynamic_cast<const model::CaseFileError*>(&error);
  if (of_case == nullptr) return mistake;
  mistake["message"] = of_case->complaint();
  if (!of_case->key().empty()) mistake["key"] = of_case->key();
  if (of_case->line() > 0) mistake["line"] = of_case->line();
  return mistake;
}

}  // namespace knitmech::serve
