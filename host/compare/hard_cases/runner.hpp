// Runs one hard case by any method: algorithms of the registries, programs on their machines, their twins, the
// oracles. Every result is compared with the baseline and with the expectation of the case.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/picture/image.hpp"
#include "host/picture/line_picture.hpp"
#include "host/compare/hard_cases/case_input.hpp"
#include "host/compare/hard_cases/manifest.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

struct Finding {
  std::optional<bool> good;  // empty: the method does not apply
  std::string text;
  // If requested, images of the first view: of the method's result, and of the correct result if no method gives it.
  std::optional<picture::Image> image = {};
  std::optional<picture::Image> truth = {};
};

// Whether a method of this name can run some input.
[[nodiscard]] bool is_method(std::string_view name);

class CaseRun {
 public:
  CaseRun(HardCase hard, base::Result<CaseInput, std::string> input)
      : hard_(std::move(hard)), input_(std::move(input)) {}

  // Programs are then judged by their own report only, without a picture.
  void disable_pictures() { pictures_ = false; }
  // Findings then have images, `side` pixels a side; dots are one pixel each.
  void enable_images(int side) { image_side_ = side; }
  // `options` replace those of the case.
  [[nodiscard]] Finding run(std::string_view method, const MethodOptions& options);
  [[nodiscard]] Finding run(std::string_view method) { return run(method, hard_.options); }

  [[nodiscard]] const HardCase& hard() const { return hard_; }
  [[nodiscard]] const CaseInput& input() const { return *input_; }

 private:
  [[nodiscard]] std::vector<scene::PolyCamera> cameras() const;
  [[nodiscard]] Finding judge(std::string_view method, const MethodOptions& options);
  // The picture of the case's baseline, from the camera with this number.
  [[nodiscard]] const picture::LinePicture& baseline(std::size_t camera);

  [[nodiscard]] Finding run_lines(std::string_view method, const MethodOptions& options);
  [[nodiscard]] Finding run_ordered_faces(const MethodOptions& options);
  [[nodiscard]] Finding run_stripes(const MethodOptions& options);
  [[nodiscard]] Finding run_cell_program(std::string_view method, const MethodOptions& options);
  [[nodiscard]] Finding run_heights(std::string_view method, const MethodOptions& options);
  [[nodiscard]] Finding run_commands(std::string_view method);

  HardCase hard_;
  base::Result<CaseInput, std::string> input_;
  // Stores the image that `draw` returns, if images are requested.
  template <class Draw>
  void keep_image(std::optional<picture::Image>& image, Draw draw) {
    if (image_side_ > 0 && !image) image = draw();
  }

  bool pictures_ = true;
  int image_side_ = 0;  // 0: no images
  std::optional<picture::Image> image_;  // of the current finding
  std::optional<picture::Image> truth_;
  std::vector<std::optional<picture::LinePicture>> baselines_;
};

// How much of a line of the scene is covered by visible pieces of edges that lie on it; decided exactly.
enum class SegmentSeen { whole, in_part, nothing };
[[nodiscard]] SegmentSeen seen_of(const SceneSegment& segment, const picture::LinePicture& picture,
                                  const scene::PolyScene& scene);

}  // namespace sightline::compare
