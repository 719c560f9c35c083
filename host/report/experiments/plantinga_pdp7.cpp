#include "host/report/experiments/plantinga_pdp7.hpp"

#include <fmt/core.h>

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/base/value_of.hpp"
#include "host/programs/turn/turn.hpp"
#include "host/picture/raster_image.hpp"
#include "host/report/experiments/png_picture.hpp"
#include "host/report/page.hpp"
#include "host/scene/read/load.hpp"

namespace sightline::report {

// The embedded files.
std::span<const std::pair<std::string_view, std::string_view>> turn_model_files();

namespace {

namespace turn = programs::turn;

turn::Tape tape_of(scene::SceneFile file) {
  const std::string name = file.name;
  const auto loaded = scene::load_scene(std::move(file));
  if (!loaded) throw base::bad_input(loaded.error().message());
  auto tape = turn::make_tape(loaded->scene, turn::Memory::words_8k);
  if (!tape) throw base::bad_input(fmt::format("{}: {}", name, tape.error().message()));
  return std::move(*tape);
}

// The notched block of Jones's views, which the README turns, and the embedded files.
std::vector<scene::SceneFile> models() {
  std::vector<scene::SceneFile> files;
  if (auto built_in = scene::named_scene("roberts"); built_in && *built_in) files.push_back(std::move(**built_in));
  for (const auto& [file, text] : turn_model_files()) files.push_back({std::string(file), std::string(text)});
  return files;
}

}  // namespace

std::vector<Pdp7Turn> plantinga_pdp7(const Context& context) {
  std::vector<Pdp7Turn> turns;
  for (const scene::SceneFile& file : models()) {
    const std::string model = file.name.substr(0, file.name.rfind('.'));
    context.progress(fmt::format("{} turning on the PDP-7", model));
    const turn::Tape tape = tape_of(file);
    for (const bool eae : {true, false}) {
      const turn::Order order{.eae = eae, .strokes = eae, .check = true};
      const turn::Outcome outcome = base::value_of(turn::run(tape, order), model);
      const turn::Summary& hidden = outcome.hidden.summary;
      Pdp7Turn& row = turns.emplace_back();
      row.model = model;
      row.eae = eae;
      row.edges = tape.edges;
      row.events = tape.events;
      row.used_words = outcome.core_words;
      row.turn_s = outcome.turn_seconds();
      row.frames_a_second = hidden.frames_per_second_mean;
      row.worst_frames_a_second = hidden.frames_per_second_worst;
      row.wire_frames_a_second = outcome.wire.summary.frames_per_second_mean;
      row.cost = outcome.cost_against_wire_frame();
      row.junctions = hidden.junctions_mean;
      row.waiting_percent = 100 * hidden.waiting_fraction;
      row.refreshes_a_second = hidden.refreshes_per_second;
      if (eae) row.screen = png_picture(picture::crisp_raster(outcome.hidden.shown[outcome.hidden.shown.size() / 8].strokes));
    }
  }
  return turns;
}

void plantinga_pdp7_chapter(Page& page, const std::vector<Pdp7Turn>& turns) {
  const auto with_eae = where(turns, &Pdp7Turn::eae);
  page.table("plantinga-pdp7-turns",
             "On the machine of 1965: solids turning with hidden lines removed on a PDP-7 with a Type 340", turns,
             {{"model", "Model", &Pdp7Turn::model},
              {"eae", "EAE", &Pdp7Turn::eae},
              {"edges", "Edges", &Pdp7Turn::edges},
              {"events", "Events", "different angles in a turn", &Pdp7Turn::events},
              {"used_words", "Core", "words of 8192", &Pdp7Turn::used_words},
              {"turn_s", "One turn", "emulated s", &Pdp7Turn::turn_s, 2},
              {"frames_a_second", "Frames a second", "mean of the turn", &Pdp7Turn::frames_a_second, 1},
              {"worst_frames_a_second", "Frames a second", "slowest of the turn", &Pdp7Turn::worst_frames_a_second, 1},
              {"wire_frames_a_second", "Wire frames a second", "mean", &Pdp7Turn::wire_frames_a_second, 1},
              {"cost", "Cost", "time of a frame to that of a wire frame", &Pdp7Turn::cost, 2},
              {"junctions", "T-junctions", "drawn, mean of a frame", &Pdp7Turn::junctions, 1},
              {"waiting_percent", "Waiting for the display", "%", &Pdp7Turn::waiting_percent, 1},
              {"refreshes_a_second", "Refreshes a second", &Pdp7Turn::refreshes_a_second, 1}},
             {.notes = {"A program of today computes the events of a turn and punches them on paper tape with the model. The "
                        "PDP-7 then rotates the corners, applies the events and draws. Every display word is compared with "
                        "that of a native program written from the same specification (`firmware/pdp7/turn`). Times are "
                        "emulated seconds and include the display's refreshing and waiting for it.",
                        fmt::format("{} {}",
                                    least(with_eae, &Pdp7Turn::worst_frames_a_second) >= 20
                                        ? "With the EAE no frame of these solids takes longer than a twentieth of a second."
                                        : "",
                                    greatest(with_eae, &Pdp7Turn::cost) <= 1
                                        ? "With it a frame without hidden lines is no slower than a wire frame: fewer lines are "
                                          "drawn, and that saves more than the events cost."
                                        : "")}});
  const std::size_t slow = count(turns, [](const Pdp7Turn& t) { return t.cost > 1.5; });
  page.claims(
      "plantinga-pdp7-claims", "Two sentences, on the PDP-7",
      {{.claim = "plantinga.wire",
        .here = least_and_greatest(turns, &Pdp7Turn::cost),
        .places = 2,
        .condition =
            fmt::format("time of a frame without hidden lines to that of a wire frame, {} solids, with the EAE and without",
                        distinct(turns, &Pdp7Turn::model)),
        .comparison = slow == 0 ? "the claim holds on this machine"
                                : fmt::format("the claim does not hold for {} of {} rows (limit 1.5 times)", slow, turns.size())},
       {.claim = "jones.frames",
        .here = least_and_greatest(turns, &Pdp7Turn::worst_frames_a_second),
        .places = 1,
        .condition =
            "worst frame of a turn about one axis, events found beforehand; Jones meant any movement, without preparation",
        .comparison = fmt::format("{} of {} rows reach sixteen frames a second in every frame",
                                  count(turns, [](const Pdp7Turn& t) { return t.worst_frames_a_second >= 16; }), turns.size())}});
  page.gallery("plantinga-pdp7-pictures", "A frame of each turn", with_eae, [](const Pdp7Turn& t) {
    return figure(*t.screen, "plantinga-pdp7-" + t.model, t.model + ", turning on the PDP-7.",
                  "An eighth of a turn after the beginning, as the Type 340 drew it.",
                  "A solid in lines on a dark screen, hidden lines removed");
  });
}

}  // namespace sightline::report
