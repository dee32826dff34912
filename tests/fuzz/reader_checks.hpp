// SPDX-License-Identifier: Apache-2.0
// What every reader promises of any bytes whatever: to return what later code may rely on, or to throw
// Error(kInput) with one line for a person. The fuzz targets and the ordinary tests both call these.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "crossgrain/error.hpp"

namespace crossgrain {

/// A reader that did something else.
class BrokenPromise : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Gives the bytes to a reader as a file, and says whether it took them. Throws BrokenPromise, or whatever
/// else the reader may not throw.
using ReaderCheck = bool(std::string_view bytes);

/// A packed STL file, and any archive of which some members are read.
ReaderCheck check_gzip, check_zip;

/// The first part of a 3MF document, and Document.xml and, behind a byte of zero, GuiDocument.xml of FreeCAD.
/// They are packed here, since no fuzzer would find the checksums of members. OpenCASCADE is not called.
ReaderCheck check_threemf, check_freecad;

ReaderCheck check_stl, check_obj, check_ply, check_off;
ReaderCheck check_medit, check_medit_binary, check_gmsh, check_vtk, check_vtu;

/// The same formats, and .inp, read for hexahedra.
ReaderCheck check_hex_medit, check_hex_gmsh, check_hex_vtk, check_abaqus;
/// One array of a .vtu file, which is inflated here whatever the XML around it says: the first byte tells how
/// it is packed (VtuDataFlags), the others are the array.
ReaderCheck check_vtu_data;
struct VtuDataFlags {
  static constexpr unsigned kWide = 1, kSwapped = 2, kCompressed = 4, kBase64 = 8;
};
ReaderCheck check_points, check_normals, check_constraints;

/// field.vtu as it stands, and by its arrays: the number of bytes of each (two of them, little endian) and
/// these, in the order of kFieldArrays (field_checks.cpp), which the check packs as the file has them. No
/// fuzzer would find blocks of zlib.
ReaderCheck check_field, check_field_arrays;

/// onto.vtu by its arrays, in the order of kOntoArrays and, of a repaired field, kRepairedArrays.
ReaderCheck check_onto_arrays, check_repaired_arrays;

/// surface.vtu by its arrays, in the order of kSurfaceArrays.
ReaderCheck check_surface_arrays;

/// singularities.vtu by its arrays, in the order of kSingularityArrays.
ReaderCheck check_singularity_arrays;

/// streamlines.vtu by its arrays, in the order of kStreamlineArrays.
ReaderCheck check_streamline_arrays;

/// hexahedra.vtu by its arrays, in the order of kHexahedronArrays; without the last two where they are empty.
ReaderCheck check_hexahedron_arrays;
ReaderCheck check_report;

/// What is looked at in a STEP, IGES or BREP file before OpenCASCADE sees it, which is not called.
ReaderCheck check_cad;

/// What crossgrain_cad writes, which a damaged CAD file may have taken over.
ReaderCheck check_cad_answer;
ReaderCheck check_netgen_answer;

/// No file but options of `hex`, as lines of text (option_checks.cpp): hexahedra are made, or an Error of any
/// kind says why not. Takes about a second at most.
ReaderCheck check_hex_options;

struct ReaderUnderTest {
  std::string_view name;  ///< of its fuzz target, dictionary and folder of regression inputs
  ReaderCheck* check;
  bool computes = false;  ///< rather than reads: what it takes does not follow from the number of bytes
};
std::span<const ReaderUnderTest> readers_under_test();

/// The most that a reader may take at once for a file of so many bytes: nothing follows a header's claim
/// without bytes behind it. A vertex takes 24 bytes and the shortest in any format three, lists that grow
/// take twice what is in them; the rest is what tables and libraries take at first. Deflate packs by up to
/// 1032 to 1, and what comes out of archives is a text that grows.
constexpr std::size_t most_allocated_at_once(std::string_view file) {
  const bool is_packed = file.starts_with("\x1f\x8b") || file.starts_with("PK");
  return (std::size_t{1} << 18) + (is_packed ? 2 * 1032 : 64) * file.size();
}

inline void require(bool sound, const std::string& what) {
  if (!sound) throw BrokenPromise(what);
}

/// Throws BrokenPromise unless a text can be shown to a person: one printable line of bearable length.
void require_one_line(std::string_view text);

/// Whether body() runs to its end; false where it throws an Error(kInput) that can be shown.
template <class Body>
bool succeeds(const Body& body) {
  try {
    body();
    return true;
  } catch (const Error& error) {
    require(error.kind() == ErrorKind::kInput, std::string("not an input error: ") + error.what());
    require_one_line(error.what());
    return false;
  }
}

}  // namespace crossgrain
