#pragma once

#include <functional>
#include <memory>
#include <utility>

namespace rubicon::bench {

/// Something that takes long to build, built when first asked for: a run with a filter builds only
/// what it measures, and the methods that are compared share one scene.
template <typename T>
class Lazy {
 public:
  explicit Lazy(std::function<std::unique_ptr<T>()> build) : build_(std::move(build)) {}

  T& get() {
    if (!value_) value_ = build_();
    return *value_;
  }

 private:
  std::function<std::unique_ptr<T>()> build_;
  std::unique_ptr<T> value_;
};

}  // namespace rubicon::bench
