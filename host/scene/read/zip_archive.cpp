// See zip_archive.hpp.
#include "host/scene/read/zip_archive.hpp"

#include <zip.h>

#include <utility>

#include "host/scene/read/poly_text.hpp"

namespace sightline::scene {
namespace {

constexpr std::uint64_t most_inflation = 200;       // of a mesh's text it is 5 to 30
constexpr std::uint64_t inflated_freely = 1 << 20;  // bytes

// What the error codes of libzip mean that an archive in memory can cause.
base::Error zip_error_of(const zip_error_t& error, std::string place) {
  switch (error.zip_err) {
    case ZIP_ER_COMPNOTSUPP:
      return {"", std::move(place), "found an unknown compression method", "stored or deflated", "save it again"};
    case ZIP_ER_ENCRNOTSUPP:
    case ZIP_ER_NOPASSWD:
      return {"", std::move(place), "found an encrypted file", "one without a password", "export it without a password"};
    case ZIP_ER_MULTIDISK: return {"", std::move(place), "found one volume of several", "a whole archive", "export it again"};
    case ZIP_ER_CRC: return {"", std::move(place), "found other contents than the checksum says", "", export_again};
    case ZIP_ER_MEMORY: return {"", std::move(place), "found sizes that need more memory than there is", "", export_again};
    default: break;
  }
  zip_error_t only_code;
  ::zip_error_init_with_code(&only_code, error.zip_err);
  std::string text = ::zip_error_strerror(&only_code);
  ::zip_error_fini(&only_code);
  return {"", std::move(place), "found damage: " + printable_name(std::move(text)), "a ZIP archive", export_again};
}

}  // namespace

void ZipArchive::Close::operator()(zip* archive) const { ::zip_discard(archive); }

ZipArchive::ZipArchive(zip* archive, std::uint64_t bytes) : archive_(archive), bytes_(bytes) {}

base::Result<ZipArchive> ZipArchive::open(std::string_view bytes) {
  zip_error_t error;
  ::zip_error_init(&error);
  zip_source_t* const source = ::zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* const opened = source == nullptr ? nullptr : ::zip_open_from_source(source, ZIP_RDONLY, &error);
  if (opened == nullptr) {
    if (source != nullptr) ::zip_source_free(source);
    const std::string end = "byte " + std::to_string(bytes.size());
    if (error.zip_err == ZIP_ER_NOZIP)
      return base::Error{"", end, "found the end of the file", "the directory of a ZIP archive before it", export_again};
    if (error.zip_err == ZIP_ER_INCONS)
      return base::Error{"", end, "found no entry of the ZIP directory where the end of the archive says", "one", export_again};
    return zip_error_of(error, "");
  }
  ZipArchive archive(opened, bytes.size());
  const zip_int64_t count = ::zip_get_num_entries(opened, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* const name = ::zip_get_name(opened, static_cast<zip_uint64_t>(i), 0);
    archive.names_.emplace_back(name == nullptr ? "" : name);
  }
  return archive;
}

base::Result<std::string> ZipArchive::read(std::size_t entry, std::uint64_t most) const {
  const std::string place = printable_name(names_[entry]);
  zip_stat_t said;
  if (::zip_stat_index(archive_.get(), entry, 0, &said) != 0) return zip_error_of(*::zip_get_error(archive_.get()), place);
  if (said.size > most)
    return base::Error{"", place, "found " + std::to_string(said.size) + " bytes",
                       "at most " + std::to_string(most) + " bytes of models", "export fewer parts, or as binary STL"};
  if (said.comp_size > bytes_)
    return base::Error{"", place, "found " + std::to_string(said.comp_size) + " bytes",
                       "at most the " + std::to_string(bytes_) + " of the archive", export_again};
  if (said.size > inflated_freely && said.size / most_inflation > said.comp_size)
    return base::Error{"", place, "found " + std::to_string(said.size) + " bytes compressed to " + std::to_string(said.comp_size),
                       "at most " + std::to_string(most_inflation) + " to 1",
                       "such a file is made to fill memory; save it with less compression"};
  zip_file_t* const file = ::zip_fopen_index(archive_.get(), entry, 0);
  if (file == nullptr) return zip_error_of(*::zip_get_error(archive_.get()), place);
  // One byte more than the directory says, which brings the check of the contents.
  std::string text(static_cast<std::size_t>(said.size) + 1, '\0');
  std::size_t filled = 0;
  zip_int64_t got = 1;
  while (got > 0 && filled < text.size()) {
    got = ::zip_fread(file, text.data() + filled, text.size() - filled);
    if (got > 0) filled += static_cast<std::size_t>(got);
  }
  auto result = [&]() -> base::Result<std::string> {
    if (got < 0) return zip_error_of(*::zip_file_get_error(file), place);
    if (filled != said.size)
      return base::Error{"", place, "found " + std::string(filled < said.size ? "fewer" : "more") + " bytes",
                         "the " + std::to_string(said.size) + " bytes that the ZIP directory says", export_again};
    text.pop_back();
    return std::move(text);
  }();
  ::zip_fclose(file);
  return result;
}

}  // namespace sightline::scene
