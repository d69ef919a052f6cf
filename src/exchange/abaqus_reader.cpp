#include "exchange/abaqus_reader.h"

#include <fmt/format.h>

#include <map>

#include "exchange/abaqus_reading.h"

namespace knitmech::exchange {

namespace deck {

std::vector<double> Reading::reals(const DataLine& data) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < data.entries.size(); ++i) {
    const bool trailing_comma = i > 0 && i + 1 == data.entries.size() && data.entries[i].empty();
    if (!trailing_comma) values.push_back(real(data, i));
  }
  return values;
}

std::string Reading::required(const KeywordBlock& block, const char* option) const {
  std::string value = block.option(option);
  if (value.empty()) fail(block.line, fmt::format("{} needs {}=...", block.as_written, option));
  return value;
}

const DataLine& Reading::data_line(const KeywordBlock& block, std::size_t i) const {
  if (i >= block.data.size()) fail(block.line, fmt::format("{} ends before its data line {}", block.as_written, i + 1));
  return block.data[i];
}

}  // namespace deck

namespace {

using deck::Reading;

void read_heading(Reading& reading, const KeywordBlock& block) {
  reading.deck.heading = block.text;
}

void refuse(Reading& reading, const KeywordBlock& block) {
  reading.fail(block.line,
               fmt::format("{} cannot be read; write the deck as one flat file without parts, instances and "
                           "includes",
                           block.as_written));
}

using Reader = void (*)(Reading&, const KeywordBlock&);

/// The one list of keywords that are read.
Reader reader_of(const std::string& keyword) {
  static const std::map<std::string, Reader> kReaders = {
      {"HEADING", read_heading},
      {"NODE", deck::read_nodes},
      {"ELEMENT", deck::read_elements},
      {"NSET", deck::read_node_set},
      {"ELSET", deck::read_element_set},
      {"BEAMSECTION", deck::read_beam_section},
      {"BEAMGENERALSECTION", deck::read_general_beam_section},
      {"AXIAL", deck::read_section_behaviour},
      {"M1", deck::read_section_behaviour},
      {"M2", deck::read_section_behaviour},
      {"TORQUE", deck::read_section_behaviour},
      {"TRANSVERSESHEARSTIFFNESS", deck::read_transverse_shear},
      {"MATERIAL", deck::read_material},
      {"DENSITY", deck::read_density},
      {"ELASTIC", deck::read_elastic},
      {"AMPLITUDE", deck::read_amplitude},
      {"BOUNDARY", deck::read_boundary},
      {"EQUATION", deck::read_equations},
      {"SURFACE", deck::read_surface},
      {"SURFACEINTERACTION", deck::read_interaction},
      {"FRICTION", deck::read_friction},
      {"SURFACEBEHAVIOR", deck::read_surface_behavior},
      {"CONTACT", deck::read_contact},
      {"CONTACTINCLUSIONS", deck::read_contact_inclusions},
      {"CONTACTPROPERTYASSIGNMENT", deck::read_contact_properties},
      {"SURFACEPROPERTYASSIGNMENT", deck::read_surface_property},
      {"STEP", deck::read_step},
      {"ENDSTEP", deck::read_end_step},
      {"DYNAMIC", deck::read_dynamic},
      {"BULKVISCOSITY", deck::read_bulk_viscosity},
      {"FIXEDMASSSCALING", deck::read_mass_scaling},
      {"OUTPUT", deck::read_output},
      {"NODEOUTPUT", deck::read_output_request},
      {"ELEMENTOUTPUT", deck::read_output_request},
      {"CONTACTOUTPUT", deck::read_output_request},
      {"ENERGYOUTPUT", deck::read_output_request},
      {"PART", refuse},
      {"INSTANCE", refuse},
      {"ASSEMBLY", refuse},
      {"INCLUDE", refuse},
  };
  const auto found = kReaders.find(keyword);
  return found == kReaders.end() ? nullptr : found->second;
}

}  // namespace

AbaqusDeck read_abaqus(std::istream& in, const std::string& source) {
  Reading reading;
  reading.source = source;
  const std::vector<KeywordBlock> blocks = read_keyword_blocks(in, source);
  for (const KeywordBlock& block : blocks) {
    if (const Reader reader = reader_of(block.keyword); reader != nullptr) {
      reader(reading, block);
    } else {
      reading.deck.unread.push_back({block.as_written, block.line});
    }
  }
  if (reading.step != nullptr) reading.fail(reading.step->line, "the step does not end; *END STEP is missing");
  check_references(reading.deck, source);
  return std::move(reading.deck);
}

}  // namespace knitmech::exchange
