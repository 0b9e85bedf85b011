// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <utility>

#include "adaptive_localization/core/stop_token.hpp"
#include "core/error_text.hpp"

namespace adaptive_localization {

/// What work came to: a value, or the reason why there is none.
template <class T>
struct Outcome {
  std::optional<T> value;
  std::string error;
};

/// Calls work and catches whatever it throws.
template <class Work>
auto outcomeOf(const Work& work) -> Outcome<decltype(work())> {
  try {
    return {work(), ""};
  } catch (const Stopped&) {
    return {std::nullopt, "it was stopped"};
  } catch (...) {
    return {std::nullopt, errorText()};
  }
}

/// One piece of work at a time in a thread of its own. Its failure is a value; nothing is thrown
/// into the thread that asks. Ends before its owner does: what is no longer wanted is told to stop
/// and waited for.
template <class T>
class Background {
 public:
  using Work = std::function<T(const StopToken&)>;

  Background() = default;
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  ~Background() { stop(); }  // the future waits

  /// Only while nothing is running.
  void start(Work work) {
    stop_ = StopSource();
    const auto run = [work = std::move(work), stop = stop_.token()] {
      return outcomeOf([&] { return work(stop); });
    };
    auto started = outcomeOf([&] { return std::async(std::launch::async, run); });
    running_ = started.value ? std::move(*started.value) : ready({std::nullopt, started.error});
  }

  bool isRunning() const { return running_.valid(); }

  /// The result is no longer wanted: it comes soon, as a failure, unless it was there already.
  void stop() { stop_.stop(); }

  /// What the work came to, once; nothing before then.
  std::optional<Outcome<T>> poll() {
    const bool has_ended =
        isRunning() && running_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (!has_ended) return std::nullopt;
    return running_.get();
  }

 private:
  static std::future<Outcome<T>> ready(Outcome<T> outcome) {
    std::promise<Outcome<T>> promise;
    promise.set_value(std::move(outcome));
    return promise.get_future();
  }

  StopSource stop_;
  std::future<Outcome<T>> running_;
};

}  // namespace adaptive_localization
