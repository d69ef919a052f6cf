#include <fmt/format.h>

#include "exchange/abaqus_reading.h"

namespace knitmech::exchange::deck {

namespace {

AbaqusDeck::Step& current_step(Reading& reading, const KeywordBlock& block) {
  if (reading.step == nullptr) reading.fail(block.line, fmt::format("{} outside a step", block.as_written));
  return *reading.step;
}

}  // namespace

void read_amplitude(Reading& reading, const KeywordBlock& block) {
  const std::string name = reading.required(block, "NAME");
  if (const std::string kind = block.option("DEFINITION", "TABULAR"); kind != "TABULAR") {
    reading.fail(block.line, fmt::format("an amplitude of DEFINITION={} cannot be read; TABULAR can", kind));
  }
  AbaqusDeck::Amplitude amplitude;
  amplitude.line = block.line;
  for (const DataLine& data : block.data) {
    if (data.is_blank()) continue;
    const std::vector<double> values = reading.reals(data);
    if (values.size() % 2 != 0) reading.fail(data.line, "an amplitude needs pairs of time and value");
    for (std::size_t i = 0; i < values.size(); i += 2) {
      if (!amplitude.points.empty() && values[i] <= amplitude.points.back().first) {
        reading.fail(data.line, fmt::format("the times of the amplitude {} do not ascend", name));
      }
      amplitude.points.emplace_back(values[i], values[i + 1]);
    }
  }
  if (amplitude.points.empty()) reading.fail(block.line, fmt::format("the amplitude {} has no points", name));
  reading.deck.amplitudes[name] = std::move(amplitude);
}

void read_boundary(Reading& reading, const KeywordBlock& block) {
  for (const DataLine& data : block.data) {
    if (data.is_blank()) continue;
    AbaqusDeck::Boundary boundary;
    boundary.line = data.line;
    boundary.nodes = data.entry(0);
    boundary.type = block.option("TYPE", "DISPLACEMENT");
    boundary.amplitude = block.option("AMPLITUDE");
    boundary.value = reading.real(data, 3);
    if (data.entry(1) == "ENCASTRE") {
      boundary.first_dof = 1;
      boundary.last_dof = 6;
    } else {
      boundary.first_dof = reading.whole(data, 1);
      boundary.last_dof = data.entry(2).empty() ? boundary.first_dof : reading.whole(data, 2);
    }
    if (boundary.first_dof < 1 || boundary.last_dof > 6 || boundary.last_dof < boundary.first_dof) {
      reading.fail(data.line, "the degrees of freedom of a boundary are a first and a last of 1 to 6");
    }
    (reading.step != nullptr ? reading.step->boundaries : reading.deck.boundaries).push_back(std::move(boundary));
  }
}

void read_step(Reading& reading, const KeywordBlock& block) {
  if (reading.step != nullptr) {
    reading.fail(block.line, fmt::format("*STEP inside the step of line {}; *END STEP is missing", reading.step->line));
  }
  AbaqusDeck::Step& step = reading.deck.steps.emplace_back();
  step.name = block.option("NAME");
  step.large_displacements = block.has("NLGEOM") && block.option("NLGEOM") != "NO";
  step.line = block.line;
  reading.step = &step;
}

void read_end_step(Reading& reading, const KeywordBlock& block) {
  current_step(reading, block);
  reading.step = nullptr;
  reading.output = nullptr;
}

void read_dynamic(Reading& reading, const KeywordBlock& block) {
  AbaqusDeck::Step& step = current_step(reading, block);
  step.explicit_dynamics = block.has("EXPLICIT");
  const DataLine& data = reading.data_line(block, 0);
  step.duration = reading.real(data, 1);
  if (step.duration <= 0) reading.fail(data.line, "the duration of a step, the second entry, must be positive");
}

void read_bulk_viscosity(Reading& reading, const KeywordBlock& block) {
  AbaqusDeck::Step& step = current_step(reading, block);
  const DataLine& data = reading.data_line(block, 0);
  if (!data.entry(0).empty()) step.linear_bulk_viscosity = reading.real(data, 0);
  if (!data.entry(1).empty()) step.quadratic_bulk_viscosity = reading.real(data, 1);
}

void read_mass_scaling(Reading& reading, const KeywordBlock& block) {
  const std::string factor = reading.required(block, "FACTOR");
  const double value = real_number(reading.source, block.line, factor);
  if (value <= 0) reading.fail(block.line, "the factor of a mass scaling must be positive");
  current_step(reading, block).mass_scaling = value;
}

void read_output(Reading& reading, const KeywordBlock& block) {
  current_step(reading, block);
  reading.output = &block;
}

void read_output_request(Reading& reading, const KeywordBlock& block) {
  AbaqusDeck::Step& step = current_step(reading, block);
  if (reading.output == nullptr)
    reading.fail(block.line, fmt::format("{} without *OUTPUT before it", block.as_written));
  AbaqusDeck::OutputRequest request;
  request.kind = block.keyword;
  request.line = block.line;
  request.history = reading.output->has("HISTORY");
  request.options = block.options;
  request.options.insert(reading.output->options.begin(), reading.output->options.end());
  for (const DataLine& data : block.data) {
    for (const std::string& entry : data.entries) {
      if (!entry.empty()) request.variables.push_back(entry);
    }
  }
  step.output.push_back(std::move(request));
}

}  // namespace knitmech::exchange::deck
