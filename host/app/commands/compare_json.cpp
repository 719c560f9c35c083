// The JSON values of compare_output.hpp.
#include <string_view>

#include "host/app/commands/compare_output.hpp"
#include "host/app/commands/skala_options.hpp"
#include "host/base/json.hpp"

namespace sightline::app {

namespace {

namespace jones = guests::jones;
using base::Json;
using compare::ComparedPicture;
using compare::ComparedRaster;
using compare::HeightComparison;
using compare::SceneComparison;
using picture::LineMetrics;
using picture::PixelMetrics;

Json reasons_json(const std::vector<std::pair<std::string, std::string>>& reasons) {
  Json list = Json::array();
  for (const auto& [name, reason] : reasons) list.push_back({{"name", name}, {"reason", reason}});
  return list;
}

Json metrics_json(const LineMetrics& m) {
  return {{"true_length", m.true_length},
          {"drawn_length", m.drawn_length},
          {"missing", m.missing},
          {"extra", m.extra},
          {"missing_share", m.share(m.missing)},
          {"extra_share", m.share(m.extra)},
          {"missing_far", m.missing_far},
          {"extra_far", m.extra_far},
          {"hausdorff", m.hausdorff.greatest},
          {"hausdorff_99_9", m.hausdorff.usual},
          {"wrong_visibility",
           {{"points", m.wrong_visibility.points},
            {"wrong", m.wrong_visibility.wrong},
            {"rate", m.wrong_visibility.rate},
            {"low", m.wrong_visibility.low},
            {"high", m.wrong_visibility.high}}},
          {"pieces_different", m.pieces_different}};
}

Json line_json(const ComparedPicture& compared) {
  Json row{{"name", compared.name}, {"measured", compared.what}};
  if (compared.identical) row["equal_to_oracle"] = *compared.identical;
  row.update(metrics_json(compared.metrics));
  return row;
}

Json points_json(const std::string& name, const PixelMetrics& m) {
  return {{"name", name},
          {"pixels", m.pixels},
          {"boundary_pixels", m.boundary_pixels},
          {"different_on_boundary", m.different_on_boundary},
          {"different_inside", m.different_inside},
          {"mismatch", m.mismatch()},
          {"boundary_mismatch", m.boundary_mismatch()},
          {"interior_mismatch", m.interior_mismatch()},
          {"lit", m.lit},
          {"missing", m.missing},
          {"extra", m.extra},
          {"missing_far", m.missing_far},
          {"extra_far", m.extra_far}};
}

}  // namespace

Json compare_json(const SceneComparison& comparison) {
  Json document{{"scene", comparison.scene},
                {"perspective", comparison.camera.perspective},
                {"eye", comparison.camera.eye},
                {"forward", comparison.camera.forward},
                {"pixels_a_unit", comparison.frame.scale},
                {"agrees", comparison.agrees()},
                {"pictures", Json::array()}};
  for (const ComparedPicture& compared : comparison.pictures)
    document["pictures"].push_back(line_json(compared));
  document["faces"] = Json::array();
  for (const compare::ComparedFaces& compared : comparison.faces) {
    Json row = points_json(compared.name, compared.metrics);
    row["not_separated"] = compared.not_solved;
    document["faces"].push_back(std::move(row));
  }
  if (comparison.guest) {
    document["guest"] = {{"identical_to_twin", comparison.guest->difference.empty()},
                         {"difference", comparison.guest->difference},
                         {"status", jones::name(comparison.guest->status)},
                         {"display_words", comparison.guest->words},
                         {"emulated_ns", comparison.guest->time.count()}};
  }
  document["not_compared"] = reasons_json(comparison.not_applicable);
  return document;
}

Json compare_json(const std::string& name, const HeightComparison& comparison) {
  Json document{{"function", name},
                {"picture", picture_name(comparison.view.picture)},
                {"rotation", comparison.view.rotation},
                {"elevation", comparison.view.elevation},
                {"agrees", comparison.agrees()},
                {"pictures", Json::array()}};
  for (const ComparedRaster& compared : comparison.rasters)
    document["pictures"].push_back(points_json(compared.name, compared.metrics));
  if (comparison.vectors) {
    document["vectors"] = {{"name", comparison.vectors->name}};
    document["vectors"].update(metrics_json(comparison.vectors->metrics));
  }
  document["guest"] = {{"identical_to_twin", comparison.agrees()},
                       {"difference", comparison.guest_difference},
                       {"t_states", comparison.guest_time.count()}};
  return document;
}

}  // namespace sightline::app
