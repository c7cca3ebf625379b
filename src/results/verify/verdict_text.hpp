#pragma once

#include <string>

#include "src/results/verify/verify.hpp"

namespace rubicon::verify {

/// How the files of a result are called in messages.
struct ResultNames {
  std::string trace = "trace.jsonl";
  std::string schedule_json = "schedule.json";
  std::string schedule_csv = "schedule.csv";
  std::string loads_csv = "loads.csv";
  std::string report = "report.html";
};

/// One line if all is well; else one line a fault, at most 50, then how many there are.
std::string verdict_text(const Verdict& verdict, const ResultNames& names);

/// {"verified": .., "tasks": .., "done": .., "steps": .., "pairs": .., "faults": [..]}, all faults.
std::string verdict_json(const Verdict& verdict, const ResultNames& names);

}  // namespace rubicon::verify
