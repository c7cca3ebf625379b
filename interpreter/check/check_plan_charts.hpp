#pragma once

#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter::plan_check {

/// The policy of a network that says charts; null if it has another one.
const syntax::PolicyItem* charts_policy(const syntax::NetworkItem& item);

/// Errands and reports of a network with policy charts, into the model: P01, P02, P09, P60. What
/// cannot be carried out is found by doing it. `network` is checked, and the last of the model;
/// `is_whole` says whether it is free of mistakes.
void check_charts(Subject& subject, const syntax::NetworkItem& item,
                  const syntax::PolicyItem& policy, bool is_whole);

/// Errands, reports and costs of lanes where the policy is another one: P60.
void refuse_charts(Subject& subject, const syntax::NetworkItem& item);

}  // namespace rubicon::interpreter::plan_check
