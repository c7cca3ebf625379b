#pragma once

#include "bench/near_steps.hpp"

namespace rubicon::bench {

/// `count` floor slabs without gaps on five storeys 3 m apart, at constant density. The load, a
/// wall panel, stands exactly on them and slides along (T) or turns about a vertical axis up to
/// 30 m away (R): it touches and every step is free.
SweptScene contact_scene(int count, StepKind kind);

}  // namespace rubicon::bench
