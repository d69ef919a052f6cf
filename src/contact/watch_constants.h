#pragma once

/// Every number that tunes the watch over crossings and yarn ends, with its unit, its usual value and what a change
/// does. D is the diameter of the yarns, or the mean of two.
namespace knitmech::contact {

/// What two pieces may move against each other between two checks beyond twice kCheckCrossings, since a check comes
/// only after the step that makes it due [D]. Nodes move by 0.05 D in a step at most.
inline constexpr double kBeyondCheck = 0.2;

/// Length at a free end of a yarn that the watch over crossings does not count [radii of the yarn]. What slips over
/// the end there leaves the loop instead of going through it. Larger: passes close to an end are no losses.
inline constexpr double kUncountedEnd = 1;

/// Offset that keeps yarns which meet exactly, as in symmetric tests, from being neither on one side nor on the other
/// [D]. Far above the rounding of positions, far below anything that matters.
inline constexpr double kOffset = 1e-7;

/// Length of a yarn's tail, which is watched for slipping out of loops [D]. Larger: crossings are noticed earlier, at
/// more cost.
inline constexpr double kTail = 6;

/// Half the length of the window on the other yarn [D]. Larger: neighbouring crossings of one loop count as one.
inline constexpr double kOtherHalfWindow = 3;

/// How far the place of a crossing may move along either yarn between two calls [D]. Larger: places jump to another
/// crossing nearby; smaller: they are left behind where yarns slide at small angles.
inline constexpr double kPlaceStep = 1.5;

/// Distance along the other yarn within which an end that slips back and off again is not reported a second time [D]:
/// yarns slide meanwhile. Larger: an end that leaves a loop of a narrow bight at its second place is not reported.
inline constexpr double kSameEvent = 6;

/// Length of tail that must stick out beyond another yarn before this is a crossing that can be lost over the end [D].
inline constexpr double kHeldTail = 1;

/// Least size of the Gauss integral of such a crossing [-]. Straight yarns that touch have 0.31 at a right angle and
/// 0.15 at 20 degrees; smaller: ends that merely lie beside a yarn count as crossing it.
inline constexpr double kHeldIntegral = 0.15;

/// Share of its largest value to which the Gauss integral falls when the end is off the other yarn [-]. At a right
/// angle 0.63 is left when the end is just above the other centreline, 0.4 when it has gone half a diameter further,
/// 0.25 a whole one.
inline constexpr double kOffShare = 0.4;

/// Distance within which a tail is at another yarn [D]. Larger: loose yarns cross as well.
inline constexpr double kAtYarn = 2;

}  // namespace knitmech::contact
