// The release proof: many random questions to the engine, judged by oracles that share no code with
// it, and the same questions to FCL. scripts/prove builds and runs it; docs/collision_proof.md
// explains the table.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdio>
#include <exception>
#include <mutex>
#include <thread>

#include "tests/proof/generators.hpp"
#include "tests/proof/tally.hpp"

namespace rubicon::collision::proof {
namespace {

/// Cases a thread takes at a time.
constexpr std::uint64_t kChunk = 256;
/// Wrong cases printed a generator.
constexpr std::size_t kShown = 20;

struct Options {
  std::uint64_t questions = 1'000'000;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  bool poses = false;
  bool aligned = false;
  bool soil = false;
  std::vector<std::string> only;
  std::string replay;
};

std::vector<Generator> step_generators() {
  std::vector<Generator> all;
  for (const auto& list : {box_generators(), touch_generators(), convex_generators(),
                           mesh_generators(), scene_generators()}) {
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

std::vector<Generator> listed(std::span<const Generator> list) {
  return {list.begin(), list.end()};
}

CaseRecord run_case(const Generator& generator, std::uint64_t seed, std::uint64_t index,
                    bool explain) {
  CaseRecord record;
  record.explain = explain;
  Random random(CaseEngine(seed, generator.name, index));
  generator.run(random, record);
  return record;
}

/// All cases of one generator; which thread runs which does not matter, since a case depends on its
/// index alone.
Tally run(const Generator& generator, std::uint64_t seed, std::uint64_t cases, unsigned threads) {
  std::atomic<std::uint64_t> next = 0;
  std::mutex mutex;
  Tally sum;
  std::exception_ptr failure;
  const auto work = [&] {
    Tally mine;
    std::uint64_t index = 0;
    try {
      for (;;) {
        const std::uint64_t begin = next.fetch_add(kChunk);
        if (begin >= cases) break;
        for (index = begin; index < std::min(begin + kChunk, cases); ++index)
          mine.add(index, run_case(generator, seed, index, false));
      }
    } catch (const std::exception& error) {
      const std::lock_guard lock(mutex);
      fmt::print(stderr, "prove: case {}:{}:{} fails: {}\n", generator.name, seed, index,
                 error.what());
      failure = std::current_exception();
      next = cases;
    }
    const std::lock_guard lock(mutex);
    sum += mine;
  };
  std::vector<std::thread> helpers;
  for (unsigned i = 1; i < threads; ++i) helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
  return sum;
}

std::string_view name_of_truth(Truth truth) {
  if (truth == Truth::kNearBoundary) return "too near to call";
  return truth == Truth::kHit ? "a hit" : "free";
}

int replay(const std::string& text) {
  const std::size_t first = text.find(':');
  const std::size_t second = text.rfind(':');
  std::uint64_t seed = 0;
  std::uint64_t index = 0;
  const auto number = [](std::string_view digits, std::uint64_t& value) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc() && end == digits.data() + digits.size() && !digits.empty();
  };
  std::vector<Generator> all = step_generators();
  for (const auto& list : {static_generators(), aligned_generators(), soil_generators()}) {
    all.insert(all.end(), list.begin(), list.end());
  }
  const std::string name = text.substr(0, first);
  const auto generator =
      std::find_if(all.begin(), all.end(), [&](const Generator& g) { return g.name == name; });
  if (first == second || generator == all.end() ||
      !number(std::string_view(text).substr(first + 1, second - first - 1), seed) ||
      !number(std::string_view(text).substr(second + 1), index)) {
    fmt::print(stderr, "prove: expected GENERATOR:SEED:INDEX after --replay, found \"{}\"\n", text);
    return 2;
  }
  const CaseRecord record = run_case(*generator, seed, index, true);
  fmt::print("{}", record.notes);
  bool clean = true;
  for (const Outcome& outcome : record.outcomes) {
    fmt::print(
        "{}: in truth {}; the engine says {}{}{}\n", name_of(outcome.motion),
        name_of_truth(outcome.truth), outcome.engine_hit ? "a hit" : "free",
        outcome.fcl_hit ? (*outcome.fcl_hit ? "; FCL: a hit" : "; FCL: free") : "",
        outcome.third ? fmt::format("; third voice: {}", name_of_truth(*outcome.third)) : "");
    clean = clean && !outcome.is_miss() && !outcome.is_false_hit() && !outcome.is_quarrel();
  }
  return clean ? 0 : 1;
}

int prove(const Options& options) {
  const std::vector<Generator> all = options.poses     ? listed(static_generators())
                                     : options.aligned ? listed(aligned_generators())
                                     : options.soil    ? listed(soil_generators())
                                                       : step_generators();
  std::uint64_t shares = 0;
  for (const Generator& generator : all) shares += static_cast<std::uint64_t>(generator.share);
  fmt::print("{}", table_head());
  Count total;
  std::string wrong;
  for (const Generator& generator : all) {
    if (!options.only.empty() &&
        std::find(options.only.begin(), options.only.end(), generator.name) == options.only.end())
      continue;
    const std::uint64_t questions =
        options.questions * static_cast<std::uint64_t>(generator.share) / shares;
    const std::uint64_t cases = std::max<std::uint64_t>(
        1, questions / static_cast<std::uint64_t>(generator.questions_a_case));
    const Tally tally = run(generator, options.seed, cases, options.threads);
    fmt::print("{}", table_lines(generator.name, tally));
    std::fflush(stdout);
    total += tally.total();
    for (std::size_t i = 0; i < std::min(kShown, tally.wrong.size()); ++i) {
      wrong += fmt::format("wrong: scripts/prove --replay {}:{}:{}\n", generator.name, options.seed,
                           tally.wrong[i]);
    }
    if (tally.wrong.size() > kShown) {
      wrong += fmt::format("wrong: {} more of {}\n", tally.wrong.size() - kShown, generator.name);
    }
  }
  fmt::print("{}{}", table_total(total), wrong);
  if (total.questions == 0) {
    fmt::print(stderr, "prove: there is no such generator\n");
    return 2;
  }
  return total.is_clean() ? 0 : 1;
}

int run_command(int argc, char** argv) {
  Options options;
  CLI::App app("Proves the collision engine on random questions against independent oracles.");
  app.add_option(
      "--cases", options.questions,
      "questions in all (default 1,000,000; poses 12,000,000; aligned and soil 100,000)");
  app.add_option("--seed", options.seed, "another seed gives other cases");
  app.add_option("--threads", options.threads, "the answers do not depend on it")
      ->check(CLI::Range(1, 64));
  app.add_option("--only", options.only, "these families of cases only");
  CLI::Option* poses = app.add_flag("--static", options.poses, "poses instead of steps");
  CLI::Option* aligned =
      app.add_flag("--aligned", options.aligned, "meshes whose faces lie in each other instead")
          ->excludes(poses);
  app.add_flag("--soil", options.soil, "steps over soil that is dug bit by bit instead")
      ->excludes(poses)
      ->excludes(aligned);
  app.add_option("--replay", options.replay, "GENERATOR:SEED:INDEX: one case, explained");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (!options.replay.empty()) return replay(options.replay);
  if (options.poses && app.count("--cases") == 0) options.questions = 12'000'000;
  if ((options.aligned || options.soil) && app.count("--cases") == 0) options.questions = 100'000;
  return prove(options);
}

}  // namespace
}  // namespace rubicon::collision::proof

int main(int argc, char** argv) {
  try {
    return rubicon::collision::proof::run_command(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "prove: {}\n", error.what());
    return 3;
  }
}
