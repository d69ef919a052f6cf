#pragma once

#include <string>

#include "model/frame.h"
#include "model/model.h"

namespace knitmech::serve {

/// The stress-free fabric of a run: RunModel of web/src/api/types.ts, with its arrays.
[[nodiscard]] std::string model_blob(const model::Model& model);

/// A state of the fabric with its fields and contacts: FrameHead of types.ts, with its arrays. Values of fields are in
/// the unit that the head tells; the ends of the colour bars hold all values of this frame.
/// \param live number of the live view; 0 for a stored frame
[[nodiscard]] std::string frame_blob(const model::Model& model, const model::Frame& frame, int live);

}  // namespace knitmech::serve
