// The swept-volume engine and FCL in one process. What is measured and how to read it:
// docs/benchmarks.md; the table: scripts/bench_collision.

#include <benchmark/benchmark.h>

#include "bench/change_bench.hpp"
#include "bench/compare.hpp"
#include "bench/contact_scene.hpp"
#include "bench/crane_bench.hpp"
#include "bench/mesh_scene.hpp"
#include "bench/panel_scene.hpp"
#include "bench/question_bench.hpp"

namespace {

using namespace rubicon::bench;

void register_near() {
  const std::vector<Method> short_list = {Method::kOurs, Method::kFclDefault, Method::kFcl10mm};
  for (const StepKind kind : {StepKind::kTranslation, StepKind::kRotation}) {
    std::vector<Method> all = {Method::kOurs,    Method::kOursBaseline,   Method::kFclDefault,
                               Method::kFcl10mm, Method::kFcl10mmOneTree, Method::kFclTight};
    if (kind == StepKind::kRotation) all.push_back(Method::kFclDropped);
    for (const int count : {1000, 10000, 100000}) {
      register_comparison(
          "panels", name_of(kind), count, [=] { return panel_scene(count, kind); }, all);
    }
    for (const int count : {100, 1000, 10000}) {
      register_comparison(
          "meshes", name_of(kind), count, [=] { return mesh_scene(count, kind, MeshLoad::kBox); },
          all);
      register_comparison(
          "mesh_load", name_of(kind), count,
          [=] { return mesh_scene(count, kind, MeshLoad::kMesh); }, short_list);
    }
    for (const int count : {1000, 10000, 100000}) {
      register_comparison(
          "contact", name_of(kind), count, [=] { return contact_scene(count, kind); }, short_list);
    }
    for (const int count : {1000, 100000}) {
      register_comparison("free", name_of(kind), count, [=] { return free_scene(count, kind); },
                          {Method::kOurs, Method::kFclDefault});
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  register_near();
  register_crane();
  register_questions();
  register_changes();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
