// A sign is drawn on a lattice 4 or 5 units wide and 6 high.
#include "host/picture/lettering.hpp"

#include <array>

namespace sightline::picture {
namespace {

constexpr double lattice_height = 6;
constexpr int gap = 2;  // between signs

// Two characters are a point; a blank lifts the pen. The first is x; the second is y, with a to c for -1 to -3. `width`
// is the sign's width.
struct Sign {
  int width;
  std::string_view strokes;
};

// In ASCII order, from the blank.
constexpr std::array<Sign, 95> signs{{
    {2, ""},                                                // blank
    {0, "0602 00"},                                         // !
    {2, "0604 2624"},                                       // "
    {4, "1016 3036 0242 0444"},                             // #
    {4, "453616050413334241301001 272a"},                   // $
    {4, "0046 0616150506 3141403031"},                      // %
    {4, "400405162635340201102042"},                        // &
    {0, "0604"},                                            // '
    {1, "16050110"},                                        // (
    {1, "06151100"},                                        // )
    {4, "2125 0442 0244"},                                  // *
    {4, "0343 2125"},                                       // +
    {1, "110a"},                                            // ,
    {3, "0333"},                                            // -
    {0, "00"},                                              // .
    {4, "0046"},                                            // /
    {4, "103041453616050110"},                              // 0
    {4, "152620 1030"},                                     // 1
    {4, "05163645440040"},                                  // 2
    {4, "05163645443313 334241301001"},                     // 3
    {4, "30360242"},                                        // 4
    {4, "460604344341301001"},                              // 5
    {4, "36160501103041423303"},                            // 6
    {4, "064610"},                                          // 7
    {4, "133342413010010213 1304051636454433"},             // 8
    {4, "43130405163645413010"},                            // 9
    {0, "00 03"},                                           // :
    {1, "110a 13"},                                         // ;
    {4, "450341"},                                          // <
    {4, "0242 0444"},                                       // =
    {4, "054301"},                                          // >
    {4, "051636454422 20"},                                 // ?
    {4, "1214343212 324245361605011040"},                   // @
    {4, "0004264440 0242"},                                 // A
    {4, "00063645443303 3342413000"},                       // B
    {4, "4536160501103041"},                                // C
    {4, "00062644422000"},                                  // D
    {4, "46060040 0333"},                                   // E
    {4, "460600 0333"},                                     // F
    {4, "45361605011030414323"},                            // G
    {4, "0006 4046 0343"},                                  // H
    {2, "0020 0626 1016"},                                  // I
    {4, "0110304146"},                                      // J
    {4, "0006 4602 1340"},                                  // K
    {4, "060040"},                                          // L
    {4, "0006234640"},                                      // M
    {4, "00064046"},                                        // N
    {5, "104051554616050110"},                              // O, wider than 0
    {4, "00063645443303"},                                  // P
    {5, "104051554616050110 3250"},                         // Q
    {4, "00063645443303 2340"},                             // R
    {4, "453616050413334241301001"},                        // S
    {4, "0646 2620"},                                       // T
    {4, "060110304146"},                                    // U
    {4, "062046"},                                          // V
    {4, "0610233046"},                                      // W
    {4, "0046 0640"},                                       // X
    {4, "062346 2320"},                                     // Y
    {4, "06460040"},                                        // Z
    {1, "16060010"},                                        // [
    {4, "0640"},                                            // backslash
    {1, "06161000"},                                        // ]
    {4, "042644"},                                          // ^
    {4, "0a4a"},                                            // _
    {1, "0615"},                                            // `
    {3, "3324140301102031 3430"},                           // a
    {3, "0600 0314243331201001"},                           // b
    {3, "3324140301102031"},                                // c
    {3, "3630 3324140301102031"},                           // d
    {3, "02323324140301102031"},                            // e
    {3, "36261510 0424"},                                   // f
    {3, "3324140301102031 343a2b1b0a"},                     // g
    {3, "0600 0314243330"},                                 // h
    {0, "0400 0605"},                                       // i
    {1, "141a0b 1615"},                                     // j
    {3, "0600 3401 1230"},                                  // k
    {1, "060110"},                                          // l
    {4, "0400 03142320 23344340"},                          // m
    {3, "0400 0314243330"},                                 // n
    {3, "102031332414030110"},                              // o
    {3, "040b 0314243331201001"},                           // p
    {3, "343b 3324140301102031"},                           // q
    {2, "0400 031424"},                                     // r
    {3, "3414031222312000"},                                // s
    {2, "161120 0424"},                                     // t
    {3, "0401102031 3430"},                                 // u
    {4, "042044"},                                          // v
    {4, "0410223044"},                                      // w
    {3, "0430 0034"},                                       // x
    {4, "0420 441b0b"},                                     // y
    {3, "04340030"},                                        // z
    {2, "2615140312 1120 0312"},                            // {
    {0, "070b"},                                            // |
    {2, "0615142312 1100 2312"},                            // }
    {4, "03143243"},                                        // ~
}};
constexpr Sign unknown{4, "0006464000"};

constexpr const Sign& sign_of(char c) {
  return c >= ' ' && c <= '~' ? signs[static_cast<std::size_t>(c - ' ')] : unknown;
}

constexpr int height_of(char digit) {
  return digit >= 'a' ? 'a' - digit - 1 : digit - '0';
}

}  // namespace

double append_text(VectorDrawing& drawing, std::uint32_t layer, double x, double y, double height,
                   std::string_view text, TextDirection direction) {
  const double unit = height / lattice_height;
  const double across = unit * direction.x;
  const double up = unit * direction.y;
  int from = 0;
  for (const char c : text) {
    const Sign& sign = sign_of(c);
    for (std::size_t i = 0; i < sign.strokes.size(); ++i) {
      const auto first = static_cast<std::uint32_t>(drawing.points.size());
      for (; i < sign.strokes.size() && sign.strokes[i] != ' '; i += 2) {
        const int right = from + sign.strokes[i] - '0';
        const int above = height_of(sign.strokes[i + 1]);
        drawing.points.push_back({static_cast<float>(x + right * across - above * up),
                                  static_cast<float>(y + right * up + above * across)});
      }
      drawing.lines.push_back({layer, first, static_cast<std::uint32_t>(drawing.points.size()) - first});
    }
    from += sign.width + gap;
  }
  return x + text_width(height, text);
}

double text_width(double height, std::string_view text) {
  int width = text.empty() ? 0 : -gap;
  for (const char c : text) width += sign_of(c).width + gap;
  return width * height / lattice_height;
}

void append_line(VectorDrawing& drawing, std::uint32_t layer, double x0, double y0, double x1, double y1) {
  const auto first = static_cast<std::uint32_t>(drawing.points.size());
  drawing.points.push_back({static_cast<float>(x0), static_cast<float>(y0)});
  const bool dot = x0 == x1 && y0 == y1;
  if (!dot) drawing.points.push_back({static_cast<float>(x1), static_cast<float>(y1)});
  drawing.lines.push_back({layer, first, dot ? 1U : 2U});
}

}  // namespace sightline::picture
