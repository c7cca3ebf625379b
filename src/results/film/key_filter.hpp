#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "src/results/film/column.hpp"

namespace rubicon::film {

/// Where all parameters of a robot are at one moment, in millionths of seconds, metres and degrees.
struct Key {
  std::int64_t t = 0;
  std::vector<std::int64_t> q;

  bool operator==(const Key&) const = default;
};

/// The keys of one motion, parameter by parameter.
class KeyColumns {
 public:
  explicit KeyColumns(std::size_t parameters);
  void add(const Key& key);
  void add(const KeyColumns& more);

  std::size_t count() const { return t_.count(); }
  const Column& t() const { return t_; }
  const std::vector<Column>& q() const { return q_; }

 private:
  Column t_;
  std::vector<Column> q_;
};

/// Leaves out keys that lie on a line with their neighbours, one at a time: from the last key that
/// stays it holds, for each parameter, the slopes that pass every key since then within
/// `kOffTheLine` ("swinging door": E. H. Bristol, Swinging door trending: adaptive trend
/// recording?, ISA National Conference 1990). Of several keys at one time the first and the last
/// stay: a jump.
class KeyFilter {
 public:
  /// A value may be off by this many millionths; with half a millionth of rounding, two at most.
  static constexpr double kOffTheLine = 1.5;

  /// The first key stays.
  explicit KeyFilter(Key first);

  /// The time of the key before must not be later.
  void add(const Key& key);
  /// Once all are added; nothing may be added any more.
  void finish();

  const Key& first() const { return first_; }
  /// The last that was added.
  const Key& last() const { return last_; }
  /// All that stay but for the first.
  const KeyColumns& kept() const { return kept_; }

 private:
  struct Slopes {
    double lower = 0;
    double upper = 0;
  };

  void keep_last();
  bool on_the_line(const Key& key) const;
  void narrow(const Key& key);
  void open_slopes();

  Key first_;
  Key anchor_;  ///< the lines begin here; it stays
  Key last_;
  bool last_is_kept_ = true;
  bool last_is_jump_ = false;  ///< a key of the same time was kept before it
  std::vector<Slopes> slopes_;
  KeyColumns kept_;
};

}  // namespace rubicon::film
