#include <iostream>

#include "app/commands.h"
#include "model/parameters_text.h"

namespace knitmech::app {

ExitCode run_command(const ParametersOptions& options) {
  std::cout << (options.markdown ? model::input_reference() : model::parameter_list()) << std::flush;
  return kDone;
}

}  // namespace knitmech::app
