#pragma once

namespace rubicon::bench {

/// Registers what it costs when a site changes, as SCENE/panels/COUNT/METHOD, processor time for
/// one panel:
/// - build: from nothing to 1e5 panels; counter `bytes`, heap memory a panel;
/// - insert: 2e4 more into 1e5; insert_ask: the same, with a step tested after each, so that work
///   put off until the next query is counted;
/// - remove: 2e4 out of 1.2e5, in any order; remove_ask likewise.
/// Methods: ours, and fcl_default: registerObject and unregisterObject of FCL's dynamic tree, which
/// begins balanced (build: registerObjects in one go).
/// build/meshes/10000 gives the memory of an instance of a shared mesh.
void register_changes();

}  // namespace rubicon::bench
