#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "yarn/curve_columns.h"

namespace knitmech::yarn {

/// The readings of one tensile test of a yarn or a fabric, in the order of the file.
struct TensileCurve {
  std::string name;             ///< of the specimen, for messages and legends: the file, and which one in it
  std::vector<double> strains;  ///< of the gauge length [-]
  std::vector<double> forces;   ///< as many [N]
  std::string specimen{};       ///< its name in its file: that in the column of specimens, or its number
  bool per_width = false;       ///< the file tells forces per width
};

/// What is known of the yarn or fabric and its test besides the file; needed where a column asks for it.
struct TestFacts {
  std::optional<double> diameter{};        ///< D [mm], turns a stress into a force
  std::optional<double> linear_density{};  ///< [t/mm] (1 tex = 1e-12 t/mm), turns a force per tex into a force
  std::optional<double> gauge_length{};    ///< free length between the grips [mm], turns a displacement into a strain
  std::optional<double> width{};           ///< of a fabric [mm], turns a force per width into a force
  ColumnChoice columns{};                  ///< which to take
};

/// The tensile curves in a text as testing machines export it.
///
/// - Lines are skipped until one names a column of load and one of extension (curve_columns.h) and numbers follow. A
/// line
///   between them may hold the units. The separator is the tab, the semicolon or the comma, the first of these with
///   which the columns are found; the decimal mark is a point or a comma, the same throughout.
/// - One pair of columns is one specimen, or several if there is a column of specimens. Several pairs side by side are
/// as
///   many specimens; so are several columns of load beside one of extension.
/// - Of several kinds of load the first of force, force per linear density, stress, force per width is taken for which
/// the facts suffice; of
///   several kinds of extension the strain, then the displacement. Other columns do not matter.
/// - Empty lines are skipped, and so are pairs of empty cells, as shorter specimens have them at their end. An empty
/// cell of
///   the specimen column means the specimen above.
///
/// @param bytes the file's content: UTF-8 or Latin-1
/// @param file its name, for messages
/// @return at least one curve, each with at least two points
/// @throws InputError with file, line, what is wrong and what would be right
[[nodiscard]] std::vector<TensileCurve> read_tensile_curves(std::string_view bytes, const std::string& file,
                                                            const TestFacts& facts);

}  // namespace knitmech::yarn
