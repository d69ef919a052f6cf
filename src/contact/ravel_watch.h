#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/left_out.h"
#include "contact/contact_elements.h"
#include "contact/neighbour_search.h"
#include "contact/yarn_window.h"
#include "model/state.h"

namespace knitmech::contact {

enum class YarnEnd { first_node, last_node };

/// A free yarn end that has slipped over another yarn, or over another place of its own yarn: the crossing that was
/// there is gone. In a knitted fabric this is ravelling.
struct RavelEvent {
  std::int32_t yarn;        ///< whose end it is
  YarnEnd end;              ///< which of its ends
  std::int32_t other_yarn;  ///< that it slipped over
  double arc_length;        ///< of the place on the other yarn, along it from its first node [mm]
  Vector3 place;            ///< on the other yarn [mm]

  template <class Archive>
  void serialize(Archive& archive) {
    archive(yarn, end, other_yarn, arc_length, place);
  }
};

/// Where the tail of a yarn is near a place of another yarn, or of its own.
struct TailApproach {
  std::size_t tail = 0;   ///< number of the tail
  std::size_t other = 0;  ///< number of the other yarn, by its range of nodes
  double arc_length = 0;  ///< of the place on the other yarn [mm]
  double distance = 0;    ///< of the centrelines there [mm]
  double sticks_out = 0;  ///< length of the tail beyond the place [mm]; 0: its end is nearest
  double integral = 0;    ///< Gauss integral of the two windows [-]
  Vector3 place{};        ///< on the other yarn [mm]

  template <class Archive>
  void serialize(Archive& archive) {
    archive(tail, other, arc_length, distance, sticks_out, integral, place);
  }
};

/// Watches the free ends of yarns.
///
/// The tail of a yarn (kTail) and a window on the other yarn about the place nearest to it (kOtherHalfWindow) have a
/// Gauss integral that is large where they cross and halves when the place of the crossing reaches the very end. A
/// crossing is held where the tail is at the other yarn, sticks out beyond it (kHeldTail) and the integral is large
/// enough (kHeldIntegral): ends that lie beside a yarn, or just reach it, hold none. A held crossing is followed until
/// its integral has dropped to kOffShare of its largest value. If the end of the yarn is there, that is an event. If it
/// is not, as when a loop is lifted or pulled off sideways, the crossing is gone without one. There is no second event
/// when the same end slips back and off near the same place again. Windows are stretches of yarn, so the mesh does not
/// matter. Where a yarn crosses itself, its two windows leave out the middle half of the loop between them.
class RavelWatch {
 public:
  explicit RavelWatch(std::shared_ptr<const ContactElements> elements);

  /// The events since the call before. An end must not move more than about 0.2 D between two calls.
  /// \param position of the contact nodes [mm]
  /// \param pairs all pairs of pieces that touch or nearly touch, nearer than about 1.4 D
  std::vector<RavelEvent> update(const model::VectorArray& position, const std::vector<ElementPair>& pairs);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(base::left_out(elements_, ranges_, tails_, range_of_yarn_, tail_at_), held_, gone_);
  }

 private:
  static constexpr std::uint8_t kNoTail = 0, kFirstTail = 1, kLastTail = 2;
  struct Tail {
    std::size_t range;  ///< index into ranges_
    YarnEnd end;
    ArcWindow window;
    double end_arc;  ///< arc length of the end [mm]
  };
  struct Windows {
    ArcWindow tail, other;
  };
  struct HeldCrossing {
    TailApproach now;
    double largest_integral = 0;  ///< with its sign [-]

    template <class Archive>
    void serialize(Archive& archive) {
      archive(now, largest_integral);
    }
  };

  [[nodiscard]] std::size_t range_of(std::int32_t piece) const {
    return range_of_yarn_[static_cast<std::size_t>(elements_->yarn[static_cast<std::size_t>(piece)])];
  }
  void add_tail(std::size_t range, YarnEnd end, double length);
  void follow_held(const model::VectorArray& position, std::vector<RavelEvent>& events);
  void hold_new(const model::VectorArray& position, const std::vector<ElementPair>& pairs);
  void add_approach(const model::VectorArray& position, std::int32_t tail_piece, std::int32_t other_piece,
                    std::vector<TailApproach>& found) const;
  bool look(const model::VectorArray& position, TailApproach& approach) const;
  [[nodiscard]] double place_on_tail(const TailApproach& approach) const;
  [[nodiscard]] Windows windows(const TailApproach& approach) const;
  [[nodiscard]] bool is_own_yarn(const TailApproach& approach) const;
  [[nodiscard]] double loop_length(const TailApproach& approach) const;
  [[nodiscard]] bool is_held(const TailApproach& approach) const;
  [[nodiscard]] bool end_is_there(const TailApproach& approach) const;
  [[nodiscard]] bool is_known(const TailApproach& approach) const;
  [[nodiscard]] bool is_same(const TailApproach& a, const TailApproach& b, double reach) const;
  [[nodiscard]] double diameter(const TailApproach& approach) const;
  [[nodiscard]] RavelEvent event_of(const TailApproach& approach) const;

  std::shared_ptr<const ContactElements> elements_;
  std::vector<YarnRange> ranges_;
  std::vector<Tail> tails_;                 ///< two to a range, that of the first node before that of the last
  std::vector<std::size_t> range_of_yarn_;  ///< index into ranges_
  std::vector<std::uint8_t> tail_at_;       ///< which tail of its yarn a piece belongs to; one entry per piece
  std::vector<HeldCrossing> held_;
  std::vector<TailApproach> gone_;  ///< reported
};

}  // namespace knitmech::contact
