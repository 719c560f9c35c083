#include "host/report/experiments/overview.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <utility>

namespace sightline::report {

namespace {

// A range as "0.06 to 0.98".
template <class T>
std::string span(const Range<T>& range, int places) {
  return fmt::format("{} to {}", text_of(range.least, places), text_of(range.greatest, places));
}

void method(Page& page, std::string id, std::string_view paper, CheckedText title, CheckedText text, Figure picture) {
  Panel panel{std::move(id), std::move(title), page.papers().paper(paper).citation(), {}, {std::move(text)}, {}};
  panel.figures.push_back(std::move(picture));
  page.add(std::move(panel));
}

const MethodPicture& picture_of(const CrossCheck& methods, std::string_view scene, std::string_view method) {
  return only(methods.pictures, [=](const MethodPicture& row) { return row.scene == scene && row.method == method; });
}

template <class Count>
double ratio(Count part, Count whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

void overview_question(Page& page) {
  page.paragraph(
      "Draw a house as lines. Seen from one place, some lines are hidden by walls, and a correct drawing leaves them out. Which "
      "lines, or which parts of them, can the eye see? Between 1971 and 1990 five papers answered this, for machines from a "
      "PDP-7 with a few thousand words of memory to the first fast workstations. Here all five methods run as new programs, "
      "written from the papers: in the languages of a PDP-7 or an 8080, on emulations of these machines, and in C++ for a computer of "
      "today.");
  page.paragraph(
      "This page asks of each: how fast is it, how accurate, and what does it need? Every figure is measured or computed when "
      "the page is made, and is shown with the paper's. Times of the PDP-7 and the 8080 are emulated seconds: they follow from "
      "the cycles of the machine and are the same in every run. A picture is correct if it equals that of an oracle: an exact "
      "program in rational numbers that shares no code with the methods.");
}

void method_jones(Page& page, const JonesViews& jones) {
  method(page, "method-jones", "jones", "Cells and portals",
         "Space is divided into convex cells, such as rooms, that are joined by portals, such as doors. The search begins in the "
         "cell of the eye. Nothing in a convex cell hides anything else in it, so its lines are drawn, cut to the outline of the "
         "portals passed so far. The search continues through each portal that is visible in this outline, and ends where none "
         "is. Cells that no line of sight reaches are never read.",
         figure(*jones.view("roberts", true).phosphor, "method-jones-roberts", "A notched block on the Type 340 display.",
                "Drawn by the emulated PDP-7.", "A notched block in glowing lines, hidden lines removed"));
}

void method_willis(Page& page, const WillisOrder& willis) {
  const WillisPicture& deepest =
      only(willis.pictures, equals(&WillisPicture::depth, greatest(willis.pictures, &WillisPicture::depth)));
  method(page, "method-willis", "willis", "Distance as priority",
         "Surfaces are ordered by the distance of one of their corners from the eye, and a display shows, at each point, the "
         "nearest in this order. That order is wrong where two surfaces are close together and long. So the model is prepared "
         "once: surfaces that come within each other's boundary are cut until distance alone decides. A frame then needs only "
         "distances and a sort.",
         figure(deepest.picture, "method-willis-order", "A town of turned houses.",
                fmt::format("Surfaces in the order of their distances, cut up to {} times.", deepest.depth),
                "Houses in greys, each face in one grey"));
}

void method_montani_re(Page& page, const CrossCheck& methods) {
  method(page, "method-montani-re", "montani_re", "Faces as stripes",
         "Each face in the image is cut into horizontal stripes, whose ends are all that is kept of it. Faces are put in "
         "priority order: each before those that it hides. Then the stripes of nearer faces are taken away from those of farther "
         "ones, by comparing ends. The thinner the stripes, the more accurate the picture and the more the work; with stripes "
         "that end at every corner it is exact.",
         figure(picture_of(methods, "C8", "montani-re (faces)").picture, "method-montani-re-faces", "A hole seen through a hole.",
                "Visible parts of faces, each in one grey.",
                "A hole in a sheet through which another sheet and its hole are seen, in greys"));
}

void method_skala(Page& page, const SkalaPictures& skala) {
  const SkalaPicture& sinc = only(skala.of("surface"), equals(&SkalaPicture::function, "sinc"));
  method(page, "method-skala", "skala", "The floating horizon",
         "A surface y = f(x, z) is drawn as slices from front to back. For each column of the screen two numbers are kept: the "
         "highest and the lowest point drawn so far. A point of the next slice is visible if it lies above the one or below the "
         "other. Bresenham's algorithm, which draws a line with additions alone, makes this test at every step, without "
         "floating-point numbers.",
         figure(sinc.raster, "method-skala-sinc", "sin r / r as a surface.", "Drawn by the emulated 8080 on 256 by 256 points.",
                "A round wave with a high peak in the middle, in seven greys"));
}

void method_plantinga(Page& page, const CrossCheck& methods) {
  method(page, "method-plantinga", "plantinga", "Events of a rotation",
         "While a scene rotates, what is visible changes only at certain angles, when a corner passes an edge or three edges "
         "meet in the image. These events are computed once for a full turn. A frame is then the frame before it, with the "
         "events between them applied: no hidden-line problem is solved while the scene rotates.",
         figure(picture_of(methods, "C5", "plantinga").picture, "method-plantinga-lines", "Three tilted boxes.",
                "The first of the views of a turn.", "Three boxes that hide parts of each other, as lines"));
}

void finding_view_time(Page& page, const JonesViews& jones, const JonesAccuracy& accuracy) {
  using View = JonesView;
  const auto all = range_of(jones.views, &View::second_view_s);
  Panel panel{"finding-view-time", "A view takes the PDP-7 " + span(all, 2) + " seconds"};
  panel.facts = {{"Here, with the EAE", span(range_of(jones.of(true), &View::second_view_s), 2) + " s"},
                 {"Here, without it", span(range_of(jones.of(false), &View::second_view_s), 2) + " s"},
                 page.paper_says("jones.order_of_seconds")};
  panel.text = {fmt::format("{} scenes on a machine whose memory cycle is {} us. ", distinct(jones.views, &View::scene),
                            text_of(jones_cycle_us(), 2)) +
                page.claim(all.greatest <= 9, "The largest scenes take seconds, as the paper says; the small ones are quicker.") +
                " The EAE (Extended Arithmetic Element) is an option that multiplies and divides. " +
                page.claim(least(accuracy.builds, &JonesBuild::eae_gain) >= 2, "It saves more than half of the time.") +
                " The paper does not say whether its machine had one."};
  Plot plot{"finding-view-time-plot",
            "Time of a view",
            "Each point is a scene.",
            "Time of a view against the lines that are cut to the outline of portals; both rise together",
            {"lines cut to portals in a view", "", false},
            {"emulated time", "s", false}};
  const auto lines = [](const View& view) { return static_cast<double>(view.lines_clipped); };
  const auto not_long = [](const View& view) { return view.scene != "corridor32"; };
  add_curves(plot, where(jones.of(false), not_long), "without EAE", lines, &View::second_view_s, {.line = false});
  add_curves(plot, where(jones.of(true), not_long), "with EAE", lines, &View::second_view_s,
             {[](const View& view) { return view.lines_clipped > 200 ? view.scene : std::string(); }, false});
  page.add_plot(panel, std::move(plot));
  page.add(std::move(panel));
}

void finding_pdp7_turn(Page& page, const std::vector<Pdp7Turn>& turns, const JonesViews& jones) {
  const auto turn = [&](std::string_view model, bool eae) -> const Pdp7Turn& {
    return only(turns, [=](const Pdp7Turn& row) { return row.model == model && row.eae == eae; });
  };
  const auto worst = [&](std::string_view model) {
    return fmt::format("{} and {} a second", text_of(turn(model, true).worst_frames_a_second, 0),
                       text_of(turn(model, false).worst_frames_a_second, 0));
  };
  Panel panel{
      "finding-pdp7-turn",
      fmt::format("On the machine of 1965: a notched block turns on the PDP-7 without hidden lines at {} frames a second",
                  text_of(turn("roberts", true).frames_a_second, 0))};
  panel.facts = {{"Notched block, slowest frame of a turn, with the EAE and without", worst("roberts")},
                 {fmt::format("Star of {} edges, slowest frame", turn("star", true).edges), worst("star")},
                 {"Time of a frame to that of a wire frame", span(range_of(turns, &Pdp7Turn::cost), 2)},
                 page.paper_says_dated("jones.motion"),
                 page.paper_says_dated("plantinga.wire")};
  panel.text = {
      fmt::format("The method of 1990 on the machine of 1965: events of a turn are found beforehand and read from paper tape; "
                  "the machine rotates the corners, applies the events and draws. Jones needed {} seconds a view, for any "
                  "movement of the eye and without preparation. ",
                  span(range_of(jones.views, &JonesView::second_view_s), 2)) +
      page.claim(greatest(where(turns, equals(&Pdp7Turn::eae, true)), &Pdp7Turn::cost) <= 1,
                 "With the EAE a frame without hidden lines takes no longer than a wire frame, since fewer lines are drawn.")};
  panel.figures.push_back(figure(*turn("star", true).screen, "finding-pdp7-turn-star", "The star, turning on the PDP-7.",
                                 "One frame, as the Type 340 drew it.",
                                 "A star of many edges in lines on a dark screen, hidden lines removed"));
  page.add(std::move(panel));
}

void finding_8080_stripes(Page& page, const MontaniRe8080& stripes) {
  const auto& scenes = stripes.scenes;
  const StripesScene& boxes = only(scenes, equals(&StripesScene::scene, "boxes-20"));
  Panel panel{"finding-8080-stripes",
              fmt::format("An 8080 with {} bytes of program fills {} faces without hidden parts in {} seconds",
                          text_of(stripes.program_bytes), text_of(boxes.faces), text_of(boxes.whole_s, 1))};
  panel.facts = {{fmt::format("Finding what is in front, {} scenes", scenes.size()),
                  span(range_of(scenes, &StripesScene::priority_s), 2) + " s"},
                 {"Stripes, differences, dots", span(range_of(scenes, &StripesScene::drawing_s), 2) + " s"},
                 {"The same stripes as lines on a plotter", span(range_of(scenes, &StripesScene::plotter_s), 0) + " s"},
                 page.paper_says("montani_re.firmware")};
  panel.text = {
      "The paper has no program. Here it is one for a machine of its time: polygons come over the link, the 8080 cuts them into "
      "stripes of a scan line, finds the priority list by the paper's six tests, and draws each face less those before it. " +
      page.claim(greatest(scenes, &StripesScene::whole_s) <= 60, "No scene takes a minute.")};
  panel.figures.push_back(figure(boxes.raster, "finding-8080-stripes-boxes", "Twenty boxes on the raster board.",
                                 fmt::format("{} faces in seven greys.", boxes.faces),
                                 "Boxes in greys on a dark screen, hidden parts removed"));
  page.add(std::move(panel));
}

void finding_flight(Page& page, const std::vector<WillisFlight>& flights) {
  using Flight = WillisFlight;
  const auto kept = where(flights, [](const Flight& flight) { return flight.bits == 8 && flight.worst_frames_a_second >= 24.9; });
  const auto rates = [&](int bits) {
    const Flight& hundred =
        only(flights, [=](const Flight& flight) { return flight.pieces == 100 && flight.bits == bits && flight.axes == 3; });
    return fmt::format("{} and {} a second", text_of(hundred.computed_a_second, 0), text_of(hundred.worst_computed_a_second, 0));
  };
  const auto wrong_percent = [&](int bits, int places) {
    const auto rows = where(flights, equals(&Flight::bits, bits));
    return text_of(100 * ratio(sum(rows, &Flight::wrong_orders), sum(rows, &Flight::pairs)), places);
  };
  Panel panel{"finding-flight",
              fmt::format("An 8080 keeps the priorities of {} surfaces in order 25 times a second",
                          text_of(greatest(kept, &Flight::pieces)))};
  panel.facts = {{"100 pieces, 8 bits, mean and worst", rates(8)},
                 {"100 pieces, 16 bits, mean and worst", rates(16)},
                 {"Pairs in a wrong order, 8 and 16 bits", fmt::format("{} and {} %", wrong_percent(8, 2), wrong_percent(16, 4))},
                 page.paper_says("willis.rate")};
  panel.text = {
      std::string("Flights through a town and between turned houses, with the priority display that the paper has in mind. The "
                  "processor computes distances, puts the surfaces in order, beginning with the order of the frame before, and "
                  "loads a priority for each; where they are on the screen comes from outside. ") +
      (greatest(flights, &Flight::wrong_points) == 0 ? "No wrong order is seen in a picture." : "")};
  const auto most = greatest(flights, &Flight::pieces);
  const Flight& longest =
      only(flights, [most](const Flight& flight) { return flight.pieces == most && flight.bits == 8 && flight.axes == 3; });
  panel.figures.push_back(figure(*longest.screen, "finding-flight-town", "A town, on the priority display.",
                                 fmt::format("One frame of a flight past {} pieces.", longest.pieces),
                                 "Buildings in greys, seen from between them"));
  page.add(std::move(panel));
}

void finding_word_length(Page& page, const JonesAccuracy& accuracy) {
  using Build = JonesBuild;
  const auto computed = [](const Build& build) { return build.computed.symmetric_per_cent(); };
  const auto displayed = [](const Build& build) { return build.displayed.symmetric_per_cent(); };
  const auto gain = [&](std::string_view scene, auto error) {
    return error(accuracy.build(scene, 0)) / error(accuracy.build(scene, 3));
  };
  const auto both = [&](auto error) {
    return fmt::format("{} and {} %", text_of(error(accuracy.build("street4", 0)), 2),
                       text_of(error(accuracy.build("street4", 3)), 2));
  };
  Panel panel{
      "finding-word-length",
      fmt::format("In street4 three fraction bits divide the error of computed lines by {}, that of lines on the screen by {}",
                  text_of(gain("street4", computed), 0), text_of(gain("street4", displayed), 1))};
  panel.facts = {{"Wrong length, computed, 0 and 3 bits", both(computed)},
                 {"On the screen, 0 and 3 bits", both(displayed)},
                 page.paper_says("jones.core")};
  panel.text = {
      "Wrong length is the length of lines that are drawn though hidden, or hidden though visible, in per cent of the visible "
      "length, over six views. Of the 18 bits of a word, the program may spend 0 to 3 on fractions of a screen point. " +
      page.claim(gain("street4", computed) > 6 && gain("house", computed) > 6,
                 "Between the computed end points each bit about halves the wrong length.") +
      " " +
      page.claim(gain("street4", displayed) < 1.1 && gain("house", displayed) < 1.1,
                 "The display draws between whole points: in these six views the gain is lost there.") +
      " The program `sightline_fraction_bits` in tests/bench measures 1,000 views of each scene; the default of 3 bits follows "
      "from them. " +
      fmt::format(
          "Of all lines that should be hidden at most {} points are seen away from a visible line. The paper gives no error.",
          text_of(greatest(accuracy.builds, [](const Build& build) { return build.displayed.extra_far; }), 2))};
  Plot plot{"finding-word-length-plot",
            "Wrong length against fraction bits",
            "Two scenes, coordinates rounded.",
            "Wrong length against fraction bits: computed end points fall steeply, the screen stays level",
            {"fraction bits", "", false},
            {"wrong length", "% of the visible"}};
  const auto drawn = where(
      accuracy.builds, [](const Build& build) { return build.rounded && (build.scene == "house" || build.scene == "street4"); });
  const auto bits = [](const Build& build) { return static_cast<double>(build.fraction_bits); };
  add_curves(plot, drawn, [](const Build& build) { return build.scene + ", computed"; }, bits, computed);
  add_curves(plot, drawn, [](const Build& build) { return build.scene + ", on the screen"; }, bits, displayed);
  page.add_plot(panel, std::move(plot));
  page.add(std::move(panel));
}

void finding_visibility_cost(Page& page, const SkalaPictures& skala) {
  using Row = SkalaPicture;
  const auto& long_slices = skala.curves;
  const auto short_slices = skala.of("lines");
  const auto cost = [](const auto& rows) { return range_of(rows, &Row::cost_percent); };
  const double paper = page.paper_figure("skala.cost").least;
  const auto here = [&](const auto& rows) {
    return fmt::format("{} %, mean {} %", span(cost(rows), 1), text_of(mean(rows, &Row::cost_percent), 1));
  };
  Panel panel{"finding-visibility-cost",
              fmt::format("Visibility costs the 8080 {} % in long slices, {} % in short ones", span(cost(long_slices), 0),
                          span(cost(short_slices), 0))};
  panel.facts = {{"Here, 30 slices of 256 points", here(long_slices)},
                 {"Here, 60 slices of 33 points, rotated", here(short_slices)},
                 page.paper_says("skala.cost")};
  // T-states of a point without the test, and those that the test adds.
  const auto plain = [](const auto& rows) { return text_of(ratio(sum(rows, &Row::plain_t_states), sum(rows, &Row::walked)), 0); };
  const auto test = [](const auto& rows) {
    return text_of(ratio(sum(rows, &Row::drawing_t_states) - sum(rows, &Row::plain_t_states), sum(rows, &Row::walked)), 0);
  };
  const Row& cosr = only(long_slices, equals(&Row::function, "cosr"));
  const auto near = count(long_slices, [paper](const Row& row) { return std::abs(*row.cost_percent() - paper) <= 1; });
  const auto surface = cost(skala.of("surface"));
  panel.text = {
      fmt::format("The cost is how much longer the same {} functions take with the test than without it. A point takes {} "
                  "T-states (cycles of the 8080's clock) without the test in long slices, which are sent point by point, and {} "
                  "in short ones, which are drawn as lines. The test adds {} and {} T-states on average.",
                  long_slices.size(), plain(long_slices), plain(short_slices), test(long_slices), test(short_slices)),
      "Why not 15 %: the cost depends on the picture. " +
          page.claim(cosr.cost_percent() == cost(long_slices).least && ratio(cosr.dots, cosr.walked) <= 0.35,
                     "A point that is hidden is not sent to the raster board, which saves more than the test costs: cosr, most "
                     "of whose points are hidden, is drawn faster with the test.") +
          fmt::format(" {} of {} functions in long slices cost within one percentage point of the paper's figure. The paper "
                      "names neither its functions nor the number of points, so its share of hidden points is not known. In "
                      "short slices a step of the drawing loop takes 74 T-states without the test and 97 or more with it "
                      "(firmware/i8080/skala/NOTES.md); a loop as short as this one cannot test for 15 %.",
                      near, long_slices.size()),
      fmt::format("Surfaces take {} to {} % less time with the test than without, because facets that are hidden are neither "
                  "shaded nor drawn. This is why `sightline skala surface` reports a visibility below zero.",
                  text_of(-surface.greatest, 0), text_of(-surface.least, 0))};
  Plot plot{"finding-visibility-cost-plot",
            "Cost of visibility",
            "Each point is a function; the line is the paper's figure.",
            "Cost of visibility against the share of points that are hidden: the more are hidden, the less it costs",
            {"points that are hidden", "%", false},
            {"cost of visibility", "%", false}};
  const CurveParts<Row> points{
      [](const Row& row) { return row.function == "cosr" || row.function == "saddle" ? row.function : std::string(); }, false};
  add_curves(plot, long_slices, "long slices", &Row::hidden_percent, &Row::cost_percent, points);
  add_curves(plot, short_slices, "short slices", &Row::hidden_percent, &Row::cost_percent, points);
  add_curves(plot, long_slices, "the paper", &Row::hidden_percent, [paper](const Row&) { return paper; }, {.marks = false});
  page.add_plot(panel, std::move(plot));
  page.add(std::move(panel));
}

void finding_growth(Page& page, const MontaniReGrowth& growth) {
  using View = GrowthView;
  const auto pairs = range_of(growth.exponents, &GrowthExponents::pairs);
  const auto faces = range_of(growth.views, &View::faces);
  Panel panel{"finding-growth",
              "Pairs of faces to be compared grow as the number of faces to the power " + span(pairs, 1)};
  panel.facts = {
      {"Exponent of pairs to be compared", span(pairs, 2)},
      {"Exponent of pairs, one of which hides the other", span(range_of(growth.exponents, &GrowthExponents::relations), 2)},
      page.paper_says("montani_re.linear")};
  panel.text = {
      "Montani and Re compare each face with those that overlap it in one direction. An exponent of 1 is linear growth, 2 means "
      "that twice the faces take four times the work. " +
      page.claim(pairs.least > 1.1,
                 "In these scenes each face overlaps more others as the scene grows, so that the work is not linear.")};
  if (page.host_times()) {
    const auto time = range_of(growth.exponents, &GrowthExponents::exact_build_over_pairs);
    panel.text.push_back("The time of the exact program grows as the number of pairs to the power " + span(time, 2) + ". " +
                         page.claim(time.greatest <= 1.1, "That is no faster than the paper's other claim, time linear with the "
                                                          "product of faces and overlaps."));
  }
  Plot plot{"finding-growth-plot",
            "Work against the size of the scene",
            fmt::format("Scenes of {} to {} faces.", text_of(faces.least), text_of(faces.greatest)),
            "Pairs of faces against the number of faces, both logarithmic: straight lines steeper than linear",
            {"faces"},
            {"pairs of faces"}};
  const auto of_faces = [](const View& view) { return static_cast<double>(view.faces); };
  add_curves(plot, growth.views, [](const View& view) { return view.family + ": to be compared"; }, of_faces,
             [](const View& view) { return static_cast<double>(view.pairs); });
  add_curves(plot, growth.views, [](const View& view) { return view.family + ": one hides the other"; }, of_faces,
             [](const View& view) { return static_cast<double>(view.relations); });
  page.add_plot(panel, std::move(plot));
  page.add(std::move(panel));
}

void finding_unseen(Page& page, const JonesViews& jones, const JonesUnseen& unseen) {
  using Building = JonesBuilding;
  const auto& buildings = unseen.buildings;
  const auto rooms = range_of(buildings, &Building::all_rooms);
  const auto corridor = [&](std::string_view scene) {
    const JonesCorridor& row = only(jones.corridors, [=](const JonesCorridor& c) { return c.scene == scene && c.eae; });
    return std::pair(fmt::format("Corridor of {} cells, emulated", row.cells), text_of(row.view_s, 4) + " s");
  };
  Panel panel{"finding-unseen",
              page.claim(jones.unseen_rooms_cost_nothing(), "Invisible cells cost nothing:") +
                  fmt::format(" a view in {} rooms enters {} cells", text_of(rooms.greatest), text_of(buildings.back().visits, 0))};
  panel.facts = {corridor("corridor8"), corridor("corridor32"), page.paper_says("jones.never_considered")};
  const auto used = range_of(jones.views, &JonesView::used_words);
  panel.text = {
      page.claim(
          jones.unseen_rooms_cost_nothing(),
          "On the PDP-7 cells that no line of sight reaches cost no instructions; they only occupy core memory.") +
          fmt::format(
              " The native program does the same: from {} to {} rooms the cells entered in a view stay between {} and {}.",
              text_of(rooms.least), text_of(rooms.greatest), text_of(least(buildings, &Building::visits), 0),
              text_of(greatest(buildings, &Building::visits), 0)),
      fmt::format("The same holds for equipment. The programs use {} to {} of the {} words of core memory, and a device that a "
                  "program does not use is not emulated and takes no time.",
                  text_of(used.least), text_of(used.greatest), text_of(page.paper_figure("jones.core").greatest, 0))};
  Plot plot{"finding-unseen-plot",
            "Cells of a building, and cells entered in a view",
            "Mean of up to 256 views from inside.",
            "Cells of a building rise with the rooms, cells entered stay the same",
            {"rooms"},
            {"cells"}};
  const auto all_rooms = [](const Building& building) { return static_cast<double>(building.all_rooms); };
  add_curves(plot, buildings, "in the building", all_rooms,
             [](const Building& building) { return static_cast<double>(building.cells); });
  add_curves(plot, buildings, "entered in a view", all_rooms, &Building::visits);
  page.add_plot(panel, std::move(plot));
  page.add(std::move(panel));
}

void finding_normals(Page& page, const WillisOrder& willis) {
  using Model = WillisModel;
  const auto over = sum(willis.normals, &WillisNormals::pairs_over_90);
  Panel panel{"finding-normals",
              page.claim(over > 0, "One of Willis's rules is wrong:") +
                  fmt::format(" {} of {} pairs of surfaces contradict it", text_of(over),
                              text_of(sum(willis.normals, &WillisNormals::pairs)))};
  panel.facts = {{"Greatest angle here, one surface hiding the other",
                  text_of(greatest(willis.normals, &WillisNormals::greatest_degrees), 0) + " degrees"},
                 page.paper_says("willis.normals")};
  // Wrong lines in models in which no pair is left over.
  const auto wrong = [&](bool rule) {
    return sum(where(willis.models, [rule](const Model& model) { return model.left_over == 0 && model.rule90 == rule; }),
               &Model::lines_wrong);
  };
  panel.text = {
      page.claim(wrong(false) == 0, "The method itself is right: once no two surfaces lie in each other's boundary, distance "
                                    "orders all of them correctly.") +
      " " +
      page.claim(wrong(true) > 0, "With the rule, some pairs that need a cut are left alone, and some sight lines meet surfaces "
                                  "in the wrong order however often surfaces are cut.") +
      " A sight line here is one that meets two or more surfaces."};
  const std::string& first = willis.models.front().scene;
  Plot plot{"finding-normals-plot",
            "Sight lines in the wrong order",
            first + ": houses with turned walls.",
            "Sight lines in the wrong order against cuts: without the rule they fall to none, with it some stay",
            {"surfaces are cut up to so many times", "", false},
            {"sight lines in the wrong order", "%"}};
  for (const bool rule : {false, true})
    add_curves(
        plot,
        where(willis.models,
              [&](const Model& model) { return model.scene == first && model.boundary == "ball" && model.rule90 == rule; }),
        rule ? "with the rule" : "without the rule", [](const Model& model) { return static_cast<double>(model.depth); },
        &Model::lines_wrong_percent);
  page.add_plot(panel, std::move(plot));
  page.add(std::move(panel));
}

void finding_events(Page& page, const PlantingaTurns& turns) {
  using Model = TurnModel;
  const auto& models = turns.models;
  const std::string per_edge = span(range_of(models, &Model::per_edge), 1);
  const double paper = page.paper_figure("plantinga.events_per_edge").least;
  Panel panel{"finding-events", "A rotation needs " + per_edge + " events for each edge"};
  panel.facts = {{fmt::format("Here, {} models", models.size()), per_edge + " events for each edge"},
                 page.paper_says("plantinga.events_per_edge")};
  panel.text = {fmt::format("An event is an angle at which the visible part of an edge changes its ends. {} of {} models need "
                            "more than the paper's figure. The paper does not give the coordinates of its models; those here "
                            "have the same numbers of vertices, edges and faces.",
                            count(models, [paper](const Model& model) { return model.per_edge >= paper; }), models.size())};
  if (page.host_times())
    panel.text.push_back(fmt::format(
        "A frame as fast as a wire frame, the paper's aim, holds when each line is then drawn pixel by pixel ({} times the wire "
        "frame's time on this computer), since fewer lines are drawn; positions alone take {} times as long.",
        span(range_of(turns.frames, &TurnFrames::ratio_drawn), 1), span(range_of(turns.frames, &TurnFrames::ratio), 1)));
  Plot plot{"finding-events-plot",
            "Events of a full turn",
            "The paper's Table 1 and the models here.",
            "Events against edges, as printed and as found here, of the same order",
            {"edges"},
            {"events"}};
  const PrintedTable& printed = page.papers().table("plantinga_table_1");
  Curve& of_paper = plot.curves.emplace_back(Curve{"printed", {}, false, true});
  for (std::size_t row = 0; row < printed.rows.size(); ++row)
    of_paper.points.push_back({printed.number(row, "edges"), printed.number(row, "events"), printed.text(row, "model")});
  add_curves(plot, models, "here", [](const Model& model) { return static_cast<double>(model.edges); },
             [](const Model& model) { return static_cast<double>(model.events); }, {.line = false});
  page.add_plot(panel, std::move(plot));
  page.add(std::move(panel));
}

void finding_agreement(Page& page, const CrossCheck& methods) {
  const std::string run = text_of(methods.run());
  Panel panel{"finding-agreement",
              methods.agrees() ? fmt::format("All {} comparisons of two methods on a scene agree", run)
                               : fmt::format("{} comparisons of methods do not agree", methods.failures.size())};
  panel.facts = {{"Scenes", text_of(methods.scenes.size())}, {"Comparisons", run}, {"Differences", text_of(methods.failures.size())}};
  panel.text = {
      "The methods solve the same problem in different ways. Exact methods must give the same pieces of the same edges; "
      "methods that give faces must show the same face at every pixel away from edges. The picture shows one scene by each "
      "method."};
  for (const MethodPicture& row : where(methods.pictures, equals(&MethodPicture::scene, "C5")))
    panel.figures.push_back(
        figure(row.picture, "finding-agreement-" + row.id, row.method, "", "Three tilted boxes by " + row.method));
  page.add(std::move(panel));
}

void about(Page& page) {
  page.paragraph(
      "Emulated seconds follow from machine cycles: 1.75 us for the PDP-7, T-states of a third of a microsecond for the 8080 "
      "at 3 MHz. Times of this computer are medians of repetitions that alternate between the compared programs; they differ "
      "from run to run. `sightline report --part N` makes the chapters of one kind: 1 timing against the papers, 2 accuracy "
      "against time, 3 hard cases, 4 resource usage, 5 cross-check. `--no-host-times` leaves out all times of this computer, "
      "and gives the same bytes in every run.");
  page.paragraph(
      "A guest is a program on its emulated machine. Its twin is the same program in C++, which gives the same bits. A "
      "native program solves the same problem by the paper's method without the machine's limits. An oracle is an exact program "
      "that shares no code with any of them.");
}

}  // namespace sightline::report
