// SPDX-License-Identifier: Apache-2.0
// Makes the models that ship with the project: crossgrain_models FOLDER
#include <Standard_Failure.hxx>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "parts.hpp"
#include "step.hpp"
#include "tessellation.hpp"

namespace {

struct Part {
  const char* name;
  TopoDS_Shape (*make)();
};

constexpr Part kParts[] = {
    {"bracket", crossgrain::models::bracket},
    {"housing", crossgrain::models::housing},
    {"pillow_block", crossgrain::models::pillow_block},
    {"pipe_branch", crossgrain::models::pipe_branch},
    {"wedge", crossgrain::models::wedge},
};

/// Writes one part and says so; false, with a line on standard error, where it cannot be made.
bool write_part(const Part& part, const std::filesystem::path& folder) {
  const auto fail = [&](const char* why) {
    std::fprintf(stderr, "%s: %s\n", part.name, why);
    return false;
  };
  try {
    const TopoDS_Shape solid = part.make();
    crossgrain::models::write_step(folder / (std::string(part.name) + ".step"), solid);
    const auto triangles = crossgrain::models::tessellate(solid, crossgrain::models::Deflection{});
    const std::filesystem::path path = folder / (std::string(part.name) + ".stl");
    crossgrain::models::write_stl(path, triangles);
    std::printf("%s: %zu triangles\n", path.c_str(), triangles.size());
    return true;
  } catch (const Standard_Failure& failure) {
    return fail(failure.GetMessageString());
  } catch (const std::exception& failure) {
    return fail(failure.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 2;
  }
  bool good = true;
  for (const Part& part : kParts) good = write_part(part, argv[1]) && good;
  return good ? 0 : 1;
}
