#include <cstdint>
#include <stdexcept>
#include <string>

#include "src/results/debug/recording_reader.hpp"
#include "src/results/film/film_writer.hpp"
#include "src/results/verify/input/trace_reader.hpp"
#include "src/results/verify/verify.hpp"
#include "src/results/why/story_reader.hpp"
#include "src/results/why/story_text.hpp"

namespace {

/// Calls `take` with each line of the text.
template <typename Take>
void each_line(const std::string& text, Take take) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    take(text.substr(begin, end - begin));
    begin = end + 1;
  }
}

void replay(const std::string& text) {
  rubicon::verify::TraceReader reader;
  each_line(text, [&](const std::string& line) { reader.line(line); });
  rubicon::verify::Result result;
  result.trace = reader.finish();
  rubicon::verify::verify(result);
}

void film(const std::string& text) {
  rubicon::film::FilmWriter writer;
  each_line(text, [&](const std::string& line) { writer.line(line); });
  if (writer.has_header()) writer.finish("");
}

void record(const std::string& text) {
  rubicon::debug::RecordingReader reader;
  each_line(text, [&](const std::string& line) { reader.line(line); });
  reader.take();
}

void why(const std::string& text) {
  rubicon::why::StoryReader reader("set");
  each_line(text, [&](const std::string& line) { reader.line(line); });
  const rubicon::why::TaskStory story = reader.story();
  rubicon::why::story_text(story);
  rubicon::why::story_json(story);
}

}  // namespace

/// Any bytes as a trace: whoever reads it refuses it with one of two exceptions, or reads it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const auto reader : {replay, film, record, why}) {
    try {
      reader(text);
    } catch (const rubicon::verify::UnreadableInput&) {
    } catch (const std::invalid_argument&) {
    }
  }
  return 0;
}
