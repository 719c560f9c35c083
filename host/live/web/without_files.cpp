// Replaces files, folders, libpng and the readers of glTF and 3MF in the WebAssembly module: these functions return errors or nothing. The headers that declare
// them describe them.
#include "host/base/file.hpp"
#include "host/machines/cpm_files.hpp"
#include "host/picture/apng.hpp"
#include "host/picture/png.hpp"
#include "host/scene/read/gltf.hpp"
#include "host/scene/read/three_mf.hpp"

namespace sightline::base {

FileStatus file_status(const std::string&) { return {}; }

Result<Bytes> read_file(const std::string& path, std::size_t) {
  return Error{path, "", "no files here", "a file dropped on the page"};
}

Result<std::string> read_text(const std::string& path, std::size_t) {
  return Error{path, "", "no files here", "a file dropped on the page"};
}

}  // namespace sightline::base

namespace sightline::scene {

base::Result<PolyMesh> read_gltf(std::string_view, std::string_view source, const std::string&) {
  return base::Error{std::string(source), "", "found glTF, which the page does not read", "STL, PLY, OFF, OBJ or JSON", "export the mesh as STL, PLY or OBJ"};
}

base::Result<PolyMesh> read_glb(std::string_view bytes, std::string_view source, const std::string& folder) {
  return read_gltf(bytes, source, folder);
}

base::Result<PolyMesh> read_three_mf(std::string_view, std::string_view source) {
  return base::Error{std::string(source), "", "found 3MF, which the page does not read", "STL, PLY, OFF, OBJ or JSON", "export the mesh as STL, PLY or OBJ"};
}

}  // namespace sightline::scene

namespace sightline::picture {

base::Result<base::Bytes> encode_png(const Image&, const TextEntries&, double) {
  return base::bad_input("no PNG files are written here; the page saves its own pictures");
}

// Its private fields are used only with libpng.
#pragma clang diagnostic ignored "-Wunused-private-field"
ApngWriter::ApngWriter(FrameTime time, std::uint32_t plays, TextEntries text)
    : time_(time), plays_(plays), text_(std::move(text)) {}
base::Result<base::Done> ApngWriter::add(const Image&, FrameTime) { return base::bad_input("no movies are written here"); }
base::Result<base::Bytes> ApngWriter::finish() const { return base::bad_input("no movies are written here"); }

}  // namespace sightline::picture

namespace sightline::machines {

base::Result<CpmDrive> parse_cpm_drive(std::string_view) {
  return base::Error{"--cpm-drive", "", "found a folder", "none: a page has no folders"};
}

struct CpmFiles::Host {};
CpmFiles::CpmFiles(const std::vector<CpmDrive>&, std::uint8_t user) { state_.user = user; }
CpmFiles::~CpmFiles() = default;
bool CpmFiles::has_drives() const { return false; }
void CpmFiles::restart(std::uint8_t) {}
CpmFiles::Load CpmFiles::load(unsigned, std::string_view, std::size_t, std::span<std::uint8_t>) { return Load::no_drive; }
std::string CpmFiles::file_of(std::uint16_t, std::span<std::uint8_t>) const { return {}; }
CpmFiles::Answer CpmFiles::call(std::uint8_t function, std::uint16_t, std::span<std::uint8_t>) {
  return {function == version ? std::uint16_t{0x0022} : std::uint16_t{0}};
}

}  // namespace sightline::machines

// Debian's runtime library for wasm32 is compiled with stack protection, but does not define its symbols.
extern "C" {
std::uintptr_t __stack_chk_guard = 0x5349474C;
void __stack_chk_fail() { __builtin_trap(); }
}
