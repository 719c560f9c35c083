// The contents of the report: sections, their chapters, and the experiments whose data the chapters show.
//
// A chapter is a function of a Page and of the data of experiments; its parameters select the experiments that are
// run for it. Chapters with the same data share one run. sections.cpp lists them all.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <typeindex>
#include <utility>
#include <vector>

#include "host/report/experiment.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

// The data of finished experiments, by their types.
class Results {
 public:
  // Throws std::logic_error if the experiment was not run.
  template <class Data>
  [[nodiscard]] const Data& of() const {
    return *static_cast<const Data*>(find(typeid(Data)));
  }
  void store(std::type_index type, std::shared_ptr<void> data) { data_[type] = std::move(data); }

 private:
  [[nodiscard]] const void* find(std::type_index type) const;
  std::map<std::type_index, std::shared_ptr<void>> data_;
};

struct Experiment {
  std::type_index gives;
  std::function<std::shared_ptr<void>(const Context&)> run;
  bool host_times;  // measures times of this computer only: runs alone
};

template <class Data>
Experiment experiment(Data (*run)(const Context&), bool host_times = false) {
  return {typeid(Data), [run](const Context& context) { return std::make_shared<Data>(run(context)); }, host_times};
}
// For experiments that leave times to Context::when_alone: the data keep their address.
template <class Data>
Experiment experiment(void (*run)(const Context&, Data&)) {
  return {typeid(Data),
          [run](const Context& context) {
            const auto data = std::make_shared<Data>();
            run(context, *data);
            return data;
          },
          false};
}

struct Chapter {
  std::string id;
  int part;  // 0: none; in the whole report only
  std::vector<std::type_index> takes;
  std::function<void(Page&, const Results&)> write;
};

template <class... Data>
Chapter chapter(std::string id, int part, void (*write)(Page&, const Data&...)) {
  return {std::move(id), part, {typeid(Data)...}, [write](Page& page, const Results& results) {
            write(page, results.of<Data>()...);
          }};
}

// A kind of chapters, which users request by its number.
struct Part {
  int number;
  std::string title;
};

// A section of the page.
struct SectionPlan {
  std::string id;
  std::string title;
  std::string paper;  // of papers.json; empty: none
  std::vector<Chapter> chapters;
};

// Ascending.
[[nodiscard]] const std::vector<Part>& report_parts();
[[nodiscard]] const std::vector<SectionPlan>& report_sections();
// Long ones first: they run on several processors.
[[nodiscard]] const std::vector<Experiment>& report_experiments();

}  // namespace sightline::report
