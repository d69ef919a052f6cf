#pragma once

#include <stdexcept>
#include <string>

namespace knitmech {

/// Wrong input by the user: a case file, a curve, a command line argument.
///
/// The message is one sentence that says what is wrong, where (file, line, key) and what would be right; it is shown as
/// it stands. Ends the program with exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that cannot be read or written. Ends the program with exit code 4.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace knitmech
