// SPDX-License-Identifier: Apache-2.0
#include "results/field_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <exception>
#include <optional>
#include <string_view>
#include <system_error>
#include <thread>

#include "crossgrain/error.hpp"
#include "files/crc32.hpp"
#include "files/file_mark.hpp"
#include "files/folder_calls.hpp"
#include "files/input_file.hpp"
#include "results/cell_file.hpp"
#include "results/result_files.hpp"
#include "vtu/xml_tags.hpp"

namespace crossgrain {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPieceBegin = "field_", kPieceEnd = ".vtu";

std::string piece_name(int rank) {
  return fmt::format("{}{}{}", kPieceBegin, rank, kPieceEnd);
}

/// Returns whether a name is one that piece_name returns.
bool is_piece_name(std::string_view name) {
  if (!name.starts_with(kPieceBegin) || !name.ends_with(kPieceEnd)) return false;
  name.remove_prefix(kPieceBegin.size());
  if (name.size() <= kPieceEnd.size()) return false;
  name.remove_suffix(kPieceEnd.size());
  int rank = 0;
  const auto [end, failure] = std::from_chars(name.data(), name.data() + name.size(), rank);
  return failure == std::errc() && end == name.data() + name.size() && name == std::to_string(rank);
}

/// Returns what the list says of the cell data of a piece.
std::string declared(const std::vector<VtuArray>& arrays) {
  std::string text;
  for (const VtuArray& array : arrays)
    text += fmt::format("      <PDataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"/>\n",
                        vtu_name_of(array.type), array.name, array.components);
  return text;
}

/// Returns the text of the list; `cell_data` as from `declared`.
std::string list_of(const std::vector<std::string>& pieces, const std::string& cell_data,
                    const std::string& solve) {
  std::string text = fmt::format("<?xml version=\"1.0\"?>\n{}\n{}{} -->\n", kXmlMark, kXmlSolve, solve);
  text +=
      "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
      "  <PUnstructuredGrid GhostLevel=\"0\">\n"
      "    <PCellData>\n" +
      cell_data +
      "    </PCellData>\n"
      "    <PPoints>\n"
      "      <PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n"
      "    </PPoints>\n";
  for (const std::string& piece : pieces) text += fmt::format("    <Piece Source=\"{}\"/>\n", piece);
  return text + "  </PUnstructuredGrid>\n</VTKFile>\n";
}

/// Opens a folder that another host may have made just now.
Descriptor opened_soon(const fs::path& folder) {
  constexpr std::chrono::milliseconds kPatience{10000}, kPause{50};
  const auto end = std::chrono::steady_clock::now() + kPatience;
  for (;;) {
    Descriptor opened = open_folder(folder);
    if (opened.is_open()) return opened;
    const int code = errno;
    if (code != ENOENT || std::chrono::steady_clock::now() >= end)
      fail_output(folder.string(), "opened", code);
    std::this_thread::sleep_for(kPause);
  }
}

/// What the first process tells the others.
struct Order {
  std::string place, shown, solve;  ///< where pieces are written, how errors call that; SolveReport::solve
};

/// Passes the order of the first process, `mine`, to all. None: it has failed.
std::optional<Order> passed_on(Exchange& exchange, const std::optional<Order>& mine) {
  Bytes message;
  if (mine) {
    for (const std::string& text : {mine->place, mine->shown, mine->solve}) {
      const std::size_t size = text.size();
      append_to<std::size_t>(message, {&size, 1});
      append_to<char>(message, text);
    }
  }
  const Bytes told = exchange.gathered(message).front();
  if (told.empty()) return std::nullopt;
  MessageReader reader(told);
  const auto next = [&] {
    const std::vector<char> text = reader.take<char>(reader.take<std::size_t>());
    return std::string(text.begin(), text.end());
  };
  Order order;
  order.place = next();
  order.shown = next();
  order.solve = next();
  return order;
}

/// Makes a piece a file of the folder. Throws Error(kOutput) if that would replace a file of somebody else.
void expect(const std::string& piece, const OutputOptions& options, OutputFolder& output) {
  const fs::path path = fs::path(output.name()) / piece;
  if (options.foreign_files != ForeignFiles::kReplace && may_exist(path) && !has_mark(path))
    throw Error(ErrorKind::kOutput,
                {output.name(), "", fmt::format("holds '{}', which Crossgrain did not write", piece),
                 Remedy::kChooseFolder});
  output.expect(piece);
}

/// Size and CRC-32 of the piece.
using Sums = std::array<std::uint64_t, 2>;

Sums write_own_piece(const FieldData& part, const OutputOptions& options, const Order& order,
                     const Monitor& monitor) {
  const std::string name = piece_name(part.share().exchange->rank());
  const Descriptor folder = opened_soon(order.place);
  OutputFile file(folder.number(), name, (fs::path(order.shown) / name).string());
  file.set_solve(order.solve);
  write_cell_file(part, options, file, monitor);
  return {file.position(), file.crc().value()};
}

}  // namespace

std::vector<std::string> listed_pieces(const fs::path& folder) {
  const fs::path path = folder / kPiecesFile;
  std::error_code unknown;
  if (fs::status(path, unknown).type() == fs::file_type::not_found) return {};
  const InputFile file(path);
  XmlTags tags(file.bytes());
  std::vector<std::string> pieces;
  while (const auto tag = tags.next()) {
    if (tag->name != "Piece") continue;
    pieces.emplace_back(tag->attribute("Source"));
    if (!is_piece_name(pieces.back()))
      fail_input(file, {}, "names a piece " + in_quotes(pieces.back()) + ", which is no name of one",
                 Remedy::kSolveAgain);
  }
  if (pieces.empty() || tags.malformed())
    fail_input(file, {}, "is no complete list of pieces", Remedy::kCopyOrSolveAgain);
  return pieces;
}

bool is_in_pieces(const fs::path& folder) {
  std::error_code unknown;
  return fs::exists(folder / kPiecesFile, unknown);
}

std::vector<fs::path> cell_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const std::string& piece : listed_pieces(folder)) files.push_back(folder / piece);
  if (!files.empty()) return files;
  check_is_folder(folder);
  if (!may_exist(folder / kCellsFile))
    throw Error(ErrorKind::kInput,
                {folder.string(), "", fmt::format("holds no field, {} is missing", kCellsFile),
                 Remedy::kGiveFieldFolder});
  return {folder / kCellsFile};
}

std::vector<std::string> pieces_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    if (is_piece_name(name) && has_mark(entry->path())) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<ResultInventory::File> write_pieces(const FieldData& part, const OutputOptions& options,
                                                OutputFolder* output, const Monitor& monitor) {
  Exchange& exchange = *part.share().exchange;
  std::optional<Order> mine;
  if (output != nullptr) mine = Order{output->place().string(), output->name(), output->solve()};
  const std::optional<Order> order = passed_on(exchange, mine);
  if (!order) throw OtherProcessFailed();
  // A process without cells writes no piece, and may lack arrays.
  const std::string own = part.tree.size() > 0 ? declared(cell_data_arrays(part)) : "";
  const std::vector<Bytes> of_all = exchange.gathered(std::as_bytes(std::span(own)));
  std::vector<std::string> pieces;
  std::string cell_data;
  for (std::size_t rank = 0; rank < of_all.size(); ++rank) {
    if (of_all[rank].empty()) continue;
    pieces.push_back(piece_name(static_cast<int>(rank)));
    const std::vector<char> text = MessageReader(of_all[rank]).take<char>(of_all[rank].size());
    cell_data.assign(text.begin(), text.end());
  }
  std::exception_ptr failure;
  Sums own_sums{};
  try {
    if (output != nullptr)
      for (const std::string& piece : pieces) expect(piece, options, *output);
    if (part.tree.size() > 0) own_sums = write_own_piece(part, options, *order, monitor);
  } catch (const Error& error) {
    // Who interrupts does not wait for others to write their pieces.
    if (error.kind() == ErrorKind::kInterrupted) throw;
    failure = std::current_exception();
  } catch (...) {
    failure = std::current_exception();
  }
  const bool has_failed = any(exchange, failure != nullptr);
  if (failure) std::rethrow_exception(failure);
  if (has_failed) throw OtherProcessFailed();
  const std::vector<Sums> sums = gathered_value(exchange, own_sums);
  std::vector<ResultInventory::File> listed;
  if (output == nullptr) return listed;
  output->create(kPiecesFile).write(list_of(pieces, cell_data, order->solve));
  for (std::size_t rank = 0; rank < sums.size(); ++rank) {
    if (of_all[rank].empty()) continue;
    const auto [bytes, crc] = sums[rank];
    listed.push_back(
        {piece_name(static_cast<int>(rank)), bytes, Crc32::text_of(static_cast<std::uint32_t>(crc))});
  }
  return listed;
}

void cancel_pieces(const FieldData& part) {
  passed_on(*part.share().exchange, std::nullopt);
}

}  // namespace crossgrain
