// `sightline page`: writes the page of live machines.
#include <fmt/core.h>
#include <zlib.h>

#include <memory>
#include <string>

#include "host/app/commands/commands.hpp"
#include "host/app/page_data.hpp"

namespace sightline::app {
namespace {

std::string decompress(std::span<const std::uint8_t> packed) {
  constexpr int gzip = 16;
  z_stream stream{};
  if (inflateInit2(&stream, MAX_WBITS + gzip) != Z_OK) throw base::io_error("the page cannot be decompress");
  std::string text;
  std::string block(std::size_t{1} << 20, '\0');
  stream.next_in = const_cast<Bytef*>(packed.data());
  stream.avail_in = static_cast<uInt>(packed.size());
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = static_cast<uInt>(block.size());
    state = inflate(&stream, Z_NO_FLUSH);
    text.append(block, 0, block.size() - stream.avail_out);
  }
  static_cast<void>(inflateEnd(&stream));
  if (state != Z_STREAM_END) throw base::io_error("the page cannot be decompress: this program is damaged");
  return text;
}

ExitCode write_page(const std::string& file) {
  const auto packed = packed_page();
  if (packed.empty()) {
    throw base::io_error("this program was built without the page: clang 14 and wasi-libc were not there; `tools/dev page` in the source "
                  "tree installs them and makes it");
  }
  Output output(file);
  output.write(std::string_view(decompress(packed)));
  output.commit();
  if (file != "-") print_message(fmt::format("{}: open it in a browser", file));
  return ExitCode::ok;
}

}  // namespace

void add_page_command(const Command& program) {
  const auto file = std::make_shared<std::string>("sightline.html");
  const Command command = program.add_command("page", help_page("page"));
  command.option("-o,--output", *file, "The page; - is standard output").default_value().value("FILE");
  command.run([file] { return write_page(*file); });
}

}  // namespace sightline::app
