#include "src/results/verify/verify.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "src/results/verify/input/trace_reader.hpp"
#include "src/results/verify/verdict_text.hpp"
#include "tests/unit/verify/random.hpp"
#include "tests/unit/verify/sample_traces_io.hpp"

namespace rubicon::verify {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> good_trace() { return test::sample_trace("carry_a_block.jsonl"); }
std::vector<std::string> two_machines() { return test::sample_trace("two_machines.jsonl"); }

Verdict verdict_of(const std::vector<std::string>& lines) {
  TraceReader reader;
  for (const std::string& line : lines) reader.line(line);
  return verify(Result{reader.finish(), {}, {}, {}, {}, {}});
}

/// Faults as "line kind: text".
std::vector<std::string> faults_of(const std::vector<std::string>& lines) {
  std::vector<std::string> texts;
  for (const Fault& fault : verdict_of(lines).faults) {
    texts.push_back(std::to_string(fault.line) + " " + name_of(fault.kind) + ": " + fault.text);
  }
  return texts;
}

/// The trace with a piece of one line (from 1) replaced.
std::vector<std::string> edited(std::vector<std::string> lines, std::size_t line,
                                const std::string& from, const std::string& to) {
  std::string& text = lines.at(line - 1);
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << text;
  text.replace(place, from.size(), to);
  return lines;
}

std::vector<std::string> without(std::vector<std::string> lines, std::size_t line) {
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(line) - 1);
  return lines;
}

TEST(Verify, FindsNothingWrongInGoodTraces) {
  EXPECT_THAT(faults_of(good_trace()), IsEmpty());
  EXPECT_THAT(faults_of(two_machines()), IsEmpty());
  const Verdict verdict = verdict_of(good_trace());
  EXPECT_EQ(verdict.tasks, 2);
  EXPECT_EQ(verdict.done, 2);
  EXPECT_EQ(verdict.steps, 3);
  EXPECT_EQ(verdict_text(verdict, {}).substr(0, 32), "verified: 2 tasks (2 done), 3 st");
}

TEST(Verify, FindsGapsAndOverlaps) {
  EXPECT_THAT(faults_of(edited(good_trace(), 6, "\"from\":1,", "\"from\":1.5,")),
              testing::Contains(HasSubstr("6 clock: 0.5 s are not accounted for")));
  EXPECT_THAT(
      faults_of(edited(good_trace(), 6, "\"from\":1,", "\"from\":0.5,")),
      testing::Contains(HasSubstr("6 clock: it begins 0.5 s before what comes before it is over")));
  EXPECT_THAT(faults_of(edited(good_trace(), 17, "\"t\":80", "\"t\":79")),
              testing::Contains(HasSubstr("17 clock: it begins 1 s before")));
  EXPECT_THAT(faults_of(edited(good_trace(), 9, "\"t\":13", "\"t\":10")),
              testing::Contains(HasSubstr("9 clock: the clock runs backwards")));
  EXPECT_THAT(faults_of(without(good_trace(), 9)),
              testing::Contains(HasSubstr("9 clock: attempt 3 follows attempt 1")));
}

TEST(Verify, FindsStepsThatCannotBe) {
  EXPECT_THAT(faults_of(edited(good_trace(), 4, "\"x\":3", "\"x\":2.9")),
              testing::Contains(HasSubstr("4 motion: g: the step lasts 1 s instead of 0.9 s")));
  EXPECT_THAT(faults_of(edited(good_trace(), 9, "\"t\":13", "\"t\":12")),
              testing::Contains(HasSubstr("9 motion: g: the step lasts 1 s instead of 2 s")));
  EXPECT_THAT(
      faults_of(edited(good_trace(), 5, "\"q\":{\"x\":3", "\"q\":{\"x\":4")),
      ElementsAre(HasSubstr("5 motion: g: the end of a motion has x at 4 while it stands at 3")));
}

TEST(Verify, FindsLoadsInTheWrongPlace) {
  EXPECT_THAT(
      faults_of(
          edited(good_trace(), 1, "[1,0,0,3,0,1,0,0,0,0,1,1]", "[1,0,0,3,0,1,0,0.01,0,0,1,1]")),
      ElementsAre(HasSubstr("7 load: block hangs 10.0 mm and 0.000 degrees from where it stood")));
  EXPECT_THAT(
      faults_of(edited(good_trace(), 13, "[1,0,0,5,", "[1,0,0,5.002,")),
      ElementsAre(HasSubstr("13 load: block hangs 2.0 mm"), HasSubstr("13 load: block is 2.0 mm")));
  EXPECT_THAT(faults_of(edited(good_trace(), 1, "\"within\":{}", "\"within\":{\"length\":0.01}")),
              IsEmpty());
  EXPECT_THAT(faults_of(edited(edited(good_trace(), 1, "\"to\":[1,0,0,5,", "\"to\":[1,0,0,5.002,"),
                               1, "\"within\":{}", "\"within\":{\"length\":0.01}")),
              IsEmpty());
  EXPECT_THAT(faults_of(edited(good_trace(), 1, "\"to\":[1,0,0,5,", "\"to\":[1,0,0,5.00001,")),
              ElementsAre(HasSubstr("13 load: block is 0.0 mm and 0.000 degrees from its goal")));
  EXPECT_THAT(
      faults_of(without(good_trace(), 13)),
      testing::Contains(HasSubstr("expected putting down block, found the end of the task")));
}

TEST(Verify, FindsWhatIsInTheWay) {
  const auto with = [](const std::string& shape) {
    return edited(good_trace(), 1, "\"site\":[", "\"site\":[" + shape + ",");
  };
  const std::string pose = ",\"pose\":[1,0,0,4.5,0,1,0,0,0,0,1,1.5]}";
  // A sheet across the way of the block, in the middle of its last step.
  EXPECT_THAT(
      faults_of(with(R"({"type":"box","lower":[-0.001,-1,0],"upper":[0.001,1,0.1])" + pose)),
      testing::Contains(HasSubstr("block meets site 1 (at least")));
  EXPECT_THAT(faults_of(with(R"({"type":"sphere","centre":[0,0,0],"radius":0.01)" + pose)),
              ElementsAre(HasSubstr("contact: block meets site 1 (at least")));
  // It slides along without being in it.
  EXPECT_THAT(faults_of(with(R"({"type":"box","lower":[-9,-9,-1],"upper":[9,9,-0.5])" + pose)),
              IsEmpty());
  EXPECT_THAT(faults_of(with(R"({"type":"box","lower":[-9,-9,-1],"upper":[9,9,-0.4975])" + pose)),
              ElementsAre(HasSubstr("block meets site 1 (at least 2.5 mm deep)")));
  EXPECT_THAT(faults_of(with(R"({"type":"box","lower":[-9,-9,-1],"upper":[9,9,-0.499])" + pose)),
              IsEmpty());
}

TEST(Verify, FindsMachinesThatMeet) {
  // The second stops on its way, the first comes on.
  EXPECT_THAT(faults_of(without(without(two_machines(), 9), 7)),
              testing::Contains(HasSubstr("contact: a.trolley meets b.trolley (at least")));
  // The rail of the first is moved so far that they touch, and a little farther.
  const std::string rail = "\"path\":\"g.robot\",\"pose\":[1,0,0,";
  EXPECT_THAT(faults_of(edited(two_machines(), 1, rail + "0,", rail + "1.6,")), IsEmpty());
  EXPECT_THAT(faults_of(edited(two_machines(), 1, rail + "0,", rail + "1.602,")),
              testing::Contains(HasSubstr("contact: a.trolley meets b.trolley (at least 1.")));
}

TEST(Verify, FindsResourcesInTwoPlaces) {
  std::vector<std::string> lines = edited(good_trace(), 15, "\"t\":20", "\"t\":2");
  lines = edited(lines, 16, "\"from\":20", "\"from\":2");
  lines = edited(edited(lines, 16, "\"t\":80", "\"t\":62"), 17, "\"t\":80", "\"t\":62");
  EXPECT_THAT(faults_of(lines),
              ElementsAre(HasSubstr("15 resource: c is still in set"),
                          HasSubstr("15 link: it starts 18 s too early after set (FS)")));
}

TEST(Verify, FindsTasksOutOfOrder) {
  EXPECT_THAT(faults_of(without(good_trace(), 17)),
              ElementsAre(HasSubstr("order: the task never ends")));
  EXPECT_THAT(
      faults_of(edited(good_trace(), 17, "done\",\"reason\":\"", "rejected\",\"reason\":\"")),
      testing::Contains(HasSubstr("17 order: no reason is given")));
  EXPECT_THAT(
      faults_of(edited(good_trace(), 17, "done\",\"reason\":\"", "not reached\",\"reason\":\"x")),
      testing::Contains(HasSubstr("17 order: it ran and is told as not reached")));
  EXPECT_THAT(faults_of(edited(good_trace(), 1, "\"tasks\":[",
                               R"("tasks":[{"name":"more","robot":"","crews":[],"after":[]},)")),
              ElementsAre(HasSubstr("order: the task is not in the trace")));
  EXPECT_THAT(faults_of(edited(good_trace(), 5, "\"reached\":true", "\"reached\":false")),
              ElementsAre(HasSubstr("6 order: the task goes on and its motion ended short")));
}

/// Whatever happens to the text of a trace: it is read or refused, never worse.
TEST(Verify, SurvivesDamagedTraces) {
  Random random(12);
  int refused = 0, faulty = 0;
  for (int round = 0; round < 3000; ++round) {
    std::vector<std::string> lines = round % 2 == 0 ? good_trace() : two_machines();
    for (int edits = random.whole(1, 3); edits > 0; --edits) {
      std::string& line = lines[static_cast<std::size_t>(
          random.whole(0, 3) == 0 ? 0 : random.whole(0, static_cast<int>(lines.size()) - 1))];
      const auto place =
          static_cast<std::size_t>(random.whole(0, static_cast<int>(line.size()) - 1));
      switch (random.whole(0, 4)) {
        case 0:
          line.erase(place, static_cast<std::size_t>(random.whole(1, 20)));
          break;
        case 1:
          line[place] = static_cast<char>(random.whole(1, 255));
          break;
        case 2:  // another digit
          for (std::size_t i = place; i < line.size(); ++i) {
            if (line[i] < '0' || line[i] > '9') continue;
            line[i] = static_cast<char>('0' + random.whole(0, 9));
            break;
          }
          break;
        case 3:
          for (std::size_t i = place; i < line.size(); ++i) {
            if (line[i] < '0' || line[i] > '9') continue;
            line.insert(i, random.whole(0, 1) == 0 ? "-" : "1e9");
            break;
          }
          break;
        default:
          std::swap(
              line,
              lines[static_cast<std::size_t>(random.whole(0, static_cast<int>(lines.size()) - 1))]);
      }
    }
    try {
      if (!verdict_of(lines).faults.empty()) ++faulty;
    } catch (const UnreadableInput&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 300);
  EXPECT_GT(faulty, 300);
}

}  // namespace
}  // namespace rubicon::verify
