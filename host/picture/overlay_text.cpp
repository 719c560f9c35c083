// See overlay_text.hpp. A sign is drawn on a lattice 4 wide and 6 high; in the table, two digits are a point
// and a blank lifts the pen.
#include "host/picture/overlay_text.hpp"

#include <array>

namespace sightline::picture {
namespace {

constexpr double lattice_height = 6;
constexpr double advance = 6;

constexpr std::array<std::string_view, 26> letters{
    "0004264440 0242",
    "00063645443303 3342413000",
    "4536160501103041",
    "00062644422000",
    "46060040 0333",
    "460600 0333",
    "45361605011030414323",
    "0006 4046 0343",
    "1030 1636 2026",
    "0110304146",
    "0006 4602 1340",
    "060040",
    "0006234640",
    "00064046",
    "103041453616050110",
    "00063645443303",
    "103041453616050110 2240",
    "00063645443303 2340",
    "453616050413334241301001",
    "0646 2620",
    "060110304146",
    "062046",
    "0610233046",
    "0046 0640",
    "062346 2320",
    "06460040",
};

constexpr std::array<std::string_view, 10> digits{
    "103041453616050110 1135",     "152620 1030", "05163645440040",
    "05163645443313 334241301001", "30360242",    "460604344341301001",
    "36160501103041423303",        "064610",      "133342413010010213 1304051636454433",
    "43130405163645413010",
};

constexpr std::string_view sign_of(char c) {
  if (c >= 'a' && c <= 'z') return letters[static_cast<std::size_t>(c - 'a')];
  if (c >= 'A' && c <= 'Z') return letters[static_cast<std::size_t>(c - 'A')];
  if (c >= '0' && c <= '9') return digits[static_cast<std::size_t>(c - '0')];
  switch (c) {
    case ' ': return "";
    case '.': return "20";
    case ',': return "2110";
    case '-': return "1333";
    case '+': return "0343 2125";
    case '%': return "0046 0616150506 3141403031";
    case '(': return "36252130";
    case ')': return "16252110";
    case '/': return "0046";
    case ':': return "22 24";
    case ';': return "2110 24";
    case '=': return "0242 0444";
    case '_': return "0040";
    case '<': return "450341";
    case '>': return "054301";
    case '\'': return "2624";
    default: return "0006464000";
  }
}

}  // namespace

double append_text(VectorDrawing& drawing, std::uint32_t layer, double x, double y, double height,
                   std::string_view text) {
  const double unit = height / lattice_height;
  for (const char c : text) {
    const std::string_view sign = sign_of(c);
    for (std::size_t i = 0; i < sign.size(); ++i) {
      const auto first = static_cast<std::uint32_t>(drawing.points.size());
      for (; i < sign.size() && sign[i] != ' '; i += 2) {
        drawing.points.push_back({static_cast<float>(x + unit * (sign[i] - '0')),
                                  static_cast<float>(y + unit * (sign[i + 1] - '0'))});
      }
      drawing.lines.push_back({layer, first, static_cast<std::uint32_t>(drawing.points.size()) - first});
    }
    x += advance * unit;
  }
  return x;
}

double text_width(double height, std::string_view text) {
  return static_cast<double>(text.size()) * advance * height / lattice_height;
}

void append_line(VectorDrawing& drawing, std::uint32_t layer, double x0, double y0, double x1, double y1) {
  const auto first = static_cast<std::uint32_t>(drawing.points.size());
  drawing.points.push_back({static_cast<float>(x0), static_cast<float>(y0)});
  const bool dot = x0 == x1 && y0 == y1;
  if (!dot) drawing.points.push_back({static_cast<float>(x1), static_cast<float>(y1)});
  drawing.lines.push_back({layer, first, dot ? 1U : 2U});
}

}  // namespace sightline::picture
