#pragma once

#include <cstddef>
#include <cstdint>

namespace knitmech::exchange {

/// Longest floating point number of an Abaqus data line [characters], sign, point and exponent included (Abaqus
/// Analysis User's Guide, "Input syntax rules"). A longer one may be cut, and with it its exponent.
inline constexpr std::size_t kAbaqusNumberWidth = 20;

/// Longest line of an Abaqus input file [characters] ("Input syntax rules").
inline constexpr std::size_t kAbaqusLineWidth = 256;

/// Most entries on a data line of *NSET and *ELSET (Abaqus Keywords Guide).
inline constexpr std::size_t kAbaqusSetEntries = 16;

/// Abaqus' default slenderness compensation factor of transverse shear [-], also that of the beam elements here.
/// Written into the deck so that it does not depend on a default, and because soft yarns need less (AbaqusSection).
inline constexpr double kSlendernessCompensation = 0.25;

/// How far EI may be from EA D^2 / 16 for a solid circle, as a share of EI [-]. Only rounding has to fit in.
inline constexpr double kCircleTolerance = 1e-9;

/// Straight pieces between two points of a measured curve [-]. More: nearer to the smooth curve, and a longer deck.
inline constexpr int kCurvePieces = 8;

/// Strain [-] that the written curve reaches into compression and beyond its last point.
inline constexpr double kCurveReach = 1;

/// Largest cosine [-] between an element and the first axis of its section: 45 degrees. Abaqus needs the two not
/// parallel; any direction has a coordinate axis at least 54.7 degrees away from it, so a fitting axis always exists.
inline constexpr double kLargestFirstAxisCosine = 0.7071067811865476;

/// How far the straight pieces of a yarn in a geometry file are from its smooth centreline at most, as a share of its
/// radius [-]; usual 0.03, about as far as a polygon of 12 sides is from its circle. Less: smoother and larger files.
inline constexpr double kChordErrorShare = 0.03;

/// Straight pieces of an element at most [-]. Only an element very much longer than its yarn is thick needs as many.
inline constexpr int kMostStepsPerElement = 1000;

/// Sections of a yarn in a CAD file for each element [-], and how far faces and edges of a solid may be from each other
/// [mm]. With 3 the wall of a loop of 10 elements per half stitch is one radius from its centreline within 1.7 % of the
/// radius, with 2 within 5 %, with 4 within 0.9 %, and a file is as much larger.
inline constexpr int kSolidStepsPerElement = 3;
inline constexpr double kSolidTolerance = 1e-6;

/// Most sections in a CAD file [-]: while it is made, one takes 11 kB of memory.
inline constexpr std::size_t kMostSolidSections = 1000000;

/// Largest file of tubes [bytes]: the length of a binary glTF file is a number of 32 bits (glTF 2.0, 4.4.2). The other
/// formats are held to it too, since a file is made, and read by other programs, in memory.
inline constexpr std::uint64_t kMostFileBytes = 0xffffffff;

/// Least distance of a node that gives beams their orientation from the middle of the fabric [mm], and that distance in
/// extents of the fabric [-]. So far that its direction is that of the axis, to 0.1, from everywhere in the fabric.
inline constexpr double kOrientationDistance = 1000;
inline constexpr double kOrientationExtents = 10;

/// Time that a velocity curve reaches, in durations of the test [-]: a run that is made longer keeps its speed.
inline constexpr double kCurveAfterTheTest = 10;

/// Numbers on a line of a list of nodes or parts [-], in OpenRadioss decks (Radioss Reference Guide, "/GRNOD",
/// "/LINE/PART").
inline constexpr std::size_t kNumbersOnALine = 10;

/// Longest title and longest name of a run in an OpenRadioss deck [characters] (Radioss Reference Guide, "/TITLE",
/// "/BEGIN").
inline constexpr std::size_t kRadiossTitle = 100;
inline constexpr std::size_t kRadiossRunName = 80;

/// Format year of OpenRadioss decks, and the first in which /INTER/TYPE11 has Irem_gap.
inline constexpr int kRadiossYear = 2018;
inline constexpr int kRadiossYearOfRemovedGaps = 2020;

/// Yarn diameter as a share of the shortest element [-] above which contact along a yarn has to be left out: there the
/// starter of OpenRadioss warns of a large gap, and elements next but one to each other come near to touching.
inline constexpr double kShortForContact = 0.5;

/// Stiffness of a line of /INTER/TYPE11 in that of a crossing [-]: two lines in series, and half of that.
inline constexpr double kLinesInSeries = 4;

/// Characters of a number in the engine deck of OpenRadioss [-], which is free of columns; digits: all that matter.
inline constexpr std::size_t kRadiossEngineNumber = 14;

/// Cycles between two lines that OpenRadioss prints [-].
inline constexpr int kRadiossPrintedCycles = 5000;

/// Numbers on a line of a list of nodes or parts in LS-DYNA decks [-] (LS-DYNA Keyword User's Manual I, "*SET").
inline constexpr std::size_t kDynaNumbersOnALine = 8;

/// Longest title of an LS-DYNA deck [characters] (LS-DYNA Keyword User's Manual I, "*TITLE").
inline constexpr std::size_t kDynaTitle = 80;

/// ELFORM of a beam of given A, I and J, after Belytschko and Schwer (LS-DYNA Keyword User's Manual I,
/// "*SECTION_BEAM").
inline constexpr int kResultantBeam = 2;

/// SOFT by which the reader of OpenRadioss makes *CONTACT_AUTOMATIC_GENERAL a contact of beams with each other.
inline constexpr int kSoftOfBeamContact = -11;

/// FS of *CONTACT by which *DEFINE_FRICTION gives the friction (LS-DYNA Keyword User's Manual I, "*CONTACT").
inline constexpr int kFrictionOfTable = -2;

/// Stiffness of a line in that of a crossing [-], where OpenRadioss takes the mean of both lines: half of it counts.
inline constexpr double kLinesInParallel = 2;

/// Share of the stable time step that explicit decks ask for [-]. The contact is not in the stable step of the
/// elements, hence less than the usual 0.9.
inline constexpr double kStepShare = 0.8;

/// Inner square of a round section of hexahedra: distance of its corners from the centre, as a share of the outline's
/// radius [-]. With 0.59 the second moment of area under 2 x 2 points of integration is that of the circle to 0.02 %;
/// with 0.5 and 0.68 it is 0.3 % too small and too large.
inline constexpr double kCoreShare = 0.59;

/// Longest solid element, in yarn diameters [-], and the most that the yarn may turn in it [rad]. A quarter turn in six
/// of them bends as stiff as theory says within 0.5 %, in three within 1 %.
inline constexpr double kSolidLargestLength = 2.5, kSolidLargestTurn = 0.3;

/// Shortest element that a tie cuts off, in yarn diameters [-].
inline constexpr double kSolidShortest = 0.05;

/// The most that a beam element may turn [rad], and rise over its chord, in radii of gyration [-].
inline constexpr double kBeamLargestTurn = 0.3, kBeamLargestRise = 0.1;

/// Largest cosine [-] between a yarn and the first axis of its section in CalculiX, which turns the axis square to it.
inline constexpr double kCalculixLargestAxisCosine = 0.98;

/// When an increment with beams has converged: largest residual force over the mean force, largest correction over the
/// displacement of the increment [-]. CalculiX' own are 0.005 and 0.01; the residual of held rotations stays at 0.004
/// to 0.009 while the corrections fall to 1e-5, so that it cuts increments without end. Here the correction decides.
inline constexpr double kBeamResidual = 0.02, kBeamCorrection = 0.001;

/// Largest ratio of the bending stiffnesses of two yarns of a fabric of beams without contact [-]. With 100 a fabric of
/// 2 x 3 stitches goes through; with 3460, the soft edge yarn of the article, its pull is 1e-9 N and nothing converges.
inline constexpr double kCalculixBendingRatio = 100;

/// Stiffness of CalculiX' contact in pressure per penetration [MPa/mm], in units of the model's contact stiffness k
/// over the square of the diameter [-]. Two crossing cylinders that overlap by d share a volume of pi D d^2 / 4, so
/// that a crossing bears the force k pi d^2 / (4 D): 2.5 % of the diameter at a thousandth of k D. More: harder, and
/// more iterations; with 10, loose courses of 2 x 2 stitches take three times as long, with 100 they do not converge.
inline constexpr double kPressureStiffnessShare = 1;

/// Slope of the stick over that stiffness [-]: a tenth, so that the motion let through is small beside the penetration
/// that the friction comes from. More: more iterations.
inline constexpr double kStickShare = 0.1;

/// Increments of CalculiX' static step: largest and least, as shares of the test [-], and most of them.
inline constexpr double kCalculixIncrement = 0.1, kCalculixLeastIncrement = 1e-6;
inline constexpr int kCalculixIncrements = 100000;

/// Largest motion of the grip in an increment where yarns touch, in yarn diameters [-]. With 0.05 an increment of 2 x 2
/// loose stitches takes about 6 iterations; with 0.5 there are wrong states with a hundred times the force among them.
inline constexpr double kSolidIncrement = 0.05;

/// States of a test that CalculiX writes at most, about [-]; one has the size of the deck.
inline constexpr int kCalculixStates = 100;

/// Terms of *EQUATION on a line, and nodes on the first line of a 20-node element (a line has at most 16 entries).
inline constexpr std::size_t kCalculixEquationTerms = 4;
inline constexpr int kNodesOnFirstLine = 15;

}  // namespace knitmech::exchange
