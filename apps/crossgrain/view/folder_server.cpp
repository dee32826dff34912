// SPDX-License-Identifier: Apache-2.0
// The only source that includes cpp-httplib, which takes seconds to compile.
#include "view/folder_server.hpp"

#include <fmt/format.h>
#include <httplib.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "crossgrain/error.hpp"
#include "view/connection_threads.hpp"
#include "view/open_connections.hpp"
#include "view/page_name.hpp"

namespace crossgrain::app {
namespace {

constexpr const char* kAddress = "127.0.0.1";

enum Status { kRedirect = 302, kForbidden = 403, kNotFound = 404 };

/// Connections served at once; more wait. Each takes a descriptor, and another for the file that it reads.
constexpr std::size_t kMostConnections = 600;

/// The HTTP library waits by select(), which knows no higher descriptors.
constexpr rlim_t kMostDescriptors = FD_SETSIZE;

/// A connection that sends nothing for so long is closed. On one machine requests arrive within milliseconds.
constexpr time_t kSecondsOfSilence = 1;

/// The page is one file, with its script and style in it. It draws itself from what it contains: pictures as
/// data and blobs, and asks for no address.
constexpr const char* kContentSecurityPolicy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

class Connections : public httplib::TaskQueue {
 public:
  void enqueue(std::function<void()> job) override { threads_.run(std::move(job)); }
  void shutdown() override { threads_.finish(); }

 private:
  ConnectionThreads threads_{kMostConnections};
};

void limit_descriptors() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_max, kMostDescriptors);
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

std::string content_type_of(const std::filesystem::path& file) {
  constexpr std::array<std::pair<std::string_view, const char*>, 9> kTypes{
      {{".html", "text/html; charset=utf-8"},
       {".json", "application/json"},
       {".js", "text/javascript; charset=utf-8"},
       {".css", "text/css; charset=utf-8"},
       {".svg", "image/svg+xml"},
       {".png", "image/png"},
       {".wasm", "application/wasm"},
       {".vtu", "application/xml"},
       {".frames", "text/plain; charset=utf-8"}}};
  for (const auto& [extension, type] : kTypes)
    if (file.extension() == extension) return type;
  return "application/octet-stream";
}

void answer(httplib::Response& response, Status status, const std::string& text) {
  response.status = status;
  response.set_content(text + "\n", "text/plain; charset=utf-8");
}

/// Reads part of a file for the HTTP library, block by block, so that no file needs to fit into memory.
httplib::ContentProvider provider_of(const std::shared_ptr<std::ifstream>& file) {
  return [file](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
    constexpr std::size_t kBlock = std::size_t{1} << 18;
    std::string block(std::min(length, kBlock), '\0');
    file->seekg(static_cast<std::streamoff>(offset));
    file->read(block.data(), static_cast<std::streamsize>(block.size()));
    const auto count = static_cast<std::size_t>(file->gcount());
    return count > 0 && sink.write(block.data(), count);
  };
}

}  // namespace

class FolderServer::Files {
 public:
  explicit Files(const std::filesystem::path& folder) : folder_(std::filesystem::canonical(folder)) {
    limit_descriptors();
    server.set_socket_options([this](socket_t socket) {
      // The default of the library would let two servers share a port.
      const int yes = 1;
      ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
      listening_ = socket;
    });
    server.new_task_queue = [] { return new Connections; };
    server.set_read_timeout(kSecondsOfSilence);
    server.set_keep_alive_timeout(kSecondsOfSilence);
    server.set_tcp_nodelay(true);
    server.set_default_headers({{"Cache-Control", "no-store"},
                                {"X-Content-Type-Options", "nosniff"},
                                {"Content-Security-Policy", kContentSecurityPolicy},
                                {"Cross-Origin-Resource-Policy", "same-origin"}});
    server.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      if (is_for_this_machine(request)) return httplib::Server::HandlerResponse::Unhandled;
      answer(response, kForbidden, "for 127.0.0.1 and localhost only");
      return httplib::Server::HandlerResponse::Handled;
    });
    server.Get("/", [](const httplib::Request&, httplib::Response& response) {
      response.set_redirect(std::string("/") + kPageName, kRedirect);
    });
    server.Get("/([^/]+)", [this](const httplib::Request& request, httplib::Response& response) {
      connections.begin_answer(request.remote_port);
      serve_file(request.matches[1].str(), response);
    });
    server.set_logger([this](const httplib::Request& request, const httplib::Response&) {
      connections.end_answer(request.remote_port);
    });
  }

  /// Lets as many connections wait as the system allows; the library's five lose those of a burst.
  void let_connections_wait() const { ::listen(listening_, SOMAXCONN); }

  httplib::Server server;
  OpenConnections connections;
  std::atomic<bool> has_served = false;
  int port = 0;

 private:
  bool is_for_this_machine(const httplib::Request& request) const {
    if (request.get_header_value_count("Host") != 1) return false;
    const std::string host = request.get_header_value("Host");
    for (const char* name : {kAddress, "localhost"})
      if (host == fmt::format("{}:{}", name, port)) return true;
    return false;
  }

  /// Returns the path of a regular file in the folder itself; nothing for anything else.
  std::optional<std::filesystem::path> file_of(const std::string& name) const {
    if (name.empty() || name.front() == '.' || name.find_first_of(std::string_view("/\0", 2)) != name.npos)
      return std::nullopt;
    std::error_code failure;
    std::filesystem::path file = std::filesystem::canonical(folder_ / name, failure);
    if (failure || file.parent_path() != folder_ || !std::filesystem::is_regular_file(file, failure))
      return std::nullopt;
    return file;
  }

  void serve_file(const std::string& name, httplib::Response& response) const {
    const auto path = file_of(name);
    const auto file = std::make_shared<std::ifstream>();
    if (path) file->open(*path, std::ios::binary | std::ios::ate);
    if (!path || !*file) return answer(response, kNotFound, "no such file");
    const auto size = static_cast<std::size_t>(file->tellg());
    const std::string type = content_type_of(*path);
    if (size == 0) return response.set_content("", type);
    response.set_content_provider(size, type, provider_of(file));
  }

  std::filesystem::path folder_;
  socket_t listening_ = -1;
};

FolderServer::FolderServer(const std::filesystem::path& folder) : files_(std::make_unique<Files>(folder)) {}

FolderServer::~FolderServer() = default;

int FolderServer::bind(int port) {
  httplib::Server& server = files_->server;
  const bool is_bound =
      port > 0 ? server.bind_to_port(kAddress, port) : (port = server.bind_to_any_port(kAddress)) > 0;
  if (!is_bound)
    throw Error(ErrorKind::kOutput,
                {fmt::format("port {} of {}", port, kAddress), "",
                 "is in use or needs privileges; choose another with --port, or omit it"});
  files_->let_connections_wait();
  files_->connections.serve_on(port);
  return files_->port = port;
}

void FolderServer::serve() {
  files_->server.listen_after_bind();
  files_->has_served = true;
}

void FolderServer::close_slow_connections() {
  files_->connections.close_slow();
}

void FolderServer::stop() {
  constexpr std::chrono::milliseconds kInterval{1};
  // The HTTP library ignores a stop before it has started.
  while (!files_->server.is_running() && !files_->has_served) std::this_thread::sleep_for(kInterval);
  files_->server.stop();
  // It waits for its connections, which clients can hold open, and may take one more.
  while (!files_->has_served) {
    files_->connections.close_all();
    std::this_thread::sleep_for(kInterval);
  }
}

}  // namespace crossgrain::app
