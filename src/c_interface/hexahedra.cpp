// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <memory>
#include <utility>

#include "c_interface/field_calls.hpp"
#include "c_interface/guarded.hpp"
#include "c_interface/handles.hpp"
#include "measure/hex_quality.hpp"

using namespace crossgrain;

static_assert(static_cast<int>(HexOutcome::kApproximate) == CROSSGRAIN_APPROXIMATE_HEX);
static_assert(static_cast<int>(HexOutcome::kNone) == CROSSGRAIN_NO_HEX);

crossgrain_hexahedra::crossgrain_hexahedra(Hexahedra its_hexahedra)
    : made(std::move(its_hexahedra)),
      sentence(sentence_of(made.report())),
      scaled_jacobians(crossgrain::scaled_jacobians(made.mesh)) {
  for (const HexMesh::Face& face : made.mesh.boundary) {
    faces.insert(faces.end(), face.vertices.begin(), face.vertices.end());
    tags.push_back(face.tag);
  }
}

crossgrain_status crossgrain_hexahedra_make(const char* path, const crossgrain_options* options,
                                            crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                            crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_hexahedra(make_hexahedra(std::filesystem::path(&given(path, "path")),
                                                   options_or_defaults<HexMeshingOptions>(options),
                                                   monitor_of(monitor)));
  });
}

crossgrain_status crossgrain_hexahedra_make_inside(const crossgrain_mesh* surface,
                                                   const crossgrain_options* options,
                                                   crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                                   crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_hexahedra(make_hexahedra(given(surface, "surface").mesh,
                                                   options_or_defaults<HexMeshingOptions>(options),
                                                   monitor_of(monitor)));
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

crossgrain_status crossgrain_tet_field_hexahedra(const crossgrain_tet_field* field,
                                                 const crossgrain_options* options,
                                                 crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                                 crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_hexahedra(hexahedra(given(field, "field").field,
                                              options_or_defaults<HexOptions>(options), monitor_of(monitor)));
  });
}

void crossgrain_hexahedra_free(crossgrain_hexahedra* hexahedra) {
  delete hexahedra;
}

crossgrain_hex_outcome crossgrain_hexahedra_outcome(const crossgrain_hexahedra* hexahedra) {
  if (hexahedra == nullptr) return {};
  return static_cast<crossgrain_hex_outcome>(hexahedra->made.report().outcome);
}

const char* crossgrain_hexahedra_sentence(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? nullptr : hexahedra->sentence.c_str();
}

size_t crossgrain_hexahedra_vertex_count(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? 0 : hexahedra->made.mesh.vertices.size();
}

size_t crossgrain_hexahedra_count(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? 0 : hexahedra->made.mesh.hexahedra.size();
}

size_t crossgrain_hexahedra_face_count(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? 0 : hexahedra->tags.size();
}

const double* crossgrain_hexahedra_vertices(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? nullptr : numbers_of(hexahedra->made.mesh.vertices);
}

const uint32_t* crossgrain_hexahedra_corners(const crossgrain_hexahedra* hexahedra) {
  if (hexahedra == nullptr) return nullptr;
  const auto& corners = hexahedra->made.mesh.hexahedra;
  return corners.empty() ? nullptr : corners.front().data();
}

const double* crossgrain_hexahedra_scaled_jacobians(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? nullptr : data_or_null(hexahedra->scaled_jacobians);
}

const int32_t* crossgrain_hexahedra_regions(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? nullptr : data_or_null(hexahedra->made.mesh.regions);
}

const uint32_t* crossgrain_hexahedra_faces(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? nullptr : data_or_null(hexahedra->faces);
}

const int32_t* crossgrain_hexahedra_face_tags(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? nullptr : data_or_null(hexahedra->tags);
}

const char* crossgrain_hexahedra_unit(const crossgrain_hexahedra* hexahedra) {
  return hexahedra == nullptr ? nullptr : hexahedra->made.mesh.unit.c_str();
}

crossgrain_status crossgrain_hexahedra_field(const crossgrain_hexahedra* hexahedra,
                                             crossgrain_tet_field** out, crossgrain_error** error) {
  return made(out, error, [&] { return new crossgrain_tet_field{given(hexahedra, "hexahedra").made.field}; });
}

crossgrain_status crossgrain_hexahedra_report(const crossgrain_hexahedra* hexahedra, char** json,
                                              crossgrain_error** error) {
  return made(json, error,
              [&] { return copy_of(report_json(given(hexahedra, "hexahedra").made.field.report())); });
}

crossgrain_status crossgrain_hexahedra_write(const crossgrain_hexahedra* hexahedra, const char* path,
                                             int inverted, crossgrain_monitor* monitor,
                                             crossgrain_error** error) {
  return guarded(error, [&] {
    write_hexahedra(given(hexahedra, "hexahedra").made.mesh, &given(path, "path"), monitor_of(monitor),
                    inverted != 0 ? InvertedHexahedra::kAllowed : InvertedHexahedra::kRefused);
  });
}

crossgrain_status crossgrain_hexahedra_write_folder(const crossgrain_hexahedra* hexahedra, const char* folder,
                                                    const crossgrain_options* options, const char* model,
                                                    double read_seconds, crossgrain_monitor* monitor,
                                                    char** json, crossgrain_error** error) {
  return guarded(error, [&] {
    const Hexahedra& written = given(hexahedra, "hexahedra").made;
    OutputOptions output = output_options_for(written.field, options);
    // These pointers own nothing: the handle outlives the call.
    output.hexahedra = {std::shared_ptr<const void>(), &written.mesh};
    output.hex_map = {std::shared_ptr<const void>(), &written.map};
    write_result(written.field, folder, output, model, read_seconds, monitor, json);
  });
}
