// SPDX-License-Identifier: Apache-2.0
// Netgen's library as Debian builds it: with OpenCASCADE, and in a namespace that its header does not open.
#pragma once

#include <memory>

#define OCCGEOMETRY
namespace nglib {
#include <nglib.h>
}

namespace crossgrain {

struct DeleteNetgenMesh {
  void operator()(nglib::Ng_Mesh* mesh) const { nglib::Ng_DeleteMesh(mesh); }
};
using NetgenMesh = std::unique_ptr<nglib::Ng_Mesh, DeleteNetgenMesh>;

}  // namespace crossgrain
