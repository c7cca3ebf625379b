#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "src/studies/cluster/hand_out.hpp"

namespace rubicon::cluster {

namespace {

/// The threads of a rank, what they have to do, and what they have done.
class Helper {
 public:
  Helper(const study::StudyModel& study, const HelperOptions& options)
      : study_(study), read_(options.read, static_cast<std::size_t>(options.threads) + 1) {
    for (int i = 0; i < options.threads; ++i) threads_.emplace_back([this] { work(); });
  }
  Helper(const Helper&) = delete;
  Helper& operator=(const Helper&) = delete;
  ~Helper() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    changed_.notify_all();
    for (std::thread& each : threads_) each.join();
  }

  void add(Order order) {
    const std::lock_guard lock(mutex_);
    orders_.push_back(std::move(order));
    changed_.notify_one();
  }
  std::optional<Answer> take_answer() {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
    if (answers_.empty()) return std::nullopt;
    Answer answer = std::move(answers_.front());
    answers_.pop_front();
    return answer;
  }

 private:
  void work() {
    study::Worker worker(study_, read_, &stop_);
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [&] { return stop_ || !orders_.empty(); });
      if (stop_) return;
      const Order order = std::move(orders_.front());
      orders_.pop_front();
      lock.unlock();
      std::optional<Answer> answer;
      std::exception_ptr failure;
      try {
        answer = Answer{order.number, worker.work(order.piece)};
      } catch (...) {
        failure = std::current_exception();
      }
      lock.lock();
      if (failure) {
        if (!failure_) failure_ = failure;
        return;
      }
      if (!stop_) answers_.push_back(*std::move(answer));
    }
  }

  const study::StudyModel& study_;
  study::OpenVariants read_;
  std::mutex mutex_;  ///< of what follows
  std::condition_variable changed_;
  std::deque<Order> orders_;
  std::deque<Answer> answers_;
  std::exception_ptr failure_;
  std::atomic<bool> stop_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace

bool help(Channel& channel, const study::StudyModel& study, const HelperOptions& options) {
  channel.send(0, write_message(Hello{options.digest, channel.identity(), options.failure}));
  std::optional<Helper> helper;
  if (options.failure.empty()) helper.emplace(study, options);
  double reported = channel.now();
  double heard = reported;
  while (true) {
    bool idle = true;
    while (auto received = channel.receive()) {
      idle = false;
      heard = channel.now();
      auto message = read_message(received->message, study.questions.size());
      if (!message) return false;
      if (const auto* end = std::get_if<End>(&*message)) return end->all_there;
      if (auto* order = std::get_if<Order>(&*message); order && helper) {
        helper->add(std::move(*order));
      }
    }
    while (auto answer = helper ? helper->take_answer() : std::nullopt) {
      idle = false;
      channel.send(0, write_message(*std::move(answer)));
    }
    const double now = channel.now();
    if (now - reported > kReportEvery) {
      channel.send(0, write_message(Alive{}));
      reported = now;
    }
    if (now - heard > kRankZeroLostAfter) return false;
    if (idle) channel.pause();
  }
}

}  // namespace rubicon::cluster
