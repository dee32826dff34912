// SPDX-License-Identifier: Apache-2.0
// What passes between the library and crossgrain_netgen, whatever a crash leaves of it.
#include "tet_making/netgen_messages.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "crossgrain/error.hpp"
#include "crossgrain/version.hpp"
#include "files/temporary_folder.hpp"
#include "support/shapes.hpp"
#include "tet_making/made_netgen_answers.hpp"
#include "tet_making/tet_making_tuning.hpp"
#include "tet_making/tets_of_makers.hpp"

namespace crossgrain {
namespace {

TEST(NetgenMessages, ARequestIsReadToTheBit) {
  NetgenRequest request{4711, NetgenWork::kCut, {0.1}, SIZE_MAX, "/tmp/a b"};
  request.sizes.edges_per_circle = 1.0 / 3;
  request.sizes.smallest_share = 1e-300;
  const std::optional<NetgenRequest> got = netgen_request_of(arguments_of(request));
  ASSERT_TRUE(got);
  EXPECT_EQ(got->asking_process, 4711);
  EXPECT_EQ(got->work, NetgenWork::kCut);
  EXPECT_EQ(got->sizes.size, 0.1);
  EXPECT_EQ(got->sizes.edges_per_circle, 1.0 / 3);
  EXPECT_EQ(got->sizes.smallest_share, 1e-300);
  EXPECT_EQ(got->max_memory_bytes, SIZE_MAX);
  EXPECT_EQ(got->folder, "/tmp/a b");
}

TEST(NetgenMessages, ASurfaceIsReadToTheBit) {
  const NetgenSurface surface{{{0, 1.0 / 3, -0.0}, {1, 0, 0}, {0, 1, 1e-300}}, {{0, 1, 2}}};
  const std::string bytes = netgen_surface_bytes(surface);
  const std::optional<NetgenSurface> got = netgen_surface_in(bytes);
  ASSERT_TRUE(got);
  EXPECT_EQ(got->vertices, surface.vertices);
  EXPECT_EQ(got->triangles, surface.triangles);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(netgen_surface_in(bytes.substr(0, size)));
}

TEST(NetgenMessages, BelieveNoAnswerThatIsCutShort) {
  const std::string bytes = written(some_netgen_answer());
  ASSERT_TRUE(netgen_answer_in(bytes));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(netgen_answer_in(bytes.substr(0, size)));
  EXPECT_FALSE(netgen_answer_in(bytes + "."));
}

TEST(NetgenMessages, BelieveNoAnswerThatContradictsItself) {
  const auto is_believed = [](const auto& change) {
    NetgenAnswer answer = some_netgen_answer();
    change(answer);
    return netgen_answer_in(written(answer)).has_value();
  };
  EXPECT_TRUE(is_believed([](NetgenAnswer&) {}));
  EXPECT_FALSE(is_believed([](NetgenAnswer& a) { a.mesh.tets[0][2] = 4; }));
  EXPECT_FALSE(is_believed([](NetgenAnswer& a) { a.mesh.feature_faces[0].vertices[1] = 4; }));
  EXPECT_FALSE(is_believed([](NetgenAnswer& a) { a.mesh.feature_edges[0].vertices[0] = 4; }));
  EXPECT_FALSE(is_believed([](NetgenAnswer& a) { a.mesh.regions.push_back(1); }));
  EXPECT_FALSE(is_believed([](NetgenAnswer& a) { a.mesh.vertices[0][0] = std::nan(""); }));
  EXPECT_FALSE(is_believed([](NetgenAnswer& a) { a.fault = "two\nlines"; }));
  EXPECT_FALSE(is_believed([](NetgenAnswer& a) { a.end = static_cast<NetgenEnd>(3); }));
}

TEST(NetgenMessages, SurviveFlippedBits) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 3000; ++trial) {
    std::string bytes = written(some_netgen_answer());
    bytes[random() % bytes.size()] ^= static_cast<char>(1 << random() % 8);
    netgen_answer_in(bytes);
  }
}

/// A program in the place of crossgrain_netgen.
Error error_by(const std::string& script) {
  const TemporaryFolder folder;
  TetMakingTuning options{tets_of_size(0.5)};
  options.maker = TetMaker::kNetgen;
  options.seconds = 30;
  options.netgen = folder.write("netgen.sh", "#!/bin/sh\n" + script + "\n");
  std::filesystem::permissions(options.netgen, std::filesystem::perms::owner_all);
  try {
    make_tets(make_box({1, 1, 1}), options);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return Error(ErrorKind::kUsage, "");
}

void expect_words(const Error& error, ErrorKind kind, const std::string& words) {
  EXPECT_EQ(error.kind(), kind) << error.what();
  EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
}

TEST(NetgenMessages, AProgramOfAnotherVersionIsTold) {
  expect_words(error_by("printf 'crossgrain_netgen 0.0.0\\n' >&3"), ErrorKind::kInput, "does not belong to");
}

TEST(NetgenMessages, ACrashIsTold) {
  expect_words(error_by("kill -SEGV $$"), ErrorKind::kInput, "Netgen crashed on it (Segmentation fault)");
  expect_words(error_by(fmt::format("printf 'crossgrain_netgen {}\\nhalf' >&3", kVersion)), ErrorKind::kInput,
               "Netgen crashed on it (no complete answer)");
}

TEST(NetgenMessages, MissingLibrariesAreTold) {
  expect_words(error_by("exit 127"), ErrorKind::kInput, "cannot find libraries of Netgen");
}

}  // namespace
}  // namespace crossgrain
