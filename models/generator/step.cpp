// SPDX-License-Identifier: Apache-2.0
#include "step.hpp"

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <stdexcept>

namespace crossgrain::models {

void write_step(const std::filesystem::path& path, const TopoDS_Shape& solid) {
  Message::DefaultMessenger()->ChangePrinters().Clear();  // the writer reports each file on standard output
  STEPControl_Writer writer;
  // Products are numbered by the process otherwise.
  Interface_Static::SetCVal("write.step.product.name", path.stem().c_str());
  if (writer.Transfer(solid, STEPControl_ManifoldSolidBrep) != IFSelect_RetDone)
    throw std::runtime_error("the solid cannot be translated to STEP");
  APIHeaderSection_MakeHeader header(writer.Model());
  header.SetName(new TCollection_HAsciiString(path.stem().c_str()));
  header.SetTimeStamp(new TCollection_HAsciiString("2026-01-01T00:00:00"));
  header.SetAuthorValue(1, new TCollection_HAsciiString("The Crossgrain authors"));
  header.Apply(writer.Model());
  if (writer.Write(path.c_str()) != IFSelect_RetDone) throw std::runtime_error("the file cannot be written");
}

}  // namespace crossgrain::models
