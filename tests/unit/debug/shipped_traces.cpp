#include "tests/unit/debug/shipped_traces.hpp"

#include <gtest/gtest.h>

#include <map>

#include "src/exchange/files/disk_io.hpp"
#include "src/results/debug/recording_reader.hpp"
#include "src/simulation/taskplan/run_plan.hpp"
#include "tests/support/places.hpp"

namespace rubicon::test {

namespace {

class Lines : public trace::TraceSink {
 public:
  void line(std::string_view text) override { all.emplace_back(text); }
  void restart() override { all.clear(); }
  std::vector<std::string> all;
};

std::vector<std::string> run(const std::string& path) {
  files::DiskFiles disk;
  interpreter::SourceMap sources;
  interpreter::Diagnostics diagnostics;
  const auto plan = load_plan(test::source_dir() + "/" + path, sources, disk, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << path;
  Lines lines;
  if (plan) taskplan::run_plan(*plan, sources, &lines, {});
  return lines.all;
}

}  // namespace

const std::vector<std::string>& trace_of(const std::string& plan) {
  static std::map<std::string, std::vector<std::string>> known;
  auto found = known.find(plan);
  if (found == known.end()) found = known.emplace(plan, run(plan)).first;
  return found->second;
}

debug::Recording recording_of(const std::vector<std::string>& lines) {
  debug::RecordingReader reader;
  for (const std::string& line : lines) reader.line(line);
  return reader.take();
}

debug::Session session_of(const std::vector<std::string>& lines, const std::string& task) {
  debug::Recording recording = recording_of(lines);
  EXPECT_EQ(debug::Session::why_not(recording, task), "");
  return debug::Session(std::move(recording), task, {});
}

const std::vector<std::string>& walked_plans() {
  static const std::vector<std::string> plans = {"taskplans/two_cranes.plan",
                                                 "taskplans/crane_and_trucks.plan",
                                                 "taskplans/people_below.plan",
                                                 "examples/02_over_the_wall/site.plan",
                                                 "examples/03_round_the_block/site.plan",
                                                 "examples/06_wait_for_the_goal/site.plan",
                                                 "examples/07_three_blocks/site.plan",
                                                 "examples/08_what_cannot_be_done/site.plan",
                                                 "examples/09_two_machines/site.plan"};
  return plans;
}

}  // namespace rubicon::test
