#include "src/motion/ompl_bridge/ompl_planners.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace rubicon::ompl_bridge {

namespace {

constexpr std::array kPlanners{
    OmplPlanner{"ABITstar",
                "delay_rewiring_to_first_solution drop_unconnected_samples_on_prune "
                "find_approximate_solutions inflation_scaling_parameter initial_inflation_factor "
                "prune_threshold_as_fractional_cost_change rewire_factor samples_per_batch "
                "stop_on_each_solution_improvement truncation_scaling_parameter use_graph_pruning "
                "use_just_in_time_sampling use_k_nearest use_strict_queue_ordering",
                ""},
    OmplPlanner{"AITstar",
                "find_approximate_solutions rewire_factor samples_per_batch use_graph_pruning "
                "use_k_nearest",
                ""},
    OmplPlanner{"AnytimePathShortening", "", "it runs planners in threads"},
    OmplPlanner{"BFMT",
                "balanced cache_cc extended_fmt heuristics nearest_k num_samples optimality "
                "radius_multiplier",
                ""},
    OmplPlanner{"BiEST", "range", ""},
    OmplPlanner{"BiRLRT", "keep_last_valid max_dist_near range", ""},
    OmplPlanner{"BiTRRT",
                "cost_threshold frontier_node_ratio frontier_threshold init_temperature range "
                "temp_change_factor",
                ""},
    OmplPlanner{
        "BITstar",
        "delay_rewiring_to_first_solution drop_unconnected_samples_on_prune "
        "find_approximate_solutions prune_threshold_as_fractional_cost_change rewire_factor "
        "samples_per_batch stop_on_each_solution_improvement use_graph_pruning "
        "use_just_in_time_sampling use_k_nearest use_strict_queue_ordering",
        ""},
    OmplPlanner{"BKPIECE1",
                "border_fraction failed_expansion_score_factor min_valid_path_fraction range", ""},
    OmplPlanner{"CForest", "", "it runs in threads"},
    OmplPlanner{"EST", "goal_bias range", ""},
    OmplPlanner{"FMT",
                "cache_cc extended_fmt heuristics num_samples radius_multiplier use_k_nearest", ""},
    OmplPlanner{"InformedRRTstar",
                "delay_collision_checking goal_bias number_sampling_attempts ordered_sampling "
                "ordering_batch_size prune_threshold range rewire_factor use_k_nearest",
                ""},
    OmplPlanner{
        "KPIECE1",
        "border_fraction failed_expansion_score_factor goal_bias min_valid_path_fraction range",
        ""},
    OmplPlanner{"LazyLBTRRT", "", "an assertion in it ends the program; take LBTRRT"},
    OmplPlanner{"LazyPRM", "max_nearest_neighbors range", ""},
    OmplPlanner{"LazyPRMstar", "", ""},
    OmplPlanner{"LazyRRT", "goal_bias range", ""},
    OmplPlanner{"LBKPIECE1", "border_fraction min_valid_path_fraction range", ""},
    OmplPlanner{"LBTRRT", "epsilon goal_bias range", ""},
    OmplPlanner{"LightningRetrieveRepair", "", "it needs ways of former runs"},
    OmplPlanner{"PDST", "goal_bias", ""},
    OmplPlanner{"PRM", "", "a thread of its own looks for the way; take LazyPRM, or the kind prm"},
    OmplPlanner{"PRMstar", "", "a thread of its own looks for the way; take LazyPRMstar"},
    OmplPlanner{"ProjEST", "goal_bias range", ""},
    OmplPlanner{"pRRT", "", "it runs in threads; take RRT"},
    OmplPlanner{"pSBL", "", "it runs in threads; take SBL"},
    OmplPlanner{"QRRT", "", "it needs several spaces"},
    OmplPlanner{"RLRT", "goal_bias keep_last_valid range", ""},
    OmplPlanner{"RRT", "goal_bias intermediate_states range", ""},
    OmplPlanner{"RRTConnect", "intermediate_states range", ""},
    OmplPlanner{
        "RRTsharp",
        "goal_bias informed_sampling number_sampling_attempts range rejection_variant "
        "rejection_variant_alpha rewire_factor sample_rejection update_children use_k_nearest",
        ""},
    OmplPlanner{"RRTstar",
                "delay_collision_checking focus_search goal_bias informed_sampling "
                "new_state_rejection number_sampling_attempts ordered_sampling ordering_batch_size "
                "prune_threshold pruned_measure range rewire_factor sample_rejection tree_pruning "
                "use_admissible_heuristic use_k_nearest",
                ""},
    OmplPlanner{
        "RRTXstatic",
        "epsilon goal_bias informed_sampling number_sampling_attempts range rejection_variant "
        "rejection_variant_alpha rewire_factor sample_rejection update_children use_k_nearest",
        ""},
    OmplPlanner{"SBL", "range", ""},
    OmplPlanner{"SORRTstar",
                "delay_collision_checking goal_bias number_sampling_attempts ordered_sampling "
                "ordering_batch_size prune_threshold range rewire_factor use_k_nearest",
                ""},
    OmplPlanner{"SPARS", "", "a thread of its own looks for the way; take LazyPRM"},
    OmplPlanner{"SPARStwo", "", "a thread of its own looks for the way; take LazyPRM"},
    OmplPlanner{"SST", "goal_bias pruning_radius range selection_radius", ""},
    OmplPlanner{"STRIDE", "goal_bias min_valid_path_fraction range use_projected_distance", ""},
    OmplPlanner{"ThunderRetrieveRepair", "", "it needs ways of former runs"},
    OmplPlanner{"TRRT",
                "cost_threshold frontier_node_ratio frontier_threshold goal_bias init_temperature "
                "range temp_change_factor",
                ""},
    OmplPlanner{"TSRRT", "", "it needs a task space"},
    OmplPlanner{"VFRRT", "", "it needs a field of directions"},
    OmplPlanner{"XXL", "", "it needs a division of the space"},
};

}  // namespace

std::span<const OmplPlanner> ompl_planners() { return kPlanners; }

const OmplPlanner* find_ompl_planner(std::string_view name) {
  const auto* const found =
      std::find_if(kPlanners.begin(), kPlanners.end(),
                   [&](const OmplPlanner& planner) { return name == planner.name; });
  return found == kPlanners.end() ? nullptr : &*found;
}

std::vector<std::string> parameters_of(const OmplPlanner& planner) {
  std::vector<std::string> names;
  std::string name;
  for (const char* c = planner.parameters;; ++c) {
    if (*c != ' ' && *c != '\0') {
      name += *c;
      continue;
    }
    if (!name.empty()) names.push_back(std::exchange(name, {}));
    if (*c == '\0') return names;
  }
}

Setting setting_of(std::string_view parameter) {
  for (const char* count : {"samples_per_batch", "num_samples", "max_nearest_neighbors",
                            "number_sampling_attempts", "ordering_batch_size"}) {
    if (parameter == count) return {1, 20000};
  }
  return {0, 1e9};
}

}  // namespace rubicon::ompl_bridge
