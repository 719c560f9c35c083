// Runs a fuzz target without libFuzzer: every file of its corpus, then a few thousand mutations of them with a fixed seed.
// It fails only by a crash, a sanitizer report or a hang; the file named by the second argument then contains the current
// input, so that it can be added to the corpus.
//
//   NAME_replay CORPUS_FOLDER LAST_INPUT_FILE [MUTATIONS]
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Input = std::vector<std::uint8_t>;

std::vector<Input> read_corpus(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<Input> corpus;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return corpus;
}

class Mutator {
 public:
  explicit Mutator(const std::vector<Input>& corpus) : corpus_(corpus) {}

  Input next() {
    Input input = corpus_[below(corpus_.size())];
    for (std::size_t n = 1 + below(8); n > 0; --n) change(input);
    return input;
  }

 private:
  std::size_t below(std::size_t limit) { return static_cast<std::size_t>(random_() % limit); }
  std::uint8_t byte() { return static_cast<std::uint8_t>(random_()); }

  static Input::iterator at(Input& input, std::size_t place) {
    return input.begin() + static_cast<std::ptrdiff_t>(place);
  }

  void change(Input& input) {
    const std::size_t place = below(input.size() + 1);
    const std::size_t length = std::min(1 + below(16), input.size() - place);
    switch (below(6)) {
      case 0: input.insert(at(input, place), byte()); break;
      case 1: input.erase(at(input, place), at(input, place + length)); break;
      case 2: input.resize(place); break;
      case 3: {
        const Input copy(at(input, place), at(input, place + length));
        input.insert(at(input, below(input.size() + 1)), copy.begin(), copy.end());
        break;
      }
      case 4: {
        const Input& other = corpus_[below(corpus_.size())];
        const auto from = other.begin() + static_cast<std::ptrdiff_t>(below(other.size() + 1));
        input.insert(at(input, place), from, from + std::min<std::ptrdiff_t>(other.end() - from, 32));
        break;
      }
      default:
        if (place < input.size()) input[place] ^= static_cast<std::uint8_t>(1U << below(8));
    }
  }

  const std::vector<Input>& corpus_;
  std::mt19937_64 random_{1971};
};

void try_input(const Input& input, const std::filesystem::path& last_input) {
  std::ofstream(last_input, std::ios::binary | std::ios::trunc)
      .write(reinterpret_cast<const char*>(input.data()), static_cast<std::streamsize>(input.size()));
  LLVMFuzzerTestOneInput(input.data(), input.size());
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::fprintf(stderr, "usage: %s CORPUS_FOLDER LAST_INPUT_FILE [MUTATIONS]\n", arguments[0]);
    return 2;
  }
  std::error_code absent;
  if (!std::filesystem::is_directory(arguments[1], absent)) {
    std::fprintf(stderr, "%s: no such corpus folder\n", arguments[1]);
    return 2;
  }
  std::vector<Input> corpus = read_corpus(arguments[1]);
  for (const Input& input : corpus) try_input(input, arguments[2]);
  const std::size_t files = corpus.size();
  if (corpus.empty()) corpus.emplace_back();
  Mutator mutator(corpus);
  const long mutations = count > 3 ? std::strtol(arguments[3], nullptr, 10) : 3000;
  for (long i = 0; i < mutations; ++i) try_input(mutator.next(), arguments[2]);
  std::printf("%zu corpus files and %ld mutations\n", files, mutations);
  return 0;
}
