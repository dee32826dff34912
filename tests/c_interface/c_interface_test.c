/* SPDX-License-Identifier: Apache-2.0 */
/* The C interface as a program in C sees it. Each TEST is one of ctest: `c_interface_tests NAME` runs it. */
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "crossgrain/c.h"

static void fail(const char* what, const char* file, int line, const crossgrain_error* error) {
  fprintf(stderr, "%s:%d: %s%s%s\n", file, line, what, error ? ": " : "", error ? error->sentence : "");
  exit(1);
}
#define CHECK(condition) ((condition) ? (void)0 : fail("not true: " #condition, __FILE__, __LINE__, NULL))

static crossgrain_error* g_error;
#define OK(call) ((call) == CROSSGRAIN_OK ? (void)0 : fail(#call, __FILE__, __LINE__, g_error))

/* The call fails with a status and an error that has all its parts, one of them with a text in it. */
static void expect(crossgrain_status status, crossgrain_status wanted, const char* part, const char* file,
                   int line) {
  if (status != wanted || g_error == NULL) fail("another status", file, line, g_error);
  if (g_error->status != wanted || !g_error->file || !g_error->place || !g_error->text || !g_error->remedy ||
      !g_error->remedy_name)
    fail("parts are missing", file, line, g_error);
  if (strstr(g_error->sentence, part) == NULL) fail(part, file, line, g_error);
  crossgrain_error_free(g_error);
  g_error = NULL;
}
#define FAILS(wanted, part, call) expect((call), (wanted), (part), __FILE__, __LINE__)

/* -- Models ------------------------------------------------------------------------------------------------
 */

static crossgrain_mesh* box(double x, double y, double z) {
  double vertices[24];
  for (int v = 0; v < 8; ++v) {
    vertices[3 * v] = (v & 1) ? x : 0;
    vertices[3 * v + 1] = (v & 2) ? y : 0;
    vertices[3 * v + 2] = (v & 4) ? z : 0;
  }
  const uint32_t triangles[] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  crossgrain_mesh* mesh = NULL;
  OK(crossgrain_mesh_new(vertices, 8, triangles, 12, &mesh, &g_error));
  return mesh;
}

/* A ball: a cube of n squares a side, its surface moved to the unit sphere. */
static crossgrain_mesh* ball(int n) {
  const int row = n + 1;
  double* vertices = malloc(sizeof(double) * 3 * 6 * row * row);
  uint32_t* triangles = malloc(sizeof(uint32_t) * 3 * 6 * 2 * n * n);
  size_t v = 0, t = 0;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2, side = face % 2;
    const uint32_t first = (uint32_t)v;
    for (int i = 0; i < row; ++i) {
      for (int j = 0; j < row; ++j, ++v) {
        double p[3];
        p[axis] = side ? 1 : -1;
        p[(axis + 1) % 3] = 2.0 * i / n - 1;
        p[(axis + 2) % 3] = 2.0 * j / n - 1;
        const double length = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        for (int k = 0; k < 3; ++k) vertices[3 * v + k] = p[k] / length;
      }
    }
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const uint32_t a = first + (uint32_t)(i * row + j), b = a + (uint32_t)row;
        const uint32_t corners[2][6] = {{a, a + 1, b, b, a + 1, b + 1}, {a, b, a + 1, b, b + 1, a + 1}};
        for (int k = 0; k < 6; ++k) triangles[t++] = corners[side][k];
      }
    }
  }
  crossgrain_mesh* mesh = NULL;
  OK(crossgrain_mesh_new(vertices, v, triangles, t / 3, &mesh, &g_error));
  free(vertices);
  free(triangles);
  return mesh;
}

/* The cube from -1 to 1 moved onto the unit ball: a point keeps its direction and the share of its way out.
 */
static void make_round(double* point) {
  double largest = 0, length = 0;
  for (int k = 0; k < 3; ++k) {
    largest = fmax(largest, fabs(point[k]));
    length += point[k] * point[k];
  }
  for (int k = 0; k < 3 && length > 0; ++k) point[k] *= largest / sqrt(length);
}

/* The unit cube as n^3 cubes of six tets, or the unit ball. */
static crossgrain_domain* of_tets(int n, int is_round) {
  const int row = n + 1;
  double* vertices = malloc(sizeof(double) * 3 * row * row * row);
  uint32_t* tets = malloc(sizeof(uint32_t) * 4 * 6 * n * n * n);
  for (int i = 0; i < row * row * row; ++i) {
    vertices[3 * i] = (double)(i % row) / n;
    vertices[3 * i + 1] = (double)(i / row % row) / n;
    vertices[3 * i + 2] = (double)(i / row / row) / n;
    for (int k = 0; k < 3 && is_round; ++k) vertices[3 * i + k] = 2 * vertices[3 * i + k] - 1;
    if (is_round) make_round(vertices + 3 * i);
  }
  /* Paths from corner 0 to corner 7 along the axes. */
  const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  const int steps[3] = {1, row, row * row};
  size_t t = 0;
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        for (int path = 0; path < 6; ++path) {
          int at = x + row * (y + row * z);
          tets[t++] = (uint32_t)at;
          for (int k = 0; k < 3; ++k) tets[t++] = (uint32_t)(at += steps[orders[path][k]]);
        }
  crossgrain_tets* mesh = NULL;
  crossgrain_domain* domain = NULL;
  OK(crossgrain_tets_new(vertices, (size_t)(row * row * row), tets, t / 4, NULL, &mesh, &g_error));
  OK(crossgrain_domain_new(mesh, NULL, NULL, &domain, &g_error));
  crossgrain_tets_free(mesh);
  free(vertices);
  free(tets);
  return domain;
}

static crossgrain_domain* cube_of_tets(int n) {
  return of_tets(n, 0);
}

static crossgrain_options* of_resolution(int resolution) {
  crossgrain_options* options = NULL;
  OK(crossgrain_options_new(CROSSGRAIN_SOLVE_OPTIONS, &options, &g_error));
  OK(crossgrain_options_set_integer(options, "resolution", resolution, &g_error));
  return options;
}

static crossgrain_field* solved(crossgrain_mesh* mesh, int resolution) {
  crossgrain_options* options = of_resolution(resolution);
  crossgrain_field* field = NULL;
  OK(crossgrain_solve(mesh, NULL, options, NULL, &field, &g_error));
  crossgrain_options_free(options);
  crossgrain_mesh_free(mesh);
  return field;
}

/* The largest entry of a unit axis; 1 for a coordinate axis. */
static double alignment(const double* axis) {
  return fmax(fabs(axis[0]), fmax(fabs(axis[1]), fabs(axis[2])));
}

static int exists(const char* path) {
  struct stat its_stat;
  return stat(path, &its_stat) == 0;
}

/* -- Tests -------------------------------------------------------------------------------------------------
 */

#define TEST(name) static void name(void)

TEST(TheHeaderIsThatOfTheLibrary) {
  CHECK(crossgrain_c_version() == CROSSGRAIN_C_VERSION);
  char version[64];
  snprintf(version, sizeof version, "%d.%d.%d", CROSSGRAIN_VERSION_MAJOR, CROSSGRAIN_VERSION_MINOR,
           CROSSGRAIN_VERSION_PATCH);
  CHECK(strcmp(crossgrain_version(), version) == 0);
}

TEST(FramesInABoxFollowIt) {
  crossgrain_field* field = solved(box(2, 1, 1.5), 16);
  const size_t n = crossgrain_field_size(field);
  CHECK(n > 1000);
  CHECK(crossgrain_field_degree(field) == 4);
  double* frames = malloc(sizeof(double) * 9 * n);
  double* centers = malloc(sizeof(double) * 3 * n);
  double* sizes = malloc(sizeof(double) * n);
  int32_t* levels = malloc(sizeof(int32_t) * n);
  OK(crossgrain_field_frames(field, frames, &g_error));
  OK(crossgrain_field_centers(field, centers, &g_error));
  OK(crossgrain_field_sizes(field, sizes, &g_error));
  OK(crossgrain_field_levels(field, levels, &g_error));
  const float* quaternions = crossgrain_field_quaternions(field);
  for (size_t i = 0; i < n; ++i) {
    CHECK(alignment(frames + 9 * i) > 0.9999 && alignment(frames + 9 * i + 6) > 0.9999);
    CHECK(centers[3 * i] > -0.2 && centers[3 * i] < 2.2 && centers[3 * i + 1] < 1.2);
    CHECK(sizes[i] > 0 && levels[i] > 0);
    const float* q = quaternions + 4 * i;
    CHECK(fabs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1) < 1e-5);
  }
  CHECK(crossgrain_field_energy_density(field) != NULL && crossgrain_field_on_boundary(field) != NULL);
  CHECK(crossgrain_field_constraint_classes(field)[0] <= CROSSGRAIN_CONFLICTED);
  CHECK(crossgrain_field_regions(field) == NULL);
  free(frames);
  free(centers);
  free(sizes);
  free(levels);
  crossgrain_field_free(field);
}

TEST(SamplesSayWhatIsOutside) {
  crossgrain_field* field = solved(box(2, 1, 1.5), 16);
  const double points[] = {1, 0.5, 0.75, 9, 9, 9};
  double frames[18], deviation[2], distance[2];
  uint8_t inside[2];
  OK(crossgrain_field_sample(field, points, 2, 1, frames, inside, deviation, distance, NULL, &g_error));
  CHECK(inside[0] == 1 && inside[1] == 0);
  CHECK(alignment(frames) > 0.9999 && deviation[0] < 1e-6 && distance[0] > 0);
  double again[18];
  OK(crossgrain_field_sample(field, points, 2, 0, again, NULL, NULL, NULL, NULL, &g_error));
  CHECK(memcmp(frames, again, sizeof frames) == 0);
  OK(crossgrain_field_sample(field, NULL, 0, 0, NULL, NULL, NULL, NULL, NULL, &g_error));
  const double bad[] = {0, 0, 0, 1, NAN, 0};
  FAILS(CROSSGRAIN_USAGE, "point 1",
        crossgrain_field_sample(field, bad, 2, 0, again, NULL, NULL, NULL, NULL, &g_error));
  crossgrain_field_free(field);
}

TEST(CoefficientsOfAFrameDoNotDependOnItsNames) {
  const double frames[] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1, 0};
  double four[18], three[14];
  OK(crossgrain_coefficients_of_frames(frames, 2, 4, four, &g_error));
  OK(crossgrain_coefficients_of_frames(frames, 2, 3, three, &g_error));
  CHECK(fabs(four[4] - sqrt(7.0 / 12)) < 1e-12 && fabs(four[8] - sqrt(5.0 / 12)) < 1e-12);
  CHECK(fabs(fabs(three[1]) - 1) < 1e-12);
  for (int m = 0; m < 9; ++m) CHECK(fabs(four[m] - four[9 + m]) < 1e-12);
  FAILS(CROSSGRAIN_USAGE, "3 or 4", crossgrain_coefficients_of_frames(frames, 2, 5, four, &g_error));
}

TEST(ErrorsTellWhatIsWrongAndWhere) {
  crossgrain_mesh* mesh = NULL;
  crossgrain_field* field = NULL;
  FAILS(CROSSGRAIN_INPUT, "missing.stl", crossgrain_mesh_read("missing.stl", NULL, NULL, &mesh, &g_error));
  CHECK(mesh == NULL);
  const double vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const uint32_t triangles[] = {0, 1, 7};
  OK(crossgrain_mesh_new(vertices, 3, triangles, 1, &mesh, &g_error));
  FAILS(CROSSGRAIN_INPUT, "7", crossgrain_solve(mesh, NULL, NULL, NULL, &field, &g_error));
  CHECK(field == NULL);
  CHECK(crossgrain_solve(mesh, NULL, NULL, NULL, &field, NULL) == CROSSGRAIN_INPUT);
  FAILS(CROSSGRAIN_USAGE, "mesh", crossgrain_solve(NULL, NULL, NULL, NULL, &field, &g_error));
  FAILS(CROSSGRAIN_USAGE, "vertices", crossgrain_mesh_new(NULL, 3, triangles, 1, &mesh, &g_error));
  FAILS(CROSSGRAIN_USAGE, "out", crossgrain_mesh_new(vertices, 3, triangles, 1, NULL, &g_error));
  crossgrain_mesh_free(mesh);
  crossgrain_mesh_free(NULL);
  crossgrain_error_free(NULL);
}

TEST(EveryOptionKeepsWhatItHas) {
  size_t all = 0;
  for (int k = CROSSGRAIN_SOLVE_OPTIONS; k <= CROSSGRAIN_HEX_FIT_OPTIONS; ++k) {
    const crossgrain_options_kind kind = (crossgrain_options_kind)k;
    crossgrain_options* options = NULL;
    OK(crossgrain_options_new(kind, &options, &g_error));
    const size_t count = crossgrain_options_count(kind);
    CHECK(count > 0 && crossgrain_options_name(kind, count) == NULL);
    all += count;
    for (size_t i = 0; i < count; ++i) {
      const char* name = crossgrain_options_name(kind, i);
      const crossgrain_option_type type = crossgrain_options_type(kind, i);
      if (type == CROSSGRAIN_TEXT) {
        char *text = NULL, *again = NULL;
        OK(crossgrain_options_get_text(options, name, &text, &g_error));
        OK(crossgrain_options_set_text(options, name, text, &g_error));
        OK(crossgrain_options_get_text(options, name, &again, &g_error));
        CHECK(strcmp(text, again) == 0);
        crossgrain_text_free(text);
        crossgrain_text_free(again);
        FAILS(CROSSGRAIN_USAGE, name, crossgrain_options_set_number(options, name, 1, &g_error));
        continue;
      }
      crossgrain_numbers *numbers = NULL, *again = NULL;
      OK(crossgrain_options_get_numbers(options, name, &numbers, &g_error));
      const size_t rows = crossgrain_numbers_rows(numbers);
      const double* values = crossgrain_numbers_data(numbers);
      if (type == CROSSGRAIN_NUMBERS)
        OK(crossgrain_options_set_numbers(options, name, values, rows, &g_error));
      else if (type == CROSSGRAIN_NUMBER)
        OK(crossgrain_options_set_number(options, name, values[0], &g_error));
      else
        OK(crossgrain_options_set_integer(options, name, (int64_t)values[0], &g_error));
      OK(crossgrain_options_get_numbers(options, name, &again, &g_error));
      CHECK(crossgrain_numbers_rows(again) == rows);
      for (size_t r = 0; r < rows; ++r) CHECK(crossgrain_numbers_data(again)[r] == values[r]);
      crossgrain_numbers_free(numbers);
      crossgrain_numbers_free(again);
      FAILS(CROSSGRAIN_USAGE, name, crossgrain_options_set_text(options, name, "x", &g_error));
    }
    crossgrain_options_free(options);
  }
  CHECK(all > 50);
}

TEST(OptionsRefuseWhatTheyCannotHold) {
  crossgrain_options *options = of_resolution(16), *others = NULL;
  FAILS(CROSSGRAIN_USAGE, "similar one is resolution",
        crossgrain_options_set_integer(options, "resolutoin", 1, &g_error));
  FAILS(CROSSGRAIN_USAGE, "use boundary",
        crossgrain_options_set_text(options, "onto.boundary", "all", &g_error));
  FAILS(CROSSGRAIN_USAGE, "integer", crossgrain_options_set_number(options, "resolution", 1.5, &g_error));
  FAILS(CROSSGRAIN_USAGE, "not negative",
        crossgrain_options_set_integer(options, "max_memory_bytes", -1, &g_error));
  FAILS(CROSSGRAIN_USAGE, "smooth-only", crossgrain_options_set_text(options, "boundary", "some", &g_error));
  FAILS(CROSSGRAIN_USAGE, "0 or 1", crossgrain_options_set_integer(options, "unite_solids", 2, &g_error));
  FAILS(CROSSGRAIN_USAGE, "3 or 4", crossgrain_options_set_integer(options, "degree", 5, &g_error));
  FAILS(CROSSGRAIN_USAGE, "no options of kind",
        crossgrain_options_new((crossgrain_options_kind)99, &others, &g_error));
  OK(crossgrain_options_set_text(options, "seed", "18446744073709551615", &g_error));
  FAILS(CROSSGRAIN_USAGE, "seed",
        crossgrain_options_set_text(options, "seed", "18446744073709551616", &g_error));
  crossgrain_mesh* mesh = NULL;
  FAILS(CROSSGRAIN_USAGE, "another kind", crossgrain_mesh_read("a.stl", options, NULL, &mesh, &g_error));
  crossgrain_options_free(options);
}

static int count_calls(const crossgrain_progress* progress, void* state) {
  CHECK(progress->phase <= CROSSGRAIN_WRITING && progress->level >= 0);
  ++*(int*)state;
  return 0;
}

static int cancel_at_third(const crossgrain_progress* progress, void* state) {
  (void)progress;
  return ++*(int*)state >= 3;
}

TEST(AListenerHearsAndCancels) {
  crossgrain_mesh* mesh = box(2, 1, 1.5);
  crossgrain_options* options = of_resolution(24);
  crossgrain_monitor* monitor = NULL;
  crossgrain_field* field = NULL;
  int calls = 0;
  OK(crossgrain_monitor_new(count_calls, NULL, &calls, &monitor, &g_error));
  OK(crossgrain_solve(mesh, NULL, options, monitor, &field, &g_error));
  CHECK(calls > 3);
  crossgrain_field_free(field);
  field = NULL;
  crossgrain_monitor_cancel(monitor);
  FAILS(CROSSGRAIN_INTERRUPTED, "", crossgrain_solve(mesh, NULL, options, monitor, &field, &g_error));
  crossgrain_monitor_free(monitor);
  calls = 0;
  OK(crossgrain_monitor_new(cancel_at_third, NULL, &calls, &monitor, &g_error));
  FAILS(CROSSGRAIN_INTERRUPTED, "", crossgrain_solve(mesh, NULL, options, monitor, &field, &g_error));
  CHECK(field == NULL);
  crossgrain_monitor_free(monitor);
  crossgrain_options_free(options);
  crossgrain_mesh_free(mesh);
}

TEST(TetsOfAnOpenSurfaceAreRefused) {
  const double vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const uint32_t triangles[] = {0, 2, 1, 0, 1, 3, 0, 3, 2};
  crossgrain_mesh* mesh = NULL;
  OK(crossgrain_mesh_new(vertices, 4, triangles, 3, &mesh, &g_error));
  crossgrain_options* options = NULL;
  OK(crossgrain_options_new(CROSSGRAIN_TET_MAKING_OPTIONS, &options, &g_error));
  OK(crossgrain_options_set_number(options, "size", 0.5, &g_error));
  OK(crossgrain_options_set_text(options, "maker", "gmsh", &g_error));
  crossgrain_tets* tets = NULL;
  FAILS(CROSSGRAIN_INPUT, "the surface encloses nothing",
        crossgrain_tets_make_inside(mesh, options, NULL, &tets, &g_error));
  CHECK(tets == NULL);
  FAILS(CROSSGRAIN_INPUT, "no such file",
        crossgrain_tets_make("nowhere.stl", options, NULL, &tets, &g_error));
  crossgrain_options_free(options);
  crossgrain_mesh_free(mesh);
}

TEST(TaggedFacesAndEdgesAreGivenBackAndWritten) {
  const double vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const uint32_t tet[] = {0, 1, 2, 3}, face[] = {0, 2, 1}, edge[] = {1, 2};
  const int32_t tag = 7;
  crossgrain_tets* tets = NULL;
  OK(crossgrain_tets_new(vertices, 4, tet, 1, NULL, &tets, &g_error));
  OK(crossgrain_tets_add_feature_faces(tets, face, &tag, 1, &g_error));
  OK(crossgrain_tets_add_feature_edges(tets, edge, &tag, 1, 1, &g_error));
  crossgrain_domain* domain = NULL;
  OK(crossgrain_domain_new(tets, NULL, NULL, &domain, &g_error));
  CHECK(crossgrain_domain_face_count(domain) == 1 && crossgrain_domain_edge_count(domain) == 1);
  uint32_t got[3];
  int32_t its_tag = 0;
  uint8_t is_stated = 0;
  crossgrain_domain_faces(domain, got, &its_tag);
  CHECK(got[0] == 0 && got[1] == 2 && got[2] == 1 && its_tag == 7);
  crossgrain_domain_edges(domain, got, &its_tag, &is_stated);
  CHECK(got[0] == 1 && got[1] == 2 && its_tag == 7 && is_stated == 1);
  FAILS(CROSSGRAIN_USAGE, ".mesh or .msh", crossgrain_domain_write(domain, "a.vtk", NULL, &g_error));
  crossgrain_domain_free(domain);
  crossgrain_tets_free(tets);
}

TEST(MatchingsCarryFramesAcrossFacesOfTets) {
  crossgrain_domain* domain = cube_of_tets(4);
  CHECK(crossgrain_domain_tet_count(domain) == 384 && crossgrain_domain_vertex_count(domain) == 125);
  CHECK(crossgrain_domain_typical_edge_length(domain) > 0 && crossgrain_domain_regions(domain) == NULL);
  crossgrain_options* options = NULL;
  OK(crossgrain_options_new(CROSSGRAIN_SOLVE_OPTIONS, &options, &g_error));
  crossgrain_tet_field* field = NULL;
  OK(crossgrain_options_size_for(options, domain, &g_error));
  OK(crossgrain_solve_onto(domain, options, NULL, &field, &g_error));
  double* frames = malloc(sizeof(double) * 9 * 384);
  OK(crossgrain_tet_field_frames(field, frames, &g_error));
  crossgrain_matchings* matchings = NULL;
  OK(crossgrain_tet_field_matchings(field, NULL, &matchings, &g_error));
  /* Each tet has four faces, twelve of every 24 cube's on the surface: 6 sides of 2 n^2 triangles. */
  CHECK(crossgrain_matchings_count(matchings) == (4 * 384 - 6 * 2 * 16) / 2);
  const uint32_t* tets = crossgrain_matchings_tets(matchings);
  const int8_t* axes = crossgrain_matchings_axes(matchings);
  CHECK(crossgrain_matchings_faces(matchings)[0] < crossgrain_matchings_faces(matchings)[1]);
  for (size_t f = 0; f < crossgrain_matchings_count(matchings); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int to = axes[3 * f + k];
      const double* a = frames + 9 * tets[2 * f] + 3 * k;
      const double* b = frames + 9 * tets[2 * f + 1] + 3 * (abs(to) - 1);
      CHECK((a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * (to > 0 ? 1 : -1) > 0.99);
    }
  }
  CHECK(crossgrain_tet_field_quaternions(field) != NULL &&
        crossgrain_tet_field_vertex_quaternions(field) != NULL);
  double vertex_frames[9 * 125];
  OK(crossgrain_tet_field_vertex_frames(field, vertex_frames, &g_error));
  crossgrain_field* grid = NULL;
  OK(crossgrain_tet_field_grid(field, &grid, &g_error));
  crossgrain_tet_field_free(field);
  CHECK(crossgrain_field_size(grid) > 0);
  OK(crossgrain_carry_onto(grid, domain, options, NULL, &field, &g_error));
  crossgrain_field_free(grid);
  free(frames);
  crossgrain_matchings_free(matchings);
  crossgrain_tet_field_free(field);
  crossgrain_options_free(options);
  crossgrain_mesh* boundary = NULL;
  OK(crossgrain_domain_boundary(domain, &boundary, &g_error));
  CHECK(crossgrain_mesh_triangle_count(boundary) == 192);
  crossgrain_mesh_free(boundary);
  crossgrain_domain_free(domain);
}

TEST(TetsArePreparedForAMap) {
  crossgrain_domain* domain = cube_of_tets(2);
  CHECK(crossgrain_domain_parents(domain) == NULL);
  crossgrain_domain* prepared = NULL;
  OK(crossgrain_domain_prepared_for_map(domain, NULL, &prepared, &g_error));
  CHECK(crossgrain_domain_tet_count(prepared) > crossgrain_domain_tet_count(domain));
  const uint32_t* parents = crossgrain_domain_parents(prepared);
  CHECK(parents != NULL);
  for (size_t t = 0; t < crossgrain_domain_tet_count(prepared); ++t)
    CHECK(parents[t] < crossgrain_domain_tet_count(domain));
  crossgrain_domain_free(prepared);
  crossgrain_domain_free(domain);
}

/* The field of a ball of tets that are prepared for a map. */
static crossgrain_tet_field* prepared_ball(void) {
  crossgrain_domain *domain = of_tets(3, 1), *prepared = NULL;
  OK(crossgrain_domain_prepared_for_map(domain, NULL, &prepared, &g_error));
  crossgrain_tet_field* field = NULL;
  OK(crossgrain_solve_onto(prepared, NULL, NULL, &field, &g_error));
  crossgrain_domain_free(prepared);
  crossgrain_domain_free(domain);
  return field;
}

static int same_matchings(const crossgrain_tet_field* a, const crossgrain_tet_field* b) {
  crossgrain_matchings *of_a = NULL, *of_b = NULL;
  OK(crossgrain_tet_field_matchings(a, NULL, &of_a, &g_error));
  OK(crossgrain_tet_field_matchings(b, NULL, &of_b, &g_error));
  const size_t count = crossgrain_matchings_count(of_a);
  CHECK(count > 0 && crossgrain_matchings_count(of_b) == count);
  const int same = memcmp(crossgrain_matchings_axes(of_a), crossgrain_matchings_axes(of_b), 3 * count) == 0 &&
                   memcmp(crossgrain_matchings_tets(of_a), crossgrain_matchings_tets(of_b), 8 * count) == 0;
  crossgrain_matchings_free(of_a);
  crossgrain_matchings_free(of_b);
  return same;
}

TEST(ARepairedFieldIsReadAsItWasWritten) {
  crossgrain_tet_field *field = prepared_ball(), *repaired = NULL, *again = NULL;
  OK(crossgrain_tet_field_repaired(field, NULL, 0, NULL, &repaired, &g_error));
  CHECK(!same_matchings(field, repaired));
  char *before = NULL, *after = NULL;
  OK(crossgrain_tet_field_report(field, &before, &g_error));
  OK(crossgrain_tet_field_report(repaired, &after, &g_error));
  CHECK(strstr(before, "\"repair\"") == NULL && strstr(after, "\"repair\"") != NULL);
  crossgrain_text_free(before);
  crossgrain_text_free(after);
  OK(crossgrain_tet_field_write(repaired, "repaired.frames", NULL, NULL, 0, NULL, NULL, &g_error));
  OK(crossgrain_tet_field_read("repaired.frames", 0, NULL, &again, &g_error));
  CHECK(same_matchings(repaired, again));
  crossgrain_domain* domain = NULL;
  OK(crossgrain_tet_field_domain(again, &domain, &g_error));
  CHECK(memcmp(crossgrain_tet_field_quaternions(repaired), crossgrain_tet_field_quaternions(again),
               32 * crossgrain_domain_tet_count(domain)) == 0);
  crossgrain_domain_free(domain);
  crossgrain_tet_field_free(field);
  crossgrain_tet_field_free(repaired);
  crossgrain_tet_field_free(again);
}

TEST(ARepairTakesItsOptionAndCanBeCancelled) {
  crossgrain_tet_field *field = prepared_ball(), *repaired = NULL;
  crossgrain_options* options = NULL;
  OK(crossgrain_options_new(CROSSGRAIN_REPAIR_OPTIONS, &options, &g_error));
  OK(crossgrain_options_set_integer(options, "moves_vertices", 0, &g_error));
  OK(crossgrain_tet_field_repaired(field, options, 1, NULL, &repaired, &g_error));
  crossgrain_tet_field_free(repaired);
  FAILS(CROSSGRAIN_USAGE, "tries is no option any more",
        crossgrain_options_set_integer(options, "tries", 0, &g_error));
  FAILS(CROSSGRAIN_USAGE, "threads",
        crossgrain_tet_field_repaired(field, NULL, -1, NULL, &repaired, &g_error));
  crossgrain_monitor* monitor = NULL;
  OK(crossgrain_monitor_new(NULL, NULL, NULL, &monitor, &g_error));
  crossgrain_monitor_cancel(monitor);
  FAILS(CROSSGRAIN_INTERRUPTED, "",
        crossgrain_tet_field_repaired(field, NULL, 0, monitor, &repaired, &g_error));
  crossgrain_monitor_free(monitor);
  crossgrain_options_free(options);
  crossgrain_tet_field_free(field);
}

TEST(AFieldThatIsReadIsTheOneThatWasWritten) {
  crossgrain_field* field = solved(box(2, 1, 1.5), 16);
  crossgrain_options* options = NULL;
  OK(crossgrain_options_new(CROSSGRAIN_OUTPUT_OPTIONS, &options, &g_error));
  OK(crossgrain_options_set_integer(options, "page", 1, &g_error));
  OK(crossgrain_options_set_text(options, "foreign_files", "replace", &g_error));
  char* json = NULL;
  OK(crossgrain_field_write(field, "written.frames", options, "part.stl", 0.5, NULL, &json, &g_error));
  CHECK(strstr(json, "\"part.stl\"") != NULL && strstr(json, "\"verdict\": \"meshable\"") != NULL);
  CHECK(exists("written.frames/report.html"));
  crossgrain_text_free(json);
  crossgrain_field* again = NULL;
  OK(crossgrain_field_read("written.frames", 0, NULL, &again, &g_error));
  const size_t n = crossgrain_field_size(field);
  CHECK(crossgrain_field_size(again) == n);
  CHECK(memcmp(crossgrain_field_quaternions(field), crossgrain_field_quaternions(again), 16 * n) == 0);
  crossgrain_tet_field* none = NULL;
  OK(crossgrain_tet_field_read("written.frames", 0, NULL, &none, &g_error));
  CHECK(none == NULL);
  int is_clipped = 2;
  OK(crossgrain_is_clipped_field("written.frames", &is_clipped, &g_error));
  CHECK(is_clipped == 0);
  OK(crossgrain_field_write_page(field, "page.html", NULL, &g_error));
  OK(crossgrain_field_render(field, "picture.png", NULL, NULL, NULL, NULL, &g_error));
  CHECK(exists("page.html") && exists("picture.png"));
  OK(crossgrain_field_report(field, &json, &g_error));
  CHECK(strstr(json, "\"schema\"") != NULL);
  crossgrain_text_free(json);
  FAILS(CROSSGRAIN_OUTPUT, "picture.png",
        crossgrain_field_write(field, "picture.png", options, NULL, 0, NULL, NULL, &g_error));
  crossgrain_options_free(options);
  crossgrain_field_free(field);
  crossgrain_field_free(again);
}

static int write_name(const char* report, crossgrain_sink sink, void* sink_state, void* state) {
  CHECK(strstr(report, "\"energy\"") != NULL);
  return sink(sink_state, state, strlen(state));
}

static int give_up(const char* report, crossgrain_sink sink, void* sink_state, void* state) {
  (void)report, (void)sink, (void)sink_state, (void)state;
  return 1;
}

TEST(ACompanionIsWrittenWithTheFieldOrNothingIs) {
  crossgrain_field* field = solved(box(1, 1, 1), 8);
  crossgrain_options *options = NULL, *others = NULL;
  crossgrain_reservation *reservation = NULL, *second = NULL;
  OK(crossgrain_options_new(CROSSGRAIN_OUTPUT_OPTIONS, &options, &g_error));
  OK(crossgrain_options_set_text(options, "foreign_files", "replace", &g_error));
  OK(crossgrain_options_set_companion(options, "name.txt", write_name, (void*)"mine", &g_error));
  OK(crossgrain_reserve_folder("companion.frames", options, 0, &reservation, &g_error));
  FAILS(CROSSGRAIN_OUTPUT, "companion.frames",
        crossgrain_reserve_folder("companion.frames", options, 0, &second, &g_error));
  OK(crossgrain_options_set_reservation(options, reservation, &g_error));
  crossgrain_reservation_free(reservation);
  OK(crossgrain_field_write(field, "companion.frames", options, "cube.stl", 0, NULL, NULL, &g_error));
  CHECK(exists("companion.frames/name.txt") && exists("companion.frames/field.vtu"));
  char *model = NULL, *solve = NULL, *json = NULL;
  OK(crossgrain_model_of_result("companion.frames", &model, &g_error));
  OK(crossgrain_solve_of_result("companion.frames", &solve, &g_error));
  OK(crossgrain_field_check(field, &json, &g_error));
  CHECK(strcmp(model, "cube.stl") == 0 && strlen(solve) == 16 && strstr(json, "\"verdict\"") != NULL);
  crossgrain_text_free(model);
  crossgrain_text_free(solve);
  crossgrain_text_free(json);
  crossgrain_options_free(options);
  OK(crossgrain_options_new(CROSSGRAIN_OUTPUT_OPTIONS, &others, &g_error));
  OK(crossgrain_options_set_companion(others, "name.txt", give_up, NULL, &g_error));
  FAILS(CROSSGRAIN_OUTPUT, "name.txt",
        crossgrain_field_write(field, "given_up.frames", others, NULL, 0, NULL, NULL, &g_error));
  CHECK(!exists("given_up.frames"));
  crossgrain_options_free(others);
  crossgrain_field_free(field);
}

TEST(SamplesAreWrittenForPointsThatAreRead) {
  crossgrain_field* field = solved(box(1, 1, 1), 8);
  FILE* file = fopen("points.txt", "w");
  fputs("0.5 0.5 0.5\n9 9 9 # outside\n", file);
  fclose(file);
  crossgrain_numbers *points = NULL, *normals = NULL;
  size_t outside = 0;
  OK(crossgrain_points_read("points.txt", &points, &g_error));
  CHECK(crossgrain_numbers_rows(points) == 2 && crossgrain_numbers_columns(points) == 3);
  OK(crossgrain_field_write_samples(field, crossgrain_numbers_data(points), 2, "frames.txt", NULL, NULL,
                                    &outside, &g_error));
  CHECK(outside == 1 && exists("frames.txt"));
  OK(crossgrain_normals_read("points.txt", &normals, &g_error));
  CHECK(crossgrain_numbers_columns(normals) == 4 && crossgrain_numbers_data(normals)[3] == 1);
  FAILS(CROSSGRAIN_INPUT, "missing.txt", crossgrain_points_read("missing.txt", &points, &g_error));
  crossgrain_numbers_free(points);
  crossgrain_numbers_free(normals);
  crossgrain_field_free(field);
}

TEST(ArcsOfABallAreOfValenceThree) {
  crossgrain_field* field = solved(ball(12), 20);
  crossgrain_graph* graph = NULL;
  OK(crossgrain_field_singularities(field, NULL, &graph, &g_error));
  const crossgrain_graph_summary* summary = crossgrain_graph_summary_of(graph);
  CHECK(summary->arcs > 0 && crossgrain_graph_arc(graph, summary->arcs) == NULL);
  for (size_t i = 0; i < summary->arcs; ++i) {
    const crossgrain_arc* arc = crossgrain_graph_arc(graph, i);
    CHECK(arc->point_count >= 2 && arc->length > 0);
    if (arc->type == CROSSGRAIN_REGULAR) CHECK(fabs(fabs(arc->index) - 0.25) < 1e-12);
    for (size_t k = 0; k < 3 * arc->point_count; ++k) CHECK(fabs(arc->points[k]) < 1.2);
    if (!arc->is_closed) CHECK(arc->nodes[0] < summary->nodes && arc->nodes[1] < summary->nodes);
  }
  for (size_t i = 0; i < summary->nodes; ++i) {
    const crossgrain_node* node = crossgrain_graph_node(graph, i);
    CHECK(node->arc_count > 0 && node->arcs[0] < summary->arcs);
  }
  crossgrain_answer* answer = NULL;
  OK(crossgrain_field_answer(field, &answer, &g_error));
  CHECK(strlen(crossgrain_answer_sentence(answer)) > 5);
  const int is_meshable = crossgrain_answer_verdict(answer) == CROSSGRAIN_MESHABLE;
  CHECK(is_meshable == (crossgrain_answer_reason(answer, 0) == NULL));
  crossgrain_answer_free(answer);
  crossgrain_graph_free(graph);
  crossgrain_field_free(field);
}

TEST(LinesAreTracedWrittenAndRead) {
  crossgrain_field* field = solved(box(2, 1, 1.5), 16);
  crossgrain_tracer* tracer = NULL;
  crossgrain_numbers *seeds = NULL, *on_cut = NULL;
  crossgrain_lines *lines = NULL, *read = NULL;
  OK(crossgrain_tracer_new(field, NULL, NULL, NULL, &tracer, &g_error));
  OK(crossgrain_tracer_spread_seeds(tracer, 5, NULL, &seeds, &g_error));
  CHECK(crossgrain_numbers_rows(seeds) == 5 && crossgrain_numbers_columns(seeds) == 3);
  OK(crossgrain_tracer_trace(tracer, crossgrain_numbers_data(seeds), 5, 3, 0, NULL, &lines, &g_error));
  CHECK(crossgrain_lines_count(lines) == 15 && crossgrain_lines_outside_seeds(lines) == 0);
  for (size_t i = 0; i < 15; ++i) {
    const crossgrain_line* line = crossgrain_lines_line(lines, i);
    CHECK(line->point_count >= 2 && line->tangents != NULL && line->seed < 5);
    CHECK(line->first_end == CROSSGRAIN_AT_BOUNDARY && line->last_end == CROSSGRAIN_AT_BOUNDARY);
    CHECK(fabs(line->length - (line->axis == 0 ? 2 : line->axis == 1 ? 1 : 1.5)) < 1e-3);
  }
  OK(crossgrain_lines_write(lines, "lines.vtu", NULL, NULL, &g_error));
  OK(crossgrain_lines_read("lines.vtu", &read, &g_error));
  CHECK(crossgrain_lines_count(read) == 15 && crossgrain_lines_line(read, 0)->tangents == NULL);
  FAILS(CROSSGRAIN_USAGE, "trace them again",
        crossgrain_lines_write(read, "again.vtu", NULL, NULL, &g_error));
  OK(crossgrain_field_render(field, "lines.png", NULL, NULL, read, NULL, &g_error));
  OK(crossgrain_tracer_cut_seeds(tracer, 0, NAN, 3, NULL, &on_cut, &g_error));
  CHECK(crossgrain_numbers_columns(on_cut) == 6);
  FAILS(CROSSGRAIN_USAGE, "three or six",
        crossgrain_tracer_trace(tracer, crossgrain_numbers_data(on_cut), 3, 5, 0, NULL, &read, &g_error));
  crossgrain_numbers_free(seeds);
  crossgrain_numbers_free(on_cut);
  crossgrain_lines_free(lines);
  crossgrain_lines_free(read);
  crossgrain_tracer_free(tracer);
  crossgrain_field_free(field);
}

TEST(AConstraintTurnsTheFrames) {
  crossgrain_mesh* mesh = ball(8);
  crossgrain_constraints* constraints = NULL;
  const double at[] = {0, 0, 0}, axis[] = {1, 1, 1}, tensor[] = {3, 2, 1, 0, 0, 0};
  OK(crossgrain_constraints_new(&constraints, &g_error));
  OK(crossgrain_constraints_add_point(constraints, at, axis, 1, 1000, &g_error));
  OK(crossgrain_constraints_check(constraints, &g_error));
  crossgrain_options* options = of_resolution(12);
  OK(crossgrain_options_set_constraints(options, constraints, &g_error));
  crossgrain_field* field = NULL;
  OK(crossgrain_solve(mesh, NULL, options, NULL, &field, &g_error));
  double frame[9], best = 0;
  OK(crossgrain_field_sample(field, at, 1, 0, frame, NULL, NULL, NULL, NULL, &g_error));
  for (int k = 0; k < 3; ++k)
    best = fmax(best, fabs(frame[3 * k] + frame[3 * k + 1] + frame[3 * k + 2]) / sqrt(3));
  CHECK(best > 0.97);
  crossgrain_field_free(field);
  field = NULL;
  OK(crossgrain_constraints_add_stress(constraints, at, tensor, 1, &g_error));
  const double line[] = {0, 0, 0, 0.1, 0, 0};
  OK(crossgrain_constraints_add_polyline(constraints, line, 2, NULL, 0, 1, &g_error));
  OK(crossgrain_constraints_add_face(constraints, 5, NULL, 0, 1, &g_error));
  OK(crossgrain_options_set_constraints(options, constraints, &g_error));
  FAILS(CROSSGRAIN_INPUT, "face", crossgrain_solve(mesh, NULL, options, NULL, &field, &g_error));
  crossgrain_options_free(options);
  crossgrain_constraints_free(constraints);
  crossgrain_mesh_free(mesh);
}

TEST(TheFormOfAPlaneHasItsSpectrum) {
  crossgrain_spectrum* spectrum = NULL;
  OK(crossgrain_spectrum_of_preset("plane", 3, &spectrum, &g_error));
  const crossgrain_form* form = crossgrain_spectrum_form(spectrum);
  CHECK(form->size == 7 && form->null_space_count == 2);
  for (int i = 0; i < 7; ++i) CHECK(fabs(form->eigenvalues[i] - (i < 2 ? 0 : 1)) < 1e-12);
  crossgrain_spectrum_free(spectrum);
  const double normal[] = {0, 0, 2}, weight = 1;
  OK(crossgrain_spectrum_of_normals(normal, &weight, 1, 4, &spectrum, &g_error));
  CHECK(crossgrain_spectrum_form(spectrum)->size == 9);
  crossgrain_spectrum_free(spectrum);
  FAILS(CROSSGRAIN_USAGE, "pyramid", crossgrain_spectrum_of_preset("pyramid", 3, &spectrum, &g_error));
}

static void* solve_ball(void* out) {
  *(crossgrain_field**)out = solved(ball(8), 14);
  return NULL;
}

TEST(TwoSolvesAtOnceGiveTheSameBits) {
  crossgrain_field* fields[2] = {NULL, NULL};
  pthread_t threads[2];
  for (int i = 0; i < 2; ++i) CHECK(pthread_create(&threads[i], NULL, solve_ball, &fields[i]) == 0);
  for (int i = 0; i < 2; ++i) CHECK(pthread_join(threads[i], NULL) == 0);
  const size_t n = crossgrain_field_size(fields[0]);
  CHECK(crossgrain_field_size(fields[1]) == n);
  CHECK(memcmp(crossgrain_field_quaternions(fields[0]), crossgrain_field_quaternions(fields[1]), 16 * n) ==
        0);
  crossgrain_field_free(fields[0]);
  crossgrain_field_free(fields[1]);
}

TEST(AMeshHasAllThatItWasGiven) {
  crossgrain_mesh* mesh = box(1, 1, 1);
  int32_t faces[12];
  double normals[12 * 9] = {0}, points[] = {0, 0, 0, 1, 0, 0}, tangents[] = {1, 0, 0, 1, 0, 0};
  for (int i = 0; i < 12; ++i) faces[i] = i / 2;
  OK(crossgrain_mesh_set_faces(mesh, faces, 12, &g_error));
  OK(crossgrain_mesh_set_corner_normals(mesh, normals, 12, &g_error));
  OK(crossgrain_mesh_add_crease(mesh, points, tangents, 2, 7, 1, &g_error));
  const uint32_t inner[] = {0, 3, 7};
  OK(crossgrain_mesh_add_inner_faces(mesh, inner, 1, &g_error));
  CHECK(memcmp(crossgrain_mesh_faces(mesh), faces, sizeof faces) == 0);
  CHECK(crossgrain_mesh_solids(mesh) == NULL && crossgrain_mesh_corner_normals(mesh) != NULL);
  CHECK(crossgrain_mesh_crease_count(mesh) == 1 && crossgrain_mesh_crease(mesh, 1) == NULL);
  const crossgrain_crease* crease = crossgrain_mesh_crease(mesh, 0);
  CHECK(crease->tag == 7 && crease->is_tagged == 1 && crease->point_count == 2 && crease->points[3] == 1);
  CHECK(crossgrain_mesh_vertices(mesh)[3] == 1 && crossgrain_mesh_triangles(mesh)[1] == 2);
  CHECK(crossgrain_mesh_warning(mesh, 0) == NULL && strcmp(crossgrain_mesh_unit(mesh), "") == 0);
  OK(crossgrain_mesh_set_solids(mesh, faces, 5, &g_error)); /* too few: a solve says so */
  crossgrain_field* field = NULL;
  FAILS(CROSSGRAIN_INPUT, "solids", crossgrain_solve(mesh, NULL, NULL, NULL, &field, &g_error));
  crossgrain_mesh_free(mesh);
  CHECK(crossgrain_is_tet_file("a.MESH") && !crossgrain_is_tet_file("a.stl") &&
        crossgrain_is_cad_file("a.step"));
  CHECK(crossgrain_format_name(0) != NULL && crossgrain_format_description(0) != NULL);
  CHECK(crossgrain_format_name(1000) == NULL);
}

static crossgrain_options* of_hexahedra(crossgrain_options_kind kind, const char* name, double size) {
  crossgrain_options* options = NULL;
  OK(crossgrain_options_new(kind, &options, &g_error));
  OK(crossgrain_options_set_number(options, name, size, &g_error));
  return options;
}

TEST(HexahedraFillACubeOfTets) {
  crossgrain_domain* domain = cube_of_tets(3);
  crossgrain_options* options = of_hexahedra(CROSSGRAIN_HEX_MESHING_OPTIONS, "hexahedra.size", 0.5);
  crossgrain_hexahedra* hexahedra = NULL;
  OK(crossgrain_hexahedra_make_in_tets(domain, options, NULL, &hexahedra, &g_error));
  CHECK(crossgrain_hexahedra_outcome(hexahedra) == CROSSGRAIN_ALL_HEX);
  CHECK(strstr(crossgrain_hexahedra_sentence(hexahedra), "all-hex: 8 hexahedra, mean edge ") != NULL);
  CHECK(crossgrain_hexahedra_count(hexahedra) == 8 && crossgrain_hexahedra_vertex_count(hexahedra) == 27);
  CHECK(crossgrain_hexahedra_face_count(hexahedra) == 24);
  const double* vertices = crossgrain_hexahedra_vertices(hexahedra);
  for (int i = 0; i < 3 * 27; ++i) CHECK(fabs(2 * vertices[i] - round(2 * vertices[i])) < 1e-6);
  for (int i = 0; i < 8; ++i) CHECK(crossgrain_hexahedra_scaled_jacobians(hexahedra)[i] > 0.999);
  for (int i = 0; i < 8 * 8; ++i) CHECK(crossgrain_hexahedra_corners(hexahedra)[i] < 27);
  for (int i = 0; i < 4 * 24; ++i) CHECK(crossgrain_hexahedra_faces(hexahedra)[i] < 27);
  CHECK(crossgrain_hexahedra_face_tags(hexahedra)[23] == 0);
  CHECK(crossgrain_hexahedra_regions(hexahedra) == NULL && crossgrain_hexahedra_unit(hexahedra)[0] == 0);
  char* json = NULL;
  OK(crossgrain_hexahedra_report(hexahedra, &json, &g_error));
  CHECK(strstr(json, "\"outcome\": \"all-hex\"") != NULL);
  crossgrain_text_free(json);
  crossgrain_hexahedra_free(hexahedra);
  crossgrain_options_free(options);
  crossgrain_domain_free(domain);
}

TEST(HexahedraAreWrittenAloneAndWithTheirField) {
  crossgrain_domain* domain = cube_of_tets(3);
  crossgrain_options* options = of_hexahedra(CROSSGRAIN_HEX_MESHING_OPTIONS, "hexahedra.cells", 2);
  crossgrain_hexahedra* hexahedra = NULL;
  OK(crossgrain_hexahedra_make_in_tets(domain, options, NULL, &hexahedra, &g_error));
  OK(crossgrain_hexahedra_write(hexahedra, "cube.msh", 0, NULL, &g_error));
  CHECK(exists("cube.msh"));
  FAILS(CROSSGRAIN_USAGE, "cube.stl", crossgrain_hexahedra_write(hexahedra, "cube.stl", 0, NULL, &g_error));
  OK(crossgrain_hexahedra_write_folder(hexahedra, "cube.hexahedra", NULL, "cube.mesh", 0, NULL, NULL,
                                       &g_error));
  CHECK(exists("cube.hexahedra/hexahedra.inp") && exists("cube.hexahedra/onto.vtu"));
  crossgrain_tet_field* field = NULL;
  OK(crossgrain_hexahedra_field(hexahedra, &field, &g_error));
  crossgrain_hexahedra_free(hexahedra);
  crossgrain_domain* repaired = NULL;
  OK(crossgrain_tet_field_domain(field, &repaired, &g_error));
  CHECK(crossgrain_domain_parents(repaired) != NULL); /* prepared for a map */
  crossgrain_domain_free(repaired);
  crossgrain_tet_field_free(field);
  crossgrain_options_free(options);
  crossgrain_domain_free(domain);
}

TEST(HexahedraFollowAFieldThatIsThere) {
  crossgrain_domain *domain = cube_of_tets(3), *prepared = NULL;
  OK(crossgrain_domain_prepared_for_map(domain, NULL, &prepared, &g_error));
  crossgrain_tet_field* field = NULL;
  OK(crossgrain_solve_onto(prepared, NULL, NULL, &field, &g_error));
  crossgrain_options* options = of_hexahedra(CROSSGRAIN_HEX_OPTIONS, "size", 0.5);
  crossgrain_hexahedra* hexahedra = NULL;
  OK(crossgrain_tet_field_hexahedra(field, options, NULL, &hexahedra, &g_error));
  CHECK(crossgrain_hexahedra_count(hexahedra) == 8);
  crossgrain_hexahedra_free(hexahedra);
  FAILS(CROSSGRAIN_USAGE, "another kind",
        crossgrain_hexahedra_make_in_tets(domain, options, NULL, &hexahedra, &g_error));
  OK(crossgrain_options_set_number(options, "size", -1, &g_error));
  FAILS(CROSSGRAIN_USAGE, "size", crossgrain_tet_field_hexahedra(field, options, NULL, &hexahedra, &g_error));
  FAILS(CROSSGRAIN_INPUT, "none.step",
        crossgrain_hexahedra_make("none.step", NULL, NULL, &hexahedra, &g_error));
  crossgrain_options_free(options);
  crossgrain_tet_field_free(field);
  crossgrain_domain_free(prepared);
  crossgrain_domain_free(domain);
}

/* A cube of side 2 from the origin: each side is cut along a diagonal. */
static void write_cube(const char* name) {
  static const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  FILE* file = fopen(name, "w");
  CHECK(file != NULL);
  for (int k = 0; k < 8; ++k) fprintf(file, "v %d %d %d\n", 2 * (k & 1), k & 2, k / 4 * 2);
  for (int k = 0; k < 6; ++k)
    fprintf(file, "f %d %d %d %d\n", quads[k][0] + 1, quads[k][1] + 1, quads[k][2] + 1, quads[k][3] + 1);
  CHECK(fclose(file) == 0);
}

/* Eight hexahedra in a smaller one. */
static void lattice(double* vertices, uint32_t* corners) {
  static const int places[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (int v = 0; v < 27; ++v) {
    vertices[3 * v] = 0.1 + 0.9 * (v % 3);
    vertices[3 * v + 1] = 0.1 + 0.9 * (v / 3 % 3);
    vertices[3 * v + 2] = 0.1 + 0.9 * (v / 9);
  }
  for (int h = 0; h < 8; ++h)
    for (int k = 0; k < 8; ++k)
      corners[8 * h + k] =
          (uint32_t)((h % 2 + places[k][0]) + 3 * (h / 2 % 2 + places[k][1]) + 9 * (h / 4 + places[k][2]));
}

TEST(HexahedraOfAnotherMesherArePutOntoAModel) {
  double vertices[81];
  uint32_t corners[64];
  lattice(vertices, corners);
  write_cube("cube.obj");
  crossgrain_options* options = NULL;
  OK(crossgrain_options_new(CROSSGRAIN_HEX_FIT_OPTIONS, &options, &g_error));
  OK(crossgrain_options_set_number(options, "crease_angle_deg", 40, &g_error));
  crossgrain_hexahedra *fitted = NULL, *again = NULL;
  OK(crossgrain_hexahedra_fit_arrays(vertices, 27, corners, 8, "cube.obj", options, NULL, &fitted, &g_error));
  CHECK(crossgrain_hexahedra_outcome(fitted) == CROSSGRAIN_ALL_HEX);
  CHECK(crossgrain_hexahedra_count(fitted) == 8 && crossgrain_hexahedra_face_count(fitted) == 24);
  for (int i = 0; i < 81; ++i)
    CHECK(fabs(crossgrain_hexahedra_vertices(fitted)[i] - round(crossgrain_hexahedra_vertices(fitted)[i])) <
          1e-6);
  CHECK(memcmp(crossgrain_hexahedra_corners(fitted), corners, sizeof corners) == 0);
  OK(crossgrain_hexahedra_write_folder(fitted, "cube.fitted", NULL, NULL, 0, NULL, NULL, &g_error));
  CHECK(exists("cube.fitted/hexahedra.inp") && exists("cube.fitted/report.json") &&
        !exists("cube.fitted/onto.vtu"));
  OK(crossgrain_hexahedra_fit("cube.fitted/hexahedra.inp", "cube.obj", NULL, NULL, &again, &g_error));
  CHECK(crossgrain_hexahedra_outcome(again) == CROSSGRAIN_ALL_HEX);
  crossgrain_tet_field* field = NULL;
  FAILS(CROSSGRAIN_USAGE, "follow no field", crossgrain_hexahedra_field(fitted, &field, &g_error));
  crossgrain_hexahedra_free(again);
  crossgrain_hexahedra_free(fitted);
  for (int i = 0; i < 81; ++i) vertices[i] *= 1000;
  FAILS(CROSSGRAIN_INPUT, "the model from 0 0 0 to 2 2 2",
        crossgrain_hexahedra_fit_arrays(vertices, 27, corners, 8, "cube.obj", options, NULL, &fitted,
                                        &g_error));
  corners[5] = 27;
  FAILS(CROSSGRAIN_USAGE, "hexahedron 0",
        crossgrain_hexahedra_fit_arrays(vertices, 27, corners, 8, "cube.obj", options, NULL, &fitted,
                                        &g_error));
  crossgrain_options_free(options);
}

TEST(HexahedraOfALatticeFillAModelWithoutAField) {
  write_cube("cube.obj");
  crossgrain_options* options = NULL;
  OK(crossgrain_options_new(CROSSGRAIN_HEX_MESHING_OPTIONS, &options, &g_error));
  OK(crossgrain_options_set_number(options, "hexahedra.cells", 4, &g_error));
  crossgrain_hexahedra *made = NULL, *inside = NULL;
  OK(crossgrain_hexahedra_lattice("cube.obj", options, NULL, &made, &g_error));
  CHECK(crossgrain_hexahedra_outcome(made) == CROSSGRAIN_ALL_HEX && crossgrain_hexahedra_count(made) == 64);
  crossgrain_mesh* mesh = NULL;
  OK(crossgrain_mesh_read("cube.obj", NULL, NULL, &mesh, &g_error));
  OK(crossgrain_hexahedra_lattice_inside(mesh, options, NULL, &inside, &g_error));
  CHECK(crossgrain_hexahedra_count(inside) == 64);
  crossgrain_tet_field* field = NULL;
  FAILS(CROSSGRAIN_USAGE, "follow no field", crossgrain_hexahedra_field(made, &field, &g_error));
  crossgrain_mesh_free(mesh);
  crossgrain_hexahedra_free(inside);
  crossgrain_hexahedra_free(made);
  crossgrain_options_free(options);
}

int main(int argc, char** argv) {
  const struct {
    const char* name;
    void (*run)(void);
  } tests[] = {
#define NAMED(name) {#name, name}
      NAMED(TheHeaderIsThatOfTheLibrary),
      NAMED(FramesInABoxFollowIt),
      NAMED(SamplesSayWhatIsOutside),
      NAMED(CoefficientsOfAFrameDoNotDependOnItsNames),
      NAMED(ErrorsTellWhatIsWrongAndWhere),
      NAMED(EveryOptionKeepsWhatItHas),
      NAMED(OptionsRefuseWhatTheyCannotHold),
      NAMED(AListenerHearsAndCancels),
      NAMED(TetsOfAnOpenSurfaceAreRefused),
      NAMED(TaggedFacesAndEdgesAreGivenBackAndWritten),
      NAMED(MatchingsCarryFramesAcrossFacesOfTets),
      NAMED(TetsArePreparedForAMap),
      NAMED(ARepairedFieldIsReadAsItWasWritten),
      NAMED(ARepairTakesItsOptionAndCanBeCancelled),
      NAMED(AFieldThatIsReadIsTheOneThatWasWritten),
      NAMED(ACompanionIsWrittenWithTheFieldOrNothingIs),
      NAMED(SamplesAreWrittenForPointsThatAreRead),
      NAMED(ArcsOfABallAreOfValenceThree),
      NAMED(LinesAreTracedWrittenAndRead),
      NAMED(AConstraintTurnsTheFrames),
      NAMED(TheFormOfAPlaneHasItsSpectrum),
      NAMED(TwoSolvesAtOnceGiveTheSameBits),
      NAMED(AMeshHasAllThatItWasGiven),
      NAMED(HexahedraFillACubeOfTets),
      NAMED(HexahedraAreWrittenAloneAndWithTheirField),
      NAMED(HexahedraFollowAFieldThatIsThere),
      NAMED(HexahedraOfAnotherMesherArePutOntoAModel),
      NAMED(HexahedraOfALatticeFillAModelWithoutAField),
  };
  for (size_t i = 0; i < sizeof tests / sizeof tests[0]; ++i) {
    if (argc > 1 && strcmp(argv[1], tests[i].name) != 0) continue;
    tests[i].run();
    if (argc > 1) return 0;
  }
  return argc > 1; /* a name that there is not */
}
