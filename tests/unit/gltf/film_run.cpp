#include "tests/unit/gltf/film_run.hpp"

#include <gtest/gtest.h>

#include "src/exchange/files/disk_io.hpp"
#include "src/results/gltf/document_file.hpp"
#include "src/results/replay/replay.hpp"
#include "src/simulation/taskplan/run_plan.hpp"
#include "tests/support/places.hpp"

namespace rubicon::test {

namespace {

class Lines : public trace::TraceSink {
 public:
  explicit Lines(std::vector<std::string>& lines) : lines_(lines) {}
  void line(std::string_view text) override { lines_.emplace_back(text); }
  void restart() override { lines_.clear(); }

 private:
  std::vector<std::string>& lines_;
};

}  // namespace

FilmRun run_for_film(const std::string& path) {
  FilmRun result;
  files::DiskFiles disk;
  interpreter::Diagnostics diagnostics;
  result.plan = load_plan(test::source_dir() + "/" + path, result.sources, disk, diagnostics);
  EXPECT_TRUE(result.plan) << path;
  if (!result.plan) return result;
  Lines sink(result.lines);
  taskplan::run_plan(*result.plan, result.sources, &sink, {});
  for (std::size_t i = 1; i < result.lines.size(); ++i) {
    result.records.push_back(nlohmann::json::parse(result.lines[i]));
  }
  return result;
}

std::string film_of(const FilmRun& run, double speed_up) {
  replay::ReplayReader reader;
  for (const std::string& line : run.lines) reader.line(line);
  return gltf::glb_bytes(gltf::make_document(reader.finish(), {speed_up}));
}

}  // namespace rubicon::test
