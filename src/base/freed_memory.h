#pragma once

namespace knitmech::base {

/// Hands memory that the program has freed back to the system, where the C library (glibc) would keep it for later: to
/// be called when much was needed only to set something up.
void hand_back_freed_memory();

}  // namespace knitmech::base
