// SPDX-License-Identifier: Apache-2.0
#include "step.hpp"

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <stdexcept>

namespace crossgrain::models {

void write_step(const std::filesystem::path& path, const TopoDS_Shape& solid) {
  Message::DefaultMessenger()->ChangePrinters().Clear();  // the writer reports each file on standard output
  STEPControl_Writer writer;
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.unit", "MM");
  if (writer.Transfer(solid, STEPControl_ManifoldSolidBrep) != IFSelect_RetDone)
    throw std::runtime_error("the solid cannot be translated to STEP");
  // The writer numbers products by the process.
  const Handle(TCollection_HAsciiString) name = new TCollection_HAsciiString(path.stem().c_str());
  for (int k = 1; k <= writer.Model()->NbEntities(); ++k) {
    const auto product = Handle(StepBasic_Product)::DownCast(writer.Model()->Value(k));
    if (product.IsNull()) continue;
    product->SetId(name);
    product->SetName(name);
  }
  APIHeaderSection_MakeHeader header(writer.Model());
  header.SetName(name);
  header.SetTimeStamp(new TCollection_HAsciiString("2026-01-01T00:00:00"));
  header.SetAuthorValue(1, new TCollection_HAsciiString("The Crossgrain authors"));
  header.Apply(writer.Model());
  if (writer.Write(path.c_str()) != IFSelect_RetDone) throw std::runtime_error("the file cannot be written");
}

}  // namespace crossgrain::models
