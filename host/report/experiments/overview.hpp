// The opening page: the question, the five methods, and the findings, one panel each. sections.cpp gives their order.
#pragma once

#include <vector>

#include "host/report/experiments/cross_check.hpp"
#include "host/report/experiments/jones_accuracy.hpp"
#include "host/report/experiments/jones_unseen.hpp"
#include "host/report/experiments/jones_views.hpp"
#include "host/report/experiments/montani_re_8080.hpp"
#include "host/report/experiments/montani_re_growth.hpp"
#include "host/report/experiments/plantinga_pdp7.hpp"
#include "host/report/experiments/plantinga_turns.hpp"
#include "host/report/experiments/skala_pictures.hpp"
#include "host/report/experiments/willis_flight.hpp"
#include "host/report/experiments/willis_order.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

void overview_question(Page& page);

void method_jones(Page& page, const JonesViews& jones);
void method_willis(Page& page, const WillisOrder& willis);
void method_montani_re(Page& page, const CrossCheck& methods);
void method_skala(Page& page, const SkalaPictures& skala);
void method_plantinga(Page& page, const CrossCheck& methods);

void finding_view_time(Page& page, const JonesViews& jones, const JonesAccuracy& accuracy);
void finding_pdp7_turn(Page& page, const std::vector<Pdp7Turn>& turns, const JonesViews& jones);
void finding_8080_stripes(Page& page, const MontaniRe8080& stripes);
void finding_flight(Page& page, const std::vector<WillisFlight>& flights);
void finding_word_length(Page& page, const JonesAccuracy& accuracy);
void finding_visibility_cost(Page& page, const SkalaPictures& skala);
void finding_growth(Page& page, const MontaniReGrowth& growth);
void finding_unseen(Page& page, const JonesViews& jones, const JonesUnseen& unseen);
void finding_normals(Page& page, const WillisOrder& willis);
void finding_events(Page& page, const PlantingaTurns& turns);
void finding_agreement(Page& page, const CrossCheck& methods);

void about(Page& page);

}  // namespace sightline::report
