#pragma once

#include <string>

#include "base/errors.h"

namespace knitmech::serve {

/// A request that is refused, with the status of the answer [HTTP, RFC 9110]: 404 there is no such thing, 409 it is in
/// another state than the request takes it to be, 413 it is too large. A plain InputError is answered with 400, a
/// FileError with 500.
class Refusal : public InputError {
 public:
  Refusal(int status, const std::string& sentence) : InputError(sentence), status_(status) {}
  [[nodiscard]] int status() const { return status_; }

 private:
  int status_;
};

}  // namespace knitmech::serve
