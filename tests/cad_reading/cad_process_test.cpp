// SPDX-License-Identifier: Apache-2.0
// What a reader of CAD files may do that OpenCASCADE does on damaged files: crash, hang, take too much
// memory, talk. Most of it is played by shell scripts in its place.
#include <fmt/format.h>
#include <signal.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <thread>

#include "base/required_memory.hpp"
#include "base/system_memory.hpp"
#include "cad_reading/cad_messages.hpp"
#include "cad_reading/made_cad_answers.hpp"
#include "cad_reading/made_cad_files.hpp"
#include "crossgrain/version.hpp"
#include "mesh_files/surface_files.hpp"
#include "support/nightly.hpp"

namespace crossgrain {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kStep = "ISO-10303-21;\nEND-ISO-10303-21;\n";

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A folder with a file to read and a script to read it with.
class FakeReader {
 public:
  explicit FakeReader(const std::string& script) : part_(folder_.write("part.step", kStep)) {
    options_.cad_program = folder_.write("reader.sh", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(options_.cad_program, std::filesystem::perms::owner_all);
    options_.read_seconds = 30;
  }

  CadReading& options() { return options_; }
  const std::filesystem::path& folder() const { return folder_.path(); }
  TriangleMesh read(const Monitor& monitor = {}) const { return read_surface(part_, options_, monitor); }

  /// The message of what reading gives, which names the file.
  std::string error(ErrorKind kind = ErrorKind::kInput) const {
    try {
      read();
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(error.kind(), kind) << message;
      EXPECT_TRUE(message.starts_with(part_.string() + ": ")) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message;
    }
    ADD_FAILURE() << "no error";
    return "";
  }

 private:
  TemporaryFolder folder_;
  std::filesystem::path part_;
  CadReading options_;
};

void expect_words(const std::string& message, const std::vector<std::string>& words) {
  for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << message;
}

/// A shell command that says so much of an answer.
std::string saying(const std::string& bytes) {
  std::string octal;
  for (const unsigned char c : bytes) octal += fmt::format("\\{:03o}", c);
  return "printf '" + octal + "' >&3";
}

std::string greeting() {
  return fmt::format("crossgrain_cad {}\n", kVersion);
}

TEST(CadProcess, HandsOverTheWholeMesh) {
  TriangleMesh sent = some_answer().mesh;
  const TriangleMesh got = FakeReader(saying(written(some_answer()))).read();
  EXPECT_EQ(got.vertices, sent.vertices);
  EXPECT_EQ(got.triangles, sent.triangles);
  EXPECT_EQ(got.faces, sent.faces);
  EXPECT_EQ(got.solids, sent.solids);
  EXPECT_TRUE(got.corner_normals.empty());
  ASSERT_EQ(got.creases.size(), 1u);
  EXPECT_EQ(got.creases[0].points, sent.creases[0].points);
  EXPECT_EQ(got.creases[0].tangents, sent.creases[0].tangents);
  EXPECT_EQ(got.creases[0].tag, 5);
  ASSERT_EQ(got.face_list.size(), 2u);
  EXPECT_EQ(got.face_list[1].number, 2);
  EXPECT_EQ(got.face_list[1].kind, FaceKind::kTorus);
  EXPECT_EQ(got.face_list[1].area, 1.5);
  EXPECT_EQ(got.face_list[1].centre, (Vector3{4, 5, 6}));
  EXPECT_EQ(got.face_list[1].solids, 2u);
  EXPECT_EQ(got.exact_size.volume, 1.5);
  EXPECT_EQ(got.exact_size.area, 2.5);
  EXPECT_EQ(got.exact_box.high, (Vector3{1, 1, 0.125}));
  EXPECT_EQ(got.unit, "mm");
  EXPECT_EQ(got.file_unit, "inch");
  ASSERT_EQ(got.warnings.size(), 2u);
  for (Warning& warning : sent.warnings) warning.file = got.warnings[0].file;
  EXPECT_TRUE(got.warnings[0].file.ends_with("part.step"));
  EXPECT_EQ(got.warnings, sent.warnings);
}

TEST(CadProcess, GetsTheRequestToTheBit) {
  CadRequest request{"a b'c.step", CadFormat::kIges, {}, 4711, true};
  request.options.resolution = 77;
  request.options.cell_size = 0.1;
  request.options.facet_angle_deg = 1.0 / 3;
  request.options.max_memory_bytes = SIZE_MAX;
  request.options.glue = true;
  request.options.glue_gap = 2e-7;
  const std::optional<CadRequest> got = cad_request_of(arguments_of(request));
  ASSERT_TRUE(got);
  EXPECT_EQ(got->path, request.path);
  EXPECT_EQ(got->format, request.format);
  EXPECT_EQ(got->asking_process, 4711);
  EXPECT_EQ(got->options.resolution, 77);
  EXPECT_EQ(got->options.cell_size, 0.1);
  EXPECT_EQ(got->options.facet_angle_deg, 1.0 / 3);
  EXPECT_EQ(got->options.crease_angle_deg, 35);
  EXPECT_EQ(got->options.max_memory_bytes, SIZE_MAX);
  EXPECT_TRUE(got->options.glue);
  EXPECT_EQ(got->options.glue_gap, 2e-7);
  EXPECT_TRUE(got->with_solids);
}

TEST(CadProcess, BelievesNoAnswerThatIsCutShort) {
  const std::string bytes = written(some_answer());
  ASSERT_TRUE(cad_answer_in(bytes));
  for (std::size_t size = 0; size < bytes.size(); ++size) EXPECT_FALSE(cad_answer_in(bytes.substr(0, size)));
  EXPECT_FALSE(cad_answer_in(bytes + "."));
}

TEST(CadProcess, BelievesNoAnswerThatContradictsItself) {
  CadAnswer answer = some_answer();
  answer.mesh.triangles[3][1] = 4;
  EXPECT_FALSE(cad_answer_in(written(answer)));
  answer = some_answer();
  answer.mesh.solids.pop_back();
  EXPECT_FALSE(cad_answer_in(written(answer)));
  answer = some_answer();
  answer.mesh.creases[0].tangents.clear();
  EXPECT_FALSE(cad_answer_in(written(answer)));
}

TEST(CadProcess, BelievesNoAnswerBeyondALimit) {
  const auto is_believed = [](const auto& change) {
    CadAnswer answer = some_answer();
    change(answer);
    return cad_answer_in(written(answer)).has_value();
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity(), kNone = std::nan("");
  EXPECT_TRUE(is_believed([](CadAnswer& a) { a.mesh.unit.assign(kMostTextBytes, 'm'); }));
  EXPECT_TRUE(is_believed([](CadAnswer& a) { a.mesh.warnings.resize(kMostCadWarnings); }));
  EXPECT_FALSE(is_believed([](CadAnswer& a) { a.mesh.unit.assign(kMostTextBytes + 1, 'm'); }));
  EXPECT_FALSE(is_believed([](CadAnswer& a) { a.mesh.warnings.resize(kMostCadWarnings + 1); }));
  EXPECT_FALSE(is_believed([](CadAnswer& a) { a.mesh.warnings[0].text = "\x1b[2J"; }));
  EXPECT_FALSE(is_believed([](CadAnswer& a) { a.fault.text = "two\nlines"; }));
  EXPECT_FALSE(is_believed([](CadAnswer& a) { a.mesh.warnings[0].kind = static_cast<WarningKind>(-1); }));
  EXPECT_FALSE(is_believed([](CadAnswer& a) { a.mesh.warnings[0].remedy = static_cast<Remedy>(1000); }));
  EXPECT_FALSE(is_believed([](CadAnswer& a) { a.end = static_cast<CadEnd>(3); }));
  EXPECT_FALSE(is_believed([](CadAnswer& a) { a.mesh.solids[0] = -1; }));
  EXPECT_FALSE(is_believed([](CadAnswer& a) { a.mesh.faces[0] = -1; }));
  EXPECT_FALSE(is_believed([](CadAnswer& a) { a.solids.face_numbers[0] = -1; }));
  EXPECT_FALSE(is_believed([](CadAnswer& a) { a.mesh.vertices[0][2] = kInfinity; }));
  EXPECT_FALSE(is_believed([](CadAnswer& a) { a.mesh.corner_normals.assign(4, {Vector3{kNone, 0, 0}}); }));
  EXPECT_FALSE(is_believed([](CadAnswer& a) { a.mesh.creases[0].tangents[1][0] = kNone; }));
}

/// Eight bytes anywhere replaced by numbers that no list can have, or that look like one that it can.
TEST(CadProcess, SurvivesEveryLengthInEveryPlace) {
  const std::string sound = written(some_answer());
  for (const std::uint64_t length : {std::uint64_t{1}, std::uint64_t{1000}, std::uint64_t{1} << 32,
                                     std::uint64_t{1} << 60, UINT64_MAX / 24 + 1, UINT64_MAX}) {
    for (std::size_t at = greeting().size(); at + sizeof length <= sound.size(); ++at) {
      std::string bytes = sound;
      std::memcpy(bytes.data() + at, &length, sizeof length);
      cad_answer_in(bytes);
    }
  }
}

TEST(CadProcess, RefusesRequestsThatAreNone) {
  CadRequest request{"part.step", CadFormat::kIges, {}, 4711};
  const std::vector<std::string> sound = arguments_of(request);
  ASSERT_TRUE(cad_request_of(sound));
  EXPECT_FALSE(cad_request_of({}));
  EXPECT_FALSE(cad_request_of({sound.begin(), sound.end() - 1}));
  for (std::size_t i = 0; i + 1 < sound.size(); ++i) {
    for (const char* other : {"", "-", "1x", "99999999999999999999999"}) {
      std::vector<std::string> arguments = sound;
      arguments[i] = other;
      const bool is_large_number = i >= 4 && i <= 8 && i != 7 && std::string_view(other).size() > 2;
      EXPECT_EQ(cad_request_of(arguments).has_value(), is_large_number) << i << " " << other;
    }
  }
}

/// Whatever bytes a crash leaves behind: no crash here, and no memory beyond them.
TEST(CadProcess, SurvivesAnswersWithFlippedBits) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 3000; ++trial) {
    std::string bytes = written(some_answer());
    const std::size_t begin = greeting().size();
    bytes[begin + random() % (bytes.size() - begin)] ^= static_cast<char>(1 << random() % 8);
    cad_answer_in(bytes);
  }
}

TEST(CadProcess, ACrashIsToldOfTheFile) {
  expect_words(FakeReader("kill -SEGV $$").error(),
               {"crashed on it", "Segmentation fault", "export it again"});
  expect_words(FakeReader(saying(greeting() + "half an ans") + "; kill -ABRT $$").error(), {"crashed on it"});
  expect_words(FakeReader(saying(greeting()) + "; exit 1").error(), {"crashed on it"});
}

TEST(CadProcess, AHangEndsWithItsTime) {
  // What it has started holds on to its files, and goes with it.
  for (const char* script :
       {"sleep 1000; true", "exec 3>&-; while true; do sleep 1; done", "yes >&3; true"}) {
    SCOPED_TRACE(script);
    FakeReader reader(script);
    reader.options().read_seconds = 0.3;
    reader.options().max_memory_bytes = std::size_t{1} << 40;
    const auto start = Clock::now();
    expect_words(reader.error(), {"did not finish within 0.3 s", "or allow more time"});
    EXPECT_LT(seconds_since(start), 20);
  }
}

TEST(CadProcess, AnAnswerOfMoreThanTheMemoryIsCutOff) {
  FakeReader reader("yes >&3; true");
  reader.options().max_memory_bytes = current_memory_bytes() + kHelperProgramBytes + 50'000'000;
  expect_words(reader.error(ErrorKind::kLimit), {"needs more than the 0.0", "or allow more memory"});
}

TEST(CadProcess, AProcessThatTheSystemStopsIsTakenForOneWithoutMemory) {
  expect_words(FakeReader("kill -KILL $$").error(), {"the system stopped", "memory"});
}

TEST(CadProcess, IsKilledOnceTheMonitorIsCancelled) {
  const FakeReader reader("echo $$ > \"$(dirname \"$0\")/process\"; sleep 1000; true");
  Monitor monitor;
  std::thread interrupt([&] {
    while (content_of(reader.folder() / "process").find('\n') == std::string::npos)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    monitor.cancel();
  });
  try {
    reader.read(monitor);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
  }
  interrupt.join();
  EXPECT_NE(::kill(std::stoi(content_of(reader.folder() / "process")), 0), 0);
}

TEST(CadProcess, AMissingOrStrangeReaderIsNamedWithThePackagesToInstall) {
  FakeReader reader("exit 127");
  expect_words(reader.error(), {"reader.sh, cannot find libraries", "libocct-data-exchange"});
  expect_words(FakeReader("true").error(), {"does not belong to Crossgrain", kVersion});
  expect_words(FakeReader(saying("crossgrain_cad 0.0.1\n")).error(), {"does not belong to Crossgrain"});
  reader.options().cad_program = reader.folder() / "none";
  expect_words(reader.error(), {"cannot be started: No such file", "libocct-data-exchange-dev"});
  reader.options().cad_program = reader.folder() / "part.step";
  expect_words(reader.error(), {"cannot be started: Permission denied"});
}

TEST(CadProcess, StartsWithNoFilesSignalsAndChatterOfThisOne) {
  const FakeReader reader(
      "cd \"$(dirname \"$0\")\"; echo chatter; echo more >&2; ls /proc/self/fd > files; "
      "grep -e SigBlk -e SigIgn /proc/self/status > signals; " +
      saying(written(some_answer())));
  struct sigaction before;
  struct sigaction ignored {};
  ignored.sa_handler = SIG_IGN;
  ::sigaction(SIGUSR1, &ignored, &before);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  reader.read();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  ::sigaction(SIGUSR1, &before, nullptr);
  EXPECT_EQ(content_of(reader.folder() / "files"), "0\n1\n2\n3\n4\n");  // 4 is the folder that is listed
  EXPECT_EQ(content_of(reader.folder() / "signals").find_first_of("123456789abcdef", 60), std::string::npos)
      << content_of(reader.folder() / "signals");
}

TEST(CadProcess, HasTheArithmeticOfAllProcessorsWhateverThisOneHas) {
  const FakeReader reader("env > \"$(dirname \"$0\")/variables\"; " + saying(written(some_answer())));
  ::setenv("GLIBC_TUNABLES", "glibc.malloc.check=0", 1);
  ::setenv("CROSSGRAIN_TEST", "kept", 1);
  reader.read();
  ::unsetenv("GLIBC_TUNABLES");
  ::unsetenv("CROSSGRAIN_TEST");
  const std::string variables = "\n" + content_of(reader.folder() / "variables");
  EXPECT_NE(variables.find("\nGLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-FMA4\n"), std::string::npos) << variables;
  EXPECT_EQ(variables.find("glibc.malloc"), std::string::npos);
  EXPECT_NE(variables.find("\nCROSSGRAIN_TEST=kept\n"), std::string::npos);
}

TEST(CadProcess, WorksWhereThisOneDoesNotWaitForItsChildren) {
  struct sigaction before;
  struct sigaction ignored {};
  ignored.sa_handler = SIG_IGN;
  ::sigaction(SIGCHLD, &ignored, &before);
  EXPECT_EQ(FakeReader(saying(written(some_answer()))).read().triangles.size(), 4u);
  expect_words(FakeReader("kill -SEGV $$").error(), {"crashed on it"});
  ::sigaction(SIGCHLD, &before, nullptr);
}

#ifdef CROSSGRAIN_CAD_FILES

/// Overwrites some bytes, takes some out, or repeats some.
void damage(std::string& content, std::mt19937& random) {
  const std::size_t count = 1 + random() % 4;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = random() % content.size(), length = 1 + random() % 40;
    switch (random() % 4) {
      case 0:
        content[at] = static_cast<char>(random());
        break;
      case 1:
        content[at] = "0123456789.#(),$*'"[random() % 18];
        break;
      case 2:
        content.erase(at, length);
        break;
      default:
        content.insert(at, content.substr(random() % content.size(), length));
    }
  }
}

TEST(CadProcess, DamagedFilesGiveASoundSurfaceOrOneClearLineInTime) {
  const TemporaryFolder folder;
  std::mt19937 random(3);
  CadReading options;
  options.read_seconds = 2;
  for (const char* name : {"plate.step", "plate.iges", "rounded.brep", "plate.brp", "assembly.step"}) {
    const std::string sound = content_of(cad_files() / name);
    for (int trial = 0; trial < (is_nightly() ? 50 : 4); ++trial) {
      SCOPED_TRACE(fmt::format("{} {}", name, trial));
      std::string content = sound;
      damage(content, random);
      const auto start = Clock::now();
      try {
        const TriangleMesh mesh = read_surface(folder.write(name, content), options);
        EXPECT_FALSE(mesh.triangles.empty());
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kInput) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      }
      EXPECT_LT(seconds_since(start), 20);
    }
  }
}

TEST(CadProcess, TakesNoMoreMemoryThanItMay) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer takes terabytes of address space";
#endif
  CadReading options;
  options.resolution = 1'000'000;
  options.facet_angle_deg = 0.02;
  options.max_memory_bytes = current_memory_bytes() + kHelperProgramBytes + 50'000'000;
  try {
    const TriangleMesh mesh = read_surface(cad_files() / "rounded.brep", options);
    ADD_FAILURE() << mesh.triangles.size();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kLimit);
    expect_words(error.what(), {"needs more than the", "or allow more memory"});
  }
}

#endif

}  // namespace
}  // namespace crossgrain
