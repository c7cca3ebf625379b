#pragma once

namespace rubicon::bench {

/// Registers what further questions cost, one iteration a question:
/// - SCENE_contact and SCENE_explain/KIND/COUNT/ours, of the steps that are hits: where and when it
///   begins, and all pairs that block;
/// - SCENE_clearance/KIND/COUNT/ours, of all steps: the nearest miss within 2 m, to 1 mm;
/// - free/KIND/100000/ours_budget: free space, asked with a clearance budget.
/// Scenes: panels (10,000) and meshes (1,000).
void register_questions();

}  // namespace rubicon::bench
