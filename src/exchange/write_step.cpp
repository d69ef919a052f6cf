#include <fmt/format.h>

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Compound.hxx>
#include <cstdint>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "base/errors.h"
#include "base/text.h"
#include "exchange/constants.h"
#include "exchange/tube_files.h"
#include "exchange/tube_solid.h"

namespace knitmech::exchange {
namespace {

/// Open CASCADE keeps options and printers for the whole program, and STEPControl_Writer reads and writes them.
std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

/// While it lives Open CASCADE prints nothing to standard output, where the file may go.
class Silence {
 public:
  Silence() : printers_(Message::DefaultMessenger()->Printers()) {
    Message::DefaultMessenger()->ChangePrinters().Clear();
  }
  ~Silence() { Message::DefaultMessenger()->ChangePrinters() = printers_; }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  Message_SequenceOfPrinters printers_;
};

/// What stands for the title until the text is there: Open CASCADE writes no letters but those of ASCII.
constexpr const char* kTitle = "title-of-the-fabric";

/// A string between its quotes (ISO 10303-21, 6.4.3): quotes and backslashes twice, other than ASCII by its number.
std::string in_step(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const char32_t letter = base::take_letter(text);
    const auto number = static_cast<std::uint32_t>(letter);
    if (number == '\'' || number == '\\') {
      result.append(2, static_cast<char>(number));
    } else if (number >= ' ' && number <= '~') {
      result += static_cast<char>(number);
    } else if (number <= 0xFFFF) {
      result += fmt::format("\\X2\\{:04X}\\X0\\", number);
    } else {
      result += fmt::format("\\X4\\{:08X}\\X0\\", number);
    }
  }
  return result;
}

void replace_all(std::string& text, std::string_view word, std::string_view other) {
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + other.size())) {
    text.replace(at, word.size(), other);
  }
}

opencascade::handle<TCollection_HAsciiString> words(const std::string& text) {
  return new TCollection_HAsciiString(text.c_str());
}

void check_size(const std::vector<YarnRow>& rows) {
  std::size_t sections = 0;
  for (const YarnRow row : rows) sections += kSolidStepsPerElement * row.size() + 1;
  if (sections <= kMostSolidSections) return;
  throw InputError(fmt::format(
      "step: the yarns of this fabric are solids of {} sections, and {} are the most, as they fill 11 GB of "
      "memory; export fewer wales and courses, or take -f gltf",
      sections, kMostSolidSections));
}

/// An assembly of the solids.
TopoDS_Compound assembly(const std::vector<YarnRow>& rows) {
  TopoDS_Compound fabric;
  const BRep_Builder builder;
  builder.MakeCompound(fabric);
  for (const YarnRow row : rows) builder.Add(fabric, tube_solid(row));
  return fabric;
}

void transfer(STEPControl_Writer& writer, const TopoDS_Shape& fabric) {
  Interface_Static::SetIVal("write.step.assembly", 1);
  Interface_Static::SetIVal("write.surfacecurve.mode", 0);  // edges without a second description on their faces
  if (writer.Transfer(fabric, STEPControl_AsIs) != IFSelect_RetDone) {
    throw std::runtime_error("Open CASCADE refuses to write solids that it has made");
  }
}

/// The product of the assembly comes first, then one of each solid in their order. The occurrences get numbers here, as
/// Open CASCADE counts on from file to file.
void set_names(const StepData_StepModel& model, const std::vector<YarnRow>& rows) {
  std::size_t n_products = 0, n_occurrences = 0;
  for (int i = 1; i <= model.NbEntities(); ++i) {
    if (const auto product = opencascade::handle<StepBasic_Product>::DownCast(model.Value(i)); !product.IsNull()) {
      const std::string name =
          n_products == 0 ? kTitle : fmt::format("yarn {}", rows.at(n_products - 1).front().yarn + 1);
      product->SetId(words(name));
      product->SetName(words(name));
      ++n_products;
    }
    const auto occurrence = opencascade::handle<StepRepr_NextAssemblyUsageOccurrence>::DownCast(model.Value(i));
    if (!occurrence.IsNull()) occurrence->SetId(words(fmt::format("{}", ++n_occurrences)));
  }
}

void set_header(const opencascade::handle<StepData_StepModel>& model) {
  APIHeaderSection_MakeHeader header(model);
  const auto nothing = words("");
  header.SetName(words(kTitle));
  header.SetTimeStamp(nothing);
  header.SetAuthorValue(1, nothing);
  header.SetOrganizationValue(1, nothing);
  header.SetOriginatingSystem(words("KnitMech"));
  header.SetAuthorisation(nothing);
  header.SetDescriptionValue(1, words("Yarns of a knitted fabric as solids, lengths in mm"));
  header.Apply(model);
}

std::string text_of(const opencascade::handle<StepData_StepModel>& model) {
  StepData_StepWriter writer(model);
  writer.SendModel(opencascade::handle<StepData_Protocol>::DownCast(model->Protocol()));
  std::ostringstream text;
  writer.Print(text);
  return std::move(text).str();
}

}  // namespace

std::string step_text(const YarnTubes& tubes) {
  const std::lock_guard lock(one_at_a_time());
  const Silence silence;
  try {
    const std::vector<YarnRow> rows = tube_rows(tubes.pieces);
    check_size(rows);
    STEPControl_Writer writer;  // which empties its model at its end
    transfer(writer, assembly(rows));
    const opencascade::handle<StepData_StepModel> model = writer.Model();
    set_names(*model, rows);
    set_header(model);
    std::string text = text_of(model);
    replace_all(text, kTitle, in_step(tubes.title));
    return text;
  } catch (const Standard_Failure& failure) {  // which is no std::exception
    throw std::runtime_error(fmt::format("Open CASCADE: {}", failure.GetMessageString()));
  }
}

}  // namespace knitmech::exchange
