#include "src/studies/cluster/hand_out.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <mutex>
#include <set>
#include <thread>

#include "interpreter/parse/parse.hpp"
#include "src/studies/answers/study_answers.hpp"
#include "src/studies/answers/study_text.hpp"
#include "src/studies/study/runner.hpp"

namespace rubicon::cluster {
namespace {

/// The ranks of a job as threads of this process.
struct Job {
  explicit Job(int ranks) : boxes(static_cast<std::size_t>(ranks)), gone(boxes.size()) {}
  std::mutex mutex;
  std::vector<std::deque<Channel::Received>> boxes;
  std::vector<std::atomic<bool>> gone;
};

class Rank : public Channel {
 public:
  /// After so many messages it has ended: nothing that it sends arrives any more.
  Rank(Job& job, int rank, int ends_after = -1) : job_(job), rank_(rank), left_(ends_after) {}
  int rank() const override { return rank_; }
  int size() const override { return static_cast<int>(job_.boxes.size()); }
  void send(int to, std::string message) override {
    const auto me = static_cast<std::size_t>(rank_);
    if (left_ == 0) job_.gone[me] = true;
    if (job_.gone[me]) return;
    --left_;
    const std::lock_guard lock(job_.mutex);
    job_.boxes[static_cast<std::size_t>(to)].push_back({rank_, std::move(message)});
  }
  std::optional<Received> receive() override {
    const std::lock_guard lock(job_.mutex);
    auto& box = job_.boxes[static_cast<std::size_t>(rank_)];
    if (box.empty()) return std::nullopt;
    Received received = std::move(box.front());
    box.pop_front();
    senders_.insert(received.from);
    return received;
  }
  /// Waits until something was received of so many others.
  void wait_for_senders(std::size_t count) {
    while (true) {
      {
        const std::lock_guard lock(job_.mutex);
        if (senders_.size() >= count) return;
      }
      pause();
    }
  }
  std::string identity() const override { return std::to_string(rank_); }
  bool is_gone(const std::string& identity) const override {
    return job_.gone[static_cast<std::size_t>(std::stoi(identity))];
  }
  double now() const override {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
               .count() *
           speed_of_clock;
  }
  void pause() override { std::this_thread::sleep_for(std::chrono::microseconds(50)); }

  double speed_of_clock = 1;

 private:
  Job& job_;
  int rank_;
  int left_;
  std::set<int> senders_;
};

class OnePlan : public interpreter::FileProvider {
 public:
  std::variant<std::string, interpreter::FileFailure> read_text(const std::string&) override {
    return std::string(
        "plan p { parameter n = 1; crew gang { size n; } for i from 1 to 5 { task t[i] { by gang; "
        "needs 1 gang; takes exponential(1 h); } } }");
  }
  std::variant<std::shared_ptr<const geometry::TriangleMesh>, interpreter::FileFailure> read_mesh(
      const interpreter::MeshRequest&) override {
    return interpreter::FileFailure{"no meshes"};
  }
};

class HandOutTest : public testing::Test {
 protected:
  HandOutTest() {
    interpreter::SourceMap sources;
    interpreter::Diagnostics diagnostics;
    const auto file =
        sources.add("s.study",
                    "study s { plan \"p.plan\"; vary n 0.5, 1 to 3; runs at most 400 until "
                    "width(p80(makespan)) < 1 h; ask makespan, waiting; }");
    study_ = study::check_study(parse_study(sources, file, diagnostics), diagnostics);
  }

  static study::LoadedVariant read(const interpreter::ParameterTexts& set) {
    study::LoadedVariant loaded;
    OnePlan files;
    interpreter::Diagnostics found;
    loaded.plan = load_plan("p.plan", loaded.sources, files, found, set);
    if (!loaded.plan) loaded.fault = found.sorted().front().message;
    loaded.digest = "plan";
    return loaded;
  }

  std::string run(study::RemoteWorkers* remote, int threads = 1) {
    study::RunnerOptions options;
    options.threads = threads;
    options.remote = remote;
    options.read = [this](std::size_t, const interpreter::ParameterTexts& set) {
      before_read_();
      return read(set);
    };
    const auto variants = run_study(*study_, variants_of(*study_), options);
    const auto answers = answers_of(*study_, *variants);
    return study_json(*study_, *variants, answers) + runs_csv(*study_, *variants);
  }

  std::thread help_as(Rank& rank, const std::string& digest = "study",
                      const std::string& plan_digest = "plan", int threads = 1) {
    return std::thread([&rank, this, digest, plan_digest, threads] {
      HelperOptions options;
      options.threads = threads;
      options.digest = digest;
      options.read = [this, plan_digest](std::size_t, const interpreter::ParameterTexts& set) {
        ++read_by_helpers_;
        study::LoadedVariant loaded = read(set);
        loaded.digest = plan_digest;
        return loaded;
      };
      help(rank, *study_, options);
    });
  }

  HandOut hand_out(Rank& zero, int threads = 1) {
    return HandOut(zero, threads, study_->questions.size(), "study",
                   [this](const std::string& note) { notes_.push_back(note); });
  }

  std::unique_ptr<study::StudyModel> study_;
  std::vector<std::string> notes_;
  std::function<void()> before_read_ = [] {};  ///< of rank 0
  std::atomic<int> read_by_helpers_ = 0;
};

TEST_F(HandOutTest, ManyRanksHaveTheResultOfOne) {
  const std::string expected = run(nullptr);
  EXPECT_NE(expected.find("\"fault\""), std::string::npos) << "a crew of half a person";
  for (const int threads : {1, 3}) {
    Job job(4);
    Rank zero(job, 0), one(job, 1), two(job, 2), three(job, 3);
    HandOut ranks = hand_out(zero, threads);
    std::thread a = help_as(one, "study", "plan", threads);
    std::thread b = help_as(two, "study", "plan", threads);
    std::thread c = help_as(three, "study", "plan", threads);
    EXPECT_EQ(run(&ranks, threads), expected);
    EXPECT_EQ(run(&ranks, threads), expected) << "a search asks again and again";
    ranks.end();
    a.join();
    b.join();
    c.join();
    EXPECT_TRUE(ranks.all_there());
    EXPECT_EQ(notes_, std::vector<std::string>());
  }
  EXPECT_GT(read_by_helpers_, 0);
}

TEST_F(HandOutTest, WhatALostRankHadIsDoneByOthers) {
  const std::string expected = run(nullptr);
  for (const int messages : {1, 2, 3, 5, 8}) {
    // On a busy machine the others may have done everything before rank 2 is lost: then again.
    bool was_lost = false;
    for (int attempt = 0; attempt < 100 && !was_lost; ++attempt) {
      Job job(3);
      Rank zero(job, 0), one(job, 1), two(job, 2, messages);
      HandOut ranks = hand_out(zero);
      std::thread a = help_as(one);
      std::thread b = help_as(two);
      EXPECT_EQ(run(&ranks), expected) << messages;
      ranks.end();
      was_lost = !ranks.all_there();
      zero.send(2, write_message(End{}));  // as if it were killed
      a.join();
      b.join();
    }
    EXPECT_TRUE(was_lost) << "after " << messages << " messages";
  }
  ASSERT_FALSE(notes_.empty());
  EXPECT_EQ(notes_.front().find("rank 2 is left out: it has ended"), 0u) << notes_.front();
}

TEST_F(HandOutTest, ARankThatIsSilentIsLost) {
  const std::string expected = run(nullptr);
  // Rank 0 may have done everything before it has given rank 1 anything to do: then again.
  bool was_lost = false;
  for (int attempt = 0; attempt < 100 && !was_lost; ++attempt) {
    Job job(2);
    Rank zero(job, 0), one(job, 1);
    one.send(0, write_message(Hello{"study", "1", ""}));  // and never again
    zero.speed_of_clock = 1000;
    HandOut ranks = hand_out(zero);
    EXPECT_EQ(run(&ranks), expected);
    was_lost = !ranks.all_there();
  }
  EXPECT_TRUE(was_lost);
  ASSERT_EQ(notes_.size(), 1u);
  EXPECT_NE(notes_[0].find("nothing was heard of it for 60 s; what it had is done by others"),
            std::string::npos)
      << notes_[0];
}

TEST_F(HandOutTest, ARankWithOtherFilesIsLeftOut) {
  Job job(5);
  Rank zero(job, 0), other_study(job, 1), other_plan(job, 2), nonsense(job, 3), wrong(job, 4);
  std::thread a = help_as(other_study, "another");
  std::thread b = help_as(other_plan, "study", "another");
  nonsense.send(0, "\1\2\3");
  wrong.send(0, write_message(Hello{"study", "4", ""}));
  wrong.send(0,
             write_message(Answer{0, {"", "plan", {}, {{0, 99, {{1, 2, 3, 4}, {}, {}, {}, ""}}}}}));
  const std::string expected = run(nullptr);
  HandOut ranks = hand_out(zero);
  before_read_ = [&zero] { zero.wait_for_senders(4); };
  EXPECT_EQ(run(&ranks), expected);
  EXPECT_TRUE(ranks.all_there());
  ranks.end();
  a.join();
  b.join();
  std::string all;
  for (const std::string& each : notes_) all += each + "\n";
  EXPECT_NE(all.find("rank 1 is left out: its study or its program is another"), std::string::npos);
  EXPECT_NE(all.find("rank 3 is left out: what it says is not understood"), std::string::npos);
  EXPECT_NE(all.find("rank 4 is left out: it answers what nobody asked"), std::string::npos) << all;
}

}  // namespace
}  // namespace rubicon::cluster
