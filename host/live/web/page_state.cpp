#include "host/live/web/page_state.hpp"

#include "host/live/web/requests.hpp"

namespace sightline::live::web {

Json PageState::answer(std::string_view text) {
  const auto request = base::parse_json(text, "request");
  if (!request) return error_answer(request.error().message());
  const Json* const what = request->find("do");
  if (what != nullptr && what->text() != nullptr) {
    for (const auto answers : {pictures_answer, stripes_answer, turning_answer, kinds_answer}) {
      Json answer = answers(workbench, *what->text(), *request);
      if (!answer.is_null()) return answer;
    }
    if (Json answer = flying.answer(workbench, *what->text(), *request); !answer.is_null()) return answer;
  }
  return workbench.answer(*request);
}

}  // namespace sightline::live::web
