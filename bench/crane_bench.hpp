#pragma once

namespace rubicon::bench {

/// Registers crane/path/1401/METHOD: the tower crane roofs the residential building with 80 planks;
/// one query a step with all bodies that move and the load. One iteration is one moving body (or
/// load) and step; the whole path is timed. Methods: ours (against the site), ours_pairs (also the
/// crane's own parts and the load against each other, as a run asks), ours_budget and
/// ours_pairs_budget (with a clearance budget), fcl_default (against the site). Counter: `hits`,
/// which must be 0 for ours.
void register_crane();

}  // namespace rubicon::bench
