#pragma once

namespace rubicon::test {

/// Sanitizers make the queries up to ninety times slower: there a test asks a tenth of its random
/// cases. They are the first of the same sequence.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int kFewerCases = 10;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr int kFewerCases = 10;
#else
inline constexpr int kFewerCases = 1;
#endif
#else
inline constexpr int kFewerCases = 1;
#endif

/// How many random cases to ask.
constexpr int cases(int count) { return count / kFewerCases; }

/// How many of these have to be of some kind; chance counts more among fewer.
constexpr int at_least(int count) { return kFewerCases == 1 ? count : count / (2 * kFewerCases); }

}  // namespace rubicon::test
