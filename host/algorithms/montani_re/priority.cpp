#include "host/algorithms/montani_re/priority.hpp"

#include <algorithm>
#include <cstddef>

namespace sightline::algorithms::montani_re {
namespace {

// Strongly connected components of the remaining faces, after Tarjan, without recursion.
class Components {
 public:
  Components(std::uint32_t faces, std::span<const Relation> relations, const std::vector<std::uint8_t>& live)
      : first_(faces + std::size_t{1}), number_(faces), low_(faces), component_(faces, none) {
    for (std::size_t r = 0; r < relations.size(); ++r) {
      if (live[r] != 0) ++first_[relations[r].near + std::size_t{1}];
    }
    for (std::size_t f = 0; f < faces; ++f) first_[f + 1] += first_[f];
    hidden_.resize(first_.back());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::size_t r = 0; r < relations.size(); ++r) {
      if (live[r] != 0) hidden_[fill[relations[r].near]++] = relations[r].far;
    }
    for (std::uint32_t f = 0; f < faces; ++f) {
      if (number_[f] == 0) search(f);
    }
  }

  [[nodiscard]] bool together(std::uint32_t f, std::uint32_t g) const {
    return component_[f] == component_[g];
  }

 private:
  struct Visit {
    std::uint32_t face = 0;
    std::uint32_t next = 0;  // into hidden_
  };

  void enter(std::uint32_t face) {
    number_[face] = low_[face] = ++visited_;
    open_.push_back(face);
    path_.push_back({face, first_[face]});
  }

  void search(std::uint32_t start) {
    enter(start);
    while (!path_.empty()) {
      const std::uint32_t face = path_.back().face;
      if (path_.back().next < first_[face + std::size_t{1}]) {
        const std::uint32_t to = hidden_[path_.back().next++];
        if (number_[to] == 0) {
          enter(to);
        } else if (component_[to] == none) {
          low_[face] = std::min(low_[face], number_[to]);
        }
        continue;
      }
      path_.pop_back();
      if (!path_.empty()) low_[path_.back().face] = std::min(low_[path_.back().face], low_[face]);
      if (low_[face] == number_[face]) close(face);
    }
  }

  void close(std::uint32_t face) {
    std::uint32_t member = none;
    do {
      member = open_.back();
      open_.pop_back();
      component_[member] = face;
    } while (member != face);
  }

  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> hidden_;
  std::vector<std::uint32_t> number_;  // in order of visits, from 1
  std::vector<std::uint32_t> low_;
  std::vector<std::uint32_t> component_;
  std::vector<std::uint32_t> open_;
  std::vector<Visit> path_;
  std::uint32_t visited_ = 0;
};

class Table {
 public:
  Table(std::uint32_t faces, std::span<const Relation> relations)
      : faces_(faces),
        relations_(relations),
        live_(relations.size(), 1),
        minimum_(faces),
        maximum_(faces),
        first_(faces + std::size_t{1}),
        of_(2 * relations.size()) {
    for (const Relation& relation : relations) {
      ++minimum_[relation.near];
      ++maximum_[relation.far];
    }
    std::vector<std::uint32_t> fill(faces);
    for (std::uint32_t f = 0; f < faces; ++f) {
      fill[f] = first_[f];
      first_[f + std::size_t{1}] = first_[f] + minimum_[f] + maximum_[f];
    }
    for (std::uint32_t r = 0; r < relations.size(); ++r) {
      of_[fill[relations[r].near]++] = r;
      of_[fill[relations[r].far]++] = r;
    }
  }

  [[nodiscard]] bool hides_none(std::uint32_t face) const { return minimum_[face] == 0; }
  [[nodiscard]] bool hidden_by_none(std::uint32_t face) const { return maximum_[face] == 0; }

  void remove(std::uint32_t relation) {
    if (live_[relation] == 0) return;
    live_[relation] = 0;
    --minimum_[relations_[relation].near];
    --maximum_[relations_[relation].far];
  }
  void remove_face(std::uint32_t face) {
    for (std::uint32_t k = first_[face]; k < first_[face + std::size_t{1}]; ++k) remove(of_[k]);
  }

  [[nodiscard]] std::vector<std::uint32_t> on_cycles() const {
    const Components components(faces_, relations_, live_);
    std::vector<std::uint32_t> found;
    for (std::uint32_t r = 0; r < relations_.size(); ++r) {
      if (live_[r] != 0 && components.together(relations_[r].near, relations_[r].far)) found.push_back(r);
    }
    return found;
  }

 private:
  std::uint32_t faces_;
  std::span<const Relation> relations_;
  std::vector<std::uint8_t> live_;
  std::vector<std::uint32_t> minimum_;  // NMIN: number of relations "<": faces that it hides
  std::vector<std::uint32_t> maximum_;  // NMAX: number of relations ">": faces that hide it
  std::vector<std::uint32_t> first_;    // by face: index into of_
  std::vector<std::uint32_t> of_;       // relations of each face
};

}  // namespace

std::vector<PriorityClass> PriorityList::classes() const {
  std::vector<PriorityClass> all = front;
  all.insert(all.end(), back.begin(), back.end());
  return all;
}

PriorityList priority_list(std::uint32_t faces, std::span<const Relation> relations,
                           const CycleBreaker& break_cycles, const RankListener& ranked) {
  PriorityList list;
  Table table(faces, relations);
  std::vector<std::uint32_t> left(faces);
  for (std::uint32_t f = 0; f < faces; ++f) left[f] = f;
  while (!left.empty()) {
    PriorityClass front;
    PriorityClass back;
    std::vector<std::uint32_t> rest;
    for (const std::uint32_t face : left) {
      (table.hides_none(face) ? back : table.hidden_by_none(face) ? front : rest).push_back(face);
    }
    if (front.empty() && back.empty()) {
      for (const std::uint32_t relation : break_cycles(table.on_cycles())) table.remove(relation);
      continue;
    }
    for (const PriorityClass* members : {&front, &back}) {
      for (const std::uint32_t face : *members) table.remove_face(face);
    }
    if (ranked) ranked(front, back);
    if (!front.empty()) list.front.push_back(std::move(front));
    if (!back.empty()) list.back.push_back(std::move(back));
    left = std::move(rest);
  }
  std::reverse(list.back.begin(), list.back.end());
  return list;
}

}  // namespace sightline::algorithms::montani_re
