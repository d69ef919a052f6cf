#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/left_out.h"
#include "base/thread_team.h"
#include "contact/contact_elements.h"
#include "contact/gauss_integral.h"
#include "contact/neighbour_search.h"
#include "contact/ravel_watch.h"
#include "contact/yarn_window.h"
#include "model/state.h"

namespace knitmech::contact {

/// Two yarns that went through each other.
struct CrossingLoss {
  std::int32_t first, second;  ///< pieces, first < second
  Vector3 place;               ///< [mm]
};

/// What happened to the crossings of yarns since the call before.
struct CrossingReport {
  std::vector<CrossingLoss> lost;
  std::vector<RavelEvent> ravelled;
};

/// Watches that no yarn passes through another or through itself during a run. Knows nothing of the contact law: it
/// looks at positions only.
///
/// Between two calls every point of a yarn goes straight from its old to its new place. Two pieces that were further
/// apart than they moved against each other cannot have met. For all other pairs the passes are counted exactly
/// (gauss_integral.h): yarns that turn, slide, bend or lie side by side raise no alarm, however near they are, and a
/// pass is found at any angle. Opposite passes of neighbouring pieces in one call cancel: there the straight way cuts a
/// corner that the yarns may have gone round.
///
/// A free end may leave a loop: the last radius of a yarn (kUncountedEnd) is not counted. RavelWatch sees it go.
///
/// The yarns are the chords of the pieces. A piece of a length l that turns by an angle a in a smooth yarn lies l a / 8
/// inside of it; if that of two pieces adds up to the distance of the smooth yarns, the chords may pass where the yarns
/// do not. Pieces of two diameters that turn by 0.25 rad leave 0.06 D each, and 0.25 D where they turn by 1 rad.
class CrossingWatch {
 public:
  explicit CrossingWatch(std::shared_ptr<const ContactElements> elements);

  /// Compares with the positions at the call before. The first call has nothing to compare with.
  ///
  /// Its cost is linear in the number of pairs: one distance each. What is remembered of it are only the pairs that may
  /// meet before the next call.
  /// \param position of the contact nodes [mm]
  /// \param pairs all pairs of pieces that may meet before the next call, and those of a crossing, nearer than about
  /// 1.4 D (find_neighbours), for the yarn ends
  /// \param motion that two pieces make against each other before the next call at most [mm]
  CrossingReport update(const model::VectorArray& position, const std::vector<ElementPair>& pairs, double motion,
                        const base::ThreadTeam& team = base::ThreadTeam(1));

  template <class Archive>
  void serialize(Archive& archive) {
    archive(base::left_out(elements_, counted_, offset_), near_, ends_);
  }

 private:
  /// The part of a piece that counts, as shares of the way along it; nothing if it ends before it starts.
  struct CountedPart {
    double from, to;
    [[nodiscard]] bool is_any() const { return from < to; }
  };

  /// A pair that may meet, and where the parts of it that count were.
  struct NearPair {
    ElementPair pair;
    double distance;  ///< of the whole pieces [mm]
    Segment first, second;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(pair, distance, first, second);
    }
  };

  [[nodiscard]] CountedPart counted_part(std::int32_t piece) const;
  [[nodiscard]] Segment counted_segment(std::int32_t piece, const model::VectorArray& position) const;
  [[nodiscard]] std::vector<CrossingLoss> losses(const model::VectorArray& position) const;
  void remember(const model::VectorArray& position, const std::vector<ElementPair>& pairs, double reach,
                const base::ThreadTeam& team);

  std::shared_ptr<const ContactElements> elements_;
  std::vector<ArcWindow> counted_;  ///< one entry per yarn
  Vector3 offset_;                  ///< [mm], see passes()
  std::vector<NearPair> near_;      ///< of the last call
  RavelWatch ends_;
};

}  // namespace knitmech::contact
