#pragma once

#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

/// The policy of a network that says by which rule it is explored; null if it has another one.
const syntax::PolicyItem* explore_policy(const syntax::NetworkItem& item);

/// Who explores a network, into the model: P01, P02, P09, P61. The network is the last of the
/// model; `is_whole` says whether it is free of mistakes. Where the policy is another one `explore`
/// is refused.
void check_explore(Subject& subject, const syntax::NetworkItem& item, bool is_whole);

}  // namespace rubicon::interpreter::plan_check
