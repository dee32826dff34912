// SPDX-License-Identifier: Apache-2.0
// Allocations fail one after the other: each failure is an exception, and what is done next is as before.
// CROSSGRAIN_ALLOCATION_STEP sets how many are passed over between two that fail; 1 takes all.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <new>
#include <string>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/page.hpp"
#include "crossgrain/picture.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/solve.hpp"
#include "crossgrain/streamlines.hpp"
#include "field/field_data.hpp"
#include "files/folder_reservation.hpp"
#include "files/temporary_folder.hpp"
#include "mesh_files/medit_files.hpp"
#include "mesh_files/vtk_files.hpp"
#include "support/allocation_watch.hpp"
#include "support/shapes.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

using Numbers = std::vector<std::array<float, 4>>;

Numbers frames_of(const FrameField& field) {
  Numbers frames;
  for (const auto& frame : field.data().frames) frames.push_back(std::bit_cast<std::array<float, 4>>(frame));
  return frames;
}

/// A cylinder with a hole: creases, several levels, and something to mend.
TriangleMesh open_cylinder() {
  TriangleMesh mesh = make_cylinder(0.5, 1.0, 24);
  mesh.triangles.pop_back();
  return mesh;
}

SolveOptions small_solve(int threads = 1) {
  SolveOptions options;
  options.resolution = 12;
  options.threads = threads;
  return options;
}

/// Number of allocations passed over between two that fail.
long step_of(long count) {
  const char* const text = std::getenv("CROSSGRAIN_ALLOCATION_STEP");
  return text != nullptr ? std::atol(text) : std::max(1L, count / 30);
}

/// Calls act() with one allocation after the other failing, and compares what it returns otherwise; after
/// each failure, `check`.
template <class Act>
void expect_exceptions(
    const Act& act, const std::function<void()>& check = [] {}) {
  const auto expected = act();
  watch_allocations();
  act();
  const long count = allocation_count();
  const long step = step_of(count);
  long failures = 0, passed = 0;
  for (long number = 0; number < count; number += step) {
    try {
      watch_allocations(number);
      const auto result = act();
      watch_allocations();
      // Work that may fail, such as a buffer to sort in, is done another way.
      ++passed;
      ASSERT_TRUE(result == expected) << number;
    } catch (const std::bad_alloc&) {
      watch_allocations();
      ++failures;
    } catch (const Error& error) {
      watch_allocations();
      // Readers say which file it is.
      ASSERT_EQ(error.kind(), ErrorKind::kLimit) << number << ": " << error.what();
      ++failures;
    }
    ASSERT_NO_THROW(check()) << number;
  }
  EXPECT_TRUE(act() == expected);
  EXPECT_GT(failures, 2 * passed) << failures << " of " << count;
}

TEST(AllocationFailure, OfASolveIsAnException) {
  const TriangleMesh mesh = open_cylinder();
  expect_exceptions([&] { return frames_of(solve(mesh, small_solve())); });
}

TEST(AllocationFailure, OfASolveOnTwoThreadsIsAnException) {
  const TriangleMesh mesh = open_cylinder();
  expect_exceptions([&] { return frames_of(solve(mesh, small_solve(2))); });
}

TEST(AllocationFailure, OfASolveOnTetsIsAnException) {
  const TetMesh mesh = TetBox{{2, 2, 2}}.mesh();
  expect_exceptions([&] {
    const TetFrameField field = solve_onto(TetDomain(mesh), small_solve());
    return frames_of(field.grid());
  });
}

TEST(AllocationFailure, OfReadersIsAnException) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& name, const std::string& content) {
    const std::filesystem::path path = folder.write(name, content);
    SCOPED_TRACE(name);
    expect_exceptions([&] { return read_surface(path).vertices; });
  };
  read("box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  read("box.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 1\n");
  for (const auto& files : {medit_text(made_tet_mesh()), vtu_files(made_tet_mesh()).back()}) {
    const std::filesystem::path path = folder.write("tets" + files.extension, files.content);
    expect_exceptions([&] { return read_tets(path).vertices; });
  }
}

/// How a process ends that writes or reads a field while an allocation fails. JSON's library allocates in
/// destructors, where a failure ends the process; the program then says that it is out of memory.
enum Ending { kDone = 0, kThrown = 10, kTerminated = 11 };

/// Runs the test below in a process of its own; number -1 fails nothing. Returns how it ended.
int run_apart(const std::string& act, const std::filesystem::path& folder, long number) {
  return WEXITSTATUS(std::system(
      fmt::format("CROSSGRAIN_ACT={} CROSSGRAIN_FOLDER='{}' CROSSGRAIN_NUMBER={} '{}' "
                  "--gtest_also_run_disabled_tests --gtest_filter=AllocationFailure.DISABLED_OfOneAct > "
                  "/dev/null 2>&1",
                  act, folder.string(), number, std::filesystem::read_symlink("/proc/self/exe").string())
          .c_str()));
}

/// Writes the number of allocations beside the result if none fails.
TEST(AllocationFailure, DISABLED_OfOneAct) {
  const std::string act = std::getenv("CROSSGRAIN_ACT");
  const std::filesystem::path folder = std::getenv("CROSSGRAIN_FOLDER"), result = folder / "result";
  const long number = std::atol(std::getenv("CROSSGRAIN_NUMBER"));
  const FrameField field = solve(open_cylinder(), small_solve());
  OutputOptions options;
  options.companion = page_of(field);
  std::set_terminate([] { std::_Exit(kTerminated); });
  try {
    watch_allocations(number);
    if (act == "write")
      write_field(field, result, {}, options);
    else if (frames_of(read_field(result)) != frames_of(field))
      std::_Exit(1);
    const long count = allocation_count();
    watch_allocations();
    if (number < 0) std::ofstream(folder / "count") << count;
    std::_Exit(kDone);
  } catch (const std::bad_alloc&) {
    std::_Exit(kThrown);
  } catch (const Error& error) {
    std::_Exit(error.kind() == ErrorKind::kLimit ? kThrown : 1);
  }
}

/// The files of a result; those that hold how long writing took only by their names.
std::map<std::string, std::string> contents_of(const std::filesystem::path& result) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : std::filesystem::directory_iterator(result)) {
    const std::string name = entry.path().filename();
    if (is_name_of_unfinished_work(name))
      continue;  // memory ran out after the exchange: for the next command
    contents[name] = name.starts_with("report.") ? "" : content_of(entry.path());
  }
  return contents;
}

TEST(AllocationFailure, OfWritingAndReadingAFieldLeavesItsFolderWhole) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_apart("write", folder.path(), -1), kDone);
  const auto before = contents_of(folder.path() / "result");
  for (const std::string act : {"write", "read"}) {
    ASSERT_EQ(run_apart(act, folder.path(), -1), kDone);
    const long count = std::stol(content_of(folder.path() / "count"));
    std::map<int, int> endings;
    for (long number = 0; number < count; number += step_of(count)) {
      const int ending = run_apart(act, folder.path(), number);
      ASSERT_TRUE(ending == kDone || ending == kThrown || ending == kTerminated)
          << act << number << ": " << ending;
      ++endings[ending];
      ASSERT_TRUE(contents_of(folder.path() / "result") == before) << act << number;
      ASSERT_NE(solve_of_result(folder.path() / "result"), "") << act << number;
      for (const std::string& name : folder.names())
        ASSERT_TRUE(name == "count" || name == "result" || is_name_of_unfinished_work(name)) << act << name;
    }
    EXPECT_GT(endings[kThrown], 4 * endings[kTerminated]) << act;
    ASSERT_EQ(run_apart("write", folder.path(), -1), kDone);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"count", "result"}));
  }
}

TEST(AllocationFailure, OfStreamlinesIsAnException) {
  const FrameField field = solve(open_cylinder(), small_solve());
  const std::vector<Vector3> seeds{{0.1, 0.1, 0.2}, {-0.2, 0.1, -0.3}};
  expect_exceptions([&] {
    std::vector<Vector3> points;
    for (const Streamline& line : StreamlineTracer(field).trace(seeds).lines)
      points.insert(points.end(), line.points.begin(), line.points.end());
    return points;
  });
}

TEST(AllocationFailure, OfAPictureLeavesTheEarlierOne) {
  const FrameField field = solve(open_cylinder(), small_solve());
  const TemporaryFolder folder;
  const std::filesystem::path picture = folder.path() / "field.png";
  PictureOptions options;
  options.size = {64, 64};
  const auto draw = [&] {
    render_picture(field, picture, options);
    return content_of(picture);
  };
  const std::string before = draw();
  expect_exceptions(draw, [&] {
    EXPECT_EQ(folder.names(), std::vector<std::string>{"field.png"});
    EXPECT_EQ(content_of(picture), before);
  });
}

}  // namespace
}  // namespace crossgrain
