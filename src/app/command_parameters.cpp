#include <iostream>

#include "app/commands.h"
#include "model/parameters_text.h"
#include "serve/parameters_json.h"

namespace knitmech::app {

ExitCode run_command(const ParametersOptions& options) {
  if (options.json) {
    std::cout << serve::parameters_json() << std::endl;
    return kDone;
  }
  std::cout << (options.markdown ? model::input_reference() : model::parameter_list()) << std::flush;
  return kDone;
}

}  // namespace knitmech::app
