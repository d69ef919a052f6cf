#include "solve/threads.h"

#include <algorithm>
#include <thread>

#include "solve/constants.h"

namespace knitmech::solve {

int automatic_threads(int n_elements, unsigned n_processors) {
  const int useful = n_elements / kElementsPerThread;
  return std::max(1, std::min(useful, static_cast<int>(n_processors)));
}

int automatic_threads(const model::Model& model) {
  return automatic_threads(model.n_elements(), std::thread::hardware_concurrency());
}

}  // namespace knitmech::solve
