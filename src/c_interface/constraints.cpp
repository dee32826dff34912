// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "c_interface/guarded.hpp"
#include "c_interface/handles.hpp"

namespace crossgrain {
namespace {

Vector3 vector_of(const double* numbers, const char* name) {
  return rows_of<Vector3>(numbers, 1, name).front();
}

}  // namespace
}  // namespace crossgrain

using namespace crossgrain;

crossgrain_status crossgrain_constraints_new(crossgrain_constraints** out, crossgrain_error** error) {
  return made(out, error, [&] { return new crossgrain_constraints{}; });
}

crossgrain_status crossgrain_constraints_read(const char* path, crossgrain_constraints** out,
                                              crossgrain_error** error) {
  return made(out, error, [&] { return new crossgrain_constraints{read_constraints(&given(path, "path"))}; });
}

void crossgrain_constraints_free(crossgrain_constraints* constraints) {
  delete constraints;
}

crossgrain_status crossgrain_constraints_add_point(crossgrain_constraints* constraints, const double at[3],
                                                   const double* axes, size_t axis_count, double weight,
                                                   crossgrain_error** error) {
  return guarded(error, [&] {
    given(constraints, "constraints")
        .constraints.points.push_back(
            {vector_of(at, "at"), rows_of<Vector3>(axes, axis_count, "axes"), weight});
  });
}

crossgrain_status crossgrain_constraints_add_polyline(crossgrain_constraints* constraints,
                                                      const double* points, size_t point_count,
                                                      const double* axes, size_t axis_count, double weight,
                                                      crossgrain_error** error) {
  return guarded(error, [&] {
    given(constraints, "constraints")
        .constraints.polylines.push_back({rows_of<Vector3>(points, point_count, "points"),
                                          rows_of<Vector3>(axes, axis_count, "axes"), weight});
  });
}

crossgrain_status crossgrain_constraints_add_face(crossgrain_constraints* constraints, int32_t face,
                                                  const double* axes, size_t axis_count, double weight,
                                                  crossgrain_error** error) {
  return guarded(error, [&] {
    given(constraints, "constraints")
        .constraints.faces.push_back({face, rows_of<Vector3>(axes, axis_count, "axes"), weight});
  });
}

crossgrain_status crossgrain_constraints_add_stress(crossgrain_constraints* constraints, const double at[3],
                                                    const double tensor[6], double weight,
                                                    crossgrain_error** error) {
  return guarded(error, [&] {
    Constraints::Stress stress{vector_of(at, "at"), {}, weight};
    const auto all = elements(tensor, 1, 6, "tensor");
    std::copy(all.begin(), all.end(), stress.tensor.begin());
    given(constraints, "constraints").constraints.stresses.push_back(stress);
  });
}

crossgrain_status crossgrain_constraints_check(const crossgrain_constraints* constraints,
                                               crossgrain_error** error) {
  return guarded(error, [&] { check_constraints(given(constraints, "constraints").constraints); });
}
