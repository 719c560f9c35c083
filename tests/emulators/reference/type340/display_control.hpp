// Display: the IOTs of the PDP-7, and the advance of time. Included by display.hpp only.
#pragma once

#include "emulators/core/state_visitor.hpp"
#include "tests/emulators/reference/type340/display.hpp"

namespace sightline::reference_display {
using namespace type340;


template <class Sink>
void Display<Sink>::start(core::Instant now, std::uint32_t address) {
  advance(now);
  delays_.stop_all();
  writing_ = false;
  registers_.initiate(static_cast<std::uint16_t>(address & Registers::address_mask));
  pass_open_ = true;
  ++counters_.passes_started;
  counters_.previous_start = counters_.last_start;
  counters_.last_start = now;
  sink_->begin_pass(now);
  raise_request(now);
}

template <class Sink>
void Display<Sink>::clear_flags(core::Instant now) {
  advance(now);
  registers_.clear_flags();
  writing_ = false;
}

template <class Sink>
void Display<Sink>::resume(core::Instant now) {
  advance(now);
  registers_.resume();
  if (registers_.mode != Mode::character) delays_.start(Delay::settle, now + timing::settle);
}

template <class Sink>
void Display<Sink>::power_clear(core::Instant now) {
  advance(now);
  delays_.stop_all();
  writing_ = false;
  pass_open_ = false;
  Registers clear;
  clear.x = registers_.x;
  clear.y = registers_.y;
  clear.scale = registers_.scale;
  clear.intensity = registers_.intensity;
  clear.address = registers_.address;
  clear.return_address = registers_.return_address;
  registers_ = clear;
}

template <class Sink>
void Display<Sink>::deliver(core::Instant at, core::Word18 word) {
  advance(at);
  if (!registers_.request) return;
  ++counters_.words;
  input_ = word;
  word_address_ = registers_.address;
  registers_.clear_for_word();
  delays_.start(Delay::strobe, at + timing::strobe);
}

template <class Sink>
void Display<Sink>::deposited(core::Instant at) {
  advance(at);
  if (!writing_) return;
  writing_ = false;
  raise_request(at);
}

template <class Sink>
void Display<Sink>::point_light_pen(std::optional<LightPen> pen) {
  constexpr core::Duration longest = timing::pulse - core::Duration(1);
  if (pen) pen->delay = std::clamp(pen->delay, core::Duration(0), longest);
  pen_ = pen;
}

// Between a delay and its effect outside lie the fixed delays behind it, unless a flag is about to rise or fall with it.
template <class Sink>
core::Instant Display<Sink>::deadline() const {
  const auto effect = [this](Delay d, bool at_once) {
    const core::Instant t = delays_.at(d);
    return t == core::never || at_once ? t : t + timing::intensify;
  };
  const bool flag_at_strobe = registers_.stop || registers_.pen_will_stop() || delays_.runs(Delay::light);
  return std::min({effect(Delay::strobe, flag_at_strobe), effect(Delay::settle, registers_.edge()),
                   effect(Delay::intensify, true), effect(Delay::deflection, false),
                   effect(Delay::point_flash, true), effect(Delay::stroke_settle, false),
                   effect(Delay::stroke_flash, true)});
}

template <class Sink>
void Display<Sink>::catch_up(core::Instant now) {
  // So that sums of delays stay inside the clock.
  constexpr core::Instant latest = core::never - core::milliseconds(1);
  now = std::min(now, latest);
  while (!delays_.none()) {
    const Delays::Next next = delays_.next();
    if (next.at > now) return;
    delays_.stop(next.delay);
    fire(next.delay, next.at);
  }
}

template <class Sink>
void Display<Sink>::visit_state(core::StateVisitor& visit) {
  visit.part("registers", registers_);
  visit.part("delays", delays_);
  visit("input", input_);
  visit("word_address", word_address_, Registers::address_mask);
  visit("request_since", request_.since);
  visit("request_address", request_.address, Registers::address_mask);
  visit("request_write", request_.write);
  visit("request_word", request_.word);
  visit("writing", writing_);
  visit("pass_open", pass_open_);
  visit.part("path", path_);
  visit.count("stroke", stroke_, path_.size());
  visit.present("pen", pen_, [&visit](LightPen& pen) { pen.visit_state(visit); });
  visit("words", counters_.words);
  visit("passes_started", counters_.passes_started);
  visit("passes_stopped", counters_.passes_stopped);
  visit("stop_codes", counters_.stop_codes);
  visit("edges", counters_.edges);
  visit("characters_met", counters_.characters_met);
  visit("subroutines_met", counters_.subroutines_met);
  visit("last_start", counters_.last_start);
  visit("previous_start", counters_.previous_start);
  const bool draws_stroke = delays_.runs(Delay::stroke_settle) || delays_.runs(Delay::stroke_flash);
  visit.require(!draws_stroke || stroke_ < path_.size(), "stroke", "one of the character");
  visit.require(break_request() == nullptr || request_.write == writing_, "request_write", "the same as writing");
}

}  // namespace sightline::reference_display
