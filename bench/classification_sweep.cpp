// SPDX-License-Identifier: Apache-2.0
// The sweep that chose ClassificationTolerances: cells of known shape in random rotations, classified for a
// grid of the two tolerances. Prints the percentage of cells in the wrong class, and for the defaults also
// that of each shape.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "constraint/classification.hpp"
#include "constraint/normal_form.hpp"

namespace crossgrain {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kCellsPerShape = 400;

using Random = std::mt19937;
using Form = QuadraticForm<3>;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Vector3 on_sphere(double polar_rad, double azimuth_rad) {
  return {std::sin(polar_rad) * std::cos(azimuth_rad), std::sin(polar_rad) * std::sin(azimuth_rad),
          std::cos(polar_rad)};
}

// A cell whose normals are all rotated by one random rotation.
class Cell {
 public:
  explicit Cell(Random& random) {
    std::normal_distribution<double> normal;
    rotation_ = normalised(Quaternion{normal(random), normal(random), normal(random), normal(random)});
  }
  void add(const Vector3& normal, double weight) { add_normal(form_, rotate(rotation_, normal), weight); }

  // A strip of a cylinder about y that spans `half_rad` to both sides of z.
  void add_strip(double half_rad, double weight) {
    constexpr int kPieces = 40;
    for (int i = 0; i < kPieces; ++i) {
      const double angle = half_rad * (2 * (i + 0.5) / kPieces - 1);
      add({std::sin(angle), 0, std::cos(angle)}, weight / kPieces);
    }
  }

  // A cap of a sphere within `half_rad` of z.
  void add_cap(double half_rad, double weight) {
    constexpr int kRings = 12, kPieces = 12;
    for (int i = 0; i < kRings; ++i) {
      const double cosine = 1 - (1 - std::cos(half_rad)) * (i + 0.5) / kRings;
      for (int j = 0; j < kPieces; ++j) {
        add(on_sphere(std::acos(cosine), 2 * std::numbers::pi * j / kPieces), weight / (kRings * kPieces));
      }
    }
  }

  // The sides of a cone or pyramid about z.
  void add_cone(int sides, double tilt_rad, double weight) {
    for (int i = 0; i < sides; ++i)
      add(on_sphere(tilt_rad, 2 * std::numbers::pi * i / sides), weight / sides);
  }

  const Form& form() const { return form_; }

 private:
  Quaternion rotation_;
  Form form_;
};

struct Shape {
  std::string name;
  std::vector<ConstraintClass> right;
  std::function<void(Cell&, Random&)> fill;
};

using C = ConstraintClass;

// Cells whose surface one frame fits.
std::vector<Shape> fitting_shapes() {
  return {
      {"plane",
       {C::kPlane},
       [](Cell& cell, Random&) {
         cell.add({0, 0, 1}, 1);
       }},
      {"cylinder strip, half angle up to 20",
       {C::kPlane},
       [](Cell& cell, Random& random) { cell.add_strip(uniform(random, 0, 20) * kDegree, 1); }},
      {"sphere cap, half angle up to 16",
       {C::kPlane},
       [](Cell& cell, Random& random) { cell.add_cap(uniform(random, 0, 16) * kDegree, 1); }},
      {"crease of up to 20 degrees",
       {C::kPlane},
       [](Cell& cell, Random& random) {
         cell.add({0, 0, 1}, 1);
         cell.add(on_sphere(uniform(random, 0, 20) * kDegree, 0), uniform(random, 0.1, 1));
       }},
      {"plane with a speck, 5 % of the area",
       {C::kPlane},
       [](Cell& cell, Random& random) {
         cell.add({0, 0, 1}, 0.95);
         cell.add(on_sphere(uniform(random, 0, 90) * kDegree, 0), 0.05);
       }},
      {"edge of 80 to 90 degrees",
       {C::kFrame},
       [](Cell& cell, Random& random) {
         cell.add({0, 0, 1}, 1);
         cell.add(on_sphere(uniform(random, 80, 90) * kDegree, 0), uniform(random, 0.15, 1));
       }},
      {"corner of three orthogonal planes",
       {C::kFrame},
       [](Cell& cell, Random& random) {
         for (const Vector3& n : {Vector3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
           cell.add(n, uniform(random, 0.2, 1));
       }},
  };
}

// Cells whose surface no frame fits.
std::vector<Shape> other_shapes() {
  const std::vector<C> not_one_frame{C::kAxis, C::kFrameCompromised, C::kConflicted};
  return {
      {"edge of 40 to 60 degrees", not_one_frame,
       [](Cell& cell, Random& random) {
         cell.add({0, 0, 1}, 1);
         cell.add(on_sphere(uniform(random, 40, 60) * kDegree, 0), uniform(random, 0.5, 1));
       }},
      {"whole cylinder", {C::kAxis}, [](Cell& cell, Random&) { cell.add_cone(24, std::numbers::pi / 2, 1); }},
      {"rod with its end",
       {C::kAxis},
       [](Cell& cell, Random& random) {
         cell.add_cone(24, std::numbers::pi / 2, 1);
         cell.add({0, 0, 1}, uniform(random, 0, 1.5));
       }},
      {"half a cylinder", {C::kAxis}, [](Cell& cell, Random&) { cell.add_strip(90 * kDegree, 1); }},
      {"cylinder strip, half angle 40 to 180", not_one_frame,
       [](Cell& cell, Random& random) { cell.add_strip(uniform(random, 40, 180) * kDegree, 1); }},
      {"prism with 5 to 9 sides",
       {C::kAxis},
       [](Cell& cell, Random& random) {
         cell.add_cone(std::uniform_int_distribution<int>(5, 9)(random), std::numbers::pi / 2, 1);
       }},
      {"pyramid with 5 to 9 sides and base", not_one_frame,
       [](Cell& cell, Random& random) {
         cell.add_cone(std::uniform_int_distribution<int>(5, 9)(random), uniform(random, 40, 70) * kDegree,
                       1);
         cell.add({0, 0, -1}, uniform(random, 0.5, 1));
       }},
      {"half a sphere or all of it",
       {C::kFree},
       [](Cell& cell, Random& random) { cell.add_cap((random() % 2 == 0 ? 90 : 180) * kDegree, 1); }},
  };
}

double percent_wrong(const Shape& shape, const std::vector<Form>& cells,
                     const ClassificationTolerances& tolerances) {
  int wrong = 0;
  for (const Form& form : cells) {
    const ConstraintClass found = classify(form, tolerances);
    wrong += std::find(shape.right.begin(), shape.right.end(), found) == shape.right.end();
  }
  return 100.0 * wrong / static_cast<double>(cells.size());
}

void run() {
  std::vector<Shape> all = fitting_shapes();
  for (const Shape& shape : other_shapes()) all.push_back(shape);
  std::vector<std::vector<Form>> cells(all.size());
  Random random(1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (int k = 0; k < kCellsPerShape; ++k) {
      Cell cell(random);
      all[i].fill(cell, random);
      cells[i].push_back(cell.form());
    }
  }
  const std::vector<double> fits_values{0.03, 0.05, 0.1, 0.14, 0.15, 0.16, 0.18, 0.2, 0.25, 0.3};
  std::printf("percent in the wrong class; rows: same_eigenvalue, columns: fits\n       ");
  for (const double fits : fits_values) std::printf("%7.2f", fits);
  for (const double same : {0.01, 0.02, 0.05, 0.08, 0.1, 0.11, 0.12, 0.15, 0.2}) {
    std::printf("\n%7.2f", same);
    for (const double fits : fits_values) {
      double sum = 0;
      for (std::size_t i = 0; i < all.size(); ++i) sum += percent_wrong(all[i], cells[i], {same, fits});
      std::printf("%7.2f", sum / static_cast<double>(all.size()));
    }
  }
  const ClassificationTolerances defaults;
  std::printf("\n\nwith the defaults, same_eigenvalue %g, fits %g\n", defaults.same_eigenvalue,
              defaults.fits);
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::printf("%7.2f  %s\n", percent_wrong(all[i], cells[i], defaults), all[i].name.c_str());
  }
}

}  // namespace
}  // namespace crossgrain

int main() {
  crossgrain::run();
}
