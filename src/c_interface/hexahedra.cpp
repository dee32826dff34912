// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <memory>
#include <utility>
#include <variant>

#include "c_interface/field_calls.hpp"
#include "c_interface/guarded.hpp"
#include "c_interface/handles.hpp"
#include "crossgrain/read_limits.hpp"
#include "measure/hex_quality.hpp"

using namespace crossgrain;

static_assert(static_cast<int>(HexOutcome::kApproximate) == CROSSGRAIN_APPROXIMATE_HEX);
static_assert(static_cast<int>(HexOutcome::kNone) == CROSSGRAIN_NO_HEX);

crossgrain_hexahedra::crossgrain_hexahedra(Made its_hexahedra)
    : made(std::move(its_hexahedra)),
      sentence(sentence_of(*report().hexahedra)),
      scaled_jacobians(crossgrain::scaled_jacobians(mesh())) {
  for (const HexMesh::Face& face : mesh().boundary) {
    faces.insert(faces.end(), face.vertices.begin(), face.vertices.end());
    tags.push_back(face.tag);
  }
}

const HexMesh& crossgrain_hexahedra::mesh() const {
  return std::visit([](const auto& hexahedra) -> const HexMesh& { return hexahedra.mesh; }, made);
}

const SolveReport& crossgrain_hexahedra::report() const {
  if (const auto* fitted = std::get_if<FittedHexahedra>(&made)) return fitted->report;
  return std::get<Hexahedra>(made).field.report();
}

namespace {

/// Hexahedra of a model, or of a lattice where no tets can be made of it.
template <class Model>
crossgrain_hexahedra* made_in(const Model& model, const HexMeshingOptions& options, const Monitor& monitor) {
  try {
    return new crossgrain_hexahedra(make_hexahedra(model, options, monitor));
  } catch (const Error& error) {
    return new crossgrain_hexahedra(lattice_without_tets(error, model, options, monitor));
  }
}

}  // namespace

crossgrain_status crossgrain_hexahedra_make(const char* path, const crossgrain_options* options,
                                            crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                            crossgrain_error** error) {
  return made(out, error, [&] {
    return made_in(std::filesystem::path(&given(path, "path")),
                   options_or_defaults<HexMeshingOptions>(options), monitor_of(monitor));
  });
}

crossgrain_status crossgrain_hexahedra_make_inside(const crossgrain_mesh* surface,
                                                   const crossgrain_options* options,
                                                   crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                                   crossgrain_error** error) {
  return made(out, error, [&] {
    return made_in(given(surface, "surface").mesh, options_or_defaults<HexMeshingOptions>(options),
                   monitor_of(monitor));
  });
}

crossgrain_status crossgrain_hexahedra_make_in_tets(const crossgrain_domain* domain,
                                                    const crossgrain_options* options,
                                                    crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                                    crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_hexahedra(make_hexahedra(given(domain, "domain").domain,
                                                   options_or_defaults<HexMeshingOptions>(options),
                                                   monitor_of(monitor)));
  });
}

crossgrain_status crossgrain_hexahedra_lattice(const char* path, const crossgrain_options* options,
                                               crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                               crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_hexahedra(lattice_hexahedra(std::filesystem::path(&given(path, "path")),
                                                      options_or_defaults<HexMeshingOptions>(options),
                                                      monitor_of(monitor)));
  });
}

crossgrain_status crossgrain_hexahedra_lattice_inside(const crossgrain_mesh* surface,
                                                      const crossgrain_options* options,
                                                      crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                                      crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_hexahedra(lattice_hexahedra(given(surface, "surface").mesh,
                                                      options_or_defaults<HexMeshingOptions>(options),
                                                      monitor_of(monitor)));
  });
}

crossgrain_status crossgrain_tet_field_hexahedra(const crossgrain_tet_field* field,
                                                 const crossgrain_options* options,
                                                 crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                                 crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_hexahedra(hexahedra(given(field, "field").field,
                                              options_or_defaults<HexOptions>(options), monitor_of(monitor)));
  });
}

crossgrain_status crossgrain_hexahedra_fit(const char* mesh, const char* model,
                                           const crossgrain_options* options, crossgrain_monitor* monitor,
                                           crossgrain_hexahedra** out, crossgrain_error** error) {
  return made(out, error, [&] {
    const std::filesystem::path path = &given(mesh, "mesh"), its_model = &given(model, "model");
    const HexFitOptions& chosen = options_or_defaults<HexFitOptions>(options);
    const HexMesh read = [&] {
      const ReadLimits limits(monitor_of(monitor), chosen.max_memory_bytes);
      return read_hexahedra(path);
    }();
    try {
      return new crossgrain_hexahedra(fit_hexahedra(read, its_model, chosen, monitor_of(monitor)));
    } catch (const Error& failure) {
      throw failure.kind() == ErrorKind::kInput && failure.file().empty() ? failure.with_file(path.string())
                                                                          : failure;
    }
  });
}

crossgrain_status crossgrain_hexahedra_fit_arrays(const double* vertices, size_t vertex_count,
                                                  const uint32_t* corners, size_t count, const char* model,
                                                  const crossgrain_options* options,
                                                  crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                                  crossgrain_error** error) {
  return made(out, error, [&] {
    HexMesh mesh;
    const auto coordinates = elements(vertices, vertex_count, 3, "vertices");
    const auto indices = elements(corners, count, 8, "corners");
    mesh.vertices.resize(vertex_count);
    for (size_t k = 0; k < coordinates.size(); ++k) mesh.vertices[k / 3][k % 3] = coordinates[k];
    mesh.hexahedra.resize(count);
    for (size_t k = 0; k < indices.size(); ++k) mesh.hexahedra[k / 8][k % 8] = indices[k];
    return new crossgrain_hexahedra(fit_hexahedra(mesh, std::filesystem::path(&given(model, "model")),
                                                  options_or_defaults<HexFitOptions>(options),
                                                  monitor_of(monitor)));
  });
}

void crossgrain_hexahedra_free(crossgrain_hexahedra* hexahedra) {
  delete hexahedra;
}

crossgrain_hex_outcome crossgrain_hexahedra_outcome(const crossgrain_hexahedra* hexahedra) {
  if (hexahedra == nullptr) return {};
  return static_cast<crossgrain_hex_outcome>(hexahedra->report().hexahedra->outcome);
}

const char* crossgrain_hexahedra_sentence(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? nullptr : hexahedra->sentence.c_str();
}

size_t crossgrain_hexahedra_vertex_count(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? 0 : hexahedra->mesh().vertices.size();
}

size_t crossgrain_hexahedra_count(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? 0 : hexahedra->mesh().hexahedra.size();
}

size_t crossgrain_hexahedra_face_count(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? 0 : hexahedra->tags.size();
}

const double* crossgrain_hexahedra_vertices(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? nullptr : numbers_of(hexahedra->mesh().vertices);
}

const uint32_t* crossgrain_hexahedra_corners(const crossgrain_hexahedra* hexahedra) {
  if (hexahedra == nullptr) return nullptr;
  const auto& corners = hexahedra->mesh().hexahedra;
  return corners.empty() ? nullptr : corners.front().data();
}

const double* crossgrain_hexahedra_scaled_jacobians(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? nullptr : data_or_null(hexahedra->scaled_jacobians);
}

const int32_t* crossgrain_hexahedra_regions(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? nullptr : data_or_null(hexahedra->mesh().regions);
}

const uint32_t* crossgrain_hexahedra_faces(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? nullptr : data_or_null(hexahedra->faces);
}

const int32_t* crossgrain_hexahedra_face_tags(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? nullptr : data_or_null(hexahedra->tags);
}

const char* crossgrain_hexahedra_unit(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? nullptr : hexahedra->mesh().unit.c_str();
}

crossgrain_status crossgrain_hexahedra_field(const crossgrain_hexahedra* hexahedra,
                                             crossgrain_tet_field** out, crossgrain_error** error) {
  return made(out, error, [&] {
    const auto* followed = std::get_if<Hexahedra>(&given(hexahedra, "hexahedra").made);
    if (followed == nullptr) throw Error(ErrorKind::kUsage, "these hexahedra follow no field");
    return new crossgrain_tet_field{followed->field};
  });
}

crossgrain_status crossgrain_hexahedra_report(const crossgrain_hexahedra* hexahedra, char** json,
                                              crossgrain_error** error) {
  return made(json, error, [&] { return copy_of(report_json(given(hexahedra, "hexahedra").report())); });
}

crossgrain_status crossgrain_hexahedra_write(const crossgrain_hexahedra* hexahedra, const char* path,
                                             int inverted, crossgrain_monitor* monitor,
                                             crossgrain_error** error) {
  return guarded(error, [&] {
    write_hexahedra(given(hexahedra, "hexahedra").mesh(), &given(path, "path"), monitor_of(monitor),
                    inverted != 0 ? InvertedHexahedra::kAllowed : InvertedHexahedra::kRefused);
  });
}

crossgrain_status crossgrain_hexahedra_write_folder(const crossgrain_hexahedra* hexahedra, const char* folder,
                                                    const crossgrain_options* options, const char* model,
                                                    double read_seconds, crossgrain_monitor* monitor,
                                                    char** json, crossgrain_error** error) {
  return guarded(error, [&] {
    const crossgrain_hexahedra::Made& made = given(hexahedra, "hexahedra").made;
    if (const auto* fitted = std::get_if<FittedHexahedra>(&made)) {
      const SolveReport report = write_fitted(*fitted, &given(folder, "folder"), monitor_of(monitor),
                                              output_options_for(*fitted, options));
      if (json != nullptr) *json = copy_of(report_json(report));
      return;
    }
    const Hexahedra& written = std::get<Hexahedra>(made);
    OutputOptions output = output_options_for(written.field, options);
    // These pointers own nothing: the handle outlives the call.
    output.hexahedra = {std::shared_ptr<const void>(), &written.mesh};
    output.hex_map = {std::shared_ptr<const void>(), &written.map};
    write_result(written.field, folder, output, model, read_seconds, monitor, json);
  });
}
