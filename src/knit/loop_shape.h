#pragma once

namespace knitmech::knit {

/// The measured shape of one loop, all of the yarn centreline; the half of it is the ERC (elementary representative
/// cell).
struct LoopShape {
  double height = 0;        ///< H [mm], head middle to foot middle
  double width = 0;         ///< L [mm], width of one stitch: the wale spacing
  double head_flat = 0;     ///< l1 [mm], half length of the flat top of the head
  double head_radius = 0;   ///< R1 [mm], radius of the head arc
  double foot_flat = 0;     ///< l2 [mm], half length of the flat bottom of the foot
  double foot_radius = 0;   ///< R2 [mm], radius of the foot arc
  double out_of_plane = 0;  ///< p [1/mm], the loop lies on z = -p y^2, y from mid-height
};

}  // namespace knitmech::knit
